"""Contact against cutoff, of the models that take a spectrum."""

from __future__ import annotations

import csv
import io
import os
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, ClassVar, Protocol, Union

import numpy as np
import numpy.typing as npt

from truearea import _native
from truearea._choices import AmplitudeDefinition, StackedModel, StatisticalModel, YieldingAreaLaw
from truearea._grammar import AnyMaterial, AnySurface, material_of, surface_of
from truearea._material import Quantity
from truearea._notes import noted
from truearea._options import PopulationOptions, StackedOptions, Unpack, with_options
from truearea._picture import Drawn, Picture, Trace, load_label
from truearea._results import AnyArray, FloatArray, Result

if TYPE_CHECKING:
    from typing_extensions import Self

class HasArray(Protocol):
    """An array, or what becomes one: a series, a DataArray, a tensor."""

    def __array__(self) -> npt.NDArray[Any]: ...


Pressures = Union[Quantity, Sequence[Quantity], HasArray]
"""One pressure or several, in Pa or as text."""


class Curve(Drawn, Result):
    """Contact along the cutoff, under each of some loads: arrays of shape (loads, cutoffs).

    Attributes
    ----------
    model : str
        The model, by the name that scenes have for it.
    """

    _title = "contact against cutoff"
    _shared: ClassVar[tuple[str, ...]] = ()
    """Columns that are the same under every load."""
    __slots__ = ("model",)
    nominal_pressure_pa: FloatArray
    wavelength_m: FloatArray
    area_fraction: FloatArray

    model: str

    def _picture(self) -> Picture:
        separations_m = self.get("separation_m", np.full((len(self.nominal_pressure_pa), 1), np.nan))[:, -1]
        loads = enumerate(zip(self.nominal_pressure_pa, separations_m))
        # Less is no area that anybody meets.
        areas = np.where(self.area_fraction < 1e-12, np.nan, self.area_fraction)
        lines = (Trace(self.wavelength_m, areas[at], load_label(*load), self.model, at) for at, load in loads)
        return Picture(self._title, "wavelength_m", "area_fraction", tuple(lines))

    def write(self, path: str | os.PathLike[str]) -> None:
        """Write the rows, load after load, as CSV; an existing file is replaced."""
        file, rows = Path(path), np.asarray(self).reshape(-1)
        text = io.StringIO()
        cells = (["" if cell != cell else cell for cell in row] for row in rows.tolist())
        csv.writer(text, lineterminator="\n").writerows([rows.dtype.names or (), *cells])
        _native.write_files(os.fspath(file.parent), {file.name: text.getvalue().encode()})

    @classmethod
    def _found(cls, framework: str, surface: AnySurface, material: AnyMaterial, arguments: dict[str, Any]) -> Self:
        """The curve of a model, whose columns come load after load, and its numbers without axes."""
        answer, pressures_pa, numbers = _native.curve(framework, surface_of(surface, arguments), material_of(material), arguments)
        arrays: dict[str, AnyArray] = {"nominal_pressure_pa": np.array(pressures_pa, dtype=np.float64)}
        axes: dict[str, tuple[str, ...]] = {"nominal_pressure_pa": ("load",)}
        for name, values in answer.columns.items():
            if name not in arrays:
                array = np.asarray(values).reshape(len(pressures_pa), -1)
                arrays[name] = array[0] if name in cls._shared else array
                axes[name] = ("cutoff",) if name in cls._shared else ("load", "cutoff")
        arrays |= {name: np.asarray(number) for name, number in numbers.items()}
        curve = cls(arrays, axes | dict.fromkeys(numbers, ()), noted(answer.notes))
        curve.model = arguments["model"]
        return curve


class StackedCurve(Curve):
    """Archard's stack along the cutoff, under each of some loads."""

    _title = "stacked model against cutoff"
    _shared = ("wavelength_m", "amplitude_m")
    __slots__ = ()
    amplitude_m: FloatArray
    real_pressure_pa: FloatArray
    pressure_in_pa: FloatArray
    yield_strength_pa: FloatArray
    regime: AnyArray


class StatisticalCurve(Curve):
    """A statistical model along the cutoff. The longest wavelength has no asperities yet, and no numbers.

    ``nominal_pressure_pa`` is NaN for separations.
    """

    _title = "statistical model against cutoff"
    _shared = ("wavelength_m", "radius_m", "density_per_m2", "sigma_s_m")
    __slots__ = ()
    radius_m: FloatArray
    density_per_m2: FloatArray
    sigma_s_m: FloatArray
    separation_m: FloatArray
    pressure_pa: FloatArray
    error_estimate: FloatArray
    evaluations: FloatArray
    out_of_range_load_share: FloatArray
    ln_pressure_pa: FloatArray
    ln_area_fraction: FloatArray
    flattened_share: FloatArray
    contacts_per_m2: FloatArray
    plasticity_index: FloatArray


@with_options(StackedOptions)
def stacked(
    surface: AnySurface,
    material: AnyMaterial,
    *,
    pressure: Pressures,
    model: StackedModel = "elastic-plastic",
    strain_gradient: bool = False,
    elastic_plastic_area: YieldingAreaLaw | None = None,
    amplitude: AmplitudeDefinition = "eq5",
    **options: Unpack[StackedOptions],
) -> StackedCurve:
    """Contact area against cutoff by Archard's stack of scales (Jackson & Streator 2006; Jackson & Jacobs).

    Parameters
    ----------
    model : {"elastic-plastic", "elastic"}
        Whether scales yield.

    Examples
    --------
    >>> import truearea as ta
    >>> uncd = ta.read_psd("builtin:uncd-measured")
    >>> diamond = ta.Material("444.5 GPa", 0.2, indentation_hardness="54 GPa")
    >>> curve = ta.stacked(uncd, diamond, pressure=["1e-4 H", "1e-3 H"], model="elastic-plastic")
    >>> curve.area_fraction.shape == (2, curve.wavelength_m.size)
    True
    """
    arguments = {
        "pressure": pressure,
        "model": model,
        "strain_gradient": strain_gradient,
        "elastic_plastic_area": elastic_plastic_area,
        "amplitude": amplitude,
        **options,
    }
    return StackedCurve._found("stacked", surface, material, arguments)


@with_options(PopulationOptions)
def statistical(
    surface: AnySurface,
    material: AnyMaterial,
    *,
    model: StatisticalModel,
    pressure: Pressures | None = None,
    separation: Pressures | None = None,
    tolerance: float = 1e-12,
    **options: Unpack[PopulationOptions],
) -> StatisticalCurve:
    """Contact against cutoff of the asperities that each cutoff leaves (Greenwood & Williamson 1966; McCool 1987).

    Parameters
    ----------
    model : {"hertz", "ep-sphere", "elastic-sine", "ep-sine", "bgt"}
        How an asperity answers.
    separation : float, str, or sequence of them
        Separations, in m or as text, besides pressures or in place of them.

    Examples
    --------
    >>> import truearea as ta
    >>> uncd = ta.read_psd("builtin:uncd-measured")
    >>> diamond = ta.Material("444.5 GPa", 0.2, indentation_hardness="54 GPa")
    >>> curve = ta.statistical(uncd, diamond, pressure="1e-3 H", model="ep-sphere")
    >>> curve.area_fraction[0, -1]
    np.float64(0.00217...)
    """
    arguments = {"model": model, "pressure": pressure, "separation": separation, "tolerance": tolerance, **options}
    return StatisticalCurve._found("statistical", surface, material, arguments)
