"""Every example of the pages on Python runs, and the notebooks do."""

from __future__ import annotations

import re
from pathlib import Path

import nbformat
import pytest
from nbclient import NotebookClient

from support import ROOT

PAGES = sorted((ROOT / "docs" / "python").glob("*.md"))
NOTEBOOKS = sorted((ROOT / "python" / "notebooks").glob("*.ipynb"))
SCRIPT = ROOT / "python" / "examples" / "four_models_in_scipy.py"


def examples(page: Path) -> str:
    """The Python of a page, as one program."""
    return "\n".join(re.findall(r"```python\n(.*?)```", page.read_text(encoding="utf-8"), re.DOTALL))


@pytest.mark.parametrize("page", [*PAGES, ROOT / "README.md"], ids=lambda page: page.name)
def test_the_examples_of_a_page_run(page: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    program = examples(page)
    if page.name != "README.md" and page.stem != "index":
        assert "import truearea as ta" in program, "a page without an example"
    monkeypatch.chdir(tmp_path)
    exec(compile(program, str(page), "exec"), {"__name__": "__page__"})


def test_the_script_in_scipy_runs() -> None:
    exec(compile(SCRIPT.read_text(encoding="utf-8"), str(SCRIPT), "exec"), {"__name__": "__page__"})


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_a_notebook_runs(path: Path, tmp_path: Path) -> None:
    notebook = nbformat.read(path, as_version=4)
    assert all(cell.outputs or cell.execution_count for cell in notebook.cells if cell.cell_type == "code")
    client = NotebookClient(notebook, timeout=300, resources={"metadata": {"path": str(tmp_path)}})
    client.execute()


def test_there_are_five_notebooks_with_a_picture_on_top() -> None:
    assert len(NOTEBOOKS) == 5
    for path in NOTEBOOKS:
        cells = [cell for cell in nbformat.read(path, as_version=4).cells if cell.cell_type == "code"]
        assert any("image/png" in output.get("data", {}) for output in cells[0].outputs), path.name
