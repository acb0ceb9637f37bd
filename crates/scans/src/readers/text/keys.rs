//! What programs call the fields of their headers.

/// A field known here.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Key {
    Channel,
    Size(usize),
    Spacing(usize),
    LateralUnit,
    ValueUnit,
    Unit,
    /// The factor from values to nm, which counts where they have no unit.
    ToNanometres,
    Program,
}

/// Keys in lower case with blanks for hyphens and underscores. Gwyddion translates those of its exports.
const KEYS: [(Key, &[&str]); 10] = [
    (Key::Channel, &["channel", "kanál", "kanal", "canal", "canale", "チャネル", "채널", "канал"]),
    (
        Key::Size(0),
        &[
            "width",
            "x length",
            "x size",
            "size x",
            "x range",
            "length",
            "šířka",
            "breite",
            "anchura",
            "largeur",
            "larghezza",
            "幅",
            "폭",
            "largura",
            "ширина",
        ],
    ),
    (
        Key::Size(1),
        &[
            "height",
            "y length",
            "y size",
            "size y",
            "y range",
            "výška",
            "höhe",
            "altura",
            "hauteur",
            "altezza",
            "高さ",
            "높이",
            "высота",
        ],
    ),
    (
        Key::Spacing(0),
        &["spacing", "x spacing", "pixel size", "x step", "step", "dx", "scale x", "point spacing"],
    ),
    (Key::Spacing(1), &["y spacing", "y step", "dy", "scale y", "line spacing"]),
    (
        Key::LateralUnit,
        &["lateral units", "lateral unit", "x unit", "xy unit", "xy units", "unit x", "length unit"],
    ),
    (
        Key::ValueUnit,
        &[
            "value units",
            "value unit",
            "z unit",
            "z units",
            "height unit",
            "height units",
            "unit data",
            "jednotky hodnot",
            "einheiten",
            "unités",
            "unità valore",
            "値の単位",
            "값 단위",
            "unidades de valor",
            "единицы измерения",
        ],
    ),
    (Key::Unit, &["unit", "units"]),
    (Key::ToNanometres, &["bit2nm"]),
    (Key::Program, &["file format"]),
];

/// A recognised key with what follows it.
pub(super) fn key_and_value(line: &str) -> Option<(Key, &str)> {
    let (name, value) = line.split_once([':', '=', '：'])?;
    let name = name.trim().to_lowercase().replace(['-', '_'], " ");
    let (key, _) = KEYS.iter().find(|(_, names)| names.contains(&name.as_str()))?;
    Some((*key, value.trim()))
}
