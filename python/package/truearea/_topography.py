"""Objects of SurfaceTopography, taken where heights are: by what they can do, so that the package need not be there."""

from __future__ import annotations

from typing import Any

import numpy as np

from truearea import _native
from truearea._arrays import doubles
from truearea._native import InputError
from truearea._results import FloatArray


def is_topography(given: Any) -> bool:
    """Returns True for an object with heights and a size, such as a topography or line scan of SurfaceTopography."""
    return callable(getattr(given, "heights", None)) and hasattr(given, "physical_sizes")


def heights_and_size(topography: Any, argument: str = "heights") -> tuple[FloatArray, tuple[float, ...], bool]:
    """Heights [m], size [m], and whether the surface repeats itself, of a SurfaceTopography-like object.

    Such objects number heights by (x, y); here they are (rows, columns), x along the rows, as everywhere in this package, and masked
    where the object's are. The object's own array is never written to; ``argument`` is what messages call it.
    """
    if not is_topography(topography):
        kind = type(topography).__name__
        raise InputError(f"{argument}: an object with heights() and physical_sizes is needed, and this is of type {kind}")
    if not getattr(topography, "is_uniform", True):
        raise InputError(f"{argument}: its points are unevenly spaced; make it even with to_uniform()")
    unit = _unit(topography, argument)
    heights = topography.heights()
    # Whole numbers are converted; gaps are kept beside the heights.
    values = doubles(argument, np.ma.getdata(heights))
    if values.ndim not in (1, 2):
        raise InputError(f"{argument}: heights of one or two axes are needed, and these have {values.ndim}")
    size = _size(topography, argument)
    if size.shape != (values.ndim,):
        raise InputError(f"{argument}: its heights have {values.ndim} axes and its physical_sizes {size.size}")
    heights_m: FloatArray = _native.in_metres(argument, unit, values.T)
    if np.ma.is_masked(heights):
        heights_m = np.ma.masked_array(heights_m, mask=np.ma.getmaskarray(heights).T)
    size_m = _native.in_metres(argument, unit, size)
    return heights_m, tuple(float(length_m) for length_m in size_m), bool(getattr(topography, "is_periodic", False))


def _unit(topography: Any, argument: str) -> str:
    unit = getattr(topography, "unit", None)
    if not isinstance(unit, str):
        raise InputError(f"{argument}: its unit is {unit!r}; give it one, such as unit='nm' where it is made")
    return unit


def _size(topography: Any, argument: str) -> FloatArray:
    size = topography.physical_sizes
    if size is None:
        raise InputError(f"{argument}: its physical_sizes is None; give it one where it is made")
    return np.atleast_1d(doubles(f"{argument}.physical_sizes", size))
