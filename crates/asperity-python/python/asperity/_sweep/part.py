"""One part of a sweep: columns of numbers, and the reasons of failed rows."""

from __future__ import annotations

import os
import uuid
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from asperity._asperity import quantities as column_names
from asperity._scene import Floats

FINGERPRINT = b"asperity.sweep"


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
    """Consecutive rows of a sweep."""

    first_row: int
    #: The inputs that vary, in SI units.
    inputs: dict[str, Floats]
    #: The quantities; values of failed rows are undefined.
    values: dict[str, Floats]
    #: The reasons of failed rows, by place in this part.
    errors: dict[int, str]

    def __len__(self) -> int:
        columns = self.inputs or self.values
        return len(next(iter(columns.values())))

    @property
    def answered(self) -> slice | np.ndarray[Any, np.dtype[np.bool_]]:
        """The rows with values."""
        if not self.errors:
            return slice(None)
        answered = np.ones(len(self), dtype=bool)
        answered[list(self.errors)] = False
        return answered

    def write(self, path: Path, fingerprint: str) -> None:
        """Writes a Parquet file, complete or not at all."""
        import pyarrow as pa
        import pyarrow.parquet as pq

        failed = np.zeros(len(self), dtype=bool)
        failed[list(self.errors)] = True
        columns: dict[str, Any] = {"row": np.arange(self.first_row, self.first_row + len(self))}
        columns |= self.inputs
        for quantity, values in self.values.items():
            columns[column_name(quantity)] = pa.array(values, mask=failed if self.errors else None)
        reasons = [self.errors.get(k) for k in range(len(self))] if self.errors else None
        error = pa.array(reasons, pa.string()) if reasons else pa.nulls(len(self), pa.string())
        columns["error"] = error
        table = pa.table(columns).replace_schema_metadata({FINGERPRINT: fingerprint})
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
    def read(path: Path, inputs: list[str], quantities: list[str]) -> Part:
        """Reads some of the columns."""
        import pyarrow.parquet as pq

        names = ["row", *inputs, *(column_name(q) for q in quantities), "error"]
        try:
            table = pq.read_table(path, columns=names)
        except (ValueError, OSError) as error:
            raise ValueError(
                f"{path} is no complete part of a sweep: call sweep with the same arguments to compute "
                f"it again ({error})"
            ) from error
        reasons = table["error"]
        errors: dict[int, str] = {}
        if reasons.null_count < len(reasons):
            errors = {k: reason for k, reason in enumerate(reasons.to_pylist()) if reason is not None}

        def column(name: str) -> Floats:
            return np.asarray(table[name].to_numpy(), dtype=np.float64)

        return Part(
            table["row"][0].as_py(),
            {name: column(name) for name in inputs},
            {quantity: column(column_name(quantity)) for quantity in quantities},
            errors,
        )


def column_name(quantity: str) -> str:
    """The column of a quantity, with its unit, as in ``Curve.to_dataframe``."""
    return column_names([quantity])[quantity]
