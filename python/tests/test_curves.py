"""Contact against cutoff: the digits of the command line, axes, and what is refused."""

from __future__ import annotations

import csv
import pickle
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import truearea as ta
from support import REFERENCE, Columns, numbers, refused_naming, words
from truearea._choices import StackedModel, StatisticalModel

UNCD = "builtin:uncd-measured"
DIAMOND = ta.Material(
    "463 GPa", 0.2, yield_strength="1.8 GPa", strain_gradient_length="5 um", counterface=ta.Material("210 GPa", 0.3)
)
OPTIONS = ["--youngs-modulus", "463 GPa", "--poisson-ratio", "0.2", "--yield-strength", "1.8 GPa"]
OPTIONS += ["--counterface-youngs-modulus", "210 GPa", "--counterface-poisson-ratio", "0.3"]
LOADS = ["1e-4 H", "2 MPa", "1e-2 H"]


def flat(curve: ta.Result, name: str) -> Any:
    """An array with its axis of loads, load after load as the command line has it."""
    loads, cutoffs = curve.sizes["load"], curve.sizes["cutoff"]
    array = curve[name]
    return np.broadcast_to(array[:, None] if curve.axes(name) == ("load",) else array, (loads, cutoffs)).reshape(-1)


def same(curve: ta.Result, crates: Columns) -> None:
    for name in crates:
        if name == "regime":
            assert flat(curve, name).tolist() == words(crates, name)
        else:
            assert np.array_equal(flat(curve, name), numbers(crates, name), equal_nan=True), name


@pytest.mark.parametrize("grows", [False, True])
@pytest.mark.parametrize("model", ["elastic", "elastic-plastic"])
def test_stacks_are_those_of_the_command_line_bit_for_bit(model: StackedModel, grows: bool, command_line: Callable[..., Columns]) -> None:
    if grows and model == "elastic":
        with refused_naming("strain_gradient", "elastic"):
            ta.stacked(ta.read_psd(UNCD), DIAMOND, pressure=LOADS, model=model, strain_gradient=True)
        return
    curve = ta.stacked(ta.read_psd(UNCD), DIAMOND, pressure=LOADS, model=model, strain_gradient=grows)
    gradient = ["--strain-gradient-length", "5 um"] if grows else []
    loads = [word for load in LOADS for word in ("--pressure", load)]
    same(curve, command_line("stacked", UNCD, "--model", model, *OPTIONS, *gradient, *loads, "--details"))


@pytest.mark.parametrize("model", ["hertz", "ep-sphere", "elastic-sine", "ep-sine", "bgt"])
def test_statistical_curves_are_those_of_the_command_line_bit_for_bit(
    model: StatisticalModel, command_line: Callable[..., Columns]
) -> None:
    call = ["statistical", UNCD, "--model", model, *OPTIONS, "--pressure", "1e-3 H", "--pressure", "2 MPa"]
    crates = command_line(*call, "--separation", "10 nm", "--details")
    curve = ta.statistical(ta.read_psd(UNCD), DIAMOND, model=model, pressure=["1e-3 H", "2 MPa"], separation="10 nm")
    same(curve, crates)
    assert np.array_equal(curve.nominal_pressure_pa, [1e-3 * 5.4e9, 2e6, np.nan], equal_nan=True)


def test_stacks_follow_the_reference(reference: Callable[[str], Columns]) -> None:
    exact = reference("stacked_metal.csv")
    names = ("youngs_modulus_pa", "poisson_ratio", "yield_strength_pa", "strain_gradient_length_m", "nominal_pressure_pa")
    cases = np.unique(np.stack([numbers(exact, name) for name in names], axis=1), axis=0)
    for modulus_pa, ratio, strength_pa, length_m, pressure_pa in cases:
        grows = not np.isnan(length_m)
        metal = ta.Material(
            modulus_pa, ratio, yield_strength=strength_pa, strain_gradient_length=length_m if grows else None
        )
        is_case = np.isnan(numbers(exact, "strain_gradient_length_m")) != grows
        is_case &= numbers(exact, "nominal_pressure_pa") == pressure_pa
        curve = ta.stacked(ta.read_psd(UNCD), metal, pressure=pressure_pa, strain_gradient=grows)
        assert np.max(np.abs(curve.area_fraction[0] / numbers(exact, "area_fraction")[is_case] - 1.0)) < 1e-12


@pytest.mark.parametrize(
    ("changes", "told"),
    [
        ({"pressure": []}, "pressure: empty"),
        ({"pressure": [1e6, 0.0]}, "pressure[1] 0;"),
        ({"pressure": "1 m"}, "pressure: '1 m' 'm'"),
        ({"pressure": None}, "pressure"),
        ({"pressure": [True]}, "pressure[0]:"),
        ({"model": "hertz"}, "model: 'hertz' elastic"),
        ({"cutoff": "1 m"}, "scale"),
        ({"cutoff": 1e-12}, "cutoff nothing"),
        ({"amplitude": "eq6"}, "amplitude: 'eq6' eq5"),
        ({"scales_per_decade": 0}, "scales_per_decade 0; 1"),
        ({"material": ta.Material(1e11, 0.3)}, "material yield_strength indentation_hardness"),
    ],
)
def test_what_cannot_be_used_is_refused(changes: dict[str, Any], told: str) -> None:
    given: dict[str, Any] = {"material": DIAMOND, "pressure": 1e6, **changes}
    with refused_naming(*told.split()):
        ta.stacked(ta.read_psd(UNCD), **given)


def test_a_statistical_curve_needs_a_pressure_or_a_separation() -> None:
    with refused_naming("pressure", "separation"):
        ta.statistical(ta.read_psd(UNCD), DIAMOND, model="hertz")


def test_a_cap_of_a_strength_that_does_not_grow_changes_nothing() -> None:
    capped = DIAMOND.replace(strength_cap="2 GPa")
    for model in ("elastic", "elastic-plastic"):
        of_both = [ta.stacked(ta.read_psd(UNCD), one, pressure="2 MPa", model=model) for one in (DIAMOND, capped)]
        assert of_both[0] == of_both[1] and of_both[0].notes == of_both[1].notes


def test_curves_are_frames_datasets_and_pickles() -> None:
    curve = ta.stacked(ta.read_psd(UNCD), DIAMOND, pressure=LOADS)
    assert curve.area_fraction.shape == (3, curve.wavelength_m.size)
    frame = curve.to_pandas()
    assert frame.shape[0] == curve.area_fraction.size
    assert frame["area_fraction"].tolist() == curve.area_fraction.reshape(-1).tolist()
    data = curve.to_xarray()
    assert data["area_fraction"].dims == ("load", "cutoff") and "wavelength_m" in data.coords
    assert pickle.loads(pickle.dumps(curve)) == curve
    assert any("per decade" in note for note in curve.notes)


def test_a_logarithm_has_no_unit() -> None:
    spheres = ta.statistical(ta.read_psd(UNCD), DIAMOND, model="hertz", pressure=1e6)
    units = spheres.to_xarray()
    assert (units["ln_pressure_pa"].attrs["units"], units["pressure_pa"].attrs["units"]) == ("", "Pa")


def test_curves_are_written_as_tables(tmp_path: Path) -> None:
    curve = ta.persson(ta.read_psd("builtin:uncd-measured"), ta.Material("463 GPa", 0.2), pressure=["1 MPa", "2 MPa"])
    curve.write(tmp_path / "curve.csv")
    with open(tmp_path / "curve.csv", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    assert list(rows[0]) == list(curve.to_pandas().columns) and len(rows) == 2 * len(curve.wavelength_m)
    assert [float(row["area_fraction"]) for row in rows] == curve.area_fraction.reshape(-1).tolist()
    assert [row["stiffness_pa_per_m"] == "" for row in rows] == np.isnan(curve.stiffness_pa_per_m.reshape(-1)).tolist()
