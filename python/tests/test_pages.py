"""Every example of the pages on Python and every notebook runs, and prints what is shown there."""

from __future__ import annotations

import contextlib
import io
import re
from pathlib import Path
from typing import Any

import nbformat
import pytest
from nbclient import NotebookClient

from support import ROOT

PAGES = sorted((ROOT / "docs" / "python").glob("*.md"))
NOTEBOOKS = sorted((ROOT / "python" / "notebooks").glob("*.ipynb"))
SCRIPT = ROOT / "python" / "examples" / "four_models_in_scipy.py"


NUMBER = re.compile(r"[-+]?(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?", re.IGNORECASE)


def assert_is_what_was_printed(shown: str, printed: str) -> None:
    """Asserts that a text has the words of another and, but for rounding, its numbers."""
    words = [" ".join(NUMBER.sub(" # ", text).split()) for text in (shown, printed)]
    assert words[0] == words[1], printed
    numbers = [[float(number) for number in NUMBER.findall(text)] for text in (shown, printed)]
    assert numbers[0] == pytest.approx(numbers[1], rel=1e-6, abs=0.0), printed


def blocks(page: Path) -> list[tuple[str, str]]:
    """The blocks of a page with their languages."""
    return re.findall(r"```(\w+)\n(.*?)```", page.read_text(encoding="utf-8"), re.DOTALL)


@pytest.mark.parametrize("page", [*PAGES, ROOT / "README.md"], ids=lambda page: page.name)
def test_the_examples_of_a_page_run_and_print_what_it_shows(page: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    known: dict[str, Any] = {"__name__": "__page__"}
    before, printed = "", io.StringIO()
    for language, text in blocks(page):
        if language == "python":
            printed = io.StringIO()
            with contextlib.redirect_stdout(printed):
                exec(compile(text, str(page), "exec"), known)
        elif language == "text" and page in PAGES:
            assert before == "python", "a result follows the code that prints it"
            assert_is_what_was_printed(text, printed.getvalue())
        before = language
    assert page not in PAGES or "ta" in known, "a page without an example"


def test_a_number_of_a_page_that_is_old_is_found() -> None:
    assert_is_what_was_printed("[1.5e-8  2.0]  at 3 MPa", "[1.50000001e-08 2.]\nat 3 MPa")
    for old in ("[1.5e-8 2.1] at 3 MPa", "[1.6e-8 2.0] at 3 MPa", "[1.5e-8 2.0] at 3 kPa", "[1.5e-8 2.0] at 3 MPa 4"):
        with pytest.raises(AssertionError):
            assert_is_what_was_printed(old, "[1.5e-8 2.0] at 3 MPa")


def test_the_script_in_scipy_runs() -> None:
    exec(compile(SCRIPT.read_text(encoding="utf-8"), str(SCRIPT), "exec"), {"__name__": "__page__"})


def texts(cell: nbformat.NotebookNode) -> str:
    """What a cell prints and returns as text; pictures and warnings are none."""
    streams = [output.text for output in cell.outputs if output.get("name") == "stdout"]
    values = [output.get("data", {}).get("text/plain", "") for output in cell.outputs]
    return "\n".join([*streams, *(value for value in values if "<Figure" not in value)])


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_a_notebook_runs_and_prints_what_is_stored(path: Path, tmp_path: Path) -> None:
    notebook = nbformat.read(path, as_version=4)
    cells = [cell for cell in notebook.cells if cell.cell_type == "code"]
    assert all(cell.outputs or cell.execution_count for cell in cells)
    stored = [texts(cell) for cell in cells]
    NotebookClient(notebook, timeout=300, resources={"metadata": {"path": str(tmp_path)}}).execute()
    for shown, cell in zip(stored, cells):
        assert_is_what_was_printed(shown, texts(cell))


def test_there_are_five_notebooks_with_a_picture_on_top() -> None:
    assert len(NOTEBOOKS) == 5
    for path in NOTEBOOKS:
        cells = [cell for cell in nbformat.read(path, as_version=4).cells if cell.cell_type == "code"]
        assert any("image/png" in output.get("data", {}) for output in cells[0].outputs), path.name
