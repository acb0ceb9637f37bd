"""A folder of Parquet files, one for each partition of a sweep: whole or not there, and computed once."""

from __future__ import annotations

import importlib
import json
import os
import threading
import time
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path
from typing import Any, BinaryIO

from truearea._native import InputError
from truearea._sweep_digest import sha256
from truearea._sweep_rows import Columns, Rows

_MANIFEST = "_sweep.json"
# Nobody takes so long to write a file that was begun.
_ABANDONED_SECONDS = 600.0


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
        # Looked for first: a sweep that begins right now writes its manifest before its parts.
        has_parts = path.is_dir() and any(path.glob("*.parquet"))
        told: dict[str, Any] = {}
        try:
            told = json.loads(manifest.read_text(encoding="utf-8"))
            checksum = told.pop("checksum")
            is_whole = checksum == _checksum(told)
        except FileNotFoundError:
            if has_parts:
                raise InputError(f"to: {path} holds Parquet files of something else; name another folder") from None
            return None
        except (ValueError, KeyError, AttributeError, TypeError):
            is_whole = False
        if not is_whole:
            raise InputError(f"to: {manifest} is damaged, or of an earlier version; delete {path}, or name another folder")
        if told["key"] != key:
            raise InputError(f"to: {path} holds another sweep: {_difference(told, rows.told())}; name another folder")
        return cls(path, rows, key, told["rows_per_partition"], told["columns"])

    @classmethod
    def begin(cls, path: Path, rows: Rows, key: str, rows_per_partition: int) -> Folder:
        """A new folder, which tells what is to be in it, so that the sweep goes on in the same partitions.

        Of several processes that begin at once, the first decides on the partitions.
        """
        path.mkdir(parents=True, exist_ok=True)
        told = {
            **rows.told(),
            "key": key,
            "rows": rows.count,
            "rows_per_partition": rows_per_partition,
            "columns": rows.kinds,
        }
        text = json.dumps({**told, "checksum": _checksum(told)}, indent=1, ensure_ascii=False)
        aside = path / f".{_MANIFEST}.{os.getpid()}-{threading.get_ident()}.aside"
        with suppress(FileExistsError):
            try:
                _write_whole(aside, lambda file: file.write(text.encode()))
                # Unlike a rename, a link never replaces.
                os.link(aside, path / _MANIFEST)
            except FileExistsError:
                raise
            except OSError:
                # A file system without links.
                with open(path / _MANIFEST, "x", encoding="utf-8") as file:
                    file.write(text)
            finally:
                aside.unlink(missing_ok=True)
        begun = cls.begun(path, rows, key)
        assert begun is not None
        return begun

    def parts(self) -> tuple[list[Path], list[str]]:
        """All files, in the order of the rows, and the key of each."""
        partitions = range(self.partitions)
        return [self._file(partition) for partition in partitions], [self._key(partition) for partition in partitions]

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
        if file.is_dir():
            raise InputError(f"to: {file} is a folder where a file of the sweep belongs; remove it")
        # Whoever was ended while writing has left its file aside; whoever writes the same right now has another.
        aside = self.path / f".{file.name}.{os.getpid()}-{threading.get_ident()}.aside"
        try:
            _write_whole(aside, lambda file: parquet.write_table(table, file, write_page_checksum=True))
            aside.replace(file)
        finally:
            aside.unlink(missing_ok=True)
        return stop - start

    def tidy(self) -> None:
        """Removes what ended workers have left aside; whoever writes now is left alone."""
        for aside in self.path.glob(".*.aside"):
            with suppress(FileNotFoundError):
                if time.time() - aside.stat().st_mtime > _ABANDONED_SECONDS:
                    aside.unlink()

    def _file(self, partition: int) -> Path:
        return self.path / f"part-{partition:06}.parquet"

    def _range(self, partition: int) -> tuple[int, int]:
        start = partition * self.rows_per_partition
        return start, min(start + self.rows_per_partition, self.rows.count)

    def _key(self, partition: int) -> str:
        start, stop = self._range(partition)
        return sha256(f"{self.key} {start} {stop}".encode()).hexdigest()

    def _is_written(self, partition: int) -> bool:
        """Whether a part is there, this sweep's and readable throughout."""
        try:
            read_part(self._file(partition), self._key(partition))
        except (OSError, InputError):
            return False
        return True


def read_part(file: Path, key: str, columns: list[str] | None = None) -> Any:
    """The table of a part; its key and the checksums of its pages are checked."""
    arrow, parquet = needed("pyarrow", "to"), needed("pyarrow.parquet", "to")
    try:
        table = parquet.read_table(file, columns=columns, partitioning=None, page_checksum_verification=True)
        table.validate(full=True)
        told = json.loads(table.schema.metadata[b"truearea"])
        is_known = told["key"] == key
    except FileNotFoundError:
        raise
    except (OSError, ValueError, KeyError, TypeError, arrow.ArrowException) as error:
        raise InputError(f"to: {file} is damaged ({error}); sweep into its folder again") from error
    if not is_known:
        raise InputError(f"to: {file} is a part of another sweep; sweep into its folder again")
    return table


def frame_of(columns: Columns) -> Any:
    """Columns as a data frame."""
    return needed("pandas", "sweep").DataFrame(columns)


def _write_whole(path: Path, write: Callable[[BinaryIO], Any]) -> None:
    """Writes a file down to the disk."""
    with open(path, "wb") as file:
        write(file)
        file.flush()
        os.fsync(file.fileno())


def _checksum(told: dict[str, Any]) -> str:
    return sha256(json.dumps(told, sort_keys=True).encode()).hexdigest()


def _difference(there: dict[str, Any], here: dict[str, Any]) -> str:
    words = {
        "program": "of another version",
        "python": "by another version of Python",
        "function": "of another function",
        "scene": "of another scene",
        "over": "over other values",
        "repeats": "with other repeats",
        "seed": "with another seed",
        "table": "of another table",
        "source": "of another source or state of the function, or other files of the scene",
    }
    differ = [name for name in words if there.get(name) != json.loads(json.dumps(here.get(name)))]
    if not differ:
        return "over other values"
    name = differ[0]
    short = name in ("program", "python", "function", "repeats", "seed", "table")
    return f"{words[name]}, {there.get(name)} there and {here.get(name)} here" if short else words[name]
