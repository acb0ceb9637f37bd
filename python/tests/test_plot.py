"""Pictures by Matplotlib."""

from __future__ import annotations

import pickle
import sys
from pathlib import Path

import matplotlib
import numpy as np
import pytest

import truearea as ta
from truearea._plot import style_of

matplotlib.use("Agg")


def test_a_spectrum_is_drawn_with_its_holes() -> None:
    import matplotlib.pyplot as plt

    q = np.concatenate([np.geomspace(1e4, 1e5, 20), np.geomspace(1e7, 1e8, 20)])
    spectrum = ta.Spectrum(q, 1e-22 * (q / 1e5) ** -2.6, name="mine")
    assert len(spectrum.holes_m) == 1
    ax = spectrum.plot()
    assert ax.lines[0].get_label() == "mine" and len(ax.patches) == 1
    assert np.array_equal(np.asarray(ax.lines[0].get_ydata()), spectrum.c1d_m3)
    other = ta.read_psd("builtin:uncd-measured")
    assert other.plot(ax) is ax and len(ax.lines) == 2 and ax.xaxis_inverted()
    plt.close("all")


def test_every_model_has_a_style_of_its_own() -> None:
    styles = [style_of(str(model)) for model in ta.models().model]
    assert len({str(style) for style in styles}) == len(styles)
    assert [style["label"] for style in styles] == list(ta.models().short_name)


def test_without_matplotlib_the_error_says_what_to_install(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "matplotlib.pyplot", None)
    with pytest.raises(ImportError, match=r"truearea\[plot\]"):
        ta.read_psd("builtin:uncd-measured").plot()


def test_curves_of_loads_are_drawn_in_the_colour_of_their_model() -> None:
    import matplotlib.pyplot as plt

    spectrum, steel = ta.read_psd("builtin:uncd-measured"), ta.Material("100Cr6")
    curve = ta.stacked(spectrum, steel, pressure=["5 MPa", "50 MPa"])
    ax = curve.plot()
    assert [line.get_color() for line in ax.lines] == [style_of("elastic-plastic")["color"]] * 2
    assert np.array_equal(np.asarray(ax.lines[1].get_ydata()), curve.area_fraction[1])
    persson = ta.persson(spectrum, steel, pressure="5 MPa", model="persson-plastic")
    assert persson.model == "persson-plastic" and pickle.loads(pickle.dumps(persson)).model == persson.model
    assert persson.plot(ax) is ax and len(ax.lines) == 3
    plt.close("all")


def test_gaps_laws_scans_maps_and_intervals_are_drawn(tmp_path: Path) -> None:
    import matplotlib.pyplot as plt

    spectrum, steel = ta.read_psd("builtin:uncd-measured"), ta.Material("100Cr6")
    gaps = ta.gap(spectrum, steel, pressure=[1e6, 1e7])
    assert np.array_equal(np.asarray(gaps.plot().lines[0].get_ydata()), gaps.mean_gap_m)
    law = ta.law(spectrum, steel, pressure=["1 MPa", "100 MPa"])
    assert np.array_equal(np.asarray(law.plot().lines[0].get_xdata()), law.overclosure_m)
    heights_m = 1e-9 * np.random.default_rng(1).standard_normal((32, 32)).cumsum(1)
    heights_nm = heights_m * 1e9
    heights_nm[3:9, 5:20] = np.nan
    np.save(tmp_path / "map.npy", heights_nm)
    np.save(tmp_path / "line.npy", heights_m[0] * 1e9)
    scan = ta.read_scan(tmp_path / "map.npy", unit="nm", size="1 um")
    (picture,) = scan.plot().images
    assert np.ma.is_masked(np.ma.masked_invalid(np.asarray(picture.get_array()))) and picture.get_extent()[1] == 1e-6
    assert len(ta.read_scan(tmp_path / "line.npy", unit="nm", size="1 um").plot().lines) == 1
    pressed = ta.boundary_elements(heights_m, steel, pressure="1 MPa", size="1 um", fields=True)
    assert len(pressed.plot().images) == 1
    without = ta.boundary_elements(heights_m, steel, pressure=["1 MPa", "2 MPa"], size="1 um")
    assert np.allclose(np.asarray(without.plot().lines[0].get_xdata()), [1e6, 2e6])
    composite = ta.composite([(heights_m, "1 um"), (heights_m[::-1] * 1.1, "1 um"), (heights_m.T, "1 um")])
    found = ta.uncertainty(composite, steel, pressure="5 MPa", model=["persson", "hertz"])
    assert len(found.plot().collections) == 2
    plt.close("all")


def test_a_scene_is_drawn_with_the_answer_and_its_range() -> None:
    import matplotlib.pyplot as plt

    found = ta.Scene("builtin:uncd-measured", "100Cr6", pressure=["1 MPa", "10 MPa"]).run(uncertainty=False)
    ax = found.plot(1)
    labels = ax.get_legend_handles_labels()[1]
    assert labels[-1] == "boundary elements" and "Persson, elastic, algebraic-nayak" in labels
    area = found.conclusions["loads"][1]["area"]
    assert area["low"] <= area["area_fraction"] <= area["high"]
    with pytest.raises(ta.InputError, match="load"):
        found.plot(2)
    again = pickle.loads(pickle.dumps(found))
    assert again == found and len(again.plot().lines) == len(found.plot().lines)
    plt.close("all")
