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

from asperity._advice import Answer as Answer
from asperity._advice import check as check
from asperity._arguments import Scenes as Scenes
from asperity._asperity import Contact as Contact
from asperity._asperity import ContactWarning as ContactWarning
from asperity._asperity import JointTable as JointTable
from asperity._asperity import NotConverged as NotConverged
from asperity._asperity import PartialSlip as PartialSlip
from asperity._asperity import Scene as Scene
from asperity._asperity import Topography as Topography
from asperity._asperity import Unloading as Unloading
from asperity._asperity import UnsupportedFormat as UnsupportedFormat
from asperity._asperity import random_surface as random_surface
from asperity._asperity import template as template
from asperity._bem import BemContacts as BemContacts
from asperity._bem import bem as bem
from asperity._bem import sealing_pressure as sealing_pressure
from asperity._curve import Curve as Curve
from asperity._fit import Estimate as Estimate
from asperity._fit import Fit as Fit
from asperity._fit import Fits as Fits
from asperity._fit import fit as fit
from asperity._materials import Material as Material
from asperity._materials import materials as materials
from asperity._model import AsperityLaws as AsperityLaws
from asperity._model import Model as Model
from asperity._model import model as model
from asperity._model import models as models
from asperity._ranges import Ranges as Ranges
from asperity._ranges import ranges as ranges
from asperity._records import Asperity as Asperity
from asperity._records import Body as Body
from asperity._records import Interface as Interface
from asperity._records import Surface as Surface
from asperity._surfaces import read as read
from asperity._sweep import sample as sample
from asperity._sweep import sweep as sweep
from asperity._table import Finding as Finding
from asperity._table import Table as Table
from asperity._tables import ContactTable as ContactTable
from asperity._tables import export as export

__version__ = _version("asperity")

__all__ = sorted(name for name in globals() if not name.startswith("_"))
