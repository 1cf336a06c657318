"""Areas and forces of JG for yield strengths up to near the modulus, under exponential heights.

E = 1e11 Pa, nu = 0.3, R = 1e-4 m, density 1e9 1/m2, nominal area 1e-4 m2, at one sigma; B and all
after it from the doubles of S_y and E, to 50 digits: areas in closed form, forces (hardness of
2005) by tanh-sinh quadrature of octaves, checked with octaves of twice the width. Writes
jg_areas.csv, and jg_force_law.csv: F/F_c' of one asperity at x.
"""
import mpmath as m

m.mp.dps = 50
M = m.mpf
E, nu, R, density, nominal = 1e11, 0.3, 1e-4, 1e9, 1e-4
K = M("1.9")


def force_fit(x, c, strain, b):
    ratio = strain * m.sqrt(x * (x / K) ** b)
    hardness = M("2.84") * -m.expm1(-M("0.82") * ratio ** M("-0.7"))
    plastic = 4 / c * hardness * -m.expm1(-x ** (M(5) / 9) / 25) * x
    return m.exp(-x ** (M(5) / 12) / 4) * x ** M("1.5") + plastic


with open("jg_areas.csv", "w") as out:
    out.write("yield_strength,sigma,area,force\n")
    for sigma in (1.0, 1e-5):
        for ratio in (0.05, 0.09, 0.12, 0.1433, 0.17, 0.2, 0.22, 0.3):
            strength = ratio * E
            c = M("1.295") * m.exp(M("0.736") * M(nu))
            strain = m.pi * c * M(strength) / (2 * M(E))
            critical = strain**2 * M(R)
            b = M("0.14") * m.exp(23 * M(strength) / M(E))
            beta = critical / M(sigma)
            scale = M(density) * M(nominal) * m.exp(-1) * beta
            elastic = m.quad(lambda x: x * m.exp(-beta * x), [0, K])
            plastic = K ** (-b) * beta ** (-(2 + b)) * m.gammainc(2 + b, beta * K)
            area = scale * m.pi * M(R) * critical * (elastic + plastic)
            unit = M(4) / 3 * M(E) * M(R) ** 2 * strain**3
            last = max(K * 1.1, 130 / beta)
            low = m.quad(lambda x: x ** M("1.5") * m.exp(-beta * x), [0, K])

            def beyond(step):
                ends = [K]
                while ends[-1] < last:
                    # Next to the start the hardness changes as fast as x^(b/2).
                    width = min(ends[-1], ends[-1] - K + K / b)
                    ends.append(min(last, ends[-1] + width * (step - 1)))
                f = lambda x: force_fit(x, c, strain, b) * m.exp(-beta * x)
                return sum(m.quad(f, pair) for pair in zip(ends, ends[1:]))

            found, check = beyond(M("1.5")), beyond(M(2))
            assert abs(found / check - 1) < M("1e-25"), (ratio, sigma, found / check - 1)
            force = scale * unit * (low + found)
            out.write(f"{strength!r},{sigma!r},{m.nstr(area, 20)},{m.nstr(force, 20)}\n")

with open("jg_force_law.csv", "w") as out:
    out.write("yield_strength,x,force\n")
    for ratio in (0.001, 0.01, 0.03, 0.05, 0.09, 0.12, 0.1433, 0.17, 0.2, 0.22, 0.3):
        strength = ratio * E
        c = M("1.295") * m.exp(M("0.736") * M(nu))
        strain = m.pi * c * M(strength) / (2 * M(E))
        b = M("0.14") * m.exp(23 * M(strength) / M(E))
        for x in (1.9, 1.91, 2.5, 7.0, 31.0, 137.0, 1501.0, 2.3e4, 7.7e5, 1.1e7, 3.3e9):
            out.write(f"{strength!r},{x!r},{m.nstr(force_fit(M(x), c, strain, b), 20)}\n")
