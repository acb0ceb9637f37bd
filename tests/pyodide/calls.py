"""Calls whose answers are compared between Pyodide and the native build of the same sources.

Pyodide writes them with :func:`write_answers`. ``python calls.py with-arrays`` or ``without-arrays`` compares such text on its
standard input with the answers of its own interpreter.
"""

import importlib.metadata
import importlib.util
import json
import math
import re
import sys
import tempfile
import warnings
from collections.abc import Iterator
from importlib.machinery import EXTENSION_SUFFIXES
from pathlib import Path
from types import ModuleType, SimpleNamespace
from typing import Any

SPECTRA = ["builtin:uncd-measured", "builtin:uncd-reconstructed"]
MATERIALS = ["100Cr6", "silver", "annealed copper", "hard copper", "aluminium 6061-T6", "stainless steel 304", "NBR 70 Shore A"]
SCENES = ["bolted-joint", "contact-challenge", "electrical-contact", "gasket", "uncd-measured", "uncd-reconstructed"]

NUMBER = re.compile(r"-?\d+(?:\.\d+)?(?:e[-+]?\d+)?")

# Largest relative differences of answers that need functions which C libraries round differently, or Fourier transforms; elements
# are iterated, too. All other answers are equal to the last digit.
ROUNDING = {"bgt": 1e-12, "scan": 1e-12, "roughness": 1e-12, "tangential": 1e-12, "elements": 1e-9}


def load_extension() -> ModuleType:
    """Loads the extension of the installed package without the package."""
    files = importlib.metadata.files("truearea") or []
    [path] = [file.locate() for file in files if file.name.startswith("_native.") and file.name.endswith(tuple(EXTENSION_SUFFIXES))]
    spec = importlib.util.spec_from_file_location("truearea._native", path)
    assert spec is not None and spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def ask_without_arrays() -> dict[str, Any]:
    """Asks the extension alone for materials, spectra, laws, scenes, a scan, messages and a file."""
    native = load_extension()
    answers: dict[str, Any] = {
        "version": native.VERSION,
        "models": native.models_table(),
        "words": [native.pressure_in_words(pressure_pa) for pressure_pa in (5e6, 1.234e9, 0.1)],
    }
    for name in MATERIALS:
        answers[f"material {name}"] = native.Material({"name": name}).facts

    diamond = native.Material({"youngs_modulus": "463 GPa", "poisson_ratio": 0.2, "yield_strength": "1.8 GPa"})
    annealed = native.Material({"name": "annealed copper"})
    copper = native.Material({"name": "hard copper", "counterface": annealed})
    for name in SPECTRA:
        surface = native.Surface.of_file(name, None, {})
        answers[f"spectrum {name}"] = [bytes(surface.csv()).decode(), surface.svg()]
        for model in ("persson", "hertz", "ep-sphere", "elastic-sine", "ep-sine", "bgt"):
            law = native.FoundLaw(surface, diamond, law_arguments(model=model))
            answers[f"law {name} {model}"] = [law.cut_pressure_pa, law.interpolation_error] + [
                law.to_text(dialect, units, "ROUGH", "table")
                for dialect, units in (("abaqus", "N-mm"), ("calculix", "uN-um"), ("csv", "SI"))
            ]
        exponential = native.FoundLaw(surface, diamond, law_arguments())
        answers[f"exponential law {name}"] = exponential.to_text("calculix", "N-mm", "ROUGH", "exponential")
        for quantity, model in (("heat", "persson"), ("current", "persson"), ("heat", "yovanovich")):
            law = native.FoundLaw(surface, copper, law_arguments(model=model, quantity=quantity))
            answers[f"{quantity} {name} {model}"] = law.to_text("csv", "SI", "", "")

    for name in SCENES:
        text = native.scene_template(name)
        scene = native.Scene(text, f"{name}.toml", None, {}, {}, None)
        answers[f"scene {name}"] = [scene.facts, scene.explain()]

    scan = "# x/um z/um\n" + "".join(f"{at * 0.5} {(at * at * 7919 % 1009) / 1009 - 0.5}\n" for at in range(512))
    files = {"profile.txt": scan.encode()}
    part = SimpleNamespace(name="profile.txt", files=files)
    answers["scan"] = bytes(native.composite("profile", [(part, {})], {}, "scans").csv()).decode()

    answers["messages"] = [find_message(native, arguments) for arguments in ({"name": "unobtainium"}, {"youngs_modulus": "463 Gpz"})]
    with tempfile.TemporaryDirectory() as folder:
        native.write_files(folder, {"law.csv": b"a,b\n1,2\n"})
        answers["files"] = {path.name: path.read_text() for path in Path(folder).iterdir()}
    return answers


def law_arguments(**options: Any) -> dict[str, Any]:
    """Arguments of a law from 10 kPa to 10 MPa."""
    return {"pressure": ["10 kPa", "10 MPa"], "tolerance": 0.01, "quantity": "pressure", "model": "persson"} | options


def find_message(native: ModuleType, arguments: dict[str, Any]) -> str:
    """Returns the message by which a material is refused."""
    try:
        native.Material(arguments)
    except native.InputError as error:
        return str(error)
    raise AssertionError(f"{arguments} is no material")


def ask_with_arrays() -> dict[str, Any]:
    """Asks the whole package, which needs numpy, for tables, maps and a report."""
    import numpy as np

    import truearea as ta

    warnings.simplefilter("ignore", ta.Caution)
    uncd = ta.read_psd("builtin:uncd-measured")
    diamond = ta.Material("463 GPa", 0.2, yield_strength="1.8 GPa")
    loads = ["1 MPa", "5 MPa"]
    along = np.arange(64)
    heights_m = 1e-7 * np.sin(0.3 * along)[:, None] * np.cos(0.2 * along)[None, :]
    tables = {
        "stacked": ta.stacked(uncd, diamond, pressure=loads),
        "statistical": ta.statistical(uncd, diamond, model="gw", pressure=loads),
        "persson": ta.persson(uncd, diamond, pressure=loads),
        "gap": ta.gap(uncd, diamond, pressure=loads),
        "law": ta.law(uncd, diamond, pressure=("10 kPa", "10 MPa")),
        "moments": uncd.moments(),
        "contact": ta.contact(radius=1e-6, density=1e12, sigma_s=10e-9, material=diamond, model="ep-sphere", pressure=[1e6, 1e8]),
        "contact of two": ta.contact(
            radius=1e-6, density=1e12, sigma_s=10e-9, material=[diamond, "100Cr6"], model="hertz", pressure=1e6
        ),
        "tangential": ta.tangential(uncd, diamond, friction=0.3, pressure=loads),
        "uncertainty": ta.uncertainty(uncd, diamond, pressure="1 MPa", model="persson", draws=50, yield_strength="10 %"),
        "roughness": ta.roughness(heights_m, ("1 um", "1 um")),
    }
    answers: dict[str, Any] = {
        f"{call} {name}": np.asarray(array).tolist() for call, table in tables.items() for name, array in table.items()
    }
    pressed = ta.boundary_elements(heights_m, ta.Material("463 GPa", 0.2), size=("1 um", "1 um"), pressure="10 GPa")
    answers["elements"] = {name: np.asarray(pressed[name]).tolist() for name in ("area_fraction", "mean_gap_m", "stiffness_pa_per_m")}
    found = ta.Scene(uncd, diamond, pressure="5 MPa", curves=["persson", "hertz"]).run(judge=False, uncertainty=False)
    answers["scene"] = [found.answer, {name: content.decode() for name, content in found.files.items()}]
    return answers


ANSWERS = {"with-arrays": ask_with_arrays, "without-arrays": ask_without_arrays}


def write_answers(calls: str) -> str:
    """Returns the answers as JSON."""
    return json.dumps(ANSWERS[calls](), sort_keys=True)


def find_differences(found: Any, here: Any) -> Iterator[float]:
    """Yields the relative differences of all numbers that differ, also within text; infinity for anything else that differs."""
    if isinstance(found, dict) and isinstance(here, dict) and found.keys() == here.keys():
        for key in found:
            yield from find_differences(found[key], here[key])
    elif isinstance(found, list) and isinstance(here, list) and len(found) == len(here):
        for left, right in zip(found, here):
            yield from find_differences(left, right)
    elif isinstance(found, str) and isinstance(here, str) and NUMBER.sub("", found) == NUMBER.sub("", here):
        for left, right in zip(NUMBER.findall(found), NUMBER.findall(here)):
            if left != right:
                yield from find_differences(float(left), float(right))
    elif isinstance(found, float) and isinstance(here, float):
        if found != here and not (math.isnan(found) and math.isnan(here)):
            yield abs(found - here) / max(abs(found), abs(here))
    elif found != here:
        yield math.inf


def main() -> None:
    """Compares, prints what differs, and ends with 1 where a difference is too large."""
    calls = sys.argv[1]
    here = json.loads(write_answers(calls))
    found = json.load(sys.stdin)
    assert found.keys() == here.keys()
    equal = 0
    failed = False
    for call, answer in here.items():
        different = list(find_differences(found[call], answer))
        if different:
            largest = max(different)
            failed |= largest > next((bound for name, bound in ROUNDING.items() if name in call), 0.0)
            print(f"{call}: {len(different)} numbers differ, by {largest:.0e} at most")
        else:
            equal += 1
    print(f"{equal} of {len(here)} answers are equal to the last digit")
    sys.exit(failed)


if __name__ == "__main__":
    main()
