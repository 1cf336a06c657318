"""Boundary elements: results, refusals, and models compared with them."""

from __future__ import annotations

import os
import signal
import threading
import warnings
from pathlib import Path
from typing import Any

import asperity
import numpy as np
import numpy.typing as npt
import pytest
from laws import Hertz

STEEL = asperity.Interface(116e9, 0.3, hardness=2e9)
SIDE = 1e-4
Floats = npt.NDArray[np.float64]


def rough(n: int = 96, seed: int = 1, gradient: float = 0.05) -> Floats:
    """A periodic surface of 2 to n/8 waves per side [m]."""
    k = np.fft.fftfreq(n, 1 / n)
    waves = np.hypot(k[:, None], k[None, :])
    weight = np.where((waves >= 2) & (waves <= n / 8), np.maximum(waves, 1) ** -1.8, 0)
    spectrum = np.fft.fft2(np.random.default_rng(seed).standard_normal((n, n))) * weight
    heights = np.fft.ifft2(spectrum).real
    slopes = [
        np.fft.ifft2(2j * np.pi / SIDE * q * np.fft.fft2(heights)).real for q in (k, k[:, None])
    ]
    return np.asarray(heights * gradient / np.sqrt(sum((s**2).mean() for s in slopes)))


def scan(n: int = 96) -> asperity.Topography:
    return asperity.Topography(rough(n), dx=SIDE / n, unit="m", periodic=True)


@pytest.fixture(autouse=True)
def _quiet() -> None:
    warnings.simplefilter("ignore", asperity.ContactWarning)


@pytest.fixture
def scene(tmp_path: Path) -> asperity.Scene:
    np.save(tmp_path / "scan.npy", rough())
    return asperity.Scene.parse(
        f"""
        nominal_area = 1e-6
        [interface]
        equivalent_modulus = 116e9
        poissons_ratio = 0.3
        hardness = 2e9
        [surface]
        file = "scan.npy"
        unit = "m"
        pixel_size = {SIDE / 96!r}
        periodic = true
        """,
        tmp_path,
    )


@pytest.mark.parametrize("boundary", ["periodic", "free"])
@pytest.mark.parametrize("elastic", [True, False])
def test_maps_agree_with_the_numbers(boundary: asperity._bem.Boundary, elastic: bool) -> None:
    given = np.array([2e7, 2e8])
    found = asperity.bem(
        scan(), interface=STEEL, pressure=given, boundary=boundary, elastic=elastic
    )
    assert found.pressures is not None and found.gaps is not None
    assert found.pressures.shape == found.gaps.shape == (2, 96, 96)
    np.testing.assert_allclose(found.pressures.mean(axis=(1, 2)), given, rtol=1e-9)
    np.testing.assert_allclose(found.gaps.mean(axis=(1, 2)), found["mean_gap_m"], rtol=1e-9)
    carries = found.pressures > 0
    np.testing.assert_allclose(carries.mean(axis=(1, 2)), found["area_fraction_pixels"])
    for k in range(2):
        opened = found.gaps[k][found.pressures[k] == 0].mean()
        assert found["mean_open_gap_m"][k] == pytest.approx(opened, rel=1e-9)
    np.testing.assert_allclose(found["load_N"], given * SIDE**2)
    sq = rough().std()
    assert (np.abs(found.gaps[carries & (found.pressures < 2e9)]) < 1e-5 * sq).all()
    plastic = found["plastic_fraction"][1]
    assert plastic == 0 if elastic else plastic > 0
    # Rows of another distance.
    oblong = asperity.Topography(rough(), (SIDE / 96, SIDE / 48), "m", periodic=True)
    twice = asperity.bem(oblong, interface=STEEL, pressure=given, maps=False)
    np.testing.assert_allclose(twice["load_N"], 2 * found["load_N"], rtol=1e-12)
    assert twice.pressures is None and twice.gaps is None


def test_scene_and_scan_are_the_same_contact(scene: asperity.Scene) -> None:
    one = asperity.bem(scene, load=[50.0])
    two = asperity.bem(scan(), interface=STEEL, pressure=[5e7], maps=False)
    np.testing.assert_allclose(one["area_fraction"], two["area_fraction"], rtol=1e-12)
    assert one["load_N"] == pytest.approx(50.0)
    back = asperity.bem(scene, gap=one["mean_gap_m"])
    np.testing.assert_allclose(back["pressure_Pa"], 5e7, rtol=1e-4)
    # Other materials keep the scan, another surface does not.
    assert asperity.bem(scene.replace(hardness=1e9), load=50.0)["plastic_fraction"] > 0
    with pytest.raises(ValueError, match=r"surface\.file"):
        asperity.bem(scene.replace(asperity_height_std=1e-6), load=50.0)


def test_models_are_compared_with_it(scene: asperity.Scene) -> None:
    rows = asperity.truth(scene, pressure=[2e7, 2e8], models=["gw", "ke"])
    assert rows["model"] == ["bem", "gw", "ke"] * 2
    found = asperity.bem(scene, pressure=[2e7, 2e8])
    of_bem, of_ke = rows.of("bem"), rows.of("ke")
    np.testing.assert_allclose(of_bem["area_fraction"], found["area_fraction"], rtol=1e-9)
    assert (of_bem["area_deviation"] == 0).all()
    alone = asperity.truth(scene, load=20.0, models=["ke"])
    head, *lines = str(alone).splitlines()
    assert head.split()[:3] == ["load_N", "pressure_Pa", "model"] and lines[0].split()[0] == "20"
    assert alone["area_fraction"][1] == of_ke["area_fraction"][0]
    everything = set(asperity.truth(scene, pressure=2e7)["model"])
    assert everything > {"bem", "ke-random", "persson-fudge", *scene.models()}


class Own(Hertz):
    """Under another name."""


class Broken(Own):
    def area(self, w: Floats) -> Floats:
        raise ZeroDivisionError("no area")


def test_a_model_of_ones_own_is_compared_under_its_name(scene: asperity.Scene) -> None:
    own, quantities = asperity.model(Own), ["stiffness", "unloading-stiffness"]
    rows = asperity.truth(scene, pressure=2e8, models=["gw", own], quantities=quantities)
    gw, mine = rows.of("gw"), rows.of("Own")
    numbers = [name for name in mine if name not in ("model", "boundary")]
    assert len(numbers) == 10 and "unloading_stiffness_deviation" in numbers
    for name in numbers:
        assert mine[name] == pytest.approx(gw[name], rel=1e-9), name
    # As in a fit, the exception of the user's own code.
    broken = asperity.model(Broken)
    with pytest.raises(ZeroDivisionError, match="no area"):
        asperity.truth(scene, pressure=2e8, models=broken)


def test_it_is_a_model_by_name(scene: asperity.Scene) -> None:
    bem = asperity.model("bem")
    assert (bem.id, bem.name) == ("bem", "BEM")
    curve = bem.solve(scene, load=[50.0, 100.0], quantities=["area_fraction", "mean_pressure"])
    found = asperity.bem(scene, load=[50.0, 100.0], maps=False)
    np.testing.assert_allclose(curve.area_fraction, found["area_fraction"], rtol=1e-6)
    gap = bem.separation_at(scene, load=50.0, separation_unit="m")
    assert float(gap) == pytest.approx(found["mean_gap_m"][0] - scene.surface.mean_plane_offset)
    with pytest.raises(ValueError, match=r"surface\.file"):
        bem.solve(scene.replace(asperity_height_std=1e-6), load=50.0)
    with pytest.raises(ValueError, match="2 scenes were given"):
        bem.solve([scene, scene.replace(hardness=3e9)], load=50.0)


def test_solved_contacts_are_kept_beside_blank_ones(scene: asperity.Scene) -> None:
    pressures = [8e9, 1e7, 2e8]
    with pytest.warns(asperity.ContactWarning, match="^no-value: "):
        kept = asperity.bem(scene, pressure=pressures)
    assert np.isnan(kept["area_fraction"]).tolist() == [True, False, False]
    alone = asperity.bem(scene, pressure=pressures[1:])
    np.testing.assert_allclose(kept["area_fraction"][1:], alone["area_fraction"], rtol=1e-6)
    assert kept["patches"][2] == alone["patches"][1]
    assert kept.pressures is not None and np.isnan(kept.pressures[0]).all()
    assert (kept.pressures[2] > 0).mean() == kept["area_fraction_pixels"][2]
    with pytest.warns(asperity.ContactWarning, match="^no-value: "):
        rows = asperity.truth(scene, pressure=pressures, models=["ke"], refine=True)
    assert rows["model"] == ["bem", "bem-half-grid", "ke"] * 2 and rows["pressure_Pa"][0] == 1e7
    with pytest.raises(ValueError, match="^truth: "):
        asperity.truth(scene, pressure=8e9, models=["ke"])


def test_unresolved_contacts_and_open_edges_are_warned_of(scene: asperity.Scene) -> None:
    with pytest.warns(asperity.ContactWarning, match="^few-") as seen:
        asperity.bem(scene, pressure=[1e5, 2e5])
    assert seen[0].filename == __file__
    half = asperity.Topography(rough()[:40, :50], SIDE / 96, "m")
    with pytest.warns(asperity.ContactWarning, match="^periodic-part: "):
        asperity.bem(half, interface=STEEL, pressure=1e8)


def test_ctrl_c_stops_the_solver() -> None:
    surface, over = scan(256), threading.Event()

    def send() -> None:
        # Sent again: on a busy machine the interpreter may lose a signal inside a callback.
        while not over.wait(0.5):
            os.kill(os.getpid(), signal.SIGINT)
            over.wait(2.0)

    sender = threading.Thread(target=send)
    with pytest.raises(KeyboardInterrupt):
        sender.start()
        try:
            asperity.bem(
                surface,
                interface=STEEL,
                # A minute and more without the signal.
                pressure=np.geomspace(1e5, 1e9, 5000),
                boundary="free",
                maps=False,
            )
        finally:
            over.set()
    sender.join()


def test_a_yielded_scan_opens_along_its_own_path() -> None:
    i = np.arange(64) * 2 * np.pi / 64
    waves = 2e-8 * (np.cos(3 * i)[:, None] * np.cos(2 * i) + 0.4 * np.sin(5 * i + 1)[:, None])
    heights = asperity.Topography(waves, 1e-6, "m", periodic=True)
    solid = asperity.Interface(1e11, 0.3, hardness=1.5e8)
    given: dict[str, Any] = {"interface": solid}
    path = asperity.bem_unloading(heights, pressure="50 MPa", points=5, **given)
    loaded = asperity.bem(heights, pressure=50e6, quantities=["unloading-stiffness"], **given)
    assert loaded["plastic_fraction"] > 0
    assert path["pressure_Pa"][0] == pytest.approx(50e6, rel=1e-9)
    stiffness = loaded["unloading_stiffness_N_per_m"][0]
    assert path["stiffness_N_per_m"][0] == pytest.approx(stiffness, rel=1e-9)
    assert path["area_fraction"][0] == pytest.approx(loaded["area_fraction"][0], rel=1e-9)
    assert path["pressure_Pa"][-1] <= 0
    assert path["retreat_m"][-1] == pytest.approx(path.last_contact)
    retreat = path["retreat_m"][1]
    again = asperity.bem_unloading(heights, load=path["load_N"][0], retreat=retreat, **given)
    assert again["pressure_Pa"] == pytest.approx(path["pressure_Pa"][1], rel=1e-6)


def test_a_scan_slips_and_sticks(tmp_path: Path, scene: asperity.Scene) -> None:
    np.save(tmp_path / "scan.npy", rough())
    shear = "equivalent_shear_modulus = 24e9"
    elastic = asperity.Scene.parse(scene.to_toml().replace("hardness = 2e9", shear), tmp_path)
    given: dict[str, Any] = {"friction": 0.3, "pressure": "20 MPa"}
    slip = asperity.bem_slip(elastic, amplitude="3 nm", points=5, **given)
    force, back, loss = slip["force_N"], slip["back_N"], slip["loss_J"]
    np.testing.assert_allclose(slip["shift_m"], np.linspace(-3e-9, 3e-9, 5), atol=1e-24)
    assert np.isnan(force[:2]).all() and force[2] == 0
    assert slip["forth_N"][2] == -back[2] and 0 < loss[3] < loss[4]
    pressed = asperity.bem(elastic, pressure=20e6)
    assert pressed.pressures is not None
    np.testing.assert_array_equal(slip.states > 0, pressed.pressures[0] > 0)
    assert {1.0, 2.0} < set(slip.states.ravel())


SEAL = """
[seal]
width = "100 mm"
length = "2 mm"
upstream_pressure = "10 bar"
downstream_pressure = "1 bar"
"""


def test_a_scan_leaks_through_the_seal_of_its_scene(tmp_path: Path, scene: asperity.Scene) -> None:
    def leaking(fluid: str) -> asperity.Scene:
        return asperity.Scene.parse(scene.to_toml() + SEAL + fluid, tmp_path)

    given: dict[str, Any] = {"elastic": True, "maps": False, "pressure": [1e7, 2e8, 5e9]}
    asked = ["effective-medium-gap", "hydraulic-gap-x", "hydraulic-gap-y", "leak"]
    found = asperity.bem(leaking("viscosity = 1e-3"), quantities=asked, **given)
    x, y, flow = found["hydraulic_gap_x_m"], found["hydraulic_gap_y_m"], found["leak_x_m3_per_s"]
    assert x[:2] == pytest.approx(found["effective_medium_gap_m"][:2], rel=0.2)
    assert flow[0] > flow[1] > flow[2] == y[2] == 0 and np.isnan(found["tightest_gap_x_m"][2])
    assert any("no open path along x in 1 of 3" in text for text in found.results)
    gas = asperity.bem(leaking('gas = "helium"'), quantities=["leak"], **given)
    # R T times kg/s, in mbar l/s.
    np.testing.assert_allclose(
        gas["leak_x_mbar_l_per_s"], gas["leak_x_kg_per_s"] * 10 * 2077.26 * 293.15, rtol=1e-5
    )
    with pytest.raises(ValueError, match=r"seal is missing"):
        asperity.bem(scene, quantities=["leak"], **given)


def test_sealing_pressures_are_those_of_samples(scene: asperity.Scene) -> None:
    found = asperity.sealing_pressure(scene, samples=3, elastic=True)
    low, middle, high = (found[f"{which}_sealing_pressure_Pa"] for which in ("lowest", "middle", "highest"))
    assert list(found["flow_along"]) == ["x", "y"] and (low <= middle).all() and (middle <= high).all()
    given: dict[str, Any] = {"elastic": True, "maps": False, "quantities": ["hydraulic-gap-x"]}
    gaps = asperity.bem(scene, pressure=[0.98 * low[0], 1.02 * high[0]], **given)["hydraulic_gap_x_m"]
    assert gaps[0] > 0
    with pytest.raises(ValueError, match="samples is 1"):
        asperity.sealing_pressure(scene, samples=1)


def test_what_was_solved_is_an_input_of_the_answer(scene: asperity.Scene) -> None:
    solved = asperity.bem(scene, pressure=2e8, quantities=["tangent"], maps=False)
    asked = {"pressure": 2e8, "quantities": ["area-fraction", "tangent"]}
    with_it = scene.answer(**asked, solved=solved)  # type: ignore[arg-type]
    uncertain = {"few-patches", "few-pixels", "short-waves"} & {one.code for one in solved.findings}
    if not uncertain:
        assert with_it.value["tangent"] == solved["tangent_N_per_m"][0]
        assert "boundary elements on this scan" in with_it.by
    plain = scene.answer(**asked)  # type: ignore[arg-type]
    assert "boundary elements on this scan" not in plain.by
