"""Contact against cutoff, of the models that take a spectrum."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, TypeVar, Union

import numpy as np
import numpy.typing as npt

from truearea import _native
from truearea._choices import (
    AmplitudeDefinition,
    HardnessFormula,
    InterferenceLaw,
    Normalisation,
    StackedModel,
    StatisticalModel,
)
from truearea._grammar import AnyMaterial, AnySurface, material_of, surface_of
from truearea._material import Quantity
from truearea._notes import noted
from truearea._picture import Drawn, Picture, lines_by_load
from truearea._results import AnyArray, FloatArray, Result

if TYPE_CHECKING:
    from typing_extensions import Self

Pressures = Union[Quantity, npt.ArrayLike]
"""One pressure or several, in Pa or as text."""


AnyCurve = TypeVar("AnyCurve", bound="Curve")


class Curve(Drawn, Result):
    """Contact along the cutoff, under each of some loads: arrays of shape (loads, cutoffs).

    Attributes
    ----------
    model : str
        The model, by the name that scenes have for it.
    """

    _title = "contact against cutoff"
    __slots__ = ("model",)
    nominal_pressure_pa: FloatArray
    wavelength_m: FloatArray
    area_fraction: FloatArray

    model: str

    def _picture(self) -> Picture:
        lines = lines_by_load(self.wavelength_m, self.area_fraction, self.nominal_pressure_pa, self.model)
        return Picture(self._title, "wavelength_m", "area_fraction", lines)

    def __reduce__(self) -> tuple[Any, ...]:
        return (_curve, (type(self), dict(self), self._axes, self.notes, self.model))

    @classmethod
    def _along(
        cls, answer: _native.Answer, pressures_pa: list[float | None], shared: tuple[str, ...], model: str
    ) -> Self:
        """Columns that came block after block; what is the same under every load has the axis of cutoffs alone."""
        arrays: dict[str, AnyArray] = {"nominal_pressure_pa": np.array(pressures_pa, dtype=np.float64)}
        axes: dict[str, tuple[str, ...]] = {"nominal_pressure_pa": ("load",)}
        for name, values in answer.columns.items():
            if name not in arrays:
                array = np.asarray(values).reshape(len(pressures_pa), -1)
                arrays[name] = array[0] if name in shared else array
                axes[name] = ("cutoff",) if name in shared else ("load", "cutoff")
        return _curve(cls, arrays, axes, noted(answer.notes), model)


def _curve(
    kind: type[AnyCurve], arrays: Mapping[str, AnyArray], axes: Mapping[str, tuple[str, ...]], notes: tuple[str, ...], model: str
) -> AnyCurve:
    curve = kind(arrays, axes, notes)
    curve.model = model
    return curve


class StackedCurve(Curve):
    """Archard's stack along the cutoff."""

    _title = "stacked model against cutoff"
    __slots__ = ()
    amplitude_m: FloatArray
    real_pressure_pa: FloatArray
    pressure_in_pa: FloatArray
    yield_strength_pa: FloatArray
    regime: AnyArray


class StatisticalCurve(Curve):
    """A statistical model along the cutoff. The longest wavelength has no asperities yet, and no numbers."""

    _title = "statistical model against cutoff"
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


def stacked(
    surface: AnySurface,
    material: AnyMaterial,
    *,
    pressure: Pressures,
    model: StackedModel = "elastic-plastic",
    strain_gradient: bool = False,
    amplitude: AmplitudeDefinition = "eq5",
    cutoff: Quantity | None = None,
    scales_per_decade: int | None = None,
) -> StackedCurve:
    """Contact area against cutoff by Archard's stack of scales (Jackson & Streator 2006; Jackson & Jacobs).

    Parameters
    ----------
    surface : Spectrum, Scan, sequence of scans, or path of a spectrum
        The roughness.
    material : Material or str
        The bodies in contact, or the name of a material of the table.
    pressure : float, str, or sequence of them
        Nominal pressures, in Pa or as text such as ``"5 MPa"`` or ``"1e-3 H"``.
    model : {"elastic-plastic", "elastic"}
        Whether scales yield.
    strain_gradient : bool, default False
        Let the strength grow at small depths, with the material's ``strain_gradient_length``.
    amplitude : str, optional
        How the amplitude of a scale is made from the spectrum (Eq. 5 by default).
    cutoff : float or str, optional
        The shortest wavelength that takes part.
    scales_per_decade : int, optional
        Resample to so many wavelengths a decade; the area depends on it.

    Returns
    -------
    StackedCurve
        ``nominal_pressure_pa`` (loads,); ``wavelength_m`` and ``amplitude_m`` (cutoffs,); ``area_fraction``,
        ``real_pressure_pa``, ``regime`` and others (loads, cutoffs).

    Raises
    ------
    InputError
        With argument, value and bound.

    Examples
    --------
    >>> import truearea as ta
    >>> uncd = ta.read_psd("builtin:uncd-measured")
    >>> diamond = ta.Material("444.5 GPa", 0.2, indentation_hardness="54 GPa")
    >>> curve = ta.stacked(uncd, diamond, pressure=["1e-4 H", "1e-3 H"], model="elastic-plastic")
    >>> curve.area_fraction.shape == (2, curve.wavelength_m.size)
    True
    """
    arguments = locals()
    answer, pressures_pa, _ = _native.curve("stacked", surface_of(surface), material_of(material), arguments)
    return StackedCurve._along(answer, pressures_pa, ("wavelength_m", "amplitude_m"), model)


def statistical(
    surface: AnySurface,
    material: AnyMaterial,
    *,
    model: StatisticalModel,
    pressure: Pressures | None = None,
    separation: Pressures | None = None,
    strain_gradient: bool = False,
    hardness_formula: HardnessFormula | None = None,
    interference_law: InterferenceLaw | None = None,
    normalisation: Normalisation = "parseval",
    tolerance: float = 1e-12,
    cutoff: Quantity | None = None,
    scales_per_decade: int | None = None,
) -> StatisticalCurve:
    """Contact against cutoff of the asperities that each cutoff leaves (Greenwood & Williamson 1966; McCool 1987).

    Parameters
    ----------
    surface : Spectrum, Scan, sequence of scans, or path of a spectrum
        The roughness.
    material : Material or str
        The bodies in contact, or the name of a material of the table.
    model : {"hertz", "ep-sphere", "elastic-sine", "ep-sine", "bgt"}
        How an asperity answers.
    pressure : float, str, or sequence of them
        Nominal pressures, in Pa or as text such as ``"5 MPa"`` or ``"1e-3 H"``.
    separation : float, str, or sequence of them
        Separations, in m or as text, besides pressures or in place of them.
    strain_gradient : bool, default False
        Let the strength grow at small depths, with the material's ``strain_gradient_length``.
    hardness_formula : {"2005", "cosine"}, optional
        The form of the hardness of spheres that yield.
    interference_law : str, optional
        What ties pressure to interference of elastic sinusoids.
    normalisation : {"parseval", "as-printed"}
        The factor of the moments.
    tolerance : float, default 1e-12
        Relative tolerance of the states.
    cutoff : float or str, optional
        The shortest wavelength that takes part.
    scales_per_decade : int, optional
        Resample to so many wavelengths a decade.

    Returns
    -------
    StatisticalCurve
        ``nominal_pressure_pa`` (loads,), NaN for separations; ``wavelength_m``, ``radius_m``, ``density_per_m2``, ``sigma_s_m``
        (cutoffs,); ``area_fraction``, ``pressure_pa``, ``separation_m`` and others (loads, cutoffs).

    Raises
    ------
    InputError
        With argument, value and bound.

    Examples
    --------
    >>> import truearea as ta
    >>> uncd = ta.read_psd("builtin:uncd-measured")
    >>> diamond = ta.Material("444.5 GPa", 0.2, indentation_hardness="54 GPa")
    >>> curve = ta.statistical(uncd, diamond, pressure="1e-3 H", model="ep-sphere")
    >>> curve.area_fraction[0, -1]
    np.float64(0.00049...)
    """
    arguments = locals()
    answer, pressures_pa, _ = _native.curve("statistical", surface_of(surface), material_of(material), arguments)
    return StatisticalCurve._along(answer, pressures_pa, ("wavelength_m", "radius_m", "density_per_m2", "sigma_s_m"), model)
