#!/usr/bin/env python3
"""Reference contacts for the boundary elements (writes bem_dense.csv): dense matrices, no Fourier transform, no iteration to a tolerance.

Surfaces: the random surfaces of asperity-bem made from its documentation alone, wave by wave; the upper left rows x columns pixels of an n x n map.
Compliances: periodic, the sum of the waves 2/(E |q|) without the mean, cosine by cosine; free, the rectangle of Love (1929), pixel by pixel.
Solution: a primal-dual active set. With the sets of open, free and flowing pixels held, the pressures and the approach are the solution of one linear
    system (LU); pixels that break a bound change their set; the end is reached when none does, so that every row is exact but for rounding.
Fixed stiffness: the matrix of the pixels in contact times their pressures is 1; the sum of these pressures over the number of pixels of the map [Pa/m].
Needs numpy. Takes a minute or two.
"""
import csv
import numpy as np

M = (1 << 64) - 1


def mix(z):
    z = (z + 0x9E3779B97F4A7C15) & M
    z = ((z ^ (z >> 30)) * 0xBF58476D1CE4E5B9) & M
    z = ((z ^ (z >> 27)) * 0x94D049BB133111EB) & M
    return z ^ (z >> 31)


def surface(longest, roll_off, shortest, hurst, side, gradient, seed, n):
    waves = []
    top = int(shortest)
    for j in range(0, top + 1):
        for i in range(-top, top + 1):
            k = np.hypot(i, j)
            if (j > 0 or i > 0) and longest <= k <= shortest:
                waves.append((i, j, k, 1.0 if k <= roll_off else (k / roll_off) ** (-2 * (1 + hurst))))
    scale = gradient**2 / sum((2 * np.pi / side * k) ** 2 * w for _, _, k, w in waves)
    y, x = np.meshgrid(np.arange(n) / n, np.arange(n) / n, indexing="ij")
    h = np.zeros((n, n))
    for i, j, k, w in waves:
        phase = 2 * np.pi * (mix((mix(seed) + ((i & 0xFFFFFFFF) << 32) + j) & M) >> 11) / 2.0**53
        h += np.sqrt(2 * scale * w) * np.cos(2 * np.pi * (i * y + j * x) + phase)
    return h


def periodic(rows, columns, dy, dx, modulus):
    """Deflection of pixel (a, b) under the pressure 1 on pixel (0, 0)."""
    i = np.minimum(np.arange(rows), rows - np.arange(rows))
    j = np.minimum(np.arange(columns), columns - np.arange(columns))
    q = 2 * np.pi * np.hypot(i[:, None] / (rows * dy), j[None, :] / (columns * dx))
    waves = np.where(q > 0, 2 / (modulus * np.where(q > 0, q, 1)), 0) / (rows * columns)
    a = 2 * np.pi * np.outer(np.arange(rows), np.arange(rows)) / rows
    b = 2 * np.pi * np.outer(np.arange(columns), np.arange(columns)) / columns
    return np.cos(a) @ waves @ np.cos(b) - np.sin(a) @ waves @ np.sin(b)


def free(rows, columns, dy, dx, modulus):
    y, x = dy * np.arange(rows)[:, None], dx * np.arange(columns)[None, :]

    def corner(x, y):
        r = np.hypot(x, y)
        return x * np.log((y + r) / np.abs(x)) + y * np.log((x + r) / np.abs(y))

    a, b = dx / 2, dy / 2
    return (corner(x + a, y + b) - corner(x - a, y + b) - corner(x + a, y - b) + corner(x - a, y - b)) / (np.pi * modulus)


def solve(h, influence, wraps, load, cap):
    rows, columns = h.shape
    i, j = np.divmod(np.arange(h.size), columns)
    di, dj = np.abs(i[:, None] - i[None, :]), np.abs(j[:, None] - j[None, :])
    matrix = influence[di, dj]
    h = h.ravel()
    state = np.zeros(h.size, int)  # -1 open, 0 free, 1 flowing
    for step in range(200):
        f, b = np.flatnonzero(state == 0), np.flatnonzero(state == 1)
        m = len(f)
        system = np.ones((m + 1, m + 1))
        system[:m, :m] = matrix[np.ix_(f, f)]
        system[m, m] = 0
        right = np.empty(m + 1)
        flowing = cap if len(b) else 0.0
        right[:m] = h[f] - flowing * matrix[np.ix_(f, b)].sum(axis=1)
        right[m] = load - flowing * len(b)
        # Rows in units of their own: the last one is a sum of pressures.
        scale = np.abs(matrix[0, 0])
        system[m, :m] *= scale
        right[m] *= scale
        system[:m, m] *= scale
        solution = np.linalg.solve(system, right)
        p = np.zeros(h.size)
        p[b] = flowing
        p[f] = solution[:m]
        gap = matrix @ p - h + scale * solution[m]
        new = state.copy()
        new[(state == 0) & (p < 0)] = -1
        new[(state == 0) & (p > cap)] = 1
        new[(state == -1) & (gap < 0)] = 0
        new[(state == 1) & (gap > 0)] = 0
        if (new == state).all():
            gap[f] = 0
            return p.reshape(rows, columns), gap.reshape(rows, columns), step
        state = new
    raise RuntimeError("the sets did not settle")


def fixed_stiffness(influence, c):
    i, j = np.nonzero(c)
    matrix = influence[np.abs(i[:, None] - i[None, :]), np.abs(j[:, None] - j[None, :])]
    return np.linalg.solve(matrix, np.ones(len(i))).sum() / c.size


def edges(c, wraps):
    count = (c[1:] != c[:-1]).sum() + (c[:, 1:] != c[:, :-1]).sum()
    if wraps:
        count += (c[0] != c[-1]).sum() + (c[:, 0] != c[:, -1]).sum()
    return count


SURFACE = dict(longest=2.0, roll_off=4.0, shortest=8.0, hurst=0.8, side=1e-4, gradient=0.1)
MODULUS = 1e11
CASES = [  # seed, n, rows, columns, stretch of dy
    (1, 64, 64, 64, 1.0),
    (2, 64, 45, 63, 1.5),
]
HEAD = "seed n rows columns dy boundary hardness pressure pixels plastic edges mean_gap gap_volume highest_pressure pressure_square fixed_stiffness".split()


def main():
    with open("bem_dense.csv", "w", newline="") as file:
        table = csv.writer(file)
        table.writerow(HEAD)
        for seed, n, rows, columns, stretch in CASES:
            dx = SURFACE["side"] / n
            dy = stretch * dx
            h = surface(**SURFACE, seed=seed, n=n)[:rows, :columns]
            h = h - h.mean()
            for boundary, influence in (("periodic", periodic), ("free", free)):
                kernel = influence(rows, columns, dy, dx, MODULUS)
                for cap in (np.inf, 0.4, 0.1):
                    for pressure in (0.003, 0.02, 0.08):
                        unit = MODULUS * SURFACE["gradient"]
                        p, gap, steps = solve(h, kernel, boundary == "periodic", pressure * unit * h.size, cap * unit)
                        c = p > 0
                        plastic = (p >= cap * unit * (1 - 1e-12)).sum() if np.isfinite(cap) else 0
                        row = [seed, n, rows, columns, repr(float(dy)), boundary, repr(float(cap * unit)) if np.isfinite(cap) else "", repr(float(pressure * unit))]
                        row += [c.sum(), plastic, edges(c, boundary == "periodic")]
                        row += ["%.15e" % x for x in (gap.mean(), np.maximum(gap, 0).mean(), p.max(), (p**2).mean(), fixed_stiffness(kernel, c))]
                        table.writerow(row)
                        file.flush()
                        print(*row, "steps", steps)


if __name__ == "__main__":
    main()
