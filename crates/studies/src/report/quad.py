"""scipy.integrate.quad between the given breaks; protocol in external.rs."""
import math
import sys
import time

from scipy.integrate import quad


def read_task(line):
    cells = iter(line.split())
    number = lambda: float(next(cells))
    numbers = lambda count: [number() for _ in range(count)]
    tolerance, repeats, (s, slope, scale) = number(), int(next(cells)), numbers(3)
    breaks = numbers(int(next(cells)))
    parts = []
    for _ in range(int(next(cells))):
        start, end, sign = numbers(3)
        parts.append((start, end, sign, [numbers(3) for _ in range(int(next(cells)))]))
    return tolerance, repeats, breaks, integrand(s, slope > 0, scale, parts)


def integrand(s, slope, scale, parts):
    norm = 1 / math.sqrt(2 * math.pi)

    def law(x):
        total = 0.0
        for start, end, sign, powers in parts:
            if start <= x < end:
                for c, o, p in powers:
                    total += sign * c * (x - o) ** p
        return total

    def weight(t):
        w = norm * math.exp(-t * (s + t / 2) if s >= 0 else -((s + t) ** 2) / 2)
        return w * (s + t) if slope else w

    return lambda t: law(t / scale) * weight(t)


def integrate(tolerance, breaks, f):
    total, converged = 0.0, 1
    for a, b in zip(breaks, breaks[1:]):
        if b > a:
            found = quad(f, a, b, epsabs=0.0, epsrel=tolerance, limit=1000, full_output=1)
            total += found[0]
            if len(found) > 3:
                converged = 0
    return total, converged


for line in sys.stdin:
    tolerance, repeats, breaks, f = read_task(line)
    answer = integrate(tolerance, breaks, f)
    times = [0]
    for k in range(repeats):
        start = time.perf_counter_ns()
        integrate(tolerance, breaks, f)
        times[k:] = [time.perf_counter_ns() - start]
    print("%r %d" % answer, sorted(times)[len(times) // 2])
