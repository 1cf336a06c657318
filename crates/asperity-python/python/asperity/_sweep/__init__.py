"""Sweeps: scenes drawn from distributions, with results and statistics."""

from asperity._sweep.result import Sensitivity, SweepResult, read_sweep
from asperity._sweep.run import sweep
from asperity._sweep.space import Space

__all__ = ["Sensitivity", "Space", "SweepResult", "read_sweep", "sweep"]
