"""The compiled part: what the package is made of."""

from collections.abc import Callable, Iterable, Mapping, Sequence
from os import PathLike
from typing import Any, Literal, SupportsFloat, SupportsIndex, TypeAlias, final, overload

import numpy as np
import numpy.typing as npt
from typing_extensions import Self, disjoint_base

__all__ = [
    "Contact",
    "ContactWarning",
    "Engine",
    "JointTable",
    "NotConverged",
    "PartialSlip",
    "SceneFile",
    "Topography",
    "Unloading",
    "answer",
    "bem",
    "check",
    "check_inputs",
    "checked_body",
    "checked_interface",
    "checked_surface",
    "contact_table",
    "correlated",
    "critical_of",
    "findings",
    "floats",
    "gap_conductance",
    "interface_of",
    "model_ids",
    "plan",
    "pull_off",
    "quantities",
    "quantity",
    "recommend",
    "roughness_of",
    "separations",
    "shares",
    "surface_from_moments",
    "surface_from_plasticity_index",
    "surface_from_std",
    "svg",
    "template",
    "truth",
]

_Floats: TypeAlias = npt.NDArray[np.float64]
_Float: TypeAlias = SupportsFloat | SupportsIndex
_Spacing: TypeAlias = _Float | tuple[_Float, _Float]
# A dataclass of the package, and its fields by their names.
_Data: TypeAlias = Any
_Fields: TypeAlias = dict[str, Any]
# What a Rows of the package has.
_Rows: TypeAlias = Any
_State: TypeAlias = tuple[float | None, float | None, float | None]
_Failures: TypeAlias = list[tuple[int, BaseException]]

class NotConverged(RuntimeError): ...
class ContactWarning(UserWarning): ...

def checked_body(body: _Data) -> _Fields: ...
def checked_interface(interface: _Data) -> _Fields: ...
def checked_surface(surface: _Data) -> _Fields: ...
def interface_of(first: _Data, second: _Data | None) -> _Fields: ...
def surface_from_plasticity_index(
    index: _Float, parameter: _Float, height_std: _Float, interface: _Data
) -> _Fields: ...
def surface_from_moments(m0: _Float, m2: _Float, m4: _Float) -> _Fields: ...
def surface_from_std(radius: _Float, density: _Float, std: _Float) -> _Fields: ...
def roughness_of(surface: _Data) -> tuple[float, float]: ...
def critical_of(one: _Data) -> tuple[float, float]: ...

@final
class SceneFile:
    def __new__(cls, fields: _Data) -> SceneFile: ...
    @staticmethod
    def load(path: str | PathLike[str]) -> SceneFile: ...
    @staticmethod
    def parse(text: str, directory: str | PathLike[str]) -> SceneFile: ...
    def replace(self, numbers: Mapping[str, _Float]) -> SceneFile: ...
    def fields(self) -> _Fields: ...
    def asperity(self) -> _Fields: ...
    def asperities(self) -> float: ...
    def plasticity_index(self) -> float: ...
    def usual_reference(self) -> str: ...
    def models(self) -> list[str]: ...
    def to_toml(self, heights_file: str | None, comments: Sequence[str]) -> str: ...

def check(
    scene: SceneFile, asked: tuple[Engine, str, _Float] | None = None
) -> tuple[list[tuple[str, float, str, str]], list[_Fields]]: ...
def findings(engine: Engine, rows: _Rows) -> list[str]: ...
def pull_off(
    engine: Engine, scene: SceneFile, rtol: _Float, unit: str
) -> tuple[float, float] | None: ...
def quantity(text: str, si: str) -> float: ...
def correlated(
    name: str, scene: SceneFile, pressures: _Floats
) -> tuple[tuple[list[float], list[float], list[bool]], list[float], float | None]: ...
def gap_conductance(conductivity: _Float, gap: _Float, gas_parameter: _Float) -> float: ...
def svg(
    csv: str, x: tuple[str, str, bool], y: Sequence[tuple[str, str, bool]], curve: str
) -> str: ...
def contact_table(
    engine: Engine,
    scene: SceneFile,
    ends: tuple[str, _Float, _Float],
    spacing: tuple[int, _Float | None, _Float],
    form: tuple[str, str],
    beside: tuple[str | None, _Float | None],
) -> tuple[list[float], list[float], list[float], float, float, str]: ...

@disjoint_base
class Topography:
    def __new__(
        cls, heights: npt.ArrayLike, dx: _Spacing, unit: str, periodic: bool = False
    ) -> Topography: ...
    @classmethod
    def read(
        cls,
        path: str | PathLike[str],
        unit: str | None = None,
        pixel_size: _Spacing | None = None,
        max_missing: _Float = 0.1,
    ) -> Any: ...
    @property
    def shape(self) -> tuple[int, int]: ...
    @property
    def pixel_size(self) -> tuple[float, float]: ...
    @property
    def missing_share(self) -> float: ...
    @property
    def heights(self) -> _Floats: ...
    def statistics(
        self, level: str | None = None, estimator: str = "moments", cutoff: _Float | None = None
    ) -> dict[str, float]: ...
    @property
    def periodic(self) -> bool: ...
    def _filled(self) -> Topography: ...
    def _levelled(self, level: str | None) -> Topography: ...
    def _filtered(self, cutoff: _Float) -> Topography: ...
    def _smoothed(self, cutoff: _Float) -> Topography: ...
    def _summit_density(self) -> tuple[list[float], list[float]]: ...
    def _against(self, other: Topography) -> _Fields: ...
    def _surface(self, level: str | None, estimator: str, cutoff: _Float | None) -> _Fields: ...

@disjoint_base
class Engine:
    def __new__(cls, model: str | Callable[..., Any], options: Mapping[str, Any]) -> Self: ...
    def _source(self, scene: SceneFile | None = None) -> tuple[str, str, _Fields, list[str]]: ...
    def _law(
        self, scene: SceneFile, quantity: str, interferences: _Floats, rtol: _Float
    ) -> _Floats: ...
    def _check(self, scene: SceneFile) -> list[str]: ...

@final
class Contact:
    def __new__(
        cls,
        model: Engine,
        scene: _Data,
        quantities: Sequence[str],
        rtol: _Float,
        separation_unit: str,
    ) -> Contact: ...
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
    ) -> Any: ...
    @property
    def model(self) -> str: ...
    @property
    def scene(self) -> Any: ...
    @property
    def quantities(self) -> tuple[str, ...]: ...
    @property
    def rtol(self) -> float: ...
    @property
    def separation_unit(self) -> str: ...
    def __reduce__(self) -> tuple[Any, ...]: ...

@final
class Unloading:
    def __new__(
        cls,
        model: Engine,
        scene: _Data,
        place: tuple[str, _Float],
        law: str,
        rtol: _Float,
        separation_unit: str,
    ) -> Unloading: ...
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
    @property
    def closest(self) -> float: ...
    @property
    def law(self) -> str: ...
    @property
    def scene(self) -> Any: ...
    @property
    def rtol(self) -> float: ...
    @property
    def separation_unit(self) -> str: ...
    def __reduce__(self) -> tuple[Any, ...]: ...

@final
class JointTable:
    def __new__(
        cls,
        model: Engine,
        scene: _Data,
        ends: tuple[_Float, _Float],
        law: str,
        tolerance: _Float,
        separation_unit: str,
    ) -> JointTable: ...
    def step(self, separation: _Float, closest: _Float = ...) -> tuple[float, float, float]: ...
    def history(self, separation: npt.ArrayLike) -> tuple[_Floats, _Floats]: ...
    @property
    def ends(self) -> tuple[float, float]: ...
    @property
    def law(self) -> str: ...
    @property
    def scene(self) -> Any: ...
    @property
    def tolerance(self) -> float: ...
    @property
    def separation_unit(self) -> str: ...
    def __reduce__(self) -> tuple[Any, ...]: ...

@final
class PartialSlip:
    def __new__(cls, unloading: Unloading, friction: _Float) -> PartialSlip: ...
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
    def shift_at(self, share: _Float = 0.99) -> float: ...
    @property
    def unloading(self) -> Unloading: ...
    @property
    def friction(self) -> float: ...
    def __reduce__(self) -> tuple[Any, ...]: ...

def answer(
    engine: Engine,
    rows: _Rows,
    names: Sequence[str],
    rtol: _Float,
    aspect: Literal["value", "ln", "error"],
    stop: bool,
    threads: int | None,
    checked: bool,
) -> tuple[list[_Floats], _Failures, list[str]]: ...
def separations(
    engine: Engine, rows: _Rows, unit: str, rtol: _Float, all: bool, stop: bool
) -> tuple[_Floats, npt.NDArray[np.int64], _Failures]: ...
def shares(
    engine: Engine, rows: _Rows, quantity: str, rtol: _Float
) -> list[tuple[str, _Floats]]: ...
def plan(
    engine: Engine, rows: _Rows, names: Sequence[str], rtol: _Float
) -> tuple[str, _Fields]: ...
def recommend(
    reference: Engine,
    rows: _Rows,
    names: Sequence[str],
    within: _Float,
    rtol: _Float,
    models: Sequence[str] | None,
) -> tuple[
    str,
    str | None,
    str,
    list[tuple[dict[str, dict[str, float | None]], str | None]],
    list[tuple[str, list[tuple[str, float]], str | None, dict[str, float | None] | None]],
]: ...
def bem(
    scan: object,
    given: str,
    values: Sequence[_Float],
    elastic: bool,
    boundary: str,
    maps_and_mask: tuple[bool, bool],
) -> tuple[
    dict[str, _Floats], tuple[_Floats, _Floats] | None, tuple[int, int], dict[int, str]
]: ...
def truth(
    file: SceneFile,
    pressures: Sequence[_Float],
    elastic: bool,
    boundary: str,
    models: Sequence[str] | None,
    refine_and_mask: tuple[bool, bool],
) -> tuple[
    list[tuple[float, str, _State, _State]], str | None, dict[str, str], dict[int, str]
]: ...
def floats(values: npt.ArrayLike, name: str) -> _Floats: ...
def check_inputs(names: Sequence[str]) -> None: ...
def quantities(names: Iterable[str] = ...) -> dict[str, str]: ...
def model_ids() -> list[str]: ...
def template() -> str: ...
