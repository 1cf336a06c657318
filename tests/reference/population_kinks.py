"""Values of population.csv for laws with a kink or jump at w_c, CEB and AF, at -1 rms: the double
integral over curvatures and interferences by Gauss-Legendre panels split at w_c, tangents by a
complex step. Panels of 40 points; 20, 40 and 60 panels agree to 1e-14. Needs numpy and scipy."""
import numpy as np
from numpy.polynomial.legendre import leggauss
from scipy.special import erfc

# E, nu, H, S, m0, m2, m4 of population_scenes.csv.
SCENES = {"medium": (116e9, 0.31, 1.12e9, 0.58, 4e-13, 4e-4, 3.08e6),
          "broad": (70e9, 0.33, 1.5e9, 0.59, 1e-12, 2e-3, 2.4e8)}
NODES, WEIGHTS = leggauss(40)


def panels(edges):
    a, b = np.asarray(edges)[:-1, None], np.asarray(edges)[1:, None]
    return ((a + b + (b - a) * NODES) / 2).ravel(), ((b - a) / 2 * WEIGHTS).ravel()


def density(z, k, m0, m2, m4):
    """Nayak's density of summits of height z and k = 1/R per area, integrated over the mean curvature."""
    s2, mu, sc2 = m4 / 3, 1.5 * m2 / m4, m0 * (1 - 1.5 * m2**2 / (m0 * m4))
    a, b = 3 / (4 * s2) + mu**2 / (2 * sc2), mu * z / (2 * sc2)
    exponent = k**2 / (2 * s2) - z**2 / (2 * sc2) + b**2 / a
    mean = 0.5 * np.sqrt(np.pi / a) * erfc(np.sqrt(a) * (k - b / a)) * np.exp(exponent)
    return k**3 / s2 / (2 * np.pi * m2) * mean / np.sqrt(4 * np.pi * s2) / np.sqrt(2 * np.pi * sc2)


def force(model, w, k, e, s, h):
    strain = np.pi * s * h / (2 * e)
    r, wc = 1 / k, strain**2 / k
    hertz = 4 / 3 * e * np.sqrt(r) * w**1.5
    y = np.maximum(w - wc, 0)
    if model == "ceb":
        return np.where(w < wc, hertz, np.pi * r * s * h * (2 * w - wc))
    inner = r - wc
    return hertz - 4 / 3 * e * np.sqrt(inner) * y**1.5 + 2 * np.pi * inner * y * s * h


def area(model, w, k, e, s, h):
    r, wc = 1 / k, (np.pi * s * h / (2 * e)) ** 2 / k
    inner = r if model == "ceb" else r - wc
    return np.pi * (r * w + inner * np.maximum(w - wc, 0))


def total(law, model, scene, height, count=40):
    e, _, h, s, m0, m2, m4 = SCENES[scene]
    root, mu = np.sqrt(m4 / 3), 1.5 * m2 / m4
    rest = np.sqrt(m0 * (1 - 1.5 * m2**2 / (m0 * m4)))
    z0, found = height * np.sqrt(m0), 0.0
    for k, weight in zip(*panels(np.linspace(0, np.sqrt(16 * root), count + 1) ** 2)):
        last = max(12 * np.sqrt(m0), 12 * rest + mu * max(14 * root, k + 8 * root)) - np.real(z0)
        wc = (np.pi * s * h / (2 * e)) ** 2 / k
        edges = np.linspace(0, np.sqrt(min(wc, last)), count // 2 + 1) ** 2
        if wc < last:
            # Powers of 1.5 begin at w_c: squares of the distance from it.
            edges = np.r_[edges, wc + (last - wc) * np.linspace(0, 1, count + 1)[1:] ** 2]
        w, ww = panels(edges)
        found += weight * np.sum(ww * law(model, w, k, e, s, h) * density(z0 + w, k, m0, m2, m4))
    return found


if __name__ == "__main__":
    for scene in SCENES:
        for model in ("ceb", "af"):
            for name, law in (("force", force), ("area", area)):
                print(f"{scene},{model},-1.0,{name},{float(total(law, model, scene, -1.0))!r}")
            step = 1e-20
            m0 = SCENES[scene][4]
            slope = -np.imag(total(force, model, scene, -1.0 + 1j * step)) / step / np.sqrt(m0)
            print(f"{scene},{model},-1.0,tangent,{float(slope)!r}")
