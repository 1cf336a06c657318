"""Measured surfaces from the objects of other packages."""

from __future__ import annotations

from typing import Any

from asperity._asperity import Topography


def topography(surface: Any, unit: str | None = None) -> Topography:
    """A measured surface from an object of SurfaceTopography or surfalize.

    The objects know their pixel size and, mostly, their unit; where one does not, ``unit`` says it.
    Neither package is needed for anything else.
    """
    home = type(surface).__module__.partition(".")[0]
    if home == "SurfaceTopography":
        return _from_surface_topography(surface, unit)
    if home == "surfalize":
        return _from_surfalize(surface)
    raise TypeError(
        f"{type(surface).__name__} is no surface that is known: one of SurfaceTopography or "
        "surfalize was required; heights in an array go to asperity.Topography(heights, dx, unit)"
    )


def _from_surface_topography(surface: Any, unit: str | None) -> Topography:
    raise NotImplementedError


def _from_surfalize(surface: Any) -> Topography:
    raise NotImplementedError
