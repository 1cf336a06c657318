"""Progress, time and memory of a sweep."""

from __future__ import annotations

import re
import sys
from dataclasses import dataclass, field
from pathlib import Path


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

    def show(self, done: int, rows: int) -> None:
        """A line on stderr: how many of all rows are done."""
        left = (rows - done) / self.rows_per_second
        text = (
            f"sweep: {done} of {rows} rows ({100 * done / rows:.0f} %), "
            f"{self.rows_per_second:.3g} rows/s, {left:.0f} s left "
        )
        print(f"\r{text}", end="\n" if done == rows else "", file=sys.stderr, flush=True)


def peak_memory() -> int | None:
    """The peak memory of this process [bytes]; None if the system does not report it."""
    status = Path("/proc/self/status")
    found = re.search(r"VmHWM:\s*(\d+)", status.read_text()) if status.is_file() else None
    if found:
        return 1024 * int(found[1])
    try:
        import resource
    except ImportError:
        return None
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    return peak if sys.platform == "darwin" else 1024 * peak
