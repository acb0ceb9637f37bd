"""Laws for finite elements: their rows, their texts, and what is refused."""

from __future__ import annotations

import pickle
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import truearea as ta
from support import Columns, columns_of, numbers, refused_naming
from truearea._choices import Dialect
from truearea._choices import LawModel

UNCD = "builtin:uncd-reconstructed"
DIAMOND = ta.Material("463 GPa", 0.2)
OPTIONS = ["--youngs-modulus", "463GPa", "--poisson-ratio", "0.2", "--pressure-range", "10kPa:10MPa"]
RANGE = ("10 kPa", "10 MPa")


@pytest.fixture(scope="module")
def law() -> ta.ContactLaw:
    return ta.law(ta.read_psd(UNCD), DIAMOND, pressure=RANGE)


@pytest.mark.parametrize("model", ["persson", "hertz"])
def test_rows_are_those_of_the_command_line_bit_for_bit(model: LawModel, command_line: Callable[..., Columns]) -> None:
    crates = command_line("law", UNCD, "--model", model, "--dialect", "csv", *OPTIONS)
    law = ta.law(ta.read_psd(UNCD), DIAMOND, pressure=RANGE, model=model)
    found = (law.pressure_pa, law.overclosure_m, law.mean_gap_m, law.area_fraction)
    for array, name in zip(found, ("pressure_Pa", "overclosure_m", "mean_gap_m", "area_fraction")):
        assert np.array_equal(array, numbers(crates, name)), name


def test_the_law_is_that_of_the_gap_and_keeps_its_tolerance(law: ta.ContactLaw) -> None:
    uncd = ta.read_psd(UNCD)
    assert law.pressure_pa[0] == 0.0 and law.overclosure_m[0] == 0.0 and law.pressure_pa[-1] == 1e7
    assert np.isclose(law.cut_pressure_pa, 1e4 / np.e, rtol=1e-15)
    gaps = ta.gap(uncd, DIAMOND, pressure=law.pressure_pa[1:])
    assert np.array_equal(gaps.mean_gap_m, law.mean_gap_m[1:])
    assert np.array_equal(gaps.area_fraction, law.area_fraction[1:])
    assert np.all(np.diff(law.overclosure_m) > 0.0) and np.all(np.diff(law.pressure_pa) > 0.0)
    between = np.geomspace(1e4, 1e7, 200)
    overclosure_m = law.mean_gap_m[0] - ta.gap(uncd, DIAMOND, pressure=between).mean_gap_m
    straight = np.interp(overclosure_m, law.overclosure_m, law.pressure_pa)
    assert 1e-4 < np.max(np.abs(straight / between - 1.0)) <= 0.01
    assert 0.0 < law.interpolation_error <= 0.01
    finer = ta.law(uncd, DIAMOND, pressure=RANGE, tolerance=1e-3)
    assert len(finer.pressure_pa) > 2 * len(law.pressure_pa)


def data_lines(text: str) -> list[list[float]]:
    return [[float(cell) for cell in line.split(",")] for line in text.splitlines() if not line.startswith("*")]


@pytest.mark.parametrize("dialect", ["abaqus", "calculix"])
def test_texts_of_codes_hold_the_rows(law: ta.ContactLaw, dialect: Dialect) -> None:
    text = law.to_text(dialect, units="N-mm", name="GASKET-1")
    assert "*SURFACE INTERACTION, NAME=GASKET-1\n*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=TABULAR\n" in text
    rows = np.array(data_lines(text))
    assert np.allclose(rows[:, 0], law.pressure_pa / 1e6, rtol=1e-12) and rows.shape[1] == 2
    assert np.allclose(rows[:, 1], law.overclosure_m * 1e3, rtol=1e-12)
    assert "** spectrum: builtin:uncd-reconstructed" in text and "truearea.law, model persson" in text
    assert "E = 463000000000 Pa" in text


def test_the_plain_table_has_all_digits(law: ta.ContactLaw) -> None:
    table = columns_of(law.to_text("csv"))
    assert np.array_equal(numbers(table, "pressure_Pa"), law.pressure_pa)
    assert np.array_equal(numbers(table, "mean_gap_m"), law.mean_gap_m)


def test_light_loads_are_two_numbers_of_calculix(law: ta.ContactLaw) -> None:
    text = law.to_text("calculix", form="exponential")
    [[clearance_m, pressure_pa]] = data_lines(text)
    light = ta.gap(ta.read_psd(UNCD), DIAMOND, pressure="1 MPa")
    assert np.isclose(clearance_m, np.log(100.0) * light.u0_m[0], rtol=1e-11)
    assert np.isclose(pressure_pa, light.p00_pa[0], rtol=1e-11)
    with refused_naming("exponential", "calculix"):
        law.to_text("abaqus", form="exponential")
    hertz = ta.law(ta.read_psd(UNCD), DIAMOND, pressure=RANGE, model="hertz")
    with refused_naming("form", "exponential", "model", "hertz", "table"):
        hertz.to_text("calculix", form="exponential")


def test_a_law_is_pickled_with_its_texts_and_framed(law: ta.ContactLaw) -> None:
    again = pickle.loads(pickle.dumps(law))
    assert again == law and again.notes == law.notes
    assert again.to_text("abaqus") == law.to_text("abaqus")
    frame = law.to_pandas()
    assert list(frame) == ["pressure_pa", "overclosure_m", "mean_gap_m", "area_fraction"]
    assert "ContactLaw (point: " in repr(law)


def test_a_file_is_written_whole_or_not_at_all(law: ta.ContactLaw, tmp_path: Path) -> None:
    target = tmp_path / "rough.inp"
    target.write_text("what was there")
    with refused_naming("dialect"):
        law.write(target, "ansys")  # type: ignore[arg-type]  # pyright: ignore[reportArgumentType]
    assert target.read_text() == "what was there"
    law.write(target, "abaqus", units="N-mm")
    assert target.read_text(encoding="utf-8") == law.to_text("abaqus", units="N-mm")
    link = tmp_path / "link.inp"
    link.symlink_to(target)
    law.write(str(link), "csv")
    assert link.is_symlink() and target.read_text(encoding="utf-8") == law.to_text("csv")
    with pytest.raises(FileNotFoundError):
        law.write(tmp_path / "nowhere" / "rough.inp", "csv")
    assert sorted(path.name for path in tmp_path.iterdir()) == ["link.inp", "rough.inp"]


@pytest.mark.parametrize(
    ("changes", "told"),
    [
        ({"pressure": None}, "pressure two"),
        ({"pressure": "1 MPa"}, "pressure: 1"),
        ({"pressure": [1e4, 1e5, 1e6]}, "pressure: 3"),
        ({"pressure": ("10 MPa", "10 kPa")}, "pressure smaller"),
        ({"pressure": (1e4, float("inf"))}, "pressure[1] inf;"),
        ({"tolerance": 0.9}, "tolerance 0.9;"),
        ({"model": "bem"}, "model: 'bem' persson bgt"),
        ({"model": "hertz", "gamma": 0.4}, "gamma hertz"),
    ],
)
def test_wrong_input_is_told_by_its_argument(changes: dict[str, Any], told: str) -> None:
    given: dict[str, Any] = {"pressure": RANGE} | changes
    with refused_naming(*told.split()):
        ta.law(ta.read_psd(UNCD), DIAMOND, **given)


@pytest.mark.parametrize(
    ("changes", "told"),
    [
        ({"dialect": "ansys"}, "dialect: ansys abaqus calculix csv"),
        ({"units": "mm"}, "units: mm SI N-mm"),
        ({"name": "two words"}, "name: 80"),
        ({"name": ""}, "name:"),
        ({"form": "cubic"}, "form: 'cubic' table"),
    ],
)
def test_wrong_words_are_refused(law: ta.ContactLaw, changes: dict[str, str], told: str) -> None:
    given: dict[str, Any] = {"dialect": "abaqus"} | changes
    with refused_naming(*told.split()):
        law.to_text(given.pop("dialect"), **given)


def test_rows_nearer_than_a_code_tells_apart_are_refused() -> None:
    fine = ta.law(ta.read_psd(UNCD), DIAMOND, pressure=RANGE, tolerance=1e-5)
    with refused_naming("calculix", "rows"):
        fine.to_text("calculix")


def test_what_is_no_spectrum_or_material_is_told() -> None:
    other: Any = 1.0
    with refused_naming("surface:", "Spectrum", "float"):
        ta.law(other, DIAMOND, pressure=RANGE)
    with refused_naming("material:", "Material", "float"):
        ta.law(ta.read_psd(UNCD), other, pressure=RANGE)


CONDUCTORS: dict[str, Any] = {"thermal_conductivity": "20 W/(m K)", "counterface_thermal_conductivity": 60.0}
RESISTORS: dict[str, Any] = {"resistivity": 2e-8, "counterface_resistivity": "6e-8 ohm m"}
AIR: dict[str, Any] = {"gas_conductivity": 0.026, "gas_parameter": "0.4 um"}
FLAGS = {
    "heat": ["--thermal-conductivity", "20 W/(m K)", "--counterface-thermal-conductivity", "60 W/(m K)"],
    "current": ["--resistivity", "2e-8 ohm m", "--counterface-resistivity", "6e-8 ohm m"],
    "gas": ["--gas-conductivity", "0.026 W/(m K)", "--gas-parameter", "0.4um"],
}


def test_conductances_are_those_of_the_command_line_bit_for_bit(command_line: Callable[..., Columns]) -> None:
    uncd = ta.read_psd(UNCD)
    call = ["law", UNCD, "--model", "persson", "--dialect", "csv", *OPTIONS]
    crates = command_line(*call, "--quantity", "heat", *FLAGS["heat"], *FLAGS["gas"])
    heat = ta.law(uncd, DIAMOND, pressure=RANGE, quantity="heat", **CONDUCTORS, **AIR)
    for array, name in [
        (heat.pressure_pa, "pressure_Pa"),
        (heat.conductance_w_per_m2_k, "conductance_W_per_m2_K"),
        (heat.contact_w_per_m2_k, "contact_W_per_m2_K"),
        (heat.gas_w_per_m2_k, "gas_W_per_m2_K"),
    ]:
        assert np.array_equal(array, numbers(crates, name)), name
    assert heat.contact_w_per_m2_k[0] == 0.0 and heat.gas_w_per_m2_k[0] > 0.0 and heat.interpolation_error <= 0.01
    crates = command_line(*call, "--quantity", "current", *FLAGS["current"])
    current = ta.law(uncd, DIAMOND, pressure=RANGE, quantity="current", **RESISTORS)
    assert np.array_equal(current.conductance_s_per_m2, numbers(crates, "conductance_S_per_m2"))


def test_cards_of_conductances_are_written_and_pickled(tmp_path: Path) -> None:
    heat = ta.law(UNCD, DIAMOND, pressure=RANGE, quantity="heat", **CONDUCTORS)
    text = heat.to_text("calculix", units="N-mm")
    rows = np.array(data_lines(text))
    assert "*GAP CONDUCTANCE\n0., 0.\n" in text and np.allclose(rows[:, 1], heat.pressure_pa / 1e6, rtol=1e-12)
    assert np.allclose(rows[:, 0], heat.conductance_w_per_m2_k / 1e3, rtol=1e-12)
    again = pickle.loads(pickle.dumps(heat))
    assert again == heat and again.to_text("abaqus") == heat.to_text("abaqus")
    heat.write(tmp_path / "heat.inp", "abaqus")
    assert (tmp_path / "heat.inp").read_text(encoding="utf-8") == heat.to_text("abaqus")
    current = ta.law(UNCD, DIAMOND, pressure=RANGE, quantity="current", **RESISTORS)
    assert "*GAP ELECTRICAL CONDUCTANCE, PRESSURE" in current.to_text("abaqus")


def test_named_bodies_have_their_conductivities_from_the_table() -> None:
    copper = ta.Material("hard copper", counterface=ta.Material("annealed copper"))
    heat = ta.law(UNCD, copper, pressure=RANGE, quantity="heat")
    same = ta.law(
        UNCD,
        copper,
        pressure=RANGE,
        quantity="heat",
        thermal_conductivity=401.0,
        counterface_thermal_conductivity="401 W/(m K)",
    )
    assert np.array_equal(heat.conductance_w_per_m2_k, same.conductance_w_per_m2_k)
    flowed = ta.law(UNCD, copper, pressure=RANGE, quantity="heat", model="yovanovich")
    assert np.all(flowed.conductance_w_per_m2_k[1:] > heat.conductance_w_per_m2_k[1])


@pytest.mark.parametrize(
    ("given", "told"),
    [
        ({"quantity": "heat"}, ["thermal_conductivity", "needed"]),
        ({"quantity": "charge"}, ["quantity", "charge"]),
        ({"thermal_conductivity": 20.0}, ["thermal_conductivity", "quantity"]),
        ({"quantity": "current", **RESISTORS, **AIR}, ["gas_conductivity", "current"]),
        ({"quantity": "heat", **CONDUCTORS, "gas_parameter": 1e-6}, ["gas_conductivity", "needed"]),
        ({"quantity": "heat", **CONDUCTORS, **AIR, "gas": "air"}, ["gas_conductivity", "gas"]),
        ({"quantity": "heat", **CONDUCTORS, "model": "yovanovich"}, ["hardness", "needed"]),
        ({"quantity": "heat", "thermal_conductivity": -1.0}, ["thermal_conductivity", "-1"]),
        ({"model": "yovanovich"}, ["yovanovich", "heat"]),
    ],
)
def test_conductances_refuse_what_is_missing_or_without_bearing(given: dict[str, Any], told: list[str]) -> None:
    with refused_naming(*told):
        ta.law(UNCD, DIAMOND, pressure=RANGE, **given)
