"""Checks of scenes and answers."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

from asperity._arguments import record


@dataclass(frozen=True)
class Finding:
    """An unusual number of a scene or an answer."""

    #: The kind of finding: ``unusual-size``, ``crowded``.
    code: str
    #: ``error``: results are invalid until this is corrected; ``warning``; ``note``.
    severity: str
    #: The name of the number in scene files.
    field: str
    #: Its value, in SI units.
    value: float
    #: The usual range; None for an open end.
    usual: tuple[float | None, float | None]
    #: The text with the advice.
    message: str

    def __str__(self) -> str:
        return f"{self.severity}: {self.message}"


@dataclass(frozen=True)
class Check:
    """Derived numbers and findings of a scene and, at a load, of a model; ``print`` it."""

    #: Numbers by their names, in SI units.
    numbers: dict[str, float]
    #: Unusual numbers, most severe first.
    findings: tuple[Finding, ...]
    text: str = field(repr=False)

    @staticmethod
    def _of(numbers: list[tuple[str, float, str, str]], findings: list[dict[str, Any]]) -> Check:
        found = tuple(record(Finding, one) for one in findings)
        width = max(len(name) for name, *_ in numbers)
        lines = [
            f"{name:<{width}}  {value:<12.6g} {unit:<5} {meaning}".rstrip()
            for name, value, unit, meaning in numbers
        ]
        text = "\n".join([*lines, *map(str, found)])
        return Check({name: value for name, value, *_ in numbers}, found, text)

    def __str__(self) -> str:
        return self.text
