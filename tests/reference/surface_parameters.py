"""Parameters of two open surfaces and a profile by surfalize, and spectra of a periodic one by SurfaceTopography.

    pip install surfalize SurfaceTopography; python surface_parameters.py > surface_parameters.csv

Made with surfalize 0.19.2 and SurfaceTopography 1.27.1. Heights in um at (x, y) points; lengths in
um. The curve of material ratios has a class for each point; its areas are those
under a line, up to the class nearest to the limit of the core; those of asperity, means over the
points, differ by parts of a point's share; they are computed by NumPy (names in lower case). Sal and Str of surfalize follow a
cubic spline along rays, those of asperity the contour between neighbouring lags: they agree to
parts of a point.
"""

import sys
import warnings

import numpy as np
import SurfaceTopography as st
import surfalize
from surfalize.abbottfirestone import AbbottFirestoneCurve

ROWS, COLUMNS, STEP_X, STEP_Y = 128, 160, 0.5, 0.4


def heights(stretch):
    y, x = np.mgrid[:ROWS, :COLUMNS].astype(float)
    x *= stretch
    z = np.zeros((ROWS, COLUMNS))
    for k in range(1, 40):
        wave = 0.035 * (k + 6) * (x * np.cos(2.4 * k) + y * np.sin(2.4 * k)) + 7.1 * k * k
        z += 0.3 * np.cos(wave) / (1 + 0.1 * k)
    return z


def periodic():
    y, x = np.mgrid[:ROWS, :COLUMNS].astype(float)
    z = np.zeros((ROWS, COLUMNS))
    for k in range(1, 60):
        i, j = (7 * k) % 23, (11 * k) % 37
        z += np.cos(2 * np.pi * (i * y / ROWS + j * x / COLUMNS) + 7.1 * k * k) / (i + j + 1) ** 1.5
    return z


out = ["case,name,at,value"]
warnings.simplefilter("ignore")
for case, stretch in [("broad", 1.0), ("lay", 0.3)]:
    z = heights(stretch)
    surface = surfalize.Surface(z - z.mean(), STEP_X, STEP_Y)
    for name in "Sq Sa Sz Sp Sv Ssk Sku Sdq Sdr Sal Str Spd Spc".split():
        value = float(getattr(surface, name)())
        value = value / 100 if name == "Sdr" else value
        out.append(f"{case},{name},,{value!r}")
    curve = AbbottFirestoneCurve(surface, nbins=z.size)
    for name in "k pk vk mr1 mr2 vmp vmc vvc vvv".split():
        value = float(getattr(curve, name)())
        value = value / 100 if name.startswith("mr") else value
        out.append(f"{case},S{name},,{value!r}")
    # The same areas, as means over the points.
    ratios = np.linspace(0, 1, z.size)
    curved = np.sort((z - z.mean()).ravel())[::-1]

    def above(level):
        return np.clip(curved - level, 0, None).mean()

    def below(level):
        return np.clip(level - curved, 0, None).mean()

    mr1, mr2 = curve.mr1() / 100, curve.mr2() / 100
    top, bottom = np.interp([mr1, mr2], ratios, curved)
    out.append(f"{case},pk,,{float(2 * above(top) / mr1)!r}")
    out.append(f"{case},vk,,{float(2 * below(bottom) / (1 - mr2))!r}")
    z10, z80 = np.interp([0.1, 0.8], ratios, curved)
    vmp, vvv = above(z10), below(z80)
    out.append(f"{case},vmp,,{float(vmp)!r}")
    out.append(f"{case},vmc,,{float(above(z80) - vmp)!r}")
    out.append(f"{case},vvc,,{float(below(z10) - vvv)!r}")
    out.append(f"{case},vvv,,{float(vvv)!r}")
row = heights(1.0)[0]
profile = surfalize.Profile(row - row.mean(), STEP_X)
curve = AbbottFirestoneCurve(profile, nbins=row.size)
for name, value in [
    ("rk", curve.k()),
    ("rmr1", curve.mr1() / 100),
    ("rmr2", curve.mr2() / 100),
    ("rz", profile.Rz()),
    ("rdq", profile.Rdq()),
]:
    out.append(f"profile,{name},,{float(value)!r}")
topography = st.Topography(
    periodic().T, (COLUMNS * STEP_X, ROWS * STEP_Y), periodic=True, unit="um"
)
low = 2 * np.pi / (COLUMNS * STEP_X)
edges = low * 2 ** ((np.arange(0, 40) - 0.5) / 4)
for name, spectrum, top in [
    ("along_rows", topography.power_spectrum_from_profile, np.pi / STEP_X),
    ("radial", topography.power_spectrum_from_area, np.pi / STEP_X),
]:
    if name == "radial":
        q, c = spectrum(reliable=False, collocation=edges[edges < top * 1.2])[:2]
    else:
        q, c = spectrum(reliable=False, resampling_method=None)
    q, c = np.ma.filled(q, np.nan), np.ma.filled(c, np.nan)
    for q, c in zip(q, c):
        # Profiles: waves that have a bin of their own.
        if c > 1e-20 and 0 < q < (0.9 * top if name == "radial" else 8.5 * low):
            out.append(f"periodic,{name},{float(q)!r},{float(c)!r}")
sys.stdout.write("\n".join(out) + "\n")
