"""Films between the mean planes, their ratio to the rms height, and the factors of flow."""

from __future__ import annotations

import asperity
import numpy as np

SCENE = """
nominal_area = 1e-4
[interface]
equivalent_modulus = 1e11
poissons_ratio = 0.3
hardness = 2e9
[surface]
surface_height_std = 4e-7
asperity_radius = 2e-5
asperity_density = 6e9
"""


def test_films_are_separations_from_the_mean_plane() -> None:
    scene = asperity.Scene.parse(SCENE)
    planes = asperity.Scene.parse(SCENE + 'separation_from = "surface-mean"\n')
    model = asperity.model("ke")
    film = np.array([4e-7, 8e-7, 1.2e-6])
    by_film = model.solve(scene, film=film, quantities=("pressure", "area-fraction"))
    by_ratio = model.solve(scene, lambda_ratio=[1, 2, 3], quantities="pressure")
    by_plane = model.solve(planes, film, separation_unit="m", quantities="pressure")
    np.testing.assert_allclose(by_film.pressure, by_plane.pressure, rtol=1e-12)
    np.testing.assert_allclose(by_ratio.pressure, by_plane.pressure, rtol=1e-9)
    np.testing.assert_allclose(by_film.film, film)
    np.testing.assert_allclose(by_ratio.lambda_ratio, [1, 2, 3])
    back = model.solve(scene, by_film.separation, quantities="pressure")
    np.testing.assert_allclose(back.pressure, by_film.pressure, rtol=1e-9)
    texts = model.solve(scene, film=["0.4 um", "0.8 um"], quantities="pressure")
    np.testing.assert_allclose(texts.pressure, by_film.pressure[:2], rtol=1e-12)
    assert "3 films from 1 to 3" in repr(by_ratio)


def test_factors_of_flow_follow_the_lay_of_the_scene() -> None:
    along = asperity.Scene.parse(SCENE + "peklenik_number = 6\n")
    names = ["pressure-flow-factor-x", "pressure-flow-factor-y", "friction-flow-factor"]
    found = along.flow_factors([2.0, 4.0], quantities=names)
    assert (np.asarray(found["pressure-flow-factor-x"]) > 1).all()
    assert (np.asarray(found["pressure-flow-factor-y"]) < 1).all()
    again = asperity.Scene.parse(along.to_toml())
    assert again.flow_factors([2.0, 4.0], quantities=names) == found
    # Two like surfaces: the shears cancel.
    shear = along.flow_factors([2.0], quantities="shear-flow-factor", pairs=True)
    assert shear["shear-flow-factor"] == [0.0]
