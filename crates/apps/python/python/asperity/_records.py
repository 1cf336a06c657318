"""Bodies, interfaces, surfaces and asperities: numbers in SI units, checked by the library.

The table of keys of scene files has the numbers of all but asperities.
"""

from __future__ import annotations

from dataclasses import dataclass, fields, replace

from asperity import _asperity


class Record:
    """Numbers by name, in SI units."""

    #: What a record was made from, if not from its own numbers.
    _origin = None

    def __post_init__(self):
        vars(self).update(_asperity.checked(type(self).__name__, vars(self)))

    @classmethod
    def _made(cls, numbers, origin):
        made = cls(**numbers)
        vars(made)["_origin"] = origin
        return made

    def replace(self, **numbers):
        """A copy with other numbers, by their names."""
        return replace(self, **numbers)

    def __repr__(self):
        numbers = ((one.name, getattr(self, one.name)) for one in fields(self))
        given = (f"{name}={value!r}" for name, value in numbers if value is not None)
        return f"{type(self).__name__}({', '.join(given)})"


def _numbers(section):
    """Gives a class the numbers of a section of scene files, in its documentation, too."""

    def add(cls):
        cls.__annotations__, lines = {}, []
        for name, unit, required, text in _asperity.numbers_of(section):
            cls.__annotations__[name] = "float" if required else "float | None"
            kind = ("float or str" if unit else "float") + ("" if required else ", optional")
            lines.append(f"{name} : {kind}\n    {text}")
            if not required:
                setattr(cls, name, None)
        cls.__doc__ = cls.__doc__.replace("PARAMETERS", "\n    ".join("\n".join(lines).split("\n")))
        return dataclass(frozen=True, repr=False, match_args=False)(cls)

    return add


@_numbers("body")
class Body(Record):
    """One elastic-plastic body.

    Numbers are in SI units, or texts with their unit, as "210 GPa". A body without hardness and
    yield strength never yields: only gw, persson, dmt and jkr accept it.

    Parameters
    ----------
    PARAMETERS

    Examples
    --------
    >>> import asperity
    >>> asperity.Body(210e9, 0.3, hardness=2e9)
    Body(youngs_modulus=210000000000.0, poissons_ratio=0.3, hardness=2000000000.0)
    >>> asperity.Body("210 GPa", 0.3, hardness="2 GPa") == asperity.Body(210e9, 0.3, 2e9)
    True
    """

    @staticmethod
    def material(name):
        """A material of the list, by its name in scene files; `asperity.materials()` has the list.

        >>> import asperity
        >>> asperity.Body.material("stainless-304").youngs_modulus
        193000000000.0
        """
        return _asperity.material(name)


@_numbers("interface")
class Interface(Record):
    """The equivalent properties of two bodies in contact.

    Numbers are in SI units, or texts with their unit, as "116 GPa". Surfaces without hardness and
    yield strength never yield: only gw, persson, dmt and jkr accept them.

    Parameters
    ----------
    PARAMETERS

    Examples
    --------
    >>> import asperity
    >>> steel = asperity.Body(210e9, 0.3, hardness=2e9)
    >>> interface = asperity.Interface.between(steel, steel)
    >>> f"{interface.equivalent_modulus:.4g} {interface.equivalent_shear_modulus:.4g}"
    '1.154e+11 2.376e+10'
    """

    _origin = ()

    @staticmethod
    def between(first, second, *, work_of_adhesion=None):
        """The interface of two deformable bodies; hardness and Poisson's ratio are those of the
        softer body."""
        return Interface._of({"first": first, "second": second}, work_of_adhesion)

    @staticmethod
    def against_rigid(body, *, work_of_adhesion=None):
        """The interface of a deformable and a rigid body."""
        return Interface._of({"body": body}, work_of_adhesion)

    @staticmethod
    def _of(bodies, work_of_adhesion):
        numbers = _asperity.interface_of(bodies, work_of_adhesion)
        return Interface._made(numbers, tuple(bodies.values()))


@_numbers("surface")
class Surface(Record):
    """Asperities of one radius on a nominally flat surface.

    Numbers are in SI units, or texts with their unit, as "0.2 mm" or "200 1/mm2". For the standard
    deviation of the surface heights use ``of``.

    Parameters
    ----------
    PARAMETERS

    Examples
    --------
    >>> import asperity
    >>> surface = asperity.Surface(2e-4, 2e8, 1e-6)
    >>> round(surface.roughness_parameter, 6)
    0.04
    >>> asperity.Surface("0.2 mm", "200 1/mm2", "1 um") == surface
    True
    """

    @staticmethod
    def of(*, interface=None, **numbers):
        """The surface that follows from the three numbers of one of these descriptions, by the keys
        of a scene file:

        - ``asperity_radius``, ``asperity_density``, ``surface_height_std``: the standard deviation
          of the surface heights in the place of that of the asperity heights.
        - ``plasticity_index``, ``roughness_parameter`` (density times radius times height_std),
          ``asperity_height_std``, with the ``interface``.
        - ``m0`` [m^2], ``m2``, ``m4`` [1/m^2]: the spectral moments of profiles of an isotropic
          Gaussian surface, averages of z^2, z'^2 and z''^2.
        - ``sq``, ``spd``, ``spc``, which instruments report (ISO 25178): the standard deviation of
          the surface heights [m], the density of peaks [1/m^2] and their mean curvature [1/m]; the
          peaks are the asperities.
        - ``surface_height_std``, ``mean_slope``, ``asperity_density``: the mean absolute slope of
          profiles of such a surface, which correlations of conductance use.

        >>> import asperity
        >>> surface = asperity.Surface.of(sq="1.1 um", spd="200 1/mm2", spc="5 1/mm")
        >>> surface.asperity_radius, surface.asperity_density
        (0.0002, 200000000.0)
        """
        return Surface._made(*_asperity.surface_of(numbers, interface))

    def against(self, other):
        """The surface whose gap to a flat is that between this surface and an independent one:
        moments of profiles add. They are the given m0, m2 and m4, or those of an
        isotropic Gaussian surface with these asperities (and this Sq).

        >>> import asperity
        >>> one = asperity.Surface.of(m0=1e-12, m2=1e-4, m4=5e4)
        >>> two = asperity.Surface.of(sq="0.4 um", spd="300 1/mm2", spc="4 1/mm")
        >>> round(one.against(two).asperity_height_std, 9)
        1.037e-06
        """
        return Surface.of(**_asperity.moments_of_both(self, other))

    @property
    def roughness_parameter(self):
        """Density times radius times height_std."""
        return _asperity.derived(self, "roughness_parameter")

    @property
    def mean_plane_offset(self):
        """Height of the mean of the asperity heights above the mean plane of an isotropic Gaussian
        surface [m]."""
        return _asperity.derived(self, "mean_plane_offset")


@dataclass(frozen=True, repr=False, match_args=False)
class Asperity(Record):
    """One asperity with every input resolved: the argument of a model written in Python.

    Made by the engine and by ``Scene.asperity``.
    """

    #: Equivalent modulus E [Pa].
    equivalent_modulus: float
    #: Equivalent shear modulus G [Pa], if given.
    equivalent_shear_modulus: float | None
    #: Poisson's ratio of the softer body.
    poissons_ratio: float
    #: Hardness of the softer body [Pa]; None if it never yields.
    hardness: float | None
    #: Yield strength of the softer body [Pa]; None if it never yields.
    yield_strength: float | None
    #: Maximum contact pressure factor.
    pressure_factor: float
    #: Radius [m].
    radius: float
    #: Work of adhesion [J/m^2], if given.
    work_of_adhesion: float | None = None
    #: Tangent modulus of two like bodies [Pa], if given.
    tangent_modulus: float | None = None
    #: Density of its surface [1/m^2]; None for models without ``uses_density = True``.
    density: float | None = None

    @property
    def critical_interference(self):
        """The interference at the onset of yielding [m]; ValueError if it would exceed the radius,
        or without a hardness."""
        return _asperity.derived(self, "critical_interference")

    @property
    def critical_force(self):
        """The force at the critical interference [N]; ValueError as for ``critical_interference``."""
        return _asperity.derived(self, "critical_force")
