"""No argument is passed over in silence: in every context, each changes what comes out, is named as without effect, or is refused
by name. Callables and their arguments are those of the package; a public callable without a context fails."""

from __future__ import annotations

import contextlib
import inspect
import io
import itertools
import os
import re
import sys
import typing
import warnings
import zipfile
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import matplotlib
import numpy as np
import pytest
from matplotlib.axes import Axes
from matplotlib.figure import Figure

import truearea as ta

matplotlib.use("agg")

# The calls walk every pair of context and argument where this is set, and else one in so many.
STEP = 1 if os.environ.get("TRUEAREA_EVERY_CALL") else 11

IDLE_BY_RIGHT: tuple[tuple[str, str, str], ...] = (
    ("hertz", "tolerance", "its integrals have a closed form"),
    ("bgt", "tolerance", "likewise"),
    ("persson-plastic, growing", "seed", "all flows: neither the surface nor the elastic constants count"),
    ("persson-plastic, growing", "youngs_modulus", "likewise"),
    ("persson-plastic, growing", "poisson_ratio", "likewise"),
    ("uncertainty persson-plastic", "shares_draws", "likewise"),
    ("ball spectrum", "tolerance", "few points agree to all digits at any tolerance"),
    ("", "errors", "without a bad number there is nothing to treat"),
    ("", "gaps", "a scan without missing points has nothing to treat"),
    ("", "all_channels", "a file of one channel has no other"),
    ("", "progress", "work that ends within some 50 ms shows none"),
)
"""Arguments that change nothing by right: words of the contexts in which, the argument, and the reason."""

GROWING: dict[str, Any] = dict(yield_strength="100 MPa", strain_gradient_length="1 um")
LAYER: dict[str, Any] = dict(layer_thickness="5 um", layer_youngs_modulus="20 GPa", layer_poisson_ratio=0.4)


def steel(**more: Any) -> ta.Material:
    return ta.Material("200 GPa", 0.3, **more)


BODIES: dict[str, ta.Material] = {
    "elastic": steel(),
    "hard": steel(indentation_hardness="300 MPa"),
    "growing": steel(**GROWING),
    "named": ta.Material("silver", counterface=ta.Material("gold")),
    "paired": steel(counterface=ta.Material("70 GPa", 0.2)),
    "layered": steel(**LAYER),
    "on-rigid": ta.Material(layer_base="rigid", **LAYER),
}
HEAT = dict(quantity="heat", thermal_conductivity="20 W/(m K)", counterface_thermal_conductivity="40 W/(m K)")
CURRENT = dict(quantity="current", resistivity="2e-8 ohm m", counterface_resistivity="3e-8 ohm m")
GRID = dict(grid=32, realisations=1, shortest="2 um")


def height(x: Any) -> Any:
    """Heights [um] of points, of many wavelengths."""
    return sum(0.05 / n**1.5 * np.sin(n * 0.7 * x + n * n) for n in range(1, 40))


MAP = 1e-6 * np.array([height(0.3 * np.arange(32) + 1.7 * y) for y in range(32)])
HOLED = np.ma.masked_array(MAP, mask=np.arange(1024).reshape(32, 32) % 97 == 5)
TRACE = 1e-6 * height(0.1 * np.arange(512))
WAVELENGTHS = 1e-5 * 10 ** (-np.arange(24) / 12)
# Resampling changes a spectrum with noise, and not a power law.
C1D = 4e-21 * (1 + 0.4 * np.sin(2.3 * np.arange(24) ** 2)) * (WAVELENGTHS / 1e-5) ** 2.6
PSD = ta.Spectrum(2 * np.pi / WAVELENGTHS, C1D, 0.1 * C1D)
MAPS = ta.composite([(MAP, "10 um"), (MAP[::-1], "10 um")], instrument=["a", "b"])
SPHERES: dict[str, Any] = dict(radius=1e-6, density=1e12, sigma_s=1e-8)
SUMMITS: dict[str, Any] = dict(m0=1e-15, m2=1e-3, m4=1e10)
SCENE = """\
[surface]
psd = "psd.csv"
[material]
youngs_modulus = "200 GPa"
poisson_ratio = 0.3
yield_strength = "100 MPa"
[loads]
pressures = ["10 MPa", "100 MPa"]
[[curve]]
model = "elastic"
"""
READY = ta.Scene(PSD, steel(), pressure="10 MPa", curves=["elastic"])


def product(length: float, width: float) -> float:
    return length * width


class Client:
    """As much of Dask's client as a sweep uses."""

    def scatter(self, rows: Any, **_: Any) -> Any:
        return rows

    def map(self, call: Any, rows: Any, parts: Any, *, folder: Any, pure: bool) -> list[Any]:
        print("on a worker")
        return [call(row, part, folder=folder) for row, part in zip(rows, parts)]

    def gather(self, done: Any) -> Any:
        return done


Alternatives = dict[str, dict[str, Any]]


def bodies(*names: str) -> Alternatives:
    return {name: dict(material=BODIES[name]) for name in names or BODIES}


def words(**arguments: typing.Any) -> Alternatives:
    """One alternative for each word of the type of an argument."""
    [(name, kind)] = arguments.items()
    return {word: {name: word, **(GRID if word == "bem" else {})} for word in literal(kind)}


def literal(kind: Any) -> list[str]:
    """The words of a type."""
    if typing.get_origin(kind) is typing.Literal:
        return [word for word in typing.get_args(kind) if isinstance(word, str)]
    return [word for part in typing.get_args(kind) for word in literal(part)]


SURFACES: Alternatives = {
    "spectrum": dict(surface=PSD, **GRID),
    "free map": dict(surface=MAP, size="10 um"),
    "periodic map": dict(surface=MAP, size="10 um", periodic=True),
    "maps": dict(surface=np.array([MAP, MAP[::-1]]), size="10 um", periodic=True),
}
PERIODIC = {name: given for name, given in SURFACES.items() if name != "free map"}
ATTRACTION = dict(work_of_adhesion="50 mJ/m^2", adhesion_range="1 um")
FILES: Alternatives = {
    "trace": dict(path="trace.txt", unit="um"),
    "named trace": dict(path="named.txt"),
    "map file": dict(path="map.txt", unit="um", size="10 um"),
    "map of holes": dict(path="holes.txt", unit="um", size="10 um"),
    "channels": dict(path="two.mi"),
    "container": dict(path="plate.zip", measurement="second"),
}
Walks = dict[str, list[tuple[dict[str, Any], list[Alternatives]]]]


def walks() -> Walks:
    """Each callable with what it is called on or with, and alternatives of which each context takes one."""
    ready = ta.Scene(PSD, steel(), pressure="10 MPa", curves=["elastic"])
    results = ready.run(report=False)
    uncertain = ta.uncertainty(MAPS, steel(), pressure=1e6, model=["elastic", "persson"], draws=20)
    law = ta.law(PSD, steel(), pressure=("1 MPa", "50 MPa"))
    return {
        "stacked": [(dict(surface=PSD, pressure="50 MPa"), [words(model=ta.choices.StackedModel), bodies()])],
        "statistical": [
            (
                dict(surface=PSD, tolerance=1e-6),
                [
                    words(model=ta.choices.StatisticalModel),
                    bodies(),
                    {"": dict(pressure="50 MPa"), "apart": dict(separation="10 nm")},
                ],
            )
        ],
        "persson": [
            (
                dict(surface=PSD, pressure="50 MPa"),
                [
                    words(model=ta.choices.PerssonModel),
                    bodies(),
                    {"": {}, "power": dict(hardness_law="power:0.2"), "nix-gao": dict(hardness_law="nix-gao")}
                    | {"corrected": dict(correction="algebraic-nayak")},
                ],
            )
        ],
        "gap": [(dict(surface=PSD, pressure="50 MPa"), [words(model=ta.choices.GapModel), bodies()])],
        "tangential": [
            (dict(surface=PSD, pressure="50 MPa", friction=0.3), [words(model=ta.choices.ShearedModel), bodies()]),
        ],
        "law": [
            (
                dict(surface=PSD, pressure=("1 MPa", "50 MPa"), tolerance=0.1),
                [
                    words(model=ta.choices.ConductanceModel),
                    bodies(),
                    {"": {}, "heat": HEAT, "gas": dict(**HEAT, gas="air"), "current": CURRENT},
                ],
            )
        ],
        "boundary_elements": [
            (
                {},
                [
                    SURFACES,
                    bodies(),
                    {"": dict(pressure="50 MPa"), "flows": dict(pressure="50 MPa", saturation="200 MPa")}
                    | {"held": dict(mean_gap="40 nm"), "moved": dict(indentation="20 nm")}
                    | {"leaks": dict(pressure="50 MPa", flow=True)},
                ],
            )
        ],
        "flow": [({}, [{"array": dict(gap=MAP + 1e-6, size="10 um"), "gap file": dict(gap="map.txt", unit="um", size="10 um")}])],
        "ball": [(dict(radius="500 um", force="500 uN"), [{name: SURFACES[name] for name in ("spectrum", "free map")}, bodies()])],
        "adhesion": [
            (dict(pressure="50 MPa", **ATTRACTION), [PERIODIC, bodies(), words(branch=ta.choices.Branch)]),
        ],
        "pull_off": [(ATTRACTION, [PERIODIC, bodies()])],
        "contact": [
            (
                dict(tolerance=1e-6),
                [
                    {name: dict(model=name, **(SUMMITS if name == "bgt" else SPHERES)) for name in literal(ta.choices.StatisticalModel)},
                    bodies(),
                    {"": dict(pressure="50 MPa"), "apart": dict(separation=[1e-8, 2e-8])},
                ],
            ),
            (dict(SPHERES, model="ep-sphere", pressure=[1e6, -1.0], errors="nan"), [bodies("hard")]),
            (dict(population=dict(SPHERES, **SUMMITS), pressure=1e6, tolerance=1e-6), [words(model=ta.choices.StatisticalModel), bodies("hard")]),
        ],
        "uncertainty": [
            (
                dict(surface=PSD, pressure="500 kPa", draws=20, youngs_modulus="3 %"),
                [words(model=ta.choices.CurveModel), bodies("elastic", "growing", "named", "paired")],
            ),
            (dict(surface=MAPS, pressure="50 MPa", draws=20, model=["elastic", "persson"]), [bodies("elastic")]),
        ],
        "composite": [
            ({}, [{"array": dict(scans=[(MAP, "10 um")]), "gaps": dict(scans=[(HOLED, "10 um")])}
                  | {"line": dict(scans=[(TRACE, "51.2 um")]), "files": dict(scans=["trace.txt", "named.txt"], unit=["um", None])}
                  | {"map file": dict(scans=["map.txt"], unit="um", size="10 um"), "channels": dict(scans=["two.mi"])}]),
        ],
        "Spectrum.from_heights": [
            ({}, [{"map": dict(h=MAP, size="10 um"), "holes": dict(h=HOLED, size="10 um"), "line": dict(h=TRACE, size="51.2 um")}]),
        ],
        "roughness": [
            (
                {},
                [
                    {"map": dict(surface=MAP, size="10 um"), "trace": dict(surface="trace.txt", unit="um")}
                    | {"named trace": dict(surface="named.txt"), "channels": dict(surface="two.mi")},
                    {"": {}, "scales": dict(scales=True)},
                ],
            )
        ],
        "read_scan": [({}, [FILES])],
        "scan_channels": [({}, [{name: given for name, given in FILES.items() if name != "container"}])],
        "read_psd": [
            ({}, [{"csv": dict(path="psd.csv"),
                   "columns": dict(path="columns.csv", column="b", convention="w1"), "bare": dict(path="bare.txt", x="wavevector", x_unit="1/m", convention="c1d")}]),
        ],
        "Spectrum": [(dict(wavevectors=2 * np.pi / WAVELENGTHS, c1d=C1D), [])],
        "Spectrum.moments": [(dict(self=PSD), [])],
        "Spectrum.amplitudes": [(dict(self=PSD), [])],
        "Spectrum.fit": [(dict(self=PSD), [])],
        "Spectrum.against": [(dict(self=PSD, other=MAPS), [])],
        "Spectrum.between": [(dict(self=PSD), [])],
        "Spectrum.write": [(dict(self=PSD, path="out.csv"), [])],
        "Material": [
            ({}, [{"elastic": dict(youngs_modulus="200 GPa", poisson_ratio=0.3), "named": dict(name="silver")}
                  | {"growing": dict(youngs_modulus="200 GPa", poisson_ratio=0.3, **GROWING)}
                  | {"layered": dict(youngs_modulus="200 GPa", poisson_ratio=0.3, **LAYER), "on-rigid": dict(layer_base="rigid", **LAYER)}]),
        ],
        "Material.replace": [(dict(self=BODIES["growing"]), [])],
        "sweep": [
            (dict(swept=product), [{"": dict(axes={"length": [1.0, 2.0], "width": [3.0]})}, {"": {}, "to": dict(to="parts")}]),
        ],
        "set_threads": [(dict(count=1), [])],
        "threads": [({}, [])],
        "report": [(dict(surface=PSD, material=BODIES["hard"], pressure="50 MPa"), [])],
        "Scene": [
            (dict(pressure="50 MPa", material=BODIES["hard"]), [{"spectrum": dict(surface=PSD), "map": dict(surface=MAP, size="10 um")}]),
        ],
        "Scene.from_toml": [(dict(path_or_text="scene.toml"), [])],
        "Scene.template": [(dict(name="gasket"), [])],
        "Scene.replace": [(dict(self=ready), [])],
        "Scene.to_toml": [(dict(self=ready), [])],
        "Scene.report": [(dict(self=ready, folder="out"), [])],
        "Scene.run": [(dict(self=ready), [])],
        "SceneResults": [(vars(results), [])],
        "SceneResults.plot": [(dict(self=results), [])],
        "SceneResults.write": [(dict(self=results, folder="out"), [])],
        "Drawn.plot": [(dict(self=PSD), [])],
        "Uncertainty.plot": [(dict(self=uncertain), [])],
        "Curve.write": [(dict(self=ta.persson(PSD, steel(), pressure=1e6), path="out.csv"), [])],
        "Result": [(dict(arrays={"a": np.ones(2)}, axes={"a": ("row",)}), [])],
        "Result.axes": [(dict(self=ta.persson(PSD, steel(), pressure=1e6), name="band"), [])],
        "_FiniteElementTable.to_text": [(dict(self=law), [words(dialect=ta.choices.Dialect)])],
        "_FiniteElementTable.write": [(dict(self=law, path="out.inp", dialect="calculix"), [])],
        "Note": [(dict(text="a"), [])],
        "Place": [({}, [])],
    }


def _axes() -> Any:
    figure = Figure()
    return figure.subplots(2, 2)


# Two values of each argument that matter, by the names of callable and argument or that of the argument; types have the words.
VALUES: dict[str, list[Any]] = {
    "surface": [ta.Spectrum(2 * np.pi / WAVELENGTHS, C1D * (WAVELENGTHS / 1e-5) ** power) for power in (0.3, 0.6)],
    "counterface_surface": [ta.Spectrum(2 * np.pi / WAVELENGTHS, factor * C1D) for factor in (0.5, 2.0)],
    "surface of heights": [2 * MAP, 3 * MAP],
    "surface of a file": ["trace.txt", "named.txt"],
    "h": [2 * MAP, TRACE],
    "gap": [MAP + 2e-6, 2 * MAP + 2e-6],
    "scans": [[(2 * MAP, "10 um")], [(3 * MAP, "10 um"), (MAP, "10 um")]],
    "material": [steel(yield_strength="50 MPa"), ta.Material("70 GPa", 0.2, indentation_hardness="700 MPa")],
    "counterface": [ta.Material("silver"), ta.Material("210 GPa", 0.3)],
    "pressure": ["20 MPa", "80 MPa"],
    "law.pressure": [("2 MPa", "40 MPa"), ("1 MPa", "10 MPa")],
    "separation": ["5 nm", "20 nm"],
    "mean_gap": ["30 nm", "35 nm"],
    "indentation": ["5 nm", "50 nm"],
    "saturation": ["100 MPa", "300 MPa"],
    "size": ["7 um", "20 um"],
    "grid": [64, 48],
    "realisations": [2, 3],
    "seed": [5, 7],
    "side": ["20 um", "30 um"],
    "longest": ["9 um", "7 um"],
    "shortest": ["3 um", "2500 nm"],
    "cutoff": ["500 nm", "2 um"],
    "uncertainty.cutoff": ["200 nm", "150 nm"],
    "scales_per_decade": [7, 13],
    "bins_per_decade": [3, 5],
    "tolerance": [1e-3, 1e-5],
    "law.tolerance": [2e-4, 0.2],
    "gamma": [0.6, "fitted"],
    "hardness_law": ["power:0.3", "nix-gao"],
    "friction": [0.2, 0.5],
    "tangential_stress": ["1 MPa", "3 MPa"],
    "radius": ["1 mm", "300 um"],
    "contact.radius": ["2 um", "500 nm"],
    "force": ["700 uN", "300 uN"],
    "density": ["2e12 1/m2", 5e11],
    "sigma_s": ["20 nm", 5e-9],
    "m0": [2e-15, 3e-15],
    "m2": [2e-3, 3e-3],
    "m4": [2e10, 3e10],
    "population": [dict(SPHERES, **SUMMITS), dict(radius=2e-6, density=1e12, sigma_s=2e-8, m0=2e-15, m2=2e-3, m4=2e10)],
    "work_of_adhesion": ["20 mJ/m^2", "80 mJ/m^2"],
    "adhesion_range": ["500 nm", "2 um"],
    "draws": [30, 40],
    "shares_draws": [80, 128],
    "level": [0.9, 0.5],
    "youngs_modulus": ["70 GPa", "300 GPa"],
    "poisson_ratio": [0.1, 0.45],
    "yield_strength": ["20 MPa", "150 MPa"],
    "indentation_hardness": ["60 MPa", "450 MPa"],
    "strain_gradient_length": ["300 nm", "5 um"],
    "strength_cap": ["120 MPa", "250 MPa"],
    "layer_thickness": ["1 um", "3 um"],
    "layer_youngs_modulus": ["2 GPa", "300 GPa"],
    "layer_poisson_ratio": [0.1, 0.45],
    "layer_base": ["material", "rigid"],
    "counterface_youngs_modulus": ["3 %", "9 %"],
    "counterface_poisson_ratio": ["3 %", "9 %"],
    "uncertainty.youngs_modulus": ["3 %", "9 %"],
    "uncertainty.poisson_ratio": ["3 %", "9 %"],
    "uncertainty.yield_strength": ["3 %", "9 %"],
    "uncertainty.indentation_hardness": ["3 %", "9 %"],
    "uncertainty.strain_gradient_length": ["3 %", "9 %"],
    "thermal_conductivity": ["10 W/(m K)", "300 W/(m K)"],
    "counterface_thermal_conductivity": ["10 W/(m K)", "300 W/(m K)"],
    "resistivity": ["1e-8 ohm m", "1e-7 ohm m"],
    "counterface_resistivity": ["1e-8 ohm m", "1e-7 ohm m"],
    "gas_temperature": [400.0, 500.0],
    "gas_pressure": ["10 kPa", "1 MPa"],
    "gas_conductivity": ["0.1 W/(m K)", "0.2 W/(m K)"],
    "gas_parameter": ["100 nm", "1 um"],
    "flatness": ["1 um over 10 mm", "5 um over 40 mm"],
    "path": ["named.txt", "trace.txt"],
    "read_psd.path": ["psd.csv", "builtin:uncd-measured"],
    "Spectrum.write.path": ["out.csv", "other.csv"],
    "Curve.write.path": ["out.csv", "other.csv"],
    "_FiniteElementTable.write.path": ["out.inp", "other.inp"],
    "Scene.to_toml.path": ["a.toml", "b.toml"],
    "folder": ["one", "two"],
    "Scene.from_toml.folder": ["elsewhere", "."],
    "out": ["one", "two"],
    "to": ["one", "two"],
    "path_or_text": ["other.toml", SCENE.replace("100 MPa", "50 MPa")],
    "unit": ["nm", "mm"],
    "height_unit": ["nm", "mm"],
    "channel": ["Topography", "Second"],
    "measurement": ["first", "second"],
    "instrument": ["AFM", "stylus"],
    "z_calibration": ["3 %", "5 %"],
    "slope_uncertainty": [0.05, 0.2],
    "tip_radius": ["3 um", "none"],
    "filter": ["3 um", "1 um"],
    "short_filter": ["200 nm", "1 um"],
    "ratio_height": ["10 nm", "-10 nm"],
    "column": ["a", "b"],
    "series": ["a", "b"],
    "subject": ["one", "two"],
    "x_unit": ["um", "nm"],
    "psd_unit": ["um^3", "nm^3"],
    "wavevectors": [3 / WAVELENGTHS, 5 / WAVELENGTHS],
    "c1d": [2 * C1D, 3 * C1D],
    "c1d_se": [0.1 * C1D, 0.2 * C1D],
    "other": [PSD, MAPS],
    "name": ["one", "two"],
    "Material.name": ["gold", "aluminium"],
    "Result.axes.name": ["band", "area_fraction"],
    "Material.replace.changes": [dict(poisson_ratio=0.1), dict(youngs_modulus="70 GPa")],
    "Scene.replace.changes": [dict(pressure="20 MPa"), {"curve.0.model": "bgt"}],
    "Result.beside": [dict(notes=("b",)), dict(notes=("c",))],
    "title": ["one", "two"],
    "curves": [["hertz"], ["persson"]],
    "interface": [True, dict(fluid_pressure="1 MPa")],
    "seal": [True, dict(fluid_pressure="1 MPa")],
    "report.seal": [True, False],
    "judge": [dict(grid=64), dict(grid=128)],
    "Scene.run.judge": [True, False],
    "uncertainty": [dict(draws=30), dict(draws=40)],
    "Scene.run.uncertainty": [True, False],
    "options": [dict(band="1d"), dict(amplitude="parseval")],
    "figures": [dict(font_size="12 pt"), dict(width="60 mm")],
    "swept": [product, lambda length, width: length + width],
    "axes": [{"length": [1.0, 3.0], "width": [3.0]}, {"length": [1.0, 4.0], "width": [3.0]}],
    "Result.axes": [{"a": ("row",)}, {"a": ("state",)}],
    "client": [Client(), Client()],
    "count": [1, 2],
    "progress": [True, print],
    "load": [0, 1],
    "ax": list(_axes().flat[:2]),
    "arrays": [{"a": np.zeros(2)}, {"a": np.ones(3)}],
    "notes": [("b",), ("c",)],
    "text": ["b", "c"],
    "code": ["b", "c"],
    "place": [ta.Place(row=1), ta.Place(row=2)],
    "files": [("a",), ("b",)],
    "SceneResults.files": [{}, {"a": b"b"}],
    "row": [1, 2],
    "line": [1, 2],
    "key": ["a", "b"],
    "answer": ["one", "two"],
    "tables": [{}, {"a": ta.materials()}],
    "styles": [{}, {"a": ("a", "red", "")}],
    "loads": [1, 2],
    "errors": ["raise", "nan"],
}


def callables() -> dict[str, Callable[..., Any]]:
    """Functions, constructors and methods of the public names, by their own names."""
    found: dict[str, Callable[..., Any]] = {}
    for name in ta.__all__:
        public = getattr(ta, name)
        if inspect.isroutine(public):
            found[name] = public
        elif inspect.isclass(public):
            for kind in (one for one in public.__mro__ if one.__module__.startswith("truearea")):
                for member, method in vars(kind).items():
                    call = method.__func__ if isinstance(method, (staticmethod, classmethod)) else method
                    if not inspect.isfunction(call) or call.__name__ == "_refuse":
                        continue
                    if member in ("__init__", "__new__"):
                        found[kind.__name__] = kind
                    elif not member.startswith("_"):
                        found[f"{kind.__name__}.{member}"] = method.__get__(None, kind) if call is not method else call
    return {name: call for name, call in found.items() if arguments_of(call)}


def arguments_of(call: Callable[..., Any]) -> list[str]:
    return [name for name in inspect.signature(call).parameters if name != "self"]


def types() -> dict[str, Any]:
    """The types of arguments whose values are words, by the names of the arguments."""
    found: dict[str, Any] = {}
    modules = [module for name, module in sys.modules.items() if name.startswith("truearea.")]
    of_options = [kind for module in modules for kind in vars(module).values() if typing.is_typeddict(kind)]
    for noted in [*callables().values(), *of_options]:
        for name, kind in getattr(inspect.unwrap(noted) if callable(noted) else noted, "__annotations__", {}).items():
            text = getattr(kind, "__forward_arg__", kind)
            for word in re.findall(r"\w+", text) if isinstance(text, str) else ():
                if literal(getattr(ta.choices, word, None)):
                    found[name] = getattr(ta.choices, word)
    return found


CALLABLES = callables()
TYPES = types()


def values_of(of: str, argument: str, given: Any = None) -> list[Any]:
    call = CALLABLES[of]
    if argument == "surface" and isinstance(given, np.ndarray):
        argument = f"{argument} of heights"
    elif argument == "surface" and isinstance(given, str):
        argument = "surface of a file"
    if f"{of}.{argument}" in VALUES:
        return VALUES[f"{of}.{argument}"]
    own = getattr(inspect.unwrap(call), "__annotations__", {}).get(argument, "")
    words_of = literal(getattr(ta.choices, str(own).split(" |")[0], None)) or literal(TYPES.get(argument))
    if argument in VALUES and not words_of:
        return VALUES[argument]
    if words_of:
        return words_of
    if "bool" in str(own) or argument in ("periodic", "per_realisation", "strain_gradient"):
        return [True, False]
    raise AssertionError(f"give two values of {of}({argument}) that matter")


def contexts() -> list[tuple[str, str, dict[str, Any]]]:
    """Every callable in every context: one of each of its alternatives."""
    found = []
    for name, each in walks().items():
        for given, alternatives in each:
            for chosen in itertools.product(*(one.items() for one in alternatives)):
                arguments = {key: value for _, more in chosen for key, value in more.items()}
                found.append((name, ", ".join(word for word, _ in chosen if word), given | arguments))
    return found


def bench(folder: Path) -> None:
    """Writes a file of every kind."""
    folder.mkdir()
    rows = "".join(f"{length!r},{value!r}\n" for length, value in zip(WAVELENGTHS.tolist(), C1D.tolist()))
    (folder / "psd.csv").write_text("wavelength_m,C1D_m3\n" + rows)
    (folder / "columns.csv").write_text("wavelength_m,a,b\n" + re.sub(r",(.*)\n", r",\1,1\1\n", rows))
    (folder / "bare.txt").write_text(rows.replace(",", " "))
    (folder / "scene.toml").write_text(SCENE)
    (folder / "other.toml").write_text(SCENE.replace("elastic", "persson"))
    (folder / "elsewhere").mkdir()
    (folder / "elsewhere" / "psd.csv").write_text("wavelength_m,C1D_m3\n" + re.sub(r",(.)", r",3", rows))
    x = np.arange(512) * 0.1
    pairs = list(zip(x.tolist(), (1e6 * TRACE).tolist()))
    (folder / "trace.txt").write_text("".join(f"{at!r} {height!r}\n" for at, height in pairs))
    (folder / "named.txt").write_text("x (um), z (um)\n" + "".join(f"{at!r}, {height!r}\n" for at, height in pairs))
    np.savetxt(folder / "map.txt", 1e6 * MAP)
    np.savetxt(folder / "holes.txt", 1e6 * HOLED.filled(np.nan))
    head = "fileType      Image\nversion       PicoView 0x10c04\nxPixels       16\nyPixels       16\nxLength       3.0e-006\n"
    head += "yLength       3.0e-006\n"
    for name in ("Topography", "Second"):
        head += f"  more        bufferLabel\nbufferLabel   {name}\nbufferRange   3.2768e+000\nbufferUnit    um\ntrace         Trace\n"
    numbers = [int(2000 * height) for height in np.r_[TRACE[:256], TRACE[256:]] * 1e6]
    (folder / "two.mi").write_text(head + "data          ASCII\n" + "".join(f"{one}\n" for one in numbers))
    with zipfile.ZipFile(folder / "plate.zip", "w") as container:
        entry = "  - name: {0}\n    size: [4, 4]\n    unit: nm\n    datafile:\n      original: {0}.npy\n"
        entries = "".join(map(entry.format, ("first", "second")))
        container.writestr("meta.yml", f"surfaces:\n- name: plate\n  topographies:\n{entries}")
        for name, part in (("first", MAP), ("second", MAP[:16, :16])):
            content = io.BytesIO()
            np.save(content, part)
            container.writestr(f"{name}.npy", content.getvalue())


def seen(found: Any) -> Any:
    """All that a user sees of a result."""
    if isinstance(found, np.ndarray):
        mask = np.ma.getmaskarray(found).tobytes() if np.ma.isMaskedArray(found) else b""
        return found.shape, found.tobytes() if found.dtype.kind != "O" else repr(found.tolist()), mask
    if isinstance(found, (ta.ContactLaw, ta.HeatConductance, ta.CurrentConductance)):
        return seen(dict(found)), seen(list(found.notes)), found.to_text("csv")
    if isinstance(found, ta.Result):
        slots = (name for kind in type(found).__mro__ for name in vars(kind).get("__slots__", ()))
        beside = [(name, seen(getattr(found, name, None))) for name in slots if not name.startswith("_")]  # Notes are among them.
        return type(found), [(name, found.axes(name), seen(np.asarray(found[name]))) for name in found], beside
    if isinstance(found, ta.Spectrum):
        drawn = found.scans and ta.uncertainty(found, steel(), pressure=1e6, model="elastic", draws=20)
        return found.name, seen(found.table()), seen(found.scans), found.remarks, found.holes_m, seen(drawn)
    if isinstance(found, ta.Scan):
        return repr(found), found.notes, seen(found.heights_m), seen(ta.composite([found]))
    if isinstance(found, ta.Scene):
        return found.text, found.title, found.notes, found.explain(), seen(found.scales())
    if isinstance(found, ta.SceneResults):
        return seen(vars(found) if hasattr(found, "__dict__") else repr(found))
    if isinstance(found, ta.Material):
        return repr(found), found._repr_html_()
    if isinstance(found, ta.Note):
        return str(found), found.level, found.code, found.place
    if isinstance(found, Axes):
        return found.get_position().bounds, [np.asarray(line.get_xydata()).tobytes() for line in found.lines], found.get_title()
    if isinstance(found, contextlib.AbstractContextManager):
        with found:
            return ta.threads()
    if isinstance(found, dict):
        return {name: seen(value) for name, value in found.items()}
    if isinstance(found, (list, tuple)):
        return [seen(one) for one in found]
    text = found.decode(errors="replace") if isinstance(found, bytes) else str(found)
    return re.sub(r"\d{4}-\d\d-\d\d \d\d:\d\d UTC", "now", text)


class Refused(Exception):
    """A call that is refused, with what is said."""


def outcome(of: str, given: dict[str, Any], folder: Path) -> Any:
    """What a call gives, prints, warns of and writes; it runs in a folder of its files."""
    here = set(folder.iterdir())
    arguments = {name: value for name, value in given.items() if name not in ("changes", "beside")}
    arguments |= {**given.get("changes", {}), **given.get("beside", {})}
    call, threads, printed = CALLABLES[of], ta.threads(), io.StringIO()
    positional = [arguments.pop("self")] if "self" in arguments else []
    try:
        with warnings.catch_warnings(), contextlib.redirect_stdout(printed), contextlib.redirect_stderr(printed):
            warnings.simplefilter("ignore")
            found = seen(call(*positional, **arguments))
            found = [found, ta.threads()]
    except (ta.InputError, TypeError, OSError) as error:
        raise Refused(str(error)) from None
    finally:
        ta.set_threads(threads)
        files = {}
        for path in sorted(set(folder.rglob("*")), reverse=True):
            if any(path == old or (old.is_dir() and old in path.parents) for old in here):
                continue
            if path.is_dir():
                path.rmdir()
            else:
                files[str(path.relative_to(folder))] = seen(path.read_bytes())
                path.unlink()
    return found, printed.getvalue(), files


def is_named(argument: str, said: str) -> bool:
    return re.search(rf"\b{argument}\b", said.replace("-", "_")) is not None


def fault_of(of: str, given: dict[str, Any], argument: str, usual: Any, folder: Path) -> str | None:
    """Walks one argument in one context. What it cannot do without is given as well."""
    arguments = arguments_of(CALLABLES[of])
    others: list[Any] = []
    refusals: list[str] = []
    values = values_of(of, argument, given.get(argument))
    for value in values:
        try:
            found = outcome(of, given | {argument: value}, folder)
        except Refused as refused:
            said = str(refused)
            more = [name for name in arguments if is_named(name, said) and given.get(name) is None and name != argument]
            if not is_named(argument, said) and more and len(given) < 30:
                wider = given | {more[0]: values_of(of, more[0])[0]}
                with contextlib.suppress(Refused):
                    usual = outcome(of, wider, folder)
                    return fault_of(of, wider, argument, usual, folder)
                return fault_of(of, wider, argument, None, folder)
            refusals.append(said)
            continue
        if usual is not None and found != usual or others and found != others[0]:
            return None
        others.append(found)
    if not refusals:
        return "changes nothing" if usual is not None or len(others) > 1 else None
    if any(is_named(argument, said) or str(value) in said for said, value in zip(refusals, values)):
        return None
    return f"is refused without its name: {refusals[0]}"


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Path]:
    there = tmp_path_factory.mktemp("calls") / "bench"
    bench(there)
    before = Path.cwd()
    os.chdir(there)
    yield there
    os.chdir(before)


def test_every_callable_has_a_context() -> None:
    assert callables().keys() == walks().keys()


def test_every_argument_changes_something_or_is_named(folder: Path) -> None:
    pairs = 0
    faults, refused = [], []
    for at, (name, words_of, given) in enumerate(contexts()):
        arguments = [argument for argument in arguments_of(CALLABLES[name])]
        walked = [argument for place, argument in enumerate(arguments) if (at + place) % STEP == 0]
        walked = [one for one in walked if not any(one == idle and within in f"{name} {words_of}," for within, idle, _ in IDLE_BY_RIGHT)]
        if not walked:
            continue
        try:
            usual = outcome(name, given, folder)
        except Refused as error:
            refused.append(f"{name} ({words_of}): {error}")
            continue
        for argument in walked:
            pairs += 1
            fault = fault_of(name, given, argument, usual, folder)
            if fault is not None:
                faults.append(f"{name}({argument}) of {words_of or 'any'}: {fault}")
    if report := os.environ.get("TRUEAREA_NO_EFFECT_REPORT"):
        Path(report).write_text("\n".join([f"{pairs} pairs, {len(contexts())} contexts", "", *faults, "", *refused]))
    assert not faults, "\n".join(faults)
    assert pairs > 5000 / STEP
