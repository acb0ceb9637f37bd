//! MarWin of Mahr, which drives styli that trace contours: `.qep`.
//!
//! A ZIP file with profiles: a header, a table of texts `>key=value`, then the positions and heights of all points in
//! mm, little-endian, as the reader of SurfaceTopography takes them.

use super::measured_line::MeasuredLine;
use crate::archive::{Archive, is_named_in, is_zip};
use crate::channel::{Channel, Quantity};
use crate::cursor::{ByteOrder, Cursor, latin1};
use crate::error::{FilePlace, ScanReadError};
use crate::format::ScanFormat;
use crate::metadata::Probe;
use crate::numbers;
use crate::options::ScanOptions;
use crate::raster::{Decoded, NumberType, Raster};
use crate::readers::Reader;
use units::LengthUnit;

const FORMAT: ScanFormat = ScanFormat::MarWin;
/// Files of the archive with profiles, the measured one first, and the names of their channels.
const PROFILES: [(&str, &str); 2] =
    [("Kontur1.prf", "measured"), ("qe_contour_reference_profil_001.tmp", "reference")];
const MAGIC: &[u8] = b"[p3dlin]";
const POINTS: usize = 0x14;
const TEXTS: usize = 0xc4;
/// Files have some hundreds.
const MOST_TEXTS: u32 = 100_000;
/// The points stand so many bytes behind the beginning of the second of these marks.
const MARKS: [&[u8]; 2] = [b"[sellsg]", b"[Trajec]"];
const MARK_TO_POINTS: usize = 49;

pub(super) const READER: Reader = Reader { format: FORMAT, recognises, channels };

fn recognises(bytes: &[u8]) -> bool {
    is_zip(bytes) && PROFILES.iter().any(|(file, _)| is_named_in(bytes, file))
}

fn channels<'b>(bytes: &'b [u8], options: &ScanOptions) -> Result<Vec<Channel<'b>>, ScanReadError> {
    let mut archive = Archive::open(bytes, options.unpacked_bound())?;
    let mut channels = Vec::new();
    for (file, name) in PROFILES {
        if archive.paths().any(|path| path == file) {
            let profile = Profile::read(&archive.read(file)?)?;
            channels.push(profile.channel(name));
        }
    }
    Ok(channels)
}

/// A profile with the stylus that its texts describe.
struct Profile {
    positions_m: Vec<f64>,
    heights_m: Vec<Option<f64>>,
    tip_radius_m: Option<f64>,
    comment: String,
}

impl Profile {
    fn read(file: &[u8]) -> Result<Self, ScanReadError> {
        let cursor = Cursor::new(FORMAT, file, ByteOrder::Little);
        if !file.starts_with(MAGIC) {
            let found = format!("'{}'", file.get(..8).unwrap_or(file).escape_ascii());
            return Err(cursor.bad(0, "the beginning of a profile", &found, "'[p3dlin]'"));
        }
        let points = cursor.at(POINTS).count("the number of points")?;
        let mut cursor = cursor.at(TEXTS);
        let count_offset = cursor.at;
        let count = cursor.u32("the number of texts")?;
        if count > MOST_TEXTS {
            let bound = format!("at most {MOST_TEXTS}");
            return Err(cursor.bad(count_offset, "the number of texts", count, &bound));
        }
        let mut texts = Vec::new();
        for _ in 0..count {
            let length = cursor.u32("the length of a text")? as usize;
            texts.push(latin1(cursor.take(length, "a text")?));
        }
        let get = |key: &str| {
            let value = |text: &String| {
                text.strip_prefix('>')?.strip_prefix(key)?.strip_prefix('=').map(str::to_owned)
            };
            texts.iter().find_map(value)
        };
        let start = points_start(file, cursor.at)?;
        let mut numbers = Numbers { file, points, offset: start };
        let positions = numbers.next(NumberType::F64)?;
        if let Some(point) = positions.missing.indices().next() {
            let (field, bound) = ("a position", "a finite number");
            return Err(cursor.bad(start, field, format!("no number at point {}", point + 1), bound));
        }
        // Across the profile, where nothing changes.
        numbers.next(NumberType::F64)?;
        let heights = numbers.next(NumberType::F64)?;
        let flags = numbers.next(NumberType::F32)?;
        let is_measured = |point: usize, flag: f64| flag == 0.0 && !heights.missing.contains(point);
        let in_m = |millimetres: f64| LengthUnit::MILLIMETRE.to_m(millimetres);
        let height_m =
            |(point, (&height, &flag)): (usize, (&f64, &f64))| is_measured(point, flag).then(|| in_m(height));
        let heights_m = heights.values.iter().zip(&flags.values).enumerate().map(height_m).collect();
        let radius = get("ProbeRadius").and_then(|radius| radius.trim().parse().ok());
        let radius_m = radius.map(in_m);
        Ok(Self {
            positions_m: positions.values.into_iter().map(in_m).collect(),
            heights_m,
            tip_radius_m: radius_m.and_then(numbers::positive),
            comment: get("Comment").unwrap_or_default(),
        })
    }

    fn channel<'b>(self, name: &str) -> Channel<'b> {
        let MeasuredLine { lateral, samples, notes } = MeasuredLine::new(self.positions_m, self.heights_m);
        Channel {
            probe: Some(Probe::Tip),
            tip_radius_m: self.tip_radius_m,
            free_text: self.comment,
            notes,
            ..Channel::new(Some(name.to_owned()), Quantity::HEIGHTS_IN_M, lateral, samples)
        }
    }
}

/// The points follow two marks, which stand at distances that differ between versions.
fn points_start(file: &[u8], texts_end: usize) -> Result<usize, ScanReadError> {
    let mut at = texts_end;
    for mark in MARKS {
        let rest = file.get(at..).unwrap_or_default();
        let found = rest.windows(mark.len()).position(|part| part == mark);
        at += found.ok_or_else(|| {
            let mend = "the file is damaged or of a variant that is not known: export it again";
            FORMAT.missing(FilePlace::Byte(at as u64), format!("section '{}'", mark.escape_ascii()), mend)
        })?;
    }
    Ok(at.saturating_add(MARK_TO_POINTS))
}

/// Arrays with a number for each point, one after the other.
struct Numbers<'b> {
    file: &'b [u8],
    points: usize,
    offset: usize,
}

impl Numbers<'_> {
    fn next(&mut self, number: NumberType) -> Result<Decoded, ScanReadError> {
        let array = Raster::within(number, self.points, 1, self.file, self.offset).decode(FORMAT)?;
        self.offset = self.offset.saturating_add(self.points.saturating_mul(number.bytes()));
        Ok(array)
    }
}
