"""Scenes that many tests use."""

from __future__ import annotations

import signal

import asperity
import pytest

# Shells start background jobs with an ignored Ctrl-C, which Python then ignores, too.
signal.signal(signal.SIGINT, signal.default_int_handler)


@pytest.fixture
def scene() -> asperity.Scene:
    """Steel on steel, machined: every model allows it."""
    return asperity.Scene.parse(asperity.template())


@pytest.fixture
def soft_steel() -> asperity.Scene:
    """The AT paper's steel, less rough: AT as printed turns negative there."""
    interface = asperity.Interface(
        116e9,
        0.31,
        hardness=1.12e9,
        equivalent_shear_modulus=41e9,
    )
    surface = asperity.Surface.of(
        plasticity_index=2.0,
        roughness_parameter=0.04,
        asperity_height_std=1e-6,
        interface=interface,
    )
    return asperity.Scene(interface, surface, nominal_area=3e-5)
