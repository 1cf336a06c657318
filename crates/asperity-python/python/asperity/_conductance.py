"""Correlations of thermal contact conductance, and the conductance of a gas."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from asperity import _asperity
from asperity._arguments import Rows, SceneLike, one_number, place
from asperity._asperity import in_si
from asperity._scene import Floats
from asperity._warn import warn


@dataclass(frozen=True)
class Correlated:
    """Values of a correlation, in the shape of the pressures."""

    #: Thermal conductance over the nominal area [W/(m^2 K)].
    conductance: Floats
    #: p/H ("cmy"), or sqrt(2) p/(E m) ("mikic"): the argument of the power law.
    relative_pressure: Floats
    #: Whether the power law is within 2.1 % of the theory it is fitted to.
    holds: npt.NDArray[np.bool_]


def correlated_conductance(
    correlation: str,
    scene: SceneLike,
    *,
    load: npt.ArrayLike | None = None,
    pressure: npt.ArrayLike | None = None,
    surface_height_std: float | str | None = None,
    mean_slope: float | None = None,
) -> Correlated:
    """Thermal contact conductance by a correlation, for comparison with the quantity
    "thermal-conductance-per-area" of the models.

    "cmy" is Cooper, Mikic & Yovanovich 1969, for plastic contacts; "mikic" Mikic 1974, for elastic
    ones. Both are for nominally flat rough surfaces in vacuum, and use ``surface_height_std`` [m] and
    ``mean_slope`` (mean absolute, of profiles; both of the two surfaces together) if given, otherwise
    those of the scan or, without one, of a Gaussian surface with the scene's asperities. The
    interface needs a ``thermal_conductivity``; a warning names pressures outside the range of the
    correlation. Many scenes are broadcast against loads and pressures, as in ``Model.solve``.

    >>> import asperity
    >>> steel = asperity.Body(210e9, 0.3, hardness=2e9, thermal_conductivity=50.0)
    >>> interface = asperity.Interface.between(steel, steel)
    >>> scene = asperity.Scene(interface, asperity.Surface(2e-4, 2e8, 1e-6), nominal_area=1e-4)
    >>> asperity.correlated_conductance("cmy", scene, pressure=[1e5, 1e6]).conductance.round()
    array([ 152., 1351.])
    >>> softer = scene.vary(hardness=[1e9, 2e9])
    >>> asperity.correlated_conductance("cmy", softer, pressure=1e5).conductance.round()
    array([293., 152.])
    """
    axis, given = place(None, load, pressure, "m")
    if (surface_height_std is None) != (mean_slope is None):
        raise TypeError("surface_height_std and mean_slope go together: give both, or neither")
    rows, roughness = Rows(scene, axis, given), None
    if surface_height_std is not None and mean_slope is not None:
        std = one_number("surface_height_std", in_si(surface_height_std, "m"))
        roughness = std, one_number("mean_slope", mean_slope)
    columns, (first, last), reason = _asperity.correlated(correlation, rows, roughness)
    conductance, relative, holds = map(rows.shaped, columns)
    if reason is not None and holds.size:
        warn(f"{correlation}: {reason}", 1)
    elif not holds.all():
        worst = relative[~holds].ravel()[0]
        message = (
            f"{correlation}: relative pressure is {worst:.4g}: the correlation holds from {first:g} to "
            f"{last:g}"
        )
        warn(message, 1)
    return Correlated(conductance, relative, holds)


def gap_conductance(
    conductivity: float, gap: float | str, gas_parameter: float | str = 0.0
) -> float:
    """Conductance over the nominal area [W/(m^2 K)] of a gas beside the contacts: its conductivity
    [W/(m K)] over the sum of the mean gap and the gas parameter [m], its temperature-jump distance
    (about 0.37 um for air at 1 bar).

    The mean gap is the separation from the mean plane of the surface. Lengths may be texts with a
    unit.

    >>> import asperity
    >>> round(asperity.gap_conductance(0.026, "3 um", "0.37 um"), 1)
    7715.1
    """
    lengths = in_si(gap, "m"), in_si(gas_parameter, "m")
    return _asperity.gap_conductance(conductivity, *lengths)
