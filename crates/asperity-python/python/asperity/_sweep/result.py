"""Results of a sweep."""

from __future__ import annotations

import os
import warnings
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from itertools import combinations
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from asperity._arguments import Floats, floats
from asperity._asperity import ContactWarning
from asperity._sweep.store import Folder, Memory, Part, Run, column_name

if TYPE_CHECKING:
    import pandas as pd


@dataclass(frozen=True)
class Sensitivity:
    """Sobol indices of one quantity: shares of its variance, with 95 % half-widths (``_conf``)."""

    #: The share of each input alone.
    first: dict[str, float]
    first_conf: dict[str, float]
    #: The share of each input alone and together with others.
    total: dict[str, float]
    total_conf: dict[str, float]
    #: The share of two inputs only together; for the design "saltelli-pairs".
    second: dict[tuple[str, str], float] = field(default_factory=dict)
    second_conf: dict[tuple[str, str], float] = field(default_factory=dict)

    def to_dataframe(self) -> pd.DataFrame:
        """A row for each input, without the second order; needs pandas."""
        import pandas as pd

        columns = ("first", "first_conf", "total", "total_conf")
        return pd.DataFrame({name: getattr(self, name) for name in columns})


class SweepResult:
    """Rows of a sweep, in memory or in a folder; made by ``sweep`` and ``read_sweep``.

    Statistics are without failed rows, which cause a warning; one column is in memory as a whole.

    >>> import asperity
    >>> scene = asperity.Scene.parse(asperity.template())
    >>> space = asperity.Space(scene, separation=2.0, hardness=(1e9, 3e9), nominal_area=(0.9e-4, 1.1e-4))
    >>> result = asperity.sweep(space, "ke", "force", n=2048, design="saltelli")
    >>> result.rows, round(result.mean("force")), round(result.std("force"))
    (2048, 213, 30)
    >>> {name: round(share, 2) for name, share in result.sensitivity("force").first.items()}
    {'hardness': 0.83, 'nominal_area': 0.17}
    """

    def __init__(self, stored: Memory, run: Run) -> None:
        self._identity, self._stored = stored.identity, stored
        #: Rows and seconds of the call of ``sweep``.
        self.run = run
        inputs = self._identity["space"]["inputs"]
        #: The inputs that vary.
        self.inputs: tuple[str, ...] = tuple(n for n, i in inputs.items() if "quantiles" in i)
        #: The requested quantities.
        self.quantities: tuple[str, ...] = tuple(self._identity["quantities"])
        #: The number of rows, with failed ones.
        self.rows: int = self._identity["rows"]

    def _name(self, column: str) -> str:
        """The name of a column; a quantity also with underscores, as an attribute of a curve."""
        dashed = column.replace("_", "-")
        return dashed if column not in self.inputs and dashed in self.quantities else column

    def parts(self, *columns: str) -> Iterator[Part]:
        """The parts in order, one in memory at a time, with all columns or the named ones."""
        known = (*self.inputs, *self.quantities)
        wanted = tuple(map(self._name, columns)) or known
        for name in wanted:
            if name not in known:
                raise KeyError(f"{name} is no column: one of {', '.join(known)} was required")
        inputs = [name for name in self.inputs if name in wanted]
        quantities = [name for name in self.quantities if name in wanted]
        for number in range(self._stored.parts):
            yield self._stored.get(number, inputs, quantities)

    def __getitem__(self, column: str) -> Floats:
        """A whole column, of an input that varies or a quantity; masked for failed rows."""
        column = self._name(column)
        parts = list(self.parts(column))
        head = column if column in self.inputs else column_name(column)
        whole: Floats = np.concatenate([part.table[head].to_numpy() for part in parts])
        failed = any(part.table[head].null_count for part in parts)
        return np.ma.masked_invalid(whole) if failed else whole

    def failures(self) -> Iterator[tuple[int, str]]:
        """The numbers of failed rows with the reasons."""
        for part in self.parts(self.quantities[0]):
            for place, reason in part.errors.items():
                yield part.first_row + place, reason

    def _values(self, quantity: str) -> Floats:
        """The values of a quantity without failed rows."""
        quantity, names = self._name(quantity), ", ".join(self.quantities)
        if quantity not in self.quantities:
            raise KeyError(f"{quantity} was not requested: add it to the quantities ({names})")
        values: Floats = np.ma.compressed(self[quantity])
        return values

    def _sample(self, quantity: str) -> Floats:
        """The same, with a warning about failed rows."""
        values = self._values(quantity)
        if len(values) < 2:
            raise ValueError(f"{len(values)} of {self.rows} rows have values: at least 2 were required")
        if len(values) < self.rows:
            message = (
                f"{self.rows - len(values)} of {self.rows} rows failed and are left out: failures() has "
                "the reasons"
            )
            warnings.warn(message, ContactWarning, stacklevel=3)
        return values

    def mean(self, quantity: str) -> float:
        """The mean of a quantity."""
        return float(np.mean(self._sample(quantity)))

    def std(self, quantity: str) -> float:
        """The standard deviation of a quantity."""
        return float(np.std(self._sample(quantity), ddof=1))

    def quantile(self, quantity: str, q: npt.ArrayLike) -> Floats:
        """Quantiles of a quantity at probabilities ``q``, by the method of ``numpy.quantile``."""
        probabilities = floats(q, "q")
        if not ((probabilities >= 0.0) & (probabilities <= 1.0)).all():
            raise ValueError(f"q is {probabilities}: probabilities from 0 to 1 were required")
        return np.asarray(np.quantile(self._sample(quantity), probabilities))

    def sensitivity(
        self,
        quantity: str,
        transform: Callable[[Floats], Floats] | None = None,
        resamples: int = 100,
    ) -> Sensitivity:
        """Sobol indices of a quantity, by SALib; for the designs of Saltelli.

        ``transform`` is applied to the values first: use ``numpy.log`` for a quantity that spans
        decades, or its largest values dominate. The half-widths are from ``resamples`` resamples.
        """
        from SALib.analyze import sobol

        design = self._identity["design"]
        if not design.startswith("saltelli"):
            raise ValueError(
                f"the design is {design!r}: 'saltelli' or 'saltelli-pairs' was required for indices"
            )
        values = self._values(quantity)
        if len(values) < self.rows:
            raise ValueError(
                f"{self.rows - len(values)} of {self.rows} rows failed: every row is required for "
                "indices"
            )
        values = values if transform is None else floats(transform(values), "the transform")
        if not np.isfinite(values).all():
            raise ValueError("the transform has values that are not finite: finite numbers were required")
        if np.ptp(values) == 0.0:
            raise ValueError(f"{quantity} does not vary: indices are shares of its variance")
        pairs = design == "saltelli-pairs"
        found = sobol.analyze(
            {"num_vars": len(self.inputs), "names": list(self.inputs)},
            values,
            calc_second_order=pairs,
            num_resamples=resamples,
            seed=self._identity["seed"],
        )
        both = list(combinations(range(len(self.inputs)), 2)) if pairs else []

        def of(key: str) -> dict[str, float]:
            return dict(zip(self.inputs, found[key].tolist(), strict=True))

        def of_two(key: str) -> dict[tuple[str, str], float]:
            return {(self.inputs[j], self.inputs[k]): float(found[key][j, k]) for j, k in both}

        single = of("S1"), of("S1_conf"), of("ST"), of("ST_conf")
        return Sensitivity(*single, of_two("S2"), of_two("S2_conf"))

    def to_dataframe(self) -> pd.DataFrame:
        """All rows, with units in the heads of quantities, and a column ``error`` if rows failed."""
        import pyarrow as pa

        table = pa.concat_tables(part.table for part in self.parts()).drop_columns("row")
        if table["error"].null_count == len(table):
            table = table.drop_columns("error")
        return table.to_pandas()

    def __repr__(self) -> str:
        names = " and ".join(filter(None, [", ".join(self.inputs[:-1]), self.inputs[-1]]))
        model = self._identity["model"]
        name = model["id"].upper() if "id" in model else model["class"]
        return (
            f"<asperity.SweepResult of {name}: {', '.join(self.quantities)} on {self.rows} rows, "
            f"{names} {'vary' if len(self.inputs) > 1 else 'varies'}>"
        )


def read_sweep(folder: str | os.PathLike[str]) -> SweepResult:
    """The result in a folder of ``sweep``; ValueError if parts are missing."""
    stored = Folder(folder)
    missing = stored.missing()
    if missing:
        first = stored.file(missing[0])
        state = "incomplete" if first.is_file() else "missing"
        raise ValueError(
            f"{stored.path} has {stored.parts - len(missing)} of {stored.parts} parts, {first.name} is "
            f"{state}: call sweep with the same arguments to compute the others"
        )
    return SweepResult(stored, Run())
