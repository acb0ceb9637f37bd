"""The checkout, its tables as columns, and calls that are refused."""

from __future__ import annotations

import csv
import io
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Union

import numpy as np
import numpy.typing as npt
import pytest

import truearea as ta

ROOT = Path(__file__).resolve().parents[2]
REFERENCE = ROOT / "tests" / "reference"

Floats = npt.NDArray[np.float64]
Columns = dict[str, Union[Floats, list[str]]]


def columns_of(text: str) -> Columns:
    """The columns of a table, numbers as doubles, NaN where a cell is empty."""
    lines = [line for line in text.splitlines() if not line.startswith("#")]
    rows = list(csv.DictReader(io.StringIO("\n".join(lines))))
    columns: Columns = {}
    for name in rows[0]:
        cells = [row[name] for row in rows]
        try:
            columns[name] = np.array([float(cell) if cell else np.nan for cell in cells])
        except ValueError:
            columns[name] = cells
    return columns


def numbers(columns: Columns, name: str) -> Floats:
    """A column of numbers."""
    column = columns[name]
    assert isinstance(column, np.ndarray)
    return column


def words(columns: Columns, name: str) -> list[str]:
    """A column of text."""
    column = columns[name]
    assert isinstance(column, list)
    return column


@contextmanager
def refused_naming(*words: str, by: type[Exception] = ta.InputError) -> Iterator[None]:
    """Asserts that calls within are refused, and that the message names these arguments, values and types."""
    with pytest.raises(by) as caught:
        yield
    for word in words:
        assert word in str(caught.value)
