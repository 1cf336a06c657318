"""One part of a sweep: a table of numbers, with the reasons of failed rows."""

from __future__ import annotations

import os
import uuid
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from asperity._asperity import quantities as column_names
from asperity._scene import Floats

FINGERPRINT = b"asperity.sweep"


def column_name(quantity: str) -> str:
    """The column of a quantity, with its unit, as in ``Curve.to_dataframe``."""
    return column_names([quantity])[quantity]


def fingerprint_of(path: Path) -> str | None:
    """The fingerprint of the sweep of a part; None without a complete Parquet file."""
    import pyarrow.parquet as pq

    if not path.is_file():
        return None
    try:
        metadata = pq.read_schema(path).metadata or {}
    except (ValueError, OSError) as error:
        # Errors of Arrow about a truncated file have no errno, errors of the system have one.
        if getattr(error, "errno", None) is not None:
            raise
        return None
    return str(metadata.get(FINGERPRINT, b""), "utf-8")


@dataclass(frozen=True)
class Part:
    """Consecutive rows of a sweep: an Arrow table with the columns ``row``, those of the inputs that
    vary and of the quantities, null for failed rows, and ``error``."""

    table: Any
    _inputs: tuple[str, ...]
    _quantities: tuple[str, ...]

    @staticmethod
    def of(
        first_row: int, inputs: dict[str, Floats], values: dict[str, Floats], errors: dict[int, str]
    ) -> Part:
        """A part of columns in SI units, with the reasons of failed rows by place."""
        import pyarrow as pa

        rows = np.arange(first_row, first_row + len(next(iter(inputs.values()))))
        failed = np.isin(rows - first_row, list(errors)) if errors else None
        columns = {"row": rows, **inputs}
        columns |= {column_name(q): pa.array(v, mask=failed) for q, v in values.items()}
        reasons = map(errors.get, range(len(rows))) if errors else pa.nulls(len(rows))
        columns["error"] = pa.array(reasons, pa.string())
        return Part(pa.table(columns), tuple(inputs), tuple(values))

    def __len__(self) -> int:
        return int(self.table.num_rows)

    @property
    def first_row(self) -> int:
        """The number of the first row."""
        return int(self.table["row"][0].as_py())

    @property
    def inputs(self) -> dict[str, Floats]:
        """The inputs that vary, in SI units."""
        return {name: self.table[name].to_numpy() for name in self._inputs}

    @property
    def values(self) -> dict[str, Floats]:
        """The quantities; NaN for failed rows."""
        return {name: self.table[column_name(name)].to_numpy() for name in self._quantities}

    @property
    def errors(self) -> dict[int, str]:
        """The reasons of failed rows, by place in this part."""
        reasons = self.table["error"]
        if reasons.null_count == len(reasons):
            return {}
        return {k: reason for k, reason in enumerate(reasons.to_pylist()) if reason is not None}

    def write(self, path: Path, fingerprint: str) -> None:
        """Writes a Parquet file, complete or not at all."""
        import pyarrow.parquet as pq

        table = self.table.replace_schema_metadata({FINGERPRINT: fingerprint})
        temporary = path.with_name(f".{path.name}.{uuid.uuid4().hex}.tmp")
        try:
            with temporary.open("wb") as file:
                # Random doubles neither compress nor repeat.
                pq.write_table(table, file, compression="none", use_dictionary=False)
                file.flush()
                os.fsync(file.fileno())
            temporary.replace(path)
        finally:
            temporary.unlink(missing_ok=True)

    @staticmethod
    def read(path: Path, inputs: Iterable[str], quantities: Iterable[str]) -> Part:
        """Reads some of the columns."""
        import pyarrow.parquet as pq

        inputs, quantities = tuple(inputs), tuple(quantities)
        names = ["row", *inputs, *map(column_name, quantities), "error"]
        try:
            return Part(pq.read_table(path, columns=names), inputs, quantities)
        except (ValueError, OSError) as error:
            raise ValueError(
                f"{path} is no complete part of a sweep: call sweep with the same arguments to compute "
                f"it again ({error})"
            ) from error
