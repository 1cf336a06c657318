"""A contact law in a small dynamics simulation: a mass dropped on a rough surface.

The joint is tabulated once; every step calls it with the gap in metres. The step is implicit
(trapezoidal rule with Newton's method on the stiffness), because rough contacts stiffen a
hundredfold within a micrometre.

Asperities that have yielded return only part of the work of closing. The state of the joint is one
number, the closest approach so far: at smaller gaps the joint closes for the first time, at larger
gaps it opens, or closes again on the same curve. The first landing dissipates energy; later landings,
which stay farther away, dissipate none.

>>> history = simulate(milliseconds=6.0)
>>> len(history), landings(history) >= 2
(6001, True)
>>> first, second = rebounds(history)[:2]
>>> abs(first / quasi_static(history) - 1) < 0.02           # from the work of the joint alone
True
>>> 0.6 < first < 0.8 and abs(second - 1) < 0.02
True
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from itertools import pairwise
from math import inf, sqrt

import asperity

MASS = 0.1  # kg
GRAVITY = 9.81  # m/s^2
STEP = 1e-6  # s
DROP = 2e-5  # m, the initial gap
FREE = 5e-6  # m, a gap with a negligible force


@dataclass(frozen=True)
class State:
    """Time [s], gap [m], velocity of the gap [m/s] and the closest approach so far [m]."""

    time: float
    gap: float
    velocity: float
    closest: float = inf


@cache
def scene() -> asperity.Scene:
    """Ground steel on steel, one square centimetre."""
    steel = asperity.Body(210e9, 0.3, hardness=2e9)
    return asperity.Scene(
        interface=asperity.Interface.between(steel, steel),
        surface=asperity.Surface(2e-4, 2e8, 1e-6),
        nominal_area=1e-4,
    )


@cache
def joint() -> asperity.JointTable:
    """KE with Hertzian unloading."""
    return asperity.model("ke").joint_table(scene(), 1e-6, FREE, separation_unit="m")


def step(state: State) -> State:
    """One step of the trapezoidal rule."""
    before, _, closest = joint().step(state.gap, state.closest)
    gap = state.gap + STEP * state.velocity
    for _ in range(20):
        force, stiffness, _ = joint().step(gap, closest)
        mean = 0.5 * (before + force) / MASS - GRAVITY
        residual = gap - state.gap - STEP * (state.velocity + 0.5 * STEP * mean)
        change = residual / (1.0 + 0.25 * STEP**2 * stiffness / MASS)
        gap -= change
        if abs(change) < 1e-16:
            break
    force, _, closest = joint().step(gap, closest)
    velocity = state.velocity + STEP * (0.5 * (before + force) / MASS - GRAVITY)
    return State(state.time + STEP, gap, velocity, closest)


def simulate(milliseconds: float) -> list[State]:
    """The states of a mass dropped above the surface."""
    states = [State(0.0, DROP, 0.0)]
    for _ in range(round(milliseconds * 1e-3 / STEP)):
        states.append(step(states[-1]))
    return states


def landings(history: list[State]) -> int:
    """The number of times that the velocity turns upwards."""
    return sum(one.velocity < 0.0 <= two.velocity for one, two in pairwise(history))


def rebounds(history: list[State]) -> list[float]:
    """Coefficient of restitution of every landing: the speed after it over that before."""
    pairs = list(pairwise(history))
    falling = [abs(two.velocity) for one, two in pairs if one.gap > FREE >= two.gap]
    rising = [abs(two.velocity) for one, two in pairs if one.gap <= FREE < two.gap]
    return [up / down for down, up in zip(falling, rising, strict=False)]


def quasi_static(history: list[State]) -> float:
    """The first coefficient of restitution from the work of the joint and of the weight."""
    turn = next(two for one, two in pairwise(history) if one.velocity < 0.0 <= two.velocity)
    back = asperity.model("ke").unloading(scene(), turn.closest, separation_unit="m")
    given, weight = back.returned(FREE - turn.gap), MASS * GRAVITY * (FREE - turn.gap)
    return sqrt((given - weight) / (given + back.dissipated() - weight))


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
