"""Roughness parameters and tangential loads: the same as those of the command line."""

from __future__ import annotations

import io
import os
import subprocess
from pathlib import Path

import numpy as np
import pandas as pd
import pytest

import truearea as ta
from support import ROOT, refused_naming


def command_line(*arguments: str) -> pd.DataFrame:
    """The table that a command prints."""
    program = os.environ.get("TRUEAREA_PROGRAM")
    manifest = str(ROOT / "Cargo.toml")
    call = [program] if program else ["cargo", "run", "--quiet", "--manifest-path", manifest, "--bin", "truearea", "--"]
    done = subprocess.run([*call, *arguments], check=True, capture_output=True, text=True)
    # pandas 2 rounds the last digit of the numbers that it reads.
    printed = pd.read_csv(io.StringIO(done.stdout), comment="#", keep_default_na=False, dtype=str)
    for name in set(printed) - {"file", "channel", "parameter", "unit", "convention"}:
        printed[name] = printed[name].replace("", "nan").astype(float)
    return printed


def heights_m() -> np.ndarray:
    made: np.ndarray = 1e-9 * np.random.default_rng(3).standard_normal((48, 64)).cumsum(1)
    return made


def test_parameters_are_those_of_the_command_line(tmp_path: Path) -> None:
    path = tmp_path / "map.npy"
    np.save(path, heights_m())
    options = {"form": "second-order", "filter": "0.5 um", "convention": "all"}
    printed = command_line(
        "roughness", f"{path}:unit=m,size=1um", "--form", "second-order", "--filter", "0.5um", "--convention", "all"
    )  # fmt: skip
    for found in (
        ta.roughness(path, "1 um", unit="m", **options),  # type: ignore[arg-type]
        ta.roughness(ta.read_scan(path, unit="m", size="1 um"), **options),  # type: ignore[arg-type]
        ta.roughness(heights_m(), ("1 um", "0.75 um"), **options),  # type: ignore[arg-type]
    ):
        assert list(found.parameter) == list(printed["parameter"])
        assert list(found.convention) == list(printed["convention"])
        assert np.array_equal(found.value, printed["value"].to_numpy(float), equal_nan=True)
    assert found["Sq"] == printed.set_index("parameter")["value"]["Sq"]
    with pytest.raises(KeyError, match="Sx"):
        found["Sx"]


def test_slopes_down_to_each_wavelength_are_those_of_the_command_line(tmp_path: Path) -> None:
    path = tmp_path / "map.npy"
    np.save(path, heights_m())
    printed = command_line("roughness", f"{path}:unit=m,size=1um", "--form", "none", "--filter", "0.5um", "--scales")
    for found in (
        ta.roughness(path, "1 um", unit="m", form="none", filter="0.5 um", scales=True),
        ta.roughness(ta.read_scan(path, unit="m", size="1 um"), form="none", filter="0.5 um", scales=True),
        ta.roughness(heights_m(), ("1 um", "0.75 um"), form="none", filter="0.5 um", scales=True),
    ):
        assert list(found) == list(printed)
        for name in list(found)[2:]:
            assert np.array_equal(found[name], printed[name].to_numpy(float), equal_nan=True), name
    with_gaps = np.ma.masked_array(heights_m(), mask=heights_m() > 5e-9)
    found = ta.roughness(with_gaps, ("1 um", "0.75 um"), scales=True)
    assert np.isnan(found.rms_gradient_spectrum).all() and np.isfinite(found.rms_gradient_heights).any()
    assert any("no spectrum" in note for note in found.notes)
    for idle in ({"ratio_height": "1 nm"}, {"convention": "all"}):
        with refused_naming("scales", "no effect"):
            ta.roughness(heights_m(), ("1 um", "0.75 um"), scales=True, **idle)  # type: ignore[call-overload]  # pyright: ignore[reportCallIssue, reportArgumentType]


def test_missing_points_are_left_out_and_told() -> None:
    with_gaps = np.ma.masked_array(heights_m(), mask=heights_m() > 5e-9)
    found = ta.roughness(with_gaps, ("1 um", "0.75 um"))
    assert found["Sz"] < ta.roughness(heights_m(), ("1 um", "0.75 um"))["Sz"]
    assert any("without a height" in note for note in found.notes)


def test_shear_is_that_of_the_command_line() -> None:
    spectrum, steel = ta.read_psd("builtin:uncd-measured"), ta.Material("210 GPa", 0.3, counterface=ta.Material("210 GPa", 0.3))
    found = ta.tangential(spectrum, steel, friction=0.15, pressure="50 MPa", tangential_stress=["1 MPa", "5 MPa"])
    printed = command_line(
        "tangential", "builtin:uncd-measured", "--model", "persson", "--friction", "0.15", "--pressure", "50MPa",
        "--tangential-stress", "1MPa", "--tangential-stress", "5MPa", "--youngs-modulus", "210GPa", "--poisson-ratio", "0.3",
        "--counterface-youngs-modulus", "210GPa", "--counterface-poisson-ratio", "0.3",
    )  # fmt: skip
    for name in printed:
        assert np.array_equal(found[str(name)], printed[name].to_numpy(float)), name


def test_mistakes_are_named(tmp_path: Path) -> None:
    with refused_naming("size"):
        ta.roughness(heights_m())
    with refused_naming("unit"):
        ta.roughness(heights_m(), ("1 um", "0.75 um"), unit="nm")
    with refused_naming("5 mm"):
        ta.roughness(heights_m(), ("1 um", "0.75 um"), filter="5 mm")
    with refused_naming("form", "cubic"):
        ta.roughness(heights_m(), ("1 um", "0.75 um"), form="cubic")  # type: ignore[arg-type]  # pyright: ignore[reportArgumentType]
    with pytest.raises(FileNotFoundError):
        ta.roughness(tmp_path / "none.npy")
    spectrum, steel = ta.read_psd("builtin:uncd-measured"), ta.Material("210 GPa", 0.3, yield_strength="1 GPa")
    with refused_naming("friction"):
        ta.tangential(spectrum, steel, friction=-0.1, pressure="1 MPa")
    with refused_naming("ep-sphere"):
        ta.tangential(spectrum, steel, friction=0.1, pressure="1 MPa", model="ep-sphere")  # pyright: ignore[reportArgumentType]
