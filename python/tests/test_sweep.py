"""Sweeps: the same rows whatever computes them, files that are whole and computed once, and what is refused."""

from __future__ import annotations

import hashlib
import os
import signal
import subprocess
import sys
import time
import warnings
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import pytest

import truearea as ta
from support import refused_naming

pytest.importorskip("pyarrow")


def product(a: float, b: float) -> dict[str, Any]:
    return {"c": a * b, "is_large": a * b > 2.0, "what": f"{a}"}


def states(youngs_modulus: np.ndarray[Any, Any], pressure: np.ndarray[Any, Any]) -> Any:
    distinct, index = np.unique(youngs_modulus, return_inverse=True)
    materials = np.array([ta.Material(modulus, 0.3) for modulus in distinct], dtype=object)
    return ta.contact(model="hertz", radius=1e-6, density=1e12, sigma_s=1e-8, material=materials[index], pressure=pressure)


def content(folder: Path) -> dict[str, str]:
    return {path.name: hashlib.sha256(path.read_bytes()).hexdigest() for path in sorted(folder.iterdir())}


@pytest.fixture(scope="module")
def client() -> Iterator[Any]:
    distributed = pytest.importorskip("distributed")
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        cluster = distributed.LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None, silence_logs=50)
        with cluster, distributed.Client(cluster, set_as_default=False) as client:
            yield client


def test_a_function_over_a_grid() -> None:
    rows = ta.sweep(product, {"a": [1, 2, 3], "b": np.array([0.5, 1.5])})
    assert list(rows.columns) == ["a", "b", "c", "is_large", "what"]
    assert rows["a"].tolist() == [1, 1, 2, 2, 3, 3] and rows["b"].tolist() == [0.5, 1.5] * 3
    assert rows["c"].tolist() == [0.5, 1.5, 1.0, 3.0, 1.5, 4.5]
    assert rows["is_large"].tolist() == [False, False, False, True, False, True]
    steel, glass = ta.Material("210 GPa", 0.3), ta.Material("70 GPa", 0.2)
    rows = ta.sweep(lambda body: body.composite_modulus_pa, {"body": [steel, glass]})
    assert rows["value"].tolist() == [steel.composite_modulus_pa, glass.composite_modulus_pa]
    assert rows["body"].tolist() == [repr(steel), repr(glass)]


def test_rows_of_several_parts_are_those_of_single_calls() -> None:
    rows = ta.sweep(lambda a: 2.0 * a, {"a": range(600)})
    assert rows["value"].tolist() == [2.0 * a for a in range(600)] and rows.index.tolist() == list(range(600))
    moduli, pressures = np.geomspace(1e9, 1e12, 7), np.geomspace(1e4, 1e7, 11)
    rows = ta.sweep(states, {"youngs_modulus": moduli, "pressure": pressures}, vectorised=True)
    for modulus in moduli:
        found = ta.contact(
            model="hertz", radius=1e-6, density=1e12, sigma_s=1e-8, material=ta.Material(modulus, 0.3), pressure=pressures
        )
        np.testing.assert_array_equal(rows["area_fraction"][rows["youngs_modulus"] == modulus], found.area_fraction)


def test_a_scene_over_its_keys(tmp_path: Path) -> None:
    scene = ta.Scene.template("uncd-measured")
    axes = {"youngs_modulus": ["400 GPa", 5e11], "cutoff": [1e-8, "100 nm"]}
    rows = ta.sweep(scene, axes)
    one = scene.replace(youngs_modulus=5e11, cutoff="100 nm").scales()
    last = rows[(rows["youngs_modulus"] == "500000000000.0") & (rows["cutoff"] == "100 nm")]
    assert last["curve"].tolist() == one.curve.tolist() and len(rows) == 4 * len(one.curve)
    np.testing.assert_array_equal(last["area_fraction"], one.area_fraction)
    for _ in range(2):
        pd.testing.assert_frame_equal(pd.read_parquet(ta.sweep(scene, axes, tmp_path)), rows)


def test_workers_write_the_files_that_one_process_writes(client: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    axes = {"a": range(40), "b": np.arange(20.0)}
    alone = ta.sweep(product, axes, tmp_path / "alone")
    together = ta.sweep(product, axes, tmp_path / "together", client=client)
    assert content(alone) == content(together) and len(content(alone)) == 8
    pd.testing.assert_frame_equal(pd.read_parquet(alone), ta.sweep(product, axes))


SCRIPT = """
import sys, time
import numpy as np
import truearea as ta

# Parts small enough to be killed between two of them.
import truearea._sweep
truearea._sweep._ROWS_PER_VECTORISED_PART = (4096, 4096)

def states(sample, pressure):
    time.sleep(0.05)
    return ta.contact(model="hertz", radius=1e-6, density=1e12, sigma_s=1e-8, material="C45", pressure=pressure)

if __name__ == "__main__":
    axes = {"sample": np.arange(1000), "pressure": np.geomspace(1e5, 1e7, 100)}
    if sys.argv[2] == "alone":
        ta.sweep(states, axes, sys.argv[1], vectorised=True)
    else:
        from distributed import Client, LocalCluster
        with LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster, Client(cluster) as client:
            ta.sweep(states, axes, sys.argv[1], client, vectorised=True)
"""


@pytest.mark.skipif(os.name == "nt", reason="there is no SIGKILL there")
def test_a_killed_sweep_of_two_processes_continues(tmp_path: Path) -> None:
    pytest.importorskip("distributed")
    folder, script = tmp_path / "killed", tmp_path / "script.py"
    script.write_text(SCRIPT)
    environment = {**os.environ, "PYTHONPATH": str(Path(ta.__file__).parents[1]), "PYTHONWARNINGS": "ignore"}

    def call(folder: Path, how: str) -> list[str]:
        return [sys.executable, str(script), str(folder), how]

    first = subprocess.Popen(call(folder, "cluster"), env=environment, stderr=subprocess.DEVNULL, start_new_session=True)
    deadline = time.monotonic() + 120
    while len(list(folder.glob("part-*.parquet"))) < 4:
        assert first.poll() is None and time.monotonic() < deadline
        time.sleep(0.002)
    os.killpg(first.pid, signal.SIGKILL)
    first.wait()
    written = {path: path.stat().st_mtime_ns for path in folder.glob("part-*.parquet")}
    assert 4 <= len(written) < 25
    subprocess.run(call(folder, "cluster"), env=environment, check=True, stderr=subprocess.DEVNULL)
    assert {path: path.stat().st_mtime_ns for path in written} == written
    subprocess.run(call(tmp_path / "whole", "alone"), env=environment, check=True)
    after = {name: digest for name, digest in content(folder).items() if not name.startswith(".")}
    assert after == content(tmp_path / "whole") and len(after) == 25


def test_only_missing_and_damaged_parts_are_computed(tmp_path: Path) -> None:
    calls: list[int] = []

    def noted(a: int) -> float:
        calls.append(a)
        return 2.0 * a

    def again() -> int:
        before = len(calls)
        ta.sweep(noted, {"a": range(600)}, tmp_path)
        assert pd.read_parquet(tmp_path)["value"].tolist() == [2.0 * a for a in range(600)]
        return len(calls) - before

    assert [again(), again()] == [600, 0]
    part = tmp_path / "part-000001.parquet"
    whole = part.read_bytes()
    for damaged in [b"", whole[:400], whole[:-9], bytes(500)]:
        part.write_bytes(damaged)
        assert again() == 75
    part.unlink()
    assert again() == 75


@pytest.mark.parametrize(
    "axes", [{"a": [1.0, 2.0, 4.0]}, {"x": [1.0, 2.0, 3.0]}, {"a": range(3), "b": range(600)}, {"a": [1.0, 2.0]}]
)
def test_a_folder_of_other_axes_is_refused(tmp_path: Path, axes: dict[str, Any]) -> None:
    ta.sweep(lambda a: a, {"a": [1.0, 2.0, 3.0]}, tmp_path)
    before = content(tmp_path)
    with refused_naming("part-000000.parquet", "folder"):
        ta.sweep(lambda **values: 1.0, axes, tmp_path)
    assert content(tmp_path) == before
    (tmp_path / "mine.parquet").write_bytes(b"")
    with refused_naming("mine.parquet", "folder"):
        ta.sweep(lambda a: a, {"a": [1.0, 2.0, 3.0]}, tmp_path)


def test_a_data_frame_has_its_own_rows() -> None:
    frame = pd.DataFrame({"a": [1.0, 2.0, 3.0], "b": [4.0, 5.0, 6.0]}, index=[7, 8, 9])
    assert ta.sweep(lambda a, b: a * b, frame)["value"].tolist() == [4.0, 10.0, 18.0]
    assert ta.sweep(lambda a, b: {"value": a * b}, frame, vectorised=True)["value"].tolist() == [4.0, 10.0, 18.0]


def test_rows_are_divided_for_workers_and_bounded(tmp_path: Path) -> None:
    ta.sweep(lambda a: {"b": a}, {"a": np.arange(100_000)}, tmp_path, vectorised=True)
    assert len(list(tmp_path.glob("part-*.parquet"))) == 8
    with refused_naming("axes", "1e+10", "rows"):
        ta.sweep(lambda a, b: a, {"a": range(100_000), "b": range(100_000)})


def test_an_error_of_a_function_names_its_row() -> None:
    with pytest.raises(ZeroDivisionError) as caught:
        ta.sweep(lambda a: 1.0 / a, {"a": [1.0, 0.0]})
    assert sys.version_info < (3, 11) or caught.value.__notes__ == ["in the row a = 0.0"]
    with refused_naming("a = 1", "None"):
        ta.sweep(lambda a: None, {"a": [1]})


GASKET = ta.Scene.template("gasket")


@pytest.mark.parametrize(
    ("arguments", "told"),
    [
        ({"swept": 3}, "Scene function int"),
        ({"axes": {}}, "axes:"),
        ({"axes": [1, 2]}, "axes:"),
        ({"axes": {"a": []}}, "axes['a'] one value"),
        ({"axes": {"a": "10 nm"}}, "axes['a']: str"),
        ({"axes": {"a": 1.0}}, "axes['a']: float"),
        ({"axes": {"a": np.ones((2, 2))}}, "axes['a'] (2, 2)"),
        ({"client": object()}, "client folder"),
        ({"swept": lambda a, b: a + b, "vectorised": True}, "vectorised mapping"),
        ({"swept": lambda a, b: {"c": np.ones(7)}, "vectorised": True}, "c (7,)"),
        ({"swept": lambda a, b: {"c": [1.0, 2.0]}}, "c (2,)"),
        ({"swept": lambda a, b: {"a": a}}, "a axis"),
        ({"swept": lambda a, b: {"c": a} if a == 1.0 else {"d": a}}, "'d' 'c'"),
        ({"swept": lambda a, b: ta.Material(-a, b).composite_modulus_pa}, "a = 1.0, b = 3.0: youngs_modulus -1"),
        ({"swept": GASKET, "axes": {"colour": [1]}}, "colour = 1: colour:"),
        ({"swept": GASKET, "axes": {"pressure": [1e5]}, "vectorised": True}, "vectorised"),
    ],
)  # fmt: skip
def test_what_cannot_be_swept(arguments: dict[str, Any], told: str) -> None:
    given: dict[str, Any] = {"swept": lambda a, b: a * b, "axes": {"a": [1.0, 2.0], "b": [3.0, 4.0]}}
    with refused_naming(*told.split()):
        ta.sweep(**{**given, **arguments})


def test_errors_of_the_function_are_its_own(client: Any, tmp_path: Path) -> None:
    with pytest.raises(ZeroDivisionError):
        ta.sweep(lambda a: 1.0 / a, {"a": [1.0, 0.0]}, tmp_path, client)


def test_threads_come_back() -> None:
    with ta.threads(2):
        assert ta.sweep(lambda a: float(ta.threads()), {"a": range(8)})["value"].tolist() == [1.0] * 8
        assert ta.threads() == 2


@pytest.mark.parametrize("hidden", ["pandas", "pyarrow"])
def test_a_missing_package_is_named(hidden: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, hidden, None)
    with pytest.raises(ImportError, match=rf"{hidden}.*truearea\[cluster\]"):
        ta.sweep(lambda a: a, {"a": [1.0]}, tmp_path)
