"""Boundary elements on scans: contacts, unloading, and models compared with them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from types import MappingProxyType
from typing import Any, Literal

import numpy as np
import numpy.typing as npt

from asperity import _asperity
from asperity._arguments import Floats, checked_errors, floats, in_si, place
from asperity._asperity import Scene, Topography
from asperity._model import Model, as_models
from asperity._records import Interface
from asperity._table import Table

Boundary = Literal["periodic", "periodic-part", "free"]


@dataclass(frozen=True)
class BemContacts:
    """Contacts of a scan, solved by boundary elements; made by ``bem``.

    Numbers have the shape of the argument; maps add rows and columns to it.
    """

    #: Load on the nominal area [N].
    load: Floats
    #: Mean pressure [Pa].
    pressure: Floats
    #: Real over nominal area, corrected for the staircase edges of pixels.
    area_fraction: Floats
    #: Share of the pixels that carry pressure.
    area_fraction_pixels: Floats
    #: Share of the pixels at the hardness.
    plastic_fraction: Floats
    #: Distance between the mean planes of the two deformed surfaces [m].
    mean_gap: Floats
    #: Mean gap of the pixels out of contact [m]; NaN where every pixel touches.
    mean_open_gap: Floats
    #: Number of contact patches: pixels connected over edges.
    patches: npt.NDArray[np.int64]
    #: Iterations.
    iterations: npt.NDArray[np.int64]
    #: Relative residual of the complementarity.
    residual: Floats
    #: Pressures of the pixels [Pa]; None without ``maps``.
    pressures: Floats | None
    #: Gaps of the pixels [m], below 0 by the plastic depth; None without ``maps``.
    gaps: Floats | None
    #: The reasons of masked contacts with ``errors="mask"``, by place in the order of memory.
    failures: Mapping[int, str]
    #: What lies beyond the edges of the scan: "periodic", "periodic-part" or "free".
    boundary: str
    #: The area of the loads [m^2]: the nominal area of the scene or, without one, that of the scan.
    nominal_area: float
    #: The requested quantities, by name with underscores: ``unloading_stiffness`` [N/m], ...
    quantities: Mapping[str, Floats] = field(default_factory=lambda: MappingProxyType({}))

    def __repr__(self) -> str:
        return f"<asperity.BemContacts of shape {self.pressure.shape}>"


def bem(
    surface: Topography | Scene | npt.ArrayLike,
    *,
    pressure: npt.ArrayLike | None = None,
    load: npt.ArrayLike | None = None,
    gap: npt.ArrayLike | None = None,
    interface: Interface | None = None,
    pixel_size: float | str | tuple[float, float] | None = None,
    level: str | None = None,
    elastic: bool = False,
    boundary: Boundary | None = None,
    quantities: Sequence[str] = (),
    viscosity: float | str | None = None,
    pressure_drop: float | str | None = None,
    maps: bool = True,
    errors: str = "raise",
) -> BemContacts:
    """Contacts of a scan with an elastic half-space, solved by boundary elements pixel by pixel.

    Parameters
    ----------
    surface : Topography, Scene or array_like
        A scan; a scene whose file names a scan ([surface] file = ...), with the levelling and
        filter of that file; or heights [m], row by row, pressed as they are.
    pressure, load, gap : array_like
        One of them: mean pressures [Pa], loads [N] on the nominal area of the scene or, without a
        scene, on the area of the scan, or mean gaps [m]. ``BemContacts.nominal_area`` is that area.
    interface : Interface
        The two bodies; for a Topography and for heights.
    pixel_size : float or (float, float)
        Distance between neighbouring heights [m] along a row, and along a column; for heights only.
    level : "plane", "quadratic", "mean" or "none"
        The form removed first: by default the plane from a Topography, the mean from a periodic one
        and nothing from heights.
    elastic : bool
        Ignores the hardness: pressures are unlimited.
    boundary : "periodic", "periodic-part" or "free"
        Beyond its edges the scan is repeated as it is, with its steps; or its periodic component is
        repeated, without steps; or there is a free half-space. By default it is that of the options
        of the scene, and a scan declared periodic is repeated as it is. So is another one if its
        edges match. If they do not, its periodic component is used; if they do and the slopes there
        do not, as of a ball or a cylinder, it is a single body, free; both with a warning.
        ``BemContacts.boundary`` names the choice.
    quantities : sequence of str
        By the names that models have: "tangent" (or "stiffness"), the slope of first loading
        against the mean gap, and quantities of joints, "unloading-stiffness",
        "tangential-stiffness", "thermal-conductance", "electrical-conductance", the last two also
        with "-per-area"; ``BemContacts.quantities`` has them. In those of joints the contact pixels
        are held, so that interaction and shapes of contacts are included; with a free boundary
        their approach is that of distant points. Also "hydraulic-gap-x" and "hydraulic-gap-y" [m],
        the even gaps that let as much fluid pass along rows and along columns, 0 where no path is
        left, and "effective-medium-gap", their estimate from the distribution of the gap alone.
    viscosity, pressure_drop : float
        Of a fluid [Pa s], and the fall of its pressure from one side of the scan to the other [Pa]:
        ``BemContacts.quantities`` has the hydraulic gaps and the flows ``flow_x`` and ``flow_y``
        [m^3/s] through the outline of the scan; both or neither.
    maps : bool
        Whether the maps of pressures and gaps are kept: 16 bytes per pixel and contact.
    errors : "raise" or "mask"
        The treatment of a contact without a solution, as at a pressure above the hardness: it
        raises; or its numbers are masked, and ``BemContacts.failures`` has the reason.

    Examples
    --------
    >>> import asperity, numpy as np
    >>> wave = np.cos(2 * np.pi * 6 * np.arange(192) / 192)
    >>> scan = asperity.Topography(1e-7 * wave * wave[:, None], dx=1e-6, unit="m", periodic=True)
    >>> steel = asperity.Interface(116e9, 0.3, hardness=7e9)
    >>> contacts = asperity.bem(scan, interface=steel, pressure=[1e7, 1e8])
    >>> contacts.pressures.shape, contacts.area_fraction.round(3), contacts.patches
    ((2, 192, 192), array([0.021, 0.126]), array([72, 72]))
    """
    name, given_values = place(pressure=pressure, load=load, gap=gap)
    values = floats(given_values, name)
    maps_and_mask = maps, checked_errors(errors) == "mask"
    scan = _pressed(surface, interface, pixel_size, level, elastic, boundary)
    given = name, values.ravel().tolist()
    if (viscosity is None) != (pressure_drop is None):
        raise TypeError("viscosity and pressure_drop: both or neither was required")
    fluid = in_si(viscosity, "Pa s"), in_si(pressure_drop, "Pa")
    leak = None if viscosity is None else fluid
    found, kept, pixels = _asperity.bem(scan, given, maps_and_mask, quantities or None, leak)
    failures = found["failures"]

    def shaped(array: npt.NDArray[Any], *pixels: int) -> Any:
        array = array.reshape((*values.shape, *pixels))
        return np.ma.masked_invalid(array) if failures else array

    arrays = [name for name, value in found.items() if isinstance(value, np.ndarray)]
    numbers = {name: shaped(found.pop(name)) for name in arrays}
    for count in ("patches", "iterations"):
        # NaN has no integer.
        counts = np.nan_to_num(np.ma.getdata(numbers[count])).astype(np.int64)
        missing = np.ma.getmask(numbers[count])
        numbers[count] = np.ma.MaskedArray(counts, missing) if failures else counts
    own = BemContacts.__dataclass_fields__
    joints = MappingProxyType({name: numbers.pop(name) for name in arrays if name not in own})
    pressures, gaps = (None, None) if kept is None else (shaped(k, *pixels) for k in kept)
    return BemContacts(**found, **numbers, pressures=pressures, gaps=gaps, quantities=joints)


def _pressed(
    surface: Any,
    interface: Interface | None,
    pixel_size: float | str | tuple[float, float] | None,
    level: str | None,
    elastic: bool,
    boundary: Boundary | None,
) -> tuple[Any, Interface | None, str | None, tuple[str | None, bool]]:
    """The scan, also of heights [m] in an array, and how it is pressed."""
    if isinstance(surface, Topography | Scene):
        if pixel_size is not None:
            raise TypeError("pixel_size was given beside a Topography or a Scene, which has its own")
        return surface, interface, level, (boundary, elastic)
    if np.ndim(surface) != 2:
        raise TypeError(
            f"surface has {np.ndim(surface)} dimensions: a Topography, a Scene or heights in two "
            "dimensions was required"
        )
    if pixel_size is None:
        raise TypeError("pixel_size is missing: heights in an array need it, in m")
    size = np.asarray(in_si(pixel_size, "m"), dtype=float)
    if size.shape not in ((), (2,)):
        raise TypeError("pixel_size must be a length or two, along a row and along a column")
    along_row, along_column = np.broadcast_to(size, 2).tolist()
    scan = Topography(surface, (along_row, along_column), "m")
    return scan, interface, level or "none", (boundary, elastic)


@dataclass(frozen=True)
class BemUnloading:
    """The opening of a scan from its greatest load; made by ``bem_unloading``."""

    #: Retreats of distant points from the greatest load [m]; unless the boundary is free, the mean
    #: gap grows by them.
    retreat: Floats
    #: Load on the nominal area [N].
    load: Floats
    #: Mean pressure [Pa].
    pressure: Floats
    #: Real over nominal area.
    area_fraction: Floats
    #: Mean gap from the mean plane of the first surface [m].
    mean_gap: Floats
    #: Mean gap of the pixels out of contact [m]; NaN where every pixel touches.
    mean_open_gap: Floats
    #: Stiffness of the contact held as it is [N/m].
    stiffness: Floats
    #: The retreat at which the last pixel parts [m].
    last_contact: float
    #: What lies beyond the edges of the scan: "periodic", "periodic-part" or "free".
    boundary: str
    #: The area of the loads [m^2]: the nominal area of the scene or, without one, that of the scan.
    nominal_area: float

    def __repr__(self) -> str:
        return f"<asperity.BemUnloading of {self.retreat.size} retreats>"


def bem_unloading(
    surface: Topography | Scene | npt.ArrayLike,
    *,
    pressure: float | str | None = None,
    load: float | str | None = None,
    gap: float | str | None = None,
    retreat: npt.ArrayLike | None = None,
    points: int = 21,
    interface: Interface | None = None,
    pixel_size: float | str | tuple[float, float] | None = None,
    level: str | None = None,
    elastic: bool = False,
    boundary: Boundary | None = None,
) -> BemUnloading:
    """The contact of a scan as it opens from its greatest load, solved by boundary elements.

    Yielding has flattened the surface; on the way back the contact shrinks elastically.

    Parameters
    ----------
    pressure, load, gap : float or str
        The greatest load, by one of them.
    retreat : array_like
        Retreats from there [m]; by default ``points`` of them to the end of contact.
    points : int
        The number of default retreats.
    surface, interface, pixel_size, level, elastic, boundary
        As in ``bem``.

    Examples
    --------
    >>> import asperity, numpy as np
    >>> wave = np.cos(2 * np.pi * 6 * np.arange(96) / 96)
    >>> scan = asperity.Topography(1e-7 * wave * wave[:, None], dx=2e-6, unit="m", periodic=True)
    >>> soft = asperity.Interface(116e9, 0.3, hardness=5e8)
    >>> path = asperity.bem_unloading(scan, interface=soft, pressure=1e8, points=3)
    >>> path.pressure[0] > path.pressure[1] > path.pressure[2]
    np.True_
    """
    name, given_value = place(pressure=pressure, load=load, gap=gap)
    value = floats(given_value, name)
    if value.size != 1:
        raise TypeError(f"{name} has {value.size} values: one greatest load was required")
    if not 2 <= points <= 100_000:
        raise ValueError(f"points is {points}: 2 to 100000 were required")
    retreats = None if retreat is None else floats(in_si(retreat, "m"), "retreat")
    scan = _pressed(surface, interface, pixel_size, level, elastic, boundary)
    given = None if retreats is None else retreats.ravel().tolist()
    found = _asperity.bem_unloading(scan, (name, value.ravel().tolist()), given, points)
    shape = (-1,) if retreats is None else retreats.shape
    arrays = {name: v.reshape(shape) for name, v in found.items() if isinstance(v, np.ndarray)}
    return BemUnloading(**found | arrays)


def truth(
    scene: Scene,
    *,
    pressure: npt.ArrayLike | None = None,
    load: npt.ArrayLike | None = None,
    elastic: bool = False,
    boundary: Boundary | None = None,
    models: str | Model | Sequence[str | Model] | None = None,
    quantities: str | Sequence[str] = "stiffness",
    refine: bool = False,
) -> Table:
    """Models compared with boundary elements on a scan.

    The file of the scene names a scan ([surface] file = ...). Every pressure has a row for "bem" and
    one for every model: all that the scene allows, or the given ones, also of your own. Area and mean
    gap are compared, and ``quantities``: "stiffness", that of first loading, and
    "unloading-stiffness", as which conductances deviate. Deviations are relative to bem; that of the
    mean gap is over the rms height of the scan. A quantity that a model lacks is NaN, and so are all
    numbers of a model that needs more than the nominal area, or a pressure above 1.5 times the
    hardness; a finding has the reason. The results name the nearest models and say whether the table
    behind ``recommend`` agrees. With ``refine`` the rows "bem-half-grid" show the effect of the grid.
    A pressure without a solution has no rows and a warning.
    """
    name, value = place(load=load, pressure=pressure)
    pressures = floats(value, name).ravel()
    if name == "load":
        pressures = pressures / scene.nominal_area
    engines = None if models is None else as_models(models)
    how = boundary, elastic
    return Table(*_asperity.truth(scene, pressures.tolist(), how, engines, quantities, refine))
