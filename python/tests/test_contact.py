"""`contact`: the digits of the crates, the shapes of ufuncs, and what is refused."""

from __future__ import annotations

import pickle
import subprocess
import sys
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

import truearea as ta
from support import REFERENCE, Columns, Floats, numbers, refused_naming, words

STEEL = ta.Material("210 GPa", 0.3, yield_strength="1 GPa", strain_gradient_length="1 um")
POPULATION: dict[str, Any] = {"radius": 1e-6, "density": 1e12, "sigma_s": 10e-9}


def hertz(**changes: Any) -> ta.ContactStates:
    return ta.contact(**{"model": "hertz", "material": STEEL, "pressure": 1e6, **POPULATION, **changes})


def rows_of(table: Columns, model: str, grows: bool) -> tuple[list[int], list[ta.Material]]:
    """The rows of a model in a reference table, each with its material."""
    lengths = table["strain_gradient_length_m"]
    text = lengths if isinstance(lengths, list) else ["" if np.isnan(length) else str(length) for length in lengths]
    rows = [at for at, name in enumerate(words(table, "model")) if name == model and bool(text[at]) is grows]
    materials = [
        ta.Material(
            numbers(table, "youngs_modulus_pa")[at],
            numbers(table, "poisson_ratio")[at],
            yield_strength=numbers(table, "yield_strength_pa")[at],
            strain_gradient_length=float(text[at]) if grows else None,
        )
        for at in rows
    ]
    return rows, materials


@pytest.mark.parametrize("name", ["statistical_many.csv", "statistical_extra.csv"])
def test_states_are_those_of_the_command_line_bit_for_bit(
    name: str, command_line: Callable[..., Columns], reference: Callable[[str], Columns]
) -> None:
    table = reference(name)
    # The references have no held force.
    given = ("--given", "separation", "--flattening", "area")
    crates = command_line("statistical", "--input", str(REFERENCE / name), *given, "--details")
    compared = 0
    for model in ("hertz", "ep-sphere", "elastic-sine", "ep-sine"):
        for grows in (False, True):
            rows, materials = rows_of(table, model, grows)
            if not rows or (grows and model in ("hertz", "elastic-sine")):
                continue
            states = ta.contact(
                model=model,
                material=materials,
                radius=numbers(table, "radius_m")[rows],
                density=numbers(table, "density_per_m2")[rows],
                sigma_s=numbers(table, "sigma_s_m")[rows],
                separation=numbers(table, "separation_m")[rows],
                strain_gradient=grows,
                flattening="area" if model == "ep-sphere" else None,
            )
            for column in ("pressure_pa", "area_fraction", "error_estimate", "out_of_range_load_share"):
                assert np.array_equal(states[column], numbers(crates, column)[rows], equal_nan=True), (model, column)
            # The crates' own tests hold the last digit; here it is held that these are the same numbers.
            exact_pa = numbers(table, "pressure_pa")[rows]
            assert np.all(np.abs(states.pressure_pa - exact_pa) <= 1e-11 * exact_pa + 1e-300)
            compared += len(rows)
    assert compared > 0.8 * len(words(table, "model"))


def test_digits_do_not_depend_on_neighbours_blocks_or_threads() -> None:
    pressure = np.geomspace(1e3, 1e9, 5000)
    found = []
    before = ta.threads()
    for threads in (1, 2, 3):
        ta.set_threads(threads)
        found.append(ta.contact(model="ep-sphere", material=STEEL, pressure=pressure, **POPULATION))
    ta.set_threads(before)
    assert found[0] == found[1] == found[2]
    shuffled = np.random.default_rng(1).permutation(5000)
    mixed = ta.contact(model="ep-sphere", material=STEEL, pressure=pressure[shuffled], **POPULATION)
    assert np.array_equal(mixed.area_fraction, found[0].area_fraction[shuffled])
    alone = ta.contact(model="ep-sphere", material=STEEL, pressure=pressure[1234], **POPULATION)
    assert alone.area_fraction == found[0].area_fraction[1234]


def test_arguments_broadcast_as_those_of_a_ufunc() -> None:
    radius = np.array([1e-6, 2e-6, 3e-6])[:, None]
    pressure = np.array([1e6, 2e6, 3e6, 4e6])
    found = hertz(radius=radius, pressure=pressure)
    assert found.area_fraction.shape == (3, 4)
    assert found.area_fraction[2, 1] == hertz(radius=3e-6, pressure=2e6).area_fraction
    materials = np.array([STEEL, STEEL.replace(youngs_modulus="70 GPa")])
    by_material = hertz(material=materials[:, None], pressure=pressure)
    assert by_material.area_fraction.shape == (2, 4)
    assert np.all(by_material.area_fraction[1] > by_material.area_fraction[0])
    # Of one state the results are plain numbers.
    one = hertz()
    assert isinstance(one.area_fraction, float) and np.ndim(one.area_fraction) == 0
    assert hertz(pressure=np.array(1e6)) == one
    assert hertz(pressure=[]).area_fraction.shape == (0,)
    assert hertz(pressure=np.empty((0, 3)), radius=np.ones((1, 3))).area_fraction.shape == (0, 3)


@pytest.mark.parametrize(
    "pressure",
    [
        np.array([1000000, 2000000, 3000000]),
        np.array([1e6, 2e6, 3e6], dtype=">f8"),
        np.array([1e6, 2e6, 3e6], dtype=np.float32),
        np.array([1e6, 0.0, 2e6, 0.0, 3e6])[::2],
        np.array([3e6, 2e6, 1e6])[::-1],
        np.array([[1e6, 5.0], [2e6, 5.0], [3e6, 5.0]])[:, 0],
        np.ma.array([1e6, 2e6, 3e6]),
        [1e6, 2000000, np.float32(3e6)],
        (1e6, 2e6, 3e6),
        ["1 MPa", "2 MPa", "3 MPa"],
    ],
    ids=["integers", "big-endian", "single", "strided", "reversed", "column", "unmasked", "list", "tuple", "text"],
)
def test_numbers_of_any_kind_and_layout_are_taken(pressure: Any) -> None:
    assert np.array_equal(hertz(pressure=pressure).area_fraction, hertz(pressure=[1e6, 2e6, 3e6]).area_fraction)


def test_a_pressure_in_hardnesses_is_another_one_for_each_material() -> None:
    materials = [STEEL, STEEL.replace(yield_strength="2 GPa")]
    assert np.array_equal(hertz(material=materials, pressure="1e-3 H").pressure_pa, [3e6, 6e6])
    assert np.array_equal(hertz(material=materials, pressure=["1 MPa", "2 MPa"]).pressure_pa, [1e6, 2e6])
    with refused_naming("pressures", "H", "materials"):
        hertz(material=materials, pressure=["1e-3 H", "1e-2 H"])


@pytest.mark.parametrize(
    ("changes", "told"),
    [
        ({"pressure": [1e6, np.nan]}, "element [1]: pressure NaN;"),
        ({"pressure": -1.0}, "pressure -1;"),
        ({"pressure": [[1e6], [np.inf]]}, "element [1, 0]: pressure inf"),
        ({"pressure": "5"}, "pressure: '5'"),
        ({"pressure": ["1 MPa", "2 m"]}, "pressure[1]: '2 m' 'm'"),
        ({"radius": [1e-6, -1e-6]}, "element [1]: radius -1e-6;"),
        ({"sigma_s": 0.0}, "height"),
        ({"pressure": [1e6, 2e6], "radius": [1e-6] * 3}, "radius (3,), pressure (2,)"),
        ({"pressure": [True]}, "pressure: bool"),
        ({"pressure": 1j}, "pressure: complex128"),
        ({"pressure": np.array(["2020-01-01"], dtype="M8[D]")}, "pressure: datetime64"),
        ({"pressure": [[1.0], [1.0, 2.0]]}, "pressure: array"),
        ({"pressure": [None]}, "pressure: object"),
        ({"pressure": np.ma.array([1e6, 2e6], mask=[False, True])}, "pressure: 1 of 2 masked"),
        ({"pressure": None}, "pressure separation"),
        ({"separation": 1e-9}, "pressure separation"),
        ({"radius": None}, "radius hertz"),
        ({"m0": 1.0}, "m0 hertz"),
        ({"model": "herz"}, "model: 'herz' hertz"),
        ({"strain_gradient": True}, "strain_gradient hertz ep-sphere, ep-sine"),
        ({"model": "ep-sphere", "hardness_formula": "soft"}, "hardness_formula: 'soft' 2005"),
        ({"model": "ep-sphere", "material": ta.Material(1e9, 0.3)}, "yield strength material"),
        ({"material": "steel"}, "material: 'steel' 100Cr6"),
        ({"tolerance": 0.0}, "tolerance 0;"),
    ],
)
def test_what_cannot_be_used_is_refused_with_the_argument(changes: dict[str, Any], told: str) -> None:
    with refused_naming(*told.split()):
        hertz(**changes)


def test_a_pressure_beyond_complete_contact_has_no_separation_and_says_so() -> None:
    found = ta.contact(model="elastic-sine", material=STEEL, pressure=[1e6, 1e20], **POPULATION)
    assert np.isnan(found.separation_m[1]) and found.area_fraction[1] == 1.0
    assert any("1 of 2" in note for note in found.notes)


def test_a_spectrum_narrower_than_any_surface_has_no_state_and_says_so() -> None:
    found = ta.contact(model="bgt", material=STEEL, m0=[1e-16, 1e-17], m2=1e-2, m4=[1e14, 1e12], pressure=1e6)
    assert found.area_fraction[0] > 0.0 and np.isnan(found.area_fraction[1])
    assert any("alpha" in note for note in found.notes)


def test_results_are_mappings_frames_datasets_and_pickles() -> None:
    found = hertz(pressure=[1e6, 2e6])
    assert list(found)[:3] == ["separation_m", "pressure_pa", "area_fraction"] and len(found) == 8
    frame = found.to_pandas()
    assert frame.shape == (2, 11) and frame["area_fraction"].tolist() == found.area_fraction.tolist()
    data = found.to_xarray()
    assert data["pressure_pa"].attrs["units"] == "Pa" and data["area_fraction"].dims == ("state",)
    again = pickle.loads(pickle.dumps(found))
    assert again == found and again.notes == found.notes
    assert "pressure_pa" in repr(found) and "MPa" not in repr(found) and "Pa" in repr(found)
    assert "<table>" in found._repr_html_()
    with refused_naming("ContactStates", "area", by=AttributeError):
        getattr(found, "area")


def test_a_frame_without_pandas_says_what_to_install(monkeypatch: pytest.MonkeyPatch) -> None:
    for module, make in (("pandas", hertz().to_pandas), ("xarray", hertz().to_xarray)):
        monkeypatch.setitem(sys.modules, module, None)
        with refused_naming(f"to_{module}", f"truearea[{module}]", by=ImportError):
            make()


MEMORY = """
import numpy as np, resource, truearea as ta
rows = 4_000_000
pressure = np.geomspace(1e3, 1e6, rows)
steel = ta.Material("210 GPa", 0.3)
call = lambda pressure: ta.contact(model="hertz", material=steel, radius=1e-6, density=1e12, sigma_s=1e-8, pressure=pressure)
call(pressure[:1000])
before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
found = call(pressure)
grown = 1024 * (resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before)
print(grown / (8 * rows), len(found))
"""


def test_contiguous_doubles_are_not_copied() -> None:
    done = subprocess.run([sys.executable, "-c", MEMORY], check=True, capture_output=True, text=True)
    columns_grown, columns_found = map(float, done.stdout.split())
    # A copy of the pressures, or of a broadcast argument, would be one more.
    assert columns_grown < columns_found + 0.5, done.stdout


INTERRUPTED = """
import os, signal, threading, numpy as np, truearea as ta
steel = ta.Material("210 GPa", 0.3, yield_strength="1 GPa")
threading.Timer(0.5, lambda: os.kill(os.getpid(), signal.SIGINT)).start()
try:
    ta.contact(model="ep-sine", material=steel, radius=1e-6, density=1e12, sigma_s=1e-8, pressure=np.geomspace(1e3, 1e9, 100_000_000))
except KeyboardInterrupt:
    print("ended")
"""


def test_ctrl_c_ends_the_work() -> None:
    done = subprocess.run([sys.executable, "-c", INTERRUPTED], capture_output=True, text=True, timeout=60)
    assert done.stdout == "ended\n", done.stderr


def test_another_process_that_splits_off_can_work_too() -> None:
    hertz(pressure=np.geomspace(1e3, 1e6, 5000))
    script = """
import os, numpy as np, truearea as ta
steel = ta.Material("210 GPa", 0.3)
call = lambda: ta.contact(model="hertz", material=steel, radius=1e-6, density=1e12, sigma_s=1e-8, pressure=np.geomspace(1e3, 1e6, 5000))
ta.set_threads(2)
mine = call()
child = os.fork()
if child == 0:
    os._exit(0 if call() == mine else 1)
print(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]))
"""
    done = subprocess.run([sys.executable, "-W", "ignore", "-c", script], capture_output=True, text=True, timeout=60)
    assert done.stdout == "0\n", done.stderr


def test_states_of_the_summits_follow_the_reference(reference: Callable[[str], Columns]) -> None:
    table = reference("bgt.csv")
    alpha, separation = numbers(table, "alpha"), numbers(table, "d_over_sqrt_m0")
    m0, m2 = 1e-16, 1e-2
    m4: Floats = alpha * m2**2 / m0
    steel = ta.Material(2e11, 0.3)
    found = ta.contact(model="bgt", material=steel, m0=m0, m2=m2, m4=m4, separation=separation * m0**0.5)
    # Beyond the nominal area the model is held at it.
    assert np.max(np.abs(found.area_fraction / np.minimum(numbers(table, "bgt_area"), 1.0) - 1.0)) < 1e-9


def test_frames_of_states_have_the_populations_and_the_index() -> None:
    pandas = pytest.importorskip("pandas")
    frame = pandas.DataFrame({"radius": [1e-6, 2e-6], "density": 1e12, "sigma_s": 1e-8}, index=["a", "b"])
    states = ta.contact(frame, ta.Material(70e9, 0.3), model="hertz", pressure=frame["radius"] * 1e12)
    frame["radius"] = 0.0
    for found in (states, pickle.loads(pickle.dumps(states))):
        shown = found.to_pandas()
        assert list(shown.index) == ["a", "b"] and list(shown.radius_m) == [1e-6, 2e-6]
        assert list(shown.pressure_pa) == [1e6, 2e6] and list(shown.columns[:3]) == ["radius_m", "density_per_m2", "sigma_s_m"]
    summits = ta.contact(m0=1e-15, m2=1e-3, m4=1e10, material=ta.Material(70e9, 0.3), model="bgt", pressure=1e5)
    assert summits.to_pandas().m4_per_m2.tolist() == [1e10]


def test_a_population_that_is_not_used_is_refused() -> None:
    spheres: dict[str, float] = {"radius": 1e-6, "density": 1e12, "sigma_s": 1e-8}
    with refused_naming("population"):
        ta.contact(spheres, ta.Material(70e9, 0.3), model="hertz", pressure=1e6, **spheres)  # type: ignore[arg-type]
