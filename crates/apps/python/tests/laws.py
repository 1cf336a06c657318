"""Laws in Python that several tests use."""

from __future__ import annotations

from typing import Any

import asperity
import numpy as np


class Hertz:
    """Greenwood & Williamson."""

    force_monotone = True

    def __init__(self, one: asperity.Asperity) -> None:
        self.one = one
        self.unit = 4 / 3 * one.equivalent_modulus * one.radius**0.5

    def force(self, w: Any) -> Any:
        # Laws are asked up to the largest numbers, whose powers overflow.
        with np.errstate(over="ignore"):
            return self.unit * w**1.5

    def area(self, w: Any) -> Any:
        return np.pi * self.one.radius * w
