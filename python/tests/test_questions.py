"""Random questions of the crates, asked once more in Python: the same columns, notes and doubts, as data."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import truearea as ta
from truearea import _native

FUNCTIONS = {"elastic": ta.stacked, "elastic-plastic": ta.stacked, "persson": ta.persson, "persson-plastic": ta.persson}
UNITS_MISTAKEN = ta.Spectrum(np.geomspace(1e6, 1e9, 30), 1e-15 * np.geomspace(1.0, 1e3, 30) ** -2.2)


@pytest.fixture
def answers(monkeypatch: pytest.MonkeyPatch) -> list[_native.Answer]:
    """The answers of the core to the calls of a test."""
    kept: list[_native.Answer] = []

    def keeping(call: Any) -> Any:
        def kept_call(*given: Any) -> Any:
            found = call(*given)
            kept.append(found[0] if isinstance(found, tuple) else found)
            return found

        return kept_call

    for name in ("curve", "gaps", "press_flat"):
        monkeypatch.setattr(_native, name, keeping(getattr(_native, name)))
    return kept


def material_of(given: dict[str, Any]) -> ta.Material:
    body = {key.removesuffix("_pa").removesuffix("_m"): value for key, value in given.items() if value is not None}
    if "counterface" in body:
        body["counterface"] = material_of(body["counterface"])
    return ta.Material(**body)


def asked(spectrum: ta.Spectrum, question: dict[str, Any]) -> ta.Result:
    """The question as somebody asks it in Python."""
    model = question["model"]
    given = {key: value for key, value in question["options"].items() if value is not None and key != "strain_gradient"}
    given |= {"hardness_formula": given.pop("hardness")} if "hardness" in given else {}
    given |= {"strain_gradient": True} if question["options"]["strain_gradient"] else {}
    given |= {"normalisation": question["normalisation"]} if question["normalisation"] else {}
    call: Any = FUNCTIONS.get(model, ta.statistical)
    found: ta.Result = call(
        spectrum,
        material_of(question["material"]),
        model=model,
        pressure=[load["label"] for load in question["pressures"]],
        cutoff=question["sampling"]["cutoff_m"],
        scales_per_decade=question["sampling"]["scales_per_decade"],
        **given,
    )
    return found


def test_random_questions_have_the_columns_notes_and_doubts_of_the_crates(
    questions: list[dict[str, Any]], answers: list[_native.Answer]
) -> None:
    spectrum = ta.read_psd("builtin:uncd-measured")
    doubted = 0
    assert len(questions) == 200
    for question in questions:
        if "columns" not in question:
            with pytest.raises(ta.InputError):
                asked(spectrum, question["question"])
            continue
        found = asked(spectrum, question["question"])
        assert answers[-1].facts == question["facts"]
        assert found.notes == tuple(text for text, *_ in answers[-1].notes)
        doubted += any("level: Caution" in fact for fact in question["facts"])
        loads, cutoffs = found.sizes["load"], found.sizes["cutoff"]
        for name, cells in question["columns"].items():
            array = found[name][:, None] if found.axes(name) == ("load",) else found[name]
            column = np.broadcast_to(array, (loads, cutoffs)).reshape(-1)
            if column.dtype.kind == "f":
                assert np.array_equal(column, np.array(cells, dtype=np.float64), equal_nan=True), (name, question)
            else:
                assert column.tolist() == cells
    assert doubted > 20


def test_every_question_about_a_spectrum_doubts_its_units(answers: list[_native.Answer]) -> None:
    diamond = ta.Material("463 GPa", 0.2, yield_strength="1.8 GPa")
    ta.stacked(UNITS_MISTAKEN, diamond, pressure="1 MPa")
    ta.statistical(UNITS_MISTAKEN, diamond, pressure="1 MPa", model="hertz")
    ta.persson(UNITS_MISTAKEN, diamond, pressure="1 MPa")
    ta.gap(UNITS_MISTAKEN, diamond, pressure="1 MPa")
    ta.boundary_elements(UNITS_MISTAKEN, pressure="1 GPa", material=diamond, grid=32, realisations=1, shortest="1 um")
    answers += [
        ta.law(UNITS_MISTAKEN, diamond, pressure=("1 kPa", "1 MPa"))._native.answer(),
        UNITS_MISTAKEN._native.quantity("moments", {}),
    ]
    assert len(answers) == 7
    for answer in answers:
        assert any("SteepSurface" in fact for fact in answer.facts), answer.notes
