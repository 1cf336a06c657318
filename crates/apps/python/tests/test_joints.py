"""Joints in unloading and shear, and correlations of conductance."""

from __future__ import annotations

import math
import pickle
from typing import Any, TypeAlias

import asperity
import numpy as np
import numpy.typing as npt
import pytest
from laws import Hertz

Floats: TypeAlias = npt.NDArray[np.float64]


def test_floats_give_floats_and_arrays_their_shape(scene: asperity.Scene) -> None:
    joint = asperity.model("ke").unloading(scene, 1.0)
    retreats = np.linspace(0.0, 0.5, 6).reshape(2, 3)
    slip = joint.slip(0.3)
    shifts = 1e-7 * retreats
    calls: list[tuple[Any, Floats]] = [
        (joint.force, retreats),
        (joint.area, retreats),
        (joint.stiffness, retreats),
        (slip.force, shifts),
        (slip.loss, shifts),
        (lambda x: slip.loop_force(x, 1e-7), shifts),
    ]
    for call, given in calls:
        found = call(given)
        assert found.shape == (2, 3) and found.flags.c_contiguous
        assert type(call(float(given[1, 2]))) is float and call(given[1, 2]) == found[1, 2]
        assert call([]).shape == (0,)


def test_units_and_places_agree(scene: asperity.Scene) -> None:
    ke, sigma = asperity.model("ke"), scene.surface.asperity_height_std
    plane = asperity.Scene(
        scene.interface, scene.surface, scene.nominal_area, separation_from="surface-mean"
    )
    first = ke.unloading(scene, load=100.0)
    metres = ke.unloading(scene, first.closest * sigma, separation_unit="m")
    pressure = ke.unloading(plane, pressure=100.0 / scene.nominal_area)
    offset = scene.surface.mean_plane_offset / sigma
    assert pressure.closest == pytest.approx(first.closest + offset, rel=1e-9)
    assert metres.closest == pytest.approx(first.closest * sigma, rel=1e-12)
    for one, retreat in [(first, 0.2), (metres, 0.2 * sigma), (pressure, 0.2)]:
        assert one.force(0.0) == pytest.approx(100.0, rel=1e-8)
        assert one.force(retreat) == pytest.approx(first.force(0.2), rel=1e-8)
        assert one.scene in (scene, plane) and one.rtol == 1e-10


def test_lengths_may_have_a_unit(scene: asperity.Scene) -> None:
    joint = asperity.model("ke").unloading(scene, load="1 kN")
    metres = asperity.model("ke").unloading(scene, load=1e3, separation_unit="m")
    assert joint.force("100 nm") == pytest.approx(metres.force(1e-7), rel=1e-12)
    assert metres.force("100 nm") == metres.force(1e-7)
    found = joint.area(["0 m", "0.1 um"])
    np.testing.assert_allclose(found, metres.area([0.0, 1e-7]), rtol=1e-12)
    slip = joint.slip(0.3)
    assert slip.force("50nm") == slip.force(5e-8)
    assert slip.loop_force("50 nm", "0.1 um") == slip.loop_force(5e-8, 1e-7)
    np.testing.assert_array_equal(slip.loss(["50 nm", "0.1 um"]), slip.loss([5e-8, 1e-7]))
    contact = asperity.model("ke").compile(scene, quantities=("force", "area"))
    assert contact.evaluate("area", load="1 kN") == contact.evaluate("area", load=1e3)
    assert contact.force("1 um") == contact.force(1e-6 / scene.surface.asperity_height_std)


def test_contact_ends_and_losses_have_loss_factors(scene: asperity.Scene) -> None:
    joint = asperity.model("ke").unloading(scene, load="100 N", law="brake")
    assert joint.force(0.0) == pytest.approx(100.0, rel=1e-8)
    end = joint.last_contact()
    assert joint.contacts(end) == pytest.approx(1.0, rel=1e-6)
    assert joint.contacts([0.0, 0.1]).shape == (2,)
    metres = asperity.model("ke").unloading(scene, load=100.0, law="brake", separation_unit="m")
    sigma = scene.surface.asperity_height_std
    assert metres.last_contact() == pytest.approx(end * sigma, rel=1e-9)
    closing = joint.dissipated() + joint.returned(math.inf)
    assert joint.loss_factor() == pytest.approx(joint.dissipated() / (2 * math.pi * closing))
    slip = joint.slip(0.3)
    spring = math.pi * slip.force(1e-7) * 1e-7
    assert slip.loss_factor([1e-7, 1e-4])[0] == pytest.approx(slip.loss(1e-7) / spring)
    assert slip.loss_factor(1e-2) == pytest.approx(4 / math.pi, rel=1e-3)


def test_an_energy_gain_is_warned_of_once_a_call_at_the_line_of_the_caller(
    scene: asperity.Scene,
) -> None:
    joint = asperity.model("af").unloading(scene, load=100.0, law="brake")
    for call in (joint.loss_factor, joint.dissipated):
        with pytest.warns(asperity.ContactWarning) as seen:
            assert call() > 0.0
        (warning,) = seen
        assert str(warning.message).startswith("energy-gain: af: ")
        assert warning.filename == __file__


def test_joints_can_be_pickled_and_shown(scene: asperity.Scene) -> None:
    joint = asperity.model("jg").unloading(scene, pressure=1e6, law="brake", separation_unit="m")
    slip = joint.slip(0.25)
    again = pickle.loads(pickle.dumps(slip))
    assert again.force(1e-8) == slip.force(1e-8) and again.friction == 0.25
    assert again.unloading.force(1e-8) == joint.force(1e-8)
    assert repr(joint).startswith("<asperity.Unloading of JG")
    assert repr(again) == repr(slip) and "friction 0.25" in repr(slip)


class Halved(Hertz):
    """Half the force at the same radius recovers half the interference."""

    def force(self, w: Any) -> Any:
        return 0.5 * super().force(w)


def test_a_model_written_in_python_unloads(scene: asperity.Scene) -> None:
    hertz, halved = (asperity.model(one).unloading(scene, 1.0) for one in (Hertz, Halved))
    for u in (0.0, 0.2):
        # F/2 (1 - 2 u/w)^1.5.
        assert halved.force(u) == pytest.approx(0.5 * hertz.force(2 * u), rel=1e-8)


def steps_along(table: asperity.JointTable, way: Floats) -> Any:
    """Force and stiffness along a sequence of separations of a new joint."""
    before = np.concatenate([[np.inf], np.minimum.accumulate(way)[:-1]])
    return table.step(way, before)[:2]


def test_histories_follow_closing_and_opening(scene: asperity.Scene) -> None:
    ke, sigma = asperity.model("ke"), scene.surface.asperity_height_std
    plane = asperity.Scene(
        scene.interface, scene.surface, scene.nominal_area, separation_from="surface-mean"
    )
    table = ke.joint_table(scene, 0.9, 3.1)
    way = np.array([3.0, 1.5, 1.6, 1.9, 1.7, 1.5, 1.0, 1.1, 1.4, 1.2])
    force, stiffness = steps_along(table, way)
    # The virgin curve, and the way back from its closest approach.
    assert force[1] == pytest.approx(ke.compile(scene).force(1.5), rel=1e-6)
    assert force[8] == pytest.approx(ke.unloading(scene, 1.0).force(0.4), rel=1e-5)
    metres = ke.joint_table(scene, 0.9 * sigma, 3.1 * sigma, separation_unit="m")
    offset = scene.surface.mean_plane_offset / sigma
    moved = ke.joint_table(plane, 0.9 + offset, 3.1 + offset)
    for other, given in [(metres, way * sigma), (moved, way + offset)]:
        np.testing.assert_allclose(steps_along(other, given)[0], force, rtol=1e-6)
    closest, steps = np.inf, []
    for at in way:
        one, _, closest = table.step(at, closest)
        steps.append(one)
    np.testing.assert_array_equal(steps, force)
    assert closest == 1.0 and type(steps[0]) is float
    again = pickle.loads(pickle.dumps(table))
    np.testing.assert_array_equal(steps_along(again, way)[1], stiffness)
    assert repr(again) == repr(table) and "from 0.9 to 3.1" in repr(table)
    with pytest.raises(ValueError, match=r"0\.9 asperity_height_std"):
        table.step(0.8, 1.0)


def test_many_joints_step_at_once_with_exact_tangents(scene: asperity.Scene) -> None:
    table = asperity.model("ke").joint_table(scene, -0.2, 3.5)
    separations = np.linspace(0.0, 3.0, 12).reshape(3, 4)
    force, stiffness, closest = table.step(separations)
    back = separations + np.linspace(0.0, 0.4, 12).reshape(3, 4) - 0.1
    force, stiffness, after = table.step(back, closest)
    np.testing.assert_array_equal(after, np.minimum(back, closest))
    for k in np.ndindex(3, 4):
        one = table.step(float(back[k]), float(closest[k]))
        assert one == (float(force[k]), float(stiffness[k]), float(after[k]))
        assert type(one[0]) is float
    # Broadcast, and saved with the table.
    _, _, states = table.step(2.0, np.array([1.0, 1.5, np.inf]))
    np.testing.assert_array_equal(states, [1.0, 1.5, 2.0])
    again, saved = pickle.loads(pickle.dumps((table, states)))
    for one, other in zip(again.step([2.1], saved), table.step(2.1, states), strict=True):
        np.testing.assert_array_equal(one, other)
    with pytest.raises(ValueError, match="broadcast"):
        table.step([1.0, 2.0], [1.0, 2.0, 3.0])
    with pytest.raises(ValueError, match=r"separation is -0\.3 asperity_height_std"):
        table.step([1.0, -0.3])
    metres = asperity.model("ke").joint_table(scene, 0.0, 4e-6, separation_unit="m")
    for state in (None, 1e-6):
        with pytest.raises(ValueError, match="separation is NaN"):
            metres.step(float("nan"), state)
    with pytest.raises(ValueError, match="closest is -1e-6 m"):
        metres.step(1e-6, -1e-6)
