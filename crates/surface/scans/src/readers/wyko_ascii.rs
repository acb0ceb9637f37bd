//! Wyko's and Vision's exports of text, `.asc`: blocks of a name, a type, a length and a value, then arrays.
//!
//! Heights are in nm where the second flag of the first line is 1, else in wavelengths over `Mult`; the distance of
//! points, in mm, is `Pixel_size` along the instrument's x, across the lines, and `Aspect` times as much along them. So
//! Gwyddion and SurfaceTopography take them; the lines of the file are the rows here.

use crate::channel::{Channel, Lateral, Quantity, Samples, refuse_many};
use crate::error::{FilePlace, ScanReadError, quoted};
use crate::metadata::Probe;
use crate::numbers;
use crate::options::ScanOptions;
use crate::raster::Decoded;
use crate::readers::Reader;
use crate::readers::text::decode;
use crate::readers::wyko::{FORMAT, HEIGHTS};
use units::LengthUnit;

const MAGIC: &str = "Wyko ASCII Data File Format";
/// The mark of points without a height.
const BAD: &str = "Bad";
const MEND: &str = "export the file again";

pub(super) const READER: Reader = Reader { format: FORMAT, recognises, channels };

fn recognises(bytes: &[u8]) -> bool {
    bytes.starts_with(MAGIC.as_bytes())
}

/// The channels: every block that lines of numbers follow.
fn channels<'b>(bytes: &'b [u8], _: &ScanOptions) -> Result<Vec<Channel<'b>>, ScanReadError> {
    let text = decode(bytes)?;
    let mut lines = text.lines().enumerate().map(|(index, line)| (index + 1, line.trim_end())).peekable();
    let mut facts = Facts::of_first_line(lines.next().map_or("", |(_, line)| line));
    let mut channels = Vec::new();
    while let Some((line, fields)) = lines.next() {
        let mut cells = fields.split('\t').map(str::trim);
        let (name, last) = (cells.next().unwrap_or_default(), cells.next_back().unwrap_or_default());
        if lines.peek().is_none_or(|(_, next)| !is_of_numbers(next)) {
            facts.take(name, last);
            continue;
        }
        let (columns, rows) = facts.points(line)?;
        let mut values = Decoded::default();
        for _ in 0..rows {
            let row = lines.next_if(|(_, row)| is_of_numbers(row));
            take_row(&mut values, row, columns, rows)?;
        }
        refuse_many(FORMAT, channels.len() + 1)?;
        let (quantity, factor) = match HEIGHTS.contains(&name) {
            true => (Quantity::Heights(Some(LengthUnit::NANOMETRE)), facts.unit_nm()?),
            false => (Quantity::Other(String::new()), 1.0),
        };
        values.values.iter_mut().for_each(|value| *value *= factor);
        let samples = Samples::Decoded { columns, decoded: values };
        channels.push(Channel {
            probe: Some(Probe::Microscope),
            free_text: facts.title.clone(),
            ..Channel::new(Some(name.to_owned()), quantity, facts.lateral(), samples)
        });
    }
    Ok(channels)
}

fn is_of_numbers(line: &str) -> bool {
    let first = line.split_whitespace().next();
    first.is_some_and(|field| field.eq_ignore_ascii_case(BAD) || field.parse::<f64>().is_ok())
}

/// Takes the numbers of a line, as many as there are columns.
fn take_row(
    values: &mut Decoded,
    row: Option<(usize, &str)>,
    columns: usize,
    rows: usize,
) -> Result<(), ScanReadError> {
    let cut_off = |place, found: usize| {
        let bound = format!("{columns} in each of {rows} lines, by X Size and Y Size");
        FORMAT.bad(place, "the number of heights", found, bound, MEND)
    };
    let (line, row) = row.ok_or_else(|| cut_off(FilePlace::File, values.values.len()))?;
    let before = values.values.len();
    for (column, field) in row.split_whitespace().enumerate() {
        match field.parse::<f64>() {
            Ok(value) => values.push(Some(value)),
            Err(_) if field.eq_ignore_ascii_case(BAD) => values.push(None),
            Err(_) => {
                return Err(ScanReadError::NotANumber { line, column: column + 1, text: quoted(field) });
            }
        }
    }
    let found = values.values.len() - before;
    if found == columns { Ok(()) } else { Err(cut_off(FilePlace::Line(line), found)) }
}

/// The facts of the blocks above an array.
#[derive(Default)]
struct Facts {
    is_in_nm: bool,
    x_size: Option<usize>,
    y_size: Option<usize>,
    wavelength_nm: Option<f64>,
    mult: Option<f64>,
    pixel_mm: Option<f64>,
    aspect: Option<f64>,
    title: String,
}

impl Facts {
    /// The facts of the first line: its second flag.
    fn of_first_line(line: &str) -> Self {
        let is_in_nm = line.split_whitespace().rev().nth(1) == Some("1");
        Self { is_in_nm, ..Self::default() }
    }

    fn take(&mut self, name: &str, value: &str) {
        let number = || numbers::finite(value).and_then(numbers::positive);
        match name {
            "X Size" => self.x_size = numbers::count(value),
            "Y Size" => self.y_size = numbers::count(value),
            "Wavelength" => self.wavelength_nm = number(),
            "Mult" => self.mult = number(),
            "Pixel_size" => self.pixel_mm = number(),
            "Aspect" => self.aspect = number(),
            "Title" => value.clone_into(&mut self.title),
            _ => {}
        }
    }

    /// Numbers of columns and rows of an array at a line.
    fn points(&self, line: usize) -> Result<(usize, usize), ScanReadError> {
        let of = |size: Option<usize>, name: &str| {
            size.ok_or_else(|| FORMAT.missing(FilePlace::Line(line), format!("{name} above the array"), MEND))
        };
        Ok((of(self.y_size, "Y Size")?, of(self.x_size, "X Size")?))
    }

    /// The unit of heights in nm.
    fn unit_nm(&self) -> Result<f64, ScanReadError> {
        if self.is_in_nm {
            return Ok(1.0);
        }
        let missing = || FORMAT.missing(FilePlace::File, "Wavelength, which scales the heights", MEND);
        Ok(self.wavelength_nm.ok_or_else(missing)? / self.mult.unwrap_or(1.0))
    }

    fn lateral(&self) -> Lateral {
        self.pixel_mm.map_or(Lateral::Unknown, |pixel_mm| {
            let y_m = LengthUnit::MILLIMETRE.to_m(pixel_mm);
            Lateral::Spacing { x_m: y_m * self.aspect.unwrap_or(1.0), y_m: Some(y_m) }
        })
    }
}
