//! Names and units of the columns of a table, from the lines above its numbers.

use super::columns::Columns;
use super::lengths::trailing_unit;
use super::separator::Separator;
use units::LengthUnit;

/// The name of a column and its unit.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Head {
    /// The name without the unit; empty where there is none.
    pub(super) name: String,
    pub(super) unit: Option<LengthUnit>,
    /// Unit that is no length, such as `s` and `mV`.
    pub(super) foreign: Option<String>,
    /// The line of the unit, from 1.
    line: usize,
}

/// One head for each column, or none where no line names them.
#[derive(Default)]
pub(super) struct Heads {
    heads: Vec<Head>,
}

impl Heads {
    /// Takes a line for the names of the columns, or for the units below them, where it holds as many as there are
    /// columns. The last line of names counts.
    pub(super) fn take_line(&mut self, line: &str, number: usize, columns: &Columns) -> bool {
        // Above a single column a line with a number states a fact.
        if columns.count == 1 && line.contains(|c: char| c.is_ascii_digit()) {
            return false;
        }
        let found = fields_in(line, columns)
            .map(|fields| fields.iter().map(|field| Head::parse(field, number)).collect::<Vec<_>>());
        let Some(mut found) = found.or_else(|| named_by_brackets(line, number, columns.count)) else {
            return false;
        };
        let bare = |head: &Head| LengthUnit::parse(&head.name).filter(|_| head.unit.is_none());
        let are_units =
            found.iter().all(|head| head.name.is_empty() || bare(head).is_some() || is_no_length(&head.name))
                && found.iter().any(|head| head.unit.is_some() || bare(head).is_some());
        if are_units {
            for head in &mut found {
                if let Some(unit) = bare(head) {
                    head.unit = Some(unit);
                } else if !head.name.is_empty() {
                    head.foreign = Some(head.name.clone());
                }
                head.name.clear();
            }
        }
        if self.heads.is_empty() {
            self.heads = found;
            return self.are_telling();
        }
        if are_units {
            for (head, unit) in self.heads.iter_mut().zip(found) {
                (head.unit, head.foreign, head.line) = (unit.unit, unit.foreign, number);
            }
        } else if count_of_known(&found) >= count_of_known(&self.heads) {
            self.heads = found;
        }
        self.are_telling()
    }

    /// Returns true if a name or a unit is one that tables have.
    pub(super) fn are_telling(&self) -> bool {
        count_of_known(&self.heads) > 0
    }

    /// The name and unit of a column, from 0.
    pub(super) fn of(&self, column: usize) -> Option<&Head> {
        self.heads.get(column)
    }

    /// The unit of a column, from 0.
    pub(super) fn unit(&self, column: usize) -> Option<LengthUnit> {
        self.of(column)?.unit
    }

    /// Returns the unit of a column, from 0, that is no length, and its line.
    pub(super) fn foreign(&self, column: usize) -> Option<(usize, &str)> {
        let head = self.of(column)?;
        Some((head.line, head.foreign.as_deref()?))
    }

    /// The name of a column, from 0; its number where it has none.
    pub(super) fn name(&self, column: usize) -> String {
        match self.of(column) {
            Some(head) if self.is_named(column) => head.name.clone(),
            _ => format!("column {}", column + 1),
        }
    }

    /// Notes a factor in the name of a column, from 0, such as `z*100`.
    pub(super) fn factor_note(&self, column: usize) -> Option<String> {
        let name = &self.of(column)?.name;
        let has_number = name.split(|c: char| !c.is_ascii_digit()).any(|digits| digits.len() > 1);
        let is_factor = has_number && name.contains(['*', 'x', '\u{d7}', '/']);
        is_factor.then(|| format!("the number in the name '{name}' is not used: is it a factor?"))
    }

    /// Returns true if a column, from 0, has a name.
    pub(super) fn is_named(&self, column: usize) -> bool {
        self.of(column).is_some_and(|head| !head.name.is_empty())
    }

    /// Returns true if the columns have different units.
    pub(super) fn differ_in_units(&self) -> bool {
        let units: Vec<_> =
            self.heads.iter().filter(|head| head.unit.is_some() || head.foreign.is_some()).collect();
        units.windows(2).any(|pair| (pair[0].unit, &pair[0].foreign) != (pair[1].unit, &pair[1].foreign))
    }
}

impl Head {
    /// A field such as `X_(microns)`, `Lateral um`, `h/nm`, `x_mm`, `Slope [urad]`.
    fn parse(field: &str, line: usize) -> Self {
        let field = field.trim().trim_matches('"').trim();
        let unit = trailing_unit(field);
        let (name, foreign) = match split_bracket(field) {
            Some((name, _)) if unit.is_some() => (name, None),
            Some((name, inside)) if is_no_length(inside) || unit_like(inside) => {
                (name, Some(inside.to_owned()))
            }
            Some((name, "")) => (name, None),
            Some(_) => (field, None),
            None => match field.rsplit_once([' ', '/', '_', ',']) {
                Some((name, _)) if unit.is_some() => (name, None),
                Some((name, word))
                    if is_no_length(word)
                        && (word.chars().count() > 1
                            || name.trim_end().ends_with('/')
                            || field.ends_with(&format!("/{word}"))) =>
                {
                    (name, Some(word.to_owned()))
                }
                _ => (field, None),
            },
        };
        let name = name.trim_matches(|c: char| c.is_whitespace() || "_/,:".contains(c));
        Self { name: name.to_owned(), unit, foreign, line }
    }
}

/// Separates what stands in brackets at the end of a field.
fn split_bracket(field: &str) -> Option<(&str, &str)> {
    let (name, inside) = field.strip_suffix([')', ']', '}'])?.rsplit_once(['(', '[', '{'])?;
    Some((name, inside.trim()))
}

/// Returns true for a word in brackets that is as short as units are.
fn unit_like(text: &str) -> bool {
    let length = text.chars().count();
    (1..=3).contains(&length)
        && text.chars().all(char::is_alphabetic)
        && LengthUnit::parse_any_case(text).is_none()
}

/// The fields of a line, as many as there are columns, whatever separates them.
fn fields_in<'l>(line: &'l str, columns: &Columns) -> Option<Vec<&'l str>> {
    let separated = |separator: char| {
        let mut fields: Vec<&str> = line.split(separator).map(str::trim).collect();
        while fields.len() > columns.count && fields.last().is_some_and(|field| field.is_empty()) {
            fields.pop();
        }
        (columns.count > 1 && fields.len() == columns.count).then_some(fields)
    };
    columns
        .fields_of(line)
        .filter(|_| columns.count > 1 || split_bracket(line).is_some() || LengthUnit::parse(line).is_some())
        .or_else(|| separated('\t').filter(|_| columns.separator == Separator::Blanks))
}

/// The names before as many brackets as there are columns, where blanks separate more words.
fn named_by_brackets(line: &str, number: usize, count: usize) -> Option<Vec<Head>> {
    let parts: Vec<&str> = line.split_inclusive([')', ']']).filter(|part| !part.trim().is_empty()).collect();
    let are_heads = parts.len() == count && parts.iter().all(|part| part.contains(['(', '[']));
    are_heads.then(|| {
        parts
            .into_iter()
            .map(|part| Head::parse(part.trim_start_matches([',', ';', ' ', '\t']), number))
            .collect()
    })
}

fn count_of_known(heads: &[Head]) -> usize {
    heads
        .iter()
        .filter(|head| head.unit.is_some() || head.foreign.is_some() || Role::of(&head.name).is_some())
        .count()
}

/// Content of a column, by its name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Role {
    /// Position along the profile or the rows of a map.
    X,
    /// Position across; without another height, a height.
    Y,
    Height,
    /// A signal that is no height: slope, time, intensity.
    Signal,
    /// A number of the point.
    Counter,
    /// 0 where the height does not count.
    Validity,
    /// 0 where the height counts, or the other way round.
    Defect,
}

impl Role {
    /// The role that a name tells, if any.
    pub(super) fn of(name: &str) -> Option<Self> {
        const COUNTERS: [&str; 15] = [
            "index",
            "idx",
            "no",
            "no.",
            "nr",
            "nr.",
            "#",
            "n",
            "i",
            "point",
            "point no",
            "sample",
            "points",
            "messpunkt",
            "pixel",
        ];
        const SIGNALS: [&str; 29] = [
            "slope",
            "angle",
            "curvature",
            "gradient",
            "time",
            "velocity",
            "speed",
            "force",
            "friction",
            "current",
            "voltage",
            "phase",
            "amplitude",
            "deflection",
            "intensity",
            "brightness",
            "quality",
            "temperature",
            "steigung",
            "winkel",
            "zeit",
            "error",
            "gray",
            "grey",
            "sigma",
            "theta",
            "second",
            "elapsed",
            "frequency",
        ];
        const HEIGHTS: [&str; 22] = [
            "height",
            "heigth",
            "hight",
            "topograph",
            "elevation",
            "altitude",
            "depth",
            "profile",
            "relief",
            "raw",
            "roughness",
            "waviness",
            "residual",
            "vertical",
            "figure",
            "höhe",
            "hoehe",
            "hauteur",
            "altura",
            "altezza",
            "rauheit",
            "profil",
        ];
        const POSITIONS: [&str; 22] = [
            "position",
            "distance",
            "lateral",
            "abscissa",
            "abscisse",
            "coordinate",
            "length",
            "travel",
            "traverse",
            "horizontal",
            "displacement",
            "weg",
            "strecke",
            "länge",
            "laenge",
            "posición",
            "distancia",
            "longitud",
            "posizione",
            "distanza",
            "pos",
            "dist",
        ];
        let name = name.to_lowercase().replace(['_', '-'], " ");
        let name = name.trim();
        let words: Vec<&str> =
            name.split(|c: char| !c.is_alphanumeric()).filter(|word| !word.is_empty()).collect();
        let says =
            |known: &[&str]| known.iter().any(|known| words.iter().any(|word| word.starts_with(known)));
        let letter = |letter: char| {
            let is_it = |word: &&str| {
                word.strip_prefix(letter).is_some_and(|rest| rest.chars().all(|c| c.is_ascii_digit()))
            };
            words.iter().any(is_it)
                || name.starts_with(letter)
                    && ["pos", "coord", "axis", "value", "data"]
                        .iter()
                        .any(|word| name[1..].starts_with(word))
        };
        if COUNTERS.contains(&name) {
            Some(Self::Counter)
        } else if ["valid", "validity", "ok", "good"].contains(&name) {
            Some(Self::Validity)
        } else if ["mask", "flag", "invalid", "bad", "outlier", "missing"].contains(&name) {
            Some(Self::Defect)
        } else if says(&SIGNALS) {
            Some(Self::Signal)
        } else if letter('z') || letter('h') || says(&HEIGHTS) && !name.starts_with(['x', 'y']) {
            Some(Self::Height)
        } else if letter('x') || ["easting", "column", "col"].contains(&name) {
            Some(Self::X)
        } else if letter('y') || ["northing", "row"].contains(&name) {
            Some(Self::Y)
        } else if says(&POSITIONS) {
            Some(Self::X)
        } else {
            None
        }
    }
}

/// Returns true for a unit that instruments write beside signals and that is no length.
pub(super) fn is_no_length(text: &str) -> bool {
    const EXACT: [&str; 60] = [
        "V", "mV", "uV", "µV", "nA", "pA", "uA", "mA", "s", "sec", "ms", "us", "µs", "min", "Hz", "kHz",
        "MHz", "deg", "°", "degree", "degrees", "rad", "mrad", "urad", "µrad", "nrad", "microrad", "arcsec",
        "N", "nN", "mN", "uN", "Pa", "kPa", "MPa", "GPa", "%", "K", "°C", "W", "J", "eV", "a.u.", "arb",
        "arb.", "counts", "count", "cts", "px", "pixel", "pixels", "points", "pts", "lsb", "LSB", "dB",
        "1/0", "waves", "fringes", "mg",
    ];
    let text = text.trim().replace('μ', "µ");
    let is_slope = || {
        let (over, under) = text.split_once('/')?;
        Some(
            (LengthUnit::parse(over).is_some() || over == "1" || EXACT.contains(&over))
                && (LengthUnit::parse(under).is_some() || EXACT.contains(&under)),
        )
    };
    let lower = text.to_lowercase();
    EXACT.contains(&text.as_str())
        || lower.contains("rad") && lower.starts_with("micro")
        || is_slope() == Some(true)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn heads_have_names_and_units() {
        for (field, name, unit, foreign) in [
            ("X_(microns)", "X", Some("um"), None),
            ("Lateral um", "Lateral", Some("um"), None),
            ("h/nm", "h", Some("nm"), None),
            ("x_mm", "x", Some("mm"), None),
            ("Slope (urad)", "Slope", None, Some("urad")),
            ("Slope [micror-rad]", "Slope", None, Some("micror-rad")),
            ("t / s", "t", None, Some("s")),
            ("Deflection (V)", "Deflection", None, Some("V")),
            ("gradient (um/mm)", "gradient", None, Some("um/mm")),
            ("Height (filtered)", "Height (filtered)", None, None),
            ("\"z, um\"", "z", Some("um"), None),
            ("Section A", "Section A", None, None),
            ("[mm]", "", Some("mm"), None),
        ] {
            let head = Head::parse(field, 1);
            let found = (head.name.as_str(), head.unit.map(LengthUnit::ascii), head.foreign.as_deref());
            assert_eq!(found, (name, unit, foreign), "{field}");
        }
    }

    #[test]
    fn names_tell_roles() {
        for (name, role) in [
            ("X", Some(Role::X)),
            ("x position", Some(Role::X)),
            ("xpos", Some(Role::X)),
            ("Distance", Some(Role::X)),
            ("Lateral", Some(Role::X)),
            ("y1", Some(Role::Y)),
            ("Z", Some(Role::Height)),
            ("Raw", Some(Role::Height)),
            ("Measured heigth", Some(Role::Height)),
            ("Residual Heigth", Some(Role::Height)),
            ("Residual slope", Some(Role::Signal)),
            ("h", Some(Role::Height)),
            ("No.", Some(Role::Counter)),
            ("valid", Some(Role::Validity)),
            ("Sample A", None),
            ("hours", None),
            ("extra", None),
        ] {
            assert_eq!(Role::of(name), role, "{name}");
        }
    }
}
