"""What a look at a scene shows before its answers are believed."""

from __future__ import annotations

from dataclasses import dataclass, field, fields
from typing import Any


@dataclass(frozen=True)
class Finding:
    """Something unusual about a number of a scene, or of an answer."""

    #: What it is about: ``unusual-size``, ``crowded``.
    code: str
    #: ``error``: results are invalid until this is corrected; ``warning``; ``note``.
    severity: str
    #: The number, by its name in scene files.
    field: str
    #: Its value, in SI units.
    value: float
    #: The usual range; None where an end is open.
    usual: tuple[float | None, float | None]
    #: The whole text, with advice.
    message: str

    def __str__(self) -> str:
        return f"{self.severity}: {self.message}"


@dataclass(frozen=True)
class Check:
    """What follows from a scene and, at a load, from a model; ``print`` it."""

    #: Numbers by their names, in SI units.
    numbers: dict[str, float]
    #: What is unusual, most severe first.
    findings: tuple[Finding, ...]
    text: str = field(repr=False)

    @staticmethod
    def _of(numbers: list[tuple[str, float, str, str]], findings: list[dict[str, Any]]) -> Check:
        names = [entry.name for entry in fields(Finding)]
        known = [{name: f[name] for name in names} for f in findings]
        found = tuple(Finding(**{**f, "usual": tuple(f["usual"])}) for f in known)
        width = max(len(name) for name, *_ in numbers)
        lines = [
            f"{name:<{width}}  {value:<12.6g} {unit:<5} {meaning}".rstrip()
            for name, value, unit, meaning in numbers
        ]
        text = "\n".join([*lines, *map(str, found)])
        return Check({name: value for name, value, *_ in numbers}, found, text)

    def __str__(self) -> str:
        return self.text
