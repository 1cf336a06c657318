"""``sweep``: here on all cores, or on the workers of a Dask cluster."""

from __future__ import annotations

import os
import warnings
from collections.abc import Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from importlib.metadata import version
from typing import TYPE_CHECKING

from asperity._arguments import checked_errors, checked_unit, quantity_names
from asperity._asperity import ContactWarning
from asperity._model import Model
from asperity._sweep.design import Design, integer
from asperity._sweep.folder import Folder
from asperity._sweep.job import Job
from asperity._sweep.part import Part
from asperity._sweep.progress import Progress, Run, peak_memory
from asperity._sweep.result import SweepResult
from asperity._sweep.space import Space

if TYPE_CHECKING:
    from distributed import Client


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
    """Quantities on scenes that are drawn from a space; needs the extra ``asperity[sweep]``.

    Parameters
    ----------
    space : Space
        The scene, and the distributions of its inputs.
    model : str or Model
        An id, or what ``asperity.model`` made.
    quantities : str or sequence of str
        Any that ``Model.solve`` knows.
    n : int
        Rows. A Sobol sequence is best balanced where this is a power of two. For Saltelli's scheme
        it is rounded up to N (D + 2) rows ("saltelli") or N (2 D + 2) rows ("saltelli-pairs"), N a
        power of two, with D inputs that vary.
    seed : int
        The same seed, the same digits, on any number of cores and workers.
    design : "sobol", "latin-hypercube", "saltelli" or "saltelli-pairs"
        Scrambled Sobol points; Latin hypercubes, one for each part; or Saltelli's scheme, which
        ``SweepResult.sensitivity`` needs, for pairs of inputs, too.
    rtol : float
        Relative tolerance of every value, from 1e-15 to 0.1.
    separation_unit : "asperity_height_std" or "m"
        Unit of the separations of the space.
    errors : "raise" or "mask"
        Whether a refused row, as with a negative hardness, ends the sweep with its number, inputs
        and reason; or the row's values are masked, and its reason is in ``SweepResult.failures`` and
        in the column ``error``.
    folder : path, optional
        Where parts are written as Parquet files. Called again with the same arguments, an interrupted
        sweep computes the parts that are missing or incomplete; a folder of another sweep is
        refused. Without a folder the rows stay in memory. One run at a time.
    client : distributed.Client, optional
        A Dask cluster, whose workers evaluate the parts, each thread of a worker one at a time.
        They must see the folder under its path.
    part_size : int
        Most rows of a part: what a worker has in memory at once, some 1 kB for each.
    progress : bool, optional
        Whether a line on stderr shows the progress; by default on a terminal.

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
        raise ValueError("a client was given without a folder: its workers write their parts there")
    if not isinstance(space, Space):
        raise TypeError(f"space is {space!r}: an asperity.Space was required")
    job = Job(
        space,
        model if isinstance(model, Model) else Model(model),
        tuple(quantity_names(quantities)),
        Design(
            design,
            integer("n", n, 1),
            integer("seed", seed, 0),
            len(space.names),
            integer("part_size", part_size, 1),
        ),
        rtol,
        checked_unit(separation_unit),
        checked_errors(errors),
        version("asperity"),
    )
    run, rows = Run(), job.design.rows
    if folder is None:
        memory: list[Part] = []
        with Progress(run, rows, 0, progress) as shown:
            for _, part, said in _ahead(job, list(range(job.design.parts))):
                memory.append(part)
                _pass_on(said)
                shown.add(len(part), "this process", peak_memory())
        return SweepResult(job.identity(), memory, run)
    there = Folder.of(folder, job.identity())
    missing = there.missing()
    done = rows - sum(job.design.rows_of(number) for number in missing)
    with Progress(run, rows, done, progress) as shown:
        if client is None:
            for number, part, said in _ahead(job, missing):
                part.write(there.part(number), there.fingerprint)
                _pass_on(said)
                shown.add(len(part), "this process", peak_memory())
        else:
            _on_cluster(client, job, there, missing, shown)
    result = SweepResult(there.identity, there, run)
    if errors == "raise" and done:
        for row, why in result.failures():
            raise ValueError(f"row {row} failed in an earlier run: {why}")
    return result


def _ahead(job: Job, numbers: list[int]) -> Iterator[tuple[int, Part, list[str]]]:
    """Parts in order; while one is evaluated, the next one's inputs are drawn."""
    with ThreadPoolExecutor(1) as pool:
        drawn = [pool.submit(job.draw, number) for number in numbers[:1]]
        for place, number in enumerate(numbers):
            columns = drawn.pop().result()
            drawn += [pool.submit(job.draw, following) for following in numbers[place + 1 :][:1]]
            yield number, *job.answer(number, columns)


def write_part(job: Job, path: str, number: int) -> tuple[int, str, int | None, list[str]]:
    """What a worker of a cluster does: its rows, its name, its memory and warnings."""
    import distributed

    worker = str(distributed.get_worker().address)
    if version("asperity") != job.version:
        raise RuntimeError(
            f"worker {worker} has asperity {version('asperity')}: {job.version} was required"
        )
    try:
        there = Folder(path)
    except ValueError as error:
        raise ValueError(f"worker {worker}: {error}, which all workers share") from None
    # A thread of the worker for a part: other parts have the others.
    part, said = job.answer(number, job.draw(number), threads=1)
    part.write(there.part(number), there.fingerprint)
    return len(part), worker, peak_memory(), said


def _on_cluster(client: Client, job: Job, there: Folder, missing: list[int], shown: Progress) -> None:
    from distributed import as_completed

    path = str(there.path)
    # Not pure: a part that is gone is made again, whatever the scheduler remembers of it.
    futures = [client.submit(write_part, job, path, number, pure=False) for number in missing]
    try:
        for future in as_completed(futures):
            rows, worker, memory, said = future.result()
            _pass_on(said)
            shown.add(rows, worker, memory)
            future.release()
    finally:
        client.cancel(futures)
        there.clean()
    lost = there.missing()
    if lost:
        raise ValueError(
            f"parts {lost} were written where {path} is another folder: one that all workers share "
            "was required"
        )


def _pass_on(said: list[str]) -> None:
    for words in said:
        # The same words twice are shown once: Python's own rule.
        warnings.warn(words, ContactWarning, stacklevel=3)
