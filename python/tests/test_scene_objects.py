"""Scenes from objects: the same numbers as scenes of files, and what is refused."""

from __future__ import annotations

import pickle
from pathlib import Path

import numpy as np
import pytest

import truearea as ta


def trace(seed: int) -> np.ndarray:
    """Heights [m] of a self-affine line of 2,048 points."""
    rng = np.random.default_rng(seed)
    amplitudes = np.arange(1.0, 1025.0) ** -1.4 * np.exp(2j * np.pi * rng.random(1024))
    heights = np.fft.irfft(np.concatenate([[0.0], amplitudes]), 2048)
    found: np.ndarray = 3e-7 * heights / heights.std()
    return found


def files(folder: Path) -> list[str]:
    for seed in range(3):
        np.savetxt(folder / f"trace-{seed}.txt", np.column_stack([0.1 * np.arange(2048), 1e6 * trace(seed)]))
    return [f"{folder / f'trace-{seed}.txt'}:unit=um" for seed in range(3)]


def area(results: ta.SceneResults, curve: str = "persson") -> float:
    return float(results.tables[curve].area_fraction[-1])


def test_a_spectrum_gives_the_numbers_of_the_scene_that_names_it(tmp_path: Path) -> None:
    spectrum = ta.read_psd("builtin:uncd-measured").between("10 um", "10 nm")
    scene = ta.Scene(spectrum, "100Cr6", pressure=["1 MPa", 5e6], curves=["persson", {"model": "hertz"}], interface=True)
    found = scene.run()
    assert scene.to_toml(tmp_path / "scene.toml") == scene.text
    again = ta.Scene.from_toml(tmp_path / "scene.toml").run()
    assert area(found) == area(again) > 0.0
    assert found.tables["report-interface"] == again.tables["report-interface"]
    assert [load["nominal_pressure_pa"] for load in found.conclusions["loads"]] == [1e6, 5e6]
    assert pickle.loads(pickle.dumps(scene)) == scene
    assert area(scene.replace(pressure=["2 MPa"]).run(report=False)) == pytest.approx(0.4 * area(found), rel=1e-3)


def test_scans_in_memory_and_in_files_give_one_answer_with_an_interval(tmp_path: Path) -> None:
    of_files = ta.Scene(files(tmp_path), "100Cr6", pressure="10 MPa", curves=["persson"], cutoff="1 um").run()
    scans = [(trace(seed), 2048 * 1e-7) for seed in range(3)]
    in_memory = ta.Scene(scans, "100Cr6", pressure="10 MPa", curves=["persson"], cutoff="1 um").run()
    assert area(in_memory) == pytest.approx(area(of_files), rel=1e-6)
    for found in (of_files, in_memory):
        interval = found.tables["report-uncertainty"]
        assert bool(interval.low[0] < interval.area_fraction[0] < interval.high[0])


def test_a_report_is_that_of_the_command(tmp_path: Path) -> None:
    found = ta.report(files(tmp_path), "100Cr6", counterface="100Cr6", pressure="10 MPa", out=tmp_path / "found")
    written = {path.name for path in (tmp_path / "found").iterdir()}
    assert {"report.html", "answer.json", "scene.toml", "report-uncertainty.csv", "area-fraction.py"} <= written
    assert found.conclusions["loads"][0]["area"]["low"] > 0.0
    again = ta.Scene.from_toml(tmp_path / "found" / "scene.toml").run(judge=False, uncertainty=False)
    assert area(again) == area(found)


def test_a_counterface_of_a_material_counts_by_its_elastic_constants() -> None:
    spectrum = ta.read_psd("builtin:uncd-measured")
    steel = ta.Material("210 GPa", 0.3, counterface=ta.Material("70 GPa", 0.33, yield_strength="100 MPa"))
    found = ta.Scene(spectrum, steel, pressure="1 MPa", curves=["persson"]).run(report=False)
    assert area(found) == ta.persson(spectrum, steel, pressure="1 MPa").area_fraction[0, -1]


def test_units_reach_the_scene() -> None:
    pint = pytest.importorskip("pint")
    u = pint.UnitRegistry()
    scene = ta.Scene("builtin:uncd-measured", ta.Material(210 * u.GPa, 0.3), pressure=[5 * u.MPa, 6e6], curves=["persson"])
    assert 'pressures = ["5 MPa", "6 MPa"]' in scene.text and 'youngs_modulus = "210 GPa"' in scene.text


@pytest.mark.parametrize(
    ("arguments", "naming"),
    [
        ({"surface": 3}, "surface"),
        ({"surface": "builtin:none"}, "builtin:uncd-measured"),
        ({"surface": np.ones((4, 4))}, "size"),
        ({"surface": "builtin:uncd-measured", "size": 1.0}, "size"),
        ({"material": "1000Cr6"}, "1000Cr6"),
        ({"material": 5}, "material"),
        ({"material": {"youngs_modlus": "1 GPa"}}, "youngs_modulus"),
        ({"pressure": {1e6}}, "pressure"),
        ({"curves": ["perssn"]}, "persson"),
        ({"seal": {"viscosty": 1.0}}, "viscosity"),
    ],
)
def test_mistakes_are_named(arguments: dict[str, object], naming: str) -> None:
    given = {"surface": "builtin:uncd-measured", "material": "diamond", "pressure": 1e6, **arguments}
    surface, material = given.pop("surface"), given.pop("material")
    with pytest.raises(ta.InputError, match=naming):
        ta.Scene(surface, material, **given)  # type: ignore[arg-type]


def test_a_missing_file_is_named(tmp_path: Path) -> None:
    with pytest.raises(FileNotFoundError, match="none.csv"):
        ta.Scene(tmp_path / "none.csv", "diamond", pressure=1e6)


def test_a_composite_in_memory_keeps_the_scatter_of_its_scans_in_the_file_of_its_scene(tmp_path: Path) -> None:
    random = np.random.default_rng(3)
    heights_m = [1e-9 * random.standard_normal((48, 48)).cumsum(1) for _ in range(3)]
    gappy = np.ma.masked_array(heights_m[2], mask=np.zeros((48, 48), dtype=bool))
    gappy[3:5, 7:9] = np.ma.masked
    np.save(tmp_path / "file.npy", 1e9 * heights_m[1])
    scan = ta.read_scan(tmp_path / "file.npy", unit="nm", size="1 um")
    surface = ta.composite([(heights_m[0], "1 um"), scan, (gappy, ("1 um", 1e-6))], tip_radius="8 nm", z_calibration="2 %", instrument="AFM")
    scene = ta.Scene(surface, "100Cr6", pressure="10 MPa", curves=["persson"], uncertainty={"draws": 200})
    assert "scan-1.npy" in scene.text and "surface.csv" not in scene.text and not any("to_toml" in note for note in scene.notes)
    scene.to_toml(tmp_path / "out" / "scene.toml")
    again = ta.Scene.from_toml(tmp_path / "out" / "scene.toml")
    here, there = (one.run(report=False, uncertainty=True).tables["report-uncertainty"] for one in (scene, again))
    for name in ("area_fraction", "low", "high", "median"):
        np.testing.assert_allclose(here[name], there[name], rtol=1e-9)
    # What no file can say leaves the spectrum, and a note tells what is lost.
    periodic = ta.Spectrum.from_heights(heights_m[0], "1 um", periodic=True)
    lossy = ta.Scene(periodic, "100Cr6", pressure="10 MPa")
    assert "surface.csv" in lossy.text and "scene.scans-in-memory" in [getattr(note, "code", "") for note in lossy.notes]
