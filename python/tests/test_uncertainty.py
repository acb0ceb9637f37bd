"""Uncertainty: the digits of scenes, what is drawn, and what is refused."""

from __future__ import annotations

import pickle
import signal
import threading
import time
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import truearea as ta
from support import refused_naming

DIAMOND = ta.Material("463 GPa", 0.2, yield_strength="1.8 GPa")


def saved_scans(folder: Path) -> list[Path]:
    """Three scans of a rough plate and one of another instrument."""
    paths = []
    for seed in range(4):
        h = 2e-9 * np.random.default_rng(seed).standard_normal((48, 64)).cumsum(axis=1)
        np.save(folder / f"{seed}.npy", h)
        paths.append(folder / f"{seed}.npy")
    return paths


def measured() -> ta.Spectrum:
    """A spectrum with standard errors."""
    q = np.geomspace(1e5, 1e9, 30)
    c = 1e-22 * (q / 1e5) ** -2.6
    return ta.Spectrum(q, c, 0.2 * c)


def quick(**options: Any) -> ta.Uncertainty:
    given: dict[str, Any] = {"pressure": "1 MPa", "model": "elastic-plastic", "draws": 60}
    return ta.uncertainty(measured(), DIAMOND, **{**given, **options})


def test_intervals_are_those_of_the_scene(tmp_path: Path) -> None:
    paths = saved_scans(tmp_path)
    scans = ", ".join(
        f'{{ file = "{path.name}", unit = "m", size = "4 um", instrument = "{"AFM" if at < 3 else "stylus"}", '
        f'z_calibration = "{3 if at < 3 else 5} %" }}'
        for at, path in enumerate(paths)
    )
    scene = tmp_path / "scene.toml"
    scene.write_text(
        f"""
        [surface]
        scans = [{scans}]
        [material]
        youngs_modulus = "463 GPa +- 5 %"
        poisson_ratio = "0.2 +- 0.02"
        yield_strength = "1.8 GPa +- 0.2 GPa"
        [loads]
        pressures = ["1 MPa", "1e-2 H"]
        [uncertainty]
        draws = 80
        seed = 7
        level = 0.9
        [[curve]]
        model = "elastic-plastic"
        [[curve]]
        model = "hertz"
        """
    )
    tables = ta.Scene.from_toml(scene).run(judge=False, uncertainty=True).tables
    surface = ta.composite(
        paths, unit="m", size="4 um", instrument=["AFM"] * 3 + ["stylus"], z_calibration=["3 %"] * 3 + [0.05]
    )
    found = ta.uncertainty(
        surface,
        DIAMOND,
        pressure=["1 MPa", "1e-2 H"],
        model=["elastic-plastic", "hertz"],
        draws=80,
        seed=7,
        level=0.9,
        youngs_modulus="5 %",
        poisson_ratio=0.02,
        yield_strength="+- 0.2 GPa",
    )
    of_scene = tables["report-uncertainty"]
    for name in ("area_fraction", "median", "low", "high", "monte_carlo_error"):
        # Rows of the scene are those of a curve under every load, curve after curve.
        assert np.array_equal(found[name].T.reshape(-1), of_scene[name]), name
    assert found.low.shape == (2, 2) and found.axes("low") == ("load", "model")
    assert list(found["model"]) == ["elastic-plastic", "hertz"]
    indices = tables["report-sobol"]
    for name in indices:
        if name in ("curve", "group"):
            assert list(found.shares[name]) == list(indices[name])
        else:
            assert np.array_equal(found.shares[name], indices[name], equal_nan=True), name
    advice = tables["report-advice"]
    assert list(found.advice.step) == list(advice["step"])
    assert np.array_equal(found.advice.width_ratio, advice["width_ratio"])
    assert set(found.shares.group) == {"scans", "instruments", "material", "strength"}
    assert any("one stylus scan" in note for note in found.notes)
    assert found.draws == 80


def test_scans_are_taken_in_place_of_a_spectrum(tmp_path: Path) -> None:
    paths = saved_scans(tmp_path)[:3]
    maps = [(np.load(path), (4e-6, 3e-6)) for path in paths]
    of_arrays = ta.uncertainty(maps, DIAMOND, pressure=1e6, model="elastic", draws=40)
    of_files = ta.uncertainty(
        ta.composite(paths, unit="m", size="4 um"), DIAMOND, pressure=1e6, model="elastic", draws=40
    )
    assert np.array_equal(of_arrays.low, of_files.low) and np.array_equal(of_arrays.high, of_files.high)
    assert any("Height calibration of memory " in note and "assumed" in note for note in of_arrays.notes)


def test_one_model_has_the_axis_of_loads_alone() -> None:
    found = quick(pressure=[1e6, 2e6])
    assert found.low.shape == (2,) and found.axes("low") == ("load",)
    assert np.all(found.low < found.median) and np.all(found.median < found.high)
    assert np.all(found.low < found.low_68) and np.all(found.high_68 < found.high)
    assert found.area_fraction == pytest.approx(
        ta.stacked(measured(), DIAMOND, pressure=[1e6, 2e6]).area_fraction[:, -1], rel=0
    )
    bands = found.bands
    assert set(bands.nominal_pressure_pa) == {1e6, 2e6}
    of_first = bands.nominal_pressure_pa == 1e6
    assert np.all(np.diff(bands.wavelength_m[of_first]) < 0) and np.all(bands.low <= bands.high)
    assert found.to_pandas().shape == (2, 9)
    assert found.to_xarray().sizes == {"load": 2}
    assert found.advice.rank[0] == 1.0 and "the interval" in found.advice.in_words[0]


def test_draws_are_their_seed_and_no_threads() -> None:
    before = ta.threads()
    found = quick()
    try:
        ta.set_threads(1)
        assert quick() == found
    finally:
        ta.set_threads(before)
    assert quick(seed=2).low[0] != found.low[0]
    assert quick(level=0.5).low[0] > found.low[0]


def test_pickles_keep_the_tables() -> None:
    found = quick()
    again = pickle.loads(pickle.dumps(found))
    assert again == found and again.notes == found.notes and again.draws == found.draws
    assert again.shares == found.shares and again.advice == found.advice and again.bands == found.bands


def test_uncertainties_are_read_as_in_scenes() -> None:
    exact = ta.read_psd("builtin:uncd-measured")

    def high(**options: Any) -> float:
        found = ta.uncertainty(exact, DIAMOND, pressure="1 MPa", model="elastic-plastic", draws=40, **options)
        return float(found.high[0])

    assert high(youngs_modulus="10 %") == high(youngs_modulus="46.3 GPa") == high(youngs_modulus="± 46.3 GPa")
    assert high(youngs_modulus="10 %") == high(youngs_modulus=46.3e9)
    assert high(youngs_modulus="10 %") != high(youngs_modulus="5 %")
    of_counterface = DIAMOND.replace(counterface=ta.Material("210 GPa", 0.3))
    found = ta.uncertainty(
        exact, of_counterface, pressure=1e6, model="elastic", draws=40, counterface_youngs_modulus="10 %"
    )
    assert list(found.shares.group) == ["material"]
    assert any("no standard errors" in note for note in found.notes)


def test_progress_is_told() -> None:
    told: list[int] = []
    quick(progress=lambda done, of: told.append(done))
    assert told and told == sorted(told) and told[-1] >= 60


def test_what_cannot_be_drawn_is_told() -> None:
    exact = ta.read_psd("builtin:uncd-measured")
    with refused_naming("nothing", "scatter", "composite"):
        ta.uncertainty(exact, DIAMOND, pressure=1e6, model="elastic")
    refusals: list[tuple[dict[str, Any], str]] = [
        ({"draws": 19}, "draws 19;"),
        ({"draws": 100.5}, "draws 100.5;"),
        ({"draws": "many"}, "draws: number"),
        ({"seed": -1}, "seed -1;"),
        ({"level": 1.0}, "level 1;"),
        ({"shares_draws": 10}, "shares_draws 10;"),
        ({"model": "archard"}, "model: 'archard' elastic, elastic-plastic"),
        ({"model": []}, "model: empty"),
        ({"model": ["hertz", "hertz"]}, "model[1] hertz"),
        ({"model": "hertz", "strain_gradient": True}, "strain_gradient hertz"),
        ({"pressure": []}, "pressure: empty"),
        ({"pressure": -1.0}, "pressure -1;"),
        ({"youngs_modulus": "5 nm"}, "youngs_modulus: "),
        ({"poisson_ratio": 0.4}, "poisson_ratio: "),
        ({"yield_strength": "5 %", "indentation_hardness": "5 %"}, "both uncertainty"),
        ({"indentation_hardness": "5 %"}, "indentation_hardness value"),
        ({"counterface_youngs_modulus": "5 %"}, "counterface_youngs_modulus"),
        ({"cutoff": 1e-30}, "cutoff"),
        ({"tolerance": 1.0}, "tolerance"),
        ({"normalisation": "x"}, "normalisation: "),
        ({"model": 3}, "model: name"),
    ]
    for options, words in refusals:
        with refused_naming(*words.split()):
            quick(**options)
    with refused_naming("tolerance:", "number", "str"):
        quick(tolerance="x")
    given: Any = None
    with refused_naming("surface: ", "Spectrum", "scans"):
        ta.uncertainty(given, DIAMOND, pressure=1e6, model="elastic")


def test_ctrl_c_ends_the_draws() -> None:
    def press() -> None:
        time.sleep(0.3)
        signal.raise_signal(signal.SIGINT)

    begun = time.monotonic()
    presser = threading.Thread(target=press)
    presser.start()
    with pytest.raises(KeyboardInterrupt):
        quick(draws=1_000_000, model=["elastic-plastic", "ep-sine"])
    presser.join()
    assert time.monotonic() - begun < 20.0


def test_one_model_of_several_is_drawn() -> None:
    pytest.importorskip("matplotlib").use("agg")
    spectrum = ta.read_psd("builtin:uncd-measured")
    models: list[ta.CurveModel] = ["elastic", "persson"]
    found = ta.uncertainty(spectrum, ta.Material("210 GPa", 0.3), pressure=["1 MPa", "2 MPa"], model=models, draws=20, youngs_modulus="5 %")
    both, one = found.plot(), found.plot(model="persson")
    assert (len(both.lines), len(one.lines)) == (4, 2)
    drawn = np.asarray(one.lines[0].get_ydata())
    assert np.array_equal(drawn, found.bands.median[found.bands.curve == "persson"][: drawn.size])
    with refused_naming("model", "hertz"):
        found.plot(model="hertz")


def test_options_that_no_model_has_are_refused() -> None:
    spectrum = ta.read_psd("builtin:uncd-measured")
    given: dict[str, dict[str, Any]] = {
        "normalisation": {"normalisation": "as-printed"},
        "tolerance": {"tolerance": 1e-3},
        "amplitude": {"amplitude": "parseval", "model": "hertz"},
        "shares_draws": {"shares_draws": 80},
    }
    usual: dict[str, Any] = {"pressure": "1 MPa", "model": "elastic", "draws": 20, "youngs_modulus": "5 %"}
    for name, options in given.items():
        with refused_naming(name):
            ta.uncertainty(spectrum, ta.Material("210 GPa", 0.3), **(usual | options))
    # The counterface flows, and the strength of the rough body does not count.
    silver = ta.Material("silver", counterface=ta.Material("gold"))
    spread: dict[str, Any] = {**usual, "model": "elastic-plastic", "indentation_hardness": "5 %"}
    with refused_naming("indentation_hardness"):
        ta.uncertainty(spectrum, silver, **spread)


def test_advice_is_shown_with_its_model() -> None:
    maps = [(1e-9 * np.random.default_rng(seed).standard_normal((32, 32)).cumsum(1), "1 um") for seed in range(2)]
    models: list[ta.CurveModel] = ["elastic", "persson"]
    found = ta.uncertainty(ta.composite(maps, instrument="AFM"), ta.Material("210 GPa", 0.3), pressure="1 MPa", model=models, draws=20)
    shown = found.advice._repr_html_()
    assert found.advice.in_words[0] in shown and all(f"{model} at 1 MPa" in shown for model in models)


def test_a_cutoff_between_samples_leaves_statistical_models_an_area() -> None:
    spectrum, steel = ta.read_psd("builtin:uncd-measured"), ta.Material("210 GPa", 0.3)
    for model in ("hertz", "bgt"):
        given: Any = {"pressure": "1 MPa", "model": model, "cutoff": "200 nm"}
        found = ta.uncertainty(spectrum, steel, draws=100, youngs_modulus="1 %", **given)
        area = ta.statistical(spectrum, steel, **given).area_fraction[0, -1]
        assert found.area_fraction[0] == pytest.approx(area, rel=1e-12) and found.low[0] < area < found.high[0]
