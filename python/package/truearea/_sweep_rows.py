"""The rows of a sweep, any of them, the same wherever and with whichever others they are computed."""

from __future__ import annotations

import json
import time
from collections.abc import Callable, Mapping
from typing import Any, Union

import numpy as np

from truearea import _native
from truearea._native import InputError
from truearea._results import AnyArray, Result
from truearea._scene import Scene
from truearea._sweep_axes import Axes
from truearea._sweep_digest import digest_of, name_of, sha256
from truearea._threads import one_thread

Swept = Union[Scene, Callable[..., Any]]
"""A scene, whose keys are set, or a function, which is called with keywords."""

Columns = dict[str, AnyArray]

_PROBE_SECONDS = 0.2


class Rows:
    """What is computed for every row."""

    def __init__(self, swept: Swept, axes: Axes, repeats: int, seed: int, vectorised: bool, table: str | None) -> None:
        self.swept = swept
        self.axes = axes
        self.repeats = repeats
        self.seed = seed
        self.vectorised = vectorised
        self.table = table
        self.count = axes.rows * repeats
        self._parameters = () if isinstance(swept, Scene) else _extra_parameters(swept, axes.names)
        if vectorised and isinstance(swept, Scene):
            raise InputError("vectorised is for functions; a scene is carried out row by row")
        if vectorised and "rng" in self._parameters:
            raise InputError(
                "a vectorised function cannot take rng, since its blocks are of any size; draw the numbers beforehand and give "
                "them in over, or take row, the numbers of the rows"
            )
        if table is not None and not isinstance(swept, Scene):
            raise InputError("table is for scenes; a function yields its columns itself")
        # Rows that were computed to see how long they take.
        self._head: list[Columns] = []
        # Where the rows come from. A worker need not have the source of the function.
        self._told: dict[str, Any] | None = None
        # The columns of the first row, and what is in each, which those of all rows have.
        self.kinds: dict[str, str] = {}

    def key(self) -> str:
        """What tells this sweep from any other, the version of the program included."""
        what = {
            **self.told(),
            "over": self.axes.digest(),
            "vectorised": self.vectorised,
        }
        return sha256(json.dumps(what, sort_keys=True).encode()).hexdigest()

    def told(self) -> dict[str, Any]:
        """Where the rows come from, for people."""
        if self._told is None:
            of = {"scene": self.swept.text} if isinstance(self.swept, Scene) else {"function": name_of(self.swept)}
            import platform

            self._told = {
                "program": f"truearea {_native.VERSION}",
                "python": platform.python_version().rpartition(".")[0],
                **of,
                "source": digest_of(self.swept, "" if isinstance(self.swept, Scene) else name_of(self.swept)),
                "over": self.axes.told(),
                "repeats": self.repeats,
                "seed": self.seed,
                "table": self.table,
            }
        return self._told

    def begin(self) -> None:
        """Computes the first row, which tells the columns."""
        with one_thread():
            if self.vectorised:
                found, _ = self._block(0, 1)
            else:
                found = self._row(0)
                self._head = [found]
        self.kinds = {name: _kind(name, column) for name, column in found.items()}
        if hidden := [name for name in self.kinds if name in self.axes.names or name == "repeat"]:
            raise InputError(f"{hidden[0]} is a column of over and a result; call one of them otherwise")

    def rows_within(self, seconds: float, most: int) -> int:
        """As many rows, a power of two, as take no longer than that by themselves."""
        count, taken = 1, 0.0
        with one_thread():
            while True:
                begun = time.perf_counter()
                if self.vectorised:
                    self._block(0, count)
                    taken = time.perf_counter() - begun
                else:
                    first = len(self._head)
                    self._head.extend(self._row(row) for row in range(first, count))
                    taken = (time.perf_counter() - begun) * count / max(count - first, 1)
                if taken >= min(_PROBE_SECONDS, seconds) or 2 * count > min(self.count, most):
                    break
                count *= 2
        rows = max(1.0, count * seconds / max(taken, 1e-9))
        return int(min(most, 2 ** int(np.log2(rows))))

    def columns(self, start: int, stop: int) -> tuple[Columns, tuple[str, ...]]:
        """The rows from one to before another, and what there is to say of them."""
        notes: tuple[str, ...] = ()
        if self.vectorised:
            found, notes = self._block(start, stop)
            counts = np.ones(stop - start, dtype=np.int64)
        else:
            each = [self._head[row] if row < len(self._head) else self._row(row) for row in range(start, stop)]
            for row, columns in zip(range(start, stop), each):
                self._check(row, columns)
            counts = np.array([len(next(iter(columns.values()), ())) for columns in each], dtype=np.int64)
            found = {name: np.concatenate([columns[name] for columns in each]) for name in self.kinds}
            if isinstance(self.swept, Scene):
                notes = self.swept.notes
        self._check(start, found)
        rows = np.arange(start, stop, dtype=np.int64)
        given: Columns = {name: _shown(column) for name, column in self.axes.block(rows // self.repeats).items()}
        if self.repeats > 1:
            given["repeat"] = rows % self.repeats
        whole = {name: np.repeat(column, counts) for name, column in given.items()}
        whole.update({name: _of_kind(name, kind, found[name]) for name, kind in self.kinds.items()})
        return whole, notes

    def _check(self, row: int, columns: Columns) -> None:
        if list(columns) != list(self.kinds):
            raise InputError(
                f"row {row} yields {', '.join(columns) or 'no columns'}, and the first one {', '.join(self.kinds)}; all rows "
                "are to have the same columns"
            )

    def _block(self, start: int, stop: int) -> tuple[Columns, tuple[str, ...]]:
        rows = np.arange(start, stop, dtype=np.int64)
        given = self.axes.block(rows // self.repeats)
        if "row" in self._parameters:
            given["row"] = rows
        assert callable(self.swept)
        try:
            found = self.swept(**given)
        except InputError as error:
            raise InputError(f"rows {start} to {stop - 1}: {error}") from None
        if not isinstance(found, Mapping):
            raise InputError(f"a vectorised function yields a mapping of arrays, and this is of type {type(found).__name__}")
        columns = {}
        for name, values in found.items():
            array = np.asarray(values)
            if array.ndim > 1 or (array.ndim == 1 and len(array) != stop - start):
                raise InputError(f"{name} has the shape {array.shape}, and there are {stop - start} rows")
            columns[name] = np.broadcast_to(array, (stop - start,))
        return columns, found.notes if isinstance(found, Result) else ()

    def _row(self, row: int) -> Columns:
        given = {
            name: column[0] if column.dtype.kind == "O" else column[0].item()
            for name, column in self.axes.block(np.array([row // self.repeats])).items()
        }
        try:
            if isinstance(self.swept, Scene):
                return _of_scene(self.swept.replace(**given), self.table)
            if "rng" in self._parameters:
                given["rng"] = np.random.default_rng([self.seed, row])
            if "row" in self._parameters:
                given["row"] = row
            return _of_call(self.swept(**given))
        except InputError as error:
            raise InputError(f"row {row} ({', '.join(f'{name} = {given[name]}' for name in self.axes.names)}): {error}") from None


def _of_scene(scene: Scene, table: str | None) -> Columns:
    if table is None:
        return dict(scene.scales())
    of_report, of_judge, of_draws = _native.tables_of_runs()
    results = scene.run(report=table in of_report, judge=table in of_judge, uncertainty=table in of_draws)
    if table not in results.tables:
        raise InputError(f"table: the scene makes no {table}; it makes {', '.join(results.tables)}")
    return dict(results.tables[table])


def _of_call(found: Any) -> Columns:
    if not isinstance(found, Mapping):
        found = {"value": found}
    columns = {}
    for name, value in found.items():
        array = np.asarray(np.nan if value is None else value)
        if array.size != 1:
            raise InputError(f"{name} has the shape {array.shape}, and one value is needed for a row")
        columns[str(name)] = array.reshape(1)
    return columns


def _kind(name: str, column: AnyArray) -> str:
    if column.dtype.kind in "fiu":
        return "number"
    if column.dtype.kind == "b":
        return "truth"
    if all(isinstance(value, str) for value in column.tolist()):
        return "text"
    raise InputError(f"{name}: numbers, truths or text are needed, and these are of type {column.dtype}")


def _of_kind(name: str, kind: str, column: AnyArray) -> AnyArray:
    """The column as that of the first row, numbers as doubles, so that all files have the same columns."""
    found = _kind(name, column) if len(column) else kind
    if found != kind:
        raise InputError(f"{name} is a {kind} in the first row, and a {found} later")
    return column.astype({"number": np.float64, "truth": np.bool_, "text": object}[kind])


def _shown(column: AnyArray) -> AnyArray:
    """Anything that is no number as text."""
    if column.dtype.kind != "O":
        return column
    return np.array([value if isinstance(value, str) else repr(value) for value in column], dtype=object)


def _extra_parameters(function: Callable[..., Any], names: list[str]) -> tuple[str, ...]:
    """Which of the parameters that are no columns the function takes; what does not fit is refused before all else."""
    if not callable(function):
        raise InputError(f"a Scene or a function is needed, and this is of type {type(function).__name__}")
    import inspect

    try:
        parameters = inspect.signature(function).parameters
    except (TypeError, ValueError):
        return ()
    extra = tuple(name for name in ("rng", "row") if name in parameters and name not in names)
    try:
        inspect.signature(function).bind(**{name: None for name in (*names, *extra)})
    except TypeError as error:
        raise InputError(f"over: the function cannot be called with {', '.join(names)}: {error}") from None
    return extra
