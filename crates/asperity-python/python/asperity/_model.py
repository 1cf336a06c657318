"""Models: by id, or written in Python."""

from __future__ import annotations

import warnings
from collections.abc import Callable, Sequence
from typing import Any, Protocol, TypeAlias

import numpy as np
import numpy.typing as npt

from asperity._arguments import Floats, Many, SceneLike, floats, in_metres, quantity_names
from asperity._asperity import (
    Asperity,
    Contact,
    ContactWarning,
    Engine,
    Scene,
    model_ids,
    separations,
)
from asperity._curve import Curve


class AsperityLaws(Protocol):
    """What a model written in Python must offer: the laws of one asperity.

    The class is called with an ``Asperity``. ``w`` is an array of interferences in metres, all
    above 0; forces come back in N, areas in m^2.

    Optional: ``stiffness(w)`` in N/m, where it is not the tangent of the force; ``kinks``, the
    interferences [m] where a formula changes (a sequence, or a dict of them by quantity), which
    saves time and changes no digit; ``regimes``, a name for each range between the kinks, for
    shares; and on the class ``name``, and ``force_monotone = True`` where the force never falls as
    ``w`` grows, which makes ``separation_at`` quicker.
    """

    def force(self, w: Floats, /) -> npt.ArrayLike:
        """Force [N] at interferences [m]."""

    def area(self, w: Floats, /) -> npt.ArrayLike:
        """Real area [m^2] at interferences [m]."""


LawsOfAsperity: TypeAlias = Callable[[Asperity], AsperityLaws]
Options: TypeAlias = dict[str, str | dict[str, float]]


class Model:
    """A model of rough contact; ``asperity.model`` makes one.

    >>> import asperity
    >>> asperity.model("ke")
    <asperity.Model 'ke': Kogut & Etsion (2002)>
    """

    __slots__ = ("_engine", "_options", "_source", "_what")

    def __init__(self, model: str | LawsOfAsperity, /, **options: str | dict[str, float]) -> None:
        if isinstance(model, str):
            self._engine = Engine.named(model, options)
        elif options:
            raise TypeError("options were given: a model written in Python takes none")
        else:
            self._engine = Engine.of_class(model)
        self._what, self._options = model, options
        self._source = self._engine.source()

    @property
    def id(self) -> str:
        """Short name in lower case: ``ke``."""
        return self._source[0]

    @property
    def name(self) -> str:
        """The acronym: ``KE``."""
        return self._source[1]

    @property
    def source(self) -> str:
        """Authors, year and title of the paper, and how well its text is known."""
        _, name, authors, year, title, provenance = self._source
        if not authors:
            return f"{name}, written in Python"
        return f"{authors} ({year}){', ' + title if title else ''} [{provenance}]"

    @property
    def options(self) -> Options:
        """The options that were given; for the others those of a scene count."""
        return dict(self._options)

    def solve(
        self,
        scene: SceneLike,
        separation: npt.ArrayLike,
        quantities: str | Sequence[str] = ("force",),
        rtol: float = 1e-10,
        separation_unit: str = "asperity_height_std",
    ) -> Curve:
        """Quantities at separations.

        Parameters
        ----------
        scene : Scene, Scenes or sequence of Scene
            What is in contact. Many scenes are broadcast against the separations.
        separation : array_like
            From the plane that the scene chose, in ``separation_unit``.
        quantities : str or sequence of str
            Of "force" [N], "area" [m^2], "stiffness" and "tangent" [N/m].
        rtol : float
            Relative tolerance of every value, from 1e-15 to 0.1.
        separation_unit : "asperity_height_std" or "m"
            Unit of the separations.

        Examples
        --------
        >>> import asperity, numpy as np
        >>> scene = asperity.Scene.parse(asperity.template())
        >>> rougher = scene.vary(asperity_height_std=[1e-6, 2e-6]).reshape(2, 1)
        >>> asperity.model("ke").solve(rougher, separation=np.linspace(0, 4, 401)).force.shape
        (2, 401)
        """
        names, metres, many = (
            quantity_names(quantities),
            in_metres(separation_unit),
            Many(scene, separation),
        )
        contact: Contact | None = None
        name, flat = self.name, many.flat
        if many.one is not None:
            contact = self._engine.compile(many.one, names, rtol)
            name, messages, found = contact.model, contact._warnings(), []
            for quantity in names:
                values, warning = contact._column(quantity, flat, metres, "value")
                found.append(values)
                messages += [warning] if warning is not None else []
        else:
            found, messages = self._engine.sweep(
                many.scenes, many.index, flat, metres, names, rtol, "value"
            )
            messages += [
                f"{name}: the {quantity} is negative at {count} of the values: the model subtracts "
                "more than it adds there"
                for quantity, values in zip(names, found, strict=True)
                if (count := int(np.count_nonzero(values < 0)))
            ]
        for message in messages:
            warnings.warn(message, ContactWarning, stacklevel=2)
        columns = {q: many.shaped(values) for q, values in zip(names, found, strict=True)}
        return Curve(self._engine, name, scene, many, rtol, metres, contact, columns)

    def separation_at(
        self,
        scene: SceneLike,
        load: npt.ArrayLike,
        rtol: float = 1e-10,
        separation_unit: str = "asperity_height_std",
    ) -> Floats:
        """The separation at which the force is ``load`` [N], in the shape of scenes and loads.

        Where several separations carry a load, as for AT as printed, it is the largest: the one
        that two approaching bodies come to first. A warning says so; ``separations_at`` has all.

        >>> import asperity
        >>> scene = asperity.Scene.parse(asperity.template())
        >>> asperity.model("ke").separation_at(scene, load=[1, 10, 100]).round(4)
        array([3.5715, 2.9723, 2.2698])
        """
        many, everything = self._separations(scene, load, rtol, separation_unit)
        several = sum(len(found) > 1 for found in everything)
        if several:
            warnings.warn(
                f"{self.name}: {several} of the loads have several separations, the largest was "
                "taken: separations_at has all",
                ContactWarning,
                stacklevel=2,
            )
        return many.shaped(np.array([found[-1] for found in everything], dtype=np.float64))

    def separations_at(
        self,
        scene: SceneLike,
        load: npt.ArrayLike,
        rtol: float = 1e-10,
        separation_unit: str = "asperity_height_std",
    ) -> npt.NDArray[np.object_]:
        """All separations at which the force is ``load`` [N]: an ascending array for each load."""
        many, everything = self._separations(scene, load, rtol, separation_unit)
        arrays = np.empty(len(everything), dtype=object)
        for k, found in enumerate(everything):
            arrays[k] = found
        return arrays.reshape(many.shape)

    def _separations(
        self, scene: SceneLike, load: npt.ArrayLike, rtol: float, separation_unit: str
    ) -> tuple[Many, list[Floats]]:
        many, metres = Many(scene, load), in_metres(separation_unit)
        found = separations(self._engine, many.scenes, many.index, many.flat, metres, rtol)
        return many, found

    def compile(
        self,
        scene: Scene,
        quantities: str | Sequence[str] = ("force", "tangent"),
        rtol: float = 1e-10,
    ) -> Contact:
        """One scene, prepared for many evaluations: for codes that step in time.

        >>> import asperity
        >>> scene = asperity.Scene.parse(asperity.template())
        >>> contact = asperity.model("ke").compile(scene)
        >>> force, tangent = contact.force_and_tangent(2e-6)  # N and N/m at a gap in m
        >>> f"{force:.2f} N, {tangent:.3e} N/m"
        '216.94 N, 5.988e+08 N/m'
        """
        return self._engine.compile(scene, quantity_names(quantities), rtol)

    def law(
        self, scene: Scene, quantity: str, interference: npt.ArrayLike, rtol: float = 1e-10
    ) -> Floats:
        """The law of one asperity of a scene at interferences [m]: N, m^2 or N/m."""
        w = floats(interference)
        return self._engine.law(scene, quantity, w.ravel(), rtol).reshape(w.shape)

    def check(self, scene: Scene) -> list[str]:
        """What is wrong with the laws on one asperity of a scene: for models of your own."""
        return self._engine.check(scene)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Model):
            return NotImplemented
        return self._what == other._what and self._options == other._options

    def __hash__(self) -> int:
        return hash(self._what)

    def __reduce__(self) -> tuple[Any, ...]:
        return _rebuilt, (self._what, self._options)

    def __repr__(self) -> str:
        _, _, authors, year, _, _ = self._source
        given = "".join(f", {name}={value!r}" for name, value in self._options.items())
        whose = f"{authors} ({year})" if authors else "written in Python"
        return f"<asperity.Model {self.id!r}{given}: {whose}>"


def _rebuilt(what: str | LawsOfAsperity, options: Options) -> Model:
    return Model(what, **options)


def model(model: str | LawsOfAsperity, /, **options: str | dict[str, float]) -> Model:
    """A model by its id, with options by the names of a scene file's [options].

    Options that are not given are those of the scene. A class whose instances are the laws of one
    asperity is a model, too: see ``AsperityLaws``.

    >>> import asperity
    >>> asperity.model("at", at_reading="additive").name
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
    """Every model with its default options, simplest first.

    >>> import asperity
    >>> [model.id for model in asperity.models()][:4]
    ['gw', 'ceb', 'zmc', 'ke']
    """
    return [Model(name) for name in model_ids()]
