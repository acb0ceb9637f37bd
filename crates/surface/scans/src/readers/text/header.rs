//! Header of a text file: sizes, spacings, units, the channel.

use super::body::Body;
use super::columns::Columns;
use super::heads::Heads;
use super::keys::{Key, key_and_value, key_in_table};
use super::lengths::{Length, factor, length, numbered_factor, stylus_radius_m, unit};
use super::style::{FORMAT, holds_numbers, is_comment, shortened};
use crate::choice_of_units::Units;
use crate::error::{FilePlace, ScanReadError};
use crate::numbers;
use crate::scan_size::ScanSize;
use units::LengthUnit;

/// Contents of the lines before the first numbers.
#[derive(Default)]
pub(crate) struct Header {
    /// The channel of the file, where it has a name.
    pub channel: Option<String>,
    /// The length of a scan.
    length: Option<Length>,
    /// The width of a map.
    width: Option<Length>,
    /// Along x and y.
    sizes: [Option<Length>; 2],
    spacings: [Option<Length>; 2],
    /// Sizes that stand in a table above the points: they are compared, but make no matrix.
    tabled_sizes: [Option<Length>; 2],
    pub lateral_unit: Option<LengthUnit>,
    /// True if `lateral_unit` is that of all numbers.
    is_of_all: bool,
    value_unit: Option<LengthUnit>,
    /// Factor that takes values to their unit.
    value_factor: Option<f64>,
    to_nanometres: Option<f64>,
    counts: Vec<StatedCount>,
    /// The number that marks points without a height.
    pub no_data: Option<f64>,
    /// Names and units of the columns.
    pub heads: Heads,
    /// Lines of a name and a number that are not used.
    unread: Vec<String>,
    /// Radius of the stylus in m, where a line gives it.
    pub stylus_radius_m: Option<f64>,
    /// The lines that hold no field known here.
    free_text: String,
}

/// A number of points that the header states.
#[derive(Clone, Copy)]
struct StatedCount {
    key: Key,
    stated: usize,
    line: usize,
}

/// Most bytes of lines that are kept for what a user may have written there.
const MOST_FREE_TEXT: usize = 4096;

impl Header {
    pub(super) fn read(body: &Body<'_>, columns: &Columns) -> Result<Self, ScanReadError> {
        let mut header = Self::default();
        for (index, line) in body.text().lines().enumerate() {
            let (number, is_below) = (index + 1, index + 1 >= columns.first_line);
            if is_below && !is_comment(line.trim_start()) {
                continue;
            }
            // A tab at the ends is that of an empty column.
            let with_tabs =
                line.trim_matches(|c: char| c != '\t' && (c.is_whitespace() || "#%\u{feff}".contains(c)));
            let line = with_tabs.trim();
            let known = key_and_value(line);
            match known {
                Some((Key::Channel, _)) if is_below => return Err(second_channel(number)),
                Some((key, ref value)) if !is_below => header.set(key, value, number)?,
                None if !is_below => header.take_line(with_tabs, number, columns)?,
                _ => {}
            }
            if !line.is_empty() && known.is_none() && header.free_text.len() + line.len() < MOST_FREE_TEXT {
                header.free_text += line;
                header.free_text.push('\n');
            }
        }
        // Of a length and a width the width is across.
        if header.length.is_some() {
            header.sizes[1] = header.sizes[1].or(header.width);
        }
        header.sizes[0] = header.sizes[0].or(header.length).or(header.width);
        // One unit for all is that of heights where a length along the line has another.
        let along = [header.spacings[0], header.sizes[0], header.tabled_sizes[0]].into_iter().flatten();
        if let Some(unit) = along.filter_map(|length| length.unit).next() {
            header.lateral_unit =
                header.lateral_unit.map(|lateral| if header.is_of_all { unit } else { lateral });
        }
        if header.sizes.iter().all(Option::is_none) {
            header.set_by_position(body.text(), columns)?;
        }
        Ok(header)
    }

    /// Takes a line without a key and a colon: a factor, a row of a table of facts, names of columns.
    fn take_line(&mut self, with_tabs: &str, number: usize, columns: &Columns) -> Result<(), ScanReadError> {
        let line = with_tabs.trim();
        if self.set_conversion(line, number)? {
            return Ok(());
        }
        if let Some(radius_m) = stylus_radius_m(line) {
            self.stylus_radius_m.get_or_insert(radius_m);
            return Ok(());
        }
        match key_in_table(line) {
            Some((key @ (Key::Size(_) | Key::Length | Key::Width), value)) => {
                let axis = if let Key::Size(axis) = key { axis } else { 0 };
                self.tabled_sizes[axis] = length(&value, number).ok().flatten().or(self.tabled_sizes[axis]);
            }
            Some((key, value)) => self.set(key, &value, number)?,
            None if self.heads.take_line(with_tabs, number, columns) => {}
            None if line.contains(|c: char| c.is_ascii_digit()) && !holds_numbers(line) => {
                self.unread.push(line.to_owned())
            }
            None => {}
        }
        Ok(())
    }

    /// Takes the first four lines for those of an export from Gwyddion in a language that is not known: whatever the
    /// keys are, the channel, the two sizes and the unit of the values follow each other.
    fn set_by_position(&mut self, text: &str, columns: &Columns) -> Result<(), ScanReadError> {
        const EXPORT: [Key; 4] = [Key::Channel, Key::Size(0), Key::Size(1), Key::ValueUnit];
        let lines = text.lines().take(columns.first_line.saturating_sub(1));
        let values: Vec<&str> = lines
            .map_while(|line| line.trim_start_matches('\u{feff}').strip_prefix('#'))
            .map_while(|line| line.split_once([':', '：']).map(|(_, value)| value.trim()))
            .take(EXPORT.len())
            .collect();
        let &[_, width, height, unit] = &values[..] else { return Ok(()) };
        let is_size = |text| matches!(length(text, 0), Ok(Some(Length { unit: Some(_), .. })));
        let is_unit = !unit.is_empty()
            && unit.chars().all(|letter| !letter.is_whitespace() && !letter.is_ascii_digit());
        if !(is_size(width) && is_size(height) && is_unit) {
            return Ok(());
        }
        EXPORT
            .into_iter()
            .zip(values)
            .enumerate()
            .try_for_each(|(index, (key, value))| self.set(key, value, index + 1))
    }

    fn set(&mut self, key: Key, value: &str, line: usize) -> Result<(), ScanReadError> {
        match key {
            Key::Channel => self.channel = Some(value.to_owned()),
            Key::Width => self.width = length(value, line)?.or(self.width),
            Key::Length => self.length = length(value, line)?.or(self.length),
            Key::Size(axis) => self.sizes[axis] = length(value, line)?.or(self.sizes[axis]),
            Key::Spacing(axis) => self.spacings[axis] = length(value, line)?.or(self.spacings[axis]),
            Key::ToNanometres => {
                let factor = value.replace(',', ".").parse().ok().filter(|factor: &f64| factor.is_finite());
                self.to_nanometres = factor.or(self.to_nanometres);
            }
            // SPIP exports sizes in nm without saying so.
            Key::Program if value.eq_ignore_ascii_case("ascii") => {
                self.lateral_unit.get_or_insert(LengthUnit::NANOMETRE);
            }
            Key::Program => {}
            Key::NoData => self.no_data = value.replace(',', ".").parse().ok().or(self.no_data),
            Key::ValueRange => {
                let name = value.trim_start_matches(|c: char| c.is_ascii_digit() || "+-.,eE ".contains(c));
                if !name.is_empty() {
                    self.value_unit = Some(unit(name, line)?);
                }
            }
            Key::Multiplier => {
                let (number, unit) = factor(value, line)?;
                (self.value_factor, self.value_unit) = (Some(number), unit.or(self.value_unit));
            }
            Key::Count(_) | Key::Points => {
                // A key of another meaning has another kind of value.
                let stated = value.split_whitespace().next().and_then(numbers::count);
                self.counts.extend(stated.map(|stated| StatedCount { key, stated, line }));
            }
            Key::LateralUnit => (self.lateral_unit, self.is_of_all) = (Some(unit(value, line)?), false),
            Key::ValueUnit => self.value_unit = Some(unit(value, line)?),
            Key::Unit => {
                let unit = unit(value, line)?;
                self.is_of_all |= self.lateral_unit.is_none();
                self.lateral_unit.get_or_insert(unit);
                self.value_unit.get_or_insert(unit);
            }
        }
        Ok(())
    }

    /// Takes a line for the factor of heights, as exports of some microscopes write it: `height conversion factor (->
    /// m) = 2.5e-7`.
    fn set_conversion(&mut self, text: &str, line: usize) -> Result<bool, ScanReadError> {
        let lower = text.to_lowercase();
        let Some((name, factor)) =
            lower.split_once('=').filter(|(name, _)| name.starts_with("height conversion factor"))
        else {
            return Ok(false);
        };
        let unit_name = name.split_once("->").map_or("", |(_, unit)| unit.trim().trim_end_matches(')'));
        self.value_unit = Some(unit(unit_name, line)?);
        self.value_factor = Some(numbered_factor(factor.trim(), line)?);
        Ok(true)
    }

    /// Returns the lines of the header beside the fields known here.
    pub(crate) fn free_text(&self) -> &str {
        self.free_text.trim_end()
    }

    /// Returns true if the header gives both sizes of a map.
    pub(crate) fn is_matrix(&self) -> bool {
        self.sizes.iter().all(Option::is_some)
    }

    /// Returns true if the header states as many points as there are, and nothing across a line: its rows are one line.
    pub(crate) fn is_wrapped_line(&self, columns: &Columns) -> bool {
        let is_of_line =
            |count: &StatedCount| count.key == Key::Points && count.stated == columns.count * columns.rows();
        columns.count > 1
            && self.counts.len() == 1
            && self.counts.iter().all(is_of_line)
            && self.spacings[0].or(self.sizes[0]).is_some()
            && self.spacings[1].or(self.sizes[1]).is_none()
    }

    /// Notes a length that the points at the stated distances do not have.
    pub(crate) fn length_note(&self, points: usize) -> Option<String> {
        let (length, spacing) = (self.sizes[0].or(self.tabled_sizes[0])?, self.spacings[0]?);
        let unit = |of: Length| of.unit.or(self.lateral_unit);
        let (length_m, spacing_m) = (unit(length)?.to_m(length.value), unit(spacing)?.to_m(spacing.value));
        let differs = (length_m - spacing_m * points as f64).abs() > 1.5 * spacing_m;
        differs.then(|| "the header states a length and a distance of points that do not agree".to_owned())
    }

    /// Returns true if the header gives the distance of points along x.
    pub(crate) fn is_spaced(&self) -> bool {
        self.spacings[0].is_some()
    }

    /// The unit of the heights of a map, and what its numbers are multiplied by to be in it.
    pub(crate) fn map_heights(&self) -> (Option<LengthUnit>, f64) {
        match (self.value_unit.or(self.heads.unit(0)), self.to_nanometres) {
            (None, Some(factor)) => (Some(LengthUnit::NANOMETRE), factor),
            (unit, _) => (unit, self.value_factor.unwrap_or(1.0)),
        }
    }

    /// Unit of a column of positions, from 0.
    pub(crate) fn column_unit(&self, column: usize) -> Option<LengthUnit> {
        self.heads.unit(column).or(self.lateral_unit)
    }

    /// Refuses a column, from 0, whose unit is no length.
    pub(crate) fn refuse_no_length(&self, column: usize) -> Result<(), ScanReadError> {
        match self.heads.foreign(column) {
            Some((line, unit)) => {
                Err(ScanReadError::NoLength { line, column: column + 1, unit: unit.to_owned() })
            }
            None => Ok(()),
        }
    }

    /// Returns the factor of heights in a table, as the header states it.
    pub(crate) fn table_factor(&self) -> f64 {
        self.value_factor.unwrap_or(1.0)
    }

    /// Names lines of the header with numbers that are not used.
    pub(crate) fn unread_note(&self) -> Option<String> {
        const SHOWN: usize = 3;
        let shown: Vec<String> =
            self.unread.iter().take(SHOWN).map(|line| format!("'{}'", shortened(line))).collect();
        let rest = self.unread.len().saturating_sub(SHOWN);
        let more = if rest > 0 { format!(" and {rest} more") } else { String::new() };
        (!shown.is_empty()).then(|| format!("not used of the header: {}{more}", shown.join(", ")))
    }

    /// Unit of the column of heights, from 0.
    pub(crate) fn height_unit(&self, column: usize) -> Option<LengthUnit> {
        self.heads.unit(column).or(self.value_unit)
    }

    /// Compares the numbers of points that the header states with those of the file, and returns what to note.
    ///
    /// # Errors
    /// [`ScanReadError::BadField`] if the file holds fewer than stated: it is cut off.
    pub(crate) fn check_counts(&self, columns: &Columns, is_map: bool) -> Result<Vec<String>, ScanReadError> {
        let [across, rows] = [columns.count, columns.rows()];
        let [stated_across, stated_rows] = [0, 1].map(|axis| self.stated(Key::Count(axis)));
        let product = stated_across.zip(stated_rows).map(|(across, rows)| across.saturating_mul(rows));
        let found = |count: &StatedCount| match (count.key, is_map) {
            (Key::Count(axis), true) => Some([across, rows][axis]),
            (Key::Count(_), false) => None,
            // Some programs count the points of a line, others those of the map.
            (_, true) => {
                [across, rows].contains(&count.stated).then_some(count.stated).or(Some(across * rows))
            }
            (_, false) => Some(rows),
        };
        let mut compared: Vec<(StatedCount, usize)> =
            self.counts.iter().filter_map(|count| Some((*count, found(count)?))).collect();
        if let (false, Some(stated), Some(last)) = (is_map, product, self.counts.last()) {
            compared.push((StatedCount { key: Key::Points, stated, line: last.line }, rows));
        }
        let mut notes = Vec::new();
        for (StatedCount { key, stated, line }, found) in compared {
            let what = match key {
                Key::Count(0) => "columns",
                Key::Count(_) => "rows",
                _ => "points",
            };
            if found < stated {
                return Err(FORMAT.bad(
                    FilePlace::Line(line),
                    format!("the number of {what} in the file"),
                    found.to_string(),
                    format!("{stated}, as stated here"),
                    "the file is cut off: export it again, or correct the header",
                ));
            }
            if found > stated {
                notes.push(format!("line {line} states {stated} {what}, the file holds {found}"));
            }
        }
        Ok(notes)
    }

    fn stated(&self, key: Key) -> Option<usize> {
        self.counts.iter().find(|count| count.key == key).map(|count| count.stated)
    }

    /// The stated sizes in m beside the places of the points; a matrix has its places from its size.
    pub(crate) fn stated_m(&self, is_matrix: bool) -> [Option<f64>; 2] {
        [0, 1].map(|axis| {
            let size = self.tabled_sizes[axis].or(self.sizes[axis].filter(|_| !is_matrix))?;
            Some(size.unit.or(self.lateral_unit)?.to_m(size.value))
        })
    }

    /// The size of so many columns and rows, or of a line of so many columns.
    pub(crate) fn size(
        &self,
        columns: usize,
        rows: usize,
        units: &Units,
    ) -> Result<Option<ScanSize>, ScanReadError> {
        let axis = |axis: usize, points: usize| {
            let of_spacing = |length: Length| Length { value: length.value * points as f64, ..length };
            // A height beside a distance of points and no width is none of a map, and a bare one counts rows.
            let is_bare = |size: Option<Length>| size.is_none_or(|size| size.unit.is_none());
            if axis == 1 && self.spacings[0].is_some() && (self.sizes[0].is_none() || is_bare(self.sizes[1]))
            {
                return self.spacings[1].map(of_spacing);
            }
            // Beside a distance of points a bare size may count them.
            let spaced = self.spacings[axis].map(of_spacing);
            let size = self.sizes[axis].filter(|size| size.unit.is_some() || spaced.is_none());
            size.or(spaced)
        };
        // A bare size may count pixels unless the header gives the lateral unit; a spacing does not.
        let is_sure = |axis: usize, length: &Length| {
            length.unit.is_some() || self.lateral_unit.is_some() || self.spacings[axis].is_some()
        };
        let to_m = |length: Length| -> Result<f64, ScanReadError> {
            match length.unit {
                Some(unit) => Ok(unit.to_m(length.value)),
                None => Ok(units.length_to_m(FORMAT)?(length.value)),
            }
        };
        let Some(x) = axis(0, columns).filter(|length| is_sure(0, length)) else { return Ok(None) };
        let y = if rows == 0 { None } else { axis(1, rows).filter(|length| is_sure(1, length)) };
        Ok(Some(ScanSize { x_m: to_m(x)?, y_m: y.map(to_m).transpose()? }))
    }
}

fn second_channel(line: usize) -> ScanReadError {
    let mend = "export each channel to a file of its own";
    FORMAT.unsupported(FilePlace::Line(line), "a second channel in one file", mend)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn header(text: &str) -> Result<Header, ScanReadError> {
        let body = Body::find(text).ok_or(ScanReadError::NoRows)?;
        Header::read(&body, &Columns::read(&body)?)
    }

    #[test]
    fn units_of_columns_stand_in_their_names() {
        let units = |text: &str| {
            let heads = header(text).unwrap().heads;
            (0..3).map_while(|column| heads.of(column)).map(|head| head.unit).collect::<Vec<_>>()
        };
        let (um, nm, mm) = (LengthUnit::MICROMETRE, LengthUnit::NANOMETRE, LengthUnit::MILLIMETRE);
        assert_eq!(units("# x (um)  h [nm]\n1 2"), [Some(um), Some(nm)]);
        assert_eq!(units("X;Y;valid\n[mm];[mm];[1/0]\n1;2;1"), [Some(mm), Some(mm), None]);
        assert_eq!(units("Lateral um,Raw Micrometer,\n1.0,2.0,"), [Some(um), Some(um)]);
        assert_eq!(units("x_mm\th/nm\n1\t2"), [Some(mm), Some(nm)]);
        assert_eq!(units("mm\tum\n1\t2"), [Some(mm), Some(um)]);
        assert!(units("mm\tA\n1\t2").iter().all(Option::is_none));
        assert!(units("Scan of sample A\n1 2").iter().all(Option::is_none));
        assert_eq!(units("X_(microns),y1\n0.5,2.5"), [Some(um), None]);
        assert_eq!(units("x[microns]\ty1\n0.5\t2.5"), [Some(um), None]);
    }

    #[test]
    fn numbers_of_points_are_those_of_the_header() {
        let checked = |text: &str, is_map| {
            let body = Body::find(text).unwrap();
            let columns = Columns::read(&body).unwrap();
            Header::read(&body, &columns).unwrap().check_counts(&columns, is_map)
        };
        let map = |header: &str| checked(&format!("{header}\n1 2 3 4\n5 6 7 8"), true);
        for header in [
            "# Columns: 4\n# Rows: 2",
            "# Points: 8",
            "# points = 4",
            "# Number of points: 2",
            "# rows: many",
        ] {
            assert_eq!(map(header).unwrap(), [""; 0], "{header}");
        }
        for (header, stated_in) in [("# Rows: 3", 1), ("# a\n# nx=5", 2), ("# Points: 12", 1)] {
            match map(header).unwrap_err() {
                ScanReadError::BadField { place: FilePlace::Line(line), .. } => assert_eq!(line, stated_in),
                other => panic!("{other}"),
            }
        }
        assert_eq!(map("# Rows: 1").unwrap().len(), 1);
        assert!(
            checked("Points: 3\n0 1\n1 2", false).is_err() && checked("Points: 2\n0 1\n1 2", false).is_ok()
        );
        assert!(checked("X Pixels: 2\nY Pixels: 2\n0 0 1\n1 0 2\n0 1 3", false).is_err());
        assert!(checked(&format!("nx={0}\nny={0}\n0 0 1\n1 0 2", usize::MAX), false).is_err());
    }

    #[test]
    fn exports_in_any_language_are_told_by_the_order_of_their_lines() {
        let size = |header: &Header| header.sizes.map(|size| size.map(|size| size.value));
        // Swahili, to which Gwyddion was not translated when this was written.
        let found = header("# Kituo: Juu\n# Upana: 5,00 µm\n# Urefu: 2.5 µm\n# Vipimo: nm\n1 2 3 4\n1 2 3 4")
            .unwrap();
        assert_eq!((found.channel.as_deref(), size(&found)), (Some("Juu"), [Some(5.0), Some(2.5)]));
        assert_eq!(found.value_unit, Some(LengthUnit::NANOMETRE));
        for text in [
            "# a: b\n# c: 5 µm\n# d: 5\n# e: nm\n1 2 3 4\n1 2 3 4",
            "# a: b\n# c: 5 µm\n# d: 5 µm\n# e: 12 points\n1 2 3 4\n1 2 3 4",
            "# a: b\n# c: 5 µm\n# d: 5 µm\n1 2 3 4\n1 2 3 4",
            "# a: b\n\n# c: 5 µm\n# d: 5 µm\n# e: nm\n1 2 3 4\n1 2 3 4",
        ] {
            assert_eq!(size(&header(text).unwrap()), [None; 2], "{text}");
        }
        let phase = header("# Kituo: Awamu\n# Upana: 5 µm\n# Urefu: 5 µm\n# Vipimo: deg\n1 2 3 4\n1 2 3 4");
        assert!(phase.err().unwrap().to_string().starts_with("reading text, line 4: the unit is 'deg'"));
    }

    #[test]
    fn what_is_no_length_is_refused_with_its_line() {
        let message = |text: &str| header(text).err().map(|error| error.to_string()).unwrap_or_default();
        assert_eq!(
            message("# Channel: Phase\n# Value units: deg\n1 2"),
            "reading text, line 2: the unit is 'deg', it must be one of m, cm, mm, µm, nm, Å, kÅ, pm, km, inch, uin, mil; export a channel of \
             heights, or correct the header"
        );
        assert_eq!(
            message("# Width: 0 nm\n1 2"),
            "reading text, line 1: the length is '0 nm', it must be finite and above 0; export a channel of heights, \
             or correct the header"
        );
        assert!(message("1 2\n# Channel: B\n1 2").starts_with("reading text, line 2: a second channel"));
    }
}
