"""Boundary elements on a scan, and models compared with them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from types import MappingProxyType
from typing import Any, Literal, TypedDict

import numpy as np
import numpy.typing as npt

from asperity import _asperity
from asperity._arguments import checked_errors, place
from asperity._asperity import Interface, Scene, Topography, in_si
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


class TruthRow(TypedDict):
    """One model at one pressure, compared with boundary elements."""

    load: float
    pressure: float
    model: str
    area_fraction: float | None
    area_deviation: float | None
    mean_gap: float | None
    mean_gap_deviation: float | None
    stiffness: float | None
    stiffness_deviation: float | None


class TruthRows(list[TruthRow]):
    """Rows of ``truth``."""

    #: The models nearest to boundary elements, in a sentence; None if none was compared.
    nearest: str | None = None
    #: The reasons of models without a row or with blanks, by model.
    refused: Mapping[str, str] = MappingProxyType({})
    #: What lies beyond the edges of the scan: "periodic", "periodic-part" or "free".
    boundary: str = "periodic"
    #: The reasons of pressures without rows with ``errors="mask"``, by place.
    failures: Mapping[int, str] = MappingProxyType({})

    def __str__(self) -> str:
        """A table of the rows, and the nearest models."""
        heads = list(TruthRow.__annotations__)
        table = [heads, *([_cell(value) for value in row.values()] for row in self)]
        widths = [max(map(len, column)) for column in zip(*table, strict=True)]
        cells = (zip(line, widths, strict=True) for line in table)
        lines = ["  ".join(f"{cell:<{width}}" for cell, width in line).rstrip() for line in cells]
        return "\n".join([*lines, *([self.nearest] if self.nearest else [])])


def _cell(value: Any) -> str:
    if value is None:
        return ""
    return value if isinstance(value, str) else f"{value:.4g}"


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
    given = {"pressure": in_si(pressure, "Pa"), "load": in_si(load, "N"), "gap": in_si(gap, "m")}
    named = [(name, value) for name, value in given.items() if value is not None]
    if len(named) != 1:
        raise TypeError(f"{len(named)} of pressure, load and gap were given: exactly one was required")
    ((name, value),) = named
    values = _asperity.floats(value, name)
    mask = checked_errors(errors) == "mask"
    if isinstance(surface, Topography | Scene):
        if pixel_size is not None:
            raise TypeError("pixel_size was given beside a Topography or a Scene, which has its own")
        scan = surface
    else:
        scan, level = _scan(surface, pixel_size), level or "none"
    numbers, kept, (rows, columns), failures, used, area = _asperity.bem(
        (scan, interface, level),
        name,
        values.ravel().tolist(),
        elastic,
        boundary,
        (maps, mask),
        list(quantities),
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


def truth(
    scene: Scene,
    *,
    pressure: npt.ArrayLike | None = None,
    load: npt.ArrayLike | None = None,
    elastic: bool = False,
    boundary: Boundary | None = None,
    models: Sequence[str] | None = None,
    refine: bool = False,
    errors: str = "raise",
) -> TruthRows:
    """Models compared with boundary elements on a scan.

    The file of the scene names a scan ([surface] file = ...). Every pressure has a row for "bem" and
    one for every model: all that the scene allows, or the named ones. Deviations are relative to
    bem; that of the mean gap is over the rms height of the scan. A quantity that a model lacks is
    None, with a warning, and so are all numbers of a model that needs more than the nominal area, or
    a pressure above 1.5 times the hardness. ``rows.refused`` has the reasons, also for models that
    the scene does not allow. ``pandas.DataFrame(rows)`` makes a table, ``rows.nearest`` names the
    nearest models, and with ``refine`` the rows "bem-half-grid" show the effect of the grid. A
    pressure without a solution raises or, with ``errors="mask"``, has no rows and a reason in
    ``rows.failures``.
    """
    if (pressure is None) == (load is None):
        raise TypeError("exactly one of pressure and load was required")
    name, value = place(None, load, pressure, "m")
    pressures = _asperity.floats(value, name).ravel()
    if name == "load":
        pressures = pressures / scene.nominal_area
    ids = None if models is None else list(models)
    mask = checked_errors(errors) == "mask"
    found, nearest, refused, failures, used = _asperity.truth(
        scene, pressures.tolist(), elastic, boundary, ids, (refine, mask)
    )
    rows = TruthRows(
        TruthRow(
            load=at * scene.nominal_area,
            pressure=at,
            model=model,
            area_fraction=state[0],
            area_deviation=deviation[0],
            mean_gap=state[1],
            mean_gap_deviation=deviation[1],
            stiffness=state[2],
            stiffness_deviation=deviation[2],
        )
        for at, model, state, deviation in found
    )
    rows.nearest, rows.refused, rows.failures = nearest, refused, failures
    rows.boundary = used
    return rows
