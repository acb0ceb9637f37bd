"""Results of calls: named arrays with their axes, units and notes."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from functools import partial
from html import escape
from importlib import import_module
from typing import TYPE_CHECKING, Any, Generic, NoReturn, TypeVar, cast

import numpy as np
import numpy.typing as npt

from truearea._notes import Note, counted

if TYPE_CHECKING:
    import pandas as pd
    import xarray as xr

    from typing_extensions import Self

FloatArray = npt.NDArray[np.float64]
"""Doubles."""

AnyArray = npt.NDArray[Any]
"""Doubles or text."""

# Ends of names and their units, the longest first.
_UNITS = {
    "_pa_per_m": "Pa/m",
    "_w_per_m2_k": "W/(m² K)",
    "_rad_per_m": "rad/m",
    "_j_per_m2": "J/m²",
    "_s_per_m2": "S/m²",
    "_per_m2": "1/m²",
    "_m_per_pa": "m/Pa",
    "_ohm_m2": "Ω m²",
    "_per_m": "1/m",
    "_pa": "Pa",
    "_m4": "m⁴",
    "_m3": "m³",
    "_m2": "m²",
    "_n": "N",
    "_m": "m",
}


def needed(module: str, call: str, extra: str) -> Any:
    """Imports a module that a call needs and the package does not; the extra brings it."""
    try:
        return import_module(module)
    except ImportError as error:
        raise ImportError(f"{call} needs {module}, which is not installed: pip install truearea[{extra}]") from error


T = TypeVar("T")


class Fact(Generic[T]):
    """An attribute that the core knows: it is read from the facts of an object, under its name."""

    def __init__(self, docstring: str) -> None:
        self.__doc__ = docstring

    def __set_name__(self, owner: type, name: str) -> None:
        self._name = name

    def __get__(self, instance: Any, owner: type | None = None) -> T:
        return cast(T, self if instance is None else instance._facts[self._name])

    def __set__(self, instance: Any, value: T) -> NoReturn:
        raise AttributeError(f"{self._name} of a {type(instance).__name__} cannot be set")


def unit_of(name: str) -> str:
    """Returns the unit that a name ends in; empty for a name without one and for a logarithm."""
    if name.startswith("ln_"):
        return ""
    ends = (end for end in _UNITS if name.endswith(end))
    return next((_UNITS[end] for end in ends), "")


class Result(dict[str, AnyArray]):
    """Named arrays, each along some of a few axes.

    A result is a dictionary that cannot be changed, from names to arrays, and each array is an attribute as well. ``np.asarray``
    makes a structured array of it, and ``pandas.DataFrame`` a frame where all arrays have one axis. Names end in the unit: ``pressure_pa``,
    ``density_per_m2``. A missing number is NaN, as in data frames.

    Attributes
    ----------
    notes : tuple of Note
        What was assumed, left out, or is doubtful.
    """

    _title = "result"
    _shown = 8

    __slots__ = ("_axes", "notes")

    notes: tuple[Note, ...]

    def __init__(
        self,
        arrays: Mapping[str, AnyArray],
        axes: Mapping[str, tuple[str, ...]],
        notes: tuple[str, ...] = (),
        **beside: Any,
    ) -> None:
        super().__init__(arrays)
        for array in self.values():
            if isinstance(array, np.ndarray):
                array.flags.writeable = False
        self._axes = dict(axes)
        self.notes = tuple(note if isinstance(note, Note) else Note(note) for note in notes)
        for name, value in beside.items():
            setattr(self, name, value)

    if not TYPE_CHECKING:
        # Types know the arrays of every kind of result, so that a mistyped one is an error to a checker.
        def __getattr__(self, name: str) -> Any:
            try:
                return self[name]
            except KeyError:
                raise AttributeError(f"a {type(self).__name__} has no {name}") from None

    def _refuse(self, *_: Any, **__: Any) -> NoReturn:
        raise TypeError(f"a {type(self).__name__} cannot be changed; dict() makes a copy that can")

    __setitem__ = __delitem__ = __ior__ = clear = pop = popitem = setdefault = update = _refuse  # pyright: ignore[reportAssignmentType]

    def __dir__(self) -> list[str]:
        return [*(name for name in super().__dir__() if getattr(Result, name, None) is not Result._refuse), *self]

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> AnyArray:
        """A structured array along all axes, with a field for each array."""
        columns = {name: _spread(array, self._axes[name], self.sizes) for name, array in self.items()}
        table = np.empty(tuple(self.sizes.values()), dtype=[(name, column.dtype) for name, column in columns.items()])
        for name, column in columns.items():
            table[name] = column
        return table if dtype is None else table.astype(dtype)

    def __reduce__(self) -> tuple[Any, ...]:
        slots = (name for kind in type(self).__mro__ for name in vars(kind).get("__slots__", ()))
        beside = {name: getattr(self, name) for name in slots if name not in Result.__slots__}
        return (partial(type(self), **beside), (dict(self), self._axes, self.notes))

    def __eq__(self, other: object) -> bool:
        if type(other) is not type(self):
            return NotImplemented
        return (
            list(self) == list(other)
            and self._axes == other._axes
            and all(_same(self[name], other[name]) for name in self)
        )

    __hash__ = None

    def __repr__(self) -> str:
        sizes = ", ".join(f"{axis}: {size}" for axis, size in self.sizes.items())
        head = f"{type(self).__name__} ({sizes}){counted(self.notes)}"
        width = max((len(name) for name in self), default=0)
        lines = [f"  {name:<{width}}  {_in_short(name, array)}" for name, array in self.items()]
        notes = [f"  {note.level}: {note}" for note in self.notes]
        return "\n".join([head, *lines, *notes])

    def _repr_html_(self) -> str:
        sizes = ", ".join(f"{axis}: {size}" for axis, size in self.sizes.items())
        rows = "".join(
            f"<tr><th style='text-align:left'>{escape(name)}</th><td>{' × '.join(self._axes[name])}</td>"
            f"<td>{escape(unit_of(name))}</td><td style='text-align:left'>{escape(_values(array))}</td></tr>"
            for name, array in self.items()
        )
        return (
            f"<div><div>{self._drawing()}</div><b>{escape(self._title)}</b> ({escape(sizes)})"
            "<table><thead><tr><th>array</th><th>axes</th><th>unit</th><th>values</th></tr></thead>"
            f"<tbody>{rows}</tbody></table>{notes_html(self.notes)}</div>"
        )

    def _drawing(self) -> str:
        """The picture above the table in notebooks; none of most results."""
        return ""

    @property
    def sizes(self) -> dict[str, int]:
        """The axes and how long they are."""
        return {
            axis: length
            for name, array in self.items()
            for axis, length in zip(self._axes[name], np.shape(array))
        }

    def axes(self, name: str) -> tuple[str, ...]:
        """The axes of an array, in order."""
        return self._axes[name]

    def to_pandas(self) -> pd.DataFrame:
        """One row for each combination of the axes, one column for each array.

        Returns
        -------
        pandas.DataFrame
            With the notes in ``attrs["notes"]``.
        """
        pandas = needed("pandas", "to_pandas", "pandas")
        sizes = self.sizes
        shape = tuple(sizes.values())
        columns = {name: _spread(array, self._axes[name], sizes).reshape(-1) for name, array in self.items()}
        frame: pd.DataFrame = pandas.DataFrame(columns, index=None if shape else [0])
        frame.attrs["notes"] = list(self.notes)
        return frame

    def to_xarray(self) -> xr.Dataset:
        """The arrays with their axes; those that number an axis become its coordinates, by which ``sel`` selects.

        Attributes give ``long_name`` and ``units``.

        Returns
        -------
        xarray.Dataset
            With the notes in ``attrs["notes"]``, a line each.
        """
        xarray = needed("xarray", "to_xarray", "xarray")
        variables = {name: (self._axes[name], array, _attributes(name)) for name, array in self.items()}
        coordinates = [name for name in self if len(self._axes[name]) == 1 and self._is_coordinate(name)]
        data: xr.Dataset = xarray.Dataset(variables, attrs={"notes": "\n".join(self.notes)}).set_coords(coordinates)
        for name in coordinates:
            data = data.set_xindex(name)
        return data

    def _is_coordinate(self, name: str) -> bool:
        return len(self.sizes) > 1


def rows_html(rows: Mapping[str, str]) -> str:
    """Returns a table of names and values."""
    rows_text = "".join(
        f"<tr><th style='text-align:left'>{escape(name)}</th><td style='text-align:left'>{escape(value)}</td></tr>"
        for name, value in rows.items()
    )
    return f"<table>{rows_text}</table>"


def notes_html(notes: Iterable[str]) -> str:
    """A list of notes; nothing where there are none."""
    items = "".join(f"<li>{escape(note)}</li>" for note in notes)
    return f"<ul>{items}</ul>" if items else ""


def _attributes(name: str) -> dict[str, str]:
    """Unit and name for the axes of plots."""
    end = next((end for end in _UNITS if name.endswith(end)), "")
    return {"long_name": name.removesuffix(end).replace("_", " "), "units": unit_of(name)}


def _same(one: AnyArray, other: AnyArray) -> bool:
    is_number = np.issubdtype(np.asarray(one).dtype, np.floating)
    return bool(np.array_equal(one, other, equal_nan=is_number))


def _values(array: AnyArray) -> str:
    flat = np.asarray(array).reshape(-1)
    if flat.size == 0:
        return "none"
    if not np.issubdtype(flat.dtype, np.floating):
        return _listed([str(value) for value in flat[:3]], flat.size)
    if flat.size <= 3:
        return ", ".join(f"{value:.4g}" for value in flat)
    numbers = flat[~np.isnan(flat)]
    return f"{numbers.min():.4g} to {numbers.max():.4g}" if numbers.size else "none"


def _listed(words: list[str], size: int) -> str:
    return ", ".join(words) + (", …" if size > len(words) else "")


def _in_short(name: str, array: AnyArray) -> str:
    unit = unit_of(name)
    return f"{_values(array)} {unit}".rstrip()


def _spread(array: AnyArray, axes: tuple[str, ...], sizes: Mapping[str, int]) -> AnyArray:
    """An array along all axes, repeated along those that it does not have."""
    order = [axis for axis in sizes if axis in axes]
    turned = np.transpose(np.asarray(array), [axes.index(axis) for axis in order])
    shape = tuple(sizes[axis] if axis in axes else 1 for axis in sizes)
    return np.broadcast_to(turned.reshape(shape), tuple(sizes.values()))


class Table(Result):
    """Columns of one length, row by row along the axis ``row``."""

    _title = "table"
    __slots__ = ()

    @classmethod
    def _of(cls, columns: Mapping[str, Any], notes: tuple[str, ...] = (), axis: str = "row", **beside: Any) -> Self:
        arrays = {name: np.asarray(values) for name, values in columns.items()}
        return cls(arrays, {name: (axis,) for name in arrays}, notes, **beside)
