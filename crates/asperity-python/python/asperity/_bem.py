"""Contacts of a scan by boundary elements."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from types import MappingProxyType
from typing import Any, Literal

import numpy as np
import numpy.typing as npt

from asperity import _asperity
from asperity._arguments import checked_errors
from asperity._asperity import Scene, Topography, in_si
from asperity._records import Interface
from asperity._scene import Floats

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
        repeated, without steps; or there is a free half-space. By default a scan declared periodic
        is repeated as it is. So is another one if its edges match; if not, its periodic component
        is used, with a warning. ``BemContacts.boundary`` names the choice.
    quantities : sequence of str
        By the names that models have: "tangent" (or "stiffness"), the slope of first loading
        against the mean gap, and quantities of joints, "unloading-stiffness",
        "tangential-stiffness", "thermal-conductance", "electrical-conductance", the last two also
        with "-per-area"; ``BemContacts.quantities`` has them. In those of joints the contact pixels
        are held, so that interaction and shapes of contacts are included; with a free boundary
        their approach is that of distant points.
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
    name, values = load_given(pressure, load, gap)
    mask = checked_errors(errors) == "mask"
    scan, level = pressed(surface, pixel_size, level)
    numbers, kept, (rows, columns), failures, used, area = _asperity.bem(
        (scan, interface, level),
        name,
        values.ravel().tolist(),
        elastic,
        boundary,
        (maps, mask),
        quantities or None,
    )

    def shaped(array: npt.NDArray[Any], *pixels: int) -> Any:
        array = array.reshape((*values.shape, *pixels))
        return np.ma.masked_invalid(array) if failures else array

    contacts: dict[str, Any] = {name: shaped(array) for name, array in numbers.items()}
    fields = BemContacts.__dataclass_fields__
    joints = {name: contacts.pop(name) for name in numbers if name not in fields}
    for count in ("patches", "iterations"):
        # NaN has no integer.
        counts = np.nan_to_num(numbers[count].reshape(values.shape)).astype(np.int64)
        missing = np.ma.getmask(contacts[count])
        contacts[count] = np.ma.MaskedArray(counts, missing) if failures else counts
    pressures, gaps = (None, None) if kept is None else (shaped(k, rows, columns) for k in kept)
    return BemContacts(
        **contacts,
        pressures=pressures,
        gaps=gaps,
        failures=failures,
        boundary=used,
        nominal_area=area,
        quantities=MappingProxyType(joints),
    )


def load_given(
    pressure: npt.ArrayLike | None, load: npt.ArrayLike | None, gap: npt.ArrayLike | None
) -> tuple[str, Floats]:
    """The one of them that was given."""
    given = {"pressure": in_si(pressure, "Pa"), "load": in_si(load, "N"), "gap": in_si(gap, "m")}
    named = [(name, value) for name, value in given.items() if value is not None]
    if len(named) != 1:
        raise TypeError(f"{len(named)} of pressure, load and gap were given: exactly one was required")
    ((name, value),) = named
    return name, _asperity.floats(value, name)


def pressed(
    surface: Topography | Scene | npt.ArrayLike,
    pixel_size: float | str | tuple[float, float] | None,
    level: str | None,
) -> tuple[Topography | Scene, str | None]:
    """The scan, and the form to remove."""
    if isinstance(surface, Topography | Scene):
        if pixel_size is not None:
            raise TypeError("pixel_size was given beside a Topography or a Scene, which has its own")
        return surface, level
    return _scan(surface, pixel_size), level or "none"


def _scan(heights: npt.ArrayLike, pixel_size: float | str | tuple[float, float] | None) -> Topography:
    """Heights [m] as a scan."""
    if np.ndim(heights) != 2:
        raise TypeError(
            f"surface has {np.ndim(heights)} dimensions: a Topography, a Scene or heights in two "
            "dimensions was required"
        )
    if pixel_size is None:
        raise TypeError("pixel_size is missing: heights in an array need it, in m")
    size = np.asarray(in_si(pixel_size, "m"), dtype=float)
    if size.shape not in ((), (2,)):
        raise TypeError("pixel_size must be a length or two, along a row and along a column")
    along_row, along_column = np.broadcast_to(size, 2).tolist()
    return Topography(heights, (along_row, along_column), "m")
