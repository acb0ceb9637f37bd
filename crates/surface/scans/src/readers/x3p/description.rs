//! XML description of a file: number of points, their places, and the place of their data.

use super::axis::{Coordinate, ScanAxis};
use super::element::Element;
use super::{FORMAT, INDEX};
use crate::error::{FilePlace, ScanReadError};
use crate::metadata::Probe;
use crate::readers::xml;

/// Files that are not made to be read have more.
const MOST_NODES: u32 = 1_000_000;

/// Contents of `main.xml`.
pub(super) struct Description {
    pub(super) layout: Layout,
    pub(super) columns: usize,
    pub(super) rows: usize,
    pub(super) x: ScanAxis,
    pub(super) y: ScanAxis,
    pub(super) z: Coordinate,
    pub(super) points: Points,
    pub(super) probe: Option<Probe>,
    pub(super) free_text: String,
    pub(super) notes: Vec<String>,
}

#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Layout {
    Profile,
    Surface,
    /// Points in any order.
    Cloud,
}

/// Place of the data.
pub(super) enum Points {
    /// In a file of the archive, with a file of a bit for each point that counts.
    Binary { data: String, valid: Option<String> },
    /// In the description; nothing where a point does not count.
    Listed(Vec<Option<Vec<f64>>>),
}

impl Description {
    /// Parses the XML of an archive whose files are in a folder.
    pub(super) fn read(index: &[u8], folder: &str) -> Result<Self, ScanReadError> {
        let syntax = |problem: String| ScanReadError::Syntax { file: INDEX.to_owned(), problem };
        let text = std::str::from_utf8(index).map_err(|error| syntax(format!("no UTF-8: {error}")))?;
        let text = text.trim_start_matches('\u{feff}');
        let document = xml::parse(text, MOST_NODES).map_err(syntax)?;
        let root = Element { node: document.root_element(), path: String::new() };
        let axes = root.child("Record1")?.child("Axes")?;
        let feature = root.child("Record1")?.child("FeatureType")?;
        let layout = match feature.text() {
            "SUR" => Layout::Surface,
            "PRF" => Layout::Profile,
            "PCL" => Layout::Cloud,
            other => {
                return Err(FORMAT.unsupported(
                    FilePlace::Element(feature.path),
                    format!("the feature type '{other}'"),
                    "export a surface (SUR) or a profile (PRF)",
                ));
            }
        };
        let x = axes.child("CX")?.axis()?;
        let y = match axes.child("CY") {
            Err(_) if layout == Layout::Profile => ScanAxis::Even(1.0),
            // The one row of a profile needs no spacing.
            Ok(y) if layout == Layout::Profile && y.one_of("AxisType", &["I", "A"])? == "I" => {
                ScanAxis::Even(1.0)
            }
            y => y?.axis()?,
        };
        let z = axes.child("CZ")?;
        z.one_of("AxisType", &["A"])?;
        let notes = Vec::from_iter(z.unused_increment()?);
        let z = z.coordinate()?;
        let record = root.child("Record3")?;
        let (columns, rows) = if layout == Layout::Cloud {
            (record.child("ListDimension")?.count()?, 1)
        } else {
            let matrix = record.child("MatrixDimension")?;
            let depth = matrix.child("SizeZ")?;
            if depth.text() != "1" {
                return Err(depth.bad("1", "export one layer"));
            }
            let (columns, rows) = (matrix.child("SizeX")?, matrix.child("SizeY")?);
            if layout == Layout::Profile && rows.count()? != 1 {
                return Err(rows.bad("1 for a profile", "export one profile"));
            }
            (columns.count()?, rows.count()?)
        };
        if let (Layout::Cloud, ScanAxis::Even(_), _) | (Layout::Cloud, _, ScanAxis::Even(_)) = (layout, x, y)
        {
            return Err(axes
                .child("CX")?
                .child("AxisType")?
                .bad("A (positions) for points", "export the file otherwise"));
        }
        Ok(Self {
            layout,
            columns,
            rows,
            x,
            y,
            z,
            points: points(&record, folder)?,
            probe: probe(&root),
            free_text: root
                .child("Record2")
                .and_then(|record| record.child("Comment"))
                .map_or(String::new(), |comment| comment.text().to_owned()),
            notes,
        })
    }
}

/// The data in the description, or the way to those in a file.
fn points(record: &Element, folder: &str) -> Result<Points, ScanReadError> {
    if let Ok(list) = record.child("DataList") {
        let data = list.node.children().filter(|node| node.is_element() && node.tag_name().name() == "Datum");
        let numbers = |text: &str| {
            text.split(';').map(|number| number.trim().parse().ok()).collect::<Option<Vec<f64>>>()
        };
        let listed = data.map(|node| {
            let text = node.text().unwrap_or_default().trim();
            let point = Element { node, path: format!("{}/Datum", list.path) };
            match text {
                "" => Ok(None),
                _ => numbers(text).map(Some).ok_or_else(|| {
                    point.bad("numbers with semicolons between them", "export the file again")
                }),
            }
        });
        return Ok(Points::Listed(listed.collect::<Result<_, _>>()?));
    }
    let link = record.child("DataLink").map_err(|_| {
        let mend = "export the file again";
        FORMAT.missing(FilePlace::Element("Record3".to_owned()), "element 'DataLink' or 'DataList'", mend)
    })?;
    let valid = link.child("ValidPointsLink").ok().filter(|link| !link.text().is_empty());
    Ok(Points::Binary {
        data: link.child("PointDataLink")?.path_inside(folder)?,
        valid: valid.map(|link| link.path_inside(folder)).transpose()?,
    })
}

/// Returns the probe; none where the file does not say, or says that the surface was computed.
fn probe(root: &Element) -> Option<Probe> {
    match root.child("Record2").ok()?.child("ProbingSystem").ok()?.child("Type").ok()?.text() {
        "Contacting" => Some(Probe::Tip),
        "NonContacting" => Some(Probe::Microscope),
        _ => None,
    }
}
