"""Asperities of a random surface, in tables."""

from __future__ import annotations

from pathlib import Path

import asperity
import numpy as np

EXAMPLES = Path(__file__).resolve().parents[3] / "answer" / "scene" / "examples"


def test_an_answer_is_that_of_the_model_best_and_lies_between_its_ends() -> None:
    for path in sorted(EXAMPLES.glob("*.toml")):
        scene = asperity.Scene.from_toml(path)
        asked = ["area", "tangent", "unloading-stiffness"]
        # No contact carries 3 MPa on the elastomer.
        pressures = [1e4, 1e5] if "elastomer" in path.name else [1e5, 3e6]
        answer = scene.answer(asked, pressure=pressures)
        curve = asperity.model("best").solve(scene, pressure=pressures, quantities=asked)
        for quantity in asked:
            assert answer.value[quantity].tolist() == curve[quantity].tolist(), path
            known = ~np.isnan(answer.lower[quantity])
            value = answer.value[quantity][known]
            assert (answer.lower[quantity][known] <= value).all()
            assert (value <= answer.upper[quantity][known]).all()
        assert "mean-gap" in answer.value or scene.heights == "exponential"
        assert "real area" in str(answer) and "<table>" in answer._repr_html_()
    seal = asperity.Scene.from_toml(EXAMPLES / "lapped-seal.toml").answer(load="75 N")
    assert seal.lower["area"] < seal.value["area"] < seal.upper["area"]
    assert "nine of ten surfaces" in seal.by and not seal.widest
