#!/usr/bin/env python3
"""Seconds per load beside tamaas (PolonskyKeerRey), every load started cold, in turns; medians of the runs and of their ratios.

    pip install numpy tamaas
    cargo build --release -p asperity-bem --example timing
    python3 crates/surfaces/bem/benches/beside_tamaas.py --sizes 512 1024 --threads 1 2 --runs 5

Both end at the same residual, sum p (gap - min gap)/(sum p Sq) < 1e-8. A power-law surface, Hurst exponent 0.8, rolled off at the 3rd wave of the
side, 16 pixels to the shortest wave, gradient 0.02; loads p/(E gradient) = 1e-3, 1e-2, 1e-1.
"""
import argparse
import os
import statistics
import subprocess
import tempfile
import time

import numpy as np
import tamaas

GRADIENT = 0.02


def surface(n):
    i = np.fft.fftfreq(n, 1 / n)
    k = np.hypot(i[:, None], i[None, :])
    weight = np.where((k >= 3) & (k <= n / 16), np.maximum(k, 1) ** -3.6, 0)
    waves = np.fft.fft2(np.random.default_rng(1).standard_normal((n, n))) * np.sqrt(weight)
    h = np.fft.ifft2(waves).real
    slopes = [np.fft.ifft2(2j * np.pi * i.reshape(s) * np.fft.fft2(h)).real for s in ((-1, 1), (1, -1))]
    return h * GRADIENT / np.sqrt(sum((s**2).mean() for s in slopes))


def tamaas_seconds(h, pressure):
    model = tamaas.ModelFactory.createModel(tamaas.model_type.basic_2d, [1.0, 1.0], list(h.shape))
    model.E, model.nu = 1.0, 0.0
    solver = tamaas.PolonskyKeerRey(model, h, 1e-8)
    solver.max_iter, solver.dump_freq = 10000, 10**9
    start = time.perf_counter()
    solver.solve(pressure)
    return time.perf_counter() - start, (model.traction > 0).mean()


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--sizes", type=int, nargs="+", default=[512, 1024])
    parser.add_argument("--threads", type=int, nargs="+", default=[1, 2])
    parser.add_argument("--runs", type=int, default=5)
    parser.add_argument("--program", default="target/release/examples/timing")
    arguments = parser.parse_args()
    print("n threads p/(E g): tamaas s, asperity s, ratio, iterations, contact pixels that differ")
    for n in arguments.sizes:
        h = surface(n)
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "heights.npy")
            np.save(path, h)
            for threads in arguments.threads:
                tamaas.initialize(threads)
                for load in (1e-3, 1e-2, 1e-1):
                    theirs, ours = [], []
                    for _ in range(arguments.runs):
                        seconds, area = tamaas_seconds(h, load * GRADIENT)
                        theirs.append(seconds)
                        environment = dict(os.environ, RAYON_NUM_THREADS=str(threads))
                        command = [arguments.program, path, repr(load * GRADIENT)]
                        words = subprocess.check_output(command, env=environment, text=True).split()
                        ours.append(float(words[1]))
                    ratio = statistics.median(a / b for a, b in zip(theirs, ours))
                    differ = round((float(words[3]) - area) * n * n)
                    print(f"{n} {threads} {load:g}: {statistics.median(theirs):.2f} {statistics.median(ours):.3f} {ratio:.1f} {words[2]} {differ}", flush=True)


if __name__ == "__main__":
    main()
