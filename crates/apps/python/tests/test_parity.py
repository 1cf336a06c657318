"""What the program can, the package can: scans, scene files, tables for solvers, pictures."""

from __future__ import annotations

from pathlib import Path

import asperity
import matplotlib
import numpy as np
import pytest

matplotlib.use("Agg")


def waves(phase: float) -> np.ndarray[tuple[int, ...], np.dtype[np.float64]]:
    """A rough surface of waves in all directions [m], 96 x 96 points."""
    y, x = np.mgrid[:96, :96].astype(float)
    heights = np.zeros((96, 96))
    for k in range(1, 40):
        angle, size = 2.399963 * k, 0.035 * (k + 6)
        along = x * np.cos(angle) + y * np.sin(angle)
        heights += np.cos(size * along + (7.1 + phase) * k * k) / (10 + k)
    return 3e-6 * heights


def test_a_scan_is_read_levelled_filtered_and_smoothed(tmp_path: Path) -> None:
    np.savetxt(tmp_path / "scan.txt", waves(0.0) * 1e6)
    scan = asperity.read(tmp_path / "scan.txt", unit="um", pixel_size=2.0)
    np.testing.assert_allclose(scan.heights, waves(0.0), rtol=1e-12, atol=1e-20)
    assert scan.pixel_size == pytest.approx((2e-6, 2e-6)) and not scan.periodic
    one_by_one = scan.level("plane").filter(6e-5).statistics(level="none")
    at_once = scan.statistics(level="plane", cutoff=6e-5)
    # approx does not compare nested dicts.
    assert one_by_one.pop("outliers") == at_once.pop("outliers")
    assert one_by_one == pytest.approx(at_once)
    smooth = scan.smooth(1e-5)
    assert isinstance(smooth, asperity.Topography)
    assert smooth.surface().asperity_radius > 1.05 * scan.surface().asperity_radius
    with pytest.raises(ValueError, match="unit of"):
        asperity.read(tmp_path / "scan.txt")


def test_two_surfaces_and_measured_heights_make_scenes(tmp_path: Path) -> None:
    one, two = (asperity.Topography(waves(phase), 2e-6, "m").level() for phase in (0.0, 0.4))
    both = one.against(two)
    moments = [scan.statistics(level="none") for scan in (one, two)]
    added = {key: sum(m[key] for m in moments) for key in ("m0", "m2", "m4")}
    assert both == asperity.Surface.of(**added)
    interface = asperity.Interface(116e9, 0.31, hardness=1.12e9)
    heights = (-1e-6, 0.0, 1e-6), (0.0, 1e6, 0.0)
    measured = asperity.Scene(interface, one.surface(estimator="summits"), 1e-4, heights=heights)
    path = tmp_path / "measured.toml"
    measured.to_toml(path)
    again = asperity.Scene.from_toml(path)
    assert again == measured
    assert asperity.Scene.parse(measured.to_toml()) == measured


def test_scenes_are_written_with_plane_and_options(scene: asperity.Scene) -> None:
    other = asperity.Scene(
        scene.interface,
        scene.surface,
        scene.nominal_area,
        separation_from="surface-mean",
        mean_plane_offset=2.5e-7,
        options={"force": "vertical"},
    )
    again = asperity.Scene.parse(other.to_toml())
    assert again == other and again.mean_plane_offset == 2.5e-7
    ke = asperity.model("ke")
    from_asperities = ke.solve(scene, 1.75e-6, separation_unit="m").force
    from_surface = ke.solve(again, 2e-6, separation_unit="m").force
    np.testing.assert_allclose(from_surface, from_asperities, rtol=1e-12)
    assert asperity.Scene.parse(scene.to_toml()) == scene


def test_tables_for_solvers_are_those_of_the_library(scene: asperity.Scene) -> None:
    table = asperity.export("ke", scene, load=(1.0, 1e3), max_error=1e-4)
    again = asperity.export("ke", scene, load=("1 N", "1 kN"), max_error=1e-4)
    assert again.text == table.text
    assert table.pressure_error <= 1e-4 and (np.diff(table.clearance) > 0).all()
    curve = asperity.model("ke").solve(
        scene, table.clearance, ["pressure", "tangent"], separation_unit="m"
    )
    np.testing.assert_allclose(table.pressure, curve.pressure, rtol=1e-9)
    np.testing.assert_allclose(table.tangent, curve.tangent / scene.nominal_area, rtol=1e-9)
    for form, text in [
        ("csv", "clearance_m,pressure_Pa,tangent_Pa_per_m"),
        ("abaqus", "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=TABULAR"),
        ("calculix", "TYPE=NODE TO SURFACE"),
    ]:
        assert text in str(asperity.export("ke", scene, form, load=(10.0, 1e3), nodes=8))
    mm = asperity.export("ke", scene, load=(1.0, 1e3), max_error=1e-4, units="mm-N-MPa")
    assert "clearance_mm,pressure_MPa,tangent_MPa_per_mm" in mm.text
    np.testing.assert_array_equal(mm.pressure, table.pressure)
