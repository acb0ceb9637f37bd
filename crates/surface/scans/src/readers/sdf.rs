//! Surface data files, `.sdf`, in text and binary, as ISO 25178-71 lays them down, with their predecessor BCR-1.0 and
//! the wider counts of version 2.0. Lengths are in m.

use crate::channel::{Channel, Lateral, Quantity, Samples};
use crate::cursor::{ByteOrder, Cursor, latin1};
use crate::error::{FilePlace, ScanReadError};
use crate::format::ScanFormat;
use crate::numbers;
use crate::options::ScanOptions;
use crate::raster::{Decoded, MissingMark, NumberType, Raster};
use crate::readers::Reader;

const FORMAT: ScanFormat = ScanFormat::Sdf;
const VERSIONS: [&[u8]; 4] = [b"ISO-1.0", b"ISO-2.0", b"BCR-1.0", b"BCR-0.0"];
const VERSION_BYTES: usize = 8;
/// Lines of a header in text that are looked at; it has some dozen.
const MOST_LINES: usize = 1000;
/// Separator that some exports put between the header and the data of files of version 1.0.
const EXTRA_HEADER_BYTES: usize = 8;

pub(super) const READER: Reader = Reader { format: FORMAT, recognises, channels };

fn recognises(bytes: &[u8]) -> bool {
    bytes.split_first().is_some_and(|(kind, rest)| {
        b"ab".contains(kind) && VERSIONS.iter().any(|version| rest.starts_with(version))
    })
}

/// Fields of the header.
struct Header {
    points: usize,
    profiles: usize,
    spacing_x_m: f64,
    spacing_y_m: f64,
    height_scale_m: f64,
    compression: i64,
    data_type: i64,
    check_type: i64,
}

fn channels<'b>(bytes: &'b [u8], _: &ScanOptions) -> Result<Vec<Channel<'b>>, ScanReadError> {
    if bytes.starts_with(b"a") { text(bytes) } else { binary(bytes) }
}

fn binary(bytes: &[u8]) -> Result<Vec<Channel<'_>>, ScanReadError> {
    let is_wide = bytes.get(..VERSION_BYTES) == Some(b"bISO-2.0");
    let mut cursor = Cursor::new(FORMAT, bytes, ByteOrder::Little).at(VERSION_BYTES);
    cursor.skip(10 + 12 + 12, "the maker and the dates")?;
    let mut count = |what: &str| {
        let offset = cursor.at;
        let count = if is_wide { cursor.u32(what)? } else { u32::from(cursor.u16(what)?) };
        let found = usize::try_from(count).ok().filter(|&count| count > 0);
        found.ok_or_else(|| cursor.bad(offset, what, count, "a whole number above 0"))
    };
    let (points, profiles) = (count("NumPoints")?, count("NumProfiles")?);
    let header = Header {
        points,
        profiles,
        spacing_x_m: cursor.f64("Xscale")?,
        spacing_y_m: cursor.f64("Yscale")?,
        height_scale_m: cursor.f64("Zscale")?,
        compression: {
            cursor.skip(8, "Zresolution")?;
            cursor.u8("Compression")?.into()
        },
        data_type: cursor.u8("DataType")?.into(),
        check_type: cursor.u8("CheckType")?.into(),
    };
    let number = header.number(FilePlace::Byte(cursor.at as u64 - 2))?;
    let size = points.saturating_mul(profiles).saturating_mul(number.bytes());
    let has_extra =
        bytes.starts_with(b"bISO-1.0") && cursor.rest().len() == size.saturating_add(EXTRA_HEADER_BYTES);
    let offset = cursor.at + if has_extra { EXTRA_HEADER_BYTES } else { 0 };
    let raster = Raster {
        scale: header.height_scale_m,
        missing: header.missing(number, is_wide),
        ..Raster::within(number, points, profiles, bytes, offset)
    };
    let trailer = bytes.get(offset.saturating_add(size)..).unwrap_or_default();
    header.channel(Samples::Raster(raster), free_text(trailer))
}

/// Three parts with an asterisk behind each: the header, the heights, and what the maker adds.
fn text(bytes: &[u8]) -> Result<Vec<Channel<'_>>, ScanReadError> {
    let text: String = bytes.iter().map(|&byte| char::from(byte)).collect();
    let mut parts = text.splitn(3, '*');
    let (head, data) = (parts.next().unwrap_or_default(), parts.next().unwrap_or_default());
    let trailer = parts.next();
    // Without the asterisk, a number in the last place may have lost digits.
    if trailer.is_none() && !data.ends_with(char::is_whitespace) {
        let last = data.split_whitespace().last().unwrap_or_default();
        return Err(bad(FilePlace::Line(text.lines().count()), "the last height", last, "followed by '*'"));
    }
    let trailer = trailer.unwrap_or_default().trim_end_matches(['*', '\r', '\n', ' ']);
    let mut fields = Fields::default();
    for (index, line) in head.lines().enumerate().take(MOST_LINES).filter(|(_, line)| !line.starts_with(';'))
    {
        if let Some((name, value)) = line.split_once('=') {
            fields.0.push((index + 1, name.trim(), value.trim()));
        }
    }
    let header = Header {
        points: fields.count("NumPoints")?,
        profiles: fields.count("NumProfiles")?,
        spacing_x_m: fields.number("Xscale")?,
        spacing_y_m: fields.number("Yscale")?,
        height_scale_m: fields.number("Zscale")?,
        compression: fields.number("Compression")? as i64,
        data_type: fields.number("DataType")? as i64,
        check_type: fields.number("CheckType")? as i64,
    };
    let number = header.number(FilePlace::Line(fields.line("DataType")))?;
    let missing = header.missing(number, head.starts_with("aISO-2.0"));
    let mut decoded = Decoded::default();
    let first_line = head.matches('\n').count() + 1;
    for (index, line) in data.lines().enumerate().filter(|(_, line)| !line.starts_with(';')) {
        for word in line.split_whitespace() {
            let value = if word.eq_ignore_ascii_case("bad") { Some(f64::NAN) } else { word.parse().ok() };
            let value = value.ok_or_else(|| {
                bad(FilePlace::Line(first_line + index), "a height", word, "a number or BAD")
            })?;
            let is_missing = matches!(missing, MissingMark::Equal(mark) if value == mark);
            decoded.push((!is_missing).then_some(value * header.height_scale_m));
        }
    }
    let expected = header.points.checked_mul(header.profiles);
    if Some(decoded.values.len()) != expected {
        let bound = format!("{} x {}, NumPoints and NumProfiles", header.points, header.profiles);
        let found = decoded.values.len().to_string();
        return Err(bad(FilePlace::Line(first_line), "the number of heights", &found, &bound));
    }
    let samples = Samples::Decoded { columns: header.points, decoded };
    header.channel(samples, trailer.trim().to_owned())
}

/// The lines of the header of a text.
#[derive(Default)]
struct Fields<'t>(Vec<(usize, &'t str, &'t str)>);

impl Fields<'_> {
    fn get(&self, name: &str) -> Result<(usize, &str), ScanReadError> {
        let found = self.0.iter().find(|(_, found, _)| found.eq_ignore_ascii_case(name));
        found.map(|&(line, _, value)| (line, value)).ok_or_else(|| {
            FORMAT.missing(FilePlace::File, format!("line '{name}' in the header"), "export the file again")
        })
    }

    fn line(&self, name: &str) -> usize {
        self.get(name).map_or(0, |(line, _)| line)
    }

    fn number(&self, name: &str) -> Result<f64, ScanReadError> {
        let (line, value) = self.get(name)?;
        numbers::finite(value).ok_or_else(|| bad(FilePlace::Line(line), name, value, "a finite number"))
    }

    fn count(&self, name: &str) -> Result<usize, ScanReadError> {
        let (line, value) = self.get(name)?;
        numbers::count(value).ok_or_else(|| bad(FilePlace::Line(line), name, value, "a whole number above 0"))
    }
}

impl Header {
    fn number(&self, place: FilePlace) -> Result<NumberType, ScanReadError> {
        if self.compression != 0 {
            let mend = "export it without compression";
            return Err(FORMAT.unsupported(place, format!("compression {}", self.compression), mend));
        }
        Ok(match self.data_type {
            0 => NumberType::U8,
            1 => NumberType::U16,
            2 => NumberType::U32,
            3 => NumberType::F32,
            4 => NumberType::I8,
            5 => NumberType::I16,
            6 => NumberType::I32,
            7 => NumberType::F64,
            other => return Err(bad(place, "DataType", other, "from 0 to 7")),
        })
    }

    /// The number that stands for none: the lowest of its type, of an unsigned one the highest; bytes have none before
    /// version 2.0.
    fn missing(&self, number: NumberType, is_second_version: bool) -> MissingMark<'static> {
        MissingMark::Equal(match number {
            NumberType::U16 => f64::from(u16::MAX),
            NumberType::U32 => f64::from(u32::MAX),
            NumberType::I8 if is_second_version => f64::from(i8::MIN),
            NumberType::I16 => f64::from(i16::MIN),
            NumberType::I32 => f64::from(i32::MIN),
            NumberType::F32 => f64::from(f32::MIN),
            NumberType::F64 => f64::MIN,
            _ => return MissingMark::None,
        })
    }

    fn channel<'b>(
        &self,
        samples: Samples<'b>,
        free_text: String,
    ) -> Result<Vec<Channel<'b>>, ScanReadError> {
        let y_m = (self.profiles > 1).then_some(self.spacing_y_m);
        let lateral = Lateral::Spacing { x_m: self.spacing_x_m, y_m };
        let mut channel = Channel::new(None, Quantity::HEIGHTS_IN_M, lateral, samples);
        channel.free_text = free_text;
        if self.check_type != 0 {
            channel
                .notes
                .push(format!("the check sum of the file, of type {}, is not verified", self.check_type));
        }
        Ok(vec![channel])
    }
}

fn free_text(trailer: &[u8]) -> String {
    let is_text = trailer.iter().all(|&byte| byte >= b' ' || b"\t\r\n\0".contains(&byte));
    if is_text { latin1(trailer) } else { String::new() }
}

fn bad(place: FilePlace, field: &str, value: impl ToString, bound: &str) -> ScanReadError {
    let value: String = value.to_string().chars().take(60).collect();
    FORMAT.bad(place, field, value, bound, "export the file again")
}
