//! NetCDF-3 with offsets of 64 bits, in the layout of contact.engineering: `heights` over `x` and `y` or over the points
//! of a line, lengths in m as attributes, and a mask of the gaps.

use super::ScanWriteError;
use crate::file::ScanFile;

/// Tags of the lists of a header, and types of numbers.
const DIMENSIONS: u32 = 10;
const VARIABLES: u32 = 11;
const ATTRIBUTES: u32 = 12;
const BYTE: u32 = 1;
const TEXT: u32 = 2;
const DOUBLE: u32 = 6;

/// A variable: its name, dimensions by number, attributes, type and big-endian numbers.
struct Variable {
    name: &'static str,
    dimensions: Vec<u32>,
    attributes: Vec<(&'static str, Value)>,
    kind: u32,
    bytes: Vec<u8>,
}

#[derive(Clone)]
enum Value {
    Text(String),
    Number(f64),
}

pub(super) fn write(file: &ScanFile, provenance: &str) -> Result<Vec<u8>, ScanWriteError> {
    let scan = &file.scan;
    let (columns, rows) = scan.points();
    let lengths = match scan.size_m() {
        (x_m, Some(y_m)) if rows.is_some() => vec![("x", columns, x_m), ("y", rows.unwrap_or(1), y_m)],
        (x_m, None) if rows.is_none() => vec![("x", columns, x_m)],
        _ => return Err(ScanWriteError::Lines),
    };
    let unit = || ("unit", Value::Text("m".to_owned()));
    let doubles = |numbers: &mut dyn Iterator<Item = f64>| numbers.flat_map(f64::to_be_bytes).collect();
    let (dimensions, mut variables) = if let Some(positions_m) = scan.positions_m() {
        let x = Variable {
            name: "x",
            dimensions: vec![0],
            attributes: vec![unit()],
            kind: DOUBLE,
            bytes: doubles(&mut positions_m.iter().copied()),
        };
        (vec![("n", columns)], vec![x])
    } else {
        let periodic = f64::from(u8::from(file.is_periodic));
        let axis = |(number, (name, points, length_m)): (usize, &(&'static str, usize, f64))| {
            let (points, length_m) = (*points, *length_m);
            let attributes =
                vec![unit(), ("length", Value::Number(length_m)), ("periodic", Value::Number(periodic))];
            let positions = &mut (0..points).map(|point| point as f64 * (length_m / points as f64));
            let bytes = doubles(positions);
            Variable { name, dimensions: vec![number as u32], attributes, kind: DOUBLE, bytes }
        };
        let dimensions = lengths.iter().map(|(name, points, _)| (*name, *points)).collect();
        (dimensions, lengths.iter().enumerate().map(axis).collect())
    };
    // The last axis runs fastest, which is y.
    let rows = rows.unwrap_or(1);
    let order = || (0..columns).flat_map(move |column| (0..rows).map(move |row| row * columns + column));
    let all: Vec<u32> = (0..dimensions.len() as u32).collect();
    variables.push(Variable {
        name: "heights",
        dimensions: all.clone(),
        attributes: vec![unit()],
        kind: DOUBLE,
        bytes: doubles(&mut order().map(|index| scan.height_m(index).unwrap_or(0.0))),
    });
    if !scan.missing_points().is_empty() {
        let bytes = order().map(|index| u8::from(scan.height_m(index).is_none())).collect();
        variables.push(Variable { name: "mask", dimensions: all, attributes: vec![], kind: BYTE, bytes });
    }
    let mut of_file = vec![("history", Value::Text(provenance.to_owned()))];
    of_file.extend(file.channel.clone().map(|channel| ("channel", Value::Text(channel))));
    Ok(bytes(&dimensions, &of_file, &variables))
}

fn bytes(dimensions: &[(&str, usize)], of_file: &[(&str, Value)], variables: &[Variable]) -> Vec<u8> {
    let mut offset = header(dimensions, of_file, variables, &vec![0; variables.len()]).len();
    let mut offsets = Vec::new();
    for variable in variables {
        offsets.push(offset as u64);
        offset += variable.bytes.len().next_multiple_of(4);
    }
    let mut bytes = header(dimensions, of_file, variables, &offsets);
    for variable in variables {
        bytes.extend(&variable.bytes);
        bytes.resize(bytes.len().next_multiple_of(4), 0);
    }
    bytes
}

fn header(
    dimensions: &[(&str, usize)],
    of_file: &[(&str, Value)],
    variables: &[Variable],
    offsets: &[u64],
) -> Vec<u8> {
    let mut out = Out(b"CDF\x02".to_vec());
    out.number(0).list(DIMENSIONS, dimensions.len());
    dimensions.iter().for_each(|(name, points)| {
        out.text(name).number(*points as u32);
    });
    out.attributes(of_file).list(VARIABLES, variables.len());
    for (variable, offset) in variables.iter().zip(offsets) {
        out.text(variable.name).number(variable.dimensions.len() as u32);
        variable.dimensions.iter().for_each(|&dimension| {
            out.number(dimension);
        });
        out.attributes(&variable.attributes).number(variable.kind);
        // A size that does not fit is not needed: readers take it from the dimensions.
        let size = variable.bytes.len().next_multiple_of(4);
        out.number(u32::try_from(size).unwrap_or(u32::MAX)).0.extend(offset.to_be_bytes());
    }
    out.0
}

/// The header as far as it is written.
struct Out(Vec<u8>);

impl Out {
    fn number(&mut self, number: u32) -> &mut Self {
        self.0.extend(number.to_be_bytes());
        self
    }

    fn list(&mut self, tag: u32, count: usize) -> &mut Self {
        self.number(if count == 0 { 0 } else { tag }).number(count as u32)
    }

    fn text(&mut self, text: &str) -> &mut Self {
        self.number(text.len() as u32).0.extend(text.as_bytes());
        self.0.resize(self.0.len().next_multiple_of(4), 0);
        self
    }

    fn attributes(&mut self, attributes: &[(&str, Value)]) -> &mut Self {
        self.list(ATTRIBUTES, attributes.len());
        for (name, value) in attributes {
            self.text(name);
            match value {
                Value::Text(text) => {
                    self.number(TEXT).text(text);
                }
                Value::Number(number) => self.number(DOUBLE).number(1).0.extend(number.to_be_bytes()),
            }
        }
        self
    }
}
