"""Values of joints on their way back to 17 digits, by mpmath at 40: Hertz' law, KE and CEB, three scenes.

Writes unloading_bounds.csv beside it, in three minutes. Interferences above the one at which a contact
is lost are integrated in steps of σ_z/50 and, 2 σ_z on, σ_z/5 (and to the kinks of the laws), each by
tanh-sinh quadrature.
"""

import csv
from pathlib import Path

import mpmath as mp

mp.mp.dps = 40
HERE = Path(__file__).parent


def laws(model, scene):
    """Force, area and the kinks of one asperity."""
    e, k, h, r = (scene[key] for key in ("equivalent_modulus", "pressure_factor", "hardness", "asperity_radius"))
    critical = (mp.pi * k * h / (2 * e)) ** 2 * r
    hertz = lambda w: 4 * e * mp.sqrt(r) * w ** mp.mpf("1.5") / 3
    if model == "ceb":
        area = lambda w: mp.pi * r * w * (1 if w <= critical else 2 - critical / w)
        return (lambda w: hertz(w) if w <= critical else k * h * area(w)), area, [critical]
    unit, whole = hertz(critical), mp.pi * r * critical

    def pick(w, powers):
        x = w / critical
        for end, factor, exponent in powers:
            if x <= end:
                return factor * x**exponent

    n = mp.mpf
    force = [(1, n(1), n("1.5")), (6, n("1.03"), n("1.425")), (110, n("1.4"), n("1.263")), (mp.inf, 3 / k, n(1))]
    areas = [(1, n(1), n(1)), (6, n("0.93"), n("1.136")), (110, n("0.94"), n("1.146")), (mp.inf, n(2), n(1))]
    kinks = [critical * x for x in (1, 6, 110)]
    return (lambda w: unit * pick(w, force)), (lambda w: whole * pick(w, areas)), kinks


def left(scene, law, closest, retreat):
    """Force and area after a retreat, both over sigma."""
    (force, area, kinks), sigma = law, scene["asperity_height_std"]
    e, u = scene["equivalent_modulus"], retreat * sigma
    back = lambda w: 3 * force(w) / (4 * e * mp.sqrt(area(w) / mp.pi))
    low, high = mp.mpf(0), sigma
    while back(high) <= u:
        low, high = high, 2 * high
    for _ in range(140):
        middle = (low + high) / 2
        low, high = (middle, high) if back(middle) <= u else (low, middle)
    steps = [high + sigma * mp.mpf(k) / 50 for k in range(1, 101)]
    steps += [high + sigma * (2 + mp.mpf(k) / 5) for k in range(1, 60)]
    ends = sorted([high] + steps + [x for x in kinks if x > high])
    last = max(high + 6 * sigma, (11 - closest) * sigma)
    ends = [x for x in ends if x <= last]

    def density(w):
        return mp.exp(-((closest + w / sigma) ** 2) / 2) / mp.sqrt(2 * mp.pi) / sigma

    def part(w, of, power):
        share = 1 - u / back(w)
        return of(w) * share**power * density(w) if share > 0 else mp.mpf(0)

    count = scene["asperity_density"] * scene["nominal_area"]
    return [
        count * mp.quad(lambda w: part(w, of, power), ends, maxdegree=5)
        for of, power in ((force, mp.mpf("1.5")), (area, 1))
    ]


def main():
    scenes = list(csv.DictReader((HERE / "models_scenes.csv").open()))
    with (HERE / "unloading_bounds.csv").open("w", newline="") as file:
        out = csv.writer(file, lineterminator="\n")
        out.writerow(["case", "model", "closest", "retreat", "force", "area"])
        for row in scenes:
            if row["case"] not in ("at-paper", "mild", "severe"):
                continue
            scene = {key: mp.mpf(value) for key, value in row.items() if key != "case"}
            for model in ("ceb", "ke"):
                law = laws(model, scene)
                for closest, retreat in ((-1, "0.05"), (0, "1"), (3, "0.3"), (3, "1"), (6, "2")):
                    found = left(scene, law, mp.mpf(closest), mp.mpf(retreat))
                    digits = [mp.nstr(value, 17) for value in found]
                    out.writerow([row["case"], model, closest, retreat, *digits])


if __name__ == "__main__":
    main()
