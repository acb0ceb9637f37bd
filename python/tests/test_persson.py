"""Persson's theory: its reference tables, the digits of the command line, and what is refused."""

from __future__ import annotations

import pickle
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

import truearea as ta
from support import Columns, Floats, numbers, refused_naming, words

UNCD = "builtin:uncd-reconstructed"
DIAMOND = ta.Material("463 GPa", 0.2, indentation_hardness="5.4 GPa", strain_gradient_length="1 um")
OPTIONS = ["--youngs-modulus", "463GPa", "--poisson-ratio", "0.2", "--indentation-hardness", "5.4GPa"]


def power_law(exponent: float, decades: float = 2.0) -> ta.Spectrum:
    """C1D = q^exponent from 1e4 rad/m on, which two samples say altogether."""
    q = 1e4 * np.array([1.0, 10.0**decades])
    return ta.Spectrum(q, 1e-18 * (q / 1e4) ** exponent)


def pressed(spectrum: ta.Spectrum, spread_pa: float, hardness_pa: float, pressure_pa: float, **options: Any) -> ta.PerssonCurve:
    """A curve whose last cutoff has a given spread s = E* h'/2, by the modulus that makes it."""
    gradient = ta.persson(spectrum, ta.Material(1.0, 0.0), pressure=1.0).rms_gradient[-1]
    material = ta.Material(2.0 * spread_pa / gradient, 0.0, indentation_hardness=hardness_pa)
    return ta.persson(spectrum, material, pressure=pressure_pa, **options)


def rows(table: Columns, kind: str) -> list[dict[str, float]]:
    """The rows of a kind by their columns."""
    at = [row for row, name in enumerate(words(table, "kind")) if name == kind]
    return [{name: float(table[name][row]) for name in table if name != "kind"} for row in at]


def near(found: Floats, exact: float, tolerance: float) -> None:
    assert abs(found[0, -1] / exact - 1.0) < tolerance


@pytest.mark.parametrize(("table", "kind"), [("persson.csv", "constant"), ("persson_given.csv", "constant-hardness")])
def test_areas_under_a_constant_hardness_are_those_of_the_reference(
    table: str, kind: str, reference: Callable[[str], Columns]
) -> None:
    exact = rows(reference(table), kind)
    assert len(exact) >= 6
    for row in exact:
        curve = pressed(power_law(-2.6), row["s_pa"], row["h0_pa"], row["p_pa"], model="persson-plastic")
        near(curve.area_fraction, row["area_contact"], 1e-11)
        near(curve.elastic_area_fraction, row["area_elastic"], 1e-11)
        near(curve.plastic_area_fraction, row["area_plastic"], 1e-10)
        near(curve.real_pressure_pa, row["p_pa"] / row["area_contact"], 1e-11)


def test_areas_of_the_elastic_theory_are_those_of_the_reference(reference: Callable[[str], Columns]) -> None:
    for row in rows(reference("persson_given.csv"), "constant-hardness"):
        curve = pressed(power_law(-2.6), row["s_pa"], row["h0_pa"], row["p_pa"])
        near(curve.area_fraction, row["area_elastic_theory"], 1e-13)
        assert np.array_equal(curve.area_fraction, curve.elastic_area_fraction)
        assert not curve.plastic_area_fraction.any()


@pytest.mark.parametrize(("table", "kind"), [("persson.csv", "growing"), ("persson_given.csv", "growing-hardness")])
def test_areas_under_a_growing_hardness_are_those_of_the_reference(
    table: str, kind: str, reference: Callable[[str], Columns]
) -> None:
    for row in rows(reference(table), kind):
        # H = H0 (q/q0)^n and V ~ q^2n - q0^2n make the H^2 = H0^2 + c V of the table.
        growth = float(np.log1p(row["c"] * (row["s_pa"] / row["h0_pa"]) ** 2) / np.log(100.0))
        curve = pressed(
            power_law(growth - 3.0),
            row["s_pa"],
            row["h0_pa"],
            row["p_pa"],
            model="persson-plastic",
            hardness_law=f"power:{0.5 * growth!r}",
        )
        near(curve.area_fraction, row["area_contact"], 1e-6)
        # Shares are accurate relative to that in contact.
        for found, name in [(curve.elastic_area_fraction, "area_elastic"), (curve.plastic_area_fraction, "area_plastic")]:
            assert abs(found[0, -1] - row[name]) <= 1e-6 * row["area_contact"], name


def test_gap_and_stiffness_are_those_of_the_reference(reference: Callable[[str], Columns]) -> None:
    # Persson's C = C0 q^-3.6, whose profiles have C1D = pi^2 C q.
    q = np.array([1e4, 1e6])
    profiles = ta.Spectrum(q, np.pi**2 * 2.3041816986325860e-5 * q**-2.6)
    unit = ta.Material(1.0, 0.0)
    exact = rows(reference("persson_given.csv"), "separation")
    assert len(exact) == 8
    for row in exact:
        curve = ta.persson(profiles, unit, pressure=row["p_pa"], gamma=row["gamma"], band="1d")
        near(curve.mean_gap_m, row["u_m"], 1e-9)
        near(curve.stiffness_pa_per_m, row["k_pa_per_m"], 1e-9)
        near(curve.area_fraction, row["area_elastic_theory"], 1e-9)
        light = {0.45: (2.844653285e-6, 0.08385494254), 1.0: (6.321451744e-6, 0.01884593055)}[row["gamma"]]
        assert np.allclose((curve.u0_m, curve.p00_pa), light, rtol=1e-9, atol=0.0)


@pytest.mark.parametrize(
    ("options", "typed"),
    [
        ({}, ["--model", "elastic"]),
        (
            {"correction": "algebraic-nayak", "band": "2d"},
            "--model elastic --correction algebraic-nayak --band 2d".split(),
        ),
        (
            {"gamma": 0.7, "cutoff": "100 nm", "scales_per_decade": 7},
            "--model elastic --gamma 0.7 --cutoff 100nm --scales-per-decade 7".split(),
        ),
        ({"gamma": "fitted"}, "--model elastic --gamma fitted".split()),
        ({"model": "persson-plastic"}, ["--model", "elastic-plastic"]),
        (
            {"model": "persson-plastic", "hardness_law": "nix-gao", "amplitude": "parseval"},
            "--model elastic-plastic --strain-gradient-length 1um --amplitude parseval".split(),
        ),
        (
            {"model": "persson-plastic", "hardness_law": "power:0.2"},
            ["--model", "elastic-plastic", "--hardness-law", "power:0.2"],
        ),
    ],
)
def test_curves_are_those_of_the_command_line_bit_for_bit(
    options: dict[str, Any], typed: list[str], command_line: Callable[..., Columns]
) -> None:
    curve = ta.persson(ta.read_psd(UNCD), DIAMOND, pressure=["540 kPa", "1e-2 H"], **options)
    crates = command_line("persson", UNCD, *OPTIONS, *typed, "--pressure", "540kPa", "--pressure", "1e-2H")
    shape = curve.area_fraction.shape
    assert set(crates) == set(curve) - {"u0_m", "p00_pa"}
    for name in crates:
        axes = curve.axes(name)
        array = curve[name][:, None] if axes == ("load",) else curve[name]
        found = np.broadcast_to(array, shape).reshape(-1)
        if name == "band":
            assert found.tolist() == words(crates, name)
        else:
            assert np.array_equal(found, numbers(crates, name), equal_nan=True), name


def test_a_hardness_grows_by_its_law_or_its_table() -> None:
    uncd = ta.read_psd(UNCD)
    pressures = ["1 MPa", "10 MPa"]
    plain = ta.persson(uncd, DIAMOND, pressure=pressures, model="persson-plastic")
    nix_gao = ta.persson(uncd, DIAMOND, pressure=pressures, model="persson-plastic", strain_gradient=True)
    assert nix_gao == ta.persson(uncd, DIAMOND, pressure=pressures, model="persson-plastic", hardness_law="nix-gao")
    assert np.all(nix_gao.plastic_area_fraction[:, -1] < plain.plastic_area_fraction[:, -1])
    # A table of one hardness is a constant one, and the material needs none of its own.
    table = {"contact_size_m": [1e-6], "hardness_pa": [5.4e9]}
    soft = ta.Material("463 GPa", 0.2)
    by_table = ta.persson(uncd, soft, pressure=pressures, model="persson-plastic", hardness_law=table)
    assert np.array_equal(by_table.area_fraction, plain.area_fraction)
    capped = ta.persson(
        uncd, DIAMOND.replace(strength_cap="1.8 GPa"), pressure=pressures, model="persson-plastic", hardness_law="power:0.5"
    )
    assert np.allclose(capped.area_fraction, plain.area_fraction, rtol=1e-9)


def test_a_curve_is_pickled_framed_and_has_its_axes() -> None:
    pytest.importorskip("xarray")
    curve = ta.persson(ta.read_psd(UNCD), DIAMOND, pressure=[1e6, 1e7], model="persson-plastic")
    assert pickle.loads(pickle.dumps(curve)) == curve
    loads, cutoffs = curve.area_fraction.shape
    assert curve.axes("rms_gradient") == ("cutoff",) and curve.axes("u0_m") == ()
    # More than 3 % of the contact is plastic at the finest cutoffs.
    assert np.isnan(curve.mean_gap_m[:, -1]).all() and not np.isnan(curve.mean_gap_m[:, 0]).any()
    frame = curve.to_pandas()
    assert len(frame) == loads * cutoffs and frame["u0_m"].nunique() == 1
    data = curve.to_xarray()
    assert data.area_fraction.dims == ("load", "cutoff") and data.u0_m.attrs["units"] == "m"
    assert any("plastic" in note or "flows" in note or "h'" in note for note in curve.notes)
    assert "u0_m" in repr(curve) and "<table>" in curve._repr_html_()


@pytest.mark.parametrize(
    ("changes", "told"),
    [
        ({"pressure": -1.0}, "pressure -1; 0"),
        ({"pressure": [1e6, float("nan")]}, "pressure[1] NaN; 0"),
        ({"pressure": []}, "pressure: empty"),
        ({"model": "plastic"}, "model: plastic persson-plastic"),
        ({"gamma": 0.0}, "gamma 0;"),
        ({"gamma": "half"}, "gamma: half fitted"),
        ({"band": "3d"}, "band: 3d 1d 2d"),
        ({"correction": "none"}, "correction: none wang-muser"),
        ({"hardness_law": "power:0.2"}, "hardness_law persson"),
        ({"strain_gradient": True}, "strain_gradient persson"),
        (
            {"model": "persson-plastic", "correction": "algebraic"},
            "correction persson-plastic",
        ),
        (
            {"model": "persson-plastic", "strain_gradient": True, "hardness_law": "power:0.2"},
            "strain_gradient hardness_law",
        ),
        (
            {"model": "persson-plastic", "hardness_law": "power:-1"},
            "hardness_law: -1;",
        ),
        ({"model": "persson-plastic", "hardness_law": "linear"}, "hardness_law: 'linear' power:N nix-gao"),
        ({"model": "persson-plastic", "hardness_law": 0.2}, "hardness_law: 'power:N' 'nix-gao'"),
        (
            {"model": "persson-plastic", "hardness_law": {"hardness_pa": [1.0]}},
            "contact_size_m",
        ),
        (
            {"model": "persson-plastic", "hardness_law": {"contact_size_m": [1.0, 2.0], "hardness_pa": [1.0]}},
            "(2,) (1,)",
        ),
        (
            {"model": "persson-plastic", "hardness_law": {"contact_size_m": [], "hardness_pa": []}},
            "hardness_law: empty",
        ),
        (
            {"model": "persson-plastic", "hardness_law": {"contact_size_m": [1e-9, 1.0], "hardness_pa": [1e9, 2e9]}},
            "hardness falls",
        ),
        ({"cutoff": "1 pm"}, "cutoff nothing"),
        ({"scales_per_decade": 0}, "scales_per_decade 0;"),
        ({"amplitude": "eq6"}, "amplitude: eq6"),
    ],
)
def test_wrong_input_is_told_by_its_argument(changes: dict[str, Any], told: str) -> None:
    given: dict[str, Any] = {"pressure": "1 MPa"} | changes
    with refused_naming(*told.split()):
        ta.persson(ta.read_psd(UNCD), DIAMOND, **given)


def test_what_the_material_lacks_is_told() -> None:
    uncd, elastic = ta.read_psd(UNCD), ta.Material("463 GPa", 0.2)
    with refused_naming("material", "yield_strength", "indentation_hardness"):
        ta.persson(uncd, elastic, pressure="1 MPa", model="persson-plastic")
    hard = ta.Material("463 GPa", 0.2, indentation_hardness="5.4 GPa")
    with refused_naming("material", "strain_gradient_length"):
        ta.persson(uncd, hard, pressure="1 MPa", model="persson-plastic", strain_gradient=True)


def test_what_is_no_spectrum_or_material_is_told() -> None:
    other: Any = 1.0
    with refused_naming("surface:", "Spectrum", "float"):
        ta.persson(other, DIAMOND, pressure=1e6)
    with refused_naming("material:", "Material", "float"):
        ta.persson(ta.read_psd(UNCD), other, pressure=1e6)
