"""Findings, and tables with findings."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from asperity._arguments import Floats, record


@dataclass(frozen=True)
class Finding:
    """An unusual number of a scene or an answer."""

    #: The kind of finding: ``unusual-size``, ``crowded``.
    code: str
    #: ``refusal``: there is no value; ``warning``; ``note``.
    severity: str
    #: The name of the number in scene files.
    field: str
    #: Its value, in SI units; None if there is none.
    value: float | None
    #: The usual range; None for an open end.
    usual: tuple[float | None, float | None]
    #: The text with the advice.
    message: str

    def __str__(self) -> str:
        return f"{self.severity}[{self.code}]: {self.message}"


@dataclass(frozen=True, eq=False)
class Table:
    """The table of an answer, as the program prints it; ``print`` it.

    A column is an item: ``table["area_fraction"]``; ``pandas.DataFrame(table.columns)`` has all.
    """

    #: Columns by their heads, which end with the unit: numbers, NaN for blanks, or words.
    columns: dict[str, Floats | list[str]]
    #: What there is to say about them, with the reasons of blanks.
    findings: tuple[Finding, ...]
    #: Results that no column has, a sentence each, such as what stands behind an answer.
    results: tuple[str, ...]

    def __init__(
        self, columns: dict[str, Any], findings: list[dict[str, Any]], results: list[str]
    ) -> None:
        found = tuple(record(Finding, one) for one in findings)
        vars(self).update(columns=columns, findings=found, results=tuple(results))

    def __getitem__(self, head: str) -> Any:
        return self.columns[head]

    @property
    def numbers(self) -> dict[str, float]:
        """The column ``value`` by the column ``name``, as of a check."""
        return dict(zip(self["name"], self["value"].tolist(), strict=True))

    def __len__(self) -> int:
        return len(next(iter(self.columns.values())))

    def __str__(self) -> str:
        columns = [[head, *map(_cell, column)] for head, column in self.columns.items()]
        lines = aligned(zip(*columns, strict=True))
        return "\n".join([*lines, *map(str, self.findings), *self.results])


def aligned(rows: Iterable[Sequence[str]]) -> list[str]:
    """Rows of cells as lines, with columns under each other."""
    rows = list(rows)
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    lines = (zip(row, widths, strict=True) for row in rows)
    return ["  ".join(f"{cell:<{width}}" for cell, width in line).rstrip() for line in lines]


def _cell(value: Any) -> str:
    if isinstance(value, str):
        return value
    return "" if np.isnan(value) else f"{value:.4g}"
