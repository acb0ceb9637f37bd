//! Names of header fields, as programs write them.

use std::borrow::Cow;

use units::LengthUnit;

/// A field known here.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Key {
    Channel,
    Size(usize),
    /// The length of a scan, beside which a width is across.
    Length,
    /// The width of a map, along its rows unless a length is.
    Width,
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
    /// The range of heights, which tells their unit.
    ValueRange,
    /// The factor of heights, perhaps with their unit.
    Multiplier,
    /// The number in the place of heights that are missing.
    NoData,
    Program,
}

/// Keys in lower case with blanks for hyphens and underscores. Gwyddion translates those of its exports.
const KEYS: [(Key, &[&str]); 18] = [
    (Key::Channel, &["channel", "kanál", "kanal", "canal", "canale", "チャネル", "채널", "канал"]),
    (Key::Size(0), &["x length", "x size", "size x", "x range", "x amplitude"]),
    (
        Key::Width,
        &["width", "šířka", "breite", "anchura", "largeur", "larghezza", "幅", "폭", "largura", "ширина"],
    ),
    (
        Key::Size(1),
        &[
            "height",
            "y length",
            "y size",
            "size y",
            "y range",
            "scan width",
            "y amplitude",
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
        &[
            "spacing",
            "x spacing",
            "spacing x",
            "pixel size",
            "pixel width",
            "pixel spacing",
            "x step",
            "step",
            "step size",
            "step width",
            "dx",
            "delta x",
            "scale x",
            "x scale",
            "x increment",
            "increment",
            "point spacing",
            "point distance",
            "data spacing",
            "sample spacing",
            "sampling distance",
            "sampling interval",
            "sampling step",
            "sample interval",
            "measurement step",
            "measurement interval",
            "pitch",
            "x pitch",
            "cellsize",
            "cell size",
            "lateral resolution",
            "xpixelsize",
            "pixel size x",
            "x pixel size",
            "punktabstand",
            "xy calibration",
            "xy justierung",
            "xy캘리브레이션",
        ],
    ),
    (
        Key::Spacing(1),
        &[
            "y spacing",
            "spacing y",
            "pixel height",
            "y step",
            "dy",
            "delta y",
            "scale y",
            "y scale",
            "y increment",
            "line spacing",
            "line distance",
            "y pitch",
        ],
    ),
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
            "unit z",
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
    (Key::Unit, &["unit", "units", "einheit"]),
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
            "ncols",
            "horizontal",
            "horizont.",
            "가로",
        ],
    ),
    (
        Key::Count(1),
        &[
            "rows",
            "number of rows",
            "num rows",
            "y pixels",
            "ypixels",
            "y points",
            "number of lines",
            "ny",
            "nrows",
            "vertical",
            "vertikal",
            "세로",
        ],
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
    (
        Key::Length,
        &[
            "length",
            "scan length",
            "trace length",
            "profile length",
            "traverse length",
            "measuring length",
            "measurement length",
            "länge",
        ],
    ),
    (Key::ValueRange, &["z amplitude", "z range"]),
    (
        Key::Multiplier,
        &[
            "multiplier",
            "mult",
            "height multiplier",
            "z multiplier",
            "height factor",
            "z factor",
            "height scale",
            "z scale",
            "scale z",
        ],
    ),
    (
        Key::NoData,
        &[
            "nodata value",
            "nodata",
            "no data value",
            "no data",
            "missing value",
            "missing data",
            "bad value",
            "bad data",
            "invalid value",
            "invalid data",
            "fill value",
            "fillvalue",
            "undefined value",
            "dummy value",
            "void value",
            "bad pixel value",
            "blank value",
            "null value",
            "missingvalue",
            "missing",
            "invalid",
        ],
    ),
    (Key::Program, &["file format"]),
];

/// A recognised key with what follows it behind a colon or an equals sign. A unit in brackets behind the key is that of
/// the value.
pub(super) fn key_and_value(line: &str) -> Option<(Key, Cow<'_, str>)> {
    let (name, value) = line.split_once([':', '=', '：'])?;
    key_in_unit(name, value.trim())
}

/// The key that a name is, and its value with the unit that stands in brackets behind the name.
fn key_in_unit<'l>(name: &str, value: &'l str) -> Option<(Key, Cow<'l, str>)> {
    if let Some(key) = key(name) {
        return Some((key, Cow::Borrowed(value)));
    }
    let (bare, unit) = name.trim().trim_matches('"').strip_suffix([')', ']'])?.split_once(['(', '['])?;
    LengthUnit::parse_instrument(unit)?;
    let is_length = |key: &Key| {
        matches!(
            key,
            Key::Size(_) | Key::Length | Key::Width | Key::Spacing(_) | Key::ValueRange | Key::Multiplier
        )
    };
    Some((key(bare).filter(is_length)?, Cow::Owned(format!("{value} {unit}"))))
}

fn key(name: &str) -> Option<Key> {
    let name = name.to_lowercase().replace(['-', '_'], " ");
    let name = name.trim_matches(|c: char| c.is_whitespace() || "\"!/*".contains(c));
    KEYS.iter().find(|(_, names)| names.contains(&name)).map(|(key, _)| *key)
}

/// A key of a number or a unit with what follows it behind a comma, a semicolon, a tab or a blank, as tables of facts
/// have it.
pub(super) fn key_in_table(line: &str) -> Option<(Key, Cow<'_, str>)> {
    const SEPARATORS: [char; 3] = ['\t', ';', ','];
    let with_separators = SEPARATORS.into_iter().filter_map(|separator| line.split_once(separator));
    let blanks = line.match_indices(' ').map(|(at, _)| line.split_at(at));
    with_separators.chain(blanks).find_map(|(name, value)| {
        let value = value.trim().trim_end_matches([',', ';', '\t', ' ']);
        let (key, value) = key_in_unit(name, value)?;
        let is_number = value.starts_with(|c: char| c.is_ascii_digit() || "+-.".contains(c));
        let fits = match key {
            Key::Channel | Key::Program => false,
            Key::LateralUnit | Key::ValueUnit | Key::Unit => LengthUnit::parse_instrument(&value).is_some(),
            _ => is_number,
        };
        fits.then_some((key, value))
    })
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
            let expected = [Key::Channel, Key::Width, Key::Size(1), Key::ValueUnit];
            for (key, expected) in keys.into_iter().zip(expected) {
                assert!(key_and_value(key).is_some_and(|(found, _)| found == expected), "{language} {key}");
            }
        }
    }
}
