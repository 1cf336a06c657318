"""Rough surfaces in contact: force, real area and stiffness by published models.

A scene describes two bodies in contact, a model has the law of one asperity, and a curve holds the
results. Numbers are in SI units, or texts with a unit, as "2 kN"; separations are multiples of the
standard deviation of the asperity heights, unless ``separation_unit="m"``. A load may replace a
separation.

>>> import asperity
>>> steel = asperity.Body(210e9, 0.3, hardness=2e9)
>>> scene = asperity.Scene(
...     interface=asperity.Interface.between(steel, steel),
...     surface=asperity.Surface(asperity_radius=2e-4, asperity_density=2e8, asperity_height_std=1e-6),
...     nominal_area=1e-4,
... )
>>> curve = asperity.model("ke").solve(scene, separation=[1, 2, 3], quantities=["force", "area"])
>>> [f"{force:.2f} N" for force in curve.force]
['2319.85 N', '216.94 N', '9.05 N']
>>> bool((curve.error("force") < 1e-10).all())
True
"""

from importlib.metadata import version as _version

from asperity._advice import Plan, PlanStep, Recommendation, plan, recommend
from asperity._asperity import (
    Asperity,
    Body,
    Contact,
    ContactWarning,
    Interface,
    JointTable,
    NotConverged,
    PartialSlip,
    Scene,
    Surface,
    Topography,
    Unloading,
    UnsupportedFormat,
    template,
)
from asperity._bem import BemContacts, bem
from asperity._bem_unloading import BemUnloading, bem_unloading
from asperity._check import Check, Finding
from asperity._conductance import Correlated, correlated_conductance, gap_conductance
from asperity._corrected import CorrectedCurve
from asperity._curve import Curve
from asperity._export import ContactTable, export
from asperity._fit import Estimate, Fit, Fits, fit
from asperity._laws import AsperityLaws
from asperity._materials import Material, materials
from asperity._model import Model, model, models
from asperity._scene import Scenes
from asperity._surfaces import Picture, random_surface, read, topography
from asperity._sweep import Sensitivity, Space, SweepResult, read_sweep, sweep
from asperity._truth import TruthRow, TruthRows, truth

__version__ = _version("asperity")

__all__ = [
    "Asperity",
    "AsperityLaws",
    "BemContacts",
    "BemUnloading",
    "Body",
    "Check",
    "Contact",
    "ContactTable",
    "ContactWarning",
    "Correlated",
    "CorrectedCurve",
    "Curve",
    "Estimate",
    "Finding",
    "Fit",
    "Fits",
    "Interface",
    "JointTable",
    "Material",
    "Model",
    "NotConverged",
    "PartialSlip",
    "Picture",
    "Plan",
    "PlanStep",
    "Recommendation",
    "Scene",
    "Scenes",
    "Sensitivity",
    "Space",
    "Surface",
    "SweepResult",
    "Topography",
    "TruthRow",
    "TruthRows",
    "Unloading",
    "UnsupportedFormat",
    "bem",
    "bem_unloading",
    "correlated_conductance",
    "export",
    "fit",
    "gap_conductance",
    "materials",
    "model",
    "models",
    "plan",
    "random_surface",
    "read",
    "read_sweep",
    "recommend",
    "sweep",
    "template",
    "topography",
    "truth",
]
