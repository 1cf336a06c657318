"""Sweeps: many scenes drawn from distributions, their answers and what can be said about them."""

from asperity._sweep.result import Sensitivity, SweepResult, read_sweep
from asperity._sweep.run import sweep
from asperity._sweep.space import Space

__all__ = ["Sensitivity", "Space", "SweepResult", "read_sweep", "sweep"]
