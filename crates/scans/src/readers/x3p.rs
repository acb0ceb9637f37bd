//! X3P, the XML and binary data in a ZIP file of ISO 25178-72 (earlier ISO 5436-2). Lengths are in m.

use roxmltree::{Document, Node, ParsingOptions};

use crate::archive::{Archive, is_named_in, is_zip, leads_outside};
use crate::channel::{Channel, Lateral, Quantity, Samples};
use crate::error::{Place, ScanReadError};
use crate::format::ScanFormat;
use crate::metadata::Probe;
use crate::options::ScanOptions;
use crate::raster::Decoded;
use crate::readers::Reader;
use units::LengthUnit;

const FORMAT: ScanFormat = ScanFormat::X3p;
const INDEX: &str = "main.xml";
/// Files that are not made to be read have more.
const MOST_NODES: u32 = 100_000;
const LARGEST_INDEX: u64 = 16 << 20;

/// The type of a number, little-endian.
#[derive(Clone, Copy)]
enum Kind {
    I16,
    I32,
    F32,
    F64,
}

/// What `main.xml` says.
struct Description {
    is_map: bool,
    columns: usize,
    rows: usize,
    /// None where every point has its position in the data.
    spacing_x_m: Option<f64>,
    spacing_y_m: f64,
    x: Coordinate,
    z: Coordinate,
    data: String,
    valid: Option<String>,
    probe: Option<Probe>,
}

/// How raw numbers become lengths in m.
#[derive(Clone, Copy)]
struct Coordinate {
    kind: Kind,
    increment: f64,
    offset: f64,
}

pub(super) const READER: Reader = Reader { format: FORMAT, recognises, channels };

fn recognises(bytes: &[u8]) -> bool {
    is_zip(bytes) && is_named_in(bytes, INDEX)
}

/// The one channel of a file, which has no name.
fn channels<'b>(bytes: &'b [u8], options: &ScanOptions) -> Result<Vec<Channel<'b>>, ScanReadError> {
    let mut archive = Archive::open(bytes, options.unpacked_bound())?;
    let index = archive.read_at_most(INDEX, LARGEST_INDEX)?;
    let description = describe(&index)?;
    let (positions_m, decoded) = description.values(&mut archive)?;
    let lateral = match description.spacing_x_m {
        None => Lateral::Positions(positions_m),
        Some(x_m) => Lateral::Spacing { x_m, y_m: description.is_map.then_some(description.spacing_y_m) },
    };
    let quantity = Quantity::Heights(Some(LengthUnit::METRE));
    let samples = Samples::Decoded { columns: description.columns, decoded };
    Ok(vec![Channel { probe: description.probe, ..Channel::new(None, quantity, lateral, samples) }])
}

fn describe(index: &[u8]) -> Result<Description, ScanReadError> {
    let syntax = |problem: String| ScanReadError::Syntax { file: INDEX.to_owned(), problem };
    let text = std::str::from_utf8(index).map_err(|error| syntax(format!("no UTF-8: {error}")))?;
    let text = text.trim_start_matches('\u{feff}');
    let options = ParsingOptions { nodes_limit: MOST_NODES, ..ParsingOptions::default() };
    let document = Document::parse_with_options(text, options).map_err(|error| syntax(error.to_string()))?;
    let root = Element { node: document.root_element(), path: String::new() };
    let axes = root.child("Record1")?.child("Axes")?;
    let feature = root.child("Record1")?.child("FeatureType")?;
    let is_map = match feature.text() {
        "SUR" => true,
        "PRF" => false,
        other => {
            return Err(ScanReadError::Unsupported {
                format: FORMAT,
                place: Place::Element(feature.path),
                found: format!("the feature type '{other}'"),
                mend: "export a surface (SUR) or a profile (PRF)",
            });
        }
    };
    let (x, z) = (axes.child("CX")?, axes.child("CZ")?);
    let is_absolute_x = x.one_of("AxisType", &["I", "A"])? == "A";
    if is_map && is_absolute_x {
        return Err(x
            .child("AxisType")?
            .bad("I (even spacing) for a surface", "export it on a regular grid"));
    }
    if is_map || axes.child("CY").is_ok() {
        axes.child("CY")?.one_of("AxisType", &["I"])?;
    }
    z.one_of("AxisType", &["A"])?;
    let matrix = root.child("Record3")?.child("MatrixDimension")?;
    let depth = matrix.child("SizeZ")?;
    if depth.text() != "1" {
        return Err(depth.bad("1", "export one layer"));
    }
    let (columns, rows) = (matrix.child("SizeX")?.count()?, matrix.child("SizeY")?.count()?);
    if !is_map && rows != 1 {
        return Err(matrix.child("SizeY")?.bad("1 for a profile", "export one profile"));
    }
    let link = root.child("Record3")?.child("DataLink").map_err(|_| ScanReadError::MissingField {
        format: FORMAT,
        place: Place::Element("Record3".to_owned()),
        field: "element 'DataLink'".to_owned(),
        mend: "lists of values in the XML are not read: export with binary data",
    })?;
    Ok(Description {
        is_map,
        columns,
        rows,
        spacing_x_m: if is_absolute_x { None } else { Some(x.child("Increment")?.positive()?) },
        spacing_y_m: if is_map { axes.child("CY")?.child("Increment")?.positive()? } else { 1.0 },
        x: x.coordinate(is_absolute_x)?,
        z: z.coordinate(true)?,
        data: link.child("PointDataLink")?.path_inside()?,
        valid: link
            .child("ValidPointsLink")
            .ok()
            .filter(|link| !link.text().is_empty())
            .map(|l| l.path_inside())
            .transpose()?,
        probe: probe(&root),
    })
}

/// What the surface was felt with; none where the file does not say, or says that it was computed.
fn probe(root: &Element) -> Option<Probe> {
    match root.child("Record2").ok()?.child("ProbingSystem").ok()?.child("Type").ok()?.text() {
        "Contacting" => Some(Probe::Tip),
        "NonContacting" => Some(Probe::Microscope),
        _ => None,
    }
}

impl Description {
    /// Positions in m, none for even spacing, and heights in m, row after row.
    fn values(&self, archive: &mut Archive) -> Result<(Vec<f64>, Decoded), ScanReadError> {
        let points = self.columns.checked_mul(self.rows);
        let x_size = if self.spacing_x_m.is_some() { 0 } else { self.x.kind.size() };
        let size = x_size + self.z.kind.size();
        let data = archive.read(&self.data)?;
        let needed = points.and_then(|points| points.checked_mul(size));
        let data = needed.and_then(|needed| data.get(..needed)).ok_or_else(|| {
            truncated(
                format!("{} x {} points in '{}'", self.columns, self.rows, self.data),
                needed,
                data.len(),
            )
        })?;
        let positions_m = match x_size {
            0 => Vec::new(),
            _ => data.chunks_exact(size).map(|point| self.x.length_m(&point[..x_size])).collect(),
        };
        let valid = self.valid.as_ref().map(|path| archive.read(path)).transpose()?;
        let needed = (data.len() / size).div_ceil(8);
        if let (Some(bits), Some(path)) = (&valid, &self.valid)
            && bits.len() < needed
        {
            return Err(truncated(format!("a bit for each point in '{path}'"), Some(needed), bits.len()));
        }
        let is_valid =
            |index: usize| valid.as_ref().is_none_or(|bits| bits[index / 8] >> (index % 8) & 1 == 1);
        let height_m =
            |(index, point): (usize, &[u8])| is_valid(index).then(|| self.z.length_m(&point[x_size..]));
        Ok((positions_m, data.chunks_exact(size).enumerate().map(height_m).collect()))
    }
}

fn truncated(what: String, needed: Option<usize>, available: usize) -> ScanReadError {
    let needed = needed.map_or(u64::MAX, |needed| needed as u64);
    ScanReadError::Truncated { format: FORMAT, offset: 0, what, needed, available: available as u64 }
}

impl Coordinate {
    fn length_m(self, raw: &[u8]) -> f64 {
        let raw = match (self.kind, raw) {
            (Kind::I16, &[a, b]) => f64::from(i16::from_le_bytes([a, b])),
            (Kind::I32, &[a, b, c, d]) => f64::from(i32::from_le_bytes([a, b, c, d])),
            (Kind::F32, &[a, b, c, d]) => f64::from(f32::from_le_bytes([a, b, c, d])),
            (Kind::F64, &[a, b, c, d, e, f, g, h]) => f64::from_le_bytes([a, b, c, d, e, f, g, h]),
            _ => f64::NAN,
        };
        raw * self.increment + self.offset
    }
}

impl Kind {
    fn size(self) -> usize {
        match self {
            Self::I16 => 2,
            Self::I32 | Self::F32 => 4,
            Self::F64 => 8,
        }
    }
}

/// An element with its path, for messages.
struct Element<'a, 'd> {
    node: Node<'a, 'd>,
    path: String,
}

impl<'a, 'd> Element<'a, 'd> {
    fn child(&self, name: &str) -> Result<Self, ScanReadError> {
        let path = if self.path.is_empty() { name.to_owned() } else { format!("{}/{name}", self.path) };
        let node = self.node.children().find(|node| node.is_element() && node.tag_name().name() == name);
        let missing = || ScanReadError::MissingField {
            format: FORMAT,
            place: Place::Element(if self.path.is_empty() { INDEX.to_owned() } else { self.path.clone() }),
            field: format!("element '{name}'"),
            mend: "export the file again",
        };
        Ok(Self { node: node.ok_or_else(missing)?, path })
    }

    fn text(&self) -> &'a str {
        self.node.text().unwrap_or_default().trim()
    }

    fn one_of(&self, name: &str, accepted: &[&str]) -> Result<&'a str, ScanReadError> {
        let child = self.child(name)?;
        let is_accepted = accepted.contains(&child.text());
        if is_accepted {
            Ok(child.text())
        } else {
            Err(child.bad(&accepted.join(" or "), "export the file otherwise"))
        }
    }

    fn count(&self) -> Result<usize, ScanReadError> {
        let count = self.text().parse().ok().filter(|&count: &usize| count > 0);
        count.ok_or_else(|| self.bad("a whole number above 0", "export the file again"))
    }

    fn number(&self) -> Result<f64, ScanReadError> {
        let number = self.text().parse().ok().filter(|number: &f64| number.is_finite());
        number.ok_or_else(|| self.bad("a finite number", "export the file again"))
    }

    fn positive(&self) -> Result<f64, ScanReadError> {
        let number = self.number()?;
        if number > 0.0 { Ok(number) } else { Err(self.bad("above 0", "export the file again")) }
    }

    /// The type and scale of an axis; only axes whose values are in the data need a type.
    fn coordinate(&self, has_data: bool) -> Result<Coordinate, ScanReadError> {
        let kind = match (has_data, self.child("DataType")) {
            (false, _) => Kind::F64,
            (true, Err(error)) => return Err(error),
            (true, Ok(kind)) => match kind.text() {
                "I" => Kind::I16,
                "L" => Kind::I32,
                "F" => Kind::F32,
                "D" => Kind::F64,
                _ => return Err(kind.bad("I, L, F or D", "export the file again")),
            },
        };
        let number = |name: &str| self.child(name).ok().map(|child| child.number()).transpose();
        let increment = number("Increment")?.unwrap_or(1.0);
        if increment == 0.0 {
            return Err(self.child("Increment")?.bad("other than 0", "export the file again"));
        }
        Ok(Coordinate { kind, increment, offset: number("Offset")?.unwrap_or(0.0) })
    }

    fn path_inside(&self) -> Result<String, ScanReadError> {
        let path = self.text().to_owned();
        if leads_outside(&path) { Err(ScanReadError::PathOutside { path }) } else { Ok(path) }
    }

    fn bad(&self, bound: &str, mend: &'static str) -> ScanReadError {
        ScanReadError::BadField {
            format: FORMAT,
            place: Place::Element(self.path.clone()),
            field: "the text".to_owned(),
            value: format!("'{}'", self.text().chars().take(60).collect::<String>()),
            bound: bound.to_owned(),
            mend,
        }
    }
}
