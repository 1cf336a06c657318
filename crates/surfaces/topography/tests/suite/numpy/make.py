"""The arrays beside this script, as NumPy itself writes them (made with 2.4.6)."""

import numpy as np
from numpy.lib import format

heights = np.add.outer(10.0 * np.arange(4), np.arange(5.0))
for name in ["f8", "f4", "u1", "i2"]:
    np.save(f"{name}.npy", heights.astype(name))
np.save("big-endian.npy", heights.astype(">f8"))
np.save("fortran.npy", np.asfortranarray(heights))
for version in [(2, 0), (3, 0)]:
    with open(f"version-{version[0]}.npy", "wb") as file:
        format.write_array(file, heights, version)
np.savez("archive.npz", heights=heights, x=np.arange(5.0))
