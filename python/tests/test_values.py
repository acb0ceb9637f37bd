"""Numbers as other libraries hand them over: quantities with units, arrays that are asked for, flags, and what is refused."""

from __future__ import annotations

import io
import json
import os
import pickle
import subprocess
import sys
import warnings
import zipfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import pint
import pytest
import unyt  # type: ignore[import-untyped]
import xarray as xr
from astropy import units as astropy_units  # type: ignore[import-untyped]

import truearea as ta
from support import refused_naming
from truearea._choices import StatisticalModel

PINT: Any = pint.UnitRegistry()
OF_UNIT: dict[str, Callable[[Any, str], Any]] = {
    "pint": lambda number, unit: PINT.Quantity(number, unit),
    "unyt": lambda number, unit: unyt.unyt_array(number, unit),
    "astropy": lambda number, unit: astropy_units.Quantity(number, unit),
}
STEEL = ta.Material("210 GPa", 0.3, yield_strength="1 GPa")
POPULATION: dict[str, Any] = {"radius": 1e-6, "density": 1e12, "sigma_s": 1e-8}
UNCD = ta.read_psd("builtin:uncd-measured")
WAVE = 1e-8 * np.cos(np.linspace(0, 2 * np.pi, 16, endpoint=False)) * np.ones((16, 1))


@pytest.mark.parametrize("library", OF_UNIT)
def test_quantities_are_converted_by_their_unit(library: str) -> None:
    of = OF_UNIT[library]
    assert ta.Material(of(210, "GPa"), 0.3, yield_strength=of(1000, "MPa")) == STEEL
    expected = ta.contact(model="hertz", material=STEEL, pressure=[5e6, 6e6], **POPULATION)
    found = ta.contact(
        model="hertz", material=STEEL, pressure=of([5, 6], "MPa"), radius=of(1, "um"), density=of(1, "1/um**2"), sigma_s=of(10, "nm")
    )
    np.testing.assert_allclose(found.area_fraction, expected.area_fraction, rtol=1e-12)
    listed = ta.contact(model="hertz", material=STEEL, pressure=[of(5, "MPa"), of(6000, "kPa")], **POPULATION)
    np.testing.assert_allclose(listed.area_fraction, expected.area_fraction, rtol=1e-12)
    for pressure in (of(1, "MPa"), [of(1, "MPa")], of([1], "MPa")):
        found_curve = ta.persson(UNCD, STEEL, pressure=pressure, cutoff=of(10, "nm"))
        expected_curve = ta.persson(UNCD, STEEL, pressure="1 MPa", cutoff="10 nm")
        np.testing.assert_allclose(found_curve.area_fraction[0, -1], expected_curve.area_fraction[0, -1], rtol=1e-12)
    pressed = ta.boundary_elements(of(1e9 * WAVE, "nm"), STEEL, size=of(1, "um"), pressure=of(10, "MPa"), periodic=True)
    bare = ta.boundary_elements(WAVE, STEEL, size=1e-6, pressure=1e7, periodic=True)
    np.testing.assert_allclose(pressed.mean_gap_m, bare.mean_gap_m, rtol=1e-9)
    drawn = ta.uncertainty(UNCD, STEEL, pressure=1e6, model="elastic", draws=40, youngs_modulus=of(10, "GPa"))
    assert drawn == ta.uncertainty(UNCD, STEEL, pressure=1e6, model="elastic", draws=40, youngs_modulus="10 GPa")


@pytest.mark.parametrize("library", OF_UNIT)
def test_quantities_of_another_dimension_are_refused_by_name(library: str) -> None:
    of = OF_UNIT[library]
    with refused_naming("youngs_modulus", "Pa"):
        ta.Material(of(210, "m"), 0.3)
    with refused_naming("poisson_ratio"):
        ta.Material("210 GPa", of(0.3, "m"))
    with refused_naming("pressure", "Pa"):
        ta.contact(model="hertz", material=STEEL, pressure=of([5, 6], "m"), **POPULATION)
    with refused_naming("surface:", "m"):
        ta.boundary_elements(of(WAVE, "Pa"), STEEL, size=1e-6, pressure=1e7)
    with refused_naming("sigma_s", "m"):
        ta.contact(model="hertz", material=STEEL, pressure=1e6, **{**POPULATION, "sigma_s": of(1, "Pa")})


@pytest.mark.parametrize("model", ["hertz", "ep-sphere", "elastic-sine", "ep-sine", "bgt"])
def test_flags_of_the_processor_are_left_alone(model: StatisticalModel) -> None:
    roughness: dict[str, Any] = {"m0": 1e-16, "m2": 1e-2, "m4": 4e12} if model == "bgt" else POPULATION

    def area(pressure: float) -> float:
        return float(ta.contact(model=model, material=STEEL, pressure=pressure, **roughness).area_fraction)

    pressures = [1e3, 1e5, 1e6, 1e7, 1e8]
    with np.errstate(divide="raise", invalid="raise"):
        found = np.vectorize(area)(pressures)
    assert found.tolist() == [area(pressure) for pressure in pressures]


def test_a_bare_number_is_no_share() -> None:
    for share in (0.05, np.float64(0.05)):
        with refused_naming("youngs_modulus", '"5 %"', '"0.05 Pa"'):
            ta.uncertainty(UNCD, STEEL, pressure=1e6, model="elastic", draws=40, youngs_modulus=share)
    with refused_naming("yield_strength", '"10 %"', '"0.1 Pa"'):
        ta.uncertainty(UNCD, STEEL, pressure=1e6, model="elastic-plastic", draws=40, yield_strength=0.1)


def test_doubts_are_noted_by_every_call() -> None:
    soft = ta.Material(210, 0.3)
    answers: list[ta.Result] = [
        ta.contact(model="hertz", material=soft, pressure=1.0, **POPULATION),
        ta.persson(UNCD, soft, pressure=1.0),
        ta.gap(UNCD, soft, pressure=1.0),
        ta.boundary_elements(WAVE, soft, size=1e-6, pressure=1.0, periodic=True),
        ta.boundary_elements(1e9 * WAVE, STEEL, size=1e-6, pressure=1e7, periodic=True),
    ]
    assert [any(note.level == "caution" for note in answer.notes) for answer in answers] == [True] * 5


def test_bad_rows_may_be_nan() -> None:
    pressures = np.geomspace(1e5, 1e7, 3000)
    pressures[[0, 1500]] = np.nan, -1.0
    with refused_naming("element [0]"):
        ta.contact(model="hertz", material=STEEL, pressure=pressures, **POPULATION)
    found = ta.contact(model="hertz", material=STEEL, pressure=pressures, errors="nan", **POPULATION)
    alone = ta.contact(model="hertz", material=STEEL, pressure=np.geomspace(1e5, 1e7, 3000), **POPULATION)
    is_bad = np.isin(np.arange(3000), [0, 1500])
    np.testing.assert_array_equal(np.isnan(found.area_fraction), is_bad)
    np.testing.assert_array_equal(found.area_fraction[~is_bad], alone.area_fraction[~is_bad])
    assert any("2 of 3000" in note for note in found.notes)
    radii = ta.contact(model="hertz", material=STEEL, pressure=1e6, errors="nan", **{**POPULATION, "radius": [-1.0, 1e-6]})
    assert np.isnan(radii.area_fraction).tolist() == [True, False]
    with refused_naming("errors", "skip"):
        ta.contact(model="hertz", material=STEEL, pressure=1e6, errors="skip", **POPULATION)  # type: ignore[arg-type]


def test_results_are_arrays_and_frames() -> None:
    found = ta.contact(model="hertz", material=STEEL, pressure=[1e6, 2e6], **POPULATION)
    pd.testing.assert_frame_equal(pd.DataFrame(found), found.to_pandas()[list(found)])
    array = np.asarray(found)
    assert array.shape == (2,) and array.dtype.names == tuple(found)
    np.testing.assert_array_equal(array["pressure_pa"], found.pressure_pa)
    curve = ta.persson(UNCD, STEEL, pressure=[1e6, 2e6])
    assert np.asarray(curve).shape == tuple(curve.sizes.values())
    np.testing.assert_array_equal(np.asarray(curve)["area_fraction"], curve.area_fraction)


def test_results_cannot_be_changed() -> None:
    found = ta.contact(model="hertz", material=STEEL, pressure=[1e6, 2e6], **POPULATION)
    with pytest.raises(ValueError, match="read-only"):
        found.pressure_pa[0] = 1.0
    changes: list[Callable[[], Any]] = [
        lambda: found.update({"a": np.ones(1)}),
        lambda: found.pop("pressure_pa"),
        lambda: found.__setitem__("a", np.ones(1)),
        lambda: found.clear(),
    ]
    for change in changes:
        with pytest.raises(TypeError, match="ContactStates"):
            change()
    assert len(found) == 8


def test_datasets_have_names_and_indices() -> None:
    data = ta.persson(UNCD, STEEL, pressure=[1e6, 2e6]).to_xarray()
    assert data["nominal_pressure_pa"].attrs == {"long_name": "nominal pressure", "units": "Pa"}
    assert data["area_fraction"].attrs == {"long_name": "area fraction", "units": ""}
    near = data.sel(nominal_pressure_pa=2e6, wavelength_m=1e-8, method="nearest")
    assert float(near["nominal_pressure_pa"]) == 2e6 and near["area_fraction"].ndim == 0


def test_pressures_have_an_order() -> None:
    unordered: Any
    for unordered in ({1e6, 2e6}, frozenset([1e6]), {1e6: 2}, {1e6: 2}.keys()):
        with refused_naming("pressure", type(unordered).__name__):
            ta.persson(UNCD, STEEL, pressure=unordered)
        with refused_naming("pressure", type(unordered).__name__):
            ta.contact(model="hertz", material=STEEL, pressure=unordered, **POPULATION)


def test_materials_are_equal_by_their_numbers() -> None:
    steel = ta.Material(210e9, 0.3, counterface=ta.Material("70 GPa", 0.2))
    same = ta.Material("210 GPa", np.float64(0.3), counterface=ta.Material(7e10, 0.2))  # type: ignore[arg-type]
    assert steel == same and hash(steel) == hash(same)
    assert steel != same.replace(counterface=None) and steel != same.replace(yield_strength="1 GPa")


@pytest.mark.parametrize(
    ("call", "argument"),
    [
        (lambda wrong: ta.persson(UNCD, STEEL, pressure=1e6, hardness_law=wrong), "hardness_law"),
        (lambda wrong: ta.stacked(UNCD, STEEL, pressure=1e6, strain_gradient=wrong), "strain_gradient"),
        (lambda wrong: ta.stacked(UNCD, STEEL, pressure=1e6, model=wrong), "model"),
        (lambda wrong: ta.gap(UNCD, STEEL, pressure=1e6, band=wrong), "band"),
        (lambda wrong: ta.gap(UNCD, STEEL, pressure=wrong), "pressure"),
        (lambda wrong: ta.Material(wrong, 0.3), "youngs_modulus"),
        (lambda wrong: ta.Material("210 GPa", wrong), "poisson_ratio"),
        (lambda wrong: ta.set_threads(wrong), "count"),
        (lambda wrong: ta.contact(model="hertz", material=STEEL, pressure=1e6, tolerance=wrong, **POPULATION), "tolerance"),
    ],
)
def test_arguments_of_wrong_types_are_named(call: Callable[[Any], Any], argument: str) -> None:
    with refused_naming(argument):
        call(object())


def test_threads_are_bounded_and_come_back() -> None:
    before = ta.threads()
    with ta.threads(2):
        assert ta.threads() == 2
        with pytest.raises(ZeroDivisionError), ta.threads(3):
            assert ta.threads() == 3
            raise ZeroDivisionError
        assert ta.threads() == 2
        ta.set_threads(20000)
        assert 1 < ta.threads() <= 8 * (os.cpu_count() or 1)
    assert ta.threads() == before


@pytest.mark.parametrize(("variable", "expected"), [("3", 3), ("no number", None)])
def test_the_environment_tells_threads(variable: str, expected: int | None) -> None:
    environment = {**os.environ, "RAYON_NUM_THREADS": variable, "PYTHONPATH": str(Path(ta.__file__).parents[1])}
    program = [sys.executable, "-c", "import truearea; print(truearea.threads())"]
    done = subprocess.run(program, env=environment, capture_output=True, text=True, check=True)
    assert int(done.stdout) == (expected or len(os.sched_getaffinity(0)))


def test_scans_are_arrays(tmp_path: Path) -> None:
    np.save(tmp_path / "scan.npy", np.array([[0.0, np.nan, 1.0], [2.0, 3.0, 4.0]]))
    scan = ta.read_scan(tmp_path / "scan.npy", unit="m", size=3.0)
    np.testing.assert_array_equal(np.asarray(scan), [[0.0, np.nan, 1.0], [2.0, 3.0, 4.0]])
    assert np.asarray(scan, dtype=np.float32).dtype == np.float32


def test_names_from_files_are_escaped_in_notebooks(tmp_path: Path) -> None:
    name = "<img src=x onerror=alert(1)>"
    surface: dict[str, Any] = {"name": name, "datafile": {"original": "data.npy"}, "size": [1.0, 1.0], "unit": "um"}
    for values in (np.full((4, 4), np.nan), np.random.default_rng(1).normal(size=(16, 16))):
        heights = io.BytesIO()
        np.save(heights, values)
        with zipfile.ZipFile(tmp_path / "named.zip", "w") as container:
            container.writestr("index.json", json.dumps({"surfaces": [{"topographies": [surface]}]}))
            container.writestr("data.npy", heights.getvalue())
        scan = ta.read_scan(tmp_path / "named.zip")
        shown = [scan._repr_html_(), scan.summary()._repr_html_()]
        if not np.isnan(values).any():
            shown.append(ta.composite([scan])._repr_html_())
        assert scan.name == name and not any("<img" in html for html in shown)


def test_notes_are_data_and_cautions_warn_where_the_package_is_called() -> None:
    spectrum, soft = ta.read_psd("builtin:uncd-measured"), ta.Material(210.0, 0.3)
    with pytest.warns(ta.Caution) as caught:
        curve = ta.persson(spectrum, soft, pressure=1e6)
    assert {warning.filename for warning in caught} == {__file__}
    doubts = {note.code: note for note in curve.notes if note.level == "caution"}
    assert set(doubts) == {"doubt.softer-than-its-ratio", "doubt.real-above-third-modulus"}
    assert "210 Pa" in doubts["doubt.softer-than-its-ratio"]
    for filter, count in (("always", 6), ("default", 4), ("once", 4)):
        with warnings.catch_warnings(record=True) as further:
            warnings.simplefilter(filter, ta.Caution)  # type: ignore[arg-type]
            for pressure in (2e6, 3e6, 4e6):
                ta.persson(spectrum, soft, pressure=pressure)
        assert len(further) == count, filter
    with warnings.catch_warnings():
        warnings.simplefilter("error", ta.Caution)
        for pressure in (2e6, 2e6):
            with pytest.raises(ta.Caution):
                ta.persson(spectrum, soft, pressure=pressure)
    again = pickle.loads(pickle.dumps(curve)).notes
    assert again == curve.notes and [note.code for note in again] == [note.code for note in curve.notes]


def test_a_mistyped_name_is_met_with_the_names_that_it_resembles() -> None:
    with pytest.raises(ta.InputError, match="100Cr6"):
        ta.Material("100Cr7")
    with pytest.raises(ta.InputError, match="210 GPa"):
        ta.Material("210 GPA", 0.3)


def test_notes_of_intervals_say_how_serious_they_are() -> None:
    rng = np.random.default_rng(1)
    maps = [(factor * 1e-9 * rng.standard_normal((64, 64)).cumsum(1), "1 um") for factor in (1.0, 6.0)]
    spectrum = ta.composite(maps, instrument=["first", "second"], tip_radius="5 nm")
    notes = ta.uncertainty(spectrum, STEEL, pressure=1e6, model="elastic", draws=40).notes
    levels = {note.code: note.level for note in notes}
    assert levels["few-scans"] == "caution" and levels["uncertainty.draws"] == "note"
    assert levels["uncertainty.calibration"] == "note" and levels["uncertainty.overlap"] == "caution"


def test_datasets_with_notes_are_written_as_netcdf(tmp_path: Path) -> None:
    curve = ta.stacked(UNCD, ta.Material("463 GPa", 0.2, yield_strength="1.8 GPa"), pressure=["5.4 MPa", "54 MPa"])
    data = curve.to_xarray()
    assert data.attrs["notes"].splitlines() == list(curve.notes) != []
    data.to_netcdf(tmp_path / "curve.nc", engine="scipy")
    assert xr.open_dataset(tmp_path / "curve.nc", engine="scipy").attrs["notes"] == data.attrs["notes"]


def test_what_is_read_again_is_equal(tmp_path: Path) -> None:
    np.save(tmp_path / "map.npy", WAVE)
    scan = ta.read_scan(tmp_path / "map.npy", unit="m", size="1 um")
    assert pickle.loads(pickle.dumps(scan)) == scan == ta.read_scan(tmp_path / "map.npy", unit="m", size="1 um")
    assert scan != ta.read_scan(tmp_path / "map.npy", unit="m", size="2 um") and len({scan, scan}) == 1
    UNCD.write(tmp_path / "uncd.csv")
    again = ta.read_psd(tmp_path / "uncd.csv")
    assert again == UNCD and hash(again) == hash(UNCD) and again.name != UNCD.name
    assert np.asarray(UNCD)["c1d_m3"].tolist() == UNCD.c1d_m3.tolist()


def test_what_is_offered_can_be_called() -> None:
    curve = ta.stacked(UNCD, STEEL, pressure=1e6)
    assert {"area_fraction", "to_pandas", "items"} <= set(dir(curve))
    assert not {"clear", "pop", "popitem", "setdefault", "update"} & set(dir(curve))
    assert (STEEL.youngs_modulus, STEEL.youngs_modulus_pa) == ("210 GPa", 210e9)
    assert "rigid" in repr(STEEL) and "C45" in repr(ta.Material("100Cr6", counterface=ta.Material("C45")))
