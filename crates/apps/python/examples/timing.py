"""Median times of calls from Python on this machine."""

from __future__ import annotations

import statistics
import timeit
from collections.abc import Callable

import numpy as np

import asperity

steel = asperity.Body(210e9, 0.3, hardness=2e9)
SCENE = asperity.Scene(
    interface=asperity.Interface.between(steel, steel),
    surface=asperity.Surface(2e-4, 2e8, 1e-6),
    nominal_area=1e-4,
)


class Hertz:
    """Greenwood and Williamson's law, written in Python."""

    def __init__(self, one: asperity.Asperity) -> None:
        self.modulus, self.radius = one.equivalent_modulus, one.radius

    def force(self, w: np.ndarray) -> np.ndarray:
        """Hertz [N]."""
        return 4 / 3 * self.modulus * np.sqrt(self.radius * w**3)

    def area(self, w: np.ndarray) -> np.ndarray:
        """Hertz [m^2]."""
        return np.pi * self.radius * w


def nanoseconds(call: Callable[[], object], number: int, values: int = 1) -> float:
    """The median time of a call for each value [ns]."""
    call()
    runs = timeit.repeat(call, number=number, repeat=15)
    return statistics.median(runs) / number / values * 1e9


if __name__ == "__main__":
    contact = asperity.model("ke").compile(SCENE, separation_unit="m")
    own = asperity.model(Hertz).compile(SCENE, separation_unit="m")
    gaps = np.linspace(0, 4e-6, 1_000_000)
    print(f"force at a gap: {nanoseconds(lambda: contact.force(1.5e-6), 20_000):.0f} ns")
    both = nanoseconds(lambda: contact.force_and_tangent(1.5e-6), 20_000)
    print(f"force and tangent at a gap: {both:.0f} ns")
    many = nanoseconds(lambda: contact.force(gaps), 1, gaps.size)
    print(f"a million forces: {many:.1f} ns each")
    mine = nanoseconds(lambda: own.force(gaps), 1, gaps.size)
    print(f"a million forces of a model in Python: {mine:.1f} ns each")
