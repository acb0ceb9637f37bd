"""Pictures by Matplotlib."""

from __future__ import annotations

import sys

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
