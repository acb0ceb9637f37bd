"""Arrays, sizes and flags: every call reads them by the same functions."""

from __future__ import annotations

import os
import pickle
import threading
from collections.abc import Callable
from typing import Any

import numpy as np
import numpy.typing as npt
import pint
import pytest
import unyt  # type: ignore[import-untyped]
import xarray as xr
from astropy import units as astropy_units  # type: ignore[import-untyped]

import truearea as ta
from support import refused_naming

PINT: Any = pint.UnitRegistry()
UM: dict[str, Any] = {"pint": PINT.um, "unyt": unyt.um, "astropy": astropy_units.um}
UNCD = ta.read_psd("builtin:uncd-measured")
STEEL = ta.Material("210 GPa", 0.3, yield_strength="1 GPa", strain_gradient_length="5 um")
POPULATION: dict[str, Any] = {"radius": 1e-6, "density": 1e12, "sigma_s": 1e-8}
HEIGHTS = 1e-9 * np.random.default_rng(1).standard_normal((32, 64)).cumsum(1)
SIZE = ("2 um", "1 um")

# Of arrays of heights with a size: numbers that change with every height and with the size.
OF_HEIGHTS: dict[str, Callable[..., Any]] = {
    "boundary_elements": lambda h, size=SIZE: ta.boundary_elements(h, STEEL, pressure=1e8, size=size).mean_gap_m,
    "ball": lambda h, size=SIZE: ta.ball(h, STEEL, radius="1 um", force="1 uN", size=size).real_area_m2,
    "adhesion": lambda h, size=SIZE: ta.adhesion(
        h, STEEL, pressure=1e8, size=size, periodic=True, work_of_adhesion=0.05, adhesion_range="20 nm"
    ).mean_gap_m,
    "roughness": lambda h, size=SIZE: ta.roughness(h, size)["Sdq"],
    "from_heights": lambda h, size=SIZE: ta.Spectrum.from_heights(h, size=size).c1d_m3,
    "composite": lambda h, size=SIZE: ta.composite([(h, size)]).c1d_m3,
    "scene": lambda h, size=SIZE: ta.Scene(ta.Spectrum.from_heights(h, size=size), STEEL, pressure=1e6).scales().area_fraction,
}
# Of arrays of other quantities in SI units, with the unit of each.
OF_ARRAYS: dict[str, tuple[npt.NDArray[np.float64], str, Callable[[Any], Any]]] = {
    "stacked": (np.array([1e6, 5e6]), "MPa", lambda p: ta.stacked(UNCD, STEEL, pressure=p).area_fraction),
    "gap": (np.array([1e6, 5e6]), "MPa", lambda p: ta.gap(UNCD, STEEL, pressure=p).mean_gap_m),
    "law": (np.array([1e6, 5e6]), "MPa", lambda p: ta.law(UNCD, STEEL, pressure=p).overclosure_m),
    "shear": (
        np.array([1e5, 2e5]),
        "kPa",
        lambda q: ta.tangential(UNCD, STEEL, friction=0.3, pressure=5e6, tangential_stress=q).displacement_m,
    ),
    "separation": (
        np.array([1e-8, 2e-8]),
        "nm",
        lambda d: ta.statistical(UNCD, STEEL, model="hertz", separation=d).area_fraction,
    ),
    "mean gap": (
        np.array([5e-9, 8e-9]),
        "nm",
        lambda g: ta.boundary_elements(HEIGHTS, STEEL, mean_gap=g, size=SIZE, periodic=True).nominal_pressure_pa,
    ),
    "radius": (
        np.array([1e-6, 2e-6]),
        "um",
        lambda r: ta.contact(model="hertz", material=STEEL, pressure=1e6, **{**POPULATION, "radius": r}).area_fraction,
    ),
    "density": (
        np.array([1e12, 2e12]),
        "1/um**2",
        lambda d: ta.contact(model="hertz", material=STEEL, pressure=1e6, **{**POPULATION, "density": d}).area_fraction,
    ),
    "wavevectors": (np.geomspace(1e5, 1e9, 9), "1/um", lambda q: ta.Spectrum(q, np.geomspace(1e-22, 1e-30, 9)).wavelengths_m),
    "hardness_law": (
        np.array([1e-8, 1e-6]),
        "nm",
        lambda a: ta.persson(
            UNCD,
            STEEL,
            pressure=5e6,
            model="persson-plastic",
            hardness_law={"contact_size_m": a, "hardness_pa": [9e9, 3e9]},
        ).area_fraction,
    ),
}


def factor(unit: str) -> float:
    return float(PINT.Quantity(1.0, unit).to_base_units().m)


@pytest.mark.parametrize("name", OF_HEIGHTS)
def test_heights_of_a_data_array_are_turned_and_converted(name: str) -> None:
    call = OF_HEIGHTS[name]
    expected = call(HEIGHTS)
    each: list[tuple[str, ...]] = [("y", "x"), ("row", "column"), ("y_m", "x_m"), ("dim_0", "dim_1")]
    for dims in each:
        given = xr.DataArray(HEIGHTS * 1e9, dims=dims, attrs={"units": "nm"})
        np.testing.assert_allclose(call(given), expected, rtol=1e-6)
        if dims[0] != "dim_0":
            np.testing.assert_allclose(call(given.T), expected, rtol=1e-6)
    np.testing.assert_array_equal(call(xr.DataArray(HEIGHTS, dims=("y", "x"), attrs={"units": "m"})), expected)
    np.testing.assert_allclose(call(xr.DataArray(PINT.Quantity(HEIGHTS * 1e9, "nm"), dims=("y", "x"))), expected, rtol=1e-6)
    with refused_naming("dims", "'u', 'v'"):
        call(xr.DataArray(HEIGHTS, dims=("u", "v")))
    with refused_naming("units", "'MPa'"):
        call(xr.DataArray(HEIGHTS, dims=("y", "x"), attrs={"units": "MPa"}))


@pytest.mark.parametrize("name", OF_ARRAYS)
def test_data_arrays_and_quantities_are_converted_by_their_unit(name: str) -> None:
    si, unit, call = OF_ARRAYS[name]
    expected = call(si)
    scaled = si / factor(unit)
    np.testing.assert_allclose(call(xr.DataArray(scaled, attrs={"units": unit})), expected, rtol=1e-9)
    np.testing.assert_allclose(call(PINT.Quantity(scaled, unit)), expected, rtol=1e-9)
    np.testing.assert_allclose(call(xr.DataArray(PINT.Quantity(scaled, unit))), expected, rtol=1e-9)
    np.testing.assert_array_equal(call(xr.DataArray(si)), expected)
    with refused_naming("units", "'K'"):
        call(xr.DataArray(scaled, attrs={"units": "K"}))


def test_what_the_package_writes_into_a_dataset_is_read_again() -> None:
    data = ta.stacked(UNCD, STEEL, pressure=[1e6, 5e6]).to_xarray()
    assert ta.stacked(UNCD, STEEL, pressure=data.nominal_pressure_pa) == ta.stacked(UNCD, STEEL, pressure=[1e6, 5e6])
    samples = UNCD.to_xarray()
    again = ta.Spectrum(samples.wavevector_rad_per_m, samples.c1d_m3)
    np.testing.assert_allclose(again.c1d_m3, UNCD.c1d_m3, rtol=1e-15)
    moments = UNCD.moments().to_xarray().isel(row=slice(-5, None))
    expected = ta.contact(UNCD.moments().to_pandas().iloc[-5:], STEEL, model="hertz", pressure=1e6)
    assert ta.contact(moments, STEEL, model="hertz", pressure=1e6) == expected
    pressed = ta.boundary_elements(HEIGHTS, STEEL, pressure=1e8, size=SIZE, fields=True)
    again_pressed = ta.boundary_elements(pressed.to_xarray().height_m.T, STEEL, pressure=1e8, size=SIZE, detrend="mean")
    np.testing.assert_allclose(again_pressed.area_fraction, pressed.area_fraction, rtol=1e-9)


def test_data_arrays_of_several_dims_are_broadcast_by_place_or_refused() -> None:
    radii = xr.DataArray([1e-6, 2e-6], dims="radius")
    pressures = xr.DataArray([[1e6, 2e6], [3e6, 4e6]], dims=("load", "radius"))
    of = {"model": "hertz", "material": STEEL, "density": 1e12, "sigma_s": 1e-8}
    assert ta.contact(radius=radii, pressure=pressures, **of).area_fraction.shape == (2, 2)  # type: ignore[arg-type]
    with refused_naming("dims", "('radius',)", "('load',)"):
        ta.contact(radius=radii, pressure=xr.DataArray([1e6, 2e6], dims="load"), **of)  # type: ignore[arg-type]
    with refused_naming("axes['radius']", "unit"):
        ta.sweep(lambda radius: radius, {"radius": xr.DataArray([1.0], attrs={"units": "um"})})


@pytest.mark.parametrize("name", OF_HEIGHTS)
@pytest.mark.parametrize("library", UM)
def test_sizes_are_quantities_alone_in_lists_and_beside_text(library: str, name: str) -> None:
    call, um = OF_HEIGHTS[name], UM[library]
    expected = call(HEIGHTS)
    for size in ((2 * um, 1 * um), [2 * um, 1 * um], ("2 um", 1 * um), np.array([2.0, 1.0]) * um, [2e-6, 1 * um]):
        np.testing.assert_allclose(call(HEIGHTS, size), expected, rtol=1e-9)
    with refused_naming("size" if name not in ("composite",) else "scans[0][1]", "3 lengths"):
        call(HEIGHTS, [1 * um] * 3)


def test_flags_are_true_or_false() -> None:
    flat: dict[str, Any] = {"pressure": 1e8, "size": SIZE}
    calls: dict[str, Callable[[Any], Any]] = {
        "periodic": lambda flag: ta.boundary_elements(HEIGHTS, STEEL, **flat, periodic=flag),
        "fields": lambda flag: ta.boundary_elements(HEIGHTS, STEEL, **flat, fields=flag),
        "patches": lambda flag: ta.boundary_elements(HEIGHTS, STEEL, **flat, patches=flag),
        "per_realisation": lambda flag: ta.boundary_elements(UNCD, STEEL, pressure=1e8, grid=16, per_realisation=flag),
        "periodic ": lambda flag: ta.Spectrum.from_heights(HEIGHTS, size=SIZE, periodic=flag),
        "strain_gradient": lambda flag: ta.stacked(UNCD, STEEL, pressure=1e6, strain_gradient=flag),
        "strain_gradient ": lambda flag: ta.contact(
            model="ep-sphere", material=STEEL, pressure=1e6, strain_gradient=flag, **POPULATION
        ),
        "scales": lambda flag: ta.roughness(HEIGHTS, SIZE, scales=flag),
        "vectorised": lambda flag: ta.sweep(lambda a: {"b": a}, {"a": np.array([1.0])}, vectorised=flag),
        "report": lambda flag: ta.Scene(UNCD, STEEL, pressure=1e6, curves="elastic").run(report=flag, judge=False),
        "judge": lambda flag: ta.Scene(UNCD, STEEL, pressure=1e6, curves="elastic").run(judge=flag, report=False),
        "uncertainty": lambda flag: ta.Scene(UNCD, STEEL, pressure=1e6, curves="elastic").run(uncertainty=flag, report=False),
        "interface": lambda flag: ta.Scene(UNCD, STEEL, pressure=1e6, interface=flag),
        "seal": lambda flag: ta.Scene(UNCD, STEEL, pressure=1e6, seal=flag),
    }
    for name, call in calls.items():
        call(np.False_)
        for flag in ("no", "False", 0, 0.0, b""):
            with refused_naming(f"{name.strip()}:", "True or False"):
                call(flag)


def test_arrays_that_are_written_to_later_change_no_pickle() -> None:
    heights, gaps = HEIGHTS.copy(), np.ma.masked_array(HEIGHTS.copy(), mask=HEIGHTS > 1e-8)
    q, c = np.geomspace(1e5, 1e9, 9), np.geomspace(1e-22, 1e-30, 9)
    pressure = np.array([1e6, 1e7])
    made: list[tuple[Any, Callable[[Any], Any]]] = [
        (ta.Spectrum.from_heights(heights, size=SIZE), lambda one: one.c1d_m3),
        (ta.Spectrum.from_heights(gaps, size=SIZE), lambda one: one.c1d_m3),
        (ta.composite([(heights, SIZE), (heights, SIZE)]), lambda one: one.c1d_m3),
        (ta.Spectrum(q, c), lambda one: one.c1d_m3),
        (ta.law(UNCD, STEEL, pressure=pressure), lambda one: one.overclosure_m),
    ]
    before = [call(one).copy() for one, call in made]
    for array in (heights, gaps, q, c, pressure):
        array *= 2.0
    gaps.mask = False
    for (one, call), expected in zip(made, before):
        np.testing.assert_array_equal(call(one), expected)
        np.testing.assert_array_equal(call(pickle.loads(pickle.dumps(one))), expected)


def test_numbers_beyond_doubles_are_refused_and_mixed_objects_taken() -> None:
    for huge in (10**400, [10**400], np.array([10**400], dtype=object)):
        with refused_naming("pressure"):
            ta.contact(model="hertz", material=STEEL, pressure=huge, **POPULATION)
        with refused_naming("pressure"):
            ta.stacked(UNCD, STEEL, pressure=huge)
    with refused_naming("youngs_modulus"):
        ta.Material(10**400, 0.3)
    mixed = np.array(["1 um", 2e-6, 3 * PINT.um], dtype=object)
    found = ta.contact(model="hertz", material=STEEL, pressure=1e6, **{**POPULATION, "radius": mixed})
    expected = ta.contact(model="hertz", material=STEEL, pressure=1e6, **{**POPULATION, "radius": [1e-6, 2e-6, 3e-6]})
    np.testing.assert_allclose(found.area_fraction, expected.area_fraction, rtol=1e-12)


def test_overlapping_blocks_of_threads_leave_the_number_as_it_was() -> None:
    before = ta.threads()
    inside, other, seen = threading.Event(), threading.Event(), []

    def first() -> None:
        with ta.threads(1):
            inside.set()
            other.wait()
        seen.append(ta.threads())

    def second() -> None:
        inside.wait()
        with ta.threads(3):
            other.set()
            workers[0].join()

    workers = [threading.Thread(target=work) for work in (first, second)]
    for worker in workers:
        worker.start()
    for worker in workers:
        worker.join()
    assert seen == [3] and ta.threads() == before


def test_one_thread_is_the_one_that_calls() -> None:
    found: list[tuple[str, int]] = []
    caller = threading.get_ident()

    def tell(done: int, total: int | None) -> None:
        found.append(("", threading.get_ident()))


    def tasks() -> int:
        return len(os.listdir("/proc/self/task")) if os.path.isdir("/proc/self/task") else 0

    with ta.threads(1):
        count = tasks()
        most = count

        def watch(done: int, total: int | None) -> None:
            nonlocal most
            most = max(most, tasks())
            tell(done, total)

        ta.boundary_elements(UNCD, STEEL, pressure="5 MPa", grid=128, realisations=4, progress=watch)
        assert most == count and {ident for _, ident in found} == {caller}

        def stop(done: int, total: int | None) -> None:
            raise RuntimeError("stop")

        with pytest.raises(RuntimeError, match="stop"):
            ta.boundary_elements(UNCD, STEEL, pressure="5 MPa", grid=256, realisations=64, progress=stop)


def test_points_that_lie_unevenly_are_noted() -> None:
    """The sign of lengths that are swapped."""
    swapped = ("1 um", "2 um")
    calls: list[Callable[[Any], Any]] = [
        lambda size: ta.boundary_elements(HEIGHTS, STEEL, pressure=1e8, size=size),
        lambda size: ta.ball(HEIGHTS, STEEL, radius="1 um", force="1 uN", size=size),
        lambda size: ta.roughness(HEIGHTS, size),
        lambda size: ta.roughness(HEIGHTS, size, scales=True),
        lambda size: ta.Spectrum.from_heights(HEIGHTS, size=size),
        lambda size: ta.composite([(HEIGHTS, size)]),
    ]
    for call in calls:
        assert any("15.6 nm apart along x and 62.5 nm along y" in note for note in call(swapped).notes)
        assert not any("apart along x" in note for note in call(SIZE).notes)


def test_heights_of_simulations_have_no_tip() -> None:
    codes = [
        {note.code for note in ta.composite([(HEIGHTS, SIZE), (HEIGHTS[::-1], SIZE)], tip_radius=tip).notes}
        for tip in (None, "none", ["none", "none"], ["none", None])
    ]
    unknown = "surface.scans.scan.tip-unknown"
    assert [unknown in found for found in codes] == [True, False, False, True]
    untouched = ta.Spectrum.from_heights(HEIGHTS, size=SIZE, tip_radius="none")
    np.testing.assert_array_equal(untouched.c1d_m3, ta.Spectrum.from_heights(HEIGHTS, size=SIZE).c1d_m3)


def test_trends_and_forms_share_their_words() -> None:
    for trend in ("mean", "plane"):
        ta.Spectrum.from_heights(HEIGHTS, size=SIZE, detrend=trend)
        ta.roughness(HEIGHTS, SIZE, form=trend)
    means = [ta.roughness(HEIGHTS, SIZE, form=form) for form in ("mean", "none")]
    assert means[0] == means[1]
    pressed = [ta.boundary_elements(HEIGHTS, STEEL, pressure=1e8, size=SIZE, detrend=trend) for trend in ("mean", "none")]
    assert pressed[0] == pressed[1]
    with refused_naming("form", "cubic", "second-order"):
        ta.roughness(HEIGHTS, SIZE, form="cubic")  # type: ignore[call-overload]
