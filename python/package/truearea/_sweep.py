"""Scenes and functions over many values, in this process or on the workers of Dask."""

from __future__ import annotations

import itertools
import math
import os
import threading
from collections.abc import Callable, Iterable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from truearea import _native
from truearea._native import InputError
from truearea._results import AnyArray, needed
from truearea._scene import Scene
from truearea._threads import within

if TYPE_CHECKING:
    import pandas as pd

# The least and the most rows of a part, and of one of a vectorised function.
_ROWS_PER_PART = (2**4, 2**8)
_ROWS_PER_VECTORISED_PART = (2**12, 2**17)
_LEAST_PARTS, _MOST_PARTS = 8, 10**5


def sweep(
    swept: Scene | Callable[..., Any],
    axes: Mapping[str, Any] | pd.DataFrame,
    to: str | os.PathLike[str] | None = None,
    client: Any = None,
    vectorised: bool = False,
) -> Any:
    """Computes a scene or a function for every combination of values.

    Parameters
    ----------
    swept : Scene or callable
        A scene, whose keys are set as by :meth:`Scene.replace`; its rows are the final area of every curve under every load. Or a
        function of one keyword for each axis, which returns a mapping of single values, or one number.
    axes : mapping of str to array_like, or data frame
        The values of each name. Every combination is a row, and the last name changes fastest; a data frame has its own rows.
    to : str or path-like, optional
        A folder, which receives a Parquet file for each part of the rows (up to 256, or 131,072 of a vectorised function). A sweep
        that was killed continues when it is started again: a part whose file is whole is skipped. The files do not know the
        function: give a changed function, or changed files of a scene, a new folder.
    client : distributed.Client, optional
        Dask's client, whose workers write the parts; they must share the folder. By default this process writes them.
    vectorised : bool, default False
        The function takes arrays, an element for each row, and returns a mapping of arrays, as :func:`contact` does.

    Returns
    -------
    pandas.DataFrame or pathlib.Path
        The rows, with the values of the axes in front; with ``to`` the folder, for ``pandas.read_parquet`` or
        ``dask.dataframe.read_parquet``.

    Raises
    ------
    InputError
        If the axes do not fit the function, if a row is refused (with its values), or if the folder holds parts of other axes.
    ImportError
        If pandas or pyarrow is not installed: ``pip install truearea[cluster]``.

    Examples
    --------
    >>> import truearea as ta
    >>> ta.sweep(lambda length, width: length * width, {"length": [1, 2], "width": [3.0]})
       length  width  value
    0       1    3.0    3.0
    1       2    3.0    6.0
    """
    rows = _Rows(swept, axes, vectorised)
    if to is None:
        if client is not None:
            raise InputError("client needs a folder: give to, into which its workers write")
        return needed("pandas", "sweep", "cluster").concat([rows.frame(part) for part in range(rows.parts)], ignore_index=True)
    folder = Path(to)
    folder.mkdir(parents=True, exist_ok=True)
    left = rows.missing_from(folder)
    if client is None or not left:
        for part in left:
            rows.write(part, folder)
    else:
        shared = client.scatter(rows, broadcast=True, hash=False)
        client.gather(client.map(_Rows.write, [shared] * len(left), left, folder=folder.absolute(), pure=False))
    return folder


class _Rows:
    """The rows of a product of axes, in parts of one size."""

    def __init__(self, swept: Scene | Callable[..., Any], axes: Any, vectorised: bool) -> None:
        is_frame = (columns := getattr(axes, "columns", None)) is not None
        names = list(axes if columns is None else columns) if is_frame or isinstance(axes, Mapping) else []
        if not names:
            raise InputError("axes: give a mapping from names to values, or a data frame, with at least one name")
        self.axes = {name: _column(name, axes[name]) for name in names}
        self.swept = swept
        self.vectorised = vectorised = _native.truth("vectorised", vectorised)
        if vectorised and isinstance(swept, Scene):
            raise InputError("vectorised is for functions; a scene is computed row by row")
        if not isinstance(swept, Scene) and not callable(swept):
            raise InputError(f"give a Scene or a function to sweep, not a value of type {type(swept).__name__}")
        # A data frame has one axis.
        self.lengths = [len(column) for column in self.axes.values()][: 1 if is_frame else None]
        self.count = math.prod(self.lengths)
        least, most = _ROWS_PER_VECTORISED_PART if vectorised else _ROWS_PER_PART
        self.size = min(most, max(least, math.ceil(self.count / _LEAST_PARTS)))
        self.parts = math.ceil(self.count / self.size)
        if self.parts > _MOST_PARTS:
            raise InputError(f"axes: {self.count:.3g} rows are given, and a sweep takes up to {_MOST_PARTS * self.size:.3g}; divide it")

    def given(self, part: int) -> dict[str, AnyArray]:
        """Returns the values of the rows of a part."""
        rows = np.arange(part * self.size, min((part + 1) * self.size, self.count))
        places = itertools.cycle(np.unravel_index(rows, self.lengths))
        return {name: column[at] for (name, column), at in zip(self.axes.items(), places)}

    def frame(self, part: int) -> Any:
        """Computes the rows of a part, with the values of the axes in front."""
        given = self.given(part)
        with within(1):
            found, counts = self._block(given) if self.vectorised else self._row_by_row(given)
        if hidden := [name for name in found if name in given]:
            raise InputError(f"{hidden[0]} is the name of an axis and of a result; rename one of them")
        shown = {name: np.repeat(_shown(column), counts) for name, column in given.items()}
        return needed("pandas", "sweep", "cluster").DataFrame({**shown, **found})

    def write(self, part: int, folder: Path) -> None:
        """Writes a part under another name and renames it, so that its file is whole or absent."""
        aside = folder / f".{part}.{os.getpid()}-{threading.get_ident()}.aside"
        try:
            self.frame(part).to_parquet(aside, index=False)
            aside.replace(folder / f"part-{part:06}.parquet")
        finally:
            aside.unlink(missing_ok=True)

    def missing_from(self, folder: Path) -> list[int]:
        """Lists the parts without a whole file; refuses a folder with parts of other axes."""
        files = [folder / f"part-{part:06}.parquet" for part in range(self.parts)]
        if others := sorted(set(folder.glob("*.parquet")) - set(files)):
            raise InputError(f"to: {others[0]} is not a part of this sweep; name another folder")
        return [part for part, file in enumerate(files) if not self._is_written(file, part)]

    def _is_written(self, file: Path, part: int) -> bool:
        pandas, arrow = (needed(module, "sweep", "cluster") for module in ("pandas", "pyarrow"))
        try:
            there = pandas.read_parquet(file)
        except (OSError, ValueError, arrow.ArrowException):
            return False
        given = pandas.DataFrame({name: _shown(column) for name, column in self.given(part).items()})
        # A scene has several rows for each combination.
        axes = there.reindex(columns=given.columns)
        if not axes.drop_duplicates(ignore_index=True).equals(given.drop_duplicates(ignore_index=True)):
            raise InputError(f"to: {file} has rows of other axes; name another folder")
        return True

    def _block(self, given: dict[str, AnyArray]) -> tuple[dict[str, AnyArray], int]:
        count = len(next(iter(given.values())))
        found = self.swept(**given)  # type: ignore[operator]
        if not isinstance(found, Mapping):
            raise InputError(f"a vectorised function returns a mapping of arrays, not a value of type {type(found).__name__}")
        if wrong := [name for name, values in found.items() if np.shape(values) not in ((), (count,))]:
            shape = np.shape(found[wrong[0]])
            raise InputError(f"{wrong[0]} has the shape {shape}; {count} rows need ({count},) or a single value")
        return {name: np.broadcast_to(values, (count,)) for name, values in found.items()}, 1

    def _row_by_row(self, given: dict[str, AnyArray]) -> tuple[dict[str, AnyArray], list[int]]:
        each = [self._row(dict(zip(given, values))) for values in zip(*(column.tolist() for column in given.values()))]
        if others := [list(columns) for columns in each if list(columns) != list(each[0])]:
            raise InputError(f"one row has the columns {others[0]}, and the first has {list(each[0])}")
        counts = [len(next(iter(columns.values()), ())) for columns in each]
        return {name: np.concatenate([columns[name] for columns in each]) for name in each[0]}, counts

    def _row(self, given: dict[str, Any]) -> dict[str, AnyArray]:
        try:
            if isinstance(self.swept, Scene):
                return dict(self.swept.replace(**given).scales())
            found = self.swept(**given)
            found = found if isinstance(found, Mapping) else {"value": found}
            if missing := [name for name, value in found.items() if value is None]:
                raise InputError(f"the function returns None as {missing[0]}")
        except Exception as error:
            row = ", ".join(f"{name} = {value}" for name, value in given.items())
            if isinstance(error, InputError):
                raise InputError(f"{row}: {error}") from None
            if hasattr(error, "add_note"):
                error.add_note(f"in the row {row}")
            raise
        if wide := [name for name, value in found.items() if np.size(value) != 1]:
            raise InputError(f"{wide[0]} has the shape {np.shape(found[wide[0]])}; a row needs a single value")
        return {str(name): np.reshape(np.asarray(value), 1) for name, value in found.items()}


def _column(name: str, values: Any) -> AnyArray:
    if isinstance(values, (str, bytes, Mapping)) or not isinstance(values, Iterable):
        raise InputError(f"axes[{name!r}]: give a list or an array of values, not a value of type {type(values).__name__}")
    if hasattr(values, "to_value") or getattr(values, "attrs", {}).get("units"):
        raise InputError(f"axes[{name!r}]: give numbers in SI units, or text with a unit, in place of an array with a unit")
    values = values if isinstance(values, np.ndarray) else list(values)
    is_plain = isinstance(values, np.ndarray) or all(isinstance(value, (bool, int, float, np.number)) for value in values)
    column: AnyArray = np.asarray(values) if is_plain else np.fromiter(values, dtype=object, count=len(values))
    if column.ndim != 1 or len(column) == 0:
        raise InputError(f"axes[{name!r}]: give one axis with at least one value, not the shape {column.shape}")
    return column


def _shown(column: AnyArray) -> AnyArray:
    """Returns a column with its objects as text."""
    if column.dtype.kind != "O":
        return column
    return np.array([value if isinstance(value, str) else repr(value) for value in column], dtype=object)
