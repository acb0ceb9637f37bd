//! Texts that are changed as files of people differ: each is read right, refused, or read with a remark; none is wrong
//! without a word.

use std::collections::BTreeMap;
use std::convert::Infallible;

use measurements::{ScanRequest, read_channels};
use tables::Cells;

/// Number of texts.
const TEXTS: u64 = 2000;
/// Rounding of printed heights, relative.
const ROUNDING: f64 = 2e-3;

/// Numbers that look random, by SplitMix64 (Steele, Lea & Flood 2014).
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut mixed = self.0;
        mixed = (mixed ^ (mixed >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        mixed ^ (mixed >> 31)
    }

    fn below(&mut self, bound: usize) -> usize {
        (self.next() % bound as u64) as usize
    }

    fn of<'v, T>(&mut self, values: &'v [T]) -> &'v T {
        &values[self.below(values.len())]
    }

    /// Between -1 and 1.
    fn unit(&mut self) -> f64 {
        (self.next() >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Kind {
    NamedProfile,
    UnnamedProfile,
    Table,
    NamedPoints,
    UnnamedPoints,
    Matrix,
    Column,
    EsriGrid,
}

const KINDS: [Kind; 8] = [
    Kind::NamedProfile,
    Kind::UnnamedProfile,
    Kind::Table,
    Kind::NamedPoints,
    Kind::UnnamedPoints,
    Kind::Matrix,
    Kind::Column,
    Kind::EsriGrid,
];

/// Class of a text: the rules say how to read it, or leave it open.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Class {
    Readable,
    Ambiguous,
}

/// A text in parts, and what it holds.
#[derive(Clone)]
struct Text {
    kind: Kind,
    header: Vec<String>,
    /// Names with units, empty where there are none.
    heads: Vec<(String, String)>,
    rows: Vec<Vec<String>>,
    /// The columns of heights, one of which is read.
    height: usize,
    separator: char,
    decimal: char,
    line_end: &'static str,
    above: Vec<String>,
    below: Vec<String>,
    options: &'static str,
    /// Heights in m, and the length along the rows in m.
    heights_m: Vec<Option<f64>>,
    size_m: f64,
    unit_m: f64,
    class: Class,
    has_units_below: bool,
    is_quoted: bool,
}

impl Text {
    fn new(kind: Kind, random: &mut Random) -> Self {
        let (columns, rows) = (7 + random.below(6), 6 + random.below(5));
        let count = if is_map(kind) { columns * rows } else { 40 + random.below(100) };
        let mut height = 0.0;
        let scale = *random.of(&[0.3, 4.0, 90.0]);
        let heights: Vec<f64> = (0..count)
            .map(|_| {
                height = 0.6 * height + scale * random.unit();
                (height * 1000.0).round() / 1000.0
            })
            .collect();
        let unit = *random.of(&["nm", "um"]);
        let unit_m = match kind {
            Kind::UnnamedProfile | Kind::UnnamedPoints => 1e-6,
            Kind::EsriGrid => 1.0,
            _ if unit == "nm" => 1e-9,
            _ => 1e-6,
        };
        let separator = *random.of(&[';', '\t']);
        let number = |value: f64| format!("{value:.3}");
        let at = |index: usize| number(0.25 * index as f64);
        let mut text = Self {
            kind,
            header: Vec::new(),
            heads: Vec::new(),
            rows: Vec::new(),
            height: 0,
            separator,
            decimal: '.',
            line_end: "\n",
            above: Vec::new(),
            below: Vec::new(),
            options: "",
            heights_m: heights.iter().map(|height| Some(height * unit_m)).collect(),
            size_m: 0.25e-6 * count as f64,
            unit_m,
            class: Class::Readable,
            has_units_below: false,
            is_quoted: false,
        };
        let heads = |names: &[(&str, &str)]| -> Vec<(String, String)> {
            names.iter().map(|(name, unit)| ((*name).to_owned(), (*unit).to_owned())).collect()
        };
        let indexed = || heights.iter().enumerate();
        match kind {
            Kind::NamedProfile | Kind::UnnamedProfile => {
                text.rows = indexed().map(|(index, height)| vec![at(index), number(*height)]).collect();
                text.height = 1;
                if kind == Kind::NamedProfile {
                    text.heads = heads(&[(*random.of(&["x", "Distance", "Lateral"]), "um"), ("z", unit)]);
                } else {
                    text.options = ":unit=um";
                }
            }
            Kind::Table => {
                let slope = |index: usize| number((index as f64 * 0.7).sin());
                text.rows =
                    indexed().map(|(index, height)| vec![at(index), number(*height), slope(index)]).collect();
                text.heads = heads(&[("x", "um"), ("Height", unit), ("Slope", "urad")]);
                text.height = 1;
            }
            Kind::NamedPoints | Kind::UnnamedPoints => {
                let place = |index: usize| [at(index % columns), at(index / columns)];
                text.rows = indexed()
                    .map(|(index, height)| [&place(index)[..], &[number(*height)]].concat())
                    .collect();
                text.height = 2;
                text.size_m = 0.25e-6 * columns as f64;
                if kind == Kind::NamedPoints {
                    text.heads = heads(&[("x", "um"), ("y", "um"), ("z", unit)]);
                } else {
                    text.options = ":unit=um";
                }
            }
            Kind::Matrix | Kind::EsriGrid => {
                text.rows =
                    heights.chunks(columns).map(|row| row.iter().map(|z| number(*z)).collect()).collect();
                text.size_m = 10e-6;
                text.header = vec![
                    "# Channel: Topography".to_owned(),
                    "# Width: 10 um".to_owned(),
                    "# Height: 8 um".to_owned(),
                    format!("# Value units: {unit}"),
                ];
                if kind == Kind::EsriGrid {
                    text.size_m = 0.5 * columns as f64;
                    text.header = vec![
                        format!("ncols {columns}"),
                        format!("nrows {rows}"),
                        "cellsize 0.5".to_owned(),
                        "NODATA_value -9999".to_owned(),
                    ];
                    text.separator = ' ';
                    text.options = ":unit=m";
                }
            }
            Kind::Column => {
                text.rows = heights.iter().map(|height| vec![number(*height)]).collect();
                text.header = vec!["# Spacing: 0.25 um".to_owned(), format!("# Value units: {unit}")];
            }
        }
        text
    }

    fn render(&self) -> String {
        let separator = self.separator.to_string();
        let mut lines = self.header.clone();
        let quoted = |field: &str| if self.is_quoted { format!("\"{field}\"") } else { field.to_owned() };
        let joined = |fields: Vec<String>| {
            fields.iter().map(|field| quoted(field)).collect::<Vec<_>>().join(&separator)
        };
        let of_heads =
            |field: &dyn Fn(&(String, String)) -> String| joined(self.heads.iter().map(field).collect());
        if self.has_units_below {
            lines.push(of_heads(&|(name, _)| name.clone()));
            lines.push(of_heads(&|(_, unit)| unit.clone()));
        } else if !self.heads.is_empty() {
            lines.push(of_heads(&|(name, unit)| format!("{name} ({unit})")));
        }
        lines.extend(self.above.iter().cloned());
        let with_mark = |field: &String| field.replace('.', &self.decimal.to_string());
        lines.extend(self.rows.iter().map(|row| joined(row.iter().map(with_mark).collect())));
        lines.extend(self.below.iter().cloned());
        lines.iter().map(|line| format!("{line}{}", self.line_end)).collect()
    }

    /// Changes a text as one of the files that people have differs from another.
    fn mutate(&mut self, random: &mut Random) -> &'static str {
        let is_named = !self.heads.is_empty();
        let columns = self.rows[0].len();
        let ambiguous = |text: &mut Self| text.class = Class::Ambiguous;
        match random.below(17) {
            0 if is_named => {
                let by = 1 + random.below(columns - 1);
                self.rows.iter_mut().for_each(|row| row.rotate_left(by));
                self.heads.rotate_left(by);
                self.height = (self.height + columns - by) % columns;
                "columns permuted"
            }
            0 | 1
                if matches!(self.kind, Kind::UnnamedProfile | Kind::UnnamedPoints)
                    && self.height + 1 == columns =>
            {
                self.rows.iter_mut().for_each(|row| row.rotate_right(1));
                self.height = 0;
                ambiguous(self);
                "columns permuted without names"
            }
            1 if is_named => {
                self.heads[self.height].1 =
                    (*random.of(&["V", "deg", "s", "mV", "urad", "counts"])).to_owned();
                ambiguous(self);
                "no length for a unit"
            }
            1 | 2 if self.kind == Kind::Matrix => {
                self.header[3] = format!("# Value units: {}", random.of(&["V", "deg", "rad"]));
                ambiguous(self);
                "no length for a unit"
            }
            2 | 3 => {
                let count = self.rows.len();
                let line = match self.kind {
                    Kind::Matrix | Kind::EsriGrid => {
                        random.of(&[format!("{columns} {count}"), format!("{}", columns * count)]).clone()
                    }
                    _ => random.of(&[format!("{count}"), "Sample 12".to_owned()]).clone(),
                };
                self.above.insert(0, line);
                "preamble"
            }
            4 => {
                let line = match self.kind {
                    Kind::Matrix | Kind::EsriGrid => format!("{columns} {}", self.rows.len() + 3),
                    _ => format!("{}", self.rows.len() + 3),
                };
                self.above.insert(0, line);
                ambiguous(self);
                "preamble that states more"
            }
            5 => {
                self.below.push((*random.of(&["", "# end of data", "\n"])).to_owned());
                "an end without numbers"
            }
            6 => {
                let footer = [format!("Ra{}0.31", self.separator), "Mean roughness 0.31 um".to_owned()];
                self.below.push(random.of(&footer).clone());
                ambiguous(self);
                "a footer"
            }
            7 => {
                let rows: Vec<String> =
                    self.rows.iter().map(|row| row.join(&self.separator.to_string())).collect();
                self.below.push(String::new());
                if is_named && random.below(2) == 0 {
                    self.below.push("Profile 2".to_owned());
                }
                self.below.extend(rows);
                ambiguous(self);
                "a second block"
            }
            8 | 9 => {
                let mark = *random.of(&[
                    "nan", "NaN", "Bad", "***", "---", "N/A", "#N/A", "null", "No Data", "NM", "-1.#IND",
                    "void", "masked",
                ]);
                self.leave_out(mark, random);
                "gaps"
            }
            10 => {
                let mark = *random.of(&["-9999", "99999", "-32768"]);
                if self.kind == Kind::EsriGrid && mark == "-9999" {
                    self.leave_out(mark, random);
                    return "declared marks of gaps";
                }
                self.leave_out(mark, random);
                ambiguous(self);
                "marks of gaps that nothing declares"
            }
            11 if self.decimal == '.' => {
                let is_matrix = matches!(self.kind, Kind::Matrix | Kind::EsriGrid);
                let heights = self.rows.iter_mut().flat_map(|row| row.iter_mut().enumerate());
                for (_, field) in heights.filter(|(column, _)| is_matrix || *column == self.height) {
                    if let Ok(height) = field.parse::<f64>() {
                        *field = in_thousands((height * 100.0).round());
                    }
                }
                let unit_m = self.unit_m;
                let rounded = |height: &mut f64| *height = (*height / unit_m * 100.0).round() * unit_m;
                self.heights_m.iter_mut().flatten().for_each(rounded);
                ambiguous(self);
                "marks of thousands"
            }
            13 if is_named && !self.has_units_below => {
                self.has_units_below = true;
                "units in a line of their own"
            }
            14 if is_named && self.heads[0].0 != "No." => {
                self.heads.insert(0, ("No.".to_owned(), String::new()));
                self.rows.iter_mut().enumerate().for_each(|(at, row)| row.insert(0, (at + 1).to_string()));
                self.height += 1;
                "a counter"
            }
            15 if self.separator != ' ' => {
                self.is_quoted = true;
                "quotes"
            }
            12 if self.separator != ' ' => {
                self.decimal = ',';
                "decimal commas"
            }
            _ => {
                self.line_end = *random.of(&["\r\n", "\r", "\r\r\n"]);
                "line ends"
            }
        }
    }

    fn leave_out(&mut self, mark: &str, random: &mut Random) {
        for _ in 0..1 + random.below(3) {
            let at = 3 + random.below(self.heights_m.len() - 4);
            let columns = self.rows[0].len();
            let (row, column) = match self.kind {
                Kind::Matrix | Kind::EsriGrid => (at / columns, at % columns),
                _ => (at, self.height),
            };
            mark.clone_into(&mut self.rows[row][column]);
            self.heights_m[at] = None;
        }
    }

    /// Mean square of the heights about their mean.
    fn rms_height_m(&self) -> f64 {
        let known: Vec<f64> = self.heights_m.iter().flatten().copied().collect();
        let mean = known.iter().sum::<f64>() / known.len() as f64;
        (known.iter().map(|height| (height - mean).powi(2)).sum::<f64>() / known.len() as f64).sqrt()
    }
}

fn is_map(kind: Kind) -> bool {
    matches!(kind, Kind::NamedPoints | Kind::UnnamedPoints | Kind::Matrix | Kind::EsriGrid)
}

fn in_thousands(number: f64) -> String {
    let digits = format!("{:.0}", number.abs());
    let (lead, rest) = digits.split_at(digits.len() - digits.len().min(3));
    let sign = if number < 0.0 { "-" } else { "" };
    if lead.is_empty() { format!("{sign}{rest}") } else { format!("{sign}{lead},{rest}") }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Outcome {
    Right,
    RightWithRemark,
    Refused,
    WrongWithRemark,
    SilentlyWrong,
}

fn outcome(text: &Text) -> (Outcome, String) {
    let request: ScanRequest = format!("a.txt{}", text.options).parse().unwrap();
    let files = BTreeMap::from([("a.txt".to_owned(), text.render().into_bytes())]);
    let Ok(channels) = read_channels::<Infallible>(&[request], &files, false, |_, _| Ok(()));
    if let Some(error) = channels.unreadable.first() {
        return (Outcome::Refused, error.to_string());
    }
    let table = channels.table();
    let number = |column: &str| match table.column(column) {
        Some(Cells::Numbers(cells)) => cells[0].unwrap_or(f64::NAN),
        other => panic!("{column}: {other:?}"),
    };
    let note = match table.column("note") {
        Some(Cells::Typed(cells)) => cells[0].text().into_owned(),
        other => panic!("note: {other:?}"),
    };
    let close = |found: f64, expected: f64| (found / expected - 1.0).abs() < ROUNDING;
    let is_right =
        close(number("rms_height_m"), text.rms_height_m()) && close(number("size_x_m"), text.size_m);
    let outcome = match (is_right, note.is_empty()) {
        (true, true) => Outcome::Right,
        (true, false) => Outcome::RightWithRemark,
        (false, false) => Outcome::WrongWithRemark,
        (false, true) => Outcome::SilentlyWrong,
    };
    (outcome, note)
}

#[test]
fn changed_texts_are_read_right_or_refused_or_remarked_on() {
    let mut counts: BTreeMap<(Class, Outcome), usize> = BTreeMap::new();
    let mut wrong = Vec::new();
    for seed in 0..TEXTS {
        let mut random = Random(seed);
        let mut text = Text::new(KINDS[seed as usize % KINDS.len()], &mut random);
        let mutations: Vec<&str> = (0..1 + random.below(3) / 2).map(|_| text.mutate(&mut random)).collect();
        let (found, words) = outcome(&text);
        *counts.entry((text.class, found)).or_default() += 1;
        if found == Outcome::SilentlyWrong
            || (text.class == Class::Readable && found == Outcome::WrongWithRemark)
        {
            wrong.push(format!("{seed} {:?} {mutations:?}: {words}\n{}", text.kind, text.render()));
        }
    }
    let of = |class: Class, outcomes: &[Outcome]| -> usize {
        outcomes.iter().filter_map(|outcome| counts.get(&(class, *outcome))).sum()
    };
    let right = of(Class::Readable, &[Outcome::Right, Outcome::RightWithRemark]);
    let readable = right + of(Class::Readable, &[Outcome::Refused, Outcome::WrongWithRemark]);
    assert!(wrong.is_empty(), "{} wrong, of {counts:?}; the first:\n{}", wrong.len(), wrong[0]);
    assert!(readable >= 1000, "{counts:?}");
    assert!(right * 10 >= readable * 7, "{counts:?}");
}
