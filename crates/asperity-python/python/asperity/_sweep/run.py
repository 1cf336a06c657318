"""``sweep``: on all cores of this machine, or on the workers of a Dask cluster."""

from __future__ import annotations

import hashlib
import inspect
import os
import sys
import time
import warnings
from collections.abc import Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from importlib.metadata import version
from typing import TYPE_CHECKING, Any, TypeAlias

from asperity import _asperity
from asperity._arguments import Floats, checked_errors, checked_unit, placed, reason
from asperity._asperity import ContactWarning
from asperity._model import Model, as_model
from asperity._sweep.design import Design
from asperity._sweep.result import SweepResult
from asperity._sweep.space import Space
from asperity._sweep.store import Folder, Memory, Part, Run

if TYPE_CHECKING:
    from distributed import Client

#: Rows of a finished part, and the warnings of the model.
Finished: TypeAlias = tuple[int, list[str]]


@dataclass(frozen=True)
class Job:
    """A sweep: all that its parts depend on, sent to workers."""

    space: Space
    model: Model
    quantities: tuple[str, ...]
    design: Design
    rtol: float
    separation_unit: str
    errors: str
    version: str

    def draw(self, number: int) -> dict[str, Floats]:
        """The inputs that vary, of one part."""
        return self.space.columns(self.design.sample(self.design.parts[number]))

    def answer(
        self, number: int, inputs: dict[str, Floats], threads: int | None = None
    ) -> tuple[Part, list[str]]:
        """One part, and the warnings of the model."""
        rows, stop = self.space.rows(inputs, self.separation_unit), self.errors == "raise"
        asked = self.model, rows, self.quantities, self.rtol
        _, values, failures, messages = _asperity.answer(asked, "value", stop, threads, False)
        first = self.design.parts[number].start
        for k, error in failures:
            if stop or not isinstance(error, Exception):
                drawn = ", ".join(f"{name}={v[k]:.6g}" for name, v in inputs.items())
                raise placed(f"row {first + k} ({drawn}): ", error)
        errors = {k: reason(error) for k, error in failures}
        return Part.of(first, inputs, values, errors), messages

    def identity(self) -> dict[str, Any]:
        """Every input that the values depend on, for JSON."""
        import scipy

        drawn = self.design
        return {
            "asperity": self.version,
            "scipy": scipy.__version__,
            "model": _model_identity(self.model),
            "quantities": list(self.quantities),
            "design": drawn.kind,
            "n": drawn.n,
            "seed": drawn.seed,
            "rows": drawn.rows,
            "parts": len(drawn.parts),
            "part_size": drawn.part_size,
            "rtol": self.rtol,
            "separation_unit": self.separation_unit,
            "space": self.space.identity(),
        }


def _model_identity(model: Model) -> dict[str, Any]:
    definition = model._definition
    if isinstance(definition, str):
        return {"id": definition, "options": model.options}
    name = f"{getattr(definition, '__module__', '')}.{getattr(definition, '__qualname__', repr(definition))}"
    try:
        source = inspect.getsource(definition)
    except (OSError, TypeError):
        return {"class": name}
    return {"class": name, "source": hashlib.sha256(source.encode()).hexdigest()}


def sweep(
    space: Space,
    model: str | Model,
    quantities: str | Sequence[str] = ("force",),
    n: int = 2**14,
    seed: int = 0,
    *,
    design: str = "sobol",
    rtol: float = 1e-10,
    separation_unit: str = "asperity_height_std",
    errors: str = "raise",
    folder: str | os.PathLike[str] | None = None,
    client: Client | None = None,
    part_size: int = 2**17,
    progress: bool | None = None,
) -> SweepResult:
    """Quantities on scenes drawn from a space; needs the extra ``asperity[sweep]``.

    Parameters
    ----------
    space : Space
        The scene, and the distributions of its inputs.
    model : str or Model
        An id, or a model of ``asperity.model``.
    quantities : str or sequence of str
        As in ``Model.solve``.
    n : int
        The number of rows. A Sobol sequence is best balanced for a power of two. Saltelli's scheme
        rounds up to N (D + 2) rows ("saltelli") or N (2 D + 2) rows ("saltelli-pairs"), with N a
        power of two and D inputs that vary.
    seed : int
        The seed of the draws: the same digits on any number of cores and workers.
    design : "sobol", "latin-hypercube" ("lhs"), "saltelli" or "saltelli-pairs"
        Scrambled Sobol points; Latin hypercubes, one for each part; or Saltelli's scheme for
        ``SweepResult.sensitivity``, with "-pairs" also for pairs of inputs.
    rtol : float
        Relative tolerance of every value, from 1e-15 to 0.1.
    separation_unit : "asperity_height_std" or "m"
        Unit of the separations of the space.
    errors : "raise" or "mask"
        The treatment of a refused row, as with a negative hardness: it raises with its number,
        inputs and reason; or its values are masked, and ``SweepResult.failures`` and the column
        ``error`` have the reason.
    folder : path, optional
        A folder for the parts as Parquet files. Called again with the same arguments, an interrupted
        sweep computes the missing and incomplete parts; the folder of another sweep is an error.
        Without a folder the rows stay in memory. Only one run may use a folder at a time.
    client : distributed.Client, optional
        A Dask cluster whose workers evaluate the parts, one on each thread. The folder must have the
        same path on all workers.
    part_size : int
        Most rows of a part. A worker has one part in memory, about 1 kB for each row.
    progress : bool, optional
        Shows the progress in a line on stderr; by default on a terminal only.

    Examples
    --------
    >>> import asperity, scipy.stats
    >>> scene = asperity.Scene.parse(asperity.template())
    >>> space = asperity.Space(scene, separation=(1.0, 3.0), hardness=scipy.stats.norm(2e9, 1e8))
    >>> result = asperity.sweep(space, "ke", n=1024, seed=1)
    >>> result
    <asperity.SweepResult of KE: force on 1024 rows, separation and hardness vary>
    >>> low, median, high = result.quantile("force", [0.05, 0.5, 0.95])
    >>> bool(low < median < result.mean("force") < high)
    True
    """
    if client is not None and folder is None:
        raise ValueError("a client was given without a folder: its workers write their parts to a folder")
    if not isinstance(space, Space):
        raise TypeError(f"space is {space!r}: an asperity.Space was required")
    drawn = Design(design, n, seed, len(space.names), part_size)
    job = Job(
        space,
        as_model(model),
        tuple(_asperity.quantities(quantities)),
        drawn,
        rtol,
        checked_unit(separation_unit),
        checked_errors(errors),
        version("asperity"),
    )
    identity, run = job.identity(), Run()
    stored = Memory(identity) if folder is None else Folder.of(folder, identity)
    missing = stored.missing()
    done = before = drawn.rows - sum(len(drawn.parts[number]) for number in missing)
    shown = sys.stderr.isatty() if progress is None else progress
    found = _here(job, stored, missing)
    if client is not None and isinstance(stored, Folder):
        found = _on_cluster(client, job, stored, missing)
    begun = time.perf_counter()
    for rows, messages in found:
        for message in messages:
            # Python shows equal messages once.
            warnings.warn(message, ContactWarning, stacklevel=2)
        run.rows, run.seconds, done = run.rows + rows, time.perf_counter() - begun, done + rows
        if shown:
            run.show(done, drawn.rows)
    result = SweepResult(stored, run)
    if errors == "raise" and before:
        for row, why in result.failures():
            raise ValueError(f"row {row} failed in an earlier run: {why}")
    return result


def _here(job: Job, stored: Memory, numbers: list[int]) -> Iterator[Finished]:
    """Parts in order; the inputs of the next part are drawn while one is evaluated."""
    with ThreadPoolExecutor(1) as pool:
        draws = (pool.submit(job.draw, number) for number in numbers)
        drawn: Any = next(draws, None)
        for number in numbers:
            columns, drawn = drawn.result(), next(draws, drawn)
            part, messages = job.answer(number, columns)
            stored.put(number, part)
            yield len(part), messages


def write_part(job: Job, path: str, number: int) -> Finished:
    """Evaluates and writes a part on a worker."""
    import distributed

    worker = str(distributed.get_worker().address)
    if version("asperity") != job.version:
        raise RuntimeError(
            f"worker {worker} has asperity {version('asperity')}: {job.version} was required"
        )
    try:
        stored = Folder(path)
    except ValueError as error:
        raise ValueError(f"worker {worker}: {error}, shared by all workers") from None
    # One thread for each part: the other threads of the worker have other parts.
    part, messages = job.answer(number, job.draw(number), threads=1)
    stored.put(number, part)
    return len(part), messages


def _on_cluster(
    client: Client, job: Job, stored: Folder, missing: list[int]
) -> Iterator[Finished]:
    from distributed import as_completed

    path = str(stored.path)
    # Not pure: the scheduler must not reuse the result of a part whose file is gone.
    futures = [client.submit(write_part, job, path, number, pure=False) for number in missing]
    try:
        for future in as_completed(futures):
            yield future.result()
            future.release()
    finally:
        client.cancel(futures)
        stored.clean()
    lost = stored.missing()
    if lost:
        raise ValueError(
            f"parts {lost} are missing: workers wrote them to another folder at {path}; a folder shared by "
            "all workers was required"
        )
