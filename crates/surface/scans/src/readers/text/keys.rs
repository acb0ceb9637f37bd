//! Names of header fields, as programs write them.

/// A field known here.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Key {
    Channel,
    Size(usize),
    Spacing(usize),
    LateralUnit,
    ValueUnit,
    Unit,
    /// The number of columns or rows of a map.
    Count(usize),
    /// The number of points of a profile, or of all.
    Points,
    /// The factor from values to nm, which counts where they have no unit.
    ToNanometres,
    Program,
}

/// Keys in lower case with blanks for hyphens and underscores. Gwyddion translates those of its exports.
const KEYS: [(Key, &[&str]); 13] = [
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
    (
        Key::Count(0),
        &[
            "columns",
            "number of columns",
            "num columns",
            "x pixels",
            "xpixels",
            "x points",
            "points per line",
            "nx",
        ],
    ),
    (
        Key::Count(1),
        &["rows", "number of rows", "num rows", "y pixels", "ypixels", "y points", "number of lines", "ny"],
    ),
    (
        Key::Points,
        &[
            "points",
            "number of points",
            "num points",
            "numpoints",
            "data points",
            "number of samples",
            "samples",
        ],
    ),
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

/// A key of the extent of the points with what follows it behind a comma, a semicolon or a tab, as tables have it.
pub(super) fn extent_in_table(line: &str) -> Option<(Key, &str)> {
    let (name, value) = line.split_once([',', ';', '\t'])?;
    let (key, _) = key_and_value(&format!("{name}:"))?;
    let value = value.trim().trim_end_matches([',', ';', '\t', ' ']);
    let is_extent = matches!(key, Key::Size(_) | Key::Points | Key::Count(_));
    (is_extent && value.starts_with(|c: char| c.is_ascii_digit())).then_some((key, value))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_translation_of_gwyddion_is_known() {
        for (language, keys) in [
            ("cs", ["Kanál:", "Šířka:", "Výška:", "Jednotky hodnot:"]),
            ("de", ["Kanal:", "Breite:", "Höhe:", "Einheiten:"]),
            ("en", ["Channel:", "Width:", "Height:", "Value units:"]),
            ("es", ["Canal:", "Anchura:", "Altura:", "Value units:"]),
            ("fr", ["Canal :", "Largeur :", "Hauteur :", "Unités :"]),
            ("it", ["Canale:", "Larghezza:", "Altezza:", "unità valore:"]),
            ("ja", ["チャネル：", "幅:", "高さ：", "値の単位:"]),
            ("ko", ["채널:", "폭:", "높이:", "값 단위:"]),
            ("pt", ["Canal:", "Largura:", "Altura:", "Unidades de valor:"]),
            ("ru", ["Канал:", "Ширина:", "Высота:", "Единицы измерения:"]),
        ] {
            let expected = [Key::Channel, Key::Size(0), Key::Size(1), Key::ValueUnit];
            for (key, expected) in keys.into_iter().zip(expected) {
                assert!(key_and_value(key).is_some_and(|(found, _)| found == expected), "{language} {key}");
            }
        }
    }
}
