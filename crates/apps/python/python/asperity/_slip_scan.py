"""Partial slip of a scan in shear."""

from __future__ import annotations

from dataclasses import dataclass

import numpy.typing as npt

from asperity import _asperity
from asperity._arguments import Floats, in_si, one_number, place
from asperity._asperity import Scene, Topography
from asperity._bem import Boundary, _pressed
from asperity._records import Interface


@dataclass(frozen=True)
class BemSlip:
    """A steady cycle of a scan in shear, and where it sticks; made by ``bem_slip``.

    NaN before the shift 0 for what belongs to the first loading.
    """

    #: Shifts from -amplitude to +amplitude [m].
    shift: Floats
    #: Tangential force at these shifts of the first loading [N].
    force: Floats
    #: Tangential force on the way back from +amplitude [N].
    back: Floats
    #: Tangential force on the way forth from -amplitude [N].
    forth: Floats
    #: Energy that a cycle with this shift as its amplitude dissipates [J].
    loss: Floats
    #: The loss over pi times force times shift; 4/pi in gross slip.
    loss_factor: Floats
    #: 1 where a pixel slips at the amplitude, 2 where it sticks, 0 without contact.
    states: Floats

    def __repr__(self) -> str:
        return f"<asperity.BemSlip of {self.shift.size} shifts>"


def bem_slip(
    surface: Topography | Scene | npt.ArrayLike,
    *,
    friction: float,
    amplitude: float | str,
    load: float | str | None = None,
    pressure: float | str | None = None,
    points: int = 21,
    interface: Interface | None = None,
    pixel_size: float | str | tuple[float, float] | None = None,
    level: str | None = None,
    elastic: bool = False,
    boundary: Boundary | None = None,
) -> BemSlip:
    """Partial slip of a scan under a constant load, by boundary elements.

    From its normal solutions (Ciavarella, Jaeger): elastic bodies of like materials, without
    adhesion. Exact for circular contacts.

    Parameters
    ----------
    friction : float
        The coefficient of friction.
    amplitude : float or str
        The largest shift [m].
    load, pressure : float or str
        The constant load [N] on the nominal area, or pressure on it [Pa]; one of them.
    points : int
        The number of shifts.
    surface, interface, pixel_size, level, elastic, boundary
        As in ``bem``; with two bodies or an equivalent_shear_modulus.
    """
    if not 2 <= points <= 100_000:
        raise ValueError(f"points is {points}: 2 to 100000 were required")
    axis, number = place(load=load, pressure=pressure)
    given = axis, one_number(axis, number)
    cycle = one_number("amplitude", in_si(amplitude, "m")), points
    scan = _pressed(surface, interface, pixel_size, level, elastic, boundary)
    found, pixels = _asperity.bem_slip(scan, given, friction, cycle)
    states = found.pop("states").reshape(pixels)
    units = ("_m", "_N", "_N", "_N", "_J", "")
    own = zip(list(BemSlip.__dataclass_fields__)[:6], units, strict=True)
    return BemSlip(**{name: found[name + unit] for name, unit in own}, states=states)
