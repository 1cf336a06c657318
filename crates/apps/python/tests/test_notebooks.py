"""The notebooks run from top to bottom with the stored outputs, which are small."""

from __future__ import annotations

import csv
from collections import defaultdict
from pathlib import Path

import asperity
import nbformat
import numpy as np
import pytest
from nbclient import NotebookClient

HERE = Path(__file__).resolve()
NOTEBOOKS = sorted((HERE.parents[1] / "examples").glob("*.ipynb"))
FIGURES = HERE.parents[4] / "figures"


# Warnings of the kernel's threads and sockets are not under test.
@pytest.mark.filterwarnings("default")
@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_a_notebook_runs(path: Path, tmp_path: Path) -> None:
    notebook = nbformat.read(path, as_version=4)
    stored = [cell.get("outputs", []) for cell in notebook.cells]
    resources = {"metadata": {"path": str(tmp_path)}}
    NotebookClient(notebook, timeout=60, coalesce_streams=True, resources=resources).execute()
    shown = 0
    for cell, before in zip(notebook.cells, stored, strict=True):
        outputs = cell.get("outputs", [])
        assert [output.output_type for output in outputs] == [one.output_type for one in before]
        for output, one in zip(outputs, before, strict=True):
            # Texts and their numbers do not depend on the machine.
            assert output.get("text") == one.get("text")
            for kind, data in one.get("data", {}).items():
                assert len(data) < 100_000 * 4 / 3, f"a {kind} of {len(data)} bytes"
                shown += kind == "image/png"
    assert shown >= 1


@pytest.mark.filterwarnings("ignore::asperity.ContactWarning")
def test_the_figure_of_the_paper_is_that_of_the_repository() -> None:
    points = defaultdict(list)
    with (FIGURES / "fig05-force-models.csv").open(encoding="utf-8") as table:
        for row in csv.DictReader(table):
            points[row["curve"]].append((float(row["separation_m"]), float(row["force_N"])))
    notebook = nbformat.read(HERE.parents[1] / "examples" / "paper-figure.ipynb", as_version=4)
    code = [cell.source for cell in notebook.cells if cell.cell_type == "code"]
    found: dict[str, object] = {}
    exec("\n".join(code[:2]).replace("\nscene\n", "\n"), found)
    scene, names = found["scene"], found["names"]
    assert isinstance(scene, asperity.Scene) and set(points) == set(names)  # type: ignore[call-overload]
    for name, curve in points.items():
        separation, force = np.array(curve).T
        again = asperity.model(name).solve(scene, separation, separation_unit="m").force
        assert np.abs(again / force - 1.0).max() < 1e-8
