"""What a sweep goes over: rows of values, made when they are needed."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from typing import Any

import numpy as np

from truearea._native import InputError
from truearea._results import AnyArray
from truearea._sweep_digest import digest_of, sha256

Over = Mapping[Any, Any]
"""Values by name; a tuple of names has as many columns that go together."""

_MOST_TOLD = 64


class Axes:
    """The rows of a product of columns, the last of which changes fastest. Columns that go together are one factor."""

    def __init__(self, over: Over, zipped: bool) -> None:
        if not isinstance(over, Mapping) or not over:
            raise InputError("over: a mapping from names to values is needed, with at least one name")
        factors = [_factor(names, values) for names, values in over.items()]
        if zipped:
            factors = [{name: column for factor in factors for name, column in factor.items()}]
        self._factors = [_of_one_length(factor) for factor in factors]
        self.names = [name for factor in self._factors for name in factor]
        if twice := {name for name in self.names if self.names.count(name) > 1}:
            raise InputError(f"over: {min(twice)} is given twice")
        self._lengths = [len(next(iter(factor.values()))) for factor in self._factors]
        self.rows = math.prod(self._lengths)

    def block(self, rows: AnyArray) -> dict[str, AnyArray]:
        """The values of each of some rows, by name."""
        places = np.unravel_index(rows, self._lengths)
        return {name: column[at] for factor, at in zip(self._factors, places) for name, column in factor.items()}

    def digest(self) -> list[list[Any]]:
        """What tells these values from any others."""
        return [[[name, len(column), _digest(name, column)] for name, column in factor.items()] for factor in self._factors]

    def told(self) -> dict[str, Any]:
        """The values for people; of many, how many there are, the first and the last."""
        return {name: _told(column) for factor in self._factors for name, column in factor.items()}


def _factor(names: str | tuple[str, ...], values: Any) -> dict[str, AnyArray]:
    if isinstance(names, str):
        return {names: column_of(names, values)}
    columns = list(values)
    if len(columns) != len(names):
        raise InputError(f"over[{names}]: {len(names)} columns are needed, and these are {len(columns)}")
    return {name: column_of(name, column) for name, column in zip(names, columns)}


def column_of(name: str, values: Any) -> AnyArray:
    """An array of numbers, of truths, or of anything else."""
    if isinstance(values, (str, bytes, Mapping)) or not isinstance(values, Iterable):
        raise InputError(f"over[{name!r}]: a list or an array of values is needed, and this is of type {type(values).__name__}")
    if isinstance(values, np.ndarray) and hasattr(values, "to_value"):
        raise InputError(f"over[{name!r}]: quantities with a unit are given; give numbers in SI units, or text with a unit")
    if not isinstance(values, np.ndarray):
        values = list(values)
        kinds = {isinstance(value, (str, bytes)) for value in values}
        array = np.empty(len(values), dtype=object)
        array[:] = values
        # Text and numbers side by side stay what they are.
        values = array if len(kinds) > 1 or not all(_is_plain(value) for value in values) else np.array(values)
    if values.ndim != 1:
        raise InputError(f"over[{name!r}]: an array of one axis is needed, and this has {values.ndim}")
    if len(values) == 0:
        raise InputError(f"over[{name!r}] is empty")
    held = {"f": np.float64, "i": np.int64, "u": np.int64, "b": np.bool_}.get(values.dtype.kind, np.object_)
    column: AnyArray = values.astype(held)
    return column


def _is_plain(value: Any) -> bool:
    return isinstance(value, (str, bool, int, float, np.number, np.bool_))


def _of_one_length(factor: dict[str, AnyArray]) -> dict[str, AnyArray]:
    lengths = {name: len(column) for name, column in factor.items()}
    if len(set(lengths.values())) > 1:
        told = ", ".join(f"{name} has {length}" for name, length in lengths.items())
        raise InputError(f"over: columns that go together are of one length, and {told}")
    return factor


def _digest(name: str, column: AnyArray) -> str:
    if column.dtype.kind == "O":
        return digest_of(column.tolist(), f"over[{name!r}]")
    return sha256(column.dtype.str.encode() + np.ascontiguousarray(column).tobytes()).hexdigest()


def _told(column: AnyArray) -> Any:
    if len(column) <= _MOST_TOLD:
        return [_told_value(value) for value in column]
    return {"count": len(column), "first": _told_value(column[0]), "last": _told_value(column[-1])}


def _told_value(value: Any) -> Any:
    if isinstance(value, np.generic):
        return value.item()
    return value if _is_plain(value) else repr(value)
