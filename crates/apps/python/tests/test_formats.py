"""Files that other packages write are read as they were written, and other formats through them.

The writers are installed with the extra ``test`` where they support this version of Python, and
SurfaceTopography and surfalize with ``surfaces``.
"""

from __future__ import annotations

import gzip
import re
import sys
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

import asperity

Floats = npt.NDArray[np.float64]

# In steps of a nanometre: what whole numbers of 16 bits hold exactly.
maps = arrays(
    np.int64,
    st.tuples(st.integers(2, 9), st.integers(2, 9)),
    elements=st.integers(-20_000, 20_000),
)
many = settings(
    max_examples=40,
    deadline=None,
    suppress_health_check=[HealthCheck.function_scoped_fixture],
)
# Neither symmetric nor square.
MAP: Floats = 1e-9 * np.array([[1, 2, 3, 4, 5], [11, 12, 13, 14, 15], [21, 22, 23, 24, 25.0]])


def optional(name: str) -> Any:
    return pytest.importorskip(name, reason=f"{name} writes the files of these tests")


def check(path: Path, heights: Floats, dx: float, dy: float, rtol: float = 1e-6) -> None:
    """The file, plain and packed, has these heights and pixels."""
    packed = path.with_name(path.name + ".gz")
    packed.write_bytes(gzip.compress(path.read_bytes()))
    for file in (path, packed):
        found = asperity.read(file, max_missing=1.0, missing=np.nan)
        scale = np.nanmax(np.abs(heights))
        np.testing.assert_allclose(found.heights, heights, rtol=0, atol=rtol * scale)
        np.testing.assert_allclose(found.pixel_size, (dx, dy), rtol=1e-6)


def with_holes(steps: npt.NDArray[np.int64]) -> Floats:
    heights: Floats = 1e-9 * steps.astype(np.float64)
    heights.flat[len(steps)] = np.nan
    heights.flat[0] = 3e-9
    return heights


@given(maps)
@many
def test_gwyddion_files_of_gwyfile(tmp_path: Path, steps: npt.NDArray[np.int64]) -> None:
    objects = optional("gwyfile.objects")
    heights: Floats = 1e-9 * steps.astype(np.float64)
    heights[0, 0] = 3e-9
    rows, columns = heights.shape
    size = {"xreal": 5e-6 * columns, "yreal": 2e-6 * rows, "si_unit_xy": "m"}
    container = objects.GwyContainer()
    container["/0/data/title"] = "Height"
    container["/0/data"] = objects.GwyDataField(heights, si_unit_z="m", **size)
    container["/1/data/title"] = "Phase"
    container["/1/data"] = objects.GwyDataField(heights, si_unit_z="deg", **size)
    container["/7/data/title"] = "Back"
    container["/7/data"] = objects.GwyDataField(2 * heights, si_unit_z="m", **size)
    path = tmp_path / "a.gwy"
    container.tofile(str(path))
    check(path, heights, 5e-6, 2e-6, 1e-15)
    assert "'Back'" in asperity.read(path, missing=np.nan).notes[0].replace('"', "'")
    back = asperity.read(path, channel="back", missing=np.nan)
    np.testing.assert_array_equal(back.heights, 2 * heights)
    with pytest.raises(ValueError, match="channel is .*Phase"):
        asperity.read(path, channel="Phase")


@given(maps, st.sampled_from(["ISO-1.0", "ISO-2.0", "BCR-1.0"]), st.booleans(), st.booleans())
@many
def test_sdf_files_of_sdfio(
    tmp_path: Path, steps: npt.NDArray[np.int64], revision: str, binary: bool, whole: bool
) -> None:
    sdfio = optional("sdfio")
    heights = with_holes(steps)
    path = tmp_path / "a.sdf"
    kind = sdfio.DataType.INT16 if whole else sdfio.DataType.BINARY64
    sdfio.write(
        path,
        heights,
        x_scale=5e-6,
        y_scale=2e-6,
        z_scale=1e-9,
        format=sdfio.FileFormat.BINARY if binary else sdfio.FileFormat.ASCII,
        metadata=sdfio.Metadata(revision=sdfio.Revision(revision), data_type=kind),
    )
    # BCR fixed no direction of y: sdfio takes the last row of the file for the first.
    check(path, heights[::-1] if revision == "BCR-1.0" else heights, 5e-6, 2e-6)


@given(maps, st.sampled_from(["FLOAT64", "FLOAT32", "INT32"]), st.booleans())
@many
def test_x3p_files_of_x3pio(
    tmp_path: Path, steps: npt.NDArray[np.int64], kind: str, binary: bool
) -> None:
    x3pio = optional("x3pio")
    heights = with_holes(steps)
    path = tmp_path / "a.x3p"
    storage = x3pio.DataStorage.BINARY if binary else x3pio.DataStorage.XML
    made = x3pio.Surface.from_array(
        heights, x_scale=5e-6, y_scale=2e-6, z_type=getattr(x3pio.DataType, kind)
    )
    made.save(path, storage=storage)
    check(path, heights, 5e-6, 2e-6)
    x3pio.Profile.from_array(heights[1], x_scale=5e-6).save(path, storage=storage)
    check(path, heights[1:2], 5e-6, 5e-6)


@given(maps, st.booleans(), st.booleans())
@many
def test_sur_files_of_rosettasciio(
    tmp_path: Path, steps: npt.NDArray[np.int64], compressed: bool, several: bool
) -> None:
    writer = optional("rsciio.digitalsurf").file_writer
    steps.flat[:2] = -20_000, 20_000
    data = 1e-3 * np.stack([steps, steps[::-1]])
    path = tmp_path / "a.sur"

    def axis(name: str, size: int, scale: float, navigate: bool) -> dict[str, Any]:
        of = {"name": name, "units": "um", "size": size, "scale": scale, "offset": 0.0}
        return {**of, "navigate": navigate}

    _, rows, columns = data.shape
    axes = [axis("T", 2, 1.0, True)] if several else []
    axes += [axis("Y", rows, 2.0, False), axis("X", columns, 5.0, False)]
    signal = {
        "data": data if several else data[0],
        "axes": axes,
        "metadata": {"General": {}, "Signal": {"quantity": "Height (um)"}},
        "original_metadata": {},
    }
    writer(str(path), signal, compressed=compressed)
    # The datum of the heights is not part of the format as programs read it.
    for number in (1, 2) if several else (1,):
        found = asperity.read(path, channel=str(number), missing=np.nan)
        expected = 1e-6 * data[number - 1]
        difference = found.heights - expected
        np.testing.assert_allclose(difference, difference.mean(), rtol=0, atol=1e-11)
        np.testing.assert_allclose(found.pixel_size, (5e-6, 2e-6), rtol=1e-6)


def test_files_of_surfalize(tmp_path: Path) -> None:
    surface = optional("surfalize").Surface(1e6 * MAP, 5.0, 5.0)
    for name in ("a.sur", "a.sdf"):
        surface.save(str(tmp_path / name))
        found = asperity.read(tmp_path / name)
        difference = found.heights - MAP
        np.testing.assert_allclose(difference, difference.mean(), rtol=0, atol=1e-13)
        np.testing.assert_allclose(found.pixel_size, (5e-6, 5e-6), rtol=1e-6)


def test_files_of_surface_topography(tmp_path: Path) -> None:
    other = optional("SurfaceTopography")
    surface = other.Topography(1e9 * MAP.T, (25e3, 6e3), unit="nm")
    surface.to_gwy(str(tmp_path / "a.gwy"))
    check(tmp_path / "a.gwy", MAP, 5e-6, 2e-6, 1e-12)


def netcdf(path: Path) -> Any:
    """A NetCDF file."""
    other = optional("SurfaceTopography")
    other.Topography(1e9 * MAP.T, (25e3, 6e3), unit="nm").to_netcdf(str(path))
    return other


def test_other_formats_are_read_through_surface_topography(tmp_path: Path) -> None:
    path = tmp_path / "a.nc"
    netcdf(path)
    with pytest.raises(asperity.UnsupportedFormat, match="NetCDF|HDF5"):
        asperity.Topography.read(path)
    for file in (path, str(path)):
        found = asperity.read(file)
        np.testing.assert_allclose(found.heights, MAP, rtol=1e-12)
        np.testing.assert_allclose(found.pixel_size, (5e-6, 2e-6))
    np.testing.assert_allclose(asperity.read(path, channel="1").heights, MAP, rtol=1e-12)
    with pytest.raises(ValueError, match="channel is 'Phase': 1 'Default'"):
        asperity.read(path, channel="Phase")
    broken = tmp_path / "a.spm"
    broken.write_bytes(b"\\*File list\r\n\x00\x01")
    with pytest.raises(asperity.UnsupportedFormat, match="Nanoscope.*cannot read this one: "):
        asperity.read(broken)


def test_the_line_of_the_message_converts(tmp_path: Path) -> None:
    path = tmp_path / "a.nc"
    netcdf(path)
    with pytest.raises(asperity.UnsupportedFormat) as error:
        asperity.Topography.read(path)
    line = re.search(r'python3 -c "(.*)"', str(error.value))
    assert line is not None
    exec(line[1].replace("FILE", str(path)))
    check(tmp_path / "a.nc.gwy", MAP, 5e-6, 2e-6, 1e-12)


def test_without_surface_topography_its_installation_is_advised(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, "SurfaceTopography", None)
    path = tmp_path / "a.vk4"
    path.write_bytes(b"VK4_\x00\x01")
    with pytest.raises(asperity.UnsupportedFormat, match=r"Keyence VK.*asperity\[formats\]"):
        asperity.read(path)
    # Formats with a reader need no other package.
    np.savetxt(tmp_path / "a.txt", MAP, header="Width: 25 um\nHeight: 6 um\nValue units: m")
    found = asperity.read(tmp_path / "a.txt")
    np.testing.assert_array_equal(found.heights, MAP)


def test_line_scans_at_unequal_distances_are_interpolated() -> None:
    other = optional("SurfaceTopography")
    places = np.array([0.0, 1.0, 3.0, 4.0, 8.0])
    mine = asperity.read(other.NonuniformLineScan(places, 2 * places, unit="um"))
    assert mine.shape == (1, 5) and mine.pixel_size[0] == pytest.approx(2e-6)
    np.testing.assert_allclose(mine.heights[0], 4e-6 * np.arange(5))
    assert "interpolated linearly at 4" in mine.notes[0]
    with pytest.raises(ValueError, match="unit is missing"):
        asperity.read(other.NonuniformLineScan(places, places))
