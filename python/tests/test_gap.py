"""Mean gap and stiffness: references, the digits of the command line, and what is refused."""

from __future__ import annotations

import pickle
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

import truearea as ta
from support import Columns, numbers, refused_naming

UNCD = "builtin:uncd-reconstructed"
DIAMOND = ta.Material("463 GPa", 0.2, yield_strength="1.8 GPa", strain_gradient_length="5 um")
OPTIONS = ["--youngs-modulus", "463GPa", "--poisson-ratio", "0.2", "--yield-strength", "1.8GPa"]
LOADS = ["--pressure", "10kPa", "--pressure", "1e-3H"]


@pytest.mark.parametrize(
    ("gamma", "light", "states"),
    [
        (
            0.45,
            (2.844653285e-6, 0.08385494254),
            [
                (1e-4, 1.91416391700605e-5, 35.0598908863103),
                (1e-3, 1.25254210044303e-5, 342.978525765205),
                (1e-2, 5.5269982660541e-6, 3160.50234158949),
                (0.1, 2.41601004312858e-7, 149084.76473024),
            ],
        ),
        (1.0, (6.321451744e-6, 0.01884593055), [(1e-3, 1.87599020675443e-5, 163.266583800347)]),
    ],
)
def test_gaps_of_perssons_theory_are_those_of_references(
    gamma: float, light: tuple[float, float], states: list[tuple[float, float, float]]
) -> None:
    # C = 2.304e-5 q^-3.6 from 1e4 to 1e6 rad/m, whose profiles have C1D = pi^2 C q; by independent quadratures.
    q = np.array([1e4, 1e6])
    spectrum = ta.Spectrum(q, np.pi**2 * 0.000_023_041_816_986_325_86 * q**-2.6)
    pressure_pa, gap_m, stiffness = np.transpose(states)
    gaps = ta.gap(spectrum, ta.Material(1.0, 0.0), pressure=pressure_pa, gamma=gamma, band="1d")
    assert np.allclose(gaps.mean_gap_m, gap_m, rtol=1e-10, atol=0.0)
    assert np.allclose(gaps.stiffness_pa_per_m, stiffness, rtol=1e-10, atol=0.0)
    assert np.allclose(gaps.u0_m, light[0], rtol=1e-9, atol=0.0) and np.allclose(gaps.p00_pa, light[1], rtol=1e-9, atol=0.0)
    assert np.array_equal(gaps.nominal_pressure_pa, pressure_pa)


@pytest.mark.parametrize(
    ("options", "typed"),
    [
        ({"model": "persson"}, "--model persson"),
        (
            {"model": "persson", "band": "2d", "gamma": 1.0, "cutoff": "20 nm"},
            "--model persson --band 2d --gamma 1 --cutoff 20nm",
        ),
        ({"model": "persson-plastic"}, "--model persson-plastic"),
        ({"model": "hertz", "scales_per_decade": 7}, "--model hertz --scales-per-decade 7"),
        ({"model": "ep-sphere", "strain_gradient": True}, "--model ep-sphere --strain-gradient-length 5um"),
        ({"model": "ep-sphere", "hardness_formula": "cosine", "tolerance": 1e-6}, "--model ep-sphere --hardness-formula cosine --tolerance 1e-6"),
        (
            {"model": "bem", "grid": 32, "realisations": 2, "seed": 3, "phases": "gaussian", "shortest": "1 um"},
            "--model bem --grid 32 --realisations 2 --seed 3 --phases gaussian --shortest 1um",
        ),
    ],
)
def test_gaps_are_those_of_the_command_line_bit_for_bit(
    options: dict[str, Any], typed: str, command_line: Callable[..., Columns]
) -> None:
    crates = command_line("gap", UNCD, *OPTIONS, *LOADS, *typed.split())
    gaps = ta.gap(ta.read_psd(UNCD), DIAMOND, pressure=["10 kPa", "1e-3 H"], **options)
    assert list(gaps) == list(crates)
    for name in crates:
        assert np.array_equal(gaps[name], numbers(crates, name), equal_nan=True), name


def test_notes_tell_where_gaps_mean_little_in_terms_of_arguments() -> None:
    uncd = ta.read_psd(UNCD)
    told = "\n".join(ta.gap(uncd, DIAMOND, pressure="1 kPa", band="1d").notes)
    assert 'use band="2d"' in told and "--" not in told
    assert "the logarithmic law" in told and "exceeds 3 rms heights" in told
    assert "waves of profiles" not in "\n".join(ta.gap(uncd, DIAMOND, pressure="1 kPa").notes)
    surfaces = ta.gap(uncd, DIAMOND, pressure="1 GPa", model="bem", grid=32, realisations=1, shortest="1 um")
    assert any("1 surface of 32 x 32 points" in note for note in surfaces.notes)


def test_gaps_are_pickled_and_framed() -> None:
    pytest.importorskip("xarray")
    gaps = ta.gap(ta.read_psd(UNCD), DIAMOND, pressure=[1e4, 1e6], model="hertz")
    assert pickle.loads(pickle.dumps(gaps)) == gaps
    assert list(gaps.to_pandas()) == list(gaps) and len(gaps.to_pandas()) == 2
    assert gaps.to_xarray().mean_gap_m.dims == ("load",)
    assert np.isnan(gaps.u0_m).all()


@pytest.mark.parametrize(
    ("changes", "told"),
    [
        ({"pressure": 0.0}, "pressure 0;"),
        ({"pressure": "1 parsec"}, "pressure:"),
        ({"model": "elastic"}, "model: 'elastic' persson bem"),
        ({"model": "hertz", "gamma": 0.5}, "gamma hertz"),
        ({"model": "hertz", "band": "2d"}, "band hertz"),
        ({"normalisation": "parseval"}, "normalisation persson"),
        ({"hardness_formula": "2005"}, "hardness_formula persson"),
        ({"interference_law": "bem", "model": "hertz"}, "interference_law hertz"),
        ({"strain_gradient": True, "model": "hertz"}, "strain_gradient hertz"),
        ({"grid": 64}, "grid bem"),
        ({"model": "bem", "cutoff": 1e-6}, "cutoff bem"),
        ({"model": "bem", "gamma": 0.45}, "gamma bem"),
        ({"gamma": "fit"}, "gamma fitted"),
        ({"model": "bem", "grid": 8}, "grid 8; 16 16384"),
        ({"gamma": 1.5}, "gamma 1.5;"),
        ({"tolerance": 1e-6}, "tolerance persson"),
        ({"model": "bem", "tolerance": 1e-6}, "tolerance bem"),
        ({"model": "hertz", "tolerance": 0.5}, "tolerance"),
        ({"band": 2}, "band: int"),
        ({"scales_per_decade": 2.5}, "scales_per_decade 2.5;"),
        ({"scales_per_decade": -3}, "scales_per_decade -3;"),
    ],
)
def test_wrong_input_is_told_by_its_argument(changes: dict[str, Any], told: str) -> None:
    given: dict[str, Any] = {"pressure": "1 MPa"} | changes
    with refused_naming(*told.split()):
        ta.gap(ta.read_psd(UNCD), DIAMOND, **given)


def test_a_spectrum_without_gap_is_refused() -> None:
    uncd = ta.read_psd(UNCD)
    for model in ("persson", "hertz"):
        with refused_naming("spectrum", "gap"):
            ta.gap(uncd, DIAMOND, pressure="1 MPa", model=model, cutoff=uncd.wavelengths_m[0])


def test_what_is_no_spectrum_or_material_is_told() -> None:
    other: Any = 1.0
    with refused_naming("surface:", "Spectrum", "float"):
        ta.gap(other, DIAMOND, pressure=1e6)
    with refused_naming("material:", "Material", "float"):
        ta.gap(ta.read_psd(UNCD), other, pressure=1e6)
