"""What is to be done, as it is sent to workers."""

from __future__ import annotations

import hashlib
import inspect
import json
from dataclasses import dataclass
from typing import Any

from asperity._arguments import Floats
from asperity._asperity import NotConverged, evaluate_rows
from asperity._model import Model
from asperity._sweep.design import Design
from asperity._sweep.part import Part
from asperity._sweep.space import Space

ERRORS = ("raise", "record")


@dataclass(frozen=True)
class Job:
    """A sweep without a place to run. Its parts depend on nothing else."""

    space: Space
    model: Model
    quantities: tuple[str, ...]
    design: Design
    rtol: float
    in_metres: bool
    errors: str
    version: str

    def draw(self, number: int) -> dict[str, Floats]:
        """The inputs of one part that vary."""
        return self.space.columns(self.design.sample(number))

    def answer(
        self, number: int, inputs: dict[str, Floats], threads: int | None = None
    ) -> tuple[Part, list[str]]:
        """One part, and the warnings of the model."""
        columns = self.space.all_columns(inputs)
        scenes, roughness = self.space.scenes(columns)
        values, failed, warnings = evaluate_rows(
            self.model._engine,
            scenes,
            columns["separation"],
            self.in_metres,
            roughness,
            self.quantities,
            self.rtol,
            threads,
        )
        first = self.design.first_row(number)
        for k, error in failed:
            if self.errors == "raise" or not isinstance(error, Exception):
                raise _at_row(first + k, {name: v[k] for name, v in columns.items()}, error)
        errors = {k: reason(error) for k, error in failed}
        named = dict(zip(self.quantities, values, strict=True))
        return Part(first, inputs, named, errors), warnings

    def identity(self) -> dict[str, Any]:
        """Everything that the digits depend on, for JSON."""
        import scipy

        design = self.design
        return {
            "asperity": self.version,
            "scipy": scipy.__version__,
            "model": _model_words(self.model),
            "quantities": list(self.quantities),
            "design": design.kind,
            "n": design.n,
            "seed": design.seed,
            "rows": design.rows,
            "parts": design.parts,
            "part_size": design.part_size,
            "rtol": self.rtol,
            "separation_unit": "m" if self.in_metres else "asperity_height_std",
            "space": self.space.identity(),
        }


def fingerprint(identity: dict[str, Any]) -> str:
    """A short name for an identity."""
    return hashlib.sha256(json.dumps(identity, sort_keys=True).encode()).hexdigest()


def reason(error: Exception) -> str:
    """The words of a refusal; of an exception of the user's own, also its kind."""
    if isinstance(error, ValueError | NotConverged):
        return str(error)
    return f"{type(error).__name__}: {error}"


def _at_row(row: int, inputs: dict[str, Any], error: BaseException) -> BaseException:
    words = ", ".join(f"{name}={value:.6g}" for name, value in inputs.items())
    if type(error) in (ValueError, NotConverged):
        return type(error)(f"row {row} ({words}): {error}")
    return error


def _model_words(model: Model) -> dict[str, Any]:
    what = model._what
    if isinstance(what, str):
        return {"id": what, "options": model.options}
    name = f"{getattr(what, '__module__', '')}.{getattr(what, '__qualname__', repr(what))}"
    try:
        source = inspect.getsource(what)
    except (OSError, TypeError):
        return {"class": name}
    return {"class": name, "source": hashlib.sha256(source.encode()).hexdigest()}
