"""Roughness parameters by the standards."""

from __future__ import annotations

import os
from typing import Any, Literal, TypedDict, overload

from truearea import _native
from truearea._choices import Conventions, Form
from truearea._composite import heights_of
from truearea._material import Quantity
from truearea._native import InputError
from truearea._notes import noted
from truearea._options import Unpack, with_options
from truearea._picture import Drawn, Picture, Trace
from truearea._results import AnyArray, FloatArray, Table
from truearea._scan import Scan, read_scan


class Roughness(Table):
    """Roughness parameters, a row for each, lengths in um.

    A symbol gives the value of its parameter: ``found["Sq"]``.
    """

    _title = "roughness parameters"
    __slots__ = ()
    file: AnyArray
    channel: AnyArray
    parameter: AnyArray
    value: FloatArray
    unit: AnyArray
    convention: AnyArray

    def __getitem__(self, name: str) -> Any:
        """A column by its name, or the value of a parameter by its symbol, such as ``"Sq"``, in its unit."""
        if name in self.keys():
            return super().__getitem__(name)
        rows = [at for at, symbol in enumerate(super().__getitem__("parameter")) if symbol == name]
        if not rows:
            raise KeyError(name)
        return float(super().__getitem__("value")[rows[0]])


class RoughnessScales(Drawn, Table):
    """Rms gradient and curvature of all roughness down to each wavelength, from the spectrum and from differences of heights.

    Wavelengths go from long to short. NaN where one has no value, and of the spectrum where points have no height.
    """

    _title = "slopes and curvatures down to each wavelength"
    __slots__ = ()
    file: AnyArray
    channel: AnyArray
    wavelength_m: FloatArray
    rms_gradient_spectrum: FloatArray
    rms_gradient_heights: FloatArray
    rms_curvature_spectrum_per_m: FloatArray
    rms_curvature_heights_per_m: FloatArray

    def _picture(self) -> Picture:
        each = {"from the spectrum": self.rms_gradient_spectrum, "from the heights": self.rms_gradient_heights}
        lines = (Trace(self.wavelength_m, y, label, condition=at) for at, (label, y) in enumerate(each.items()))
        return Picture(self._title, "wavelength_m", "rms_gradient", tuple(lines))


class RoughnessOptions(TypedDict, total=False):
    """Options of parameters, and of gradients and curvatures."""

    unit: str | None
    channel: str | None
    form: Form | None
    filter: Quantity | None
    short_filter: Quantity | None


@overload
def roughness(
    surface: Any,
    size: Any = None,
    *,
    ratio_height: Quantity | None = None,
    convention: Conventions | None = None,
    scales: Literal[False] = False,
    **options: Unpack[RoughnessOptions],
) -> Roughness: ...
@overload
def roughness(
    surface: Any, size: Any = None, *, scales: Literal[True], **options: Unpack[RoughnessOptions]
) -> RoughnessScales: ...
@with_options(RoughnessOptions)
def roughness(
    surface: Any,
    size: Any = None,
    *,
    ratio_height: Quantity | None = None,
    convention: Conventions | None = None,
    scales: bool = False,
    **options: Any,
) -> Roughness | RoughnessScales:
    """Roughness parameters of a map (ISO 25178-2) or a profile (ISO 21920-2), as ``truearea roughness`` has them.

    Parameters
    ----------
    surface : Scan, array_like of float, or path
        Heights: a scan, an array in m with its ``size``, an object of SurfaceTopography, or a file.
    size : float or str, or two of them, optional
        Lengths (lx, ly) of an array; of a file, the length along its lines where it gives none.
    unit, height_unit, channel : str, optional
        Of a file, as for :func:`read_scan`.
    form : {"plane", "mean", "none", "second-order"}, optional
        The form that is subtracted first; a plane or line where left out.
    filter, short_filter : float or str, optional
        Cut-off wavelengths of the Gaussian filters of ISO 16610 that remove longer and shorter waves, in m or as text.
    ratio_height : float or str, optional
        The height above the mean at which the material ratio is taken; 0 where left out.
    convention : {"usual", "all"}, optional
        One row for each parameter, as where left out, or also those of other conventions in use.
    scales : bool, default False
        In place of the parameters the rms gradient and curvature of all roughness down to each wavelength, as
        ``truearea roughness --scales`` has them.

    Raises
    ------
    FileNotFoundError
        If the file does not exist.
    InputError
        Where no point has a height, or a filter is longer than the scan.

    Examples
    --------
    >>> import numpy as np
    >>> import truearea as ta
    >>> x = np.arange(1000) * 10e-9
    >>> found = ta.roughness(10e-9 * np.cos(2 * np.pi * (x + 5e-9) / 1e-6), "10 um")
    >>> round(found["Rq"], 6)
    0.007071
    """
    if _native.truth("scales", scales) and (ratio_height is not None or convention is not None):
        raise InputError("ratio_height and convention have no effect on scales; leave them out")
    of_file = {name: options.pop(name, None) for name in ("unit", "height_unit", "channel")}
    if isinstance(surface, (str, os.PathLike)):
        surface, size = read_scan(surface, size=size, **of_file), None
    elif any(value is not None for value in of_file.values()):
        raise InputError("unit, height_unit and channel are for files; leave them out")
    if isinstance(surface, Scan):
        if size is not None:
            raise InputError("surface is a Scan, which has its size; leave size out")
        native = surface._native
    else:
        native = _native.Scan.of_heights(heights_of("surface", "size", "heights", surface, size, None))
    arguments = {"ratio_height": ratio_height, "convention": convention, "scales": scales, **options}
    columns, notes = native.roughness(arguments)
    return (RoughnessScales if scales else Roughness)._of(columns, noted(notes))
