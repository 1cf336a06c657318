"""The folder of a sweep: a manifest, and a file for each part."""

from __future__ import annotations

import hashlib
import json
import os
from pathlib import Path
from typing import Any

from asperity._sweep.part import fingerprint_of

MANIFEST = "manifest.json"


class Folder:
    """The folder of one sweep; ``Folder.of`` creates it."""

    def __init__(self, path: str | os.PathLike[str]) -> None:
        self.path = Path(path).absolute()
        manifest = self.path / MANIFEST
        if not manifest.is_file():
            raise ValueError(f"{self.path} has no {MANIFEST}: the folder of a sweep was required")
        #: Every input that the values depend on.
        self.identity: dict[str, Any] = json.loads(manifest.read_text(encoding="utf-8"))

    @staticmethod
    def of(path: str | os.PathLike[str], identity: dict[str, Any]) -> Folder:
        """A new folder, or that of the same sweep; ValueError for another sweep's."""
        folder = Path(path).absolute()
        folder.mkdir(parents=True, exist_ok=True)
        manifest = folder / MANIFEST
        if manifest.is_file():
            found = Folder(folder)
            found._refuse_another(json.loads(json.dumps(identity)))
        elif any(folder.glob("part-*.parquet")):
            raise ValueError(
                f"{folder} has parts and no {MANIFEST}: an empty folder or the folder of this sweep was "
                "required"
            )
        else:
            temporary = folder / f".{MANIFEST}.{os.getpid()}.tmp"
            temporary.write_text(json.dumps(identity, indent=2) + "\n", encoding="utf-8")
            temporary.replace(manifest)
            found = Folder(folder)
        found.clean()
        return found

    def clean(self) -> None:
        """Removes the temporary files of interrupted writers."""
        for left_over in self.path.glob(".part-*.parquet.*.tmp"):
            left_over.unlink(missing_ok=True)

    def _refuse_another(self, identity: dict[str, Any]) -> None:
        stored, given = self.identity, identity
        path: list[str] = []
        while stored != given:
            if not (isinstance(stored, dict) and isinstance(given, dict)):
                raise ValueError(
                    f"{self.path} holds another sweep: {'.'.join(path)} is {stored!r} there and "
                    f"{given!r} here; use another folder"
                )
            name = next(
                name for name in {**stored, **given} if stored.get(name) != given.get(name)
            )
            path.append(name)
            stored, given = stored.get(name), given.get(name)  # type: ignore[assignment]

    @property
    def fingerprint(self) -> str:
        """The mark of the parts of this sweep."""
        return hashlib.sha256(json.dumps(self.identity, sort_keys=True).encode()).hexdigest()

    @property
    def parts(self) -> int:
        """The number of parts."""
        return int(self.identity["parts"])

    def part(self, number: int) -> Path:
        """The file of a part."""
        return self.path / f"part-{number:05}.parquet"

    def missing(self) -> list[int]:
        """The missing and incomplete parts; ValueError for parts of another sweep."""
        missing = []
        for number in range(self.parts):
            path = self.part(number)
            found = fingerprint_of(path)
            if found is None:
                missing.append(number)
            elif found != self.fingerprint:
                raise ValueError(
                    f"{path} is not of the sweep of {MANIFEST}: remove the file and call sweep again"
                )
        return missing
