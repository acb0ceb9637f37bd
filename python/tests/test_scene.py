"""Scenes: the same files as the command line writes, what is refused and where, and keys set anew."""

from __future__ import annotations

import os
import pickle
import signal
import subprocess
import threading
import time
from pathlib import Path

import numpy as np
import pytest

import truearea as ta
from support import ROOT, columns_of, numbers, refused_naming, words
from truearea._choices import Template

SCENE = """# Two lines of its own.
title = "Steel on glass"

[surface]
psd = "spectrum.csv"

[material]
youngs_modulus = "210 GPa"   # from a book
poisson_ratio = 0.3
yield_strength = "1 GPa"

[loads]
pressures = ["1 MPa", "1e-2 H"]

[[curve]]
model = "elastic"

[[curve]]
model = "ep-sphere"

[[figure]]
name = "areas"
shows = "area"
"""


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A scene and the spectrum that it names."""
    q = np.geomspace(1e5, 1e9, 30)
    rows = "".join(f"{wavevector!r},{c1d!r}\n" for wavevector, c1d in zip(q.tolist(), (1e-22 * (q / 1e5) ** -2.6).tolist()))
    (tmp_path / "spectrum.csv").write_text("Wavevector (1/m),C1D_m3\n" + rows)
    (tmp_path / "scene.toml").write_text(SCENE)
    return tmp_path


def quick(scene: ta.Scene) -> ta.SceneResults:
    return scene.run(judge=False, uncertainty=False)


def test_files_are_those_of_the_command_line(folder: Path) -> None:
    program = os.environ.get("TRUEAREA_PROGRAM")
    manifest = str(ROOT / "Cargo.toml")
    call = [program] if program else ["cargo", "run", "--quiet", "--manifest-path", manifest, "--bin", "truearea", "--"]
    out = folder / "out"
    done = subprocess.run(
        [*call, "run", str(folder / "scene.toml"), "--no-judge", "--no-uncertainty", "--out", str(out)],
        check=True, capture_output=True, text=True,
    )  # fmt: skip
    results = quick(ta.Scene.from_toml(folder / "scene.toml"))
    assert done.stdout.splitlines()[0].startswith(ta.Scene.from_toml(folder / "scene.toml").title)
    # The command line keeps a record of what it wrote, to replace no other file.
    written = {path.name: path.read_bytes() for path in out.iterdir() if path.name != ".truearea-files"}
    assert sorted(written) == sorted(results.files)
    assert len(written) == 9
    for name, content in written.items():
        if name == "report.html":
            assert results.report_html is not None
            assert abs(len(content) - len(results.report_html.encode())) < 1000
        else:
            assert results.files[name] == content, name


@pytest.mark.parametrize("name", ["uncd-measured", "uncd-reconstructed"])
def test_figures_are_the_committed_ones(name: Template) -> None:
    results = ta.Scene.template(name).run(report=False, judge=False, uncertainty=False)
    compared = 0
    for path in (ROOT / "tests" / "golden").glob(f"{name}__*.snap"):
        committed = columns_of(path.read_text(encoding="utf-8").split("---\n", 2)[2])
        table = results.tables[path.stem.split("__")[1]]
        for column, expected in committed.items():
            if column in table and isinstance(expected, np.ndarray) and len(expected) == len(table[column]):
                np.testing.assert_allclose(table[column], expected, rtol=1e-11)
                compared += 1
    assert compared >= 40


def test_tables_hold_what_the_files_hold(folder: Path) -> None:
    results = quick(ta.Scene.from_toml(folder / "scene.toml"))
    assert set(results.tables) == {"elastic", "ep-sphere", "report-scales", "report-decades", "report-sensitivity", "areas"}
    for name, table in results.tables.items():
        columns = columns_of(results.files[f"{name}.csv"].decode())
        assert list(columns) == list(table)
        for column, array in table.items():
            if array.dtype.kind == "f":
                np.testing.assert_array_equal(array, numbers(columns, column))
            else:
                assert array.tolist() == words(columns, column)
    assert any("Steel on glass" in note for note in results.tables["elastic"].notes)
    frame = results.tables["report-scales"].to_pandas()
    assert frame["curve"].tolist() == ["elastic", "elastic", "ep-sphere", "ep-sphere"]
    assert results.tables["elastic"].to_xarray().sizes["row"] == 60
    assert list(results.figures) == ["areas"] and results.figures["areas"].lstrip().startswith("<svg")
    assert results.report_html is not None and "Steel on glass" in results.report_html
    assert "<iframe" in results._repr_html_() and "&lt;html" in results._repr_html_()
    assert repr(results).startswith("SceneResults('Steel on glass', tables: elastic, ep-sphere, ")


def test_without_a_report(folder: Path) -> None:
    results = ta.Scene.from_toml(folder / "scene.toml").run(report=False)
    assert sorted(results.files) == ["answer.json", "areas.csv", "areas.svg", "elastic.csv", "ep-sphere.csv"]
    assert results.report_html is None
    assert "<svg" in results._repr_html_() and "Steel on glass" in results._repr_html_()


def test_the_judge_and_draws_where_they_are_asked(folder: Path) -> None:
    text = SCENE.replace('"210 GPa"', '"210 GPa +- 5 GPa"') + "[judge]\ngrid = 64\nrealisations = 2\n[uncertainty]\ndraws = 100\n"
    scene = ta.Scene.from_toml(text, folder=folder)
    told: list[tuple[int, int | None]] = []
    results = scene.run(report=False, progress=lambda done, total: told.append((done, total)))
    assert {"report-models", "report-judge", "report-uncertainty"} <= set(results.tables)
    assert told and all(total is None or done <= total for done, total in told)
    neither = scene.run(report=False, judge=False, uncertainty=False)
    assert not {"report-models", "report-uncertainty"} & set(neither.tables)
    assert "boundary elements, elastic" in results.answer and "not compared with boundary elements" in neither.answer


def test_progress_is_a_line_that_goes(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    text = SCENE + "[judge]\ngrid = 64\nrealisations = 2\n"
    ta.Scene.from_toml(text, folder=folder).run(progress=True, uncertainty=False)
    line = capsys.readouterr().err
    assert "surfaces pressed" in line and line.endswith("\r") and "\n" not in line
    with refused_naming("progress:", "True", "False", "str", by=TypeError):
        ta.Scene.from_toml(text, folder=folder).run(progress="yes")  # type: ignore[arg-type]


def test_what_an_observer_raises_ends_the_run() -> None:
    def stop(done: int, total: int | None) -> None:
        raise RuntimeError(f"enough at {done} of {total}")

    with refused_naming("enough", "at", by=RuntimeError):
        ta.Scene.template("gasket").run(progress=stop)


@pytest.mark.skipif(os.name == "nt", reason="signals are sent otherwise there")
@pytest.mark.parametrize("phase", ["surfaces pressed", "draws"])
def test_ctrl_c_ends_judge_and_draws(phase: str) -> None:
    long_judge = {"judge.grid": 256, "judge.realisations": 5000, "judge.budget": 1e14}
    scene = ta.Scene.template("gasket").replace(**{**long_judge, "uncertainty.draws": 100000})
    begun: list[bool] = []
    sent: list[float] = []

    def send() -> None:
        sent.append(time.monotonic())
        os.kill(os.getpid(), signal.SIGINT)

    def interrupt(done: int, total: int | None) -> None:
        if done > 0 and not begun:
            begun.append(True)
            threading.Timer(0.05, send).start()

    with pytest.raises(KeyboardInterrupt):
        scene.run(report=False, judge=phase != "draws", uncertainty=phase == "draws", progress=interrupt)
    assert time.monotonic() - sent[0] < 20.0


def test_results_and_scenes_are_pickled(folder: Path) -> None:
    scene = ta.Scene.from_toml(folder / "scene.toml").replace(cutoff="50 nm")
    results = quick(scene)
    again = pickle.loads(pickle.dumps(results))
    assert again == results and again.tables["elastic"] == results.tables["elastic"]
    pickled = pickle.dumps(scene)
    (folder / "spectrum.csv").unlink()
    there = pickle.loads(pickled)
    assert there == scene and there.title == "Steel on glass"
    assert there.scales() == scene.scales()
    assert there.scales() == ta.Scene.from_toml(there.text, folder=_with(folder, scene)).scales()


def _with(folder: Path, scene: ta.Scene) -> Path:
    (folder / "spectrum.csv").write_bytes(scene._recipe[3]["spectrum.csv"])
    return folder


def test_files_are_written_all_or_none(folder: Path) -> None:
    results = ta.Scene.from_toml(folder / "scene.toml").run(report=False)
    out = folder / "new" / "out"
    assert sorted(results.write(out)) == sorted(path.name for path in out.iterdir())
    assert (out / "elastic.csv").read_bytes() == results.files["elastic.csv"]
    with refused_naming("scene.toml", by=OSError):
        results.write(folder / "scene.toml")
    assert (folder / "scene.toml").read_text() == SCENE


def test_paths_and_texts(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    by_path = ta.Scene.from_toml(folder / "scene.toml")
    assert by_path.text == SCENE and by_path.title == "Steel on glass"
    assert len(by_path.notes) == 1 and "rad/m" in by_path.notes[0]
    assert ta.Scene.from_toml(str(folder / "scene.toml")).scales() == by_path.scales()
    assert ta.Scene.from_toml(SCENE, folder=folder).scales() == by_path.scales()
    monkeypatch.chdir(folder)
    assert ta.Scene.from_toml(SCENE).scales() == by_path.scales()
    (folder / "scene").write_bytes(b"\xef\xbb\xbf" + SCENE.encode())
    assert ta.Scene.from_toml("scene") == ta.Scene.from_toml("scene")
    assert "needed" in by_path.explain() and "statistical curve ep-sphere at 2 loads" in by_path.explain()
    assert "Steel on glass" in by_path._repr_html_() and repr(by_path) == "Scene('Steel on glass')"


@pytest.mark.parametrize(
    ("old", "new", "told"),
    [
        ("youngs_modulus", "young", "`young` `youngs_modulus` scene:8:1 -->"),
        ('"210 GPa"', '"210 GPA"', "material.youngs_modulus: '210 GPA' 'GPA' scene:8:18 ^^^"),
        ("poisson_ratio = 0.3", "poisson_ratio = 0.7", "poisson_ratio scene:9 0.5"),
        ('"1 MPa"', '"-1 MPa"', "pressures '-1 MPa'"),
        ('"elastic"', '"plastic"', "`plastic` scene:16"),
        ("[loads]", "[loads", "scene:12"),
        ("yield_strength = ", "# ", "yield_strength indentation_hardness material"),
    ],
)  # fmt: skip
def test_what_is_wrong_is_drawn_with_its_line(folder: Path, old: str, new: str, told: str) -> None:
    with refused_naming(*told.split()):
        ta.Scene.from_toml(SCENE.replace(old, new), folder=folder)


def test_missing_files_and_wrong_bytes(folder: Path) -> None:
    for missing in ("nowhere.toml", folder / "nowhere", "nowhere"):
        with refused_naming("nowhere", by=FileNotFoundError):
            ta.Scene.from_toml(missing)
    with refused_naming("spectrum.csv", "scene:5:7", by=FileNotFoundError):
        ta.Scene.from_toml(SCENE, folder=folder / "elsewhere")
    (folder / "spectrum.csv").write_text("nothing")
    with refused_naming("spectrum.csv"):
        ta.Scene.from_toml(folder / "scene.toml")
    (folder / "latin.toml").write_bytes(SCENE.replace("glass", "gl\xe4ss").encode("latin-1"))
    with refused_naming("latin.toml,", "line", "2:", "UTF-8"):
        ta.Scene.from_toml(folder / "latin.toml")
    with refused_naming("'nothing'", "new,", "uncd-measured"):
        ta.Scene.template("nothing")  # type: ignore[arg-type]  # pyright: ignore[reportArgumentType]
    with refused_naming("my_psd.csv", by=FileNotFoundError):
        ta.Scene.template("new")
    with refused_naming("surface", by=TypeError):
        ta.Scene()  # type: ignore[call-arg]  # pyright: ignore[reportCallIssue]


def test_keys_and_sections_that_the_scene_has_not_are_added(folder: Path) -> None:
    plain = ta.Scene.from_toml(SCENE, folder=folder)
    glass = {"counterface.youngs_modulus": "70 GPa", "counterface.poisson_ratio": 0.2}
    soft = plain.replace(cutoff=1e-7, scales_per_decade=20, normalisation="as-printed", **glass)
    assert np.all(soft.scales().area_fraction != plain.scales().area_fraction)
    typed = SCENE + '[counterface]\nyoungs_modulus = "70 GPa"\npoisson_ratio = 0.2\n'
    assert ta.Scene.from_toml(typed, folder=folder).scales() == plain.replace(**glass).scales()


def test_keys_are_set_anew(folder: Path) -> None:
    scene = ta.Scene.from_toml(folder / "scene.toml")
    changed = scene.replace(youngs_modulus="200 GPa", cutoff="50 nm", **{"material.poisson_ratio": np.float64(0.25)})
    assert "# Two lines of its own.\n" in changed.text
    assert 'youngs_modulus = "200 GPa"   # from a book\npoisson_ratio = 0.25\n' in changed.text
    assert changed.text.endswith('\n[cutoffs]\nshortest_wavelength = "50 nm"\n')
    assert scene.text == SCENE
    assert scene.replace(youngs_modulus=2e11, cutoff=5e-8, poisson_ratio=0.25).scales() == changed.scales()
    several = scene.replace(pressure=np.array([1e6, 2e6, 3e6]))
    assert several.scales().nominal_pressure_pa.tolist() == [1e6, 2e6, 3e6] * 2
    assert scene.replace(pressures="1e-3 H").scales().nominal_pressure_pa.tolist() == [3e6] * 2
    assert scene.replace(**{"curve.1.model": "hertz"}).scales().curve.tolist() == ["elastic"] * 2 + ["hertz"] * 2
    uniform = {"distribution": "uniform", "from": 1e11, "to": 2e11}
    assert "200 GPa" in scene.replace(youngs_modulus=uniform).text
    (folder / "other.csv").write_bytes((folder / "spectrum.csv").read_bytes().replace(b"e-2", b"e-3"))
    assert scene.replace(psd="other.csv").scales().area_fraction[0] > scene.scales().area_fraction[0]
    assert scene.replace() == scene


@pytest.mark.parametrize(
    ("changes", "told"),
    [
        ({"modulus": 1e9}, "modulus: psd"),
        ({"material.colour": 1}, "material.colour: material.youngs_modulus"),
        ({"off": True}, "off judge.off uncertainty.off"),
        ({"curve.2.model": "hertz"}, "curve.2.model: 2"),
        ({"youngs_modulus": "1 m"}, "material.youngs_modulus: '1 m' 'm' scene.toml:8"),
        ({"youngs_modulus": -1.0}, "material.youngs_modulus: -1"),
        ({"poisson_ratio": float("nan")}, "poisson_ratio"),
        ({"normalisation": "none"}, "`none` parseval"),
        ({"hardness_formula": "2006"}, "`2006` `2005`"),
        ({"strength_cap": "1 m"}, "strength_cap: '1 m'"),
        ({"cutoff": -1.0}, "cutoffs.shortest_wavelength: -1"),
        ({"scales_per_decade": 0}, "scales_per_decade: 0 1"),
        ({"youngs_modulus": None}, "youngs_modulus: NoneType"),
    ],
)  # fmt: skip
def test_keys_that_cannot_be_set(folder: Path, changes: dict[str, object], told: str) -> None:
    with refused_naming(*told.split()):
        ta.Scene.from_toml(folder / "scene.toml").replace(**changes)
