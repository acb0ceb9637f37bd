//! The text of a scene with some of its keys set anew. All else of it, comments too, stays as it was typed.

use std::cmp::Ordering;

use toml::Value;
use toml_edit::{DocumentMut, Item, Key, Table};

use super::error::SceneError;
use super::raw::{
    RawCounterface, RawCurve, RawCutoffs, RawFigure, RawFigureDefaults, RawInterface, RawJudge, RawLayer,
    RawLoads, RawMaterial, RawOptions, RawScanKeys, RawSeal, RawSurface, RawUncertainty,
};
use super::reader::keys;
use super::scene_text::SceneText;
use super::spelling::meant;
use study::body_properties::BodyProperty;

/// Other names of keys, those of functions and options.
const OTHER_NAMES: [(&str, [&str; 2]); 2] =
    [("cutoff", ["cutoffs", "shortest_wavelength"]), ("pressure", ["loads", "pressures"])];

/// The SI units of the keys that are typed with a unit, so that a plain number can be given for them; those of bodies are in
/// their own table.
const SI_UNITS: [(&str, &str); 24] = [
    ("surface.rms_height", "m"),
    ("surface.mean_width", "m"),
    ("surface.rolloff_wavelength", "m"),
    ("material.layer.thickness", "m"),
    ("material.layer.youngs_modulus", "Pa"),
    ("loads.pressures", "Pa"),
    ("loads.force", "N"),
    ("loads.nominal_area", "m^2"),
    ("cutoffs.shortest_wavelength", "m"),
    ("options.strength_cap", "Pa"),
    ("interface.shear_strength", "Pa"),
    ("interface.work_of_adhesion", "J/m^2"),
    ("interface.range_of_attraction", "m"),
    ("interface.gas_conductivity", "W/(m K)"),
    ("interface.gas_parameter", "m"),
    ("interface.gas_temperature", "K"),
    ("interface.gas_pressure", "Pa"),
    ("interface.tangential_stress", "Pa"),
    ("seal.pressure_drop", "Pa"),
    ("seal.viscosity", "Pa s"),
    ("seal.gas_temperature", "K"),
    ("seal.outlet_pressure", "Pa"),
    ("seal.breadth", "m"),
    ("seal.length", "m"),
];

/// A key that cannot be set anew.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ReplaceError {
    /// No section has such a key, or there is no such section.
    #[error("{name}: a scene has no such key{} it may be {}", hint(meant), known.join(", "))]
    Unknown {
        /// The name.
        name: String,
        /// The names there are.
        known: Vec<String>,
        /// The one that looks most like it.
        meant: Option<String>,
    },
    /// Several sections have such a key.
    #[error("{name} may be {}; name the one that is meant", places.join(" or "))]
    Ambiguous {
        /// The name.
        name: String,
        /// Places that the name may mean.
        places: Vec<String>,
    },
    /// There are not so many sections of a kind.
    #[error("{name}: the scene has {count} such sections, and they are counted from 0")]
    TooFew {
        /// The name.
        name: String,
        /// Number of sections there are.
        count: usize,
    },
    /// The key is a section, or its parent is not a section.
    #[error("{name} is not a single value in this scene; set it in the text")]
    NoValue {
        /// The name.
        name: String,
    },
    /// The text is not a valid scene after the replacement.
    #[error(transparent)]
    Scene(SceneError),
}

/// Returns the text of a scene with keys set to values. A name is `section.key`, or a key alone where one section has it: of
/// those that have it in the text, or where none does, of those in the text that may have it. `cutoff` and `pressure` are
/// known as well. Sections that may stand several times are counted: `curve.0.model`. A number for a key that is typed with a
/// unit is in SI units. Lines end with a line feed alone.
///
/// # Errors
/// [`ReplaceError`] that names what is known. Values are checked when the scene is read.
pub fn with_keys<'k>(
    text: &str,
    changes: impl IntoIterator<Item = (&'k str, Value)>,
) -> Result<String, ReplaceError> {
    let SceneText(mut document) = SceneText::parse(text).map_err(ReplaceError::Scene)?;
    for (name, value) in changes {
        let place = place(&document, name)?;
        let value = with_si_unit(&place.join("."), value);
        set(&mut document, &place, &value).ok_or_else(|| ReplaceError::NoValue { name: name.to_owned() })?;
    }
    Ok(document.to_string())
}

/// Suggests a similar name, or returns the semicolon that separates the clauses if there is none.
fn hint(meant: &Option<String>) -> String {
    meant.as_ref().map_or_else(|| ";".to_owned(), |meant| format!(", did you mean {meant}?"))
}

/// Returns the place of a name, part by part.
fn place(document: &DocumentMut, name: &str) -> Result<Vec<String>, ReplaceError> {
    if let Some((_, place)) = OTHER_NAMES.iter().find(|(other, _)| *other == name) {
        return Ok(place.map(str::to_owned).to_vec());
    }
    let parts: Vec<String> = name.split('.').map(str::to_owned).collect();
    match &parts[..] {
        [key] if key == "title" => Ok(parts),
        [key] => of_short_name(document, key),
        [section, key, ..] if keys_of(&SECTIONS, section).is_some_and(|keys| keys.contains(key)) => Ok(parts),
        [section, at, key] if keys_of(&REPEATED, section).is_some_and(|keys| keys.contains(key)) => {
            let count =
                (0..).take_while(|at| document.get(section).and_then(|all| all.get(at)).is_some()).count();
            let is_there = at.parse::<usize>().is_ok_and(|at| at < count);
            if is_there { Ok(parts) } else { Err(ReplaceError::TooFew { name: name.to_owned(), count }) }
        }
        _ => Err(unknown(name)),
    }
}

/// The section of a key that is named alone.
fn of_short_name(document: &DocumentMut, key: &str) -> Result<Vec<String>, ReplaceError> {
    let may_have: Vec<&str> = SECTIONS
        .iter()
        .filter(|(_, keys)| keys().iter().any(|known| known == key))
        .map(|(section, _)| *section)
        .collect();
    let table = |section: &str| document.get(section)?.as_table_like();
    let of = |section: &&str| table(section).is_some_and(|table| table.contains_key(key));
    let has: Vec<&str> = may_have.iter().copied().filter(of).collect();
    let stand: Vec<&str> = may_have.iter().copied().filter(|section| table(section).is_some()).collect();
    let candidates = [has, stand, may_have].into_iter().find(|sections| !sections.is_empty());
    match candidates.as_deref() {
        None => Err(unknown(key)),
        Some([section]) => Ok(vec![(*section).to_owned(), key.to_owned()]),
        Some(several) => Err(ReplaceError::Ambiguous {
            name: key.to_owned(),
            places: several.iter().map(|section| format!("{section}.{key}")).collect(),
        }),
    }
}

/// No such key, with those of its section where there is one.
fn unknown(name: &str) -> ReplaceError {
    let parts: Vec<&str> = name.split('.').collect();
    let section = (parts.len() > 1).then_some(parts[0]);
    let keys =
        section.and_then(|section| keys_of(&SECTIONS, section).or_else(|| keys_of(&REPEATED, section)));
    let known: Vec<String> = match (section, keys) {
        (Some(section), Some(keys)) if keys_of(&REPEATED, section).is_some() => {
            keys.iter().map(|key| format!("{section}.0.{key}")).collect()
        }
        (Some(section), Some(keys)) => keys.iter().map(|key| format!("{section}.{key}")).collect(),
        _ => {
            let mut known: Vec<String> = Vec::new();
            let keys = SECTIONS.iter().flat_map(|(_, keys)| keys());
            for key in keys.chain(OTHER_NAMES.map(|(name, _)| name.to_owned())) {
                if !known.contains(&key) {
                    known.push(key);
                }
            }
            known
        }
    };
    let meant = meant(name, known.iter().map(String::as_str)).map(str::to_owned);
    ReplaceError::Unknown { name: name.to_owned(), known, meant }
}

/// Returns the SI unit of a key by its place, such as `loads.pressures`, if it is typed with a unit.
#[must_use]
pub fn si_unit(place: &str) -> Option<&'static str> {
    let of_body = place.strip_prefix("material.").or_else(|| place.strip_prefix("counterface."));
    let of_others = || SI_UNITS.iter().find(|(key, _)| *key == place).map(|(_, unit)| *unit);
    of_body.and_then(BodyProperty::of_key).map_or_else(of_others, BodyProperty::unit)
}

/// Returns a value as the key at a place takes it: numbers with the SI unit of the key, and one pressure as a list of one.
#[must_use]
pub fn with_si_unit(place: &str, value: Value) -> Value {
    let value = match si_unit(place) {
        Some(unit) => with_unit(value, unit),
        None => value,
    };
    let is_one_pressure = place == "loads.pressures" && !value.is_array();
    if is_one_pressure { Value::Array(vec![value]) } else { value }
}

/// Numbers with a unit, in lists and tables too.
fn with_unit(value: Value, unit: &str) -> Value {
    match value {
        Value::Integer(number) => Value::String(in_full(number as f64, unit)),
        Value::Float(number) => Value::String(in_full(number, unit)),
        Value::Array(values) => {
            Value::Array(values.into_iter().map(|value| with_unit(value, unit)).collect())
        }
        Value::Table(table) => {
            Value::Table(table.into_iter().map(|(key, value)| (key, with_unit(value, unit))).collect())
        }
        other => other,
    }
}

/// A number with all its digits, a pressure in the largest unit in which these are few: figures repeat what is typed.
fn in_full(number: f64, unit: &str) -> String {
    let pressures = [(1e9, "GPa"), (1e6, "MPa"), (1e3, "kPa")].into_iter().filter(|_| unit == "Pa");
    let short = pressures.into_iter().find_map(|(scale, unit)| {
        let text = format!("{} {unit}", number / scale);
        (number >= scale && number / scale * scale == number && text.len() < 10).then_some(text)
    });
    short.unwrap_or_else(|| format!("{number} {unit}"))
}

/// Sets the value at a place; `None` if it is a section, or below a value that is none. A new key is the first of its
/// section, a new section the last of the text.
fn set(document: &mut DocumentMut, place: &[String], value: &Value) -> Option<()> {
    let mut value: toml_edit::Value = value.to_string().parse().ok()?;
    let (key, sections) = place.split_last()?;
    if let Some(section) = sections.first().filter(|section| !document.contains_key(section)) {
        let end = document.trailing().as_str().unwrap_or_default().to_owned();
        let line_break = if end.is_empty() || end.ends_with('\n') { "\n" } else { "\n\n" };
        let mut table = Table::new();
        table.decor_mut().set_prefix(end + line_break);
        table.set_position(Some(isize::MAX));
        document.set_trailing("");
        document.insert(section, Item::Table(table));
    }
    let mut item = document.as_item_mut();
    for part in sections {
        item = match part.parse::<usize>() {
            Ok(at) => item.get_mut(at)?,
            Err(_) => item.get_mut(part)?,
        };
    }
    let slot = item.get_mut(key)?;
    match slot {
        Item::Value(old) => {
            value.decor_mut().clone_from(old.decor());
            *old = value;
        }
        Item::None => {
            *slot = Item::Value(value);
            match item {
                Item::Table(table) => table.sort_values_by(|a, _, b, _| key_first(key, a, b)),
                Item::Value(toml_edit::Value::InlineTable(table)) => {
                    table.sort_values_by(|a, _, b, _| key_first(key, a, b));
                }
                _ => {}
            }
        }
        _ => return None,
    }
    Some(())
}

fn key_first(key: &str, a: &Key, b: &Key) -> Ordering {
    (a.get() != key).cmp(&(b.get() != key))
}

type Keys = fn() -> Vec<String>;

/// The sections that occur at most once, and their keys.
const SECTIONS: [(&str, Keys); 11] = [
    ("surface", keys::<RawSurface>),
    ("material", keys::<RawMaterial>),
    ("counterface", keys::<RawCounterface>),
    ("loads", keys::<RawLoads>),
    ("cutoffs", keys::<RawCutoffs>),
    ("options", keys::<RawOptions>),
    ("judge", keys::<RawJudge>),
    ("uncertainty", keys::<RawUncertainty>),
    ("interface", keys::<RawInterface>),
    ("seal", keys::<RawSeal>),
    ("figures", keys::<RawFigureDefaults>),
];

/// The sections that may occur several times, and their keys.
const REPEATED: [(&str, Keys); 2] = [("curve", keys::<RawCurve>), ("figure", keys::<RawFigure>)];

/// Returns the keys of every section, each under its name; of scans and of a layer as well.
#[must_use]
pub fn keys_by_section() -> Vec<(&'static str, Vec<String>)> {
    let nested: [(&str, Keys); 2] =
        [("surface.scans.0", keys::<RawScanKeys>), ("material.layer", keys::<RawLayer>)];
    SECTIONS.iter().chain(&REPEATED).chain(&nested).map(|(section, keys)| (*section, keys())).collect()
}

fn keys_of(sections: &[(&str, Keys)], section: &str) -> Option<Vec<String>> {
    sections.iter().find(|(name, _)| *name == section).map(|(_, keys)| keys())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::raw::RawScene;

    fn set(text: &str, name: &str, value: impl Into<Value>) -> String {
        with_keys(text, [(name, value.into())]).unwrap_or_else(|error| panic!("{error}"))
    }

    fn refused(text: &str, name: &str) -> ReplaceError {
        with_keys(text, [(name, Value::from(1.0))]).unwrap_err()
    }

    const SCENE: &str = "title = \"a\" # what it is\n[surface]\npsd = \"a.csv\"\n\n[material]   # steel\n\
                         youngs_modulus = \"210 GPa\"   # from a book\npoisson_ratio = 0.3\n\n[[curve]]\nmodel = \"hertz\"\n";

    #[test]
    fn a_value_is_replaced_and_all_else_stays() {
        let changed = set(SCENE, "youngs_modulus", "200 GPa");
        assert_eq!(changed, SCENE.replace("210 GPa", "200 GPa"));
        assert_eq!(set(SCENE, "material.poisson_ratio", 0.25), SCENE.replace("0.3", "0.25"));
        assert_eq!(set(SCENE, "title", "b"), SCENE.replace("\"a\" ", "\"b\" "));
        assert_eq!(set(SCENE, "curve.0.model", "bgt"), SCENE.replace("hertz", "bgt"));
    }

    #[test]
    fn a_new_key_stands_behind_the_head_of_its_section_and_a_new_section_at_the_end() {
        let changed = set(SCENE, "yield_strength", 1e9);
        assert!(changed.contains("[material]   # steel\nyield_strength = \"1 GPa\"\nyoungs_modulus"));
        assert!(
            set(SCENE, "cutoff", 1e-8).ends_with("\n[cutoffs]\nshortest_wavelength = \"0.00000001 m\"\n")
        );
        assert!(
            set(SCENE, "curve.0.strain_gradient", true).contains("[[curve]]\nstrain_gradient = true\nmodel")
        );
        let bare = "[material]\nyoungs_modulus = \"1 GPa\"\n[options]";
        assert!(set(bare, "tolerance", 1e-6).ends_with("[options]\ntolerance = 0.000001\n"));
        let dotted = "material.youngs_modulus = \"1 GPa\"\n";
        assert_eq!(
            set(dotted, "material.poisson_ratio", 0.3),
            format!("material.poisson_ratio = 0.3\n{dotted}")
        );
        let inline = "material = { youngs_modulus = \"1 GPa\" }\n";
        let changed = set(inline, "material.poisson_ratio", 0.3);
        assert_eq!(changed, "material = { poisson_ratio = 0.3, youngs_modulus = \"1 GPa\" }\n");
        assert_eq!(set("judge = {}", "judge.grid", 64), "judge = { grid = 64 }\n");
    }

    #[test]
    fn numbers_get_the_unit_of_their_key_in_lists_and_tables_too() {
        let changed = set(SCENE, "pressure", 5e6);
        assert!(changed.ends_with("[loads]\npressures = [\"5 MPa\"]\n"), "{changed}");
        let pressures = Value::Array(vec![1e6.into(), "1e-3 H".into()]);
        assert!(set(SCENE, "pressures", pressures).ends_with("pressures = [\"1 MPa\", \"1e-3 H\"]\n"));
        let mut table = toml::Table::new();
        table.insert("distribution".into(), "uniform".into());
        table.insert("from".into(), 1e9.into());
        table.insert("to".into(), 2e9.into());
        let changed = set(SCENE, "material.youngs_modulus", table);
        assert!(
            changed.contains("youngs_modulus = { distribution = \"uniform\", from = \"1 GPa\""),
            "{changed}"
        );
    }

    #[test]
    fn a_short_name_is_that_of_the_section_that_has_it() {
        let two = format!("{SCENE}[counterface]\nname = \"glass\"\n");
        assert_eq!(set(&two, "youngs_modulus", "200 GPa"), two.replace("210 GPa", "200 GPa"));
        let ReplaceError::Ambiguous { places, .. } = refused(&two, "yield_strength") else { panic!() };
        assert_eq!(places, ["material.yield_strength", "counterface.yield_strength"]);
        assert!(set(SCENE, "yield_strength", "1 GPa").contains("[material]   # steel\nyield_strength"));
    }

    #[test]
    fn an_unknown_name_is_refused_with_what_is_known() {
        let unknown = |name: &str| match refused(SCENE, name) {
            ReplaceError::Unknown { known, meant, .. } => (known, meant),
            other => panic!("{other}"),
        };
        let (known, meant) = unknown("young_modulus");
        assert_eq!(meant.as_deref(), Some("youngs_modulus"));
        assert!(["poisson_ratio", "cutoff"].iter().all(|name| known.iter().any(|known| known == name)));
        assert_eq!(unknown("material.colour").0[..2], ["material.name", "material.youngs_modulus"]);
        assert_eq!(unknown("curve.model").0[0], "curve.0.model");
        assert!(matches!(refused(SCENE, "curve.1.model"), ReplaceError::TooFew { count: 1, .. }));
        let apart = "[material.youngs_modulus]\ndistribution = \"uniform\"\n";
        assert!(matches!(refused(apart, "youngs_modulus"), ReplaceError::NoValue { .. }));
        let broken = with_keys("title = ", [("title", Value::from("b"))]);
        assert!(matches!(broken, Err(ReplaceError::Scene(_))));
    }

    #[test]
    fn every_section_of_a_scene_is_known() {
        let mut known: Vec<&str> = SECTIONS.iter().chain(&REPEATED).map(|(section, _)| *section).collect();
        known.push("title");
        let mut keys = keys::<RawScene>();
        known.sort_unstable();
        keys.sort_unstable();
        assert_eq!(known, keys);
    }

    #[test]
    fn the_units_are_those_of_keys_that_there_are() {
        let names = SI_UNITS.iter().map(|(name, _)| *name);
        for name in names.chain(OTHER_NAMES.iter().map(|(name, _)| *name)) {
            let text = if name.starts_with("material.layer") { "[material.layer]" } else { "" };
            assert!(with_keys(text, [(name, Value::from(1.0))]).is_ok(), "{name}");
        }
    }
}
