"""The package as a whole: what it imports, exports, and runs on."""

from __future__ import annotations

import subprocess
import sys
import threading
from typing import get_args

import numpy as np

import truearea as ta
from support import refused_naming
from truearea._choices import GapModel, LawModel, ShearedModel, StackedModel, StatisticalModel


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
        assert name == "__version__" or getattr(ta, name).__doc__, name


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


def test_types_of_names_are_those_that_the_crates_know() -> None:
    known = ta.models()
    of = {framework: set(known.model[known.framework == framework]) for framework in set(known.framework)}
    typed = [set(get_args(choices)) for choices in (StackedModel, StatisticalModel)]
    assert typed[0] in of.values() and typed[1] in of.values()
    assert set(get_args(GapModel)) == {*get_args(LawModel), "bem"}
    spectrum, steel = ta.read_psd("builtin:uncd-measured"), ta.Material("210 GPa", 0.3, yield_strength="1 GPa")
    for model in get_args(LawModel):
        assert ta.gap(spectrum, steel, pressure="1 MPa", model=model).mean_gap_m.shape == (1,)
    for shear in get_args(ShearedModel):
        if shear != "bem":
            assert ta.tangential(spectrum, steel, friction=0.3, pressure="10 MPa", model=shear).sizes
