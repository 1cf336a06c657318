"""Arguments in, arrays out: shapes, types, errors, warnings, copies."""

from __future__ import annotations

import copy
import multiprocessing
import os
import pickle
import threading
import time
import warnings
from typing import Any

import asperity
import numpy as np
import pytest


def test_scenes_by_file_and_by_keyword_are_the_same() -> None:
    text = """
        nominal_area = 3e-5
        [interface]
        equivalent_modulus = 116e9
        poissons_ratio = 0.31
        hardness = 1.12e9
        [surface]
        asperity_radius = 3.6e-4
        asperity_density = 1.1e8
        asperity_height_std = 1e-6
        heights = "exponential"
        [options]
        force = "vertical"
        displacement = { zeta = 0.1, xi = 0.2 }
    """
    scene = asperity.Scene(
        interface=asperity.Interface(116e9, 0.31, hardness=1.12e9),
        surface=asperity.Surface(3.6e-4, 1.1e8, 1e-6),
        nominal_area=3e-5,
        heights="exponential",
        options={"force": "vertical", "displacement": {"zeta": 0.1, "xi": 0.2}},
    )
    assert asperity.Scene.parse(text) == scene
    assert scene != scene.replace(nominal_area=1.0)


def test_keys_of_a_surface_are_those_of_a_file() -> None:
    keys = {"asperity_radius": 2e-4, "asperity_density": 2e8, "asperity_height_std": "1 um"}
    steel = asperity.Interface(116e9, 0.31, hardness=1.12e9)
    of_keys = asperity.Scene(steel, {**keys, "separation_from": "surface-mean"}, nominal_area=1e-4)
    beside = asperity.Scene(steel, keys, nominal_area=1e-4, separation_from="surface-mean")
    assert of_keys == beside and of_keys.separation_from == "surface-mean"
    twice = {**keys, "separation_from": "surface-mean"}
    with pytest.raises(TypeError, match="separation_from is given twice"):
        asperity.Scene(steel, twice, nominal_area=1e-4, separation_from="asperity-mean")


def test_texts_with_units_are_read_wherever_numbers_are_replaced() -> None:
    body = asperity.Body("210 GPa", 0.3, hardness="2 GPa")
    pair = asperity.Interface.between(body, body)
    scene = asperity.Scene(pair, asperity.Surface(2e-4, 2e8, 1e-6), nominal_area=1e-4)
    harder = scene.replace(body1_hardness="3 GPa", body2_hardness="4 GPa")
    assert harder.interface.hardness == 3e9
    vickers = scene.replace(hardness="200 HV")
    assert scene.vary(hardness=["200 HV", "2 GPa"])[0] == vickers


def test_results_are_contiguous_doubles_in_the_broadcast_shape(scene: asperity.Scene) -> None:
    ke = asperity.model("ke")
    every_second = np.linspace(0, 4, 18, dtype=np.float32).reshape(3, 6)[:, ::2]
    curve = ke.solve(scene, every_second, ["force", "area"])
    for values in (curve.force, curve.area, curve.error("force"), curve.ln("area")):
        assert values.shape == (3, 3) and values.dtype == np.float64
        assert values.flags.c_contiguous and values.flags.writeable
    assert curve.quantities == ("force", "area")
    assert ke.solve(scene, 1).force.shape == ()
    assert ke.solve(scene, []).force.shape == (0,)
    assert ke.separation_at(scene, [[1.0], [2.0]]).shape == (2, 1)


def test_scenes_broadcast_against_separations_and_loads(scene: asperity.Scene) -> None:
    ke = asperity.model("ke")
    stds = np.array([1e-6, 1.5e-6, 2e-6])
    scenes = scene.vary(asperity_height_std=stds, hardness=[[2e9], [3e9]])
    assert scenes.shape == (2, 3) and len(scenes) == 2
    assert scenes[1, 2] == scene.replace(asperity_height_std=2e-6, hardness=3e9)
    curve = ke.solve(scenes, separation=[0.0, 1.0, 2.0], quantities=["force", "tangent"])
    listed = ke.solve([[scenes[i, j] for j in range(3)] for i in range(2)], [0.0, 1.0, 2.0])
    assert curve.force.shape == (2, 3)
    np.testing.assert_array_equal(curve.force, listed.force)
    one = ke.solve(scenes[1, 2], 2.0, ["force", "tangent"])
    # One scene and many are integrated in different ways, each to the tolerance of 1e-10.
    np.testing.assert_allclose(curve.force[1, 2], one.force, rtol=1e-10)
    np.testing.assert_allclose(curve.tangent[1, 2], one.tangent, rtol=1e-10)
    outer = ke.solve(scenes.reshape(-1, 1), np.linspace(0, 1, 5))
    assert outer.force.shape == (6, 5)
    loads = ke.separation_at(scenes, curve.force)
    np.testing.assert_allclose(loads, np.broadcast_to([0.0, 1.0, 2.0], (2, 3)), atol=1e-12)
    shares = curve.shares("force")
    np.testing.assert_allclose(sum(shares.values()), 1.0, rtol=1e-12)
    assert ke.solve([], []).force.shape == (0,)


@pytest.mark.filterwarnings("ignore::asperity.ContactWarning")
def test_options_of_a_scene_apply_to_models_without_options(soft_steel: asperity.Scene) -> None:
    given = soft_steel.interface, soft_steel.surface, soft_steel.nominal_area
    vertical = asperity.Scene(*given, options={"force": "vertical"})
    at, named = asperity.model("at-additive"), asperity.model("at-additive", force="vertical")
    assert at.solve(vertical, 2.0).force == named.solve(soft_steel, 2.0).force
    assert at.solve(soft_steel, 2.0).force != named.solve(soft_steel, 2.0).force


class Laws:
    """A module-level class, for pickle."""

    def __init__(self, one: asperity.Asperity) -> None:
        self.one = one

    def force(self, w: Any) -> Any:
        return self.one.critical_force * w

    def area(self, w: Any) -> Any:
        return self.one.radius * w


class Noise:
    """Endless integrals."""

    def __init__(self, one: asperity.Asperity) -> None:
        self.one = one

    def force(self, w: Any) -> Any:
        return w * (1.5 + np.sin(1e15 * w / self.one.radius))

    def area(self, w: Any) -> Any:
        return w


def test_an_integral_that_does_not_converge_raises_not_converged(scene: asperity.Scene) -> None:
    with pytest.raises(asperity.NotConverged, match="not converged"):
        asperity.model(Noise).solve(scene, 1.0, rtol=1e-13)
    assert not issubclass(asperity.NotConverged, ValueError)


def test_unusual_answers_have_one_warning_for_each_cause(soft_steel: asperity.Scene) -> None:
    printed = asperity.model("at")
    quantities = ["force", "pressure", "mean-pressure"]
    negative = "negative: at: force is negative ("
    for scenes in (soft_steel, [soft_steel]):
        with pytest.warns(asperity.ContactWarning) as seen:
            curve = printed.solve(scenes, [-9.0, 1.0, 1.5], quantities)
        texts = [str(warning.message) for warning in seen]
        assert [text[: len(negative)] for text in texts if "negative" in text] == [negative]
        assert any(" in 2 rows, " in text for text in texts)
        assert curve.force[0] > 0.0 > curve.force[1]
        # The line of the caller, not of the package.
        assert seen[0].filename == __file__
    with pytest.warns(asperity.ContactWarning, match="at a separation of 1e-6 m: "):
        printed.solve(soft_steel, 1e-6, separation_unit="m")
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        asperity.model("ke").solve(soft_steel, [0.0, 1.0])


def test_copies_and_pickles_are_equal(scene: asperity.Scene) -> None:
    ke = asperity.model("ke")
    scenes = scene.vary(hardness=[[1e9], [2e9]], asperity_height_std=[1e-6, 2e-6, 3e-6])
    curve = ke.solve(scene, [0.0, 1.0])
    values: list[Any] = [
        asperity.Body(1e9, 0.3, yield_strength=1e8),
        scene.interface,
        scene.surface,
        scene,
        scenes,
        ke,
        asperity.model("at", displacement={"zeta": 0.1, "xi": 0.2}),
        asperity.model(Laws),
        ke.compile(scene),
        asperity.model(Laws).compile(scene),
        curve,
    ]
    for value in values:
        for again in (pickle.loads(pickle.dumps(value)), copy.copy(value), copy.deepcopy(value)):
            assert repr(again) == repr(value)
            if "__eq__" in vars(type(value)):
                assert again == value
    again = pickle.loads(pickle.dumps(curve))
    np.testing.assert_array_equal(again.force, curve.force)
    np.testing.assert_array_equal(again.error("force"), curve.error("force"))
    np.testing.assert_array_equal(
        pickle.loads(pickle.dumps(scenes))[1, 2].surface, scenes[1, 2].surface
    )


@pytest.mark.parametrize(
    "key",
    [
        "[gap]\ngas_conductivity = 0.026\ngas_parameter = 3.7e-7",
        '[seal]\nwidth = 0.1\nlength = 2e-3\nupstream_pressure = 1e6\ndownstream_pressure = 1e5\ngas = "air"',
        'surface.counterface = "smooth"',
        "surface.peklenik_number = 3.0",
        'surface.separation_from = "surface-mean"',
        'work_of_adhesion = 0.05',
    ],
)
def test_every_key_is_pickled_and_compared(scene: asperity.Scene, key: str) -> None:
    text = scene.to_toml()
    of_surface, is_top = key.removeprefix("surface."), "[" not in key
    place = "[surface]\n" if of_surface != key else ""
    with_key = text.replace(place, place + of_surface + "\n", 1) if is_top else f"{text}\n{key}"
    other = asperity.Scene.parse(with_key)
    assert other != scene
    again = pickle.loads(pickle.dumps(other))
    assert again == other and again.to_toml() == other.to_toml() != text


def test_representations_show_the_text(scene: asperity.Scene) -> None:
    assert repr(scene).startswith('Scene.parse("""\nnominal_area = ')
    assert eval(repr(scene), vars(asperity)) == scene
    assert repr(asperity.model("ke")) == "<asperity.Model 'ke': Kogut & Etsion (2002)>"
    assert repr(asperity.model(Laws)) == "<asperity.Model 'Laws': written in Python>"
    assert "ke: force, tangent; rtol=1e-10; separations in asperity_height_std" in repr(asperity.model("ke").compile(scene))
    assert str(asperity.model("ke").citation()) == "Kogut & Etsion (2002)"
    assert asperity.model("bem").bibtex().startswith("@article{polonsky1999,")


def test_tables_have_units_in_their_heads(scene: asperity.Scene) -> None:
    ke = asperity.model("ke")
    table = ke.solve(scene, [1e-6, 2e-6], ["force", "tangent"], separation_unit="m").to_dataframe()
    assert list(table.columns) == ["separation_m", "force_N", "tangent_N_per_m"]
    many = ke.solve(scene.vary(hardness=[[1e9], [2e9]]), [1.0, 2.0]).to_dataframe()
    assert list(many.columns) == ["scene", "hardness_Pa", "separation", "force_N"]
    assert list(many["scene"]) == [0, 0, 1, 1]
    assert list(many["hardness_Pa"]) == [1e9, 1e9, 2e9, 2e9]
    rough = scene.vary(asperity_height_std=[1e-6, 2e-6])
    loaded = ke.solve(rough, load=10.0, quantities="area", separation_unit="m")
    table = loaded.to_dataframe()
    assert list(table.columns)[1:4] == ["asperity_height_std_m", "load_N", "separation_m"]
    np.testing.assert_array_equal(table["separation_m"], loaded.separation)


def test_texts_of_tables_have_every_digit_and_blanks_for_missing_values(
    scene: asperity.Scene,
) -> None:
    curve = asperity.model("ke").solve(
        scene, load=[1.0, 1e30, 100.0], quantities=["area", "mean-pressure"], errors="mask"
    )
    head, *rows = (line.split(",") for line in curve.to_csv().splitlines())
    assert head == ["load_N", "separation", "area_m2", "mean_pressure_Pa"]
    assert rows[1] == ["1e+30", "", "", ""]
    assert [float(row[2]) for row in rows[::2]] == curve.area.compressed().tolist()  # type: ignore[attr-defined]
    assert curve.to_dataframe()["area_m2"].isna().tolist() == [False, True, False]


def test_all_ids_make_models() -> None:
    ids = [model.id for model in asperity.models()]
    assert len(ids) == len(set(ids)) == 41
    assert {"jg-cosine", "at-overlap", "persson-plastic", "jkr", "ghaednia", "best", "bem"} < set(ids)
    assert {"ke-random", "ghaednia-pairs"} < set(ids)
    assert all(asperity.model(one.upper()).id == one for one in ids)


def test_long_calls_release_the_interpreter(scene: asperity.Scene) -> None:
    separations = np.linspace(0, 4, 4_000_000)
    counts: list[int] = []
    done = threading.Event()

    def count() -> None:
        k = 0
        while not done.is_set():
            k += 1
            time.sleep(0)
        counts.append(k)

    other = threading.Thread(target=count)
    other.start()
    asperity.model("ke").solve(scene, separations)
    done.set()
    other.join()
    assert counts[0] > 100


def forces_in_a_child(scene: asperity.Scene, queue: Any) -> None:
    queue.put(asperity.model("ke").solve(scene, np.linspace(0, 4, 20_000)).force.sum())


@pytest.mark.skipif(not hasattr(os, "fork"), reason="needs a fork")
@pytest.mark.filterwarnings("ignore:.*fork:DeprecationWarning")
def test_a_forked_process_computes_too(scene: asperity.Scene) -> None:
    wanted = asperity.model("ke").solve(scene, np.linspace(0, 4, 20_000)).force.sum()
    context = multiprocessing.get_context("fork")
    queue = context.Queue()
    child = context.Process(target=forces_in_a_child, args=(scene, queue))
    child.start()
    assert queue.get(timeout=20) == wanted
    child.join(timeout=20)
    assert child.exitcode == 0


def test_cancellation_is_warned_of_for_any_number_of_rows(soft_steel: asperity.Scene) -> None:
    printed = asperity.model("at")
    low, high = 2.5, 6.0
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        while high - low > 1e-5:
            middle = 0.5 * (low + high)
            below = printed.solve(soft_steel, middle, ["force"]).force < 0.0
            low, high = (middle, high) if below else (low, middle)
    for count in (1, 300, 3000):
        places = np.append(np.linspace(5.0, 6.0, count - 1), high)
        for scenes in (soft_steel, [soft_steel]):
            with pytest.warns(asperity.ContactWarning, match="^cancelled: "):
                printed.solve(scenes, places, ["force"])
