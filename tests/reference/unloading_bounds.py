"""Values of joints on their way back to 17 digits, by mpmath at 40: Hertz' law, KE and CEB, three scenes.

Writes unloading_bounds.csv beside it, in three minutes. Interferences above the one at which a contact
is lost are integrated in steps of σ_z/50 and, 2 σ_z on, σ_z/5 (and to the kinks of the laws), each by
tanh-sinh quadrature.
"""

import csv
from pathlib import Path

import mpmath as mp

from hard_cases import Scene, law

mp.mp.dps = 40
HERE = Path(__file__).parent


def laws(model, scene):
    """Force, area and the kinks of one asperity."""
    names = ("equivalent_modulus", "hardness", "pressure_factor", "asperity_radius")
    numbers = dict(zip("EHSR", (scene[name] for name in names)), G=0, nu=0, eta=0, sigma=0, An=0)
    (unit, force, pieces), (_, area, areas) = (law(model, of, Scene(**numbers), mp.mp) for of in (False, True))
    pick = lambda pieces, x: [f for kink, f in pieces if kink <= x][-1](x)
    kinks = [unit * kink for kink, _ in pieces[1:]]
    return (lambda w: force * pick(pieces, w / unit)), (lambda w: area * pick(areas, w / unit)), kinks


def left(scene, of_one, closest, retreat):
    """Force and area after a retreat, both over sigma."""
    (force, area, kinks), sigma = of_one, scene["asperity_height_std"]
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
                of_one = laws(model, scene)
                for closest, retreat in ((-1, "0.05"), (0, "1"), (3, "0.3"), (3, "1"), (6, "2")):
                    found = left(scene, of_one, mp.mpf(closest), mp.mpf(retreat))
                    digits = [mp.nstr(value, 17) for value in found]
                    out.writerow([row["case"], model, closest, retreat, *digits])


if __name__ == "__main__":
    main()
