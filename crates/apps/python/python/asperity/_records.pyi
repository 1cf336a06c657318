"""Bodies, interfaces, surfaces and asperities. Their attributes are read-only: Final."""

from typing import Final, SupportsFloat, SupportsIndex, TypeAlias

from typing_extensions import Self

_Float: TypeAlias = SupportsFloat | SupportsIndex
_Number: TypeAlias = _Float | str

class Record:
    def replace(self, **numbers: _Number | None) -> Self: ...
    def __post_init__(self) -> None: ...
    def __eq__(self, other: object, /) -> bool: ...
    def __hash__(self) -> int: ...

class Body(Record):
    # numbers of Body
    def __init__(
        self,
        youngs_modulus: _Number,
        poissons_ratio: _Float,
        hardness: _Number | None = None,
        yield_strength: _Number | None = None,
        thermal_conductivity: _Number | None = None,
        electrical_resistivity: _Number | None = None,
        tangent_modulus: _Number | None = None,
    ) -> None: ...
    youngs_modulus: Final[float]
    poissons_ratio: Final[float]
    hardness: Final[float | None]
    yield_strength: Final[float | None]
    thermal_conductivity: Final[float | None]
    electrical_resistivity: Final[float | None]
    tangent_modulus: Final[float | None]
    # end
    @staticmethod
    def material(name: str) -> Body: ...

class Interface(Record):
    _origin: tuple[Body, ...]
    # numbers of Interface
    def __init__(
        self,
        equivalent_modulus: _Number,
        poissons_ratio: _Float,
        hardness: _Number | None = None,
        yield_strength: _Number | None = None,
        equivalent_shear_modulus: _Number | None = None,
        pressure_factor: _Float | None = None,
        thermal_conductivity: _Number | None = None,
        electrical_resistivity: _Number | None = None,
        work_of_adhesion: _Number | None = None,
        tangent_modulus: _Number | None = None,
    ) -> None: ...
    equivalent_modulus: Final[float]
    poissons_ratio: Final[float]
    hardness: Final[float | None]
    yield_strength: Final[float | None]
    equivalent_shear_modulus: Final[float | None]
    pressure_factor: Final[float | None]
    thermal_conductivity: Final[float | None]
    electrical_resistivity: Final[float | None]
    work_of_adhesion: Final[float | None]
    tangent_modulus: Final[float | None]
    # end
    @staticmethod
    def between(
        first: Body, second: Body, *, work_of_adhesion: _Number | None = None
    ) -> Interface: ...
    @staticmethod
    def against_rigid(body: Body, *, work_of_adhesion: _Number | None = None) -> Interface: ...

class Surface(Record):
    _origin: dict[str, float] | None
    # numbers of Surface
    def __init__(
        self,
        asperity_radius: _Number,
        asperity_density: _Number,
        asperity_height_std: _Number,
    ) -> None: ...
    asperity_radius: Final[float]
    asperity_density: Final[float]
    asperity_height_std: Final[float]
    # end
    @staticmethod
    def of(*, interface: Interface | None = None, **numbers: _Number) -> Surface: ...
    def against(self, other: Surface) -> Surface: ...
    @property
    def roughness_parameter(self) -> float: ...
    @property
    def mean_plane_offset(self) -> float: ...

class Asperity(Record):
    def __init__(
        self,
        equivalent_modulus: _Number,
        equivalent_shear_modulus: _Number | None,
        poissons_ratio: _Float,
        hardness: _Number | None,
        yield_strength: _Number | None,
        pressure_factor: _Float,
        radius: _Float,
        work_of_adhesion: _Number | None = None,
        tangent_modulus: _Number | None = None,
        density: _Number | None = None,
    ) -> None: ...
    equivalent_modulus: Final[float]
    equivalent_shear_modulus: Final[float | None]
    poissons_ratio: Final[float]
    hardness: Final[float | None]
    yield_strength: Final[float | None]
    pressure_factor: Final[float]
    radius: Final[float]
    work_of_adhesion: Final[float | None]
    tangent_modulus: Final[float | None]
    density: Final[float | None]
    @property
    def critical_interference(self) -> float: ...
    @property
    def critical_force(self) -> float: ...
