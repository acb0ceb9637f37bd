"""Intervals of areas, and the next measurement."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, TypedDict, Union

import numpy as np

from truearea import _native
from truearea._choices import AmplitudeDefinition, CurveModel, YieldingAreaLaw
from truearea._curves import Pressures
from truearea._grammar import AnyMaterial, AnySurface, material_of, named_material, surface_of
from truearea._material import Material, Quantity
from truearea._native import InputError
from truearea._notes import noted
from truearea._options import StatisticalOptions, Unpack, with_options
from truearea._picture import Band, Drawn, Trace, Picture, load_label
from truearea._progress import Progress, observed
from truearea._results import AnyArray, FloatArray, Result, Table, rows_html

if TYPE_CHECKING:
    from matplotlib.axes import Axes

Models = Union[CurveModel, Sequence[CurveModel]]


class Shares(Table):
    """Shares of the inputs in the variance of ln A: first-order and total indices (Saltelli et al. 2010)."""

    _title = "shares of variance"
    __slots__ = ()
    curve: AnyArray
    nominal_pressure_pa: FloatArray
    group: AnyArray
    first_order: FloatArray
    first_order_error: FloatArray
    total: FloatArray
    total_error: FloatArray


class Advice(Table):
    """Next measurements, the one that shrinks the interval most first."""

    _title = "what to measure next"
    __slots__ = ()
    curve: AnyArray
    nominal_pressure_pa: FloatArray
    rank: FloatArray
    step: AnyArray
    instrument: AnyArray
    added_scans: FloatArray
    wavelength_m: FloatArray
    width_ratio: FloatArray
    area_ratio: FloatArray
    in_words: AnyArray

    def _repr_html_(self) -> str:
        rows = zip(self.curve, self.nominal_pressure_pa, self.rank, self.in_words)
        if not len(self.curve):
            return super()._repr_html_()
        best = [(f"{curve} at {load_label(pressure_pa)}", str(words)) for curve, pressure_pa, rank, words in rows if rank == 1]
        return f"<div><b>{self._title}, first of each</b>{rows_html(dict(best))}</div>"


class Bands(Table):
    """Intervals of the area along the cutoff, with the area without uncertainty and the median of the draws."""

    _title = "intervals along the cutoff"
    __slots__ = ()
    curve: AnyArray
    nominal_pressure_pa: FloatArray
    wavelength_m: FloatArray
    area_fraction: FloatArray
    median: FloatArray
    low: FloatArray
    high: FloatArray


class Uncertainty(Drawn, Result):
    """Areas with their coverage intervals: arrays of shape (loads,), of several models (loads, models).

    The area fraction is that without uncertainty; the Monte Carlo error is that of the ends of the interval, as a share of
    ln(high/low). NaN where a model has no area in too many draws. Notes say what the intervals rest on.

    Attributes
    ----------
    draws : int
        How many draws the intervals rest on.
    shares : Shares
        Where the intervals come from.
    advice : Advice
        What to measure next.
    bands : Bands
        The intervals along the cutoff.
    """

    _title = "areas and how sure they are"
    __slots__ = ("advice", "bands", "draws", "shares")
    nominal_pressure_pa: FloatArray
    area_fraction: FloatArray
    median: FloatArray
    low: FloatArray
    high: FloatArray
    low_68: FloatArray
    high_68: FloatArray
    ln_area_sd: FloatArray
    monte_carlo_error: FloatArray

    draws: int
    shares: Shares
    advice: Advice
    bands: Bands

    def plot(self, ax: Axes | None = None, *, model: CurveModel | None = None) -> Axes:
        """Draw the bands along the cutoff, of all models or of one.

        Parameters
        ----------
        ax : matplotlib.axes.Axes, optional
            The axes to draw in; new ones where left out.
        model : str, optional
            The model that is drawn, one of those asked for.
        """
        from truearea._plot import axes_of

        if model is not None and model not in self.bands.curve:
            raise InputError(f"model: {model!r} is not drawn; give one of {', '.join(dict.fromkeys(self.bands.curve))}")
        return self._picture(model).draw(axes_of(ax))

    def _picture(self, model: CurveModel | None = None) -> Picture:
        of_all = self.bands
        lines, bands, loads_pa = [], [], list(self.nominal_pressure_pa)
        for name, pressure_pa in dict.fromkeys(zip(of_all.curve, of_all.nominal_pressure_pa)):
            if model not in (None, name):
                continue
            at = (of_all.curve == name) & (of_all.nominal_pressure_pa == pressure_pa)
            x, load = of_all.wavelength_m[at], loads_pa.index(pressure_pa)
            lines.append(Trace(x, of_all.median[at], load_label(pressure_pa), str(name), load))
            bands.append(Band(x, of_all.low[at], of_all.high[at], str(name), load))
        return Picture(self._title, "wavelength_m", "area_fraction", tuple(lines), tuple(bands))


class _Spreads(TypedDict, total=False):
    """Standard uncertainties of what a material was given."""

    youngs_modulus: Quantity | None
    poisson_ratio: Quantity | None
    yield_strength: Quantity | None
    indentation_hardness: Quantity | None
    strain_gradient_length: Quantity | None
    counterface_youngs_modulus: Quantity | None
    counterface_poisson_ratio: Quantity | None


class UncertaintyOptions(StatisticalOptions, _Spreads, total=False):
    """Options of models, and uncertainties of the material."""

    elastic_plastic_area: YieldingAreaLaw | None
    amplitude: AmplitudeDefinition | None
    tolerance: float | None


@with_options(UncertaintyOptions)
def uncertainty(
    surface: AnySurface,
    material: AnyMaterial,
    *,
    pressure: Pressures,
    model: Models,
    draws: int = 1000,
    seed: int = 1,
    level: float = 0.95,
    shares_draws: int | None = None,
    progress: Progress = False,
    **options: Unpack[UncertaintyOptions],
) -> Uncertainty:
    """Coverage intervals of the area, from draws of scans, instruments and material; where they come from; what to measure next.

    The same digits as those of a scene with the same surface, material, loads and curves, for any number of threads
    (Guide to the expression of uncertainty in measurement, supplement 1).

    Parameters
    ----------
    surface : Spectrum, Scan, sequence of scans, or path of a spectrum
        Of ``composite``, whose scans are drawn from; of ``read_psd`` or numbers, with standard errors; or scans, as for
        ``composite``.
    model : str, or sequence of str
        ``"elastic"``, ``"elastic-plastic"``, ``"hertz"``, ``"ep-sphere"``, ``"elastic-sine"``, ``"ep-sine"``, ``"bgt"``,
        ``"persson"``, ``"persson-plastic"``.
    draws, seed : int
        How many draws, 20 to 1,000,000, and what they are made from.
    level : float, default 0.95
        The probability that an interval covers.
    shares_draws : int, optional
        Draws of the full design that shares are taken from, 64 to 1,000,000; a small one where left out.
    youngs_modulus, poisson_ratio, yield_strength, indentation_hardness, strain_gradient_length : float or str, optional
        Standard uncertainties of what the material was given: ``"5 %"``, ``"10 GPa"``, or a number in SI units that cannot be
        mistaken for a share. Of strength and hardness one.
    counterface_youngs_modulus, counterface_poisson_ratio : float or str, optional
        The same of the counterface.

    Raises
    ------
    InputError
        With argument, value and bound; and where nothing is known to scatter.

    Examples
    --------
    >>> import truearea as ta
    >>> spectrum = ta.read_psd("builtin:uncd-measured")
    >>> diamond = ta.Material("463 GPa", 0.2, yield_strength="1.8 GPa")
    >>> found = ta.uncertainty(spectrum, diamond, pressure="1 MPa", model="elastic-plastic", draws=100, yield_strength="10 %")
    >>> bool(found.low[0] < found.median[0] < found.high[0])
    True
    >>> list(found.shares.group) == ["strength"]
    True
    """
    body = named_material(material) if isinstance(material, str) else material
    core, surface_core = material_of(body), surface_of(surface, options)  # type: ignore[arg-type]
    given = {name: options.get(name) for name in _Spreads.__annotations__}
    spreads = [(name, _value(body, name), spread) for name, spread in given.items() if spread is not None]
    arguments = {
        "pressure": pressure,
        "model": model,
        "draws": draws,
        "seed": seed,
        "level": level,
        "shares_draws": shares_draws,
        **options,
    }
    with observed(progress) as observer:
        found = _native.uncertainty_of(surface_core, core, spreads, arguments, observer)
    is_one = isinstance(model, str)
    arrays: dict[str, AnyArray] = {"nominal_pressure_pa": np.asarray(found["nominal_pressure_pa"])}
    axes: dict[str, tuple[str, ...]] = {"nominal_pressure_pa": ("load",)}
    if not is_one:
        arrays["model"], axes["model"] = np.asarray(found["model"]), ("model",)
    for name, array in found["arrays"].items():
        arrays[name] = array[:, 0].copy() if is_one else array
        axes[name] = ("load",) if is_one else ("load", "model")
    return Uncertainty(
        arrays,
        axes,
        noted(found["notes"]),
        draws=found["draws"],
        shares=Shares._of(found["shares"]),
        advice=Advice._of(found["advice"]),
        bands=Bands._of(found["bands"]),
    )


def _value(material: Material, name: str) -> Any:
    body: Material | None = material
    if name.startswith("counterface_"):
        body, name = material.counterface, name.removeprefix("counterface_")
        if body is None:
            raise InputError(f"counterface_{name} has a standard uncertainty, and the counterface of the material is rigid")
    return None if body is None else body._value(name)
