"""Throughput of sweeps: in memory, to a folder, and on Dask clusters of one and two workers.

    python sweep_throughput.py 10000000
"""

from __future__ import annotations

import os
import sys
import tempfile
from pathlib import Path

import asperity
import scipy.stats
from distributed import Client, LocalCluster


def main(n: int) -> None:
    """Prints the rows per second of each."""
    space = asperity.Space(
        asperity.Scene.parse(asperity.template()),
        separation=(0.5, 3.0),
        hardness=scipy.stats.norm(2e9, 1e8),
        asperity_height_std=scipy.stats.lognorm(0.2, scale=1e-6),
        asperity_radius=(1e-4, 3e-4),
        asperity_density=(1e8, 3e8),
    )
    with tempfile.TemporaryDirectory() as home:
        for workers in (1, 2):
            cluster = LocalCluster(n_workers=workers, threads_per_worker=1, dashboard_address=":0")
            with cluster, Client(cluster) as client:
                folder = Path(home) / str(workers)
                result = asperity.sweep(space, "ke", n=n, folder=folder, client=client)
            print(f"{workers} workers: {result.run}")
        print(f"folder: {asperity.sweep(space, 'ke', n=n, folder=Path(home) / 'here').run}")
        print(f"memory: {asperity.sweep(space, 'ke', n=n).run}")
    print(f"load {os.getloadavg()[0]:.1f} on {os.cpu_count()} cores")


if __name__ == "__main__":
    main(int(sys.argv[1]))
