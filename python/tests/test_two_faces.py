"""Two rough faces: the second comes by a keyword in every call, by a scene, and by the command line, with one result."""

from __future__ import annotations

import pickle
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import truearea as ta
from test_scene_objects import area, trace

STEEL = ta.Material("210 GPa", 0.3, yield_strength="2 GPa")
LENGTH_M = 2048 * 1e-7
RING = ta.composite([(trace(seed), LENGTH_M) for seed in (1, 2)])
FACE = ta.composite([(0.3 * trace(seed), LENGTH_M) for seed in (3, 4)])
BOTH = RING + FACE
SMALL: dict[str, Any] = {"grid": 32, "realisations": 1, "shortest": "10 um"}

CALLS: dict[str, Callable[..., Any]] = {
    "gap": lambda surface, **face: ta.gap(surface, STEEL, pressure="10 MPa", **face),
    "tangential": lambda surface, **face: ta.tangential(surface, STEEL, friction=0.3, pressure="10 MPa", **face),
    "law": lambda surface, **face: ta.law(surface, STEEL, pressure=("1 MPa", "10 MPa"), **face),
    "heat": lambda surface, **face: ta.law(
        surface,
        STEEL,
        pressure=("1 MPa", "10 MPa"),
        quantity="heat",
        model="yovanovich",
        thermal_conductivity=46.0,
        counterface_thermal_conductivity=46.0,
        **face,
    ),
    "persson": lambda surface, **face: ta.persson(surface, STEEL, pressure="10 MPa", **face),
    "stacked": lambda surface, **face: ta.stacked(surface, STEEL, pressure="10 MPa", **face),
    "statistical": lambda surface, **face: ta.statistical(surface, STEEL, model="hertz", pressure="10 MPa", **face),
    "uncertainty": lambda surface, **face: ta.uncertainty(
        surface, STEEL, pressure="10 MPa", model="persson", draws=40, **face
    ),
    "boundary_elements": lambda surface, **face: ta.boundary_elements(surface, STEEL, pressure="10 MPa", **SMALL, **face),
    "ball": lambda surface, **face: ta.ball(surface, STEEL, radius="1 mm", force="1 mN", **SMALL, **face),
    "adhesion": lambda surface, **face: ta.adhesion(
        surface, STEEL, pressure="10 MPa", work_of_adhesion=0.05, adhesion_range="1 um", **SMALL, **face
    ),
    "pull_off": lambda surface, **face: ta.pull_off(
        surface, STEEL, work_of_adhesion=0.05, adhesion_range="1 um", **SMALL, **face
    ),
}


@pytest.mark.parametrize("name", CALLS)
def test_every_call_takes_the_other_face(name: str) -> None:
    call = CALLS[name]
    both = call(RING, counterface_surface=FACE)
    assert both == call(BOTH)
    assert not both == call(RING)
    assert call(RING, counterface_surface=None) == call(RING)


def test_the_other_face_is_named_where_it_is_none() -> None:
    for call in (CALLS["gap"], CALLS["law"], CALLS["persson"]):
        with pytest.raises(ta.InputError, match="counterface_surface"):
            call(RING, counterface_surface=3)
    heights = np.zeros((16, 16))
    with pytest.raises(ta.InputError, match="counterface_surface"):
        ta.boundary_elements(heights, STEEL, pressure="1 MPa", size="1 um", counterface_surface=FACE)


def test_a_law_of_two_faces_is_pickled() -> None:
    law = CALLS["law"](RING, counterface_surface=FACE)
    assert pickle.loads(pickle.dumps(law)) == law


def test_a_scene_of_two_faces_is_that_of_its_text(tmp_path: Path) -> None:
    for own, other in ((RING, FACE), (ta.read_psd("builtin:uncd-measured"), FACE)):
        scene = ta.Scene(own, STEEL, pressure="10 MPa", counterface_surface=other, curves=["persson"], interface=True, seal=True)
        found = scene.run(judge=False)
        gap = float(ta.gap(own, STEEL, pressure="10 MPa", counterface_surface=other).mean_gap_m[0])
        interface = found.tables["report-interface"]
        assert float(interface.value[list(interface.quantity).index("mean_gap_m")]) == gap
        assert "[counterface.surface]" in scene.to_toml(tmp_path / "scene.toml")
        again = ta.Scene.from_toml(tmp_path / "scene.toml").run(judge=False)
        assert area(again) == pytest.approx(area(found), rel=1e-9)
        alone = ta.Scene(own, STEEL, pressure="10 MPa", curves=["persson"]).run(judge=False)
        assert area(alone) > area(found)
        assert area(pickle.loads(pickle.dumps(scene)).run(judge=False)) == area(found)
        assert area(scene.replace(pressure=["10 MPa"]).run(judge=False)) == area(found)


def test_files_of_the_other_face_make_the_report_of_the_command(tmp_path: Path) -> None:
    files = {}
    for name, factor in (("ring", 1e6), ("face", 3e5)):
        np.savetxt(tmp_path / f"{name}.txt", np.column_stack([0.1 * np.arange(2048), factor * trace(len(name))]))
        files[name] = f"{tmp_path / name}.txt:unit=um"
    found = ta.report(
        files["ring"], "100Cr6", counterface="100Cr6", counterface_surface=[files["face"]], pressure="10 MPa", out=tmp_path / "o"
    )
    assert "[counterface.surface]" in (tmp_path / "o" / "scene.toml").read_text()
    arrays = ta.Scene(
        1e-6 * np.loadtxt(tmp_path / "ring.txt")[:, 1],
        "100Cr6",
        counterface="100Cr6",
        counterface_surface=1e-6 * np.loadtxt(tmp_path / "face.txt")[:, 1],
        size=LENGTH_M,
        pressure="10 MPa",
        curves=["persson"],
    )
    assert area(arrays.run(judge=False)) == pytest.approx(area(found), rel=1e-6)


def test_a_written_sum_is_read_back_with_both_faces(tmp_path: Path) -> None:
    both = ta.read_psd("builtin:uncd-measured") + FACE
    both.write(tmp_path / "both.csv")
    again = ta.read_psd(tmp_path / "both.csv")
    assert again == both
    assert CALLS["gap"](again) == CALLS["gap"](both)


def test_scans_that_differ_are_asked_for_two_faces() -> None:
    mean = ta.composite([(trace(1), LENGTH_M), (0.1 * trace(2), LENGTH_M)])
    assert any("two faces? give one as counterface_surface" in str(note) for note in mean.notes)
