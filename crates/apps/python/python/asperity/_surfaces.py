"""Measured surfaces from files and from objects of other packages."""

from __future__ import annotations

from os import PathLike, fspath
from typing import Any

import numpy as np

from asperity._asperity import Topography, UnsupportedFormat


def read(
    surface: Any,
    unit: str | None = None,
    pixel_size: float | str | tuple[float | str, float | str] | None = None,
    max_missing: float = 0.1,
    channel: str | None = None,
    **text: Any,
) -> Topography:
    """A scan from a file, or a surface of SurfaceTopography or surfalize as a scan.

    Files are text (matrix, XYZ points, profile), NumPy .npy, X3P, Digital Surf SUR, Gwyddion .gwy or
    SDF, each also inside gzip. One in another format is read by SurfaceTopography, if that is
    installed (the extra ``formats``), and otherwise raises ``UnsupportedFormat``.

    ``unit`` and ``pixel_size``, in that unit or as "10 nm", are required where the source has none. A
    larger share of missing points than ``max_missing`` is an error; ``Topography.fill`` fills them.
    ``channel`` is the name or number of a surface in a file of several. What a ``text`` does not state
    is given by ``units=["mm", "um"]`` (of lengths and heights, or of x, y and heights),
    ``columns="x,y,z"`` (or "-,z,-", the number of the column of heights, "matrix", "axes"),
    ``skip_lines``, ``missing`` (the number of missing points), ``factor`` of the heights and
    ``delimiter``. A line scan with points at
    unequal distances is interpolated linearly.
    """
    if isinstance(surface, str | PathLike):
        path = fspath(surface)
        try:
            options = {"unit": unit, "pixel_size": pixel_size, "max_missing": max_missing}
            return Topography.read(path, channel=channel, **options, **text)
        except UnsupportedFormat as error:
            return _by_surface_topography(path, unit, channel, error)
    home = type(surface).__module__.partition(".")[0]
    if home == "SurfaceTopography":
        return _from_surface_topography(surface, unit)
    if home == "surfalize":
        return _from_surfalize(surface, unit)
    raise TypeError(
        f"{type(surface).__name__} is no path, nor a surface of SurfaceTopography or surfalize: for "
        "heights in an array use asperity.Topography(heights, dx, unit)"
    )


def _by_surface_topography(
    path: str, unit: str | None, channel: str | None, unsupported: UnsupportedFormat
) -> Topography:
    try:
        import SurfaceTopography as other
    except ImportError:
        message = f"{unsupported}; or install the extra asperity[formats] and call this again"
        raise UnsupportedFormat(message) from None

    def refused(error: Exception) -> UnsupportedFormat:
        reason = str(error).partition("\n")[0] or type(error).__name__
        return UnsupportedFormat(f"{unsupported}; SurfaceTopography cannot read this one: {reason}")

    # The exceptions of its readers have no common base.
    try:
        reader = other.open_topography(path)
        names = [str(found.name) for found in reader.channels]
    except Exception as error:
        raise refused(error) from error
    with reader:
        index = _channel(path, names, channel)
        try:
            surface = reader.topography(channel_index=index)
        except Exception as error:
            raise refused(error) from error
        return _from_surface_topography(surface, unit)


def _channel(path: str, names: list[str], channel: str | None) -> int | None:
    """The index of a channel by its name or by its number from 1; without one, the reader's own."""
    if channel is None:
        return None
    lower = [name.lower() for name in names]
    if channel.lower() in lower:
        return lower.index(channel.lower())
    if channel.isdecimal() and 1 <= int(channel) <= len(names):
        return int(channel) - 1
    known = ", ".join(f"{i} {name!r}" for i, name in enumerate(names, 1))
    raise ValueError(f"{path}: channel is {channel!r}: {known} was required")


def _one_unit(own: str | None, given: str | None, owner: str) -> str:
    if own is None and given is None:
        raise ValueError(f"unit is missing: {owner} has no unit")
    if own is not None and given is not None and own != given:
        raise ValueError(f"unit is {given!r}: {owner} is in {own!r}")
    return str(own if own is not None else given)


def _from_surface_topography(surface: Any, unit: str | None) -> Topography:
    found = _one_unit(surface.unit, unit, "this surface of SurfaceTopography")
    if not surface.is_uniform:
        positions, heights = surface.positions_and_heights()
        return Topography.from_profile(positions, np.ma.filled(heights, np.nan), found)
    # The first axis is x.
    heights = surface.heights().T
    dx, dy = (*surface.pixel_size, surface.pixel_size[0])[:2]
    return Topography(heights, (dx, dy), found, periodic=bool(surface.is_periodic))


def _from_surfalize(surface: Any, unit: str | None) -> Topography:
    # Surfalize uses micrometres; rows are y, missing points are NaN.
    found = _one_unit("um", unit, "this surface of surfalize")
    if hasattr(surface, "step_x"):
        return Topography(surface.data, (surface.step_x, surface.step_y), found)
    return Topography(surface.data, surface.step, found)
