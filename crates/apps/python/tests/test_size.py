"""Memory of long calls, and their time to react to Ctrl-C."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import textwrap
import threading
import time
import warnings
from typing import Any

import asperity
import numpy as np
import pytest

MEMORY = """
    import sys
    import asperity, numpy as np

    def peak_memory():
        status = open("/proc/self/status").read()
        return 1024 * int(status.split("VmHWM:")[1].split()[0])

    scene = asperity.Scene.parse(asperity.template())
    n, model, quantities = 300_000, asperity.model("ke"), ["force", "area", "tangent"]
    numbers = np.linspace(0.0, 4.0, n)
    scenes = scene.vary(asperity_height_std=np.linspace(0.9e-6, 1.1e-6, n))
    calls = {
        "one": lambda: list(model.solve(scene, numbers, quantities)._columns.values()),
        "many": lambda: list(model.solve(scenes, numbers, quantities)._columns.values()),
        "loads": lambda: [model.separation_at(scenes, numbers + 1.0)],
        "contact": lambda: list(model.compile(scene).force_and_tangent(numbers)),
    }
    call = calls[sys.argv[1]]
    model.solve(scenes.reshape(600, 500)[0, 0].vary(hardness=np.full(70_000, 2e9)), 1.0)
    before = peak_memory()
    results = sum(column.nbytes for column in call())
    print((peak_memory() - before - results) / 2**20)
    """


@pytest.mark.skipif(not os.path.exists("/proc/self/status"), reason="the system does not report peak memory")
@pytest.mark.parametrize("what", ["one", "many", "loads", "contact"])
def test_many_rows_need_little_above_their_results(what: str) -> None:
    script = textwrap.dedent(MEMORY)
    found = subprocess.run(
        [sys.executable, "-c", script, what], capture_output=True, text=True, check=True
    )
    assert float(found.stdout) < 50.0


def interrupted_after(seconds: float, call: Any) -> float:
    """Time after Ctrl-C [s]."""
    sent: list[float] = []

    def send() -> None:
        sent.append(time.monotonic())
        os.kill(os.getpid(), signal.SIGINT)

    timer = threading.Timer(seconds, send)
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        call()
    timer.join()
    return time.monotonic() - sent[0]


@pytest.mark.skipif(os.name == "nt", reason="other signals")
@pytest.mark.parametrize("what", ["one scene", "many scenes", "angles", "loads", "crossings"])
def test_ctrl_c_ends_a_call_soon(what: str, scene: asperity.Scene) -> None:
    # Seconds to minutes without an interrupt.
    exponential = asperity.Scene(scene.interface, scene.surface, 1e-4, heights="exponential")
    deep = np.linspace(-4, -1, 10_000_000)
    drawn = scene.vary(hardness=np.linspace(1e9, 3e9, 3_000))
    ke, at = asperity.model("ke"), asperity.model("at")
    calls = {
        "one scene": lambda: ke.solve(exponential, deep),
        "many scenes": lambda: ke.solve([exponential], deep),
        "angles": lambda: at.solve(drawn, 1.0),
        "loads": lambda: at.separation_at(drawn, 10.0),
        "crossings": lambda: at.separation_at(drawn, 10.0, all=True),
    }
    # About a second on an idle machine. The cancellation of AT's parts is not under test.
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        assert interrupted_after(0.5, calls[what]) < 5.0
