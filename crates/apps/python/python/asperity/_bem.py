"""Boundary elements on scans: contacts and leaks."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal

import numpy.typing as npt

from asperity import _asperity
from asperity._arguments import Floats, floats, place
from asperity._asperity import Scene, Topography
from asperity._records import Interface
from asperity._table import Table

Boundary = Literal["periodic", "periodic-part", "free"]


class BemContacts(Table):
    """Contacts of a scan, solved by boundary elements; made by ``bem``.

    A row for each load, blank with a warning without a solution: ``load_N`` on the nominal area,
    ``pressure_Pa``, ``area_fraction`` corrected for the staircase edges of pixels,
    ``area_fraction_pixels``, ``plastic_fraction`` of pixels at the hardness, ``mean_gap_m`` between
    the mean planes of the two deformed surfaces, ``mean_open_gap_m`` of the pixels out of contact,
    ``patches`` of pixels connected over edges, ``iterations``, ``residual`` of the complementarity,
    the quantities asked for, and the ``boundary``.
    """

    #: Pressures of the pixels [Pa], a map for each row; None without ``maps``.
    pressures: Floats | None
    #: Gaps of the pixels [m], below 0 by the plastic depth; None without ``maps``.
    gaps: Floats | None
    #: The scene that was solved with its own options; None of others.
    scene: Scene | None


def bem(
    surface: Topography | Scene,
    *,
    pressure: npt.ArrayLike | None = None,
    load: npt.ArrayLike | None = None,
    interface: Interface | None = None,
    level: str | None = None,
    elastic: bool = False,
    boundary: Boundary | None = None,
    quantities: Sequence[str] = (),
    maps: bool = True,
) -> BemContacts:
    """Contacts of a scan with an elastic half-space, solved by boundary elements pixel by pixel.

    Parameters
    ----------
    surface : Topography or Scene
        A scan; or a scene whose file names a scan ([surface] file = ...), with the levelling and
        filter of that file.
    pressure, load : array_like
        One of them: mean pressures [Pa], or loads [N] on the nominal area of the scene or, without a
        scene, on the area of the scan.
    interface : Interface
        The two bodies; for a Topography.
    level : "plane", "quadratic", "mean" or "none"
        The form removed first from a Topography: by default the plane, of a periodic one the mean.
    elastic : bool
        Ignores the hardness: pressures are unlimited.
    boundary : "periodic", "periodic-part" or "free"
        Beyond its edges the scan is repeated as it is, with its steps; or its periodic component is
        repeated, without steps; or there is a free half-space. By default it is that of the options
        of the scene, and a scan declared periodic is repeated as it is. So is another one if its
        edges match. If they do not, its periodic component is used; if they do and the slopes there
        do not, as of a ball or a cylinder, it is a single body, free; both with a warning.
        The column ``boundary`` names the choice.
    quantities : sequence of str
        By the names that models have: "tangent" (or "stiffness"), the slope of first loading
        against the mean gap, and quantities of joints, "unloading-stiffness",
        "tangential-stiffness", "thermal-conductance", "electrical-conductance", the last two also
        with "-per-area". In those of joints the contact pixels
        are held, so that interaction and shapes of contacts are included; with a free boundary
        their approach is that of distant points. Also "hydraulic-gap-x" and "hydraulic-gap-y" [m],
        the even gaps that let as much fluid pass along rows and along columns, 0 where no path is
        left, and "effective-medium-gap", their estimate from the distribution of the gap alone.
        "leak", for a scene with [seal]: the flow of a liquid or gas through it along both, as
        ``leak_x_kg_per_s`` and in other units, 0 with a result where no path is left, and
        ``tightest_gap_x_m``, the tightest gap on the widest path.
    maps : bool
        Whether the maps of pressures and gaps are kept: 16 bytes per pixel and contact.

    Examples
    --------
    >>> import asperity, numpy as np
    >>> wave = np.cos(2 * np.pi * 6 * np.arange(192) / 192)
    >>> scan = asperity.Topography(1e-7 * wave * wave[:, None], dx=1e-6, unit="m", periodic=True)
    >>> steel = asperity.Interface(116e9, 0.3, hardness=7e9)
    >>> contacts = asperity.bem(scan, interface=steel, pressure=[1e7, 1e8])
    >>> contacts.pressures.shape, contacts["area_fraction"].round(3), contacts["patches"]
    ((2, 192, 192), array([0.021, 0.126]), array([72., 72.]))
    """
    name, given = place(pressure=pressure, load=load)
    values = floats(given, name).ravel().tolist()
    scan = surface, interface, level, (boundary, elastic)
    found, kept, pixels = _asperity.bem(scan, (name, values), maps, quantities or None)
    contacts = BemContacts(*found)
    pressures, gaps = (None, None) if kept is None else (map.reshape(-1, *pixels) for map in kept)
    is_own = isinstance(surface, Scene) and boundary is None and not elastic
    of = surface if is_own else None
    vars(contacts).update(pressures=pressures, gaps=gaps, scene=of)
    return contacts


def sealing_pressure(
    surface: Topography | Scene,
    *,
    samples: int = 8,
    interface: Interface | None = None,
    level: str | None = None,
    elastic: bool = False,
    boundary: Boundary | None = None,
) -> Table:
    """Mean pressures at which contacts close the last open path through a scan.

    A row for flow along x and one along y: ``lowest_``, ``middle_`` and ``highest_`` of
    ``sealing_pressure_Pa``, within 1 %, and of ``area_fraction``, and the ``tightest_gap_m`` on the
    last paths. NaN where no path is open under the lightest contacts, with a result that says so.
    Gaps smaller than the molecule of [seal] of a scene, 0.3 nm without one, count as closed.

    Parameters
    ----------
    samples : int
        2 to 1000: the scan, and surfaces with its spectrum and nearly its distribution of heights,
        but other phases. One scan is one of many, whose pressures scatter by some ten per cent.
    surface, interface, level, elastic, boundary
        As in ``bem``; the boundary is not "free".

    Examples
    --------
    >>> import asperity
    >>> scan = asperity.random_surface((64, 64), 1e-5, long=32e-5, short=8e-5, sq=5e-6, seed=1)
    >>> found = asperity.sealing_pressure(scan, interface=asperity.Interface(1e9, 0.3), samples=2)
    >>> bool((found["lowest_sealing_pressure_Pa"] <= found["highest_sealing_pressure_Pa"]).all())
    True
    """
    if not 2 <= samples <= 1000:
        raise ValueError(f"samples is {samples}: 2 to 1000 were required")
    scan = surface, interface, level, (boundary, elastic)
    return Table(*_asperity.sealing_pressure(scan, samples))
