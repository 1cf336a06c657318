"""A contact law in a small dynamics simulation: a mass dropped on a rough surface.

The contact is compiled once; every step calls it with the gap in metres. The step is implicit
(trapezoidal rule with Newton's method on the tangent), because rough contacts stiffen a hundredfold
within a micrometre.

Asperities that have yielded do not give back what closing them took. The state that remembers it is
one number, the closest approach so far: below it the contact closes for the first time, above it
the joint unloads, or closes again on the same curve. So the first landing loses energy, and those
after it, which do not come as far, lose none.

>>> history = simulate(milliseconds=6.0)
>>> len(history), landings(history) >= 2
(6001, True)
>>> first, second = rebounds(history)[:2]
>>> abs(first / quasi_static(history) - 1) < 0.02           # from the force curves alone
True
>>> 0.6 < first < 0.8 and abs(second - 1) < 0.02
True
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from itertools import pairwise

import asperity
import numpy as np

MASS = 0.1  # kg
GRAVITY = 9.81  # m/s^2
STEP = 1e-6  # s
DROP = 2e-5  # m, the gap at which the mass is let go
FREE = 5e-6  # m, a gap without a force to speak of


@dataclass(frozen=True)
class State:
    """Time [s], gap [m] and velocity of the gap [m/s]."""

    time: float
    gap: float
    velocity: float


@cache
def scene() -> asperity.Scene:
    """Steel on steel, ground: one square centimetre."""
    steel = asperity.Body(210e9, 0.3, hardness=2e9)
    return asperity.Scene(
        interface=asperity.Interface.between(steel, steel),
        surface=asperity.Surface(2e-4, 2e8, 1e-6),
        nominal_area=1e-4,
    )


class Joint:
    """KE with unloading: what the gap is, and how close it has been."""

    def __init__(self) -> None:
        self.closing = asperity.model("ke").compile(scene(), separation_unit="m")
        self.closest = np.inf
        self.opening: asperity.Unloading | None = None

    def force_and_tangent(self, gap: float) -> tuple[float, float]:
        """Force [N] and its slope [N/m] at a gap."""
        if self.opening is None or gap <= self.closest:
            return self.closing.force_and_tangent(gap)
        if gap >= FREE:
            return 0.0, 0.0
        retreat = gap - self.closest
        return self.opening.force(retreat), self.opening.stiffness(retreat)

    def turn(self, gap: float) -> None:
        """The gap has closed this far, and opens now."""
        if gap < self.closest:
            self.closest = gap
            self.opening = asperity.model("ke").unloading(scene(), gap, separation_unit="m")


def step(state: State, joint: Joint) -> State:
    """One step of the trapezoidal rule."""
    before, _ = joint.force_and_tangent(state.gap)
    gap = state.gap + STEP * state.velocity
    for _ in range(20):
        force, tangent = joint.force_and_tangent(gap)
        mean = 0.5 * (before + force) / MASS - GRAVITY
        residual = gap - state.gap - STEP * (state.velocity + 0.5 * STEP * mean)
        change = residual / (1.0 + 0.25 * STEP**2 * tangent / MASS)
        gap -= change
        if abs(change) < 1e-16:
            break
    force, _ = joint.force_and_tangent(gap)
    velocity = state.velocity + STEP * (0.5 * (before + force) / MASS - GRAVITY)
    if state.velocity < 0.0 <= velocity:
        joint.turn(gap)
    return State(state.time + STEP, gap, velocity)


def simulate(milliseconds: float) -> list[State]:
    """A mass let go above the surface."""
    joint, states = Joint(), [State(0.0, DROP, 0.0)]
    for _ in range(round(milliseconds * 1e-3 / STEP)):
        states.append(step(states[-1], joint))
    return states


def landings(history: list[State]) -> int:
    """How often the velocity turns from down to up."""
    return sum(one.velocity < 0.0 <= two.velocity for one, two in pairwise(history))


def rebounds(history: list[State]) -> list[float]:
    """Coefficient of restitution of every landing: the speeds of leaving and of coming."""
    pairs = list(pairwise(history))
    falling = [abs(two.velocity) for one, two in pairs if one.gap > FREE >= two.gap]
    rising = [abs(two.velocity) for one, two in pairs if one.gap <= FREE < two.gap]
    return [up / down for down, up in zip(falling, rising, strict=False)]


def quasi_static(history: list[State]) -> float:
    """The first coefficient from the work on the two force curves, less that of the weight."""
    turn = next(two for one, two in pairwise(history) if one.velocity < 0.0 <= two.velocity)
    joint, gaps = Joint(), np.linspace(turn.gap, FREE, 401)
    joint.turn(turn.gap)
    assert joint.opening is not None
    taken = np.trapezoid(joint.closing.force(gaps), gaps)
    given = np.trapezoid(joint.opening.force(gaps - turn.gap), gaps)
    weight = MASS * GRAVITY * (FREE - turn.gap)
    return float(np.sqrt((given - weight) / (taken - weight)))


if __name__ == "__main__":
    import time

    begun = time.perf_counter()
    history = simulate(milliseconds=20.0)
    seconds = time.perf_counter() - begun
    lowest = min(state.gap for state in history)
    print(f"{landings(history)} landings in 20 ms, lowest gap {lowest * 1e6:.3f} um")
    print("restitution", ", ".join(f"{e:.3f}" for e in rebounds(history)))
    print(
        f"{len(history) - 1} steps in {seconds:.2f} s, {seconds / (len(history) - 1) * 1e6:.1f} us each"
    )
