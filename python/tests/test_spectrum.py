"""Spectra and what is made of them: the digits of the crates, and what is refused."""

from __future__ import annotations

import pickle
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import truearea as ta
from support import REFERENCE, ROOT, Columns, numbers, refused_naming

MEASURED = str(ROOT / "data" / "uncd_psd_measured.csv")


def power_law() -> ta.Spectrum:
    q = np.geomspace(1e5, 1e9, 41)
    return ta.Spectrum(wavevectors=q, c1d=1e-22 * (q / 1e5) ** -2.6)


def test_moments_are_those_of_the_command_line_bit_for_bit(
    command_line: Callable[..., Columns], reference: Callable[[str], Columns]
) -> None:
    moments = ta.read_psd(MEASURED).moments()
    crates = command_line("moments", MEASURED)
    assert list(moments) == list(crates)
    for name in moments:
        assert np.array_equal(moments[name], numbers(crates, name), equal_nan=True), name
    exact = reference("moments_uncd_psd_measured.csv")
    for name in ("m0_m2", "m2", "m4_per_m2", "radius_m", "density_per_m2", "nayak_alpha"):
        assert np.max(np.abs(moments[name][1:] / numbers(exact, name) - 1.0)) < 1e-13, name


def test_amplitudes_and_fit_are_those_of_the_command_line(command_line: Callable[..., Columns]) -> None:
    spectrum = ta.read_psd(MEASURED)
    for definition in ("eq5", "parseval"):
        crates = command_line("amplitude", MEASURED, "--amplitude", definition)
        found = spectrum.amplitudes(amplitude=definition)
        assert all(np.array_equal(found[name], numbers(crates, name)) for name in crates)
    crates = command_line("fit", MEASURED)
    found_fit = spectrum.fit()
    assert all(np.array_equal(found_fit[name], numbers(crates, name), equal_nan=True) for name in crates)


def test_a_spectrum_of_arrays_keeps_them() -> None:
    q, c = np.array([1e6, 1e5, 1e7]), np.array([2.0, 1.0, 3.0])
    spectrum = ta.Spectrum(wavevectors=q, c1d=c, c1d_se=[0.1, np.nan, 0.3])
    assert np.array_equal(spectrum.wavelengths_m, 2.0 * np.pi / np.sort(q))
    assert np.array_equal(spectrum.c1d_m3, [1.0, 2.0, 3.0])
    assert spectrum.c1d_se_m3 is not None
    assert np.array_equal(spectrum.c1d_se_m3, [np.nan, 0.1, 0.3], equal_nan=True)
    assert len(spectrum) == 3 and power_law().c1d_se_m3 is None
    frequency = ta.Spectrum(q, 2.0 * c, convention="frequency")
    assert np.allclose(frequency.c1d_m3, spectrum.c1d_m3, rtol=1e-15)


def test_resampling_and_cutoff_are_taken() -> None:
    spectrum = power_law()
    coarse = spectrum.moments(scales_per_decade=5)
    assert coarse.wavelength_m.size == 21
    cut = spectrum.moments(cutoff="1 um")
    assert cut.wavelength_m[-1] >= 1e-6 > spectrum.wavelengths_m[-1]
    assert spectrum.moments(normalisation="as-printed").m0_m2[-1] == pytest.approx(np.pi * spectrum.moments().m0_m2[-1])


@pytest.mark.parametrize(
    ("given", "told"),
    [
        ({"c1d": [1.0, 2.0]}, "3 2"),
        ({"wavevectors": [1.0, -2.0, 3.0]}, "wavevectors: -2.0"),
        ({"wavevectors": [1.0, np.nan, 3.0]}, "wavevectors: nan"),
        ({"c1d": [1.0, 0.0, 3.0]}, "row 2"),
        ({"c1d": [[1.0, 2.0, 3.0]]}, "c1d: 2"),
        ({"c1d": ["1", "2", "3"]}, "c1d[0]: numbers"),
        ({"c1d": []}, "3 0"),
        ({"wavevectors": [1.0, 1.0, 3.0]}, "wavelength"),
        ({"c1d_se": [0.1, -0.1, 0.1]}, "error"),
        ({"convention": "c2d"}, "convention: 'c2d' c1d"),
    ],
)
def test_bad_samples_are_refused(given: dict[str, Any], told: str) -> None:
    good: dict[str, Any] = {"wavevectors": [1.0, 2.0, 3.0], "c1d": [3.0, 2.0, 1.0]}
    with refused_naming(*told.split()):
        ta.Spectrum(**{**good, **given})


def test_files_are_read_or_refused_with_what_mends_them(tmp_path: Path) -> None:
    with refused_naming("none.csv", by=FileNotFoundError):
        ta.read_psd(tmp_path / "none.csv")
    with refused_naming("builtin:none:", "builtin:uncd"):
        ta.read_psd("builtin:none")
    bad = tmp_path / "bad.csv"
    bad.write_text("wavelength_m,C1D_m3\n1e-6,1e-20\n1e-7,-3\n")
    with refused_naming("bad.csv", "line", "3", "-3"):
        ta.read_psd(bad)
    empty = tmp_path / "empty.csv"
    empty.write_bytes(b"")
    with refused_naming("empty.csv"):
        ta.read_psd(empty)
    nameless = tmp_path / "nameless.csv"
    nameless.write_text("q (1/m),PSD (m^4)\n1e6,1e-30\n1e7,1e-34\n1e8,1e-38\n1e9,1e-42\n")
    with refused_naming("convention"):
        ta.read_psd(nameless)
    assert len(ta.read_psd(nameless, convention="ciso")) > 0


def test_spectra_come_back_from_pickles_bit_for_bit() -> None:
    from_file = ta.read_psd(REFERENCE / "psd_synthetic.csv")
    both = from_file.against(ta.read_psd("builtin:uncd-measured"))
    for spectrum in (power_law(), from_file, both):
        again = pickle.loads(pickle.dumps(spectrum))
        assert np.array_equal(again.c1d_m3, spectrum.c1d_m3) and again.notes == spectrum.notes
        assert again.remarks == spectrum.remarks and again.name == spectrum.name


def test_a_spectrum_shows_itself() -> None:
    spectrum = power_law()
    assert repr(spectrum) == "Spectrum('spectrum', 41 samples from 6.283e-05 m to 6.283e-09 m)"
    assert spectrum._repr_html_().startswith("<div><svg")
    table = spectrum.moments()
    assert table.to_pandas().shape == (41, 9) and "row: 41" in repr(table)
    assert table.to_xarray()["m0_m2"].attrs["units"] == "m²"


def test_a_spectrum_is_a_table() -> None:
    spectrum = ta.read_psd("builtin:uncd-measured")
    frame = spectrum.to_pandas()
    assert frame.attrs["name"] == spectrum.name and np.array_equal(frame["c1d_m3"], spectrum.c1d_m3)
    data = spectrum.to_xarray()
    assert data["c1d_m3"].attrs == {"long_name": "c1d", "units": "m³"}
    band = data.sel(wavelength_m=slice(1e-6, 1e-7))
    assert 0 < band.sizes["wavelength_m"] < len(spectrum)
    assert float(band["wavelength_m"].max()) <= 1e-6


def test_spectra_are_values_that_add() -> None:
    one, other = ta.read_psd("builtin:uncd-measured"), ta.read_psd("builtin:uncd-reconstructed")
    assert one == ta.read_psd("builtin:uncd-measured") and hash(one) == hash(ta.read_psd("builtin:uncd-measured"))
    assert one != other and one != 5
    assert one + other == one.against(other)
    with pytest.raises(TypeError):
        one + 5  # type: ignore[operator]
