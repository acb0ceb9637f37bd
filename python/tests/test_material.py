"""Materials: numbers and text, what goes together, and what is refused."""

from __future__ import annotations

import pickle
from typing import Any

import numpy as np
import pytest

import truearea as ta
from support import refused_naming


def test_numbers_and_text_are_the_same() -> None:
    by_text = ta.Material("210 GPa", 0.3, yield_strength="1 GPa", counterface=ta.Material("70 GPa", 0.33))
    by_number = ta.Material(210e9, np.float64(0.3), yield_strength=np.int64(10**9), counterface=ta.Material(70e9, 0.33))
    assert by_text.composite_modulus_pa == by_number.composite_modulus_pa
    assert by_text.composite_modulus_pa == pytest.approx(1.0 / ((1 - 0.09) / 210e9 + (1 - 0.33**2) / 70e9), rel=1e-15)
    assert by_text.indentation_hardness_pa == 3e9 and by_text.yield_strength_pa == 1e9
    assert ta.Material(1e9, 0.5, indentation_hardness="300 HV").yield_strength_pa is not None
    assert ta.Material(1e9, 0.5).yield_strength_pa is None


@pytest.mark.parametrize(
    ("given", "told"),
    [
        ({"youngs_modulus": "210"}, "youngs_modulus: '210'"),
        ({"youngs_modulus": "210 nm"}, "youngs_modulus: '210 nm' 'nm'"),
        ({"youngs_modulus": 0}, "youngs_modulus 0;"),
        ({"youngs_modulus": -1.0}, "youngs_modulus -1"),
        ({"youngs_modulus": float("nan")}, "youngs_modulus NaN"),
        ({"youngs_modulus": 1e40}, "youngs_modulus 1000"),
        ({"youngs_modulus": None}, "youngs_modulus: '210 GPa'"),
        ({"youngs_modulus": True}, "youngs_modulus:"),
        ({"youngs_modulus": [1e9, 2e9]}, "youngs_modulus: list"),
        ({"poisson_ratio": 0.7}, "poisson_ratio 0.7; -1 0.5"),
        ({"poisson_ratio": "0.3"}, "poisson_ratio: str"),
        ({"yield_strength": "1 GPa", "indentation_hardness": "1 GPa"}, "hardness yield strength 3"),
        ({"counterface": "steel"}, "counterface: Material str"),
        ({"strain_gradient_length": "5 Pa"}, "strain_gradient_length: '5 Pa' 'Pa'"),
    ],
)
def test_what_cannot_be_used_is_refused(given: dict[str, Any], told: str) -> None:
    with refused_naming(*told.split()):
        ta.Material(**{"youngs_modulus": 1e9, "poisson_ratio": 0.3, **given})


def test_materials_are_values() -> None:
    steel = ta.Material("210 GPa", 0.3, yield_strength="1 GPa")
    assert pickle.loads(pickle.dumps(steel)) == steel and hash(steel) == hash(steel.replace())
    assert steel.replace(yield_strength="2 GPa") != steel
    assert "E = 210000000000 Pa" in repr(steel) and "<table>" in steel._repr_html_()


def test_materials_are_known_by_name() -> None:
    table = ta.materials()
    assert all(table.sources) and all(table.youngs_modulus)
    for name, modulus, ratio in zip(table.name, table.youngs_modulus, table.poisson_ratio):
        assert ta.Material(str(name)) == ta.Material(name=str(name))
        assert ta.Material(str(name)).composite_modulus_pa == ta.Material(str(modulus), ratio).composite_modulus_pa
    steel = ta.Material("100Cr6", counterface=ta.Material("C45"))
    assert steel.name == "100Cr6" and steel.youngs_modulus == 210e9 and steel.poisson_ratio == 0.3
    assert steel.indentation_hardness_pa is not None
    assert pickle.loads(pickle.dumps(steel)) == steel
    # The softer of two bodies flows.
    assert steel.replace(yield_strength="100 MPa").indentation_hardness_pa == 3e8
    soft_pa = ta.Material("C45").indentation_hardness_pa
    assert steel.replace(yield_strength="1 GPa").indentation_hardness_pa == soft_pa
    assert steel.replace(youngs_modulus="200 GPa").youngs_modulus == "200 GPa"
    assert ta.Material("210 GPa", 0.3).name is None


def test_shares_of_a_named_material_are_of_the_values_of_the_table() -> None:
    spectrum = ta.read_psd("builtin:uncd-measured")
    steel = ta.Material("100Cr6")
    typed = ta.Material(210e9, 0.3, indentation_hardness=steel.indentation_hardness_pa)
    found = [
        ta.uncertainty(spectrum, material, pressure="1 MPa", model="persson", draws=200, youngs_modulus="5 %")
        for material in (steel, typed)
    ]
    assert found[0].low == found[1].low


@pytest.mark.parametrize("given", [{"name": "steel"}, {"youngs_modulus": "unobtainium"}, {"name": 5}])
def test_unknown_names_of_materials_are_refused(given: dict[str, Any]) -> None:
    with refused_naming("name:"):
        ta.Material(**given)
    with refused_naming("poisson_ratio"):
        ta.Material("210 GPa")


def test_models_are_listed_with_their_options() -> None:
    table = ta.models()
    assert set(table.framework) == {"stacked", "statistical", "persson"} and all(table.citation)
    options = dict(zip(table.model, table.options))
    assert "hardness_formula" in options["ep-sphere"] and "gamma" in options["persson"]


def test_a_layer_is_part_of_the_material() -> None:
    layer: dict[str, Any] = {"layer_thickness": "50 nm", "layer_youngs_modulus": "1 GPa", "layer_poisson_ratio": 0.3}
    half_space = ta.Material("1 GPa", 0.3)
    same = ta.Material("1 GPa", 0.3, **layer)
    rigid = ta.Material(**layer, layer_base="rigid")
    assert rigid.youngs_modulus is None and rigid != same and "layer" in repr(rigid)
    curves = [ta.persson("builtin:uncd-measured", material, pressure="1 MPa") for material in (half_space, same, rigid)]
    areas = [float(curve.area_fraction.flat[-1]) for curve in curves]
    assert areas[1] == pytest.approx(areas[0], rel=1e-12) and areas[2] < 0.7 * areas[0]
    scene = ta.Scene("builtin:uncd-measured", rigid, pressure="1 MPa").to_toml()
    assert "rigid" in scene and "thickness" in scene
    for wrong in ({"layer_thickness": None}, {"layer_poisson_ratio": 0.7}, {"layer_thickness": 0.0}):
        with pytest.raises(ta.InputError, match=next(iter(wrong))):
            ta.Material("1 GPa", 0.3, **{**layer, **wrong})
    with pytest.raises(ta.InputError, match="counterface"):
        ta.Material("1 GPa", 0.3, counterface=same)
    with pytest.raises(ta.InputError, match="layer"):
        ta.stacked("builtin:uncd-measured", same, model="elastic", pressure="1 MPa")


def test_the_softer_of_two_bodies_flows_and_it_is_said_which() -> None:
    hard, soft = ta.Material(200e9, 0.3, indentation_hardness="6 GPa"), ta.Material(70e9, 0.3, indentation_hardness="300 MPa")
    spectrum = ta.read_psd("builtin:uncd-measured")
    for rough, counterface, body in ((hard, soft, "the counterface flows"), (soft, hard, "the rough body flows")):
        pair = rough.replace(counterface=counterface)
        assert pair.indentation_hardness_pa == 3e8
        notes = [
            ta.stacked(spectrum, pair, pressure="1 MPa").notes,
            ta.gap(spectrum, pair, pressure="1 MPa").notes,
            ta.boundary_elements(spectrum, pair, pressure="1 MPa", grid=32, realisations=1).notes,
            ta.contact(material=pair, model="hertz", radius=1e-6, density=1e12, sigma_s=1e-8, pressure=1e6).notes,
        ]
        for each in notes:
            [note] = [note for note in each if note.code == "body-that-flows"]
            assert body in note and "300 MPa" in note and "6 GPa" in note
        scene = ta.Scene(spectrum, pair, pressure="1 MPa", curves=["elastic-plastic"])
        assert "300 MPa" in scene.text and "6 GPa" in scene.text
    alone = ta.stacked(spectrum, hard, pressure="1 MPa")
    assert not [note for note in alone.notes if note.code == "body-that-flows"]


def test_a_counterface_has_no_property_without_effect() -> None:
    idle: list[dict[str, Any]] = [
        {"strain_gradient_length": "1 um"},
        {"strength_cap": "2 GPa"},
        {"counterface": ta.Material(70e9, 0.3)},
        {"layer_thickness": "1 um", "layer_youngs_modulus": "1 GPa", "layer_poisson_ratio": 0.3},
    ]
    for given in idle:
        with refused_naming("counterface"):
            ta.Material(200e9, 0.3, counterface=ta.Material(70e9, 0.3, yield_strength="1 GPa", **given))
