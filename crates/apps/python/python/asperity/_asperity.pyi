"""The compiled part of the package. Its attributes are read-only: Final."""

from collections.abc import Callable, Iterable, Mapping, Sequence
from os import PathLike
from typing import (
    Any,
    ClassVar,
    Final,
    Literal,
    SupportsFloat,
    SupportsIndex,
    TypeAlias,
    final,
    overload,
)

import numpy as np
import numpy.typing as npt
from typing_extensions import Self, disjoint_base

from asperity._advice import Answer
from asperity._arguments import Scenes
from asperity._records import Asperity, Body, Interface, Surface
from asperity._table import Table

__all__ = [
    "Contact",
    "ContactWarning",
    "Engine",
    "JointTable",
    "NotConverged",
    "PartialSlip",
    "Scene",
    "Topography",
    "Unloading",
    "UnsupportedFormat",
    "answer",
    "bem",
    "best",
    "check",
    "contact_table",
    "fit",
    "materials",
    "column_of",
    "model_ids",
    "profile",
    "pull_off",
    "quantities",
    "quantity",
    "random_surface",
    "sealing_pressure",
    "separations",
    "shares",
    "template",
    "checked",
    "derived",
    "interface_of",
    "material",
    "moments_of_both",
    "numbers_of",
    "surface_of",
]

_Floats: TypeAlias = npt.NDArray[np.float64]
_Float: TypeAlias = SupportsFloat | SupportsIndex
_Distance: TypeAlias = _Float | str
_Spacing: TypeAlias = _Distance | tuple[_Distance, _Distance]
# Fields by name.
_Fields: TypeAlias = dict[str, Any]
# The Rows of the package.
_Rows: TypeAlias = Any
# A scan, and how it is pressed.
_Pressing: TypeAlias = tuple[str | None, bool]
_Pressed: TypeAlias = tuple[Topography | Scene, Interface | None, str | None, _Pressing]
# A model, rows, quantities and the relative tolerance.
_Asked: TypeAlias = tuple[Engine, _Rows, str | Iterable[str], _Float]
_Failures: TypeAlias = list[tuple[int, BaseException]]
# Columns by their heads, and findings.
_Table: TypeAlias = tuple[dict[str, Any], list[_Fields], list[str]]

class NotConverged(RuntimeError): ...
class UnsupportedFormat(ValueError): ...
class ContactWarning(UserWarning): ...

_Number: TypeAlias = _Float | str
_Heights: TypeAlias = str | Mapping[str, float] | tuple[npt.ArrayLike, npt.ArrayLike]
_Options: TypeAlias = Mapping[str, str | float | Mapping[str, float]]

@final
class Scene:
    def __new__(
        cls,
        interface: Interface,
        surface: Surface | Mapping[str, Any],
        nominal_area: _Number | None = None,
        heights: _Heights | None = None,
        separation_from: Literal["asperity-mean", "surface-mean"] | None = None,
        mean_plane_offset: _Number | None = None,
        options: _Options | None = None,
        accept: Sequence[str] = (),
        curvature: Mapping[str, _Number] | None = None,
    ) -> Scene: ...
    @staticmethod
    def from_toml(path: str | PathLike[str], accept: Sequence[str] = ()) -> Scene: ...
    @staticmethod
    def parse(
        text: str, directory: str | PathLike[str] = ".", accept: Sequence[str] = ()
    ) -> Scene: ...
    interface: Final[Interface]
    surface: Final[Surface]
    nominal_area: Final[float]
    heights: Final[_Heights]
    separation_from: Final[Literal["asperity-mean", "surface-mean"]]
    mean_plane_offset: Final[float | None]
    options: Final[dict[str, str | float | dict[str, float]]]
    accept: Final[tuple[str, ...]]
    curvature: Final[dict[str, float] | None]
    def replace(self, **numbers: _Number) -> Scene: ...
    def vary(self, **columns: npt.ArrayLike) -> Scenes: ...
    def at(self, end: str) -> Scene: ...
    asperity: Final[Asperity]
    plasticity_index: Final[float]
    def answer(
        self,
        quantities: str | Sequence[str] | None = None,
        *,
        load: npt.ArrayLike | None = None,
        pressure: npt.ArrayLike | None = None,
        approach: npt.ArrayLike | None = None,
        rtol: _Float = 1e-10,
        solve: bool = False,
        solved: Table | None = None,
    ) -> Answer: ...
    def profile(
        self, load: float | str, model: str = "best", *, rtol: _Float = 1e-6
    ) -> Table: ...
    def flow_factors(
        self,
        lambda_ratio: Sequence[float],
        *,
        quantities: str | Iterable[str] | None = None,
        pairs: bool = False,
    ) -> dict[str, list[float]]: ...
    def models(self) -> list[str]: ...
    def to_toml(self, path: str | PathLike[str] | None = None) -> str: ...
    def _points(self) -> tuple[list[Scene], dict[str, list[bool]]]: ...
    def _inputs_in_si(self, given: dict[str, Any]) -> dict[str, Any]: ...
    def _warn_of_ranges(self) -> None: ...
    def _identity(self) -> str: ...
    def __copy__(self) -> Scene: ...
    def __deepcopy__(self, _memo: object) -> Scene: ...
    def _usual_reference(self) -> str: ...
    def __eq__(self, other: object, /) -> bool: ...
    __hash__: ClassVar[None]  # type: ignore[assignment]

def check(scene: Scene, place: tuple[Engine, str, _Float] | None = None) -> _Table: ...
def pull_off(
    engine: Engine, scene: Scene, rtol: _Float, unit: str
) -> tuple[float, float] | None: ...
def quantity(text: str, si: str, key: str = "") -> float: ...
def contact_table(
    engine: Engine,
    scene: Scene,
    ends: tuple[str, _Float, _Float],
    spacing: tuple[int, _Float | None, _Float],
    form: tuple[str, str],
    conductance: bool,
) -> tuple[dict[str, _Floats], float, float, str]: ...

@final
class Topography:
    def __new__(
        cls, heights: npt.ArrayLike, dx: _Spacing, unit: str, periodic: bool = False
    ) -> Topography: ...
    @staticmethod
    def read(path: str | PathLike[str], **options: Any) -> Topography: ...
    @staticmethod
    def from_profile(
        positions: Sequence[float] | _Floats, heights: Sequence[float] | _Floats, unit: str
    ) -> Topography: ...
    notes: Final[list[str]]
    shape: Final[tuple[int, int]]
    pixel_size: Final[tuple[float, float]]
    missing_share: Final[float]
    heights: Final[_Floats]
    periodic: Final[bool]
    def statistics(
        self, level: str | None = None, estimator: str = "moments", cutoff: _Float | None = None
    ) -> dict[str, Any]: ...
    def surface(
        self, level: str | None = None, estimator: str = "moments", cutoff: _Float | None = None
    ) -> Surface: ...
    def facing(self, other: Topography, mirrored: bool = False) -> Topography: ...
    def against(self, other: Topography) -> Surface: ...
    def level(self, form: str | None = None) -> Topography: ...
    def fill(self) -> Topography: ...
    def despiked(self) -> Topography: ...
    def filter(self, cutoff: _Float) -> Topography: ...
    def smooth(self, cutoff: _Float) -> Topography: ...
    def report(
        self,
        level: str | None = None,
        smooth: _Float | None = None,
        cutoff: _Float | None = None,
    ) -> dict[str, Any]: ...
    def to_x3p(self, path: str | PathLike[str]) -> None: ...

@disjoint_base
class Engine:
    def __new__(cls, model: str | Callable[..., Any], options: Mapping[str, Any]) -> Self: ...
    id: Final[str]
    name: Final[str]
    _citation: Final[tuple[str, int, str, str]]
    def bibtex(self) -> str: ...
    def _law(
        self, scene: Scene, quantity: str, interferences: _Floats, rtol: _Float
    ) -> _Floats: ...
    def _check(self, scene: Scene) -> list[str]: ...

@final
class Contact:
    def __new__(
        cls,
        model: Engine,
        scene: Scene,
        quantities: str | Iterable[str],
        rtol: _Float,
        separation_unit: str,
    ) -> Contact: ...
    def __getnewargs__(self) -> tuple[Any, ...]: ...
    @overload
    def force(self, separation: float | str) -> float: ...  # type: ignore[overload-overlap]
    @overload
    def force(self, separation: npt.ArrayLike) -> _Floats: ...
    @overload
    def force_and_tangent(self, separation: float | str) -> tuple[float, float]: ...  # type: ignore[overload-overlap]
    @overload
    def force_and_tangent(self, separation: npt.ArrayLike) -> tuple[_Floats, _Floats]: ...
    def evaluate(
        self,
        quantity: str,
        separation: npt.ArrayLike | None = None,
        *,
        load: npt.ArrayLike | None = None,
        pressure: npt.ArrayLike | None = None,
        approach: npt.ArrayLike | None = None,
    ) -> Any: ...
    def prepare(self, low: float | str, high: float | str) -> None: ...
    model: Final[str]
    scene: Final[Scene]
    quantities: Final[tuple[str, ...]]
    rtol: Final[float]
    separation_unit: Final[str]

@final
class Unloading:
    def __new__(
        cls,
        model: Engine,
        scene: Scene,
        place: tuple[str, _Float],
        law: str,
        rtol: _Float,
        separation_unit: str,
    ) -> Unloading: ...
    def __getnewargs__(self) -> tuple[Any, ...]: ...
    @overload
    def force(self, retreat: float | str) -> float: ...  # type: ignore[overload-overlap]
    @overload
    def force(self, retreat: npt.ArrayLike) -> _Floats: ...
    @overload
    def area(self, retreat: float | str) -> float: ...  # type: ignore[overload-overlap]
    @overload
    def area(self, retreat: npt.ArrayLike) -> _Floats: ...
    @overload
    def stiffness(self, retreat: float | str) -> float: ...  # type: ignore[overload-overlap]
    @overload
    def stiffness(self, retreat: npt.ArrayLike) -> _Floats: ...
    @overload
    def returned(self, retreat: float | str) -> float: ...  # type: ignore[overload-overlap]
    @overload
    def returned(self, retreat: npt.ArrayLike) -> _Floats: ...
    @overload
    def contacts(self, retreat: float | str) -> float: ...  # type: ignore[overload-overlap]
    @overload
    def contacts(self, retreat: npt.ArrayLike) -> _Floats: ...
    def last_contact(self) -> float: ...
    def loss_factor(self) -> float: ...
    def dissipated(self) -> float: ...
    def slip(self, friction: _Float) -> PartialSlip: ...
    closest: Final[float]
    law: Final[str]
    scene: Final[Scene]
    rtol: Final[float]
    separation_unit: Final[str]

@final
class JointTable:
    def __new__(
        cls,
        model: Engine,
        scene: Scene,
        ends: tuple[_Float, _Float],
        law: str,
        tolerance: _Float,
        separation_unit: str,
    ) -> JointTable: ...
    def __getnewargs__(self) -> tuple[Any, ...]: ...
    @overload
    def step(
        self, separation: float, closest: float | None = ...
    ) -> tuple[float, float, float]: ...
    @overload
    def step(
        self, separation: npt.ArrayLike, closest: npt.ArrayLike | None = ...
    ) -> tuple[_Floats, _Floats, _Floats]: ...
    ends: Final[tuple[float, float]]
    law: Final[str]
    scene: Final[Scene]
    tolerance: Final[float]
    separation_unit: Final[str]

@final
class PartialSlip:
    def __new__(cls, unloading: Unloading, friction: _Float) -> PartialSlip: ...
    def __getnewargs__(self) -> tuple[Any, ...]: ...
    @overload
    def force(self, shift: float | str) -> float: ...  # type: ignore[overload-overlap]
    @overload
    def force(self, shift: npt.ArrayLike) -> _Floats: ...
    @overload
    def loop_force(  # type: ignore[overload-overlap]
        self, shift: float | str, amplitude: _Float | str, *, forth: bool = False
    ) -> float: ...
    @overload
    def loop_force(
        self, shift: npt.ArrayLike, amplitude: _Float | str, *, forth: bool = False
    ) -> _Floats: ...
    @overload
    def loss(self, amplitude: float | str) -> float: ...  # type: ignore[overload-overlap]
    @overload
    def loss(self, amplitude: npt.ArrayLike) -> _Floats: ...
    @overload
    def loss_factor(self, amplitude: float | str) -> float: ...  # type: ignore[overload-overlap]
    @overload
    def loss_factor(self, amplitude: npt.ArrayLike) -> _Floats: ...
    @overload
    def amplitude_at(self, force: float | str) -> float: ...  # type: ignore[overload-overlap]
    @overload
    def amplitude_at(self, force: npt.ArrayLike) -> _Floats: ...
    def shift_at(self, share: _Float = 0.99) -> float: ...
    unloading: Final[Unloading]
    friction: Final[float]
    limit: Final[float]

def answer(
    asked: _Asked,
    aspect: Literal["value", "ln", "error"],
    stop: bool,
    checked: bool,
) -> tuple[str, dict[str, _Floats], _Failures, list[str]]: ...
def separations(
    asked: _Asked, unit: str, all: bool, stop: bool
) -> tuple[_Floats | list[_Floats], _Failures]: ...
def shares(asked: _Asked) -> dict[str, _Floats]: ...
def profile(scene: Scene, load: _Float, model: str, rtol: _Float) -> _Table: ...
def best(
    scene: Scene,
    place: tuple[str, Sequence[_Float]],
    quantities: str | Iterable[str] | None,
    rtol: _Float,
    solving: bool | tuple[list[tuple[float, dict[str, float]]], list[str]],
) -> tuple[_Table, tuple[list[str], list[list[str]]]]: ...
def bem(
    pressed: _Pressed,
    given: tuple[str, Sequence[_Float]],
    keep: bool,
    quantities: str | Iterable[str] | None,
) -> tuple[_Table, list[_Floats] | None, list[int]]: ...
def sealing_pressure(pressed: _Pressed, samples: int) -> _Table: ...
def fit(
    scene: Scene,
    data: str | Sequence[tuple[str, Sequence[float | None]]],
    free: Sequence[str],
    engines: Sequence[Engine],
) -> list[dict[str, Any]]: ...
def quantities(names: str | Iterable[str] | None = None) -> dict[str, str]: ...
def numbers_of(section: str) -> list[tuple[str, str, bool, str]]: ...
def checked(kind: str, given: _Fields) -> _Fields: ...
def interface_of(bodies: dict[str, Body], work_of_adhesion: _Number | None) -> _Fields: ...
def surface_of(given: _Fields, interface: Interface | None) -> tuple[_Fields, _Fields | None]: ...
def moments_of_both(one: Surface, other: Surface) -> _Fields: ...
def derived(record: Surface | Asperity, name: str) -> float: ...
def material(name: str) -> Body: ...
def materials() -> dict[str, tuple[str, Body, str]]: ...
def column_of(input: str) -> str: ...
def model_ids() -> list[str]: ...
def template() -> str: ...

def random_surface(
    shape: tuple[int, int],
    pixel_size: _Spacing,
    *,
    long: _Float,
    short: _Float,
    roll_off: _Float | None = None,
    hurst: _Float = 0.8,
    sq: _Float | None = None,
    gradient: _Float | None = None,
    skewness: _Float | None = None,
    anisotropy: _Float = 1.0,
    direction: _Float = 0.0,
    seed: int = 0,
) -> Topography: ...
