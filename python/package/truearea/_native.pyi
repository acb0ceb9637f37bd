"""The core, as the Python modules beside it call it. What arguments mean is told there."""

from collections.abc import Callable, Mapping, Sequence
from typing import Any, Final, final

import numpy as np
import numpy.typing as npt

_Floats = npt.NDArray[np.float64]
_Columns = dict[str, Any]
_Arguments = Mapping[str, Any]
_Note = tuple[str, str, str, tuple[list[str], int | None, int | None, str | None]]
_Map = tuple[str, tuple[float, float, float, float], int, bytes]
_Pressed = tuple[Answer, dict[str, Any]]

__all__ = [
    "METADATA_FILES",
    "VERSION",
    "Answer",
    "AskedScan",
    "FoundLaw",
    "InputError",
    "Material",
    "Scan",
    "Scene",
    "Surface",
    "axis_label",
    "channels_of",
    "choices",
    "composite",
    "contact_states",
    "curve",
    "figure_svg",
    "gaps",
    "in_metres",
    "materials_table",
    "model_style",
    "models_table",
    "pressure_in_words",
    "press_heights",
    "press_spectrum",
    "pressures_picture",
    "scans_of",
    "scene_template",
    "scene_text",
    "scene_with_keys",
    "set_threads",
    "si_number",
    "tables_of_runs",
    "tangential",
    "threads",
    "uncertainty_of",
    "without_unit",
    "write_files",
]

VERSION: Final[str]
METADATA_FILES: Final[list[str]]

class InputError(ValueError): ...

def set_threads(count: int) -> None:
    """Let work take so many threads from now on; 1 keeps it on the thread that calls.

    More than eight times the cores are taken as that many. Before any call, ``RAYON_NUM_THREADS`` counts, or the cores.
    """

def threads() -> int:
    """How many threads work takes."""

def without_unit(argument: str, unit: str, given: Any) -> Any:
    """Numbers in a unit, of a quantity of pint, astropy or unyt; anything else as it is."""

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
) -> tuple[Answer, list[float | None], tuple[float, float] | None]: ...
def press_heights(
    heights_m: _Floats,
    size: Sequence[Any],
    repeats: bool,
    material: Material,
    arguments: _Arguments,
    observer: Callable[[str, int, int | None], None] | None,
) -> _Pressed: ...
def press_spectrum(
    surface: Surface,
    material: Material,
    arguments: _Arguments,
    observer: Callable[[str, int, int | None], None] | None,
) -> _Pressed: ...
def materials_table() -> _Columns: ...
def models_table() -> _Columns: ...
def model_style(name: str) -> tuple[str, str, str]: ...
def choices() -> dict[str, list[str]]:
    """The names that each kind of choice has."""

def axis_label(column: str) -> str: ...
def figure_svg(
    title: str,
    x: str,
    y: str,
    lines: Sequence[tuple[_Floats, _Floats, str, str, int | None]],
    bands: Sequence[tuple[_Floats, _Floats, _Floats, str]],
    holes: Sequence[tuple[float, float]],
) -> str: ...
def pressures_picture(nominal_pressure_pa: float, pressures_pa: _Floats, size_m: Sequence[float]) -> _Map: ...
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
    def to_text(self, dialect: str, units: str, name: str, form: str) -> str: ...

@final
class Material:
    def __new__(cls, arguments: _Arguments) -> Material: ...
    @staticmethod
    def is_name(text: str) -> bool: ...
    @property
    def youngs_modulus_pa(self) -> float | None: ...
    @property
    def poisson_ratio(self) -> float | None: ...
    @property
    def composite_modulus_pa(self) -> float: ...
    @property
    def indentation_hardness_pa(self) -> float | None: ...
    @property
    def yield_strength_pa(self) -> float | None: ...
    def pressure_pa(self, argument: str, pressure: Any) -> float: ...
    @property
    def identity(self) -> str:
        """Equal for equal materials."""

    def describe(self) -> str: ...
    def properties(self) -> list[tuple[str, str]]: ...

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
    def name(self) -> str: ...
    @property
    def wavelengths_m(self) -> _Floats: ...
    @property
    def c1d_m3(self) -> _Floats: ...
    @property
    def standard_errors_m3(self) -> _Floats | None: ...
    @property
    def holes_m(self) -> list[tuple[float, float]]: ...
    @property
    def notes(self) -> list[_Note]: ...
    @property
    def remarks(self) -> list[str]: ...
    def quantity(self, quantity: str, arguments: _Arguments) -> Answer: ...
    def between(self, arguments: _Arguments) -> Surface: ...
    def csv(self) -> bytes: ...
    def svg(self) -> str: ...

def scene_text(sections: Mapping[str, Any], files: Sequence[str] | None) -> str: ...
def scene_template(name: str) -> str: ...
def scene_with_keys(text: str, name: str, changes: Mapping[str, Any]) -> str: ...
def tables_of_runs() -> list[list[str]]: ...
def write_files(folder: str, files: Mapping[str, bytes]) -> None: ...
@final
class Scene:
    def __new__(
        cls,
        text: str,
        name: str,
        folder: str | None,
        files: Mapping[str, bytes],
        overrides: _Arguments,
        surface: Surface | None,
    ) -> Scene: ...
    @property
    def title(self) -> str: ...
    @property
    def notes(self) -> list[_Note]: ...
    @property
    def files(self) -> dict[str, bytes]: ...
    @property
    def loads(self) -> int: ...
    def styles(self) -> dict[str, tuple[str, str, str]]:
        """Short name, colour and SVG dash of every curve."""

    def explain(self) -> str: ...
    def run(
        self,
        report: bool,
        judge: bool | None,
        uncertainty: bool | None,
        occasion: tuple[str | None, str | None],
        observer: Callable[[str, int, int | None], None] | None,
    ) -> tuple[str, dict[str, tuple[_Columns, list[str]]], dict[str, bytes]]: ...
    def scales(self) -> _Columns: ...

@final
class Scan:
    @staticmethod
    def of_file(name: str, files: Mapping[str, bytes], options: Mapping[str, tuple[str, Any]]) -> Scan: ...
    @property
    def name(self) -> str: ...
    @property
    def format(self) -> str: ...
    @property
    def channel(self) -> str | None: ...
    @property
    def channels(self) -> list[str]: ...
    @property
    def notes(self) -> list[str]: ...
    @property
    def is_periodic(self) -> bool: ...
    @property
    def tip_radius_m(self) -> float | None: ...
    @property
    def sha256(self) -> str: ...
    @property
    def size_m(self) -> list[float]: ...
    @property
    def spacing_m(self) -> list[float]: ...
    @property
    def positions_m(self) -> list[float] | None: ...
    def heights(self) -> tuple[_Floats, npt.NDArray[np.bool_] | None]: ...
    @staticmethod
    def of_heights(
        argument: str,
        name: str,
        heights_m: _Floats,
        gaps: npt.NDArray[np.bool_] | None,
        size: tuple[str, list[Any]],
        is_periodic: bool,
    ) -> Scan: ...
    def roughness(self, arguments: _Arguments) -> tuple[_Columns, list[_Note]]: ...
    def summary(self) -> _Columns: ...
    def picture(self) -> tuple[str, _Map | None] | None: ...

@final
class AskedScan:
    @staticmethod
    def of_file(name: str, options: Mapping[str, tuple[str, Any]]) -> AskedScan: ...
    @staticmethod
    def of_scan(scan: Scan, options: Mapping[str, tuple[str, Any]]) -> AskedScan: ...
    @staticmethod
    def of_heights(
        argument: str,
        name: str,
        heights_m: _Floats,
        gaps: npt.NDArray[np.bool_] | None,
        size: tuple[str, list[Any]],
        is_periodic: bool,
        options: Mapping[str, tuple[str, Any]],
    ) -> AskedScan: ...

def composite(
    name: str,
    asked: Sequence[AskedScan],
    files: Mapping[str, bytes],
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
    names: Sequence[str],
    of_material: Sequence[tuple[str, Any, Any]],
    arguments: _Arguments,
    observer: Callable[[int], object] | None,
) -> dict[str, Any]: ...
