"""Areas of JG for yield strengths near the modulus, in closed form under exponential heights.

E = 1e11 Pa, nu = 0.3, R = 1e-4 m, density 1e9 1/m2, sigma = 1 m, nominal area 1e-4 m2, at one sigma;
B and all after it from the doubles of S_y and E, to 50 digits. Writes jg_areas.csv.
"""
import mpmath as m

m.mp.dps = 50
M = m.mpf
E, nu, R, density, sigma, nominal = 1e11, 0.3, 1e-4, 1e9, 1.0, 1e-4
with open("jg_areas.csv", "w") as out:
    out.write("yield_strength,area\n")
    for ratio in (0.05, 0.09, 0.12, 0.1433, 0.17, 0.2, 0.22):
        strength = ratio * E
        strain = m.pi * M("1.295") * m.exp(M("0.736") * M(nu)) * M(strength) / (2 * M(E))
        critical = strain**2 * M(R)
        b = M("0.14") * m.exp(23 * M(strength) / M(E))
        beta, k = critical / M(sigma), M("1.9")
        elastic = m.quad(lambda x: x * m.exp(-beta * x), [0, k])
        plastic = k ** (-b) * beta ** (-(2 + b)) * m.gammainc(2 + b, beta * k)
        area = M(density) * M(nominal) * m.exp(-1) * m.pi * M(R) * critical * beta * (elastic + plastic)
        out.write(f"{strength!r},{m.nstr(area, 20)}\n")
