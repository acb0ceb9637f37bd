"""Surfaces that attract each other: the digits of the command line, branches, pull-off, patches, and what is refused."""

from __future__ import annotations

import pickle
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt
import pytest

import truearea as ta
from support import REFERENCE, Columns, columns_of, numbers, refused_naming, words

UNCD = "builtin:uncd-reconstructed"
GLASS = ta.Material("100 GPa", 0.0)
STICKY: dict[str, Any] = {"work_of_adhesion": "20 J/m^2", "adhesion_range": "100 nm"}
FLAGS = ["--work-of-adhesion", "20J/m^2", "--adhesion-range", "100nm"]
BODY = ["--youngs-modulus", "100GPa", "--poisson-ratio", "0"]
RANDOM: dict[str, Any] = {"grid": 32, "realisations": 2, "side": "4 um", "shortest": "500 nm"}
RANDOM_FLAGS = ["--grid", "32", "--realisations", "2", "--box", "4um", "--shortest", "500nm"]
UM = 1e-6


def wave(points: int = 32) -> npt.NDArray[np.float64]:
    """An egg box with a wavelength of 2 um."""
    x = 2.0 * np.pi * np.arange(points) / points
    return 2e-7 * np.cos(x)[:, None] * np.cos(x)


def bem(command_line: Callable[..., Columns], *flags: str) -> Columns:
    return command_line("bem", UNCD, *BODY, *RANDOM_FLAGS, "--format", "csv", *flags)


@pytest.mark.parametrize("branch", ["apart", "contact", "both"])
def test_branches_have_the_digits_of_the_command_line(command_line: Callable[..., Columns], branch: Any) -> None:
    loads = ["--pressure", "20MPa", "--pressure", "50MPa"]
    told = bem(command_line, *FLAGS, *loads, "--branch", branch, "--per-realisation")
    pressed = ta.adhesion(UNCD, GLASS, pressure=["20 MPa", "50 MPa"], branch=branch, per_realisation=True, **RANDOM, **STICKY)
    assert pressed.axes("area_fraction") == (("load", "branch", "surface") if branch == "both" else ("load", "surface"))
    for name in ("area_fraction", "repulsive_area_fraction", "mean_gap_m", "mean_attraction_pa", "residual"):
        # Rows go through the loads of each branch of each surface.
        assert np.array_equal(pressed[name].T.reshape(-1), numbers(told, name)), name
    assert np.allclose(pressed.nominal_pressure_pa, [2e7, 5e7], rtol=1e-12, atol=0.0)
    assert np.reshape(pressed.branch, -1).tolist() == list(dict.fromkeys(words(told, "branch")))
    means = bem(command_line, *FLAGS, *loads, "--branch", branch)
    pressed = ta.adhesion(UNCD, GLASS, pressure=[2e7, 5e7], branch=branch, **RANDOM, **STICKY)
    assert np.array_equal(pressed.area_fraction.T.reshape(-1), numbers(means, "area_fraction"))
    assert pressed.pastewka_robbins > 0.0 and pressed.fuller_tabor > 0.0
    assert pickle.loads(pickle.dumps(pressed)) == pressed


def test_pull_off_has_the_digits_of_the_command_line_and_its_largest_pull(command_line: Callable[..., Columns]) -> None:
    told = bem(command_line, *FLAGS, "--pull-off")
    pulled = ta.pull_off(UNCD, GLASS, **RANDOM, **STICKY)
    assert isinstance(pulled, ta.PullOff)
    for name in told:
        expected = words(told, name) if name == "branch" else numbers(told, name)
        assert np.array_equal(pulled[name], expected), name
    least = [pulled.nominal_pressure_pa[pulled.realisation == at].min() for at in (1.0, 2.0)]
    assert np.isclose(pulled.pull_off_pressure_pa, np.mean(least), rtol=1e-12, atol=0.0)
    assert "<svg" in pulled._repr_html_()
    axes = pytest.importorskip("matplotlib.pyplot").subplots()[1]
    assert pulled.plot(axes) is axes
    assert axes.get_yscale() == "linear" and axes.get_ylabel().startswith("pull") and len(axes.lines) == 2


def test_maps_carry_the_loads_of_another_solver(reference: Callable[[str], Columns]) -> None:
    netcdf = pytest.importorskip("scipy.io").netcdf_file
    with netcdf(REFERENCE / "adhesion_a.nc", mmap=False) as file:
        heights_m = np.array(file.variables["heights"].data.T * UM, dtype=np.float64)
        size = (float(file.variables["x"].length) * UM, float(file.variables["y"].length) * UM)
    table = reference("adhesion.csv")
    at = np.array(words(table, "map")) == "a"
    row = {name: numbers(table, name)[at][-1] for name in table if name not in ("map", "start")}
    pressed = ta.adhesion(
        heights_m,
        ta.Material("1 GPa", 0.0),
        pressure=row["pressure_over_e_star"] * 1e9,
        work_of_adhesion=row["work_of_adhesion_over_e_star_um"] * 1e9 * UM,
        adhesion_range=row["range_um"] * UM,
        size=size,
        periodic=True,
        tolerance=1e-8,
    )
    assert abs(pressed.area_fraction[0] - row["area_fraction"]) <= 1.5 / heights_m.size
    assert np.isclose(pressed.mean_gap_m[0], row["mean_gap_um"] * UM, rtol=1e-6, atol=0.0)


def test_maps_are_pressed_side_by_side_and_may_be_pulled() -> None:
    maps = np.stack([wave(), 0.5 * wave()])
    options: dict[str, Any] = {"size": "2 um", "periodic": True, "pressure": ["50 MPa", "-1 MPa", 0.0], **STICKY}
    both = ta.adhesion(maps, GLASS, **options)
    assert both.axes("area_fraction") == ("load", "map") and both.axes("rms_gradient") == ("map",)
    for at, heights_m in enumerate(maps):
        alone = ta.adhesion(heights_m, GLASS, **options)
        assert np.array_equal(alone.area_fraction, both.area_fraction[:, at])
    assert [note.code for note in both.notes if "metastable" in note.code] == ["adhesion.metastable"]
    assert np.allclose(both.nominal_pressure_pa, [5e7, -1e6, 0.0], rtol=1e-12, atol=0.0)
    pytest.importorskip("matplotlib")
    assert both.plot().get_xscale() == "linear"


def test_patches_are_those_of_the_command_line(command_line: Callable[..., Columns], tmp_path: Path) -> None:
    path = tmp_path / "patches.csv"
    bem(command_line, "--pressure", "1GPa", "--patches", str(path))
    told = columns_of(path.read_text(encoding="utf-8"))
    pressed = ta.boundary_elements(UNCD, GLASS, pressure="1 GPa", patches=True, **RANDOM)
    assert pressed.patches is not None and len(pressed.patches.area_m2) > 1
    for name in told:
        assert np.array_equal(pressed.patches[name], numbers(told, name)), name
    again = pickle.loads(pickle.dumps(pressed))
    assert again == pressed and again.patches == pressed.patches
    assert ta.boundary_elements(UNCD, GLASS, pressure="1 GPa", **RANDOM).patches is None


@pytest.mark.parametrize(
    ("call", "options", "named"),
    [
        (ta.adhesion, {"branch": "up"}, ["branch", "up", "both"]),
        (ta.adhesion, {"pressure": float("nan")}, ["pressure", "NaN"]),
        (ta.adhesion, {"pressure": "-10 GPa"}, ["adhesion", "GPa"]),
        (ta.adhesion, {"work_of_adhesion": "20 J/m"}, ["work_of_adhesion", "20 J/m"]),
        (ta.adhesion, {"work_of_adhesion": -1.0}, ["work_of_adhesion", "-1"]),
        (ta.adhesion, {"work_of_adhesion": None}, ["work_of_adhesion", "NoneType"]),
        (ta.adhesion, {"adhesion_range": "50 MPa"}, ["adhesion_range", "50 MPa"]),
        # The process zone falls between two points.
        (ta.adhesion, {"adhesion_range": "1 nm"}, ["adhesion", "points"]),
        (ta.adhesion, {"grid": 64}, ["grid", "heights", "spectrum"]),
        (ta.pull_off, {"pressure": None, "adhesion_range": "50 MPa"}, ["adhesion_range", "50 MPa"]),
    ],
)
def test_what_does_not_go_together_is_refused_by_name(call: Any, options: dict[str, Any], named: list[str]) -> None:
    given = {"size": "2 um", "periodic": True, "pressure": 1e7, **STICKY, **options}
    with refused_naming(*named):
        call(wave(), GLASS, **(given if call is ta.adhesion else {name: one for name, one in given.items() if name != "pressure"}))


@pytest.mark.parametrize("argument", ["saturation", "mean_gap", "fields", "patches", "radius", "force"])
def test_a_function_names_an_argument_that_it_has_not(argument: str) -> None:
    calls: list[Any] = [ta.adhesion, ta.pull_off]
    for call in calls:
        with refused_naming(call.__name__, argument, by=TypeError):
            call(wave(), GLASS, **{argument: 1.0})


def test_free_edges_are_refused_with_adhesion() -> None:
    with refused_naming("adhesion", "edges"):
        ta.adhesion(wave(), GLASS, pressure=1e7, size="2 um", **STICKY)


def test_units_of_pint_are_converted() -> None:
    pint = pytest.importorskip("pint")
    units = pint.UnitRegistry()
    options: dict[str, Any] = {"size": "2 um", "periodic": True}
    given = ta.adhesion(
        wave(),
        GLASS,
        pressure=units.Quantity(50, "MPa"),
        work_of_adhesion=units.Quantity(20e3, "mJ/m**2"),
        adhesion_range=units.Quantity(100, "nm"),
        **options,
    )
    assert np.allclose(given.area_fraction, ta.adhesion(wave(), GLASS, pressure=5e7, **options, **STICKY).area_fraction)


def test_notes_have_a_level_and_a_place() -> None:
    states = ta.contact(
        radius=[1e-6, -1.0, 1e-6, -2.0], density=1e12, sigma_s=1e-8, material=GLASS, model="hertz", pressure=1e6, errors="nan"
    )
    bad = next(note for note in states.notes if note.level == "error")
    assert (bad.code, bad.place) == ("rows.bad", ta.Place(row=1))
    assert "1 error" in repr(states)
    curve = ta.stacked(UNCD, ta.Material("100 GPa", 0.0, yield_strength="1 GPa"), pressure="1 MPa")
    sampled = next(note for note in curve.notes if note.code == "sampling.sampled-scales")
    assert (sampled.level, sampled.place.key) == ("note", "scales_per_decade")
