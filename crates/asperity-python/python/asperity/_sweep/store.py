"""What a sweep keeps: its parts, in memory or in a folder, and its progress and time."""

from __future__ import annotations

import hashlib
import json
import os
import sys
import uuid
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from asperity._arguments import Floats
from asperity._asperity import quantities as column_names

FINGERPRINT = b"asperity.sweep"
MANIFEST = "manifest.json"


def column_name(quantity: str) -> str:
    """The column of a quantity, with its unit, as in ``Curve.to_dataframe``."""
    return column_names([quantity])[quantity]


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


class Memory:
    """The parts of a sweep in memory."""

    def __init__(self, identity: dict[str, Any]) -> None:
        #: Every input that the values depend on.
        self.identity = identity
        self._held: dict[int, Part] = {}

    @property
    def parts(self) -> int:
        """The number of parts."""
        return int(self.identity["parts"])

    def missing(self) -> list[int]:
        """The missing parts."""
        return [number for number in range(self.parts) if number not in self._held]

    def put(self, number: int, part: Part) -> None:
        """Keeps a part."""
        self._held[number] = part

    def get(self, number: int, inputs: Iterable[str], quantities: Iterable[str]) -> Part:
        """A part with these columns, or with more."""
        return self._held[number]


class Folder(Memory):
    """The folder of one sweep: a manifest, and a Parquet file for each part."""

    def __init__(self, path: str | os.PathLike[str]) -> None:
        self.path = Path(path).absolute()
        manifest = self.path / MANIFEST
        if not manifest.is_file():
            raise ValueError(f"{self.path} has no {MANIFEST}: the folder of a sweep was required")
        super().__init__(json.loads(manifest.read_text(encoding="utf-8")))
        #: The mark of the parts of this sweep.
        self.fingerprint = hashlib.sha256(
            json.dumps(self.identity, sort_keys=True).encode()
        ).hexdigest()

    @staticmethod
    def of(path: str | os.PathLike[str], identity: dict[str, Any]) -> Folder:
        """A new folder, or that of the same sweep; ValueError for another sweep's."""
        folder = Path(path).absolute()
        folder.mkdir(parents=True, exist_ok=True)
        manifest = folder / MANIFEST
        if not manifest.is_file():
            if any(folder.glob("part-*.parquet")):
                raise ValueError(
                    f"{folder} has parts and no {MANIFEST}: an empty folder or the folder of this sweep "
                    "was required"
                )
            temporary = folder / f".{MANIFEST}.{os.getpid()}.tmp"
            temporary.write_text(json.dumps(identity, indent=2) + "\n", encoding="utf-8")
            temporary.replace(manifest)
        found = Folder(folder)
        found._refuse_another(found.identity, json.loads(json.dumps(identity)))
        found.clean()
        return found

    def _refuse_another(self, stored: Any, given: Any, path: tuple[str, ...] = ()) -> None:
        if stored == given:
            return
        if not (isinstance(stored, dict) and isinstance(given, dict)):
            raise ValueError(
                f"{self.path} holds another sweep: {'.'.join(path)} is {stored!r} there and "
                f"{given!r} here; use another folder"
            )
        for name in {**stored, **given}:
            self._refuse_another(stored.get(name), given.get(name), (*path, name))

    def clean(self) -> None:
        """Removes the temporary files of interrupted writers."""
        for left_over in self.path.glob(".part-*.parquet.*.tmp"):
            left_over.unlink(missing_ok=True)

    def file(self, number: int) -> Path:
        """The file of a part."""
        return self.path / f"part-{number:05}.parquet"

    def missing(self) -> list[int]:
        """The missing and incomplete parts; ValueError for parts of another sweep."""
        return [number for number in range(self.parts) if not self._has(number)]

    def _has(self, number: int) -> bool:
        import pyarrow.parquet as pq

        path = self.file(number)
        if not path.is_file():
            return False
        try:
            metadata = pq.read_schema(path).metadata or {}
        except (ValueError, OSError) as error:
            # Errors of Arrow about a truncated file have no errno, errors of the system have one.
            if getattr(error, "errno", None) is not None:
                raise
            return False
        if metadata.get(FINGERPRINT, b"") != self.fingerprint.encode():
            raise ValueError(
                f"{path} is not of the sweep of {MANIFEST}: remove the file and call sweep again"
            )
        return True

    def put(self, number: int, part: Part) -> None:
        """Writes the file of a part, complete or not at all."""
        import pyarrow.parquet as pq

        path = self.file(number)
        table = part.table.replace_schema_metadata({FINGERPRINT: self.fingerprint})
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

    def get(self, number: int, inputs: Iterable[str], quantities: Iterable[str]) -> Part:
        """Reads some of the columns of a part."""
        import pyarrow.parquet as pq

        path, inputs, quantities = self.file(number), tuple(inputs), tuple(quantities)
        names = ["row", *inputs, *map(column_name, quantities), "error"]
        try:
            return Part(pq.read_table(path, columns=names), inputs, quantities)
        except (ValueError, OSError) as error:
            raise ValueError(
                f"{path} is no complete part of a sweep: call sweep with the same arguments to compute "
                f"it again ({error})"
            ) from error


@dataclass
class Run:
    """Rows and time of one call of ``sweep``; earlier calls do not count."""

    #: Evaluated rows.
    rows: int = 0
    #: Wall-clock time [s].
    seconds: float = 0.0

    @property
    def rows_per_second(self) -> float:
        """Rows over wall-clock time."""
        return self.rows / self.seconds if self.seconds else 0.0

    def __str__(self) -> str:
        return f"{self.rows} rows in {self.seconds:.1f} s, {self.rows_per_second:.3g} rows/s"

    def show(self, done: int, rows: int) -> None:
        """A line on stderr: how many of all rows are done."""
        left = (rows - done) / self.rows_per_second
        text = (
            f"sweep: {done} of {rows} rows ({100 * done / rows:.0f} %), "
            f"{self.rows_per_second:.3g} rows/s, {left:.0f} s left "
        )
        print(f"\r{text}", end="\n" if done == rows else "", file=sys.stderr, flush=True)
