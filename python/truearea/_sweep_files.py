"""A folder of Parquet files, one for each partition of a sweep: whole or not there, and computed once."""

from __future__ import annotations

import hashlib
import importlib
import json
import os
import threading
from pathlib import Path
from typing import Any

from truearea._native import InputError
from truearea._sweep_rows import Columns, Rows

_MANIFEST = "_sweep.json"


def needed(module: str, what: str) -> Any:
    """A module that comes with an extra."""
    try:
        return importlib.import_module(module)
    except ImportError as error:
        package = module.split(".")[0]
        raise ImportError(f"{what} needs {package}, which is not here: pip install truearea[cluster]") from error


class Folder:
    """The files of a sweep."""

    def __init__(self, path: Path, rows: Rows, key: str, rows_per_partition: int, kinds: dict[str, str]) -> None:
        self.path = path
        self.rows = rows
        self.key = key
        self.rows_per_partition = rows_per_partition
        self.rows.kinds = kinds
        self.partitions = -(-rows.count // rows_per_partition)

    @classmethod
    def begun(cls, path: Path, rows: Rows, key: str) -> Folder | None:
        """The folder in which this sweep was begun already; none where there is none, or it is empty.

        What another sweep has written is not touched.
        """
        manifest = path / _MANIFEST
        if path.exists() and not path.is_dir():
            raise InputError(f"to: {path} is a file; name a folder")
        if not manifest.exists():
            if path.is_dir() and any(path.glob("*.parquet")):
                raise InputError(f"to: {path} holds Parquet files of something else; name another folder")
            return None
        told = json.loads(manifest.read_text(encoding="utf-8"))
        if told["key"] != key:
            raise InputError(f"to: {path} holds another sweep: {_difference(told, rows.told())}; name another folder")
        return cls(path, rows, key, told["rows_per_partition"], told["columns"])

    @classmethod
    def begin(cls, path: Path, rows: Rows, key: str, rows_per_partition: int) -> Folder:
        """A new folder, which tells what is to be in it, so that the sweep goes on in the same partitions."""
        path.mkdir(parents=True, exist_ok=True)
        told = {
            **rows.told(),
            "key": key,
            "rows": rows.count,
            "rows_per_partition": rows_per_partition,
            "columns": rows.kinds,
        }
        aside = path / f".{_MANIFEST}.{os.getpid()}.aside"
        aside.write_text(json.dumps(told, indent=1, ensure_ascii=False), encoding="utf-8")
        aside.replace(path / _MANIFEST)
        return cls(path, rows, key, rows_per_partition, rows.kinds)

    def files(self) -> list[Path]:
        """All of them, in the order of the rows."""
        return [self._file(partition) for partition in range(self.partitions)]

    def left(self) -> list[int]:
        """The partitions that are not written yet."""
        return [partition for partition in range(self.partitions) if not self._is_written(partition)]

    def write(self, partition: int) -> int:
        """Computes a partition and writes it aside, then in its place."""
        arrow, parquet = needed("pyarrow", "to"), needed("pyarrow.parquet", "to")
        start, stop = self._range(partition)
        columns, notes = self.rows.columns(start, stop)
        told = {**self.rows.told(), "rows": [start, stop], "key": self._key(partition), "notes": list(notes)}
        text = json.dumps(told, sort_keys=True, ensure_ascii=False)
        table = arrow.table(columns).replace_schema_metadata({"truearea": text})
        file = self._file(partition)
        # Whoever was ended while writing has left its file aside; whoever writes the same right now has another.
        aside = self.path / f".{file.name}.{os.getpid()}-{threading.get_ident()}.aside"
        try:
            parquet.write_table(table, aside)
            aside.replace(file)
        finally:
            aside.unlink(missing_ok=True)
        return stop - start

    def tidy(self) -> None:
        """Removes what ended workers have left aside."""
        for aside in self.path.glob(".*.aside"):
            aside.unlink(missing_ok=True)

    def _file(self, partition: int) -> Path:
        return self.path / f"part-{partition:06}.parquet"

    def _range(self, partition: int) -> tuple[int, int]:
        start = partition * self.rows_per_partition
        return start, min(start + self.rows_per_partition, self.rows.count)

    def _key(self, partition: int) -> str:
        start, stop = self._range(partition)
        return hashlib.sha256(f"{self.key} {start} {stop}".encode()).hexdigest()

    def _is_written(self, partition: int) -> bool:
        file = self._file(partition)
        if not file.exists():
            return False
        told = needed("pyarrow.parquet", "to").read_schema(file).metadata or {}
        return bool(json.loads(told.get(b"truearea", b"{}")).get("key") == self._key(partition))


def frame_of(columns: Columns) -> Any:
    """Columns as a data frame."""
    return needed("pandas", "sweep").DataFrame(columns)


def _difference(there: dict[str, Any], here: dict[str, Any]) -> str:
    words = {
        "program": "of another version",
        "function": "of another function",
        "scene": "of another scene",
        "over": "over other values",
        "repeats": "with other repeats",
        "seed": "with another seed",
        "table": "of another table",
        "source": "of another source of the function, or other files of the scene",
    }
    differ = [name for name in words if there.get(name) != json.loads(json.dumps(here.get(name)))]
    if not differ:
        return "over other values"
    name = differ[0]
    short = name in ("program", "function", "repeats", "seed", "table")
    return f"{words[name]}, {there.get(name)} there and {here.get(name)} here" if short else words[name]
