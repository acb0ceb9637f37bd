"""Whatever people hand over is understood or refused by name: nothing of it is taken silently for something else."""

from __future__ import annotations

import datetime
import decimal
import fractions
from collections.abc import Callable
from typing import Any

import numpy as np
import pandas as pd
import pint
import polars as pl
import pytest
import unyt  # type: ignore[import-untyped]
import xarray as xr
from astropy import units as astropy_units  # type: ignore[import-untyped]

import truearea as ta
from support import refused_naming

UNITS: Any = pint.UnitRegistry()
UNCD = ta.read_psd("builtin:uncd-measured")
STEEL = ta.Material("210 GPa", 0.3, yield_strength="1 GPa")
X = np.linspace(0.0, 2.0 * np.pi, 16, endpoint=False)
WAVE = np.round(1e-8 * np.cos(X) * np.cos(X)[:, None], 12)
POPULATION: dict[str, Any] = {"radius": 1e-6, "density": 1e12, "sigma_s": 1e-8}


def of_persson(pressure: Any) -> ta.Result:
    return ta.persson(UNCD, STEEL, pressure=pressure)


def of_contact(pressure: Any) -> ta.Result:
    return ta.contact(POPULATION, STEEL, model="hertz", pressure=pressure)


def of_elements(pressure: Any) -> ta.Result:
    return ta.boundary_elements(WAVE, STEEL, pressure=pressure, size="1 um", periodic=True)


def of_scene(pressure: Any) -> ta.Result:
    return ta.Scene(UNCD, STEEL, pressure=pressure, curves=["persson"]).scales()


FIVE_MEGAPASCALS = {
    "float": 5e6,
    "int": 5_000_000,
    "float64": np.float64(5e6),
    "float32": np.float32(5e6),
    "int64": np.int64(5_000_000),
    "uint32": np.uint32(5_000_000),
    "0-d array": np.array(5e6),
    "decimal": decimal.Decimal("5e6"),
    "fraction": fractions.Fraction(5_000_000),
    "text": "5 MPa",
    "text without space": "5MPa",
    "text with spaces": "  5 MPa ",
    "text in Pa": "5e6 Pa",
    "text in kPa": "5000 kPa",
    "text in bar": "50 bar",
    "text in N/mm2": "5 N/mm2",
    "numpy text": np.str_("5 MPa"),
    "in hardnesses": "0.0016666666666666668 H",
    "pint": UNITS.Quantity(5, "MPa"),
    "pint in bar": UNITS.Quantity(50, "bar"),
    "unyt": unyt.unyt_quantity(5, "MPa"),
    "astropy": astropy_units.Quantity(5, "MPa"),
}
"""Spellings of one pressure."""

SEVERAL = {
    "list": [5e6, 1e7],
    "tuple": (5e6, 1e7),
    "list of text": ["5 MPa", "10 MPa"],
    "text and numbers": ["5 MPa", 1e7],
    "array": np.array([5e6, 1e7]),
    "strided array": np.array([5e6, 0.0, 1e7, 0.0])[::2],
    "other byte order": np.array([5e6, 1e7], dtype=">f8"),
    "int array": np.array([5_000_000, 10_000_000]),
    "array of text": np.array(["5 MPa", "10 MPa"]),
    "pandas": pd.Series([5e6, 1e7], index=["a", "b"]),
    "xarray": xr.DataArray([5e6, 1e7], dims="load"),
    "polars": pl.Series([5e6, 1e7]),
    "unmasked": np.ma.masked_array([5e6, 1e7], mask=False),
    "pint array": UNITS.Quantity(np.array([5.0, 10.0]), "MPa"),
    "list of pint": [UNITS.Quantity(5, "MPa"), UNITS.Quantity(10000, "kPa")],
    "unyt array": unyt.unyt_array([5, 10], "MPa"),
    "astropy array": astropy_units.Quantity([5, 10], "MPa"),
}
"""Spellings of two pressures."""

NO_PRESSURE = {
    "NaN": np.nan,
    "infinity": np.inf,
    "negative": -5e6,
    "zero": 0.0,
    "truth": True,
    "numpy truth": np.True_,
    "complex": 5e6 + 0j,
    "bytes": b"5 MPa",
    "no unit": "5",
    "mistyped unit": "5 MPA",
    "a length": "5 m",
    "no number": "five MPa",
    "empty text": "",
    "NaN in text": "nan Pa",
    "infinity in text": "inf MPa",
    "negative in text": "-5 MPa",
    "two numbers": "5 6 MPa",
    "an interval": "5 MPa +- 1 MPa",
    "date": datetime.date(2024, 1, 1),
    "datetime64": np.datetime64("2024-01-01"),
    "timedelta": datetime.timedelta(days=1),
    "object": object(),
    "function": len,
    "set": {5e6},
    "dict": {"pressure": 5e6},
    "generator": (value for value in (5e6,)),
    "list with NaN": [5e6, np.nan],
    "list with None": [5e6, None],
    "list with a bad text": [5e6, "5"],
    "array of objects": np.array([5e6, None], dtype=object),
    "pint length": UNITS.Quantity(5, "m"),
    "unyt length": unyt.unyt_quantity(5, "m"),
    "astropy length": astropy_units.Quantity(5, "m"),
    "masked": np.ma.masked_array([5e6, 1e7], mask=[False, True]),
    "pandas with a gap": pd.Series([5e6, None]),
    "pandas of dates": pd.Series(pd.to_datetime(["2024-01-01"])),
    "polars of text": pl.Series(["5"]),
}
"""Nothing of it is a nominal pressure."""


def same(one: Any, other: Any) -> None:
    np.testing.assert_allclose(
        np.asarray(one.area_fraction, dtype=float).reshape(-1), np.asarray(other.area_fraction).reshape(-1), rtol=1e-12
    )


@pytest.mark.parametrize("call", [of_persson, of_contact, of_elements, of_scene])
@pytest.mark.parametrize("given", FIVE_MEGAPASCALS.values(), ids=FIVE_MEGAPASCALS)
def test_spellings_of_a_pressure_are_one_pressure(call: Callable[[Any], Any], given: Any) -> None:
    same(call(given), call(5e6))


@pytest.mark.parametrize("call", [of_persson, of_contact, of_elements, of_scene])
@pytest.mark.parametrize("given", SEVERAL.values(), ids=SEVERAL)
def test_spellings_of_two_pressures_are_two_pressures(call: Callable[[Any], Any], given: Any) -> None:
    same(call(given), call([5e6, 1e7]))


@pytest.mark.parametrize("call", [of_persson, of_contact, of_elements, of_scene])
@pytest.mark.parametrize("given", NO_PRESSURE.values(), ids=NO_PRESSURE)
def test_what_is_no_pressure_is_refused_by_name(call: Callable[[Any], Any], given: Any) -> None:
    with refused_naming(*(() if call is of_contact else ("pressure",))):
        call(given)


HEIGHTS = {
    "list": WAVE.tolist(),
    "fortran order": np.asfortranarray(WAVE),
    "other byte order": WAVE.astype(">f8"),
    "pandas": pd.DataFrame(WAVE),
    "xarray": xr.DataArray(WAVE, dims=("y", "x")),
    "polars": pl.DataFrame(WAVE),
    "unmasked": np.ma.masked_array(WAVE, mask=False),
    "pint": UNITS.Quantity(WAVE * 1e9, "nm"),
    "unyt": unyt.unyt_array(WAVE * 1e9, "nm"),
    "astropy": astropy_units.Quantity(WAVE * 1e9, "nm"),
    "strided": np.repeat(np.repeat(WAVE, 2, axis=0), 3, axis=1)[::2, ::3],
    "read-only": np.frombuffer(WAVE.tobytes()).reshape(16, 16),
}

NO_HEIGHTS = {
    "NaN": np.where(WAVE > 9e-9, np.nan, WAVE),
    "infinity": np.where(WAVE > 9e-9, np.inf, WAVE),
    "masked": np.ma.masked_greater(WAVE, 9e-9),
    "one axis": WAVE[0],
    "four axes": WAVE[None, None],
    "complex": WAVE.astype(complex),
    "truths": WAVE > 0,
    "text": "heights",
    "array of text": WAVE.astype(str),
    "dates": np.full((4, 4), np.datetime64("2024-01-01")),
    "objects": np.full((4, 4), None),
    "ragged": [[0.0, 1.0], [0.0]],
    "empty": np.empty((0, 0)),
    "nothing": None,
    "a number": 1.0,
    "pint pressure": UNITS.Quantity(WAVE, "Pa"),
    "dict": {"heights": WAVE},
}


@pytest.mark.parametrize("given", HEIGHTS.values(), ids=HEIGHTS)
def test_spellings_of_heights_are_one_surface(given: Any) -> None:
    pressed = ta.boundary_elements(given, STEEL, pressure="10 MPa", size="1 um", periodic=True)
    expected = ta.boundary_elements(WAVE, STEEL, pressure="10 MPa", size="1 um", periodic=True)
    np.testing.assert_allclose(pressed.mean_gap_m, expected.mean_gap_m, rtol=1e-9)
    spectrum = ta.Spectrum.from_heights(given, "1 um", periodic=True)
    np.testing.assert_allclose(spectrum.c1d_m3, ta.Spectrum.from_heights(WAVE, "1 um", periodic=True).c1d_m3, rtol=1e-9)


@pytest.mark.parametrize("given", NO_HEIGHTS.values(), ids=NO_HEIGHTS)
def test_what_is_no_map_of_heights_is_refused(given: Any) -> None:
    with pytest.raises((ta.InputError, FileNotFoundError)):
        ta.boundary_elements(given, STEEL, pressure="10 MPa", size="1 um")


@pytest.mark.parametrize(
    "size", ["1 um", 1e-6, np.float32(1e-6), ("1 um", 1e-6), [1e-6, "1000 nm"], np.array([1e-6, 1e-6]), UNITS.Quantity(1, "um")], ids=repr
)
def test_spellings_of_a_size_are_one_size(size: Any) -> None:
    pressed = ta.boundary_elements(WAVE, STEEL, pressure="10 MPa", size=size)
    expected = ta.boundary_elements(WAVE, STEEL, pressure="10 MPa", size=1e-6)
    np.testing.assert_allclose(pressed.mean_gap_m, expected.mean_gap_m, rtol=1e-6)


@pytest.mark.parametrize("size", [0, -1e-6, "1", "1 Pa", np.nan, (1e-6,) * 3, {1e-6}, "", True, UNITS.Quantity(1, "Pa")], ids=repr)
def test_what_is_no_size_is_refused_by_name(size: Any) -> None:
    with refused_naming("size"):
        ta.boundary_elements(WAVE, STEEL, pressure="10 MPa", size=size)


@pytest.mark.parametrize("modulus", ["210 GPA", "210", "210 m", -1.0, 0.0, np.nan, np.inf, True, [210e9], 1j, "210 GPa 3"], ids=repr)
def test_what_is_no_modulus_is_refused_by_name(modulus: Any) -> None:
    with refused_naming("youngs_modulus"):
        ta.Material(modulus, 0.3)


@pytest.mark.parametrize("ratio", [0.51, -1.0, np.nan, "0.3", True, [0.3], None, UNITS.Quantity(0.3, "m")], ids=repr)
def test_what_is_no_poisson_ratio_is_refused_by_name(ratio: Any) -> None:
    with refused_naming("poisson_ratio"):
        ta.Material("210 GPa", ratio)


@pytest.mark.parametrize(
    ("radius", "density", "sigma_s"),
    [
        ("1 um", "1e12 1/m2", "10 nm"),
        ("1000 nm", "1 1/um2", "0.01 um"),
        (["1 um"], "1 /um^2", 1e-8),
        (UNITS.Quantity(1, "um"), UNITS.Quantity(1, "1/um**2"), UNITS.Quantity(10, "nm")),
        (np.array(["1 um"]), 1e12, np.float64(1e-8)),
    ],
    ids=repr,
)
def test_spellings_of_asperities_are_one_population(radius: Any, density: Any, sigma_s: Any) -> None:
    found = ta.contact(model="hertz", material=STEEL, radius=radius, density=density, sigma_s=sigma_s, pressure="5 MPa")
    same(found, of_contact(5e6))


@pytest.mark.parametrize(
    ("argument", "given"),
    [
        ("radius", "1"),
        ("radius", "1 Pa"),
        ("radius", ["1 um", "x"]),
        ("density", "1e12"),
        ("density", "1e12 m2"),
        ("density", "x 1/m2"),
        ("sigma_s", "-1 nm"),
        ("sigma_s", None),
        ("radius", np.datetime64("2024-01-01")),
        ("radius", [1e-6, "1 um", None]),
    ],
    ids=repr,
)
def test_what_is_no_population_is_refused(argument: str, given: Any) -> None:
    with pytest.raises(ta.InputError):
        ta.contact({**POPULATION, argument: given}, STEEL, model="hertz", pressure="5 MPa")


@pytest.mark.parametrize(
    ("q", "c1d"),
    [
        ([1e5, 1e6], [1e-22]),
        ([1e5, 0.0], [1e-22, 1e-23]),
        ([1e5, -1e6], [1e-22, 1e-23]),
        ([1e5, np.nan], [1e-22, 1e-23]),
        ([1e5, 1e6], [1e-22, 0.0]),
        ([1e5, 1e6], [1e-22, np.nan]),
        ([1e5], [1e-22]),
        ([[1e5, 1e6]], [[1e-22, 1e-23]]),
        (pd.to_datetime(["2024-01-01", "2024-01-02"]), [1e-22, 1e-23]),
        (["a", "b"], [1e-22, 1e-23]),
        ([True, False], [1e-22, 1e-23]),
        ([1e5, 1e5], [1e-22, 1e-23]),
    ],
    ids=repr,
)
def test_what_is_no_spectrum_is_refused(q: Any, c1d: Any) -> None:
    with pytest.raises(ta.InputError):
        ta.Spectrum(q, c1d)


def test_what_stands_for_a_surface_and_for_a_material_is_understood() -> None:
    expected = ta.persson(UNCD, ta.Material("100Cr6"), pressure="5 MPa")
    for surface in (UNCD, "builtin:uncd-measured"):
        assert ta.persson(surface, "100Cr6", pressure="5 MPa") == expected
    for wrong in (1.0, WAVE, None, object(), {"a": 1}):
        with refused_naming("surface"):
            ta.persson(wrong, STEEL, pressure="5 MPa")  # type: ignore[arg-type]
    for wrong in (1.0, None, object(), UNCD):
        with refused_naming("material"):
            ta.persson(UNCD, wrong, pressure="5 MPa")  # type: ignore[arg-type]
    with refused_naming("100Cr7", "100Cr6"):
        ta.persson(UNCD, "100Cr7", pressure="5 MPa")


def test_a_material_of_boundary_elements_may_be_a_name() -> None:
    assert ta.boundary_elements(WAVE, "100Cr6", pressure=1e7, size="1 um") == ta.boundary_elements(
        WAVE, ta.Material("100Cr6"), pressure=1e7, size="1 um"
    )
