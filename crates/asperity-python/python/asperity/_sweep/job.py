"""The work of a sweep, sent to workers."""

from __future__ import annotations

import hashlib
import inspect
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
    """A sweep: all that its parts depend on."""

    space: Space
    model: Model
    quantities: tuple[str, ...]
    design: Design
    rtol: float
    separation_unit: str
    errors: str
    version: str

    def draw(self, number: int) -> dict[str, Floats]:
        """The inputs that vary, of one part."""
        return self.space.columns(self.design.sample(self.design.parts[number]))

    def answer(
        self, number: int, inputs: dict[str, Floats], threads: int | None = None
    ) -> tuple[Part, list[str]]:
        """One part, and the warnings of the model."""
        rows, stop = self.space.rows(inputs, self.separation_unit), self.errors == "raise"
        _, values, failures, messages = _asperity.answer(
            self.model, rows, self.quantities, self.rtol, "value", stop, threads, False
        )
        first = self.design.parts[number].start
        for k, error in failures:
            if stop or not isinstance(error, Exception):
                drawn = ", ".join(f"{name}={v[k]:.6g}" for name, v in inputs.items())
                raise placed(f"row {first + k} ({drawn}): ", error)
        errors = {k: reason(error) for k, error in failures}
        return Part.of(first, inputs, values, errors), messages

    def identity(self) -> dict[str, Any]:
        """Every input that the values depend on, for JSON."""
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
            "parts": len(design.parts),
            "part_size": design.part_size,
            "rtol": self.rtol,
            "separation_unit": self.separation_unit,
            "space": self.space.identity(),
        }


def _model_identity(model: Model) -> dict[str, Any]:
    definition = model._definition
    if isinstance(definition, str):
        return {"id": definition, "options": model.options}
    name = f"{getattr(definition, '__module__', '')}.{getattr(definition, '__qualname__', repr(definition))}"
    try:
        source = inspect.getsource(definition)
    except (OSError, TypeError):
        return {"class": name}
    return {"class": name, "source": hashlib.sha256(source.encode()).hexdigest()}
