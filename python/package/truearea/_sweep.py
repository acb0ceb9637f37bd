"""Scenes and functions over many values, on one machine or a cluster of them."""

from __future__ import annotations

import importlib.util
import os
import sys
from pathlib import Path
from typing import Any

from truearea._native import InputError
from truearea._progress import Line, Progress, observer_of
from truearea._sweep_axes import Axes, Over
from truearea._sweep_files import Folder, frame_of, needed, read_part
from truearea._sweep_rows import Rows, Swept
from truearea._threads import one_thread

_MOST_ROWS = 2**20


def sweep(
    swept: Swept,
    over: Over,
    repeats: int = 1,
    *,
    zipped: bool = False,
    vectorised: bool = False,
    seed: int = 1,
    table: str | None = None,
    to: str | os.PathLike[str] | None = None,
    partition_seconds: float = 2.0,
    rows_per_partition: int | None = None,
    client: Any = None,
    progress: Progress = False,
) -> Any:
    """Carry a scene or a function out for every combination of some values.

    The rows are the same, and in the same order, whatever the number of workers and the size of the partitions. Numbers that are
    found are doubles; what is swept over stands before them in columns of its own.

    Parameters
    ----------
    swept : Scene or callable
        A scene, whose keys are set as by :meth:`Scene.replace`; or a function of one keyword for each name in ``over``, which
        yields a mapping of single values, or one number. A function with a parameter ``rng`` is given a
        ``numpy.random.Generator`` that depends on ``seed`` and the number of the row alone; one with a parameter ``row`` is given
        that number.
    over : mapping of str, or tuple of str, to array_like
        The values of each name; every combination is a row, and the last name changes fastest. A tuple of names has as many
        columns that go together, row by row.
    repeats : int, default 1
        Compute every combination so many times, told apart by a column ``repeat``; for functions that draw numbers.
    zipped : bool, default False
        All columns go together, row by row.
    vectorised : bool, default False
        The function takes arrays of any number of rows at once, and yields a mapping of arrays, such as :func:`contact` does.
    seed : int, default 1
        Of the generators, from 0 on.
    table : str, optional
        Of a scene: the table whose rows are wanted for each combination. Left out, the final area of every curve under every
        load: the table ``report-scales``.
    to : str or path-like, optional
        A folder for the rows: a Parquet file for each partition, with where it comes from in its metadata. It is filled at once.
        A sweep that was ended goes on where it was when it is begun again, and computes no partition twice.
    partition_seconds : float, default 2.0
        How long a partition takes, about. Of a folder that was begun, the partitions stay as they were.
    rows_per_partition : int, optional
        How many combinations a partition has, in place of timing the first ones: a power of two.
    client : distributed.Client, optional
        Whose workers write ``to``. Left out, that of this process where there is one; where there is none, this process itself.
    progress : bool or callable, default False
        For ``to``: True for a line on stderr, or what is called with the partitions done and their number.

    Returns
    -------
    dask.dataframe.DataFrame or pandas.DataFrame
        With ``to``, of the files in the folder. Without, nothing is computed before it is asked for; where Dask is not installed,
        all of it is computed at once, into a frame of pandas.

    Raises
    ------
    InputError
        For values that do not go together; with the row for what its values lead to; for a folder of another sweep, with how
        that differs.
    ImportError
        Where neither Dask nor pandas is installed, or ``to`` is given without pyarrow: ``pip install truearea[cluster]``.

    Notes
    -----
    A folder tells functions by their code, the state of objects, what they have captured, and the globals and the functions of
    your own that they use; installed packages count by their names. To see how long rows take, and what their columns are, the first ones are computed here; those of a vectorised function are computed again.

    Examples
    --------
    >>> import truearea as ta
    >>> scene = ta.Scene.template("uncd-measured")
    >>> frame = ta.sweep(scene, over={"youngs_modulus": ["400 GPa", "500 GPa"], "cutoff": [1e-8, 1e-7]})
    >>> frame.compute()[["youngs_modulus", "cutoff", "curve", "area_fraction"]].head(2)
      youngs_modulus ... curve  area_fraction
    0        400 GPa ... elastic ...
    1        400 GPa ... elastic ...
    """
    if not 0 < partition_seconds < float("inf"):
        raise InputError(f"partition_seconds is {partition_seconds}; it must be finite and greater than 0")
    rows = Rows(
        swept,
        Axes(over, zipped),
        _whole("repeats", repeats, 1),
        _whole("seed", seed, 0),
        vectorised,
        table,
    )
    if rows_per_partition is not None:
        _whole("rows_per_partition", rows_per_partition, 1)
        if rows_per_partition & (rows_per_partition - 1):
            raise InputError(f"rows_per_partition is {rows_per_partition}; it must be a power of two")

    def size() -> int:
        rows.begin()
        return rows_per_partition or rows.rows_within(partition_seconds, _MOST_ROWS)

    if to is not None:
        return _into_folder(Path(to), rows, size, rows_per_partition, client, progress)
    if client is not None:
        raise InputError("client is for sweeps into a folder; without to, compute the frame with the client")
    if importlib.util.find_spec("dask") is None:
        needed("pandas", "sweep")
        rows.begin()
        return frame_of(rows.columns(0, rows.count)[0])
    return _lazy(rows, size())


def _lazy(rows: Rows, size: int) -> Any:
    dask, frames = needed("dask", "sweep"), needed("dask.dataframe", "sweep")
    # In the graph once, for all partitions.
    shared = dask.delayed(rows, traverse=False)
    starts = range(0, rows.count, size)
    parts = [dask.delayed(_frame)(shared, start, min(start + size, rows.count)) for start in starts]
    return frames.from_delayed(parts, meta=frame_of(rows.columns(0, 1)[0]).head(0), verify_meta=False)


def _frame(rows: Rows, start: int, stop: int) -> Any:
    with one_thread():
        return frame_of(rows.columns(start, stop)[0])


def _into_folder(path: Path, rows: Rows, size: Any, asked_size: int | None, client: Any, progress: Progress) -> Any:
    needed("pyarrow.parquet", "to")
    key = rows.key()
    folder = Folder.begun(path, rows, key) or Folder.begin(path, rows, key, size())
    if asked_size not in (None, folder.rows_per_partition):
        raise InputError(
            f"rows_per_partition is {asked_size}, and {path} was begun with {folder.rows_per_partition}; leave it out"
        )
    left = folder.left()
    line = Line()
    observer = observer_of(progress, line)
    client = client or _client_of_this_process()
    try:
        if client is None or not left:
            written = map(folder.write, left)
        else:
            # Futures of other workers that are not done when the sweep ends are cancelled.
            shared = client.scatter(folder, broadcast=True, hash=False)
            written = client.get_executor(pure=False).map(_write, left, [shared] * len(left))
        for done, _ in enumerate(written, folder.partitions - len(left) + 1):
            if observer is not None:
                observer("partitions", done, folder.partitions)
    finally:
        line.end()
    folder.tidy()
    files, keys = folder.parts()
    if importlib.util.find_spec("dask") is not None:
        meta = _read(files[0], keys[0]).head(0)
        return needed("dask.dataframe", "sweep").from_map(_read, files, keys, meta=meta, enforce_metadata=False)
    return needed("pandas", "sweep").concat([_read(file, key) for file, key in zip(files, keys)], ignore_index=True)


def _read(file: Path, key: str, columns: list[str] | None = None) -> Any:
    """The rows of a part; Dask asks for the columns that it needs."""
    needed("pandas", "sweep")
    return read_part(file, key, columns).to_pandas()


def _client_of_this_process() -> Any:
    if "distributed" not in sys.modules:
        return None
    try:
        return sys.modules["distributed"].client.default_client()
    except ValueError:
        return None


def _write(partition: int, folder: Folder) -> int:
    with one_thread():
        return folder.write(partition)


def _whole(name: str, given: Any, least: int) -> int:
    try:
        number = given.__index__()
    except AttributeError:
        raise InputError(f"{name}: a whole number is needed, and this is of type {type(given).__name__}") from None
    if isinstance(given, bool) or number < least:
        raise InputError(f"{name} is {given}; it must be a whole number from {least} on")
    return int(number)
