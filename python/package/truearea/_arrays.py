"""Arguments that are numbers or arrays of them, made ready for the core without a copy where none is needed."""

from __future__ import annotations

import numbers
from collections.abc import Mapping, Set
from typing import Any

import numpy as np

from truearea._native import InputError, si_number, without_unit
from truearea._results import FloatArray


def lengths_of(argument: str, of_size: str, size: Any, shape: tuple[int, ...]) -> list[Any]:
    """Lengths along x, and of a map along y; of a square map one is enough."""
    if len(shape) not in (1, 2):
        raise InputError(
            f"{argument}: a map of two axes, (rows, columns), or a line of one is needed, and this has {len(shape)}"
        )
    lengths = [size] if (several := each(size)) is None else several
    if len(lengths) == 1 and len(shape) == 2:
        if shape[0] != shape[1]:
            raise InputError(
                f"{of_size}: one length is that of a square map, and {argument} has {shape[0]} rows and {shape[1]} columns; give (lx, ly)"
            )
        return 2 * lengths
    if len(lengths) != len(shape):
        needed = "a line; give one" if len(shape) == 1 else "a map; give (lx, ly)"
        raise InputError(f"{of_size}: {len(lengths)} lengths are given, and {argument} is {needed}")
    return lengths


def each(given: Any) -> list[Any] | None:
    """The elements of anything that has some, quantities among them; None of one thing, which text is."""
    try:
        return None if isinstance(given, (str, bytes, Set, Mapping)) else list(given)
    except TypeError:
        return None


_ROWS, _COLUMNS = {"y", "row", "rows"}, {"x", "column", "columns"}


def metres(argument: str, given: Any) -> FloatArray:
    """Heights [m], with y before x as the last axes: those of a DataArray are turned by their names."""
    dims = getattr(given, "dims", ())
    if len(dims) > 1:
        across, along = ([dim for dim in dims if str(dim).removesuffix("_m") in names] for names in (_ROWS, _COLUMNS))
        if len(across) == len(along) == 1:
            given = given.transpose(..., across[0], along[0])
        elif not all(str(dim).startswith("dim_") for dim in dims[-2:]):
            raise InputError(f"{argument}: which of its dims {dims} are rows? rename them to y and x")
    return doubles(argument, given, "m")


def doubles(argument: str, given: Any, unit: str = "") -> FloatArray:
    """Returns an array of doubles, not copied if it is one already; quantities, DataArrays and text are converted to ``unit``.

    Whole numbers, single precision and the other order of bytes are converted. Dates, booleans, complex numbers, anything else
    that is not a number, and masked arrays with gaps are refused.
    """
    if type(given) is float:
        return np.array(given)
    if np.ma.is_masked(given):
        raise InputError(f"{argument}: {np.count_nonzero(np.ma.getmaskarray(given))} of {np.size(given)} numbers are masked; fill them")
    if type(given) is not np.ndarray:
        given = _bare(argument, given, unit)
    elif given.dtype.kind in "UTO" and given.size:
        bare = np.empty(given.size, dtype=object)
        bare[:] = _bare(argument, given.reshape(-1).tolist(), unit)
        given = bare.reshape(given.shape)
    try:
        array = np.asarray(given)
        if array.dtype.kind == "O" and array.size and all(map(_is_real, array.flat)):
            array = array.astype(np.float64)
    except (ValueError, OverflowError) as error:
        raise InputError(f"{argument}: it cannot become an array: {error}") from None
    if array.dtype.kind not in "fiu":
        kind = "empty" if array.size == 0 else f"of type {array.dtype}"
        if array.size == 0 and array.dtype.kind == "O":
            return np.empty(array.shape)
        raise InputError(f"{argument}: numbers are needed, and these are {kind}")
    return array.astype(np.float64, copy=False)


def _is_real(given: Any) -> bool:
    """Returns True for a real number, including decimals and fractions."""
    return isinstance(given, numbers.Number) and not isinstance(given, (bool, complex))


def _bare(argument: str, given: Any, unit: str) -> Any:
    """Numbers of quantities and of text with units, which may be elements of a list."""
    if isinstance(given, str):
        if not unit:
            raise InputError(f"{argument}: numbers are needed, and this is text")
        return si_number(argument, unit, given)
    if isinstance(given, (list, tuple)):
        return [_bare(f"{argument}[{at}]", one, unit) for at, one in enumerate(given)]
    return without_unit(argument, unit, given)
