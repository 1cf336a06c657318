"""Arguments whose meaning is Python's: lengths with a unit, paths."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import asperity

KE: Any = asperity.model("ke")


def test_a_joint_table_takes_lengths_with_a_unit(scene: asperity.Scene) -> None:
    table = KE.joint_table(scene, "1 um", "3 um", separation_unit="m")
    assert table.step(2e-6) == KE.joint_table(scene, 1e-6, 3e-6, separation_unit="m").step(2e-6)


def test_texts_are_saved(scene: asperity.Scene, tmp_path: Path) -> None:
    curve = KE.solve(scene, load=[1.0, 2.0], quantities=["unloading-stiffness"])
    assert (curve["load"] == [1.0, 2.0]).all()
    text = curve.to_csv(tmp_path / "curve.csv")
    assert (tmp_path / "curve.csv").read_text() == text
    table = asperity.export(KE, scene, "csv", load=("10 N", "1 kN"), max_error=1e-3)
    table.save(tmp_path / "table.csv")
    assert (tmp_path / "table.csv").read_text() == table.text
