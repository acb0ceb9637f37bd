"""Surfaces pressed point by point."""

from __future__ import annotations

import functools
import inspect
from collections.abc import Callable
from typing import TYPE_CHECKING, Any, TypedDict, Union, overload

import numpy as np
import numpy.typing as npt

from truearea import _native
from truearea._arrays import doubles, lengths_of
from truearea._cores import material_of
from truearea._curves import Pressures
from truearea._material import Material, Quantity
from truearea._native import InputError
from truearea._notes import noted
from truearea._progress import Line, Progress, observer_of
from truearea._results import AnyArray, FloatArray, Result
from truearea._scan import Scan
from truearea._spectrum import Spectrum
from truearea._topography import heights_and_size, is_topography

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from typing_extensions import Unpack


class Pressed(Result):
    """Surfaces pressed by boundary elements: of random surfaces the mean, or each of them."""

    _title = "boundary elements"
    __slots__ = ()
    nominal_pressure_pa: FloatArray
    area_fraction: FloatArray
    area_fraction_corrected: FloatArray
    area_fraction_extrapolated: FloatArray
    standard_error: FloatArray
    plastic_area_fraction: FloatArray
    plastic_area_fraction_corrected: FloatArray
    mean_gap_m: FloatArray
    mean_plastic_depth_m: FloatArray
    largest_pressure_pa: FloatArray
    stiffness_pa_per_m: FloatArray
    open_along_x: FloatArray
    open_along_y: FloatArray
    iterations: FloatArray
    residual: FloatArray
    pressure_pa: FloatArray
    gap_m: FloatArray
    height_m: FloatArray

    def plot(self, ax: Axes | None = None) -> Axes:
        """Draw the pressures of the last map, white where nothing touches; without fields the area against the load.

        Parameters
        ----------
        ax : matplotlib.axes.Axes, optional
            The axes to draw in; new ones where left out.

        Returns
        -------
        matplotlib.axes.Axes

        Raises
        ------
        ImportError
            Without Matplotlib; ``pip install truearea[plot]`` adds it.
        """
        from truearea._plot import axes_of, draw_map

        ax = axes_of(ax)
        if "pressure_pa" in self:
            maps = np.asarray(self.pressure_pa)
            last = maps.reshape(-1, *maps.shape[-2:])[-1]
            return draw_map(ax, np.where(last > 0.0, last, np.nan), None, "pressure (Pa)", "white")
        loads_pa = np.atleast_1d(self.nominal_pressure_pa)
        areas = np.asarray(self.area_fraction_corrected).reshape(-1, loads_pa.size)
        for of_one in areas:
            ax.loglog(loads_pa, of_one, "o", color="black", markersize=4)
        ax.set_xlabel("nominal pressure (Pa)")
        ax.set_ylabel("fraction of the area in contact")
        return ax

    def _is_coordinate(self, name: str) -> bool:
        return name == "nominal_pressure_pa" and super()._is_coordinate(name)


class PressedBall(Result):
    """A smooth ball pressed onto rough flats by boundary elements, along the flats."""

    _title = "ball on a rough flat"
    __slots__ = ()
    force_n: FloatArray
    real_area_m2: FloatArray
    effective_radius_m: FloatArray
    hertz_radius_m: FloatArray
    peak_mean_pressure_pa: FloatArray
    hertz_pressure_pa: FloatArray
    force_share: FloatArray
    outermost_contact_m: FloatArray
    real_area_corrected_m2: FloatArray
    roughness_number: FloatArray
    residual: FloatArray


if TYPE_CHECKING:

    class _OfBalls(TypedDict, total=False):
        """Arguments by name that a ball takes as a flat does."""

        detrend: str | None
        tolerance: float
        grid: int | None
        realisations: int | None
        seed: int | None
        longest: Quantity | None
        shortest: Quantity | None
        side: Quantity | None
        phases: str | None
        progress: Progress

    class _Options(_OfBalls, total=False):
        """Arguments by name in either order."""

        periodic: bool | None
        fields: bool
        per_realisation: bool

    _AnyPressed = Union[Pressed, PressedBall]


def _in_either_order(press: Callable[..., _AnyPressed]) -> Callable[..., _AnyPressed]:
    """Lets the material stand behind the surface, as in all other functions, or behind size and pressure, as it once did."""

    @functools.wraps(press)
    def pressing(h: Any, *ordered: Any, **named: Any) -> _AnyPressed:
        material, *further = ordered or (None,)
        if isinstance(material, Material):
            if further:
                raise InputError("behind the material, arguments are given by name: boundary_elements(h, material, pressure=...)")
            return press(h, material=material, **named)
        return press(h, *ordered, **named)

    # Help and editors show the order of all other functions; the former one is accepted in silence.
    del pressing.__wrapped__
    setattr(pressing, "__signature__", _with_material_second(inspect.signature(press)))
    return pressing


def _with_material_second(signature: inspect.Signature) -> inspect.Signature:
    """The signature with the material behind the surface, and all further arguments by name."""
    known = dict(signature.parameters)
    first = [known.pop("h"), known.pop("material").replace(default=inspect.Parameter.empty, annotation="Material")]
    by_name = [known.pop(name) for name in ("pressure", "size")] + list(known.values())
    return signature.replace(
        parameters=first + [parameter.replace(kind=inspect.Parameter.KEYWORD_ONLY) for parameter in by_name]
    )


@overload
def boundary_elements(
    h: Any,
    material: Material,
    *,
    pressure: Pressures,
    size: Quantity | tuple[Quantity, Quantity] | None = None,
    saturation: Quantity | None = None,
    **options: Unpack[_Options],
) -> Pressed: ...


@overload
def boundary_elements(
    h: Any,
    material: Material,
    *,
    ball_radius: Quantity,
    force: Quantity,
    size: Quantity | tuple[Quantity, Quantity] | None = None,
    **options: Unpack[_OfBalls],
) -> PressedBall: ...


@overload
def boundary_elements(
    h: Any,
    size: Quantity | tuple[Quantity, Quantity] | None = None,
    pressure: Pressures | None = None,
    material: Material | None = None,
    saturation: Quantity | None = None,
    **options: Unpack[_Options],
) -> Pressed: ...


@_in_either_order
def boundary_elements(
    h: Any,
    size: Quantity | tuple[Quantity, Quantity] | None = None,
    pressure: Pressures | None = None,
    material: Material | None = None,
    saturation: Quantity | None = None,
    *,
    periodic: bool | None = None,
    detrend: str | None = None,
    tolerance: float = 1e-6,
    fields: bool = False,
    grid: int | None = None,
    realisations: int | None = None,
    seed: int | None = None,
    longest: Quantity | None = None,
    shortest: Quantity | None = None,
    side: Quantity | None = None,
    phases: str | None = None,
    per_realisation: bool = False,
    progress: Progress = False,
    ball_radius: Quantity | None = None,
    force: Quantity | None = None,
) -> Pressed | PressedBall:
    """Press heights, or random surfaces of a spectrum, into a half-space that is elastic or flows at a hardness.

    The material may come second, as in all other functions: ``boundary_elements(h, material, pressure="1 MPa", size="1 um")``.

    Every point of the grid carries a pressure, and equilibrium is found by conjugate directions with the displacements of the
    half-space by fast Fourier transforms. Areas are corrected for the staircase around each spot (Yastrebov, Anciaux & Molinari
    2017, Tribol. Int. 114:161).

    Parameters
    ----------
    h : array_like of float, shape (rows, columns), or Scan, or a topography, or Spectrum
        Heights in m; higher points touch first. Axis 0 is y, axis 1 is x. Or a scan or an object of SurfaceTopography, which
        know their size and unit. Or a spectrum, of which random surfaces are made.
    material : Material
        The bodies in contact, of which E* counts, and the hardness as a unit.
    pressure : float, str, or sequence of them
        Nominal pressures, in Pa or as text such as ``"5 MPa"`` or ``"1e-3 H"``; with a ball, ``force`` in their place.
    size : float or str, or two of them, optional
        Lengths (lx, ly) of the map in m or as text, ``columns`` and ``rows`` spacings; one for a square of as many rows as
        columns. Scans, topographies and spectra know their own.
    saturation : float or str, optional
        The pressure at which the surface flows, an indentation hardness such as ``"3 GPa"`` or ``"1 H"``; elastic throughout
        where left out.
    periodic : bool, default False
        What lies beyond the edges of a map: the map again, or an unloaded half-space. Of a scan or topography what it says
        itself, where left out.
    detrend : {"plane", "line", "mean"}, optional
        What is subtracted from heights: by default a plane, from those that repeat themselves the mean.
    tolerance : float, default 1e-6
        The residual at which the iteration stops, above 0 and at most 0.1. The residual is the mean of ``|gap|`` over the points
        in contact below the saturation, weighted with their pressures and divided by the rms height: an exact solution has 0.
    fields : bool, default False
        Give pressure and gap of every point as well.
    grid : int, default 512
        Points along each side of a random surface, from 16 to 16384.
    realisations : int, default 8
        How many surfaces are made of the spectrum.
    seed : int, default 1
        The seed of their phases.
    longest, shortest : float or str, optional
        The longest and the shortest wavelength of the surfaces; where left out, that of the spectrum for the shortest, and as
        long as the grid holds for the longest.
    side : float or str, optional
        Length of a side.
    phases : {"fixed-modulus", "gaussian"}, optional
        What is random: phases alone, or moduli as well.
    per_realisation : bool, default False
        Tell of each random surface instead of their mean.
    progress : bool or callable, default False
        True shows a line on stderr; a callable is told the steps done and how many there are.
    ball_radius : float or str, optional
        Radius in m of a smooth ball that is pressed onto the middle of the surface, whose edges are free, as
        ``truearea bem --ball-radius`` does.
    force : float or str, optional
        Force on the ball, in N or as text such as ``"10 mN"``.

    Returns
    -------
    Pressed
        Along the loads, and with ``per_realisation`` along the surfaces: ``area_fraction`` counts points,
        ``area_fraction_corrected`` is less the staircase, ``area_fraction_extrapolated`` is what a finer grid would show, with
        its ``standard_error`` over the surfaces; ``plastic_area_fraction``, ``mean_gap_m``, ``mean_plastic_depth_m``,
        ``largest_pressure_pa``, ``stiffness_pa_per_m``; ``open_along_x`` and ``open_along_y``, the share of the surfaces that an
        open way crosses; ``iterations``, ``residual``. With ``fields``, ``pressure_pa`` and ``gap_m`` of shape (loads, rows,
        columns), of random surfaces (loads, surfaces, rows, columns), and ``height_m``, the heights as they were pressed.
    PressedBall
        With ``ball_radius``, along the surfaces: ``real_area_m2`` and its value less the staircase,
        ``real_area_corrected_m2``; ``effective_radius_m`` and ``peak_mean_pressure_pa`` of the pressure averaged around the axis,
        beside ``hertz_radius_m`` and ``hertz_pressure_pa`` of a smooth ball; ``force_share``, the share of the force within
        half of Hertz's radius; ``outermost_contact_m``, ``roughness_number``, ``residual``.

    Raises
    ------
    InputError
        With argument, value and bound; with their count for heights that are masked or not finite.
    KeyboardInterrupt
        Soon after Ctrl-C, wherever the work is.

    Examples
    --------
    >>> import numpy as np
    >>> import truearea as ta
    >>> x = np.linspace(0, 2 * np.pi, 64, endpoint=False)
    >>> wave = 1e-8 * np.cos(x) * np.cos(x)[:, None]
    >>> glass = ta.Material("100 GPa", 0.0)
    >>> pressed = ta.boundary_elements(
    ...     wave, "1 um", pressure=["10 MPa", "1 GPa"], material=glass, periodic=True, fields=True
    ... )
    >>> pressed.pressure_pa.shape
    (2, 64, 64)
    >>> bool(pressed.area_fraction[0] < pressed.area_fraction[1])
    True
    >>> bool(abs(pressed.pressure_pa[1].mean() / 1e9 - 1) < 1e-9)
    True
    """
    arguments = locals()
    if ball_radius is None:
        _refuse(arguments, _OF_BALLS, "a flat, only on a ball; give ball_radius")
    else:
        _refuse(arguments, _OF_FLATS, "a ball")
    line = Line()
    observer = observer_of(progress, line)
    try:
        if isinstance(h, Spectrum):
            _refuse(arguments, _OF_HEIGHTS, "a spectrum, only on heights")
            surfaces: tuple[str, ...] = ("surface",)
            answer, fields_found = _native.press_spectrum(h._native, material_of(material), arguments, observer)
        else:
            _refuse(arguments, _OF_SPECTRA, "heights, only on a spectrum")
            heights, lengths, repeats = _map(h, size, bool(periodic))
            surfaces = ()
            arguments["periodic"] = ball_radius is None and (repeats if periodic is None else bool(periodic))
            answer, fields_found = _native.press_heights(
                heights, lengths, repeats, material_of(material), arguments, observer
            )
    finally:
        line.end()
    if ball_radius is not None:
        columns = {name: np.asarray(values) for name, values in answer.columns.items() if name != "realisation"}
        return PressedBall(columns, dict.fromkeys(columns, ("surface",)), noted(answer.notes))
    arrays, axes = _of_table(answer.columns)
    if fields_found is not None:
        points = (*surfaces, "row", "column")
        for name, array in zip(("pressure_pa", "gap_m", "height_m"), fields_found):
            arrays[name] = array
            axes[name] = points if name == "height_m" else ("load", *points)
    return Pressed(arrays, axes, noted(answer.notes))


_OF_HEIGHTS: dict[str, Any] = dict.fromkeys(("size", "periodic", "detrend"))
_OF_SPECTRA: dict[str, Any] = dict.fromkeys(("grid", "realisations", "seed", "longest", "shortest", "side", "phases")) | {
    "per_realisation": False
}


_OF_BALLS: dict[str, Any] = {"force": None}
_OF_FLATS: dict[str, Any] = dict.fromkeys(("pressure", "saturation", "periodic")) | {"fields": False, "per_realisation": False}


def _refuse(arguments: dict[str, Any], idle: dict[str, Any], what: str) -> None:
    for name, left_out in idle.items():
        if arguments[name] is not left_out:
            raise InputError(f"{name} has no bearing on {what}; leave it out")


def _map(h: Any, size: Any, periodic: bool) -> tuple[FloatArray, list[Any], bool]:
    """Heights, the lengths of their map, and whether they repeat themselves: of an array nobody else says it."""
    own: tuple[float, ...] | None = None
    if isinstance(h, Scan):
        given, own, repeats = h.heights_m, h.size_m, h.is_periodic
    elif is_topography(h):
        given, own, repeats = heights_and_size(h, "h")
    else:
        given, repeats = h, periodic
    if own is None and size is None:
        raise InputError("size is needed: the lengths (lx, ly) of the map, in m or as text")
    if own is not None and size is not None:
        raise InputError(f"size has no bearing on a {type(h).__name__}, which knows its own; leave it out")
    heights = _heights(given)
    return heights, lengths_of("h", "size", size if own is None else own, heights.shape), repeats


def _heights(given: Any) -> FloatArray:
    """A map of heights, whole."""
    masked = int(np.count_nonzero(np.ma.getmaskarray(given))) if isinstance(given, np.ma.MaskedArray) else 0
    if masked:
        raise InputError(f"h: {masked} of {np.size(given)} heights are masked; fill them before the map is pressed")
    heights = doubles("h", given, "m")
    if heights.ndim != 2:
        raise InputError(f"h: a map of rows and columns is needed, and this has {heights.ndim} axes")
    unknown = heights.size - int(np.count_nonzero(np.isfinite(heights)))
    if unknown:
        raise InputError(
            f"h: {unknown} of {heights.size} heights are NaN or infinite; fill them before the map is pressed"
        )
    return heights


def _of_table(columns: dict[str, Any]) -> tuple[dict[str, AnyArray], dict[str, tuple[str, ...]]]:
    """The arrays of a table and their axes: along the loads, and of each surface along the surfaces as well."""
    numbers = columns.pop("realisation", None)
    table: dict[str, npt.NDArray[np.float64]] = {name: np.asarray(values) for name, values in columns.items()}
    if numbers is None:
        return dict(table), {name: ("load",) for name in table}
    surfaces = int(numbers[-1])
    arrays: dict[str, AnyArray] = {name: array.reshape(-1, surfaces) for name, array in table.items()}
    axes: dict[str, tuple[str, ...]] = {name: ("load", "surface") for name in arrays}
    arrays["nominal_pressure_pa"] = arrays["nominal_pressure_pa"][:, 0]
    axes["nominal_pressure_pa"] = ("load",)
    # One surface alone has no scatter.
    del arrays["standard_error"], axes["standard_error"]
    return arrays, axes
