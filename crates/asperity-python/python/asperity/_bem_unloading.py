"""Unloading of a scan by boundary elements."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from asperity import _asperity
from asperity._asperity import Scene, Topography, in_si
from asperity._bem import Boundary, load_given, pressed
from asperity._records import Interface
from asperity._scene import Floats


@dataclass(frozen=True)
class BemUnloading:
    """The opening of a scan from its greatest load; made by ``bem_unloading``."""

    #: Retreats from the greatest load [m].
    retreat: Floats
    #: Load on the nominal area [N].
    load: Floats
    #: Mean pressure [Pa].
    pressure: Floats
    #: Real over nominal area.
    area_fraction: Floats
    #: Mean gap from the mean plane of the first surface [m].
    mean_gap: Floats
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
    name, value = load_given(pressure, load, gap)
    if value.size != 1:
        raise TypeError(f"{name} has {value.size} values: one greatest load was required")
    if not 2 <= points <= 100_000:
        raise ValueError(f"points is {points}: 2 to 100000 were required")
    retreats = None if retreat is None else _asperity.floats(in_si(retreat, "m"), "retreat")
    scan, level = pressed(surface, pixel_size, level)
    numbers, last_contact, used, area = _asperity.bem_unloading(
        (scan, interface, level),
        (name, float(value.ravel()[0])),
        elastic,
        boundary,
        None if retreats is None else retreats.ravel().tolist(),
        points,
    )
    shape = np.shape(numbers["retreat"]) if retreats is None else retreats.shape
    return BemUnloading(
        **{name: array.reshape(shape) for name, array in numbers.items()},
        last_contact=last_contact,
        boundary=used,
        nominal_area=area,
    )
