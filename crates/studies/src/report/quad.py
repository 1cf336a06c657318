"""scipy.integrate.quad between the given breaks; protocol in scipy.rs."""
import json
import math
import sys
import time

from scipy.integrate import quad


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
    tolerance, repeats, breaks, of = json.loads(line)
    f = integrand(*of)
    answer = integrate(tolerance, breaks, f)
    times = [0]
    for k in range(repeats):
        start = time.perf_counter_ns()
        integrate(tolerance, breaks, f)
        times[k:] = [time.perf_counter_ns() - start]
    print("%r %d" % answer, sorted(times)[len(times) // 2])
