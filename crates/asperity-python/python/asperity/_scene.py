"""What is in contact: bodies, surfaces, scenes, and many scenes at once."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from os import PathLike
from pathlib import Path
from typing import Any, ClassVar, Literal, TypeAlias

import numpy as np
import numpy.typing as npt

from asperity import _asperity
from asperity._asperity import Engine, SceneFile, floats
from asperity._check import Check

Floats: TypeAlias = npt.NDArray[np.float64]
Plane: TypeAlias = Literal["asperity-mean", "surface-mean"]
Options: TypeAlias = Mapping[str, str | float | Mapping[str, float]]
#: A name, a skewness, or heights [m] and densities [1/m].
Heights: TypeAlias = str | Mapping[str, float] | tuple[npt.ArrayLike, npt.ArrayLike]


class _Given:
    """A dataclass that shows what was given, and holds what the library makes of it."""

    _checked: ClassVar[Callable[[Any], dict[str, Any]]]

    def __post_init__(self) -> None:
        try:
            checked = type(self)._checked(self)
        except TypeError:
            for entry in dataclasses.fields(self):  # type: ignore[arg-type]
                value = getattr(self, entry.name)
                is_number = hasattr(value, "__float__") or (value is None and not entry.default)
                if str(entry.type).startswith("float") and not is_number:
                    given = f"{type(self).__name__}: {entry.name} is {value!r}"
                    raise TypeError(f"{given}: a number in SI units was required") from None
            raise
        for name, value in checked.items():
            object.__setattr__(self, name, value)

    def __repr__(self) -> str:
        given = []
        for entry in dataclasses.fields(self):  # type: ignore[arg-type]
            value = getattr(self, entry.name)
            if entry.init and value not in (entry.default, {}):
                table = isinstance(value, tuple)
                shown = f"<table of {len(value[0])} points>" if table else repr(value)
                given.append(f"{entry.name}={shown}")
        return f"{type(self).__name__}({', '.join(given)})"


@dataclass(frozen=True, repr=False)
class Body(_Given):
    """One elastic-plastic body.

    Parameters
    ----------
    youngs_modulus : float
        Young's modulus [Pa], above 0.
    poissons_ratio : float
        Poisson's ratio, above -1 and at most 0.5.
    hardness : float, optional
        Hardness [Pa]; 2.8 times the yield strength when not given.
    yield_strength : float, optional
        Yield strength [Pa]; the hardness over 2.8 when not given. One of the two is needed.
    thermal_conductivity : float, optional
        k [W/(m K)], for the quantity "thermal-conductance" alone.
    electrical_resistivity : float, optional
        rho [ohm m], for the quantity "electrical-conductance" alone.

    Examples
    --------
    >>> import asperity
    >>> asperity.Body(210e9, 0.3, hardness=2e9)
    Body(youngs_modulus=210000000000.0, poissons_ratio=0.3, hardness=2000000000.0)
    """

    youngs_modulus: float
    poissons_ratio: float
    hardness: float | None = None
    yield_strength: float | None = None
    thermal_conductivity: float | None = None
    electrical_resistivity: float | None = None

    _checked = _asperity.checked_body


@dataclass(frozen=True, repr=False)
class Interface(_Given):
    """The equivalent properties of two bodies in contact: what the laws use.

    Parameters
    ----------
    equivalent_modulus : float
        E [Pa]: 1/E = (1-nu1^2)/E1 + (1-nu2^2)/E2.
    poissons_ratio : float
        That of the softer body, above -1 and at most 0.5.
    hardness : float, optional
        Of the softer body [Pa]; 2.8 times the yield strength when not given.
    yield_strength : float, optional
        Of the softer body [Pa]; the hardness over 2.8 when not given. Without either, the surfaces
        never yield, and gw alone can be asked.
    equivalent_shear_modulus : float, optional
        G [Pa]: 1/G = (2-nu1)/G1 + (2-nu2)/G2; the models gao and at, and
        the quantity "tangential-stiffness", need it.
    pressure_factor : float, optional
        Maximum contact pressure factor; 0.454 + 0.41 nu when not given.
    thermal_conductivity : float, optional
        k [W/(m K)]: 2/k = 1/k1 + 1/k2; "thermal-conductance" needs it.
    electrical_resistivity : float, optional
        rho [ohm m]: 2 rho = rho1 + rho2; "electrical-conductance" needs it.
    work_of_adhesion : float, optional
        w_a [J/m^2], at least 0: the models dmt and jkr need it.

    Examples
    --------
    >>> import asperity
    >>> steel = asperity.Body(210e9, 0.3, hardness=2e9)
    >>> interface = asperity.Interface.between(steel, steel)
    >>> f"{interface.equivalent_modulus:.4g} {interface.equivalent_shear_modulus:.4g}"
    '1.154e+11 2.376e+10'
    """

    equivalent_modulus: float
    poissons_ratio: float
    hardness: float | None = None
    yield_strength: float | None = None
    equivalent_shear_modulus: float | None = None
    pressure_factor: float | None = None
    thermal_conductivity: float | None = None
    electrical_resistivity: float | None = None
    work_of_adhesion: float | None = None

    _checked = _asperity.checked_interface

    @staticmethod
    def between(
        first: Body, second: Body, *, work_of_adhesion: float | None = None
    ) -> Interface:
        """Two deformable bodies; hardness and Poisson's ratio are those of the softer one."""
        found = _asperity.interface_of(first, second)
        return Interface(**(found | {"work_of_adhesion": work_of_adhesion}))

    @staticmethod
    def against_rigid(body: Body, *, work_of_adhesion: float | None = None) -> Interface:
        """A deformable body on a rigid one."""
        found = _asperity.interface_of(body, None)
        return Interface(**(found | {"work_of_adhesion": work_of_adhesion}))


@dataclass(frozen=True, repr=False)
class Surface(_Given):
    """Asperities of one radius on a nominally flat surface.

    Parameters
    ----------
    asperity_radius : float
        R [m], above 0.
    asperity_density : float
        Asperities per area [1/m^2], above 0.
    asperity_height_std : float
        Standard deviation of the asperity heights [m], above 0; not that of the surface heights.

    Examples
    --------
    >>> import asperity
    >>> surface = asperity.Surface(2e-4, 2e8, 1e-6)
    >>> round(surface.roughness_parameter, 6)
    0.04
    """

    asperity_radius: float
    asperity_density: float
    asperity_height_std: float

    _checked = _asperity.checked_surface

    @staticmethod
    def from_plasticity_index(
        plasticity_index: float,
        roughness_parameter: float,
        asperity_height_std: float,
        interface: Interface,
    ) -> Surface:
        """From the plasticity index, the roughness parameter (density times radius times
        height_std), the standard deviation of the asperity heights [m] and the interface."""
        numbers = plasticity_index, roughness_parameter, asperity_height_std
        return Surface(**_asperity.surface_from_plasticity_index(*numbers, interface))

    @staticmethod
    def from_moments(m0: float, m2: float, m4: float) -> Surface:
        """From the spectral moments of profiles of an isotropic Gaussian surface: averages of z^2
        [m^2], z'^2 and z''^2 [1/m^2]."""
        return Surface(**_asperity.surface_from_moments(m0, m2, m4))

    @staticmethod
    def from_surface_std(
        asperity_radius: float, asperity_density: float, surface_height_std: float
    ) -> Surface:
        """From radius [m], density [1/m^2] and the standard deviation of the surface heights [m]."""
        numbers = asperity_radius, asperity_density, surface_height_std
        return Surface(**_asperity.surface_from_std(*numbers))

    @property
    def roughness_parameter(self) -> float:
        """Density times radius times height_std; usually 0.02 to 0.1."""
        return _asperity.roughness_of(self)[0]

    @property
    def mean_plane_offset(self) -> float:
        """How far the mean of the asperity heights lies above the mean plane of an isotropic
        Gaussian surface [m]."""
        return _asperity.roughness_of(self)[1]


@dataclass(frozen=True)
class Asperity:
    """One asperity, with every input resolved: what a law written in Python is made for.

    Made by the engine, and by ``Scene.asperity``.
    """

    #: E [Pa].
    equivalent_modulus: float
    #: G [Pa], where it was given.
    equivalent_shear_modulus: float | None
    #: Poisson's ratio of the softer body.
    poissons_ratio: float
    #: Hardness of the softer body [Pa], unless it never yields.
    hardness: float | None
    #: Yield strength of the softer body [Pa], unless it never yields.
    yield_strength: float | None
    #: Maximum contact pressure factor.
    pressure_factor: float
    #: Radius [m].
    radius: float
    #: Work of adhesion [J/m^2], where it was given.
    work_of_adhesion: float | None = None

    @property
    def critical_interference(self) -> float:
        """The interference at which yielding begins [m]; ValueError where it would exceed the
        radius, or there is no hardness."""
        return _asperity.critical_of(self)[0]

    @property
    def critical_force(self) -> float:
        """The force at the critical interference [N]; ValueError where there is none."""
        return _asperity.critical_of(self)[1]


@dataclass(frozen=True, repr=False)
class Scene(_Given):
    """Two bodies, their equivalent rough surface, and how much of it there is.

    Parameters
    ----------
    interface : Interface
        The two bodies.
    surface : Surface
        The equivalent rough surface.
    nominal_area : float
        The apparent area of contact [m^2], above 0.
    heights : "gaussian", "exponential", {"skewness": s} or (heights, densities)
        How the asperity heights are spread. A skewness from -1 to 2 stands for a Weibull
        density. A table has heights [m], ascending, and the density there [1/m]: linear between its
        points, 0 outside; heights count from the table's own mean.
    separation_from : "asperity-mean" or "surface-mean"
        The plane that separations are measured from: the mean of the asperity heights (for
        exponential heights: the lowest asperity), or the mean plane of the surface.
    mean_plane_offset : float, optional
        How far the mean of the asperity heights lies above the mean plane [m], where it was
        measured; when not given, that of the table of heights, or of an isotropic Gaussian surface.
    options : dict, optional
        Options of the models, as in the section [options] of a scene file; and
        ``{"asperities": "random"}``: "ke" stands for "ke-random" then, whose heights and radii are
        spread together as on an isotropic Gaussian surface with these moments.

    Examples
    --------
    >>> import asperity
    >>> interface = asperity.Interface(116e9, 0.31, hardness=1.12e9)
    >>> scene = asperity.Scene(interface, asperity.Surface(3.6e-4, 1.1e8, 1e-6), nominal_area=3e-5)
    >>> round(scene.plasticity_index, 2)
    5.98
    >>> scene.replace(hardness=2.24e9).interface.hardness
    2240000000.0
    """

    interface: Interface
    surface: Surface
    nominal_area: float
    heights: Heights = "gaussian"
    separation_from: Plane = "asperity-mean"
    mean_plane_offset: float | None = None
    options: Options = field(default_factory=dict)
    _file: SceneFile = field(init=False, compare=False)

    def __post_init__(self) -> None:
        self._take(SceneFile(self))

    def _take(self, file: SceneFile) -> None:
        given = file.fields()
        given["interface"] = Interface(**given["interface"])
        given["surface"] = Surface(**given["surface"])
        if not isinstance(given["heights"], str | Mapping):
            given["heights"] = tuple(map(tuple, given["heights"]))
        for name, value in given.items():
            object.__setattr__(self, name, value)
        object.__setattr__(self, "_file", file)

    @staticmethod
    def _of(file: SceneFile) -> Scene:
        scene = object.__new__(Scene)
        scene._take(file)
        return scene

    @staticmethod
    def from_toml(path: str | PathLike[str]) -> Scene:
        """Reads a scene file and the files it names."""
        return Scene._of(SceneFile.load(path))

    @staticmethod
    def parse(text: str, directory: str | PathLike[str] = ".") -> Scene:
        """Reads a scene from the text of a scene file; relative paths in it begin at
        ``directory``."""
        return Scene._of(SceneFile.parse(text, directory))

    def replace(self, **numbers: float) -> Scene:
        """The same scene with other numbers, by the names of a scene file: equivalent_modulus,
        equivalent_shear_modulus, poissons_ratio, hardness, yield_strength, pressure_factor,
        thermal_conductivity, electrical_resistivity, work_of_adhesion, asperity_radius,
        asperity_density, asperity_height_std, nominal_area; or plasticity_index and
        roughness_parameter in the place of radius and density."""
        return Scene._of(self._file.replace(numbers))

    def vary(self, **columns: npt.ArrayLike) -> Scenes:
        """Many scenes like this one: the names of ``replace``, with arrays that are broadcast."""
        return Scenes(self, columns)

    @property
    def asperity(self) -> Asperity:
        """One asperity of the surface, with every input resolved."""
        return Asperity(**self._file.asperity())

    @property
    def asperities(self) -> float:
        """The number of asperities: density times nominal area."""
        return self._file.asperities()

    @property
    def plasticity_index(self) -> float:
        """The square root of height_std over the critical interference."""
        return self._file.plasticity_index()

    def models(self) -> list[str]:
        """The ids of the models that this scene allows, simplest first."""
        return self._file.models()

    def to_toml(self, path: str | PathLike[str] | None = None) -> str:
        """The text of a scene file that reads back exactly, written to ``path`` if there is one. A
        table of heights goes to a file beside it, of the same name with the end ``.csv``.

        >>> import asperity
        >>> scene = asperity.Scene.parse(asperity.template())
        >>> asperity.Scene.parse(scene.to_toml()) == scene
        True
        """
        target = None if path is None else Path(path)
        heights_file = None
        if target is not None and not isinstance(self.heights, str | Mapping):
            table = target.with_suffix(".csv")
            heights, densities = (np.asarray(column, float).tolist() for column in self.heights)
            rows = zip(heights, densities, strict=True)
            lines = ["height_m,density_per_m", *(f"{z!r},{g!r}" for z, g in rows)]
            table.write_text("\n".join(lines) + "\n", encoding="utf-8")
            heights_file = table.name
        text = self._file.to_toml(heights_file, [])
        if target is not None:
            target.write_text(text, encoding="utf-8")
        return text

    def check(
        self,
        model: str | Engine | None = None,
        separation: float | None = None,
        *,
        load: float | None = None,
        pressure: float | None = None,
        separation_unit: str = "asperity_height_std",
    ) -> Check:
        """What follows from the scene, and what in it is unusual: sizes that no surface or material
        has, with the unit that would explain them. At a separation, load [N] or pressure [Pa], also
        how much touches, how deep contacts are pressed, and whether the model is made for that:
        "ke" unless another is given, or "gw" where there is no hardness.

        >>> import asperity
        >>> interface = asperity.Interface(116, 0.31, hardness=1.12e9)
        >>> surface = asperity.Surface(3.6e-4, 1.1e8, 1e-6)
        >>> print(asperity.Scene(interface, surface, nominal_area=3e-5).check().findings[0])
        error: equivalent_modulus is 116 Pa (usual: 30000 to 1.3e12): 116 looks like GPa; 116 GPa is 1.16e11 Pa
        """
        given = {"separation": separation, "load": load, "pressure": pressure}
        places = [(name, number) for name, number in given.items() if number is not None]
        if len(places) > 1:
            raise TypeError("at most one of separation, load and pressure was expected")
        if not places:
            return Check._of(*_asperity.check(self._file))
        (axis, number), default = places[0], self._file.usual_reference()
        engine = model if isinstance(model, Engine) else Engine(model or default, {})
        axis = separation_unit if axis == "separation" else axis
        return Check._of(*_asperity.check(self._file, (engine, axis, number)))

    def __reduce__(self) -> tuple[Any, ...]:
        return Scene, tuple(getattr(self, entry.name) for entry in dataclasses.fields(self)[:-1])


class Scenes:
    """Many scenes that differ from one in some of its numbers; made by ``Scene.vary``.

    Wherever a scene is taken, so are many; they are broadcast against separations and loads.

    Examples
    --------
    >>> import asperity
    >>> interface = asperity.Interface(116e9, 0.31, hardness=1.12e9)
    >>> scene = asperity.Scene(interface, asperity.Surface(3.6e-4, 1.1e8, 1e-6), nominal_area=3e-5)
    >>> scenes = scene.vary(asperity_height_std=[1e-6, 2e-6, 3e-6])
    >>> scenes
    <asperity.Scenes of shape (3,), asperity_height_std varies>
    >>> asperity.model("gw").solve(scenes, separation=1.0).force.shape
    (3,)
    """

    def __init__(self, base: Scene, columns: Mapping[str, npt.ArrayLike]) -> None:
        _asperity.check_inputs(list(columns))
        arrays = np.broadcast_arrays(*(floats(values, name) for name, values in columns.items()))
        self._base = base
        self._columns = {
            name: floats(values, name) for name, values in zip(columns, arrays, strict=True)
        }
        #: Shape of the columns, broadcast.
        self.shape: tuple[int, ...] = arrays[0].shape if arrays else ()

    def reshape(self, *shape: int) -> Scenes:
        """The same scenes in another shape; -1 stands for what is left."""
        columns = {name: values.reshape(shape) for name, values in self._columns.items()}
        return Scenes(self._base, columns)

    def __len__(self) -> int:
        if not self.shape:
            raise TypeError("len() of one scene")
        return self.shape[0]

    def __getitem__(self, index: int | tuple[int, ...]) -> Scene:
        numbers = {name: values[index] for name, values in self._columns.items()}
        if any(np.ndim(number) for number in numbers.values()):
            raise IndexError("one index for each axis was required: scenes are taken one by one")
        return self._base.replace(**numbers)

    def __repr__(self) -> str:
        names = ", ".join(self._columns) or "nothing"
        verb = "vary" if len(self._columns) > 1 else "varies"
        return f"<asperity.Scenes of shape {self.shape}, {names} {verb}>"
