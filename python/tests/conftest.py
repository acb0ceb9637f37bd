"""What tests hold results against: the committed reference tables, and the command line of the same checkout."""

from __future__ import annotations

import json
import os
import subprocess
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from support import REFERENCE, ROOT, Columns, columns_of


@pytest.fixture(scope="session")
def command_line() -> Callable[..., Columns]:
    """Runs the command line of this checkout; its tables are printed with all digits."""
    program = os.environ.get("TRUEAREA_PROGRAM")
    call = [program] if program else ["cargo", "run", "--quiet", "--bin", "truearea", "--"]

    def run(*arguments: str) -> Columns:
        done = subprocess.run([*call, *arguments], cwd=ROOT, check=True, capture_output=True, text=True)
        return columns_of(done.stdout)

    return run


@pytest.fixture(scope="session")
def reference() -> Callable[[str], Columns]:
    """A committed table of high-precision values, by name."""
    return lambda name: columns_of((REFERENCE / name).read_text(encoding="utf-8"))


@pytest.fixture(scope="session")
def of_crates() -> Callable[[str], Any]:
    """Reads a file that the crates write for these tests, by its name."""
    written = os.environ.get("TRUEAREA_QUESTIONS")
    if written is None:
        subprocess.run(["cargo", "test", "--quiet", "--workspace", "--test", "front_ends"], cwd=ROOT, check=True)
        written = str(ROOT / "target" / "tmp" / "questions.json")
    return lambda name: json.loads(Path(written).with_name(name).read_text(encoding="utf-8"))


@pytest.fixture(scope="session")
def questions(of_crates: Callable[[str], Any]) -> list[dict[str, Any]]:
    """Random questions about curves with the answers that the crates give."""
    found: list[dict[str, Any]] = of_crates("questions.json")
    return found
