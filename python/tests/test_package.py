"""The package as a whole: what it imports, exports, and runs on."""

from __future__ import annotations

import inspect
import os
import re
import subprocess
import sys
import threading
from collections.abc import Callable
from pathlib import Path
from typing import Any, get_args

import numpy as np
import pytest

import truearea as ta
from support import refused_naming
from truearea import _choices
from truearea._choices import GapModel, LawModel, ShearedModel
from truearea._results import unit_of


def test_importing_brings_no_more_than_numpy_and_itself() -> None:
    script = (
        "import sys, numpy; before = set(sys.modules); import truearea; "
        "print(' '.join(sorted({name.split('.')[0] for name in set(sys.modules) - before})))"
    )
    done = subprocess.run([sys.executable, "-c", script], check=True, capture_output=True, text=True)
    # What is slow to import is imported where it is used.
    assert not {"pandas", "xarray", "dask", "distributed", "pyarrow", "scipy", "matplotlib"} & set(done.stdout.split())
    assert "truearea" in done.stdout.split()


def test_all_that_is_exported_is_there_and_documented() -> None:
    for name in ta.__all__:
        assert name in ("__version__", *vars(ta.choices)) or getattr(ta, name).__doc__, name


def test_every_argument_of_a_function_is_documented() -> None:
    for name in ta.__all__:
        function = getattr(ta, name)
        if inspect.isfunction(function):
            entries = inspect.getdoc(function) or ""
            arguments = [argument for argument in inspect.signature(function).parameters if argument != "count"]
            assert all(re.search(rf"^(\w+, )*{argument}(, \w+)*( :|$)", entries, re.MULTILINE) for argument in arguments), name


def test_an_unknown_option_is_refused_with_the_nearest_name() -> None:
    other: Any = {"gama": 0.5}
    with pytest.raises(TypeError, match="gap.* gama; did you mean gamma?"):
        ta.gap("builtin:uncd-measured", "C45", pressure=1.0, **other)


def test_the_module_prints_versions() -> None:
    done = subprocess.run([sys.executable, "-m", "truearea"], check=True, capture_output=True, text=True)
    assert f"truearea    {ta.__version__}" in done.stdout and f"numpy       {np.__version__}" in done.stdout
    assert "command" in done.stdout


def test_input_errors_are_value_errors() -> None:
    assert issubclass(ta.InputError, ValueError)
    assert ta.InputError.__module__ == "truearea"


def test_threads_are_chosen_or_refused() -> None:
    before = ta.threads()
    ta.set_threads(3)
    assert ta.threads() == 3
    with refused_naming("count", "0;", "1"):
        ta.set_threads(0)
    ta.set_threads(before)


def test_threads_of_python_work_side_by_side() -> None:
    steel = ta.Material("210 GPa", 0.3, yield_strength="1 GPa")
    pressure = np.geomspace(1e3, 1e9, 20_000)
    before = ta.threads()
    ta.set_threads(1)
    found: list[ta.ContactStates] = []

    def work() -> None:
        found.append(
            ta.contact(model="ep-sphere", material=steel, radius=1e-6, density=1e12, sigma_s=1e-8, pressure=pressure)
        )

    workers = [threading.Thread(target=work) for _ in range(4)]
    for worker in workers:
        worker.start()
    for worker in workers:
        worker.join()
    ta.set_threads(before)
    assert len(found) == 4 and all(one == found[0] for one in found)


def test_types_of_names_are_those_that_the_crates_know(of_crates: Callable[[str], Any]) -> None:
    known: dict[str, list[str]] = of_crates("choices.json")
    for name, names in known.items():
        # Words that are shared with another choice.
        shared = {"Detrend": ["none"], "Form": ["mean"]}.get(name, [])
        assert set(get_args(getattr(_choices, name))) == {*names, *shared}, name
    others = {name for name in vars(_choices) if name[0].isupper() and name != "Literal"} - set(known)
    assert others == {"ConductanceModel", "EnergyFactor", "GapModel", "MapGaps", "ShearedModel"}
    correlations = get_args(_choices.ConductanceCorrelation)
    assert set(get_args(_choices.ConductanceModel)) == {*get_args(LawModel), *correlations}
    assert set(get_args(GapModel)) == {*get_args(LawModel), "bem"}
    spectrum, steel = ta.read_psd("builtin:uncd-measured"), ta.Material("210 GPa", 0.3, yield_strength="1 GPa")
    for model in get_args(LawModel):
        assert ta.gap(spectrum, steel, pressure="1 MPa", model=model).mean_gap_m.shape == (1,)
    for shear in get_args(ShearedModel):
        if shear != "bem":
            assert ta.tangential(spectrum, steel, friction=0.3, pressure="10 MPa", model=shear).sizes


def test_units_are_those_that_names_end_in() -> None:
    units = {"conductance_s_per_m2": "S/m²", "density_per_m2": "1/m²", "rms_curvature_heights_per_m": "1/m", "stiffness_pa_per_m": "Pa/m"}
    units |= {"wavevector_rad_per_m": "rad/m", "mean_gap_m": "m", "area_fraction": "", "ln_pressure_pa": ""}
    assert {name: unit_of(name) for name in units} == units


def test_typos_are_errors_of_types(tmp_path: Path) -> None:
    """A mistyped attribute, model or choice is found by a type checker before the program runs."""
    good = [
        "curve = ta.persson(u, 'C45', pressure=1.0)",
        "curve.area_fraction",
        "ta.gap(u, 'C45', pressure=1.0, model='bem').mean_gap_m",
        "ta.Scene.template('gasket').scales().any_column_of_a_scene",
        "ta.contact({'radius': 1.0}, ta.Material('C45'), model='hertz', pressure='1 MPa').area_fraction",
        "each: list[ta.StackedModel] = ['elastic', 'elastic-plastic']; [ta.stacked(u, 'C45', pressure=[1e6, '5 MPa'], model=model) for model in each]",
        "detrend: ta.choices.Detrend = 'mean'; ta.boundary_elements(u, 'C45', pressure=1.0, size=['1 um', 2e-6], detrend=detrend)",
    ]
    bad = [
        "ta.persson(u, 'C45', pressure=1.0).area_fractoin",
        "ta.persson(u, 'C45', pressure=1.0, model='persson-plastik')",
        "ta.persson(u, 'C45', pressure=1.0, correction='wang')",
        "ta.stacked(u, 'C45', pressure=1.0, amplitude='eq6')",
        "ta.statistical(u, 'C45', pressure=1.0, model='hertzian')",
        "ta.statistical(u, 'C45', pressure=1.0, model='hertz', interference_law='bemm')",
        "ta.gap(u, 'C45', pressure=1.0, model='hertzz')",
        "ta.law(u, 'C45', pressure=(1.0, 2.0)).to_text('abacus')",
        "ta.boundary_elements(u, 'C45', pressure=1.0, phases='random')",
        "ta.adhesion(u, 'C45', pressure=1.0, work_of_adhesion=1.0, adhesion_range=1.0, branch='up')",
        "ta.pull_off(u, 'C45', work_of_adhesion=1.0, adhesion_range=1.0).pull_off_pa",
        "ta.boundary_elements(u, 'C45', pressure=1.0).area_fractions",
        "ta.uncertainty(u, 'C45', pressure=1.0, model=['hertz', 'persso'])",
        "ta.Spectrum.from_heights([0.0], 1.0, window='han')",
        "ta.composite([], gaps='fill')",
        "ta.read_psd('file', convention='c2d')",
        "ta.Scene.template('gaskets')",
        "ta.roughness('file', form='cubic')",
        "ta.contact({'radius': 1.0}, ta.Material('C45'), model='hertz', pressure=1.0, errors='skip')",
    ]
    head = "import truearea as ta\nu = ta.read_psd('builtin:uncd-measured')\n"
    path = tmp_path / "typed.py"
    path.write_text(head + "\n".join([*good, *bad]) + "\n")
    # An installed package is found by itself, and mypy refuses its folder as a path.
    folder = Path(ta.__file__).parents[1]
    environment = os.environ if folder.name == "site-packages" else {**os.environ, "MYPYPATH": str(folder)}
    program = [sys.executable, "-m", "mypy", "--strict", "--no-error-summary", str(path)]
    done = subprocess.run(program, capture_output=True, text=True, env=environment, cwd=tmp_path)
    found = {int(line.split(":")[1]) for line in done.stdout.splitlines() if ": error:" in line}
    first = 1 + head.count("\n") + len(good)
    assert found == set(range(first, first + len(bad))), done.stdout + done.stderr


def test_arrays_of_results_are_those_that_types_declare() -> None:
    spectrum, steel = ta.read_psd("builtin:uncd-measured"), ta.Material("100Cr6")
    wave = 1e-8 * np.cos(np.linspace(0.0, 6.0, 16)) * np.ones((16, 1))
    found: list[ta.Result] = [
        spectrum.moments(),
        spectrum.amplitudes(),
        spectrum.fit(),
        spectrum.table(),
        ta.persson(spectrum, steel, pressure="5 MPa"),
        ta.stacked(spectrum, steel, pressure="5 MPa"),
        ta.statistical(spectrum, steel, pressure="5 MPa", model="ep-sphere"),
        ta.gap(spectrum, steel, pressure="5 MPa"),
        ta.law(spectrum, steel, pressure=("1 MPa", "5 MPa")),
        ta.law(spectrum, steel, pressure=("1 MPa", "5 MPa"), quantity="heat", thermal_conductivity=46.0, counterface_thermal_conductivity=46.0),
        ta.law(spectrum, ta.Material("hard copper"), pressure=("1 MPa", "5 MPa"), quantity="current", counterface_resistivity=2e-8),
        ta.tangential(spectrum, steel, friction=0.3, pressure="5 MPa", tangential_stress="1 MPa"),
        ta.contact(radius=1e-6, density=1e12, sigma_s=1e-8, material=steel, model="hertz", pressure=1e6),
        ta.boundary_elements(wave, steel, pressure="5 MPa", size="1 um", fields=True),
        ta.boundary_elements(wave * np.ones((2, 1, 1)), steel, pressure="5 MPa", size="1 um"),
        ta.pull_off(wave, steel, size="1 um", periodic=True, work_of_adhesion=0.5, adhesion_range="20 nm"),
        ta.adhesion(
            wave, steel, pressure=1e6, size="1 um", periodic=True, branch="both", work_of_adhesion=0.5, adhesion_range="20 nm"
        ),
        ta.uncertainty(spectrum, steel, pressure="5 MPa", model="persson", draws=40, youngs_modulus="5 %"),
        ta.roughness(wave, "1 um"),
        ta.materials(),
        ta.models(),
    ]
    for result in found:
        declared = {name for kind in type(result).__mro__ for name in vars(kind).get("__annotations__", {})}
        assert set(result) <= declared, type(result)
        assert result._repr_html_().startswith("<div>"), type(result)
