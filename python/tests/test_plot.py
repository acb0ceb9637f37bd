"""Pictures by Matplotlib."""

from __future__ import annotations

import pickle
import re
import sys
from pathlib import Path
from typing import Any

import matplotlib
import numpy as np
import pytest

import truearea as ta
from truearea._choices import CurveModel
from truearea._plot import style_of

matplotlib.use("Agg")


def test_a_spectrum_is_drawn_with_its_holes() -> None:
    import matplotlib.pyplot as plt

    q = np.concatenate([np.geomspace(1e4, 1e5, 20), np.geomspace(1e7, 1e8, 20)])
    spectrum = ta.Spectrum(q, 1e-22 * (q / 1e5) ** -2.6, name="mine")
    assert len(spectrum.holes_m) == 1
    ax = spectrum.plot()
    assert ax.lines[0].get_label() == "mine" and len(ax.patches) == 1
    drawn = np.asarray(ax.lines[0].get_ydata())
    assert np.array_equal(drawn[~np.isnan(drawn)], spectrum.c1d_m3) and np.isnan(drawn[20])
    other = ta.read_psd("builtin:uncd-measured")
    assert other.plot(ax) is ax and len(ax.lines) == 2 and not ax.xaxis_inverted()
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
    scales = ta.roughness(heights_m, "1 um", scales=True)
    assert np.array_equal(np.asarray(scales.plot().lines[0].get_ydata()), scales.rms_gradient_spectrum, equal_nan=True)
    plt.close("all")


def test_pictures_side_by_side_share_no_id_and_tell_models_and_loads_apart(tmp_path: Path) -> None:
    import matplotlib.pyplot as plt

    diamond = ta.Material("463 GPa", 0.2, yield_strength="1.8 GPa")
    spectrum = ta.read_psd("builtin:uncd-measured")
    heights_m = 1e-9 * np.random.default_rng(1).standard_normal((32, 32)).cumsum(1)
    np.save(tmp_path / "map.npy", heights_m)
    np.save(tmp_path / "line.npy", heights_m[0])
    models: tuple[CurveModel, ...] = ("elastic-plastic", "persson", "hertz")
    loads = ["5.4 MPa", "54 MPa"]
    found = ta.uncertainty(spectrum, diamond, pressure=loads, model=models, draws=50, youngs_modulus="5 %")
    shown: list[Any] = [found, spectrum, ta.persson(spectrum, diamond, pressure=loads), ta.roughness(heights_m, "1 um", scales=True)]
    shown += [ta.read_scan(tmp_path / name, unit="m", size="1 um") for name in ("map.npy", "line.npy")]
    shown += [ta.boundary_elements(heights_m, diamond, pressure=loads, size="1 um", fields=fields) for fields in (True, False)]
    page = "".join(one._repr_html_() for one in [*shown, *shown])
    ids = re.findall(r"\sid=[\"']([^\"']*)", page)
    assert page.count("<svg") == 2 * len(shown) and len(set(ids)) == len(ids)
    colours = [style_of(model)["color"] for model in models]
    bands = re.findall(r'class="band"[^>]*fill="(#\w+)"', found._repr_html_())
    assert sorted(bands) == sorted(2 * colours)
    ax = found.plot()
    faces = [tuple(np.ravel(band.get_facecolor())) for band in ax.collections]
    assert len(set(faces)) == 6 and len({face[:3] for face in faces}) == 3
    assert len({(line.get_color(), line.get_alpha()) for line in ax.lines}) == 6
    assert len(set(ax.get_legend_handles_labels()[1])) == 6
    plt.close("all")


def test_axes_have_units_of_a_few_digits_and_lines_have_names() -> None:
    import matplotlib.pyplot as plt

    spectrum, steel = ta.read_psd("builtin:uncd-measured"), ta.Material("100Cr6")
    heights_m = 1e-9 * np.random.default_rng(1).standard_normal((3, 32, 32)).cumsum(2)
    maps = ta.boundary_elements(heights_m, steel, pressure=["1 MPa", "50 MPa"], size="1 um")
    held = ta.statistical(spectrum, steel, model="hertz", separation=["10 nm", "60 nm"])
    gaps = [ta.gap(spectrum, steel, pressure=[1e6, 1e7], model=model) for model in ("persson", "hertz")]
    ax = gaps[0].plot()
    gaps[1].plot(ax)
    plt.gcf().draw_without_rendering()
    ticks = [tick.get_text() for axis in (ax.xaxis, ax.yaxis) for tick in axis.get_ticklabels() + axis.get_ticklabels(minor=True)]
    assert {"MPa", "nm"} <= {text.split()[-1] for text in ticks if text} <= {"kPa", "MPa", "nm"}
    assert ax.get_xlabel() == "nominal pressure" and ax.get_legend_handles_labels()[1] == [style_of(m)["label"] for m in ("persson", "hertz")]
    assert pickle.loads(pickle.dumps(gaps[0])).model == "persson"
    assert maps.plot().get_legend_handles_labels()[1] == ["map 1", "map 2", "map 3"]
    drawn = held.plot()
    assert [label.split(", ")[-1] for label in drawn.get_legend_handles_labels()[1]] == ["separation 10 nm", "separation 60 nm"]
    assert min(np.nanmin(np.asarray(line.get_ydata(), dtype=float)) for line in drawn.lines) >= 1e-12
    fields = ta.boundary_elements(heights_m[0], steel, pressure=["1 MPa", "50 MPa"], size="1 um", fields=True)
    assert fields.plot().get_title() == "at 50 MPa"
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
