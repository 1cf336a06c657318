"""Sweeps in folders: the same digits everywhere, and no part lost or doubled by interrupts."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import textwrap
import threading
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import asperity
import numpy as np
import pyarrow.parquet as pq
import pytest
import scipy.stats
from distributed import Client, LocalCluster

N, PART = 12_000, 500


def swept(
    scene: asperity.Scene, folder: Path | None = None, client: Client | None = None, seed: int = 7
) -> asperity.SweepResult:
    space = asperity.Space(
        scene, separation=(0.5, 3.0), hardness=scipy.stats.norm(2e9, 1e8)
    )
    return asperity.sweep(
        space, "ke", n=N, seed=seed, part_size=PART, folder=folder, client=client
    )


@pytest.fixture(scope="module")
def in_memory() -> asperity.SweepResult:
    return swept(asperity.Scene.parse(asperity.template()))


@pytest.fixture(scope="module")
def cluster() -> Iterator[Client]:
    arguments = {"n_workers": 2, "threads_per_worker": 1, "dashboard_address": ":0"}
    with LocalCluster(**arguments) as cluster, Client(cluster) as client:
        yield client


def whole(folder: Path, wanted: asperity.SweepResult) -> None:
    """Every part once, nothing else, and every row once with the digits of the run in memory."""
    names = sorted(path.name for path in folder.iterdir())
    assert names == ["manifest.json"] + [f"part-{k:05}.parquet" for k in range(N // PART)]
    found = asperity.read_sweep(folder)
    rows = np.concatenate([pq.read_table(folder / n)["row"].to_numpy() for n in names[1:]])
    assert (rows == np.arange(N)).all()
    for column in ("separation", "hardness", "force"):
        assert (found[column] == wanted[column]).all()
    assert found.mean("force") == wanted.mean("force")
    assert found.std("force") == wanted.std("force")
    q = [0.01, 0.5, 0.99]
    assert (found.quantile("force", q) == wanted.quantile("force", q)).all()


def wait_for(condition: Callable[[], bool]) -> None:
    end = time.monotonic() + 30.0
    while not condition():
        assert time.monotonic() < end, "timeout"
        time.sleep(0.002)


def test_a_folder_holds_the_rows_of_a_sweep_in_memory(
    scene: asperity.Scene, in_memory: asperity.SweepResult, tmp_path: Path
) -> None:
    result = swept(scene, tmp_path)
    whole(tmp_path, in_memory)
    assert result.run.rows == N
    manifest = json.loads((tmp_path / "manifest.json").read_text())
    assert (manifest["seed"], manifest["n"], manifest["part_size"]) == (7, N, PART)
    assert manifest["asperity"] == asperity.__version__
    assert manifest["space"]["inputs"]["hardness"]["is"] == "norm(2000000000.0, 100000000.0)"
    schema = pq.read_schema(tmp_path / "part-00000.parquet")
    assert schema.names == ["row", "separation", "hardness", "force_N", "error"]
    assert swept(scene, tmp_path).run.rows == 0


def test_missing_parts_are_computed_again(
    scene: asperity.Scene, in_memory: asperity.SweepResult, tmp_path: Path
) -> None:
    swept(scene, tmp_path)
    kept = (tmp_path / "part-00001.parquet").stat().st_mtime_ns
    for gone in (0, 17, N // PART - 1):
        (tmp_path / f"part-{gone:05}.parquet").unlink()
    (tmp_path / ".part-00017.parquet.0.tmp").write_bytes(b"half a part")
    with pytest.raises(ValueError, match="21 of 24 parts"):
        asperity.read_sweep(tmp_path)
    assert swept(scene, tmp_path).run.rows == 3 * PART
    assert (tmp_path / "part-00001.parquet").stat().st_mtime_ns == kept
    whole(tmp_path, in_memory)


@pytest.mark.parametrize("size", [0, 3, 1000, -100])
def test_truncated_parts_are_named_and_computed_again(
    size: int, scene: asperity.Scene, in_memory: asperity.SweepResult, tmp_path: Path
) -> None:
    result = swept(scene, tmp_path)
    part = tmp_path / "part-00003.parquet"
    whole_part = part.read_bytes()
    part.write_bytes(whole_part[:size])
    with pytest.raises(ValueError, match=r"23 of 24 parts, part-00003\.parquet is incomplete: call"):
        asperity.read_sweep(tmp_path)
    # A result reads its parts on request.
    with pytest.raises(ValueError, match=r"part-00003\.parquet is no complete part of a sweep: call"):
        result.mean("force")
    assert swept(scene, tmp_path).run.rows == PART
    assert part.read_bytes() == whole_part
    whole(tmp_path, in_memory)


def test_folders_of_another_sweep_are_refused(scene: asperity.Scene, tmp_path: Path) -> None:
    swept(scene, tmp_path / "a")
    with pytest.raises(ValueError, match="holds another sweep: seed is 7 there and 8 here"):
        swept(scene, tmp_path / "a", seed=8)
    rougher = scene.replace(asperity_height_std=2e-6)
    with pytest.raises(ValueError, match=r"another sweep: space\.surface\.asperity_height_std is "):
        swept(rougher, tmp_path / "a")
    swept(scene, tmp_path / "b", seed=8)
    (tmp_path / "b" / "part-00003.parquet").replace(tmp_path / "a" / "part-00003.parquet")
    with pytest.raises(ValueError, match=r"part-00003\.parquet is not of the sweep"):
        swept(scene, tmp_path / "a")
    (tmp_path / "a" / "manifest.json").unlink()
    with pytest.raises(ValueError, match=r"has parts and no manifest\.json"):
        swept(scene, tmp_path / "a")
    with pytest.raises(ValueError, match="the folder of a sweep was required"):
        asperity.read_sweep(tmp_path)


def test_rows_that_fail_are_null_and_named(scene: asperity.Scene, tmp_path: Path) -> None:
    space = asperity.Space(scene, separation=1.0, hardness=(-1e9, 9e9))
    result = asperity.sweep(space, "ke", n=100, errors="mask", folder=tmp_path, part_size=30)
    failures = dict(result.failures())
    assert sorted(failures) == list(np.flatnonzero(result["hardness"] <= 0))
    for path in sorted(tmp_path.glob("*.parquet")):
        table = pq.read_table(path)
        for row, force, error in zip(
            table["row"].to_pylist(),
            table["force_N"].to_pylist(),
            table["error"].to_pylist(),
            strict=True,
        ):
            assert error == failures.get(row) and (force is None) == (row in failures)
    with pytest.raises(ValueError, match=f"row {min(failures)} failed in an earlier run"):
        asperity.sweep(space, "ke", n=100, folder=tmp_path, part_size=30)


@pytest.mark.parametrize("how", [signal.SIGINT, signal.SIGKILL])
def test_an_interrupted_run_continues(
    how: signal.Signals, scene: asperity.Scene, in_memory: asperity.SweepResult, tmp_path: Path
) -> None:
    script = f"""
        import sys
        sys.path.insert(0, {str(Path(__file__).parent)!r})
        import asperity, pathlib, test_sweep_folder
        scene = asperity.Scene.parse(asperity.template())
        test_sweep_folder.swept(scene, pathlib.Path({str(tmp_path)!r}))
        """
    run = subprocess.Popen(
        [sys.executable, "-c", textwrap.dedent(script)], stderr=subprocess.PIPE, text=True
    )
    wait_for(lambda: len(list(tmp_path.glob("part-*.parquet"))) >= 3)
    run.send_signal(how)
    _, errors = run.communicate(timeout=30)
    assert run.returncode != 0
    assert ("KeyboardInterrupt" in errors) == (how == signal.SIGINT)
    before = {path.name: path.stat().st_mtime_ns for path in tmp_path.glob("part-*.parquet")}
    assert 3 <= len(before) < N // PART
    assert swept(scene, tmp_path).run.rows == N - PART * len(before)
    assert before.items() <= {p.name: p.stat().st_mtime_ns for p in tmp_path.iterdir()}.items()
    whole(tmp_path, in_memory)


def test_a_cluster_gives_the_same_digits(
    scene: asperity.Scene, in_memory: asperity.SweepResult, cluster: Client, tmp_path: Path
) -> None:
    swept(scene, tmp_path, cluster)
    whole(tmp_path, in_memory)


def test_a_refused_row_ends_a_sweep_on_a_cluster(
    scene: asperity.Scene, cluster: Client, tmp_path: Path
) -> None:
    space = asperity.Space(scene, separation=1.0, hardness=(-1e9, 9e9))
    with pytest.raises(ValueError, match=r"^row \d+ \(.*hardness is -"):
        asperity.sweep(space, "ke", n=64, folder=tmp_path, client=cluster)
    assert not list(tmp_path.glob("*.parquet"))


def test_a_killed_worker_loses_and_doubles_nothing(
    scene: asperity.Scene, in_memory: asperity.SweepResult, cluster: Client, tmp_path: Path
) -> None:
    workers = set(cluster.run(os.getpid).values())
    victim = min(workers)
    seen: list[int] = []

    def kill() -> None:
        wait_for(lambda: len(list(tmp_path.glob("part-*.parquet"))) >= 3)
        os.kill(victim, signal.SIGKILL)
        seen.append(len(list(tmp_path.glob("part-*.parquet"))))

    killer = threading.Thread(target=kill)
    killer.start()
    swept(scene, tmp_path, cluster)
    killer.join()
    assert seen and seen[0] < N // PART
    whole(tmp_path, in_memory)
    cluster.wait_for_workers(2, timeout=30)
    assert victim not in set(cluster.run(os.getpid).values())
