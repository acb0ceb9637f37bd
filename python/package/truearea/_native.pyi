"""The core, as the Python modules beside it call it; they document the arguments."""

from collections.abc import Callable, Mapping, Sequence
from typing import Any, Final, TypedDict, final

import numpy as np
import numpy.typing as npt

_Floats = npt.NDArray[np.float64]
_Columns = dict[str, Any]
_Arguments = Mapping[str, Any]
_Note = tuple[str, str, str, tuple[list[str], int | None, int | None, str | None]]
_Maps = tuple[_Floats, Sequence[Any], bool | None]
_Bodies = Surface | tuple[_Maps, _Maps | None]
_Pressed = tuple[Answer, dict[str, Any]]
_Observer = Callable[[str, int, "int | None"], object]

class _SceneFacts(TypedDict):
    title: str
    loads: int
    notes: list[_Note]
    styles: dict[str, tuple[str, str, str]]

VERSION: Final[str]
METADATA_FILES: Final[list[str]]

class InputError(ValueError): ...

def set_threads(count: int) -> None:
    """Let work take so many threads from now on; 1 keeps it on the thread that calls.

    More than eight times the cores are taken as that many. Before any call, ``RAYON_NUM_THREADS`` counts, or the cores.
    """

def threads() -> int:
    """Returns the number of threads."""

def way_out(name: str) -> str | None: ...
def truth(argument: str, given: Any) -> bool:
    """True or False; anything else is refused."""

def without_unit(argument: str, unit: str, given: Any) -> Any:
    """Numbers in a unit, of a quantity of pint, astropy or unyt, or a DataArray; anything else as it is."""

def si_number(argument: str, unit: str, given: Any) -> float:
    """The number in m, Pa, m², 1/m² or without a unit of text with a unit, or of anything else that is one number."""

def in_metres(argument: str, unit: str, lengths: _Floats) -> _Floats:
    """Lengths in m, of lengths in a unit."""

@final
class Answer:
    """The columns of a table, and the notes on it."""

    @property
    def columns(self) -> _Columns: ...
    @property
    def notes(self) -> list[_Note]: ...
    @property
    def facts(self) -> list[str]:
        """The notes as data."""

def contact_states(
    given: Sequence[_Floats | float],
    condition: str,
    materials: Sequence[Material],
    material_index: npt.NDArray[np.int64] | None,
    arguments: _Arguments,
) -> Answer: ...
def curve(
    framework: str, surface: Surface, material: Material, arguments: _Arguments
) -> tuple[Answer, list[float | None], dict[str, float]]: ...
def press_flat(bodies: _Bodies, material: Material, arguments: _Arguments, observer: _Observer | None) -> _Pressed: ...
def press_ball(bodies: _Bodies, material: Material, arguments: _Arguments, observer: _Observer | None) -> _Pressed: ...
def press_adhesive(bodies: _Bodies, material: Material, arguments: _Arguments, observer: _Observer | None) -> _Pressed: ...
def flow_of_gap(
    gap: tuple[str, Mapping[str, bytes], Mapping[str, tuple[str, Any]]] | _Maps, arguments: _Arguments, observer: _Observer | None
) -> _Pressed: ...
def flow_picture(axis: str, flow: _Floats, gap_m: _Floats, size_m: Sequence[float]) -> str: ...
def materials_table() -> _Columns: ...
def models_table() -> _Columns: ...
def model_style(name: str) -> tuple[str, str, str]: ...
def axis_label(column: str) -> str: ...
def figure_svg(
    title: str,
    x: str,
    y: str,
    lines: Sequence[tuple[_Floats, _Floats, str, str, int | None]],
    bands: Sequence[tuple[_Floats, _Floats, _Floats, str, str]],
    holes: Sequence[tuple[float, float]],
    is_linear: bool,
) -> str: ...
def pressures_picture(nominal_pressure_pa: float, pressures_pa: _Floats, size_m: Sequence[float]) -> str: ...
def pressure_in_words(pressure_pa: float) -> str: ...
def gaps(surface: Surface, material: Material, arguments: _Arguments) -> Answer: ...
def tangential(surface: Surface, material: Material, arguments: _Arguments) -> Answer: ...
@final
class FoundLaw:
    def __new__(cls, surface: Surface, material: Material, arguments: _Arguments) -> FoundLaw: ...
    @property
    def cut_pressure_pa(self) -> float | None: ...
    @property
    def interpolation_error(self) -> float: ...
    def answer(self) -> Answer: ...
    def to_text(self, dialect: str, units: str, name: str | None, form: str | None) -> str: ...

@final
class Material:
    def __new__(cls, arguments: _Arguments) -> Material: ...
    @staticmethod
    def is_name(text: str) -> bool: ...
    @property
    def facts(self) -> dict[str, Any]:
        """Properties of the material; the identity is equal for equal materials."""

    def pressure_pa(self, argument: str, pressure: Any) -> float: ...

@final
class Surface:
    @staticmethod
    def of_samples(
        name: str,
        wavelengths_m: _Floats,
        values: _Floats,
        standard_errors: _Floats | None,
        convention: str,
    ) -> Surface: ...
    @staticmethod
    def of_file(name: str, bytes: bytes | None, arguments: _Arguments) -> Surface: ...
    def against(self, other: Surface) -> Surface: ...
    @property
    def facts(self) -> dict[str, Any]: ...
    def quantity(self, quantity: str, arguments: _Arguments) -> Answer: ...
    def between(self, arguments: _Arguments) -> Surface: ...
    def csv(self) -> bytes: ...

def scene_text(sections: Mapping[str, Any], files: Mapping[str, Sequence[str] | None]) -> str: ...
def scene_template(name: str) -> str: ...
def scene_with_keys(text: str, name: str, changes: Mapping[str, Any]) -> str: ...
def write_files(folder: str, files: Mapping[str, bytes]) -> None: ...
@final
class Scene:
    def __new__(
        cls,
        text: str,
        name: str,
        folder: str,
        files: Mapping[str, bytes],
        faces: Sequence[Surface | None],
    ) -> Scene: ...
    @property
    def facts(self) -> _SceneFacts:
        """Title, loads and notes, and short name, colour and SVG dash of every curve."""

    @property
    def files(self) -> dict[str, bytes]: ...
    def explain(self) -> str: ...
    def run(
        self,
        arguments: _Arguments,
        stamp: tuple[str | None, str | None],
        observer: _Observer | None,
    ) -> tuple[str, dict[str, tuple[_Columns, list[str]]], dict[str, bytes]]: ...
    def scales(self) -> _Columns: ...

@final
class Scan:
    @staticmethod
    def of_file(name: str, files: Mapping[str, bytes], options: Mapping[str, tuple[str, Any]]) -> Scan: ...
    @property
    def facts(self) -> dict[str, Any]:
        """Facts that the file tells of its scan."""

    def heights(self) -> tuple[_Floats, npt.NDArray[np.bool_] | None]: ...
    @staticmethod
    def of_heights(heights: Any) -> Scan: ...
    def roughness(self, arguments: _Arguments) -> tuple[_Columns, list[_Note]]: ...
    def summary(self) -> _Columns: ...
    def picture(self) -> str | None: ...

def composite(
    name: str,
    parts: Sequence[tuple[Any, Mapping[str, tuple[str, Any]]]],
    recipe: _Arguments,
    argument: str,
) -> Surface: ...
def scans_of(surface: Surface) -> _Columns | None: ...
def channels_of(
    name: str, files: Mapping[str, bytes], options: Mapping[str, tuple[str, Any]], all_channels: bool
) -> _Columns: ...
def uncertainty_of(
    surface: Surface,
    material: Material,
    of_material: Sequence[tuple[str, Any, Any]],
    arguments: _Arguments,
    observer: _Observer | None,
) -> dict[str, Any]: ...
