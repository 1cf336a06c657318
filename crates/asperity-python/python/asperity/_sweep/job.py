"""The work of a sweep, as it is sent to workers."""

from __future__ import annotations

import hashlib
import inspect
import json
from dataclasses import dataclass
from typing import Any

from asperity import _asperity
from asperity._arguments import placed, reason
from asperity._model import Model
from asperity._scene import Floats
from asperity._sweep.design import Design
from asperity._sweep.part import Part
from asperity._sweep.space import Space


@dataclass(frozen=True)
class Job:
    """A sweep without a place to run. Its parts depend on nothing else."""

    space: Space
    model: Model
    quantities: tuple[str, ...]
    design: Design
    rtol: float
    separation_unit: str
    errors: str
    version: str

    def draw(self, number: int) -> dict[str, Floats]:
        """The inputs of one part that vary."""
        return self.space.columns(self.design.sample(number))

    def answer(
        self, number: int, inputs: dict[str, Floats], threads: int | None = None
    ) -> tuple[Part, list[str]]:
        """One part, and the warnings of the model."""
        rows, stop = self.space.rows(inputs, self.separation_unit), self.errors == "raise"
        values, failures, said = _asperity.answer(
            self.model, rows, self.quantities, self.rtol, "value", stop, threads, False
        )
        first = self.design.first_row(number)
        for k, error in failures:
            if stop or not isinstance(error, Exception):
                drawn = ", ".join(f"{name}={v[k]:.6g}" for name, v in inputs.items())
                raise placed(f"row {first + k} ({drawn}): ", error)
        errors = {k: reason(error) for k, error in failures}
        return Part(first, inputs, dict(zip(self.quantities, values, strict=True)), errors), said

    def identity(self) -> dict[str, Any]:
        """Everything that the digits depend on, for JSON."""
        import scipy

        design = self.design
        return {
            "asperity": self.version,
            "scipy": scipy.__version__,
            "model": _model_identity(self.model),
            "quantities": list(self.quantities),
            "design": design.kind,
            "n": design.n,
            "seed": design.seed,
            "rows": design.rows,
            "parts": design.parts,
            "part_size": design.part_size,
            "rtol": self.rtol,
            "separation_unit": self.separation_unit,
            "space": self.space.identity(),
        }


def fingerprint(identity: dict[str, Any]) -> str:
    """A short name for an identity."""
    return hashlib.sha256(json.dumps(identity, sort_keys=True).encode()).hexdigest()


def _model_identity(model: Model) -> dict[str, Any]:
    what = model._what
    if isinstance(what, str):
        return {"id": what, "options": model.options}
    name = f"{getattr(what, '__module__', '')}.{getattr(what, '__qualname__', repr(what))}"
    try:
        source = inspect.getsource(what)
    except (OSError, TypeError):
        return {"class": name}
    return {"class": name, "source": hashlib.sha256(source.encode()).hexdigest()}
