"""Surfaces pressed point by point."""

from __future__ import annotations

import os
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from truearea import _native
from truearea._arrays import lengths_of, metres
from truearea._choices import Compliance, FlowEdges, MapGaps
from truearea._curves import Pressures
from truearea._grammar import AnyMaterial, faces_of, material_of
from truearea._material import Quantity
from truearea._native import InputError
from truearea._notes import noted
from truearea._options import FlatOptions, PressOptions, Unpack, with_options
from truearea._picture import Drawn, Picture, Trace, load_label
from truearea._progress import observed
from truearea._results import AnyArray, FloatArray, Result, Table
from truearea._scan import Scan
from truearea._spectrum import Spectrum
from truearea._topography import heights_and_size, is_topography

if TYPE_CHECKING:
    from matplotlib.axes import Axes


class Patches(Table):
    """Regions that touch without a break, load by load and surface by surface."""

    _title = "contact patches"
    __slots__ = ()
    nominal_pressure_pa: FloatArray
    realisation: FloatArray
    patch: FloatArray
    points: FloatArray
    area_m2: FloatArray
    perimeter_m: FloatArray


class Pressed(Drawn, Result):
    """Surfaces pressed by boundary elements: of random surfaces the mean, or each of them.

    Arrays go along the loads, along the maps where there are several, and with ``per_realisation`` along the surfaces. The area
    fraction counts points; corrected, it is less the staircase; extrapolated, it is what a finer grid would show, with its
    standard error over the surfaces. ``open_along_x`` and ``open_along_y`` are the share of the surfaces that an open way crosses,
    or with ``flow`` the share that fluid flows through, for which there are flow factors with their standard deviations and
    their errors by the spacing of the points;
    ``rms_gradient`` is by differences of neighbours of a map, or of the band of random surfaces. Only with ``fields`` there are
    pressures and gaps of shape (loads, rows, columns), of several surfaces (loads, surfaces, rows, columns), the heights as they
    were pressed, and ``x_m`` and ``y_m``.

    Attributes
    ----------
    patches : Patches or None
        The regions that touch, if requested.
    """

    _title = "boundary elements"
    __slots__ = ("patches",)
    patches: Patches | None
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
    flow_factor_x: FloatArray
    flow_factor_y: FloatArray
    flow_factor_x_sd: FloatArray
    flow_factor_y_sd: FloatArray
    flow_factor_x_error: FloatArray
    flow_factor_y_error: FloatArray
    flow_residual: FloatArray
    rms_gradient: FloatArray
    pressure_pa: FloatArray
    gap_m: FloatArray
    height_m: FloatArray
    x_m: FloatArray
    y_m: FloatArray

    def _picture(self) -> Picture:
        pressures_pa = np.asarray(self.nominal_pressure_pa)
        areas = np.asarray(self.area_fraction_corrected)
        areas = areas.reshape(len(areas), -1)
        loads_pa = np.broadcast_to(pressures_pa.reshape(len(areas), -1), areas.shape)
        labels = [f"{self._axes['area_fraction'][-1]} {at + 1}" for at in range(areas.shape[1])] if areas.shape[1] > 1 else [""]
        lines = tuple(Trace(loads_pa[:, at], areas[:, at], label, condition=at) for at, label in enumerate(labels))
        return Picture(self._title, "nominal_pressure_pa", "area_fraction", lines, marker="o")

    def _last_map(self) -> tuple[FloatArray, float, list[float]]:
        """The pressures of the last surface under the last load, the load, and the size of the map."""
        maps = self["pressure_pa"]
        size_m = [float(self[name][1]) * len(self[name]) if len(self[name]) > 1 else 1.0 for name in ("x_m", "y_m")]
        return maps.reshape(-1, *maps.shape[-2:])[-1], float(np.reshape(self.nominal_pressure_pa, -1)[-1]), size_m

    def _draw(self, ax: Axes) -> Axes:
        if "pressure_pa" not in self:
            return super()._draw(ax)
        from truearea._plot import draw_map

        pressures_pa, nominal_pressure_pa, size_m = self._last_map()
        touching_pa = np.where(pressures_pa > 0.0, pressures_pa, np.nan)
        ax.set_title(f"at {load_label(nominal_pressure_pa)}")
        return draw_map(ax, touching_pa, tuple(size_m), "pressure", "Pa", "white")

    def _drawing(self) -> str:
        if "pressure_pa" not in self:
            return super()._drawing()
        pressures_pa, nominal_pressure_pa, size_m = self._last_map()
        return _native.pressures_picture(nominal_pressure_pa, pressures_pa, size_m)

    def _is_coordinate(self, name: str) -> bool:
        return name in ("nominal_pressure_pa", "x_m", "y_m") and super()._is_coordinate(name)


class PressedBall(Result):
    """A smooth ball pressed onto rough flats by boundary elements, along the flats.

    Effective radius and peak pressure are those of the pressure averaged around the axis, beside Hertz's of a smooth ball; the force
    share is that within half of Hertz's radius; the corrected area is less the staircase.
    """

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


@with_options(FlatOptions)
def boundary_elements(
    surface: Any,
    material: AnyMaterial,
    *,
    pressure: Pressures | None = None,
    mean_gap: Pressures | None = None,
    indentation: Pressures | None = None,
    saturation: Quantity | None = None,
    gaps: MapGaps | None = None,
    compliance: Compliance | None = None,
    fields: bool = False,
    patches: bool = False,
    flow: bool = False,
    flow_edges: FlowEdges | None = None,
    **options: Unpack[FlatOptions],
) -> Pressed:
    """Press heights, or random surfaces of a spectrum, into a half-space that is elastic or flows at a hardness.

    Every point of the grid carries a pressure, and equilibrium is found by conjugate directions with the displacements of the
    half-space by fast Fourier transforms. Areas are corrected for the staircase around each spot (Yastrebov, Anciaux & Molinari
    2017, Tribol. Int. 114:161).

    Parameters
    ----------
    surface : array_like of float, shape (rows, columns) or (maps, rows, columns), or Scan, topography, list of them, Spectrum or path
        Heights in m; higher points touch first. The last axis is x, the one before it y, a third one in front counts maps, which
        are pressed side by side on all threads. Or a scan or an object of SurfaceTopography, which know their size and unit, or
        a list of some of one size. Or a spectrum or its path, of which random surfaces are made.
    material : Material or str
        The bodies in contact, of which E* counts, and the hardness as a unit; or the name of a material of the table.
    pressure : float, str, or sequence of them
        Nominal pressures, in Pa or as text such as ``"5 MPa"``, ``"1e-3 H"``, ``"0.01 E*"`` or ``"0.05 E* h'"`` with the rms
        gradient h' of each surface (``rms_gradient`` of the result).
    mean_gap : float or str, or sequence of them
        Mean gaps in m that are held in place of pressures, on surfaces that repeat themselves: the distance of the mean planes,
        which is ``mean_gap_m`` less ``mean_plastic_depth_m``.
    indentation : float or str, or sequence of them
        Distances in m by which the bodies approach from where the highest point touches, held in place of pressures.
    saturation : float or str, optional
        The pressure at which the surface flows, an indentation hardness such as ``"3 GPa"`` or ``"1 H"``; elastic throughout
        where left out.
    tolerance : float, default 1e-6
        The residual at which the iteration stops, above 0 and at most 0.1. The residual is the mean of ``|gap|`` over the points
        in contact below the saturation, weighted with their pressures and divided by the rms height: an exact solution has 0.
    gaps : {"refuse", "keep"}, optional
        What becomes of heights that are masked or NaN. Kept ones never touch; where edges are free, those that reach the edge of the
        map lie outside the specimen, and pressures and areas are over the rest. Refused where left out, but kept between two maps.
    compliance : {"none", "punch", "even"}, optional
        What is taken out of the stiffness of maps with free edges: the approach of the specimen's outline as a rigid punch, or its
        mean displacement under even pressure; nothing where left out.
    fields : bool, default False
        Give pressure and gap of every point as well.
    patches : bool, default False
        Find the regions that touch without a break, each with its area and perimeter.
    flow : bool, default False
        Solve the flow through the gap along x and along y, as ``truearea.flow`` does.
    flow_edges : {"periodic", "reservoirs", "channel"}, optional
        Edges that the flow meets, as ``edges`` of ``truearea.flow``; where left out, those of a surface that repeats itself are
        periodic, and all others channels.

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
    ...     wave, glass, pressure=["10 MPa", "1 GPa"], size="1 um", periodic=True, fields=True
    ... )
    >>> pressed.pressure_pa.shape
    (2, 64, 64)
    >>> bool(pressed.area_fraction[0] < pressed.area_fraction[1])
    True
    >>> bool(abs(pressed.pressure_pa[1].mean() / 1e9 - 1) < 1e-9)
    True
    >>> held = ta.boundary_elements(wave, glass, mean_gap=pressed.mean_gap_m, size="1 um", periodic=True)
    >>> bool(np.allclose(held.nominal_pressure_pa, [1e7, 1e9], rtol=1e-4))
    True
    """
    arguments = {
        "pressure": pressure,
        "mean_gap": mean_gap,
        "indentation": indentation,
        "saturation": saturation,
        "gaps": gaps,
        "compliance": compliance,
        "fields": fields,
        "patches": patches,
        "flow": flow,
        "flow_edges": flow_edges,
        **options,
    }
    return _pressed(*press(_native.press_flat, surface, material, arguments))


@with_options(PressOptions)
def ball(
    surface: Any, material: AnyMaterial, *, radius: Quantity, force: Quantity, **options: Unpack[PressOptions]
) -> PressedBall:
    """Press a smooth ball onto the middle of a rough flat, whose edges are free.

    Parameters
    ----------
    surface, material, tolerance : as for ``boundary_elements``
        One map, or random surfaces, the bodies in contact, and the residual at which the iteration stops.
    radius : float or str
        Radius of the ball, in m or as text such as ``"1 mm"``.
    force : float or str
        Force on the ball, in N or as text such as ``"10 mN"``.
    """
    answer, _, _ = press(_native.press_ball, surface, material, {"radius": radius, "force": force, **options})
    columns = {name: np.asarray(values) for name, values in answer.columns.items() if name != "realisation"}
    return PressedBall(columns, dict.fromkeys(columns, ("surface",)), noted(answer.notes))


def press(call: Any, surface: Any, material: AnyMaterial, arguments: dict[str, Any]) -> tuple[_native.Answer, dict[str, Any], str]:
    """Lets the core press surfaces: its answer, what else is known of the surfaces, and the axis of several of them."""
    core = material_of(material)
    if isinstance(surface, (str, os.PathLike, Spectrum)):
        spectrum = faces_of(surface, arguments)
        with observed(arguments.get("progress")) as observer:
            answer, beside = call(spectrum._native, core, arguments, observer)
        return answer, beside, "surface"
    other = arguments.pop("counterface_surface", None)
    if isinstance(other, (str, os.PathLike, Spectrum)):
        raise InputError(
            "counterface_surface: a spectrum has no heights to add to those of a map; give its heights, or press "
            "Spectrum.from_heights(h, size) and this"
        )
    keeps = {None: other is not None, "keep": True, "refuse": False}.get(gaps := arguments.get("gaps"))
    if keeps is None:
        raise InputError(f"gaps: {gaps!r} is none of refuse and keep")
    size = arguments.get("size")
    maps = maps_of("surface", surface, size, keeps)
    facing = None
    if other is not None:
        # An array has the size of the surface, unless that has its own and says nothing of arrays.
        facing = maps_of("counterface_surface", other, None if _knows_its_size(other) else size, keeps)
    with observed(arguments.get("progress")) as observer:
        answer, beside = call((maps, facing), core, arguments, observer)
    return answer, beside, "map" if maps[0].ndim == 3 else ""


def _knows_its_size(surface: Any) -> bool:
    return isinstance(surface, Scan) or is_topography(surface)


def maps_of(argument: str, surface: Any, size: Any, keeps: bool) -> tuple[FloatArray, list[Any], bool | None]:
    """Maps of heights, the lengths of each, and whether they repeat themselves; None for an array, which does not say it."""
    own: tuple[float, ...] | None = None
    repeats: bool | None
    if isinstance(surface, (list, tuple)) and surface and all(_knows_its_size(one) for one in surface):
        each = [maps_of(argument, one, size, keeps) for one in surface]
        if any((one.shape, lengths, repeats) != (each[0][0].shape, *each[0][1:]) for one, lengths, repeats in each):
            raise InputError(f"{argument}: its maps have to be of one shape, size and kind of edges; press each by itself")
        return np.stack([one for one, _, _ in each]), *each[0][1:]
    if isinstance(surface, Scan):
        given, own, repeats = surface.heights_m, surface.size_m, surface.is_periodic
    elif is_topography(surface):
        given, own, repeats = heights_and_size(surface, argument)
    else:
        given, repeats = surface, None
    if own is None and size is None:
        raise InputError("size is needed: the lengths (lx, ly) of the map, in m or as text")
    if own is not None and size is not None:
        raise InputError(f"size has no effect on a {type(surface).__name__}, which knows its own; leave it out")
    heights = _heights(argument, given, keeps)
    return heights, lengths_of(argument, "size", size if own is None else own, heights.shape[-2:]), repeats


def _heights(argument: str, given: Any, keeps: bool) -> FloatArray:
    """Maps of heights; missing ones are NaN where they are kept."""
    mask = np.ma.getmaskarray(given) if isinstance(given, np.ma.MaskedArray) else None
    mend = "fill them before the map is pressed, or keep them with gaps='keep'"
    if mask is not None and mask.any():
        if not keeps:
            raise InputError(f"{argument}: {np.count_nonzero(mask)} of {mask.size} heights are masked; {mend}")
        given = np.where(mask, np.nan, np.ma.getdata(given))
    heights = metres(argument, given)
    if heights.ndim not in (2, 3):
        raise InputError(f"{argument}: a map of rows and columns is needed, or several, and this has {heights.ndim} axes")
    if not heights.size:
        raise InputError(f"{argument}: it has no heights")
    unknown = np.isinf(heights) if keeps else ~np.isfinite(heights)
    if unknown.any():
        kind = "infinite; fill them before the map is pressed" if keeps else f"NaN or infinite; {mend}"
        raise InputError(f"{argument}: {np.count_nonzero(unknown)} of {heights.size} heights are {kind}")
    return heights


def _pressed(answer: _native.Answer, beside: Mapping[str, Any], several: str) -> Pressed:
    """The arrays of a table and the fields, with their axes: along the loads, and of each surface along ``several``."""
    columns = dict(answer.columns)
    numbers = columns.pop("realisation", None)
    of_each = () if numbers is None else (several,)
    surfaces = 1 if numbers is None else int(np.max(numbers, initial=1.0))
    arrays: dict[str, AnyArray] = {}
    axes: dict[str, tuple[str, ...]] = {}
    for name, values in columns.items():
        array = np.asarray(values)
        arrays[name] = array.reshape(-1, surfaces) if of_each else array
        axes[name] = ("load", *of_each)
    if of_each:
        # One surface alone has no scatter, and most loads are those of all surfaces.
        del arrays["standard_error"], axes["standard_error"]
        pressures_pa = arrays["nominal_pressure_pa"]
        if np.array_equal(pressures_pa, np.broadcast_to(pressures_pa[:, :1], pressures_pa.shape)):
            arrays["nominal_pressure_pa"], axes["nominal_pressure_pa"] = pressures_pa[:, 0].copy(), ("load",)
    fields, gradients = beside["fields"], beside["rms_gradient"]
    arrays["rms_gradient"] = np.asarray(gradients if several == "map" else gradients[0])
    axes["rms_gradient"] = ("map",) if several == "map" else ()
    if fields is not None:
        points = (several, "row", "column") if several else ("row", "column")
        for name, array in zip(("pressure_pa", "gap_m", "height_m"), fields):
            axes[name] = points if name == "height_m" else ("load", *points)
            arrays[name] = array if several else array.squeeze(0 if name == "height_m" else 1)
        for name, axis, length_m in zip(("x_m", "y_m"), ("column", "row"), reversed(beside["size_m"])):
            count = arrays["height_m"].shape[-1 if axis == "column" else -2]
            arrays[name], axes[name] = np.arange(count) * (length_m / count), (axis,)
    patches = Patches._of(beside["patches"], axis="patch") if "patches" in beside else None
    return Pressed(arrays, axes, noted(answer.notes), patches=patches)
