"""Measured surfaces from the objects of other packages."""

from __future__ import annotations

from os import PathLike
from typing import Any

from asperity import _asperity
from asperity._scene import Surface


class Topography(_asperity.Topography):
    """A measured surface: heights on a regular grid.

    Parameters
    ----------
    heights : array_like
        One or two dimensions, row by row; NaN, or masked, where a point is missing.
    dx : float or (float, float)
        Distance of neighbouring points along a row, and along a column.
    unit : str
        Unit of both, heights and dx: "m", "cm", "mm", "um", "nm", "angstrom", "pm".
    periodic : bool
        Whether the surface goes on beyond its edges.
    """

    def surface(
        self, level: str | None = None, estimator: str = "moments", cutoff: float | None = None
    ) -> Surface:
        """The equivalent rough surface of this one on a flat; see ``statistics``."""
        return Surface(**self._surface(level, estimator, cutoff))

    def against(self, other: Topography) -> Surface:
        """The equivalent rough surface of this one and another pressed together, both as they are:
        their moments add."""
        return Surface(**self._against(other))

    def level(self, form: str | None = None) -> Topography:
        """The same surface without its "mean", "plane" or "quadratic" form, by least squares; unless
        it is given the plane, of a periodic surface the mean."""
        return self._of(self._levelled(form))

    def fill(self) -> Topography:
        """The same surface with heights where points are missing: harmonic ones, each the mean of its
        four neighbours; at an edge the surface goes on as its least-squares plane does, or beyond the
        edge where it is periodic. At most 5 % of the points are filled."""
        return self._of(self._filled())

    def filter(self, cutoff: float) -> Topography:
        """The roughness below a wavelength [m] (Gaussian filter, ISO 16610)."""
        return self._of(self._filtered(cutoff))

    def smooth(self, cutoff: float) -> Topography:
        """The same surface without waves shorter than this [m], noise above all."""
        return self._of(self._smoothed(cutoff))

    def summit_density(self) -> tuple[tuple[float, ...], tuple[float, ...]]:
        """How the heights of the summits are spread: heights [m] from their mean, and the density
        there [1/m], as ``Scene`` takes them for its ``heights``."""
        heights, densities = self._summit_density()
        return tuple(heights), tuple(densities)

    @classmethod
    def _of(cls, changed: _asperity.Topography) -> Topography:
        return cls(changed.heights, changed.pixel_size, "m", changed.periodic)


def read(
    path: str | PathLike[str],
    unit: str | None = None,
    pixel_size: float | tuple[float, float] | None = None,
    max_missing: float = 0.1,
    fill_missing: bool = False,
) -> Topography:
    """A scan from a file: ASCII matrix, XYZ points, CSV profile, NumPy .npy or .npz, X3P or SUR.

    What the file does not say of its unit and pixels must be said here, nothing is guessed;
    ``pixel_size`` is in that unit. A scan of which more than ``max_missing`` is missing is refused;
    with ``fill_missing`` missing points, up to 5 % of all, get the heights of ``Topography.fill``.
    """
    found: Topography = Topography.read(path, unit, pixel_size, max_missing)
    return found.fill() if fill_missing else found


def topography(surface: Any, unit: str | None = None) -> Topography:
    """A measured surface from an object of SurfaceTopography or surfalize.

    The objects know their pixel size and, mostly, their unit; where one does not, ``unit`` says it.
    Neither package is needed for anything else, and neither is imported here.
    """
    home = type(surface).__module__.partition(".")[0]
    if home == "SurfaceTopography":
        return _from_surface_topography(surface, unit)
    if home == "surfalize":
        return _from_surfalize(surface, unit)
    raise TypeError(
        f"{type(surface).__name__} is no surface that is known: one of SurfaceTopography or "
        "surfalize was required; heights in an array go to asperity.Topography(heights, dx, unit)"
    )


def _one_unit(own: str | None, given: str | None, what: str) -> str:
    if own is None and given is None:
        raise ValueError(f"unit is missing: {what} has none")
    if own is not None and given is not None and own != given:
        raise ValueError(f"unit is {given!r}: {what} is in {own!r} already")
    return str(own if own is not None else given)


def _from_surface_topography(surface: Any, unit: str | None) -> Topography:
    if not surface.is_uniform:
        raise ValueError(
            f"{type(surface).__name__} has points at unequal distances: a uniform surface was "
            "required, as of surface.to_uniform()"
        )
    # Its first axis is x.
    heights = surface.heights().T
    dx, dy = (*surface.pixel_size, surface.pixel_size[0])[:2]
    found = _one_unit(surface.unit, unit, "this surface of SurfaceTopography")
    return Topography(heights, (dx, dy), found, periodic=bool(surface.is_periodic))


def _from_surfalize(surface: Any, unit: str | None) -> Topography:
    # Micrometres throughout; rows are y, missing points are NaN.
    found = _one_unit("um", unit, "this surface of surfalize")
    if hasattr(surface, "step_x"):
        return Topography(surface.data, (surface.step_x, surface.step_y), found)
    return Topography(surface.data, surface.step, found)
