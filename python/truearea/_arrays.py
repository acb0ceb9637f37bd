"""Arguments that are numbers or arrays of them, made ready for the core without a copy where none is needed."""

from __future__ import annotations

from typing import Any

import numpy as np

from truearea._native import InputError
from truearea._results import FloatArray


def doubles(argument: str, given: Any) -> FloatArray:
    """An array of doubles, the same memory where it is one already.

    Whole numbers, single precision and the other order of bytes are converted; text, dates, booleans, complex numbers and what
    else is no number are refused, and so are masked arrays with gaps.
    """
    if np.ma.is_masked(given):
        raise InputError(f"{argument}: {np.count_nonzero(np.ma.getmaskarray(given))} of {np.size(given)} numbers are masked; fill them")
    try:
        array = np.asarray(given)
    except ValueError as error:
        raise InputError(f"{argument}: no array can be made of it: {error}") from None
    if array.dtype.kind not in "fiu":
        kind = "empty" if array.size == 0 else f"of type {array.dtype}"
        if array.size == 0 and array.dtype.kind == "O":
            return np.empty(array.shape)
        raise InputError(f"{argument}: numbers are needed, and these are {kind}")
    return array.astype(np.float64, copy=False)


def formula_of(hardness_formula: str | None, hardness: str | None) -> str | None:
    """The form of the hardness of spheres, by its name or by ``hardness``, the former one."""
    if hardness_formula is not None and hardness is not None:
        raise InputError("hardness_formula and hardness, its former name, are both given; give one")
    return hardness_formula or hardness
