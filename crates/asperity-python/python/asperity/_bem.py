"""Boundary elements on a scan: pixel by pixel, and the models beside them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from types import MappingProxyType
from typing import Any, Literal, TypedDict

import numpy as np
import numpy.typing as npt

from asperity import _asperity
from asperity._arguments import checked_errors
from asperity._asperity import Interface, Scene, Topography
from asperity._scene import Floats

Boundary = Literal["periodic", "free"]


@dataclass(frozen=True)
class BemContacts:
    """Contacts of a scan, solved by boundary elements; made by ``bem``.

    Numbers have the shape of what was given; maps have rows and columns behind it.
    """

    #: Load on the nominal area of the scene, or on the scan [N].
    load: Floats
    #: Mean pressure [Pa].
    pressure: Floats
    #: Real over nominal area, corrected for the staircase edges of pixels.
    area_fraction: Floats
    #: Share of the pixels that carry pressure.
    area_fraction_pixels: Floats
    #: Share of the pixels that carry the hardness.
    plastic_fraction: Floats
    #: Distance of the mean planes of the two deformed surfaces [m].
    mean_gap: Floats
    #: Number of contact patches; pixels touch over edges.
    patches: npt.NDArray[np.int64]
    #: Iterations.
    iterations: npt.NDArray[np.int64]
    #: What is left of the complementarity, relative.
    residual: Floats
    #: Pressures of the pixels [Pa]; None where they were not kept.
    pressures: Floats | None
    #: Gaps of the pixels [m], below 0 by the plastic depth; None where they were not kept.
    gaps: Floats | None
    #: Why contacts have no numbers, where ``errors="mask"``: by their place in the order of memory.
    failures: Mapping[int, str]

    def __repr__(self) -> str:
        return f"<asperity.BemContacts of shape {self.pressure.shape}>"


class TruthRow(TypedDict):
    """One model at one pressure, beside boundary elements."""

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

    #: Which models were nearest to boundary elements, in a sentence; None where none was asked.
    nearest: str | None = None
    #: What a model lacks that has no row, or blanks in it, by model.
    refused: Mapping[str, str] = MappingProxyType({})
    #: Why pressures have no rows, where ``errors="mask"``: by their place.
    failures: Mapping[int, str] = MappingProxyType({})


def bem(
    surface: Topography | Scene,
    *,
    pressure: npt.ArrayLike | None = None,
    load: npt.ArrayLike | None = None,
    gap: npt.ArrayLike | None = None,
    interface: Interface | None = None,
    level: str | None = None,
    elastic: bool = False,
    boundary: Boundary = "periodic",
    maps: bool = True,
    errors: str = "raise",
) -> BemContacts:
    """Presses a scan on an elastic half-space, pixel by pixel.

    Parameters
    ----------
    surface : Topography or Scene
        A scan; or a scene, read from a file that names one ([surface] file = ...), levelled and
        filtered as it says.
    pressure, load, gap : array_like
        One of them: mean pressures [Pa], loads [N] on the nominal area of the scene or on the
        scan, or mean gaps [m].
    interface : Interface
        The two bodies; for a Topography, which has none.
    level : "plane", "quadratic", "mean" or "none"
        What is taken from a Topography before; unless given the plane, of a periodic one the mean.
    elastic : bool
        No hardness: pressures may grow without end.
    boundary : "periodic" or "free"
        What lies beyond the edges: the scan again, whose seam is taken out (with a warning) where
        edges do not meet; or nothing.
    maps : bool
        Whether the maps of pressures and gaps are kept, 16 bytes a pixel and contact.
    errors : "raise" or "mask"
        What happens when a contact cannot be, as at a pressure above the hardness: the first is
        raised, and the others with it; or they are solved, its own numbers are masked, and
        ``BemContacts.failures`` has the reasons.

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
    given = {"pressure": pressure, "load": load, "gap": gap}
    named = [(name, value) for name, value in given.items() if value is not None]
    if len(named) != 1:
        raise TypeError(f"{len(named)} of pressure, load and gap were given: one was required")
    ((name, value),) = named
    values = _asperity.floats(value, name)
    mask = checked_errors(errors) == "mask"
    numbers, kept, (rows, columns), failures = _asperity.bem(
        (surface, interface, level), name, values.ravel().tolist(), elastic, boundary, (maps, mask)
    )

    def shaped(array: npt.NDArray[Any], *pixels: int) -> Any:
        array = array.reshape((*values.shape, *pixels))
        return np.ma.masked_invalid(array) if failures else array

    contacts: dict[str, Any] = {name: shaped(array) for name, array in numbers.items()}
    for count in ("patches", "iterations"):
        # What is masked is no number, and no whole one.
        counts = np.nan_to_num(numbers[count].reshape(values.shape)).astype(np.int64)
        missing = np.ma.getmask(contacts[count])
        contacts[count] = np.ma.MaskedArray(counts, missing) if failures else counts
    pressures, gaps = (None, None) if kept is None else (shaped(k, rows, columns) for k in kept)
    return BemContacts(**contacts, pressures=pressures, gaps=gaps, failures=failures)


def truth(
    scene: Scene,
    *,
    pressure: npt.ArrayLike | None = None,
    load: npt.ArrayLike | None = None,
    elastic: bool = False,
    boundary: Boundary = "periodic",
    models: Sequence[str] | None = None,
    refine: bool = False,
    errors: str = "raise",
) -> TruthRows:
    """Which model holds on this scan: each beside boundary elements on it.

    The scene is read from a file that names a scan ([surface] file = ...). For every pressure
    there is a row of "bem" and one of every model: all that the scene allows, or those that are
    named. Deviations are relative to bem; of the mean gap, over the rms height of the scan. What a
    model cannot give is None, with a warning, and so are all numbers of one that would need more
    area than there is, or more pressure on it than 1.5 times the hardness. ``rows.refused`` says
    why, also of models that the scene does not allow. ``pandas.DataFrame(rows)`` makes a table of
    it, ``print(rows.nearest)`` says which models were nearest, and with ``refine`` the rows
    "bem-half-grid" say how far the answer depends on the grid. A pressure that cannot be solved is
    raised, or, with ``errors="mask"``, has no rows but a reason in ``rows.failures``.
    """
    if (pressure is None) == (load is None):
        raise TypeError("pressure or load was required, and not both")
    name, value = ("load", load) if pressure is None else ("pressure", pressure)
    assert value is not None
    pressures = _asperity.floats(value, name).ravel()
    if name == "load":
        pressures = pressures / scene.nominal_area
    ids = None if models is None else list(models)
    mask = checked_errors(errors) == "mask"
    found, told, refused, failures = _asperity.truth(
        scene, pressures.tolist(), elastic, boundary, ids, (refine, mask)
    )
    rows = TruthRows(
        TruthRow(
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
    rows.nearest, rows.refused, rows.failures = told, refused, failures
    return rows
