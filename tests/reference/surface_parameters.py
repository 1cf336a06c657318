"""Parameters of two open surfaces by surfalize, and spectra of a periodic one by SurfaceTopography.

    pip install surfalize SurfaceTopography; python surface_parameters.py > surface_parameters.csv

Made with surfalize 0.19.2 and SurfaceTopography 1.27.1. Heights in um at (x, y) points; lengths in
um. Sal and Str of surfalize follow a cubic spline along rays, those of asperity the contour between
neighbouring lags: they agree to parts of a point.
"""

import sys
import warnings

import numpy as np
import SurfaceTopography as st
import surfalize

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
