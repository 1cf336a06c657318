"""Statistics of a column chunk by chunk, without the whole column in memory."""

from __future__ import annotations

from collections.abc import Callable, Iterable

import numpy as np
import numpy.typing as npt

from asperity._scene import Floats

DIGIT = 16
TOP = np.uint64(1 << 63)


def moments(chunks: Iterable[Floats]) -> tuple[int, float, float]:
    """Count, mean and sum of squared deviations, in the order of the chunks: the digits do not depend
    on the workers."""
    count, mean, squares = 0, 0.0, 0.0
    for chunk in chunks:
        if not len(chunk):
            continue
        own_mean = float(np.mean(chunk))
        step, total = own_mean - mean, count + len(chunk)
        squares += float(np.sum((chunk - own_mean) ** 2)) + step * step * (count * len(chunk) / total)
        mean += step * (len(chunk) / total)
        count = total
    return count, mean, squares


def quantiles(chunks: Callable[[], Iterable[Floats]], probabilities: Floats) -> Floats:
    """Exact quantiles by the method of ``numpy.quantile``, of chunks that are read four times."""
    count = sum(len(chunk) for chunk in chunks())
    places = probabilities * (count - 1)
    below = np.floor(places).astype(np.int64)
    above = np.minimum(below + 1, count - 1)
    ranks = np.unique(np.concatenate([below, above]))
    values = dict(zip(ranks.tolist(), _order_statistics(chunks, ranks), strict=True))
    low = np.array([values[rank] for rank in below.tolist()])
    high = np.array([values[rank] for rank in above.tolist()])
    return np.asarray(low + (places - below) * (high - low))


def _order_statistics(chunks: Callable[[], Iterable[Floats]], ranks: npt.NDArray[np.int64]) -> Floats:
    """The values of given ranks, 16 bits in every pass."""
    prefixes = np.zeros(len(ranks), dtype=np.uint64)
    left = ranks.copy()
    for shift in range(64 - DIGIT, -1, -DIGIT):
        wanted = np.unique(prefixes)
        counts = np.zeros((len(wanted), 1 << DIGIT), dtype=np.int64)
        for chunk in chunks():
            keys = _keys(chunk)
            digits = (keys >> np.uint64(shift)) & np.uint64((1 << DIGIT) - 1)
            # The first pass has no prefix, and a shift by 64 bits is undefined.
            heads = keys >> np.uint64(shift + DIGIT) if shift + DIGIT < 64 else np.zeros_like(keys)
            for place, prefix in enumerate(wanted):
                of_prefix = digits[heads == prefix].astype(np.int64)
                counts[place] += np.bincount(of_prefix, minlength=1 << DIGIT)
        for k, prefix in enumerate(prefixes):
            up_to = np.cumsum(counts[np.searchsorted(wanted, prefix)])
            digit = int(np.searchsorted(up_to, left[k], side="right"))
            left[k] -= up_to[digit - 1] if digit else 0
            prefixes[k] = (prefix << np.uint64(DIGIT)) | np.uint64(digit)
    return np.where(prefixes & TOP, prefixes ^ TOP, ~prefixes).view(np.float64)


def _keys(values: Floats) -> npt.NDArray[np.uint64]:
    """Integers in the order of the doubles."""
    bits = np.ascontiguousarray(values).view(np.uint64)
    return np.where(bits & TOP, ~bits, bits | TOP)
