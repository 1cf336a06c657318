"""Progress, time and memory of a sweep."""

from __future__ import annotations

import sys
import time
from dataclasses import dataclass, field


@dataclass
class Run:
    """Rows, time and memory of one call of ``sweep``; earlier calls do not count."""

    #: Evaluated rows.
    rows: int = 0
    #: Wall-clock time [s].
    seconds: float = 0.0
    #: Peak memory of each worker [bytes], if the system reports it.
    peak_memory: dict[str, int] = field(default_factory=dict)

    @property
    def rows_per_second(self) -> float:
        """Rows over wall-clock time."""
        return self.rows / self.seconds if self.seconds else 0.0

    def __str__(self) -> str:
        memory = ", ".join(f"{name}: {size / 2**20:.0f} MiB" for name, size in self.peak_memory.items())
        return (
            f"{self.rows} rows in {self.seconds:.1f} s, {self.rows_per_second:.3g} rows/s"
            + (f"; peak memory {memory}" if memory else "")
        )


class Progress:
    """A line on stderr; by default on a terminal only."""

    def __init__(self, run: Run, rows: int, done: int, shown: bool | None) -> None:
        self._run, self._rows, self._before = run, rows, done
        self._shown = sys.stderr.isatty() if shown is None else shown
        self._begun = time.perf_counter()

    def add(self, rows: int, worker: str, memory: int | None) -> None:
        """Adds a finished part."""
        run = self._run
        run.rows += rows
        run.seconds = time.perf_counter() - self._begun
        if memory is not None:
            run.peak_memory[worker] = max(memory, run.peak_memory.get(worker, 0))
        if self._shown:
            done = self._before + run.rows
            left = (self._rows - done) / run.rows_per_second
            text = (
                f"sweep: {done} of {self._rows} rows ({100 * done / self._rows:.0f} %), "
                f"{run.rows_per_second:.3g} rows/s, {left:.0f} s left "
            )
            print(f"\r{text}", end="\n" if done == self._rows else "", file=sys.stderr, flush=True)


def peak_memory() -> int | None:
    """The peak memory of this process [bytes]; None if the system does not report it."""
    try:
        with open("/proc/self/status", encoding="ascii") as status:
            return next(1024 * int(line.split()[1]) for line in status if line.startswith("VmHWM:"))
    except (OSError, StopIteration):
        pass
    try:
        import resource
    except ImportError:
        return None
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    return peak if sys.platform == "darwin" else 1024 * peak
