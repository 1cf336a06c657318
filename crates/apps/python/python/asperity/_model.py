"""Models: by id, or written in Python."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any, NamedTuple, Protocol, TypeAlias

import numpy as np
import numpy.typing as npt

from asperity import _asperity
from asperity._arguments import (
    LOADS,
    Floats,
    Options,
    Rows,
    SceneLike,
    checked_errors,
    checked_unit,
    floats,
    in_si,
    one_number,
    one_scene,
    place,
)
from asperity._asperity import Contact, Engine, JointTable, Scene, Unloading
from asperity._curve import Curve
from asperity._records import Asperity
from asperity._warn import warn


class AsperityLaws(Protocol):
    """The laws of one asperity: the protocol of a model written in Python.

    The class is called with an ``Asperity``. ``w`` is an array of interferences [m], all above 0;
    the laws return forces [N] and areas [m^2], one for each.

    Optional: ``stiffness(w)`` [N/m], if it is not the tangent of the force; ``kinks``, the
    interferences [m] at which a formula changes, jumps, bends or has a cusp (a sequence, or a dict
    of sequences by quantity); ``regimes``, a name for each range between the kinks, for shares; and
    on the class ``name``, and ``force_monotone = False`` if the force may fall as ``w`` grows:
    without it ``Model.check`` reports such a force; and ``uses_density = True`` if the laws depend on
    ``asperity.density``, which is None otherwise.

    Declare every kink. Values with an undeclared kink take more time, and mostly keep the tolerance;
    but a jump, kink or cusp between the sampled interferences escapes the bounds of
    ``Curve.error``, and the error may exceed the tolerance. ``Model.check`` finds most undeclared
    kinks.
    """

    def force(self, w: Floats, /) -> npt.ArrayLike:
        """Force [N] at interferences [m]."""

    def area(self, w: Floats, /) -> npt.ArrayLike:
        """Real area [m^2] at interferences [m]."""


LawsOfAsperity: TypeAlias = Callable[[Asperity], AsperityLaws]
Law: TypeAlias = Callable[[Floats], Floats]


class Laws:
    """The laws of a class: checked functions, with their kinks and regimes."""

    def __init__(self, factory: LawsOfAsperity) -> None:
        if not (callable(factory) and hasattr(factory, "force")):
            raise ValueError(
                f"{factory!r} is no model: an id, or a class with force(w) and area(w), was required"
            )
        self.factory = factory
        name = getattr(factory, "name", None) or getattr(factory, "__name__", "")
        self.name = str(name)
        self.own_stiffness = hasattr(factory, "stiffness")
        self.force_monotone = bool(getattr(factory, "force_monotone", True))
        self.uses_density = bool(getattr(factory, "uses_density", False))

    def __call__(self, one: Asperity, quantity: str) -> tuple[Law, list[float], list[str]]:
        """The law of an asperity, its kinks [m], ascending, and the names of the ranges between them."""
        laws = self.factory(one)
        kinks: Any = getattr(laws, "kinks", None)
        kinks = kinks() if callable(kinks) else kinks
        kinks = kinks.get(quantity) if isinstance(kinks, Mapping) else kinks
        numbers = {float(kink) for kink in (() if kinks is None else kinks)}
        within = sorted(kink for kink in numbers if 0.0 < kink < np.inf)
        regimes = list(getattr(laws, "regimes", None) or ())
        if regimes and len(regimes) != len(within) + 1:
            raise ValueError(
                f"regimes has {len(regimes)} names: one more than the {len(within)} kinks was required"
            )
        return self._checked(getattr(laws, quantity), quantity), within, regimes

    def findings(self, one: Asperity) -> list[str]:
        """Exceptions of the laws for an array of interferences, which the engine passes."""
        found = []
        for quantity in ("force", "area", "stiffness")[: 2 + self.own_stiffness]:
            try:
                law, _, _ = self(one, quantity)
                law(one.radius * np.array([1e-6, 1e-4, 1e-2]))
            except Exception as error:
                raised = f"{type(error).__name__}: {error}"
                found.append(f"{quantity}: {raised}; a law must accept an array of interferences")
        return found

    def _checked(self, law: Callable[[Floats], npt.ArrayLike], quantity: str) -> Law:
        call = f"{self.name}.{quantity}(w)"

        def checked(w: Floats) -> Floats:
            found = np.asarray(law(w))
            if found.dtype.kind not in "fiub":
                raise ValueError(f"{call} has values of type {found.dtype}: real numbers were required")
            if found.shape != w.shape:
                raise ValueError(
                    f"{call} has shape {found.shape} for {w.size} interferences: one value for each "
                    "was required"
                )
            bad = np.flatnonzero(~np.isfinite(found))
            if bad.size:
                raise ValueError(
                    f"{call} is {found[bad[0]]} at w = {w[bad[0]]:e} m: a finite number was required"
                )
            return np.ascontiguousarray(found, dtype=np.float64)

        return checked


class Citation(NamedTuple):
    """What the paper of a model is cited by."""

    #: As cited, without initials.
    authors: str
    year: int
    title: str
    #: Of the equations: seen (read in text that quotes the paper), derived, or recalled.
    provenance: str

    def __str__(self) -> str:
        return f"{self.authors} ({self.year})" if self.year else self.authors


class Model(Engine):
    """A model of rough contact; ``asperity.model`` makes one.

    >>> import asperity
    >>> asperity.model("ke")
    <asperity.Model 'ke': Kogut & Etsion (2002)>
    """

    def __new__(cls, model: str | LawsOfAsperity, /, **options: Any) -> Model:
        if options and not isinstance(model, str):
            raise TypeError("options were given: a model written in Python takes none")
        return super().__new__(cls, model if isinstance(model, str) else Laws(model), options)

    def __init__(self, model: str | LawsOfAsperity, /, **options: Any) -> None:
        self._definition, self._options = model, options

    @property
    def options(self) -> Options:
        """The given options; those of a scene apply to the others."""
        return dict(self._options)

    def citation(self) -> Citation:
        """Authors, year and title of the paper, and the provenance of its equations; ``bibtex`` has
        the journal, where it is known.

        >>> import asperity
        >>> asperity.model("ke").citation()[:2]
        ('Kogut & Etsion', 2002)
        """
        if not isinstance(self._definition, str):
            return Citation("written in Python", 0, "", "derived")
        return Citation(*self._citation)

    def solve(
        self,
        scene: SceneLike,
        separation: npt.ArrayLike | None = None,
        quantities: str | Sequence[str] = ("force",),
        rtol: float = 1e-10,
        separation_unit: str = "asperity_height_std",
        *,
        load: npt.ArrayLike | None = None,
        pressure: npt.ArrayLike | None = None,
        film: npt.ArrayLike | None = None,
        lambda_ratio: npt.ArrayLike | None = None,
        approach: npt.ArrayLike | None = None,
        errors: str = "raise",
    ) -> Curve:
        """Quantities at separations, or under loads or pressures.

        Parameters
        ----------
        scene : Scene, Scenes or sequence of Scene
            The scene; many scenes are broadcast against separations or loads.
        separation : array_like
            From the scene's plane, in ``separation_unit``, or texts with a unit, as "1 um" (also
            loads and pressures, as "2 kN"). Masked values stay masked.
        quantities : str or sequence of str
            Of "force" [N], "area" [m^2], "stiffness" and "tangent" [N/m], "pressure" [Pa],
            "area-fraction", "contacts", "contact-radius-sum" [m], "unloading-stiffness" (of
            vibrations) and "tangential-stiffness" (in stick) [N/m], "thermal-conductance"
            [W/K], "electrical-conductance" [S], both with "-per-area" over the nominal area,
            "mean-pressure" [Pa], "ln-force", "ln-area", "elastic-share", "elastic-plastic-share" and
            "plastic-share".
        rtol : float
            Relative tolerance of every value, from 1e-15 to 0.1.
        separation_unit : "asperity_height_std" or "m"
            Unit of the separations.
        load : array_like, optional
            Normal loads [N], in the place of separations. If several separations carry a load, the
            values are those at the largest, the first that approaching bodies reach.
        pressure : array_like, optional
            Mean pressures on the nominal area [Pa], in the place of separations.
        film, lambda_ratio : array_like, optional
            In the place of separations: films [m] between the mean planes of the surfaces, and their
            ratios to the standard deviation of the surface heights.
        approach : array_like, optional
            Approaches of curved bodies [m]. These have "approach", "approach-beyond-hertz", "axis-x",
            "axis-y", "effective-radius", "central-separation" [m], "peak-pressure" [Pa],
            "peak-pressure-ratio" and "central-area-fraction", and totals of their patch.
        errors : "raise" or "mask"
            The treatment of a refused row, as with a load that no separation carries: it raises; or
            its values are masked, and ``Curve.failures`` has the reason.

        Examples
        --------
        >>> import asperity, numpy as np
        >>> scene = asperity.Scene.parse(asperity.template())
        >>> rougher = scene.vary(asperity_height_std=[1e-6, 2e-6]).reshape(2, 1)
        >>> asperity.model("ke").solve(rougher, separation=np.linspace(0, 4, 401)).force.shape
        (2, 401)
        >>> asperity.model("ke").solve(rougher, load=1200.0, quantities="area").area.round(9)
        array([[7.68e-07],
               [7.15e-07]])
        """
        given = {"separation": separation, "load": load, "film": film, "lambda_ratio": lambda_ratio}
        given |= {"approach": approach, "pressure": pressure}
        rows = Rows(scene, *place(separation_unit, **given))
        checked_errors(errors)
        name, columns, failures, found = rows.answer(self, quantities, rtol, "value", errors, True)
        for message in found:
            warn(message, 1)
        return Curve(self, name, rows, rtol, separation_unit, columns, failures)

    def separation_at(
        self,
        scene: SceneLike,
        load: npt.ArrayLike | None = None,
        rtol: float = 1e-10,
        separation_unit: str = "asperity_height_std",
        *,
        pressure: npt.ArrayLike | None = None,
        all: bool = False,
        errors: str = "raise",
    ) -> Floats:
        """The separation at which the force is ``load`` [N], or the mean pressure on the nominal
        area ``pressure`` [Pa], in the shape of scenes and loads.

        If several separations carry a load, as with AT as printed, it is the largest, the first that
        approaching bodies reach. With ``all=True`` every number is an ascending array of all of them.

        >>> import asperity
        >>> scene = asperity.Scene.parse(asperity.template())
        >>> asperity.model("ke").separation_at(scene, load=[1, 10, 100]).round(4)
        array([3.5715, 2.9723, 2.2698])
        """
        rows = Rows(scene, *place(load=load, pressure=pressure))
        unit = checked_unit(separation_unit)
        found: Floats = rows.separations(self, unit, rtol, checked_errors(errors), all)
        return found

    def compile(
        self,
        scene: Scene,
        quantities: str | Sequence[str] = ("force", "tangent"),
        rtol: float = 1e-10,
        separation_unit: str = "asperity_height_std",
    ) -> Contact:
        """The model compiled on one scene for many evaluations, as in codes that step in time.

        >>> import asperity
        >>> scene = asperity.Scene.parse(asperity.template())
        >>> contact = asperity.model("ke").compile(scene, separation_unit="m")
        >>> force, tangent = contact.force_and_tangent(2e-6)  # N and N/m at a gap in m
        >>> f"{force:.2f} N, {tangent:.3e} N/m"
        '216.94 N, 5.988e+08 N/m'
        """
        unit = checked_unit(separation_unit)
        return Contact(self, one_scene(scene, "compile"), quantities, rtol, unit)

    def unloading(
        self,
        scene: Scene,
        closest: float | str | None = None,
        law: str = "hertz",
        rtol: float = 1e-10,
        separation_unit: str = "asperity_height_std",
        *,
        load: float | str | None = None,
        pressure: float | str | None = None,
    ) -> Unloading:
        """The unloading and shear of a joint after its first closing.

        Models of equal, upright asperities with circular contacts only.

        Parameters
        ----------
        scene : Scene
            The scene.
        closest : float
            The closest approach, from the scene's plane, in ``separation_unit``, also the unit of
            retreats.
        law : "hertz", "brake" or "etsion"
            The unloading law of an asperity: a Hertzian contact with the force and area at the closest
            approach; Brake 2015, whose area jumps at the start; Etsion, Kligerman & Kadin 2005,
            without an area.
        rtol : float
            Relative tolerance of the integrals, from 1e-15 to 0.1.
        load, pressure : float, optional
            The largest load [N], or pressure on the nominal area [Pa], in the place of ``closest``;
            all three may be texts with a unit, as "2 kN".

        Examples
        --------
        >>> import asperity
        >>> scene = asperity.Scene.parse(asperity.template())
        >>> joint = asperity.model("ke").unloading(scene, load=100.0, separation_unit="m")
        >>> joint.force([0.0, 0.1e-6, 0.5e-6]).round(2)
        array([100.  ,  61.51,   3.21])
        >>> slip = joint.slip(friction=0.3)
        >>> f"{slip.force(1e-8):.2f} N of 30 N; full sliding from {slip.shift_at(0.99):.1e} m on"
        '3.54 N of 30 N; full sliding from 2.2e-07 m on'
        >>> f"{slip.loss(5e-8):.1e} J dissipated per cycle, loss factor {slip.loss_factor(5e-8):.3f}"
        '2.3e-07 J dissipated per cycle, loss factor 0.097'
        >>> f"contact ends at a retreat of {joint.last_contact():.1e} m"
        'contact ends at a retreat of 7.9e-07 m'
        """
        scene = one_scene(scene, "unloading")
        axis, number = place(separation_unit, closest=closest, load=load, pressure=pressure)
        where = axis, one_number("closest" if axis not in LOADS else axis, number)
        return Unloading(self, scene, where, law, rtol, separation_unit)

    def pull_off(
        self, scene: Scene, rtol: float = 1e-10, separation_unit: str = "asperity_height_std"
    ) -> tuple[float, float] | None:
        """The pull-off force of a model with adhesion [N], below 0, and its separation; ``None`` if there
        is no tensile force.

        For "dmt" and "jkr-separation"; asperities of "jkr", which describes approach, have no force
        before they touch.

        >>> import asperity
        >>> rubber = asperity.Interface.against_rigid(asperity.Body(1e6, 0.5), work_of_adhesion=0.05)
        >>> scene = asperity.Scene(rubber, asperity.Surface(1e-4, 1e9, 1e-6), nominal_area=1e-4)
        >>> force, separation = asperity.model("jkr-separation").pull_off(scene)
        >>> f"{force:.3f} N at {separation:.3f} asperity_height_std"
        '-0.956 N at 0.408 asperity_height_std'
        """
        unit = checked_unit(separation_unit)
        return _asperity.pull_off(self, one_scene(scene, "pull_off"), rtol, unit)

    def joint_table(
        self,
        scene: Scene,
        deepest: float | str,
        open: float | str,
        law: str = "hertz",
        tolerance: float = 1e-6,
        separation_unit: str = "asperity_height_std",
    ) -> JointTable:
        """Loading, unloading and reloading for codes that step in time: a table of closest approaches
        from ``deepest`` to ``open`` (in metres also texts with a unit, as "8 um"); beyond ``open``
        loading is elastic.

        The error of an unloading force is at most ``tolerance`` times the force at the closest
        approach.

        >>> import asperity
        >>> scene = asperity.Scene.parse(asperity.template())
        >>> table = asperity.model("ke").joint_table(scene, -1e-6, 5e-6, separation_unit="m")
        >>> force, stiffness, closest = table.step(2e-6)          # first loading
        >>> f"{force:.2f} N, {stiffness:.2e} N/m"
        '216.94 N, 5.99e+08 N/m'
        >>> force, stiffness, closest = table.step(2.1e-6, closest)  # unloading
        >>> f"{force:.2f} N, {stiffness:.2e} N/m, from {closest:.1e} m"
        '137.00 N, 6.83e+08 N/m, from 2.0e-06 m'
        """
        scene, unit = one_scene(scene, "joint_table"), checked_unit(separation_unit)
        given = in_si([deepest, open], "m")
        if tuple(given) != (deepest, open) and unit != "m":
            raise ValueError(
                f"deepest is {deepest!r} and open {open!r}, but separation_unit is {unit!r}: lengths "
                'with a unit need separation_unit="m"'
            )
        ends = one_number("deepest", given[0]), one_number("open", given[1])
        return JointTable(self, scene, ends, law, tolerance, unit)

    def law(
        self, scene: Scene, quantity: str, interference: npt.ArrayLike, rtol: float = 1e-10
    ) -> Floats:
        """The law of one asperity of a scene at interferences [m]: N, m^2 or N/m."""
        w = floats(interference, "interference")
        return self._law(scene, quantity, w.ravel(), rtol).reshape(w.shape)

    def check(self, scene: Scene) -> list[str]:
        """Faults of the laws on one asperity of a scene, as of models written in Python; empty for
        correct laws."""
        laws = None if isinstance(self._definition, str) else Laws(self._definition)
        return (laws and laws.findings(scene.asperity)) or self._check(scene)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Model):
            return NotImplemented
        return self._definition == other._definition and self._options == other._options

    def __hash__(self) -> int:
        return hash(self._definition)

    def __getnewargs_ex__(self) -> tuple[tuple[Any, ...], Options]:
        return (self._definition,), self._options

    def __repr__(self) -> str:
        given = "".join(f", {name}={value!r}" for name, value in self._options.items())
        return f"<asperity.Model {self.id!r}{given}: {self.citation()}>"


def as_model(model: str | Model) -> Model:
    """The model of an id, or a model as it is."""
    return model if isinstance(model, Model) else Model(model)


def as_models(models: str | Model | Sequence[str | Model]) -> list[Model]:
    """One or several of them."""
    return [as_model(one) for one in ([models] if isinstance(models, str | Model) else models)]


def model(model: str | LawsOfAsperity, /, **options: Any) -> Model:
    """A model by id, with options by the names of a scene file's [options]; or a model written in
    Python, from a class whose instances are the laws of one asperity: see ``AsperityLaws``.

    The options of a scene apply to those that are not given.

    >>> import asperity
    >>> asperity.model("at-additive", force="vertical").name
    'AT additive'
    >>> class Hertz:
    ...     force_monotone = True
    ...     def __init__(self, asperity):
    ...         self.asperity = asperity
    ...     def force(self, w):
    ...         return 4 / 3 * self.asperity.equivalent_modulus * self.asperity.radius**0.5 * w**1.5
    ...     def area(self, w):
    ...         return 3.141592653589793 * self.asperity.radius * w
    >>> scene = asperity.Scene.parse(asperity.template())
    >>> mine = asperity.model(Hertz).solve(scene, separation=2.0).force
    >>> theirs = asperity.model("gw").solve(scene, separation=2.0).force
    >>> bool(abs(mine / theirs - 1) < 1e-10)
    True
    """
    return Model(model, **options)


def models() -> list[Model]:
    """Every model, with its default options: those of asperities by year, of whole surfaces, with
    adhesion, with hardening, their variants, and boundary elements.

    >>> import asperity
    >>> ids = [model.id for model in asperity.models()]
    >>> ids[:4], ids[-1], {"persson", "jkr", "ke-random", "gw-pairs"} <= set(ids)
    (['gw', 'ceb', 'zmc', 'ke'], 'bem', True)
    """
    return [Model(name) for name in _asperity.model_ids()]
