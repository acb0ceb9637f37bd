//! X3P of ISO 25178-72: `main.xml` with the axes, and double-precision numbers beside it. A gap is no number.

use std::io::{Cursor, Write};

use md5::{Digest, Md5};
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, ZipWriter};

use super::ScanWriteError;
use crate::file::ScanFile;

const DATA: &str = "bindata/data.bin";
const CHECKSUM: &str = "md5checksum.hex";

pub(super) fn write(file: &ScanFile, provenance: &str) -> Result<Vec<u8>, ScanWriteError> {
    let data = data(file);
    let index = index(file, provenance, &digits(&data))?;
    let checksum = format!("{} *main.xml\n", digits(index.as_bytes()));
    let files = [("main.xml", index.as_bytes()), (DATA, &data), (CHECKSUM, checksum.as_bytes())];
    packed(&files).map_err(|error| ScanWriteError::Archive(error.to_string()))
}

fn packed(files: &[(&str, &[u8])]) -> Result<Vec<u8>, zip::result::ZipError> {
    let mut archive = ZipWriter::new(Cursor::new(Vec::new()));
    let options = SimpleFileOptions::default().compression_method(CompressionMethod::Deflated);
    for (path, content) in files {
        archive.start_file(*path, options)?;
        archive.write_all(content)?;
    }
    Ok(archive.finish()?.into_inner())
}

/// Positions, where they are uneven, and heights, a point after the other.
fn data(file: &ScanFile) -> Vec<u8> {
    let positions_m = file.scan.positions_m();
    let mut data = Vec::new();
    for (index, height_m) in file.scan.heights_m().enumerate() {
        data.extend(positions_m.iter().flat_map(|positions_m| positions_m[index].to_le_bytes()));
        data.extend(height_m.unwrap_or(f64::NAN).to_le_bytes());
    }
    data
}

fn index(file: &ScanFile, provenance: &str, data_digits: &str) -> Result<String, ScanWriteError> {
    let scan = &file.scan;
    let (columns, rows) = scan.points();
    let even = |name: &str, spacing_m: f64| {
        format!(
            "<C{name}><AxisType>I</AxisType><DataType>D</DataType><Increment>{spacing_m:e}</Increment><Offset>0</Offset></C{name}>"
        )
    };
    let stored = |name: &str| format!("<C{name}><AxisType>A</AxisType><DataType>D</DataType></C{name}>");
    let (feature, x, y) = match (scan.positions_m(), scan.spacing_m(), rows) {
        (Some(_), ..) => ("PRF", stored("X"), even("Y", 1.0)),
        (None, (x_m, Some(y_m)), Some(_)) => ("SUR", even("X", x_m), even("Y", y_m)),
        (None, (x_m, _), None) => ("PRF", even("X", x_m), even("Y", 1.0)),
        _ => return Err(ScanWriteError::Lines),
    };
    // The standard wants instrument and dates, which are not known here: the record is left out, and what is known of
    // the origin is a comment.
    let origin =
        [Some(provenance), file.channel.as_deref()].into_iter().flatten().collect::<Vec<_>>().join("; ");
    let origin = origin.replace("--", "- -");
    Ok(format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<!-- {origin} -->\n\
         <p:ISO5436_2 xmlns:p=\"http://www.opengps.eu/2008/ISO5436_2\">\n\
         <Record1><Revision>ISO5436 - 2000</Revision><FeatureType>{feature}</FeatureType><Axes>{x}{y}{}</Axes></Record1>\n\
         <Record3><MatrixDimension><SizeX>{columns}</SizeX><SizeY>{}</SizeY><SizeZ>1</SizeZ></MatrixDimension>\
         <DataLink><PointDataLink>{DATA}</PointDataLink><MD5ChecksumPointData>{data_digits}</MD5ChecksumPointData></DataLink>\
         </Record3>\n<Record4><ChecksumFile>{CHECKSUM}</ChecksumFile></Record4>\n</p:ISO5436_2>\n",
        stored("Z"),
        rows.unwrap_or(1),
    ))
}

/// The MD5 of a file in hexadecimal digits, which the standard wants beside it.
fn digits(bytes: &[u8]) -> String {
    Md5::digest(bytes).iter().map(|byte| format!("{byte:02x}")).collect()
}
