"""Flow and friction factors of Patir & Cheng (1978, 1979) from their tables, by mpmath (30 digits). Writes
patir_cheng.csv; tests/reference/patir_cheng_tables.csv holds the tables as public code quotes them.

Columns: Peklenik number gamma, film over sigma H; phi_x, phi_y of the tables; Phi_s, Phi_fs of one surface;
phi_f = H INT f(z) dz/(H + z) by quadrature over local gaps above 0.01, of the density
f = (35/96) (1 - (z/3)^2)^3 on |z| < 3; phi_fp (gamma = 1). Empty below the range of a fit.
"""

from csv import DictReader
from fractions import Fraction
from pathlib import Path

from mpmath import exp, log, mp, mpf, quad

mp.dps = 30
HERE = Path(__file__).parent
with (HERE / "patir_cheng_tables.csv").open() as file:
    lines = [line for line in file if not line.startswith("#")]
FITS = {Fraction(row.pop("gamma")): {k: mpf(v) for k, v in row.items()} for row in DictReader(lines)}
FILMS = ["0.5", "0.75", "1", "1.5", "2", "2.9999", "3", "3.001", "4.9", "5", "5.1", "6.999", "7", "10", "25", "60"]
BETWEEN = [Fraction(1, 7), Fraction(1, 2), Fraction(5, 4), Fraction(2), Fraction(7)]


def linear(gamma, of):
    """A value at gamma: at those of the tables the formula, between them linear in ln gamma."""
    if gamma in FITS:
        return of(FITS[gamma], gamma)
    low, high = max(g for g in FITS if g < gamma), min(g for g in FITS if g > gamma)
    ln = lambda g: log(mpf(g.numerator) / g.denominator)
    share = (ln(gamma) - ln(low)) / (ln(high) - ln(low))
    return (1 - share) * of(FITS[low], low) + share * of(FITS[high], high)


def phi_x(gamma, h):
    if h < (1 if gamma < 1 else mpf("0.5")):
        return None
    return linear(gamma, lambda fit, g: 1 - fit["C"] * exp(-fit["r"] * h) if g <= 1 else 1 + fit["C"] * h ** -fit["r"])


def shear(fit, h):
    if h > 5:
        return fit["A2"] * exp(-h / 4)
    return fit["A1"] * h ** fit["a1"] * exp(-fit["a2"] * h + fit["a3"] * h**2)


def friction(fit, h):
    return fit["A3"] * h ** fit["a4"] * exp(-fit["a5"] * h + fit["a6"] * h**2) if h < 7 else mpf(0)


def phi_f(h):
    density = lambda z: mpf(35) / 96 * (1 - (z / 3) ** 2) ** 3
    low = max(-h + mpf("0.01"), mpf(-3))
    ends = [low, low + mpf("0.05"), low + mpf("0.5"), 3]
    return h * quad(lambda z: density(z) / (h + z), ends)


rows = ["gamma,H,phi_x,phi_y,Phi_s,Phi_fs,phi_f,phi_fp"]
for gamma in sorted([*FITS, *BETWEEN]):
    for text in FILMS:
        h = mpf(text)
        values = [phi_x(gamma, h), phi_x(1 / gamma, h)]
        values += [linear(gamma, lambda fit, g: of(fit, h)) for of in (shear, friction)]
        values += [phi_f(h), 1 - mpf("1.4") * exp(mpf("-0.66") * h) if gamma == 1 and h >= mpf("0.75") else None]
        cells = ["" if value is None else mp.nstr(value, 17) for value in values]
        rows.append(",".join([mp.nstr(mpf(gamma.numerator) / gamma.denominator, 20), text, *cells]))
(HERE / "patir_cheng.csv").write_text("\n".join(rows) + "\n")
