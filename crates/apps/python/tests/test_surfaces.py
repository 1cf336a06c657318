"""Measured surfaces: arrays, and objects of other packages, if installed."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import asperity
import numpy as np
import pytest

RNG = np.random.default_rng(7)


def rough(rows: int, columns: int) -> Any:
    """A Gaussian surface, smooth on a scale of some pixels [um], one pixel being 1 um."""
    noise = RNG.standard_normal((rows, columns))
    ky, kx = np.meshgrid(np.fft.fftfreq(rows), np.fft.fftfreq(columns), indexing="ij")
    smooth = np.fft.ifft2(np.fft.fft2(noise) * np.exp(-120.0 * (kx**2 + ky**2))).real
    return smooth / smooth.std()


HEIGHTS = rough(128, 192)


def test_units_are_those_of_heights_and_spacing() -> None:
    metres = asperity.Topography(HEIGHTS * 1e-6, 1e-6, "m")
    for unit, factor in [("um", 1.0), ("nm", 1e3), ("mm", 1e-3)]:
        other = asperity.Topography(HEIGHTS * factor, (factor, factor), unit)
        assert other.shape == (128, 192)
        np.testing.assert_allclose(other.heights, metres.heights, rtol=1e-14)
        np.testing.assert_allclose(other.pixel_size, (1e-6, 1e-6), rtol=1e-14)


def test_a_few_missing_points_are_filled() -> None:
    holed = HEIGHTS.copy()
    holed[5, 7:9] = np.nan
    holed[60, 100] = np.nan
    surface = asperity.Topography(holed, 1.0, "um")
    steel = asperity.Interface(116e9, 0.3, hardness=7e9)
    with pytest.raises(ValueError, match=r"use Topography.fill\(\)"):
        asperity.bem(surface, interface=steel, pressure=1e8)
    filled = surface.fill()
    beside = [holed[59, 100], holed[61, 100], holed[60, 99], holed[60, 101]]
    assert filled.heights[60, 100] == pytest.approx(1e-6 * np.mean(beside), rel=1e-8)
    with pytest.warns(asperity.ContactWarning):
        assert asperity.bem(filled, interface=steel, pressure=1e8)["area_fraction"] > 0.0


def test_surfaces_of_surface_topography() -> None:
    theirs: Any = pytest.importorskip("SurfaceTopography", reason="SurfaceTopography is optional")
    # The first axis is x.
    surface = theirs.Topography(HEIGHTS.T, (192.0, 256.0), unit="um", periodic=True)
    mine = asperity.read(surface)
    assert mine.shape == (128, 192)
    np.testing.assert_allclose(mine.pixel_size, (1e-6, 2e-6))
    np.testing.assert_allclose(mine.heights, HEIGHTS * 1e-6)
    ours = asperity.read(
        theirs.Topography(HEIGHTS.T, (192.0, 128.0), unit="um", periodic=True)
    )
    found = ours.statistics(level="none")
    assert found["sq"] == pytest.approx(1e-6 * HEIGHTS.std(), rel=1e-9)

    holes = np.ma.masked_greater(HEIGHTS.T, 1.0)
    masked = theirs.Topography(holes, (192.0, 128.0))
    with pytest.raises(ValueError, match="unit is missing"):
        asperity.read(masked)
    mine = asperity.read(masked, unit="nm")
    assert mine.missing_share == pytest.approx(np.ma.getmaskarray(holes).mean())

    scan = theirs.UniformLineScan(HEIGHTS[0], 192.0, unit="um")
    mine = asperity.read(scan)
    assert mine.shape == (1, 192) and mine.pixel_size == pytest.approx((1e-6, 1e-6))
    with pytest.raises(ValueError, match="unit is 'nm'"):
        asperity.read(scan, unit="nm")


def test_surfaces_of_surfalize() -> None:
    theirs: Any = pytest.importorskip("surfalize", reason="surfalize is optional")
    surface = theirs.Surface(HEIGHTS, 1.0, 1.0)
    mine = asperity.read(surface)
    np.testing.assert_allclose(mine.heights, HEIGHTS * 1e-6)
    assert mine.pixel_size == (1e-6, 1e-6)
    assert mine.statistics(level="none")["sq"] == pytest.approx(1e-6 * surface.Sq(), rel=1e-9)
    with pytest.raises(ValueError, match="unit is 'nm'"):
        asperity.read(surface, unit="nm")
    profile = theirs.Profile(HEIGHTS[0], 1.0)
    assert asperity.read(profile).shape == (1, 192)


def test_outliers_are_reported_first_and_replaced() -> None:
    spiked = HEIGHTS.copy()
    spiked[5, 7] += 30.0
    surface = asperity.Topography(spiked, 1.0, "um")
    with pytest.warns(asperity.ContactWarning) as recorded:
        statistics = surface.statistics()
    assert str(recorded[0].message).startswith("outliers: 1 ")
    assert statistics["outliers"]["count"] == 1
    assert surface.despiked().statistics()["outliers"]["count"] == 0


def test_random_surfaces_are_those_of_the_program_and_have_their_parameters() -> None:
    surface = asperity.random_surface(
        (96, 128),
        (0.5e-6, 0.4e-6),
        long=40e-6,
        roll_off=20e-6,
        short=2e-6,
        hurst=0.7,
        sq=0.3e-6,
        skewness=-0.8,
        anisotropy=2,
        direction=30,
        seed=7,
    )
    assert surface.shape == (96, 128) and surface.periodic
    assert surface.heights.std() == pytest.approx(0.3e-6, rel=1e-9)
    report = surface.report()
    assert report["slope_ratio"] == pytest.approx(2, rel=0.1)
    # Most of the heights are in the core, and skewness below 0 makes dales deeper than peaks.
    assert report["svk"] > report["spk"] and 0 < report["smr1"] < 0.2 < report["smr2"] < 1


def test_a_surface_is_written(tmp_path: Path) -> None:
    surface = asperity.random_surface((64, 64), 1e-6, long=32e-6, short=4e-6, gradient=0.1, seed=3)
    surface.to_x3p(tmp_path / "s.x3p")
    again = asperity.read(tmp_path / "s.x3p")
    np.testing.assert_array_equal(again.heights, surface.heights)
    assert again.pixel_size == surface.pixel_size


def test_heights_of_aligned_scans_add() -> None:
    z = np.arange(20.0).reshape(4, 5) ** 2
    flat, other = (asperity.Topography(h, "10 nm", "nm") for h in (z, np.ones((4, 5)) * np.arange(5)))
    assert flat.pixel_size == pytest.approx((1e-8, 1e-8), rel=1e-12)
    assert flat.facing(other).heights == pytest.approx((z + np.arange(5)) * 1e-9)
    assert flat.facing(other, mirrored=True).heights == pytest.approx((z + 4 - np.arange(5)) * 1e-9)


def test_what_a_file_lacks_is_named_as_an_argument(tmp_path: Path) -> None:
    path = tmp_path / "a.txt"
    path.write_text("1 2 3 4\n4 5 6 1\n7 8 10 2\n2 1 2 9\n")
    cases: list[tuple[dict[str, Any], str]] = [
        ({}, "give unit"),
        ({"unit": "nm"}, "give pixel_size"),
    ]
    for arguments, lacking in cases:
        with pytest.raises(ValueError, match=lacking) as raised:
            asperity.read(path, **arguments)
        assert "--" not in str(raised.value)
    assert asperity.read(path, "nm", "1 um").pixel_size == pytest.approx((1e-6, 1e-6))
