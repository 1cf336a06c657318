"""Arguments in, arrays out: shapes, types, errors, warnings, copies."""

from __future__ import annotations

import copy
import multiprocessing
import os
import pickle
import threading
import time
import warnings
from pathlib import Path
from typing import Any

import asperity
import numpy as np
import pytest

EXAMPLES = Path(__file__).resolve().parents[3] / "answer" / "scene" / "examples"


def refusal(call: Any, *arguments: Any, **named: Any) -> str:
    with pytest.raises(ValueError) as caught:
        call(*arguments, **named)
    return str(caught.value)


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


@pytest.mark.parametrize("path", sorted(EXAMPLES.glob("*.toml")), ids=lambda path: path.stem)
def test_example_files_are_read(path: Path) -> None:
    scene = asperity.Scene.from_toml(path)
    assert asperity.Scene.from_toml(str(path)) == scene
    assert "gw" in scene.models()


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


def test_loads_of_many_scenes_in_any_order(scene: asperity.Scene) -> None:
    ke = asperity.model("ke")
    scenes = scene.vary(asperity_height_std=np.linspace(1e-6, 2e-6, 40))
    wanted = np.broadcast_to(np.linspace(0.0, 3.0, 7), (40, 7))
    loads = ke.solve(scenes.reshape(40, 1), wanted[0]).force
    found = ke.separation_at(scenes.reshape(40, 1), loads)
    np.testing.assert_allclose(found, wanted, atol=1e-11)
    # Scenes change from one value to the next.
    np.testing.assert_allclose(ke.separation_at(scenes, loads.T), wanted.T, atol=1e-11)
    many = ke.separation_at(scene, np.geomspace(1e-3, 1e3, 500))
    assert many.shape == (500,) and (np.diff(many) < 0).all()
    assert refusal(ke.separation_at, scenes, -loads.T).startswith("scene 0: load is -")
    shares = ke.solve(scenes, wanted.T).shares("force")
    np.testing.assert_allclose(sum(shares.values()), 1.0, rtol=1e-12)


def test_separations_in_metres_and_from_the_surface_mean(scene: asperity.Scene) -> None:
    ke, std = asperity.model("ke"), scene.surface.asperity_height_std
    in_stds = ke.solve(scene, [0.5, 2.0])
    in_metres = ke.solve(scene, np.array([0.5, 2.0]) * std, separation_unit="m")
    np.testing.assert_allclose(in_metres.force, in_stds.force, rtol=1e-14)
    # What rounding a separation does to the value is in the bound.
    assert (in_metres.error("force") > in_stds.error("force")).all()
    many = ke.solve([scene], np.array([0.5, 2.0]) * std, separation_unit="m")
    assert (many.error("force") > ke.solve([scene], [0.5, 2.0]).error("force")).all()

    plane = asperity.Scene(
        scene.interface, scene.surface, scene.nominal_area, separation_from="surface-mean"
    )
    offset = scene.surface.mean_plane_offset
    assert pickle.loads(pickle.dumps(plane)) == plane == eval(repr(plane), vars(asperity))
    shifted = ke.solve(plane, np.array([0.5, 2.0]) * std + offset, separation_unit="m")
    np.testing.assert_allclose(shifted.force, in_stds.force, rtol=1e-13)
    back = ke.separation_at(plane, in_stds.force, separation_unit="m")
    # To the tolerance of 1e-10, which separations are found with.
    np.testing.assert_allclose(back, np.array([0.5, 2.0]) * std + offset, rtol=1e-10)


def test_tabulated_heights_keep_their_metres() -> None:
    z = np.array([-2e-6, 0.0, 0.5e-6, 1.5e-6])
    density = np.array([0.0, 3e5, 3.5e5, 0.0])
    interface, surface = (
        asperity.Interface(116e9, 0.31, 1.12e9),
        asperity.Surface(3.6e-4, 1.1e8, 1e-6),
    )
    scene = asperity.Scene(interface, surface, 3e-5, heights=(z, density))
    again = pickle.loads(pickle.dumps(scene))
    assert again == scene
    np.testing.assert_array_equal(again.heights[0], z)
    gw = asperity.model("gw")
    wider = scene.replace(asperity_height_std=2e-6)
    gaps = np.array([-1e-6, 0.0, 1e-6])
    one = gw.solve(scene, gaps, separation_unit="m").force
    np.testing.assert_allclose(gw.solve(wider, gaps, separation_unit="m").force, one, rtol=1e-9)


@pytest.mark.filterwarnings("ignore::asperity.ContactWarning")
def test_options_of_a_scene_apply_to_models_without_options(soft_steel: asperity.Scene) -> None:
    given = soft_steel.interface, soft_steel.surface, soft_steel.nominal_area
    vertical = asperity.Scene(*given, options={"force": "vertical"})
    at, named = asperity.model("at-additive"), asperity.model("at-additive", force="vertical")
    assert at.solve(vertical, 2.0).force == named.solve(soft_steel, 2.0).force
    assert at.solve(soft_steel, 2.0).force != named.solve(soft_steel, 2.0).force
    message = refusal(at.solve, [soft_steel, vertical], 2.0)
    assert message.startswith("scene 1 has other")


def test_bad_input_is_a_value_error_with_the_message_of_the_library(scene: asperity.Scene) -> None:
    ke = asperity.model("ke")
    assert 'the nearest is "zmc"' in refusal(asperity.model, "zcm")
    assert 'the nearest is "stick"' in refusal(asperity.model, "at", stik="clamped")
    assert refusal(asperity.Surface, 1e-4, -1.0, 1e-6).startswith("asperity_density is -1.0: ")
    assert refusal(asperity.Body, 1e9, 0.6, 1e8).startswith("poissons_ratio is 0.6: ")
    elastic = asperity.Interface(2e6, 0.5)
    rubber = asperity.Scene(elastic, scene.surface, scene.nominal_area)
    assert asperity.model("gw").solve(rubber, 2.0).force > 0.0
    assert refusal(ke.solve, rubber, 2.0).startswith("hardness is missing")
    assert refusal(ke.solve, scene, [0.0, np.nan]).startswith("separation is NaN asperity_height_std: ")
    assert 'the nearest is "force"' in refusal(ke.solve, scene, 0.0, "forc")
    assert refusal(ke.solve, scene, 0.0, rtol=0.0).startswith("tolerance is 0.0: ")
    assert refusal(ke.solve, scene, 0.0, []).startswith("quantities is empty")
    assert refusal(ke.solve, scene, 0.0, separation_unit="mm").startswith("separation_unit is 'mm'")
    assert refusal(ke.separation_at, scene, [1.0, 1e30]).startswith("load is 1e30 N, above ")
    assert refusal(scene.replace, hardnes=1.0).startswith("hardnes is not")
    assert refusal(scene.vary, hardnes=[1.0]).startswith("hardnes is not")
    many = scene.vary(hardness=[1e9, 2e9, -3.0, -4.0])
    assert refusal(ke.solve, many, 1.0).startswith("scene 2: hardness is -3.0: ")
    with pytest.raises(FileNotFoundError, match=r"^no such file\.toml: "):
        asperity.Scene.from_toml("no such file.toml")
    assert refusal(asperity.Scene.parse, "nominal_aera = 1").startswith("line 1: nominal_aera ")
    bodies = scene.interface, scene.surface, 1.0
    assert "2 heights and 1 densities" in refusal(asperity.Scene, *bodies, ([0.0, 1.0], [1.0]))
    assert '"asperity-mean" or "surface-mean" was required' in refusal(asperity.Scene, *bodies, separation_from="mean")
    rubber = scene.replace(hardness=1e12)
    assert refusal(ke.solve, rubber, 1.0).startswith("hardness is ")
    bare = asperity.Interface(116e9, 0.31, hardness=1e9)
    bare_scene = asperity.Scene(bare, scene.surface, 1e-4)
    assert "gao needs it" in refusal(asperity.model("gao").solve, bare_scene, 1.0)


def test_arguments_of_another_type_are_type_errors(scene: asperity.Scene) -> None:
    ke = asperity.model("ke")
    for arguments in [(scene, 1j), (scene, "one"), ([scene, "scene"], 1.0), (None, 1.0)]:
        with pytest.raises(TypeError):
            ke.solve(*arguments)  # type: ignore[arg-type]
    with pytest.raises(TypeError):
        asperity.model(Laws, force="size")
    with pytest.raises(ValueError, match=r"^scenes .*\(2,\) and separation \(3,\)"):
        ke.solve([scene, scene], [1.0, 2.0, 3.0])
    curve = ke.solve(scene, 1.0)
    with pytest.raises(AttributeError, match="area was"):
        _ = curve.area
    with pytest.raises(KeyError, match="area was"):
        _ = curve["area"]


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


def test_representations_show_the_arguments(scene: asperity.Scene) -> None:
    assert repr(scene).startswith("Scene(interface=Interface(equivalent_modulus=115384615384.61537")
    assert eval(repr(scene), vars(asperity)) == scene
    assert repr(asperity.model("ke")) == "<asperity.Model 'ke': Kogut & Etsion (2002)>"
    assert repr(asperity.model(Laws)) == "<asperity.Model 'Laws': written in Python>"
    assert "ke: force, tangent; rtol=1e-10; separations in asperity_height_std" in repr(asperity.model("ke").compile(scene))
    assert str(asperity.model("ke").citation()) == "Kogut & Etsion (2002)"


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


def test_plans_and_recommendations(scene: asperity.Scene) -> None:
    plan = asperity.plan("ke", scene, np.linspace(0, 4, 9), ["force", "tangent", "area"])
    assert [(step["law"], step["quantities"]) for step in plan.steps] == [
        ("force", ["force", "tangent"]),
        ("area", ["area"]),
    ]
    assert plan.steps[0]["terms"][1] <= 16
    at_loads = asperity.plan("ke", scene, load=[1.0, 100.0], quantities="area")
    assert {step["law"] for step in at_loads.steps} == {"force", "area"}
    advice = asperity.recommend(
        scene, [0.0, 1.0, 2.0], reference=asperity.model("zmc"), within=1e-6
    )
    assert advice.simplest == "zmc"
    assert np.isnan(advice.of("persson")["force_deviation"]).all()
    zmc = advice.of("zmc")
    assert (zmc["force_deviation"], zmc["area_deviation"]) == (0.0, 0.0)
    assert advice.results
    under_load = asperity.recommend(scene, load=[10.0, 1200.0], quantities=["area"])
    ke, gw = (under_load.of(name)["area_deviation"] for name in ("ke", "gw"))
    assert ke < 1e-9 < gw
    few = asperity.recommend(scene, load=10.0, quantities=["area"], models=["gw", "persson"])
    assert set(few["model"]) == {"gw", "persson"}
    sticky = asperity.Interface(1e7, 0.49, work_of_adhesion=0.05)
    among = asperity.recommend(asperity.Scene(sticky, scene.surface, 1e-4), load=1.0)
    assert {"dmt", "jkr"} <= set(among["model"])
    assert np.isnan(asperity.recommend(scene, 30.0)["area_off_bem"]).all()
    with pytest.raises(ValueError, match=r"within is 5"):
        asperity.recommend(scene, [1.0], within=5)
    bare = asperity.Scene(asperity.Interface(116e9, 0.31, 1e9), scene.surface, 1e-4)
    reasons = [one.message for one in asperity.recommend(bare, [1.0]).findings if one.code == "left-out"]
    assert any("gao" in reason for reason in reasons)


def test_all_ids_make_models() -> None:
    ids = [model.id for model in asperity.models()]
    assert len(ids) == len(set(ids)) == 40
    assert {"jg-cosine", "at-overlap", "persson-plastic", "jkr", "ghaednia", "bem"} < set(ids)
    assert {"ke-random", "ghaednia-pairs"} < set(ids)
    assert all(asperity.model(one.upper()).id == one for one in ids)


def test_models_have_citations() -> None:
    at = asperity.model("at-additive")
    assert at.citation().authors == "Amini & Tehrani" and at.citation().year == 2020
    assert at.citation().title.startswith("A New Combined Model")
    assert "doi = {10.1155/2020/4640204}" in at.bibtex()
    assert at.bibtex().startswith("@article{amini2020,\n")
    assert asperity.model("bem").bibtex().startswith("@article{polonsky1999,")


@pytest.mark.parametrize(
    ("model", "option"),
    [
        ("ke", {"force": "vertical"}),
        ("at-additive", {"friction_cut_off": 0.02}),
        ("ke-random", {"af_flow_pressure": "H"}),
        ("bem", {"hurst_exponent": 0.8}),
    ],
)
def test_options_of_other_models_are_refused(model: str, option: dict[str, Any]) -> None:
    (name,) = option
    with pytest.raises(ValueError, match=f"{name}: does not change {model}"):
        asperity.model(model, **option)


@pytest.mark.filterwarnings("ignore::asperity.ContactWarning")
def test_persson_has_gaps_with_a_hurst_exponent(scene: asperity.Scene) -> None:
    fudge = asperity.model("persson-fudge", hurst_exponent=0.8)
    with pytest.warns(asperity.ContactWarning, match="persson-fudge ignores yielding"):
        curve = fudge.solve(scene, load=[1.0, 10.0, 100.0], quantities=["area", "tangent"])
    gaps = fudge.separation_at(scene, load=[1.0, 10.0, 100.0], separation_unit="m")
    assert np.all(np.diff(gaps) < 0) and np.all(np.diff(curve.tangent) > 0)
    back = fudge.solve(scene, gaps, separation_unit="m")
    np.testing.assert_allclose(back.force, [1.0, 10.0, 100.0], rtol=1e-8)
    numbers = scene.interface, scene.surface, scene.nominal_area
    smooth = asperity.Scene(*numbers, options={"hurst_exponent": 0.5})
    assert asperity.Scene.parse(smooth.to_toml()).options == {"hurst_exponent": 0.5}
    other = asperity.model("persson-fudge").solve(smooth, load=1.0, quantities=["tangent"])
    assert other.tangent != curve.tangent[0]
    with pytest.raises(ValueError, match="hurst_exponent is missing"):
        asperity.model("persson").solve(scene, load=1.0, quantities=["tangent"])
    with pytest.raises(ValueError, match=r"hurst_exponent is 2\.0"):
        asperity.model("persson", hurst_exponent=2.0)


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


def test_threads_share_a_contact(scene: asperity.Scene) -> None:
    contact = asperity.model("ke").compile(scene)
    wanted = asperity.model("ke").compile(scene).force(np.linspace(0, 4, 5000))
    found: dict[int, Any] = {}

    def work(k: int) -> None:
        found[k] = contact.force(np.linspace(0, 4, 5000))

    threads = [threading.Thread(target=work, args=(k,)) for k in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    for values in found.values():
        np.testing.assert_array_equal(values, wanted)


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
