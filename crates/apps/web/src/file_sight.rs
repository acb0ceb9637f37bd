//! First sight of a file: its kind, its size, its roughness, a picture, and what it lacks.

use measurements::{Files, METADATA_FILES, ScanProblem, TopographyError, read_channels};
use report::chart::maps::HeightsPicture;
use serde::Serialize;

use crate::heights::MapHeights;
use crate::request::{FileKind, FileRequest, Refusal};

/// True if this build reads every format.
const HAS_ALL_FORMATS: bool = cfg!(feature = "all-formats");

/// A file as the page shows it.
#[derive(Debug, Serialize)]
pub struct FileSight {
    /// Its name.
    pub name: String,
    /// Its kind.
    pub kind: FileKind,
    /// Format, size, points, roughness parameters and notes of its channels.
    pub words: String,
    /// The heights of its first map.
    pub map: Option<MapHeights>,
    /// The picture of its first line, as SVG.
    pub line: Option<String>,
    /// The reason why it cannot be used, and what mends it.
    pub refusal: Option<Refusal>,
    /// True if this build lacks formats and another may read the file, or what it says about others.
    pub wants_all_formats: bool,
}

impl FileSight {
    /// Looks at a file.
    pub fn new(file: &FileRequest, files: &dyn Files) -> Self {
        let mut sight = FileSight {
            name: file.name.clone(),
            kind: FileKind::Scan,
            words: String::new(),
            map: None,
            line: None,
            refusal: None,
            wants_all_formats: !HAS_ALL_FORMATS && is_metadata(&file.name),
        };
        let request = match file.scan() {
            Ok(request) => request,
            Err(refusal) => return FileSight { refusal: Some(refusal), ..sight },
        };
        let (mut map, mut line) = (None, None);
        let found = read_channels::<std::convert::Infallible>(&[request], files, false, |_, scan| {
            if map.is_none() && line.is_none() {
                map = MapHeights::new(scan);
                line = match map {
                    Some(_) => None,
                    None => match HeightsPicture::new(scan) {
                        Some(HeightsPicture::Line(svg)) => Some(svg),
                        _ => None,
                    },
                };
            }
            Ok(())
        });
        let Ok(found) = found;
        sight.words = found.describe();
        (sight.map, sight.line) = (map, line);
        match found.unreadable.first() {
            None => {}
            Some(TopographyError { problem: ScanProblem::HoldsASpectrum, .. }) => {
                sight.kind = FileKind::Spectrum;
                sight.words = "power spectrum".to_owned();
            }
            Some(TopographyError { problem: ScanProblem::IsAScene, .. }) => {
                sight.kind = FileKind::Scene;
                sight.words = "scene".to_owned();
            }
            Some(error) => {
                sight.refusal = Some(Refusal::of_scans(error));
                if sight.refusal.as_ref().is_some_and(|refusal| refusal.option.is_none()) {
                    sight.kind = FileKind::Other;
                    sight.wants_all_formats = !HAS_ALL_FORMATS;
                }
            }
        }
        sight
    }
}

/// True for a file that describes the scans of its folder.
fn is_metadata(name: &str) -> bool {
    METADATA_FILES.iter().any(|metadata| name.rsplit('/').next() == Some(metadata))
}
