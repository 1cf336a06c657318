"""Boundary elements: results, refusals, and models compared with them."""

from __future__ import annotations

import copy
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
    # Other materials keep the scan.
    assert asperity.bem(scene.replace(hardness=1e9), load=50.0)["plastic_fraction"] > 0
    with pytest.raises(ValueError, match=r"surface\.file"):
        asperity.bem(asperity.Scene(STEEL, scene.surface, 1e-6), load=50.0)


def test_it_is_a_model_by_name(scene: asperity.Scene) -> None:
    bem = asperity.model("bem")
    assert (bem.id, bem.name) == ("bem", "BEM")
    curve = bem.solve(scene, load=[50.0, 100.0], quantities=["area_fraction", "mean_pressure"])
    found = asperity.bem(scene, load=[50.0, 100.0], maps=False)
    np.testing.assert_allclose(curve.area_fraction, found["area_fraction"], rtol=1e-6)
    gap = bem.separation_at(scene, load=50.0, separation_unit="m")
    assert float(gap) == pytest.approx(found["mean_gap_m"][0] - scene.surface.mean_plane_offset)
    with pytest.raises(ValueError, match=r"surface\.file"):
        bem.solve(asperity.Scene(STEEL, scene.surface, 1e-6), load=50.0)
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


def test_a_scan_counts_by_what_was_measured(scene: asperity.Scene, tmp_path: Path) -> None:
    assert copy.copy(scene) is scene and copy.deepcopy(scene) is scene
    text = scene.to_toml()
    np.save(tmp_path / "scan.npy", 2.0 * rough())
    other = asperity.Scene.parse(text)
    assert other.to_toml() == text and other != scene
    solved = asperity.bem(scene, pressure=2e8, maps=False)
    for wrong in (other, scene.replace(hardness=3e9)):
        with pytest.raises(ValueError, match="solved is not of this scene with its options"):
            wrong.answer(pressure=2e8, solved=solved)
    with pytest.raises(TypeError, match="level was given beside a scene"):
        asperity.bem(scene, pressure=2e8, level="quadratic")


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
