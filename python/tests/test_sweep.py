"""Sweeps: the same rows whatever computes them, files that are whole and computed once, and what is refused."""

from __future__ import annotations

import functools
import hashlib
import json
import os
import runpy
import signal
import subprocess
import sys
import threading
import time
import warnings
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import pytest

import truearea as ta
from support import refused_naming

GASKET = ta.Scene.template("gasket")
pq: Any = pytest.importorskip("pyarrow.parquet")


def product(a: float, b: float) -> dict[str, Any]:
    return {"c": a * b, "is_large": a * b > 2.0, "what": f"{a}"}


def drawn(a: float, rng: np.random.Generator) -> float:
    return float(a + rng.normal())


def blocks(a: np.ndarray[Any, Any], row: np.ndarray[Any, Any]) -> dict[str, Any]:
    return {"c": a + row, "rows": float(len(a)) * 0.0}


def states(youngs_modulus: np.ndarray[Any, Any], pressure: np.ndarray[Any, Any]) -> Mapping[str, Any]:
    distinct, index = np.unique(youngs_modulus, return_inverse=True)
    materials = np.array([ta.Material(modulus, 0.3) for modulus in distinct], dtype=object)
    return ta.contact(model="hertz", radius=1e-6, density=1e12, sigma_s=1e-8, material=materials[index], pressure=pressure)


def rows_of(frame: Any) -> pd.DataFrame:
    found: pd.DataFrame = (frame.compute() if hasattr(frame, "compute") else frame).reset_index(drop=True)
    return found


def content(folder: Path) -> dict[str, str]:
    return {path.name: hashlib.sha256(path.read_bytes()).hexdigest() for path in sorted(folder.iterdir())}


@pytest.fixture(scope="module")
def client() -> Iterator[Any]:
    distributed = pytest.importorskip("distributed")
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        cluster = distributed.LocalCluster(
            n_workers=2, threads_per_worker=1, dashboard_address=None, silence_logs=50
        )
        with cluster, distributed.Client(cluster, set_as_default=False) as client:
            yield client


def test_a_function_over_a_grid() -> None:
    frame = ta.sweep(product, over={"a": [1, 2, 3], "b": np.array([0.5, 1.5])})
    assert type(frame).__module__.startswith("dask")
    rows = rows_of(frame)
    assert list(rows.columns) == ["a", "b", "c", "is_large", "what"]
    assert rows["a"].tolist() == [1, 1, 2, 2, 3, 3] and rows["b"].tolist() == [0.5, 1.5] * 3
    assert rows["c"].tolist() == [0.5, 1.5, 1.0, 3.0, 1.5, 4.5]
    assert rows["is_large"].tolist() == [False, False, False, True, False, True]
    assert rows["what"].tolist() == ["1", "1", "2", "2", "3", "3"]
    assert frame.dtypes.astype(str).tolist()[:4] == ["int64", "float64", "float64", "bool"]


def test_columns_that_go_together() -> None:
    over = {"a": [1.0, 2.0], "b": [3.0, 4.0]}
    assert rows_of(ta.sweep(product, over=over, zipped=True))["c"].tolist() == [3.0, 8.0]
    both = rows_of(ta.sweep(lambda a, b, x: a * b * x, over={("a", "b"): ([1.0, 2.0], [3.0, 4.0]), "x": [1.0, 10.0]}))
    assert both["value"].tolist() == [3.0, 30.0, 8.0, 80.0]
    steel, glass = ta.Material("210 GPa", 0.3), ta.Material("70 GPa", 0.2)
    rows = rows_of(ta.sweep(lambda body: body.composite_modulus_pa, over={"body": [steel, glass]}))
    assert rows["value"].tolist() == [steel.composite_modulus_pa, glass.composite_modulus_pa]
    assert rows["body"].tolist() == [repr(steel), repr(glass)]


@pytest.mark.parametrize("rows_per_partition", [1, 4, 64, None])
def test_drawn_numbers_are_the_same_in_any_partition(rows_per_partition: int | None) -> None:
    frame = ta.sweep(drawn, over={"a": [0.0, 10.0, 20.0]}, repeats=5, seed=7, rows_per_partition=rows_per_partition)
    rows = rows_of(frame)
    expected = [10.0 * (row // 5) + np.random.default_rng([7, row]).normal() for row in range(15)]
    assert rows["value"].tolist() == expected
    assert rows["repeat"].tolist() == list(range(5)) * 3
    assert frame.npartitions == {1: 15, 4: 4, 64: 1}.get(rows_per_partition or 64)


def test_blocks_are_rows() -> None:
    rows = rows_of(ta.sweep(blocks, over={"a": np.arange(100.0)}, vectorised=True, rows_per_partition=8))
    np.testing.assert_array_equal(rows["c"], 2.0 * np.arange(100.0))
    moduli, pressures = np.geomspace(1e9, 1e12, 7), np.geomspace(1e4, 1e7, 11)
    over = {"youngs_modulus": moduli, "pressure": pressures}
    rows = rows_of(ta.sweep(states, over=over, vectorised=True, rows_per_partition=16))
    for modulus in moduli:
        of_one = rows[rows["youngs_modulus"] == modulus]
        found = ta.contact(
            model="hertz", radius=1e-6, density=1e12, sigma_s=1e-8, material=ta.Material(modulus, 0.3), pressure=pressures
        )
        np.testing.assert_array_equal(of_one["area_fraction"], found.area_fraction)


def test_a_scene_over_its_keys() -> None:
    scene = ta.Scene.template("uncd-measured")
    over = {"youngs_modulus": ["400 GPa", 5e11], "cutoff": [1e-8, "100 nm"]}
    rows = rows_of(ta.sweep(scene, over=over))
    one = scene.replace(youngs_modulus=5e11, cutoff="100 nm").scales()
    last = rows[(rows["youngs_modulus"] == "500000000000.0") & (rows["cutoff"] == "100 nm")]
    assert last["curve"].tolist() == one.curve.tolist()
    np.testing.assert_array_equal(last["area_fraction"], one.area_fraction)
    assert len(rows) == 4 * len(one.curve)
    gasket = ta.Scene.template("gasket")
    table = rows_of(ta.sweep(gasket, over={"pressure": [1e5, 2e5]}, table="persson"))
    np.testing.assert_array_equal(
        table["area_fraction"][table["pressure"] == 2e5],
        gasket.replace(pressure=2e5).run(report=False).tables["persson"].area_fraction,
    )


def test_workers_write_the_files_that_one_process_writes(client: Any, tmp_path: Path) -> None:
    over = {"youngs_modulus": np.geomspace(1e9, 1e12, 9), "pressure": np.geomspace(1e4, 1e7, 50)}
    alone, together = tmp_path / "alone", tmp_path / "together"
    told: list[tuple[int, int | None]] = []

    def tell(done: int, total: int | None) -> None:
        told.append((done, total))

    here = ta.sweep(states, over=over, vectorised=True, rows_per_partition=64, to=alone, progress=tell)
    there = ta.sweep(states, over=over, vectorised=True, rows_per_partition=64, to=together, client=client)
    assert content(alone) == content(together)
    assert len(content(alone)) == 9 and told == [(done, 8) for done in range(1, 9)]
    pd.testing.assert_frame_equal(rows_of(here), rows_of(there))
    plain = rows_of(ta.sweep(states, over=over, vectorised=True))
    np.testing.assert_array_equal(rows_of(here)["area_fraction"], plain["area_fraction"])
    scene = ta.Scene.template("gasket")
    by_workers = ta.sweep(scene, over={"pressure": [1e5, 2e5, 3e5]}, rows_per_partition=1, to=tmp_path / "scene", client=client)
    by_one = ta.sweep(scene, over={"pressure": [1e5, 2e5, 3e5]})
    np.testing.assert_array_equal(rows_of(by_workers)["area_fraction"], rows_of(by_one)["area_fraction"])


def test_files_tell_where_they_come_from(tmp_path: Path) -> None:
    ta.sweep(ta.Scene.template("gasket"), over={"pressure": [1e5, 2e5]}, rows_per_partition=1, to=tmp_path / "a")
    told = json.loads(pq.read_schema(tmp_path / "a" / "part-000001.parquet").metadata[b"truearea"])
    assert told["program"] == f"truearea {ta.__version__}"
    assert told["scene"] == ta.Scene.template("gasket").text
    assert told["over"] == {"pressure": [1e5, 2e5]} and told["rows"] == [1, 2] and told["seed"] == 1
    assert any("not measured" in note for note in told["notes"])
    ta.sweep(drawn, over={"a": np.arange(1000.0)}, to=tmp_path / "b", rows_per_partition=1024)
    told = json.loads(pq.read_schema(tmp_path / "b" / "part-000000.parquet").metadata[b"truearea"])
    assert told["function"].endswith("drawn") and told["over"] == {"a": {"count": 1000, "first": 0.0, "last": 999.0}}
    rows = rows_of(ta.sweep(drawn, over={"a": np.arange(1000.0)}))
    assert pd.read_parquet(tmp_path / "b")["value"].tolist() == rows["value"].tolist()


SCRIPT = """
import sys, time
import truearea as ta

def counted(a, rng):
    with open({log!r}, "a") as log:
        log.write(f"{{a}}\\n")
    time.sleep(0.01)
    return {{"b": a + rng.normal()}}

if __name__ == "__main__":
    ta.sweep(counted, over={{"a": range(40)}}, to={to!r}{arguments})
"""


@pytest.mark.skipif(os.name == "nt", reason="there is no SIGKILL there")
@pytest.mark.parametrize("arguments", [", rows_per_partition=4", ", partition_seconds=0.05"])
def test_a_killed_sweep_goes_on_where_it_was(tmp_path: Path, arguments: str) -> None:
    log, folder, script = tmp_path / "log", tmp_path / "killed", tmp_path / "script.py"
    script.write_text(SCRIPT.format(log=str(log), to=str(folder), arguments=arguments))
    package = str(Path(ta.__file__).parents[1])
    environment = {**os.environ, "PYTHONPATH": package}
    first = subprocess.Popen([sys.executable, str(script)], env=environment)
    deadline = time.monotonic() + 60
    while len(list(folder.glob("part-*.parquet"))) < 4:
        assert first.poll() is None and time.monotonic() < deadline
        time.sleep(0.002)
    first.send_signal(signal.SIGKILL)
    first.wait()
    written = content(folder)
    rows_per_partition = json.loads((folder / "_sweep.json").read_text())["rows_per_partition"]
    in_files = set()
    for path in folder.glob("part-*.parquet"):
        in_files |= set(pq.read_table(path)["a"].to_pylist())
    assert len(in_files) < 40
    before = [int(line) for line in log.read_text().splitlines()]
    assert len(before) == len(set(before))
    subprocess.run([sys.executable, str(script)], env=environment, check=True)
    computed_again = [int(line) for line in log.read_text().splitlines()][len(before) :]
    assert sorted(computed_again) == sorted(set(range(40)) - in_files)
    for aside in folder.glob(".*.aside"):
        assert aside.name in written
        os.utime(aside, (0, 0))
    subprocess.run([sys.executable, str(script)], env=environment, check=True)
    after = content(folder)
    assert {name: after[name] for name in written if name in after} == {n: c for n, c in written.items() if not n.startswith(".")}
    whole, again = tmp_path / "whole", f", rows_per_partition={rows_per_partition}"
    script.write_text(SCRIPT.format(log=str(log), to=str(whole), arguments=again))
    runpy.run_path(str(script), run_name="__main__")
    assert content(whole) == after
    assert not [name for name in after if name.endswith(".aside")]


def test_nothing_is_computed_where_all_is_written(tmp_path: Path) -> None:
    calls: list[float] = []
    path = str(tmp_path / "calls")

    def noted(a: float) -> float:
        with open(path, "a") as log:
            log.write("x")
        return a

    for _ in range(2):
        ta.sweep(noted, over={"a": [1.0, 2.0, 3.0]}, rows_per_partition=2, to=tmp_path / "f")
        calls.append(len(Path(path).read_text()))
    assert calls == [3, 3]
    (tmp_path / "f" / "part-000001.parquet").unlink()
    ta.sweep(noted, over={"a": [1.0, 2.0, 3.0]}, to=tmp_path / "f")
    assert len(Path(path).read_text()) == 4


def _scaled(factor: float) -> Callable[[float], float]:
    return lambda a: factor * a


@pytest.mark.parametrize(
    ("arguments", "told"),
    [
        ({"over": {"a": [1.0, 2.0, 4.0]}}, "values"),
        ({"seed": 2}, "seed 1 2"),
        ({"repeats": 2}, "repeats 1 2"),
        ({"swept": _scaled(3.0)}, "source function"),
        ({"swept": abs, "over": {"x": [1.0]}}, ""),
        ({"swept": product, "over": {"a": [1.0], "b": [1.0]}}, "function _scaled product"),
        ({"rows_per_partition": 4}, "4 rows_per_partition 2"),
    ],
)  # fmt: skip
def test_another_sweep_into_the_same_folder_is_refused(tmp_path: Path, arguments: dict[str, Any], told: str) -> None:
    given: dict[str, Any] = {"swept": _scaled(2.0), "over": {"a": [1.0, 2.0, 3.0]}, "rows_per_partition": 2}
    ta.sweep(**given, to=tmp_path)
    before = content(tmp_path)
    with refused_naming(*told.split()):
        ta.sweep(**{**given, **arguments}, to=tmp_path)
    assert content(tmp_path) == before


GLOBAL_FACTOR = 1.0


def by_a_global(a: float) -> float:
    return GLOBAL_FACTOR * a


def by_a_function_of_a_global(a: float) -> float:
    return by_a_global(a)


class Scaling:
    def __init__(self, factor: float) -> None:
        self.factor = factor
        self.models = {"itself": self}

    def __call__(self, a: float) -> float:
        return self.factor * a

    def method(self, a: float) -> float:
        return self.factor * a


@dataclass
class ScalingOfData:
    factor: float

    def __call__(self, a: float) -> float:
        return self.factor * a


def over_object(scaling: Scaling) -> Callable[[float], float]:
    return lambda a: scaling.factor * a


@pytest.mark.parametrize(
    "swept",
    [
        Scaling,
        ScalingOfData,
        lambda factor: Scaling(factor).method,
        lambda factor: functools.partial(Scaling(factor)),
        lambda factor: functools.partial(lambda a, by: by * a, by=factor),
        lambda factor: functools.cache(over_object(Scaling(factor))),
        lambda factor: over_object(Scaling(factor)),
        lambda factor: [lambda a: 1.0 * a, lambda a: 100.0 * a][factor > 1],
    ],
)
def test_state_of_functions_makes_another_sweep(swept: Callable[[float], Any], tmp_path: Path) -> None:
    given: dict[str, Any] = {"over": {"a": [1.0, 2.0]}, "to": tmp_path}
    first = rows_of(ta.sweep(swept(1.0), **given))
    assert first["value"].tolist() == [1.0, 2.0]
    # The same state again, in other objects.
    assert rows_of(ta.sweep(swept(1.0), **given))["value"].tolist() == [1.0, 2.0]
    with refused_naming("state", str(tmp_path)):
        ta.sweep(swept(100.0), **given)


@pytest.mark.parametrize("swept", [by_a_global, by_a_function_of_a_global])
def test_globals_make_another_sweep(swept: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    ta.sweep(swept, over={"a": [1.0]}, to=tmp_path)
    monkeypatch.setitem(globals(), "GLOBAL_FACTOR", 100.0)
    with refused_naming("state"):
        ta.sweep(swept, over={"a": [1.0]}, to=tmp_path)


def test_state_that_cannot_be_told_is_refused_by_name(tmp_path: Path) -> None:
    scaling = Scaling(1.0)
    scaling.models["lock"] = threading.Lock()  # type: ignore[assignment]
    with refused_naming("models.lock", "method"):
        ta.sweep(scaling.method, over={"a": [1.0]}, to=tmp_path)
    with refused_naming("over['a']", "lock"):
        ta.sweep(lambda a: 1.0, over={"a": [threading.Lock()]}, to=tmp_path)


PROCESSES = """
import sys, time
import truearea as ta

def doubled(a):
    time.sleep(0.0005 * (1 + a % 3))
    return 2.0 * a

if __name__ == "__main__":
    frame = ta.sweep(doubled, over={"a": range(256)}, to=sys.argv[1], partition_seconds=0.02)
    assert frame.compute()["value"].tolist() == [2.0 * a for a in range(256)]
"""


@pytest.mark.parametrize("attempt", range(3))
def test_two_processes_fill_one_folder(attempt: int, tmp_path: Path) -> None:
    script, folder = tmp_path / "script.py", tmp_path / "folder"
    script.write_text(PROCESSES)
    environment = {**os.environ, "PYTHONPATH": str(Path(ta.__file__).parents[1])}
    both = [subprocess.Popen([sys.executable, str(script), str(folder)], env=environment) for _ in range(2)]
    assert [process.wait(timeout=120) for process in both] == [0, 0]
    told = json.loads((folder / "_sweep.json").read_text())
    assert len(list(folder.glob("*.parquet"))) == -(-256 // told["rows_per_partition"])
    assert not list(folder.glob(".*.aside"))


def test_damaged_parts_are_computed_again(tmp_path: Path) -> None:
    def swept() -> list[float]:
        found: list[float] = rows_of(ta.sweep(doubled, over={"a": range(64)}, to=tmp_path, rows_per_partition=8))["b"].tolist()
        return found

    def doubled(a: int) -> dict[str, Any]:
        return {"b": 2.0 * a, "text": f"row {a}"}

    expected = [2.0 * a for a in range(64)]
    assert swept() == expected
    part, other = tmp_path / "part-000003.parquet", tmp_path / "part-000004.parquet"
    whole = part.read_bytes()
    changed = [bytearray(whole) for _ in range(60)]
    drawn = np.random.default_rng(1)
    for content_ in changed:
        content_[drawn.integers(len(whole))] ^= 1 << int(drawn.integers(8))
    for damaged in [b"", whole[:400], whole[:-9], bytes(500), other.read_bytes(), *map(bytes, changed)]:
        part.write_bytes(damaged)
        assert swept() == expected
    part.unlink()
    part.mkdir()
    with refused_naming(str(part)):
        swept()
    part.rmdir()
    part.write_bytes(whole[:400])
    lazily = ta.sweep(doubled, over={"a": range(64)}, to=tmp_path)
    part.write_bytes(other.read_bytes())
    with refused_naming(str(part)):
        lazily.compute()


@pytest.mark.parametrize("damaged", ["", "{}", "\x00", "[1]", None])
def test_a_damaged_manifest_is_refused(damaged: str | None, tmp_path: Path) -> None:
    ta.sweep(drawn, over={"a": [1.0, 2.0]}, to=tmp_path)
    manifest = tmp_path / "_sweep.json"
    manifest.write_text(manifest.read_text().replace('"rows": 2', '"rows": 3') if damaged is None else damaged)
    with refused_naming(str(manifest)):
        ta.sweep(drawn, over={"a": [1.0, 2.0]}, to=tmp_path)


def test_folders_of_others_are_refused(tmp_path: Path) -> None:
    (tmp_path / "mine.parquet").write_bytes(b"")
    with refused_naming("Parquet", "folder"):
        ta.sweep(drawn, over={"a": [1.0]}, to=tmp_path)
    with refused_naming("mine.parquet", "folder"):
        ta.sweep(drawn, over={"a": [1.0]}, to=tmp_path / "mine.parquet")


@pytest.mark.parametrize(
    ("arguments", "told"),
    [
        ({"swept": 3}, "Scene function int"),
        ({"over": {}}, "over:"),
        ({"over": [1, 2]}, "over:"),
        ({"over": {"a": []}}, "over['a'] empty"),
        ({"over": {"a": "10 nm"}}, "over['a']: str"),
        ({"over": {"a": 1.0}}, "over['a']: float"),
        ({"over": {"a": np.ones((2, 2))}}, "one axis 2"),
        ({"over": {("a", "b"): [[1.0]]}}, "2 columns 1"),
        ({"over": {"a": [1.0], ("a", "b"): [[1.0], [1.0]]}}, "over: a twice"),
        ({"over": {"a": [1.0], "b": [1.0, 2.0]}, "zipped": True}, "1, 2"),
        ({"over": {"a": [1.0]}}, "a: 'b'"),
        ({"over": {"a": [1.0], "b": [1.0], "x": [1.0]}}, "a, b, x"),
        ({"repeats": 0}, "repeats 0; 1"),
        ({"repeats": 1.5}, "repeats: float"),
        ({"seed": -1}, "seed -1; 0"),
        ({"rows_per_partition": 3}, "3; rows_per_partition"),
        ({"partition_seconds": 0.0}, "partition_seconds 0.0;"),
        ({"table": "scales"}, "table scenes"),
        ({"client": object()}, "client folder"),
        ({"swept": lambda a, b, rng: a, "vectorised": True}, "vectorised rng"),
        ({"swept": lambda a, b: a + b, "vectorised": True}, "vectorised mapping"),
        ({"swept": lambda a, b: {"c": np.ones(7)}, "vectorised": True}, "c (7,) 1"),
        ({"swept": lambda a, b: {"c": [1.0, 2.0]}}, "c (2,)"),
        ({"swept": lambda a, b: {"a": a}}, "column over"),
        ({"swept": lambda a, b: {"c": object()}}, "c: numbers"),
        ({"swept": lambda a, b: {"c": a} if a == 1.0 else {"d": a}}, "row 2"),
        ({"swept": lambda a, b: {"c": a if a == 1.0 else "no"}}, "number"),
        ({"swept": lambda a, b: ta.Material(-a, b).composite_modulus_pa}, "row 0 (a = 1.0, b = 3.0): youngs_modulus -1"),
        ({"swept": GASKET, "over": {"colour": [1]}}, "row 0 (colour = 1): colour:"),
        ({"swept": GASKET, "over": {"pressure": [1e5]}, "vectorised": True}, "vectorised"),
        ({"swept": GASKET, "over": {"pressure": [1e5]}, "table": "none"}, "none persson"),
    ],
)  # fmt: skip
def test_what_cannot_be_swept(arguments: dict[str, Any], told: str) -> None:
    given: dict[str, Any] = {"swept": lambda a, b: a * b, "over": {"a": [1.0, 2.0], "b": [3.0, 4.0]}}
    with refused_naming(*told.split()):
        rows_of(ta.sweep(**{**given, **arguments}))


def test_errors_of_the_function_are_its_own(client: Any, tmp_path: Path) -> None:
    with pytest.raises(ZeroDivisionError):
        ta.sweep(lambda a: 1.0 / a, over={"a": [1.0, 0.0]}, rows_per_partition=1, to=tmp_path, client=client)
    with refused_naming("row", "1", "youngs_modulus", "0"):
        ta.sweep(lambda a: ta.Material(a, 0.3).composite_modulus_pa, over={"a": [1.0, 0.0]}, rows_per_partition=1,
                 to=tmp_path / "other", client=client)  # fmt: skip


def test_threads_come_back() -> None:
    before = ta.threads()
    ta.set_threads(2)
    try:
        rows = rows_of(ta.sweep(lambda a: float(ta.threads()), over={"a": range(8)}, rows_per_partition=1))
        assert rows["value"].tolist() == [1.0] * 8
        assert ta.threads() == 2
    finally:
        ta.set_threads(before)


@pytest.mark.parametrize(("hidden", "call"), [(["dask", "pandas"], "sweep"), (["pyarrow"], "to")])
def test_what_is_not_installed_is_told(hidden: list[str], call: str, tmp_path: Path) -> None:
    program = f"""
import importlib.abc, sys
class Hidden(importlib.abc.MetaPathFinder):
    def find_spec(self, name, path=None, target=None):
        if name.split(".")[0] in {hidden!r}:
            raise ModuleNotFoundError(name)
sys.meta_path.insert(0, Hidden())
import importlib.util
find = importlib.util.find_spec
importlib.util.find_spec = lambda name: None if name in {hidden!r} else find(name)
import truearea as ta
assert "dask" not in sys.modules and "pandas" not in sys.modules
try:
    ta.sweep(lambda a: a, over={{"a": [1.0]}}{", to='folder'" if call == "to" else ""})
except ImportError as error:
    print(error)
"""
    environment = {**os.environ, "PYTHONPATH": str(Path(ta.__file__).parents[1])}
    python = [sys.executable, "-c", program]
    done = subprocess.run(python, env=environment, capture_output=True, text=True, check=True, cwd=tmp_path)
    assert f"{call} needs {hidden[-1]}, which is not here: pip install truearea[cluster]" in done.stdout


def test_without_dask_all_is_computed_at_once(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    import importlib.util

    find = importlib.util.find_spec
    monkeypatch.setattr(importlib.util, "find_spec", lambda name: None if name == "dask" else find(name))
    frame = ta.sweep(product, over={"a": [1, 2], "b": [3.0]})
    assert isinstance(frame, pd.DataFrame) and frame["c"].tolist() == [3.0, 6.0]
    files = ta.sweep(product, over={"a": [1, 2], "b": [3.0]}, rows_per_partition=1, to=tmp_path)
    assert isinstance(files, pd.DataFrame) and files["c"].tolist() == [3.0, 6.0]
