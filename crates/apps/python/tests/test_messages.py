"""The words of messages: those of messages.txt, which ASPERITY_BLESS=1 writes."""

from __future__ import annotations

import os
import warnings
from collections.abc import Callable
from pathlib import Path
from typing import Any

import asperity
import numpy as np

FILE = Path(__file__).parent / "messages.txt"
SCENE: Any = asperity.Scene.parse(asperity.template())
KE: Any = asperity.model("ke")
A: Any = asperity
STEEL: Any = asperity.Body(210e9, 0.3, hardness=2e9)
PAIR: Any = asperity.Interface.between(STEEL, STEEL)

CALLS: list[Callable[[], Any]] = [
    lambda: A.Body("210", 0.3),
    lambda: A.Body([2e11], 0.3),
    lambda: A.Surface(1e-4, None, 1e-6),
    lambda: A.Surface.of(m0=1e-12, m2=0.1, spd=1e9),
    lambda: A.Interface.between(STEEL, None),
    lambda: A.Scene(STEEL, SCENE.surface, 1e-4),
    lambda: A.Scene(PAIR, SCENE.surface, 1e-4).replace(equivalent_modulus=1e11, youngs_modulus=1e11),
    lambda: A.Scene(PAIR, SCENE.surface, 1e-4).replace(hardness=1e9, body1_hardness=1e9),
    lambda: A.model(object),
    lambda: A.model("gw").pull_off(SCENE),
    lambda: KE.solve(SCENE),
    lambda: KE.solve(SCENE, load="2 mm"),
    lambda: KE.solve(SCENE, load=[1.0, "2 kN"]),
    lambda: KE.solve([SCENE, SCENE], load=[1.0, 2.0, 3.0]),
    lambda: KE.solve(SCENE, 1.0).area,
    lambda: KE.solve(SCENE, load=[1e-3, 1.0], quantities="area"),
    lambda: KE.solve(SCENE, load=1e30),
    lambda: KE.compile([SCENE]),
    lambda: KE.unloading(SCENE, load=[1.0, 2.0]),
    lambda: A.export(SCENE, "ke", "abaqus", load=(1, 2), nodes=3),
    lambda: A.export(KE, SCENE, "abaqus", load=np.ones(40), nodes=3),
    lambda: A.fit(SCENE, {"load_N": [1.0], "area_m2": [1e-9]}, "hardnes"),
    lambda: A.fit(SCENE, {"load_N": [1.0], "area_m2": [1e-9]}, {"hardness": 1e9}),
    lambda: A.bem(np.zeros((8, 8)), interface=PAIR, pressure=1e7),
    lambda: A.bem(A.Topography(np.eye(8), 1.0, "um"), pressure=1e7),
    lambda: A.read(np.zeros((8, 8))),
    lambda: A.sample(np.zeros((4, 2)), hardness=(1e9, 2e9)),
]


def told(call: Callable[[], Any]) -> str:
    """The exception and the warnings of a call, a line each."""
    with warnings.catch_warnings(record=True) as seen:
        warnings.simplefilter("always")
        try:
            call()
            lines = []
        except Exception as error:
            lines = [f"{type(error).__name__}: {error}"]
    return "\n".join([*lines, *(f"{one.category.__name__}: {one.message}" for one in seen)])


def test_messages_are_those_that_were_read() -> None:
    found = "\n\n".join(map(told, CALLS)) + "\n"
    if os.environ.get("ASPERITY_BLESS"):
        FILE.write_text(found, encoding="utf-8")
    assert found == FILE.read_text(encoding="utf-8")
