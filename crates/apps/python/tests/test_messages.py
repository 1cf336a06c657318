"""The words of exceptions and warnings: messages.txt has calls and what each of them says.

ASPERITY_BLESS=1 writes the answers anew.
"""

from __future__ import annotations

import os
import warnings
from pathlib import Path

import asperity as A
import numpy as np

FILE = Path(__file__).parent / "messages.txt"
SCENE = A.Scene.parse(A.template())
STEEL = A.Body(210e9, 0.3, hardness=2e9)
PAIR = A.Interface.between(STEEL, STEEL)
NAMES = {
    **{"A": A, "np": np, "SCENE": SCENE, "STEEL": STEEL, "PAIR": PAIR, "MANY": SCENE.vary(hardness=[2e9, 3e9])},
    "KE": A.model("ke"),
    "BALL": A.Scene(PAIR, SCENE.surface, curvature={"radius": "10 mm"}),
    "MOMENTS": A.Scene(PAIR, A.Surface.of(m0=1e-12, m2=1e-4, m4=5e4), 1e-4),
    "SCAN": A.Topography(1e-6 * np.eye(16), 1e-6, "m", periodic=True),
    "JOINT": A.model("ke").unloading(SCENE, 1.0),
}


def message_of(call: str) -> str:
    """The call, and its exception and warnings, a line each."""
    with warnings.catch_warnings(record=True) as seen:
        warnings.simplefilter("always")
        try:
            eval(call, dict(NAMES))
            lines = []
        except Exception as error:
            lines = [f"{type(error).__name__}: {error}"]
    shown = [f"{one.category.__name__}: {one.message}" for one in seen]
    return "\n".join([">>> " + call, *lines, *shown])


def test_messages_are_those_that_were_read() -> None:
    text = FILE.read_text(encoding="utf-8")
    calls = [line[4:] for line in text.splitlines() if line.startswith(">>> ")]
    found = "\n\n".join(map(message_of, calls)) + "\n"
    if os.environ.get("ASPERITY_BLESS"):
        FILE.write_text(found, encoding="utf-8")
    assert found == FILE.read_text(encoding="utf-8")
