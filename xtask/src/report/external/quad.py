"""scipy.integrate.quad between the given breaks; protocol in external.rs."""
import math
import sys
import time

from scipy.integrate import quad


def read_problem(line):
    cells = iter(line.split())
    number = lambda: float(next(cells))
    s, slope, exponential, scale = number(), number() > 0, number() > 0, number()
    breaks = [number() for _ in range(int(next(cells)))]
    parts = []
    for _ in range(int(next(cells))):
        start, end, sign = number(), number(), number()
        parts.append((start, end, sign, [(number(), number(), number()) for _ in range(int(next(cells)))]))
    return s, slope, exponential, scale, breaks, parts


def integrand(s, slope, exponential, scale, parts):
    norm = 1 / math.sqrt(2 * math.pi)

    def law(x):
        total = 0.0
        for start, end, sign, powers in parts:
            if start <= x < end:
                for c, o, p in powers:
                    total += sign * c * (x - o) ** p
        return total

    def weight(t):
        if exponential:
            return math.exp(-(t + min(s, 0.0)))
        w = norm * math.exp(-t * (s + t / 2) if s >= 0 else -((s + t) ** 2) / 2)
        return w * (s + t) if slope else w

    return lambda t: law(t / scale) * weight(t)


def integrate(problem, tolerance):
    s, slope, exponential, scale, breaks, parts = problem
    f = integrand(s, slope, exponential, scale, parts)
    total, count, converged = 0.0, 0, 1
    for a, b in zip(breaks, breaks[1:]):
        if b > a:
            found = quad(f, a, b, epsabs=0.0, epsrel=tolerance, limit=1000, full_output=1)
            total += found[0]
            count += found[2]["neval"]
            if len(found) > 3:
                converged = 0
    return total, count, converged


lines = iter(sys.stdin.read().splitlines())
for head in lines:
    tolerance, repeats, count = head.split()
    tolerance, repeats = float(tolerance), int(repeats)
    problems = [read_problem(next(lines)) for _ in range(int(count))]
    answers = [integrate(p, tolerance) for p in problems]
    times = []
    for _ in range(repeats):
        start = time.perf_counter_ns()
        for p in problems:
            integrate(p, tolerance)
        times.append((time.perf_counter_ns() - start) / len(problems))
    print(sorted(times)[repeats // 2] if repeats else 0)
    for value, evaluations, converged in answers:
        print("%r %d %d" % (value, evaluations, converged))
