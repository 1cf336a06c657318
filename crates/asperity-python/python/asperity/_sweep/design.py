"""Points in the unit cube, drawn part by part."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from asperity._arguments import Floats

DESIGNS = ("sobol", "latin-hypercube", "saltelli", "saltelli-pairs")
# Bits of a coordinate of scipy's Sobol points: 2^BITS is their number.
BITS = 30


@dataclass(frozen=True)
class Design:
    """``rows`` points in ``dimensions`` dimensions, in parts that are drawn independently."""

    kind: str
    n: int
    seed: int
    dimensions: int
    part_size: int

    def __post_init__(self) -> None:
        for name, least in {"n": 1, "seed": 0, "part_size": 1}.items():
            given = getattr(self, name)
            # Also an integer of NumPy.
            if isinstance(given, bool) or not isinstance(given, int | np.integer) or given < least:
                raise ValueError(f"{name} is {given!r}: an integer from {least} was required")
            object.__setattr__(self, name, int(given))
        if self.kind == "lhs":
            object.__setattr__(self, "kind", "latin-hypercube")
        if self.kind not in DESIGNS:
            raise ValueError(f"design is {self.kind!r}: one of {', '.join(DESIGNS)} was required")
        if self.kind != "latin-hypercube" and self.points > 2**BITS:
            raise ValueError(f"n is {self.n}: at most 2^{BITS} Sobol points were required")

    @property
    def block(self) -> int:
        """Rows of one base point of Saltelli's scheme; else 1."""
        d = self.dimensions
        return {"saltelli": d + 2, "saltelli-pairs": 2 * d + 2}.get(self.kind, 1)

    @property
    def points(self) -> int:
        """The number of drawn points: for Saltelli's scheme a power of two, to be balanced."""
        if self.block == 1:
            return self.n
        return 1 << (math.ceil(self.n / self.block) - 1).bit_length()

    @property
    def rows(self) -> int:
        """The number of rows: ``n``, rounded up for Saltelli's scheme."""
        return self.points * self.block

    @property
    def part_rows(self) -> int:
        """Rows of a part: whole blocks only."""
        return max(1, self.part_size // self.block) * self.block

    @property
    def parts(self) -> list[range]:
        """The rows of each part."""
        rows = range(self.rows)
        return [rows[first : first + self.part_rows] for first in rows[:: self.part_rows]]

    def sample(self, rows: range) -> Floats:
        """The rows of one part, strictly between 0 and 1."""
        from scipy.stats import qmc

        start, count = rows.start // self.block, len(rows) // self.block
        if self.kind == "latin-hypercube":
            # Every part is a hypercube: one for all rows cannot be drawn part by part.
            rng = np.random.default_rng([self.seed, rows.start // self.part_rows])
            sample = qmc.LatinHypercube(self.dimensions, rng=rng).random(count)
            return np.asarray(np.minimum(sample, 1.0 - 2.0**-53))
        dimensions = self.dimensions * (1 if self.block == 1 else 2)
        sobol = qmc.Sobol(dimensions, bits=BITS, rng=np.random.default_rng(self.seed))
        if start:
            base = sobol.fast_forward(start).random(count)
        else:
            # scipy warns of a first draw that is no power of two.
            base = sobol.random_base2((count - 1).bit_length())[:count]
        # Moved to the middle of their cells: 0 has no finite quantile.
        return self._crossed(base + 2.0 ** -(BITS + 1))

    def _crossed(self, base: Floats) -> Floats:
        """Rows A, A with each column of B, (B with each column of A,) B: the order of SALib."""
        if self.block == 1:
            return base
        d = self.dimensions
        a, b = base[:, None, :d], base[:, None, d:]
        one = np.eye(d, dtype=bool)[None]
        rows = [a, np.where(one, b, a), *([np.where(one, a, b)] if self.block > d + 2 else []), b]
        return np.concatenate(rows, axis=1).reshape(-1, d)
