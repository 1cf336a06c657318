"""Arguments of a wrong kind, and names with a slip: the message names the argument and the way out."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import asperity
import numpy as np
import pytest

KE = asperity.model("ke")
KB = asperity.model("jkr-separation")


def wrong(argument: object) -> Any:
    """An argument of a type that is not allowed."""
    return argument


def test_a_list_in_the_place_of_one_number_is_refused_by_name(scene: asperity.Scene) -> None:
    with pytest.raises(TypeError, match=r"^load is \[1.0, 2.0\]"):
        KE.unloading(scene, load=wrong([1.0, 2.0]))
    with pytest.raises(TypeError, match=r"^load is a ndarray"):
        asperity.export(KE, scene, load=wrong(np.linspace(1.0, 2.0, 40)), nodes=3)
    with pytest.raises(TypeError, match="^model is a Scene"):
        asperity.export(wrong(scene), wrong(KE), load=(1.0, 2.0), nodes=3)


def test_one_scene_is_required_where_many_have_no_answer(scene: asperity.Scene) -> None:
    many = scene.vary(work_of_adhesion=[0.05, 0.1])
    advice = r"one scene, not many"
    for call in (
        lambda: KB.pull_off(wrong(many)),
        lambda: KE.compile(wrong(many)),
        lambda: KE.unloading(wrong([scene, scene]), 1.0),
        lambda: asperity.export(KE, wrong(many), load=(1.0, 2.0), nodes=3),
        lambda: asperity.plan(KE, wrong(many), 1.0),
    ):
        with pytest.raises(TypeError, match=advice):
            call()


def test_a_joint_table_takes_lengths_with_a_unit(scene: asperity.Scene) -> None:
    table = KE.joint_table(scene, "-1 um", "5 um", separation_unit="m")
    assert table.step(2e-6) == KE.joint_table(scene, -1e-6, 5e-6, separation_unit="m").step(2e-6)
    with pytest.raises(ValueError, match='lengths with a unit need separation_unit="m"'):
        KE.joint_table(scene, "-1 um", "5 um")


def test_shapes_that_do_not_broadcast_are_named(scene: asperity.Scene) -> None:
    many = scene.vary(hardness=np.full((3, 5), 2e9))
    with pytest.raises(ValueError, match=r"^scenes .*\(3, 5\) and load \(2,\)"):
        KE.solve(many, load=[1.0, 2.0])


def test_curves_give_their_axis_and_near_names(scene: asperity.Scene, tmp_path: Path) -> None:
    curve = KE.solve(scene, load=[1.0, 2.0], quantities=["unloading-stiffness"])
    assert (curve["load"] == [1.0, 2.0]).all()
    with pytest.raises(AttributeError, match="unloading-stiffness"):
        _ = curve.unloading_stifness
    text = curve.to_csv(tmp_path / "curve.csv")
    assert (tmp_path / "curve.csv").read_text() == text


def test_a_contact_table_is_saved(scene: asperity.Scene, tmp_path: Path) -> None:
    with pytest.warns(asperity.ContactWarning, match="^interpolation-error: "):
        table = asperity.export(KE, scene, "abaqus", load=("1 N", "1 kN"), nodes=5)
    table.save(tmp_path / "table.inp")
    assert (tmp_path / "table.inp").read_text() == table.text


def test_files_that_do_not_exist_are_not_found(tmp_path: Path) -> None:
    for read in (asperity.read, asperity.Scene.from_toml):
        with pytest.raises(FileNotFoundError, match="nothing.*: no such file"):
            read(wrong(tmp_path / "nothing.x3p"))


def test_a_pixel_size_that_is_no_number_is_named() -> None:
    with pytest.raises(TypeError, match="^None is no"):
        asperity.Topography(np.zeros((8, 8)), dx=wrong(None), unit="um")



def test_options_of_other_models_may_differ_between_scenes(scene: asperity.Scene) -> None:
    given = scene.interface, scene.surface, scene.nominal_area
    scenes = [scene, asperity.Scene(*given, options={"force": "vertical"})]
    force = KE.solve(scenes, 1.0).force
    assert force[0] == force[1]
    with pytest.raises(ValueError, match="^scene 1 .*scene 0"):
        asperity.model("at").solve(scenes, 1.0)
