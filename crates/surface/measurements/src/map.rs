//! The detrended heights of one map, for boundary elements.

use scans::{HeightMap, Scan, ScanError};
use topography::{Direction, Recipe, detrended_m, readings};
use units::Remark;

use crate::error::{ScanProblem, TopographyError};
use crate::files::Files;
use crate::load::{Loaded, load_heights};
use crate::only_map::{map_in, only_scan};
use crate::request::ScanRequest;

/// A measured map.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct MapOfFile {
    /// Heights minus their trend.
    pub map: HeightMap,
    /// True if the file declares the map periodic.
    pub is_periodic: bool,
    /// Provenance: the file with its SHA-256 and the detrending.
    pub provenance: String,
    /// Assumptions made on reading.
    pub remarks: Vec<Remark>,
}

impl MapOfFile {
    /// Reads the one map in the bytes of a file and subtracts the trend, as for its spectrum. With `repeats` the map is taken to repeat
    /// itself, as if the file said so; then a line is a surface that does not change across it, and becomes two equal rows.
    ///
    /// # Errors
    /// [`TopographyError`] if the file holds no map, several, or one with too many missing points.
    pub fn read(
        request: &ScanRequest,
        bytes: &[u8],
        files: &dyn Files,
        recipe: &Recipe,
        repeats: bool,
    ) -> Result<Self, TopographyError> {
        request.check_takes(&ScanRequest::OF_MAPS)?;
        let Loaded { scans, sha256 } = load_heights(request, bytes, files)?;
        let recipe = &request.recipe(recipe);
        let file = only_scan(request, scans, recipe.gaps, ScanProblem::NotOneSurface)?;
        let broken = |error: ScanError| {
            TopographyError::for_file(&request.path, ScanProblem::Format(Box::new(error.into())))
        };
        let repeats = repeats || file.is_periodic;
        let two_rows = match &file.scan {
            Scan::UniformLine(line) if repeats => {
                let (heights_m, spacing_m) = (line.heights_m(), line.spacing_m());
                let map = HeightMap::new(heights_m.len(), spacing_m, spacing_m, heights_m.repeat(2));
                Some(map.map_err(broken)?)
            }
            _ => None,
        };
        let map = match &two_rows {
            Some(map) => map,
            None => map_in(request, &file, ScanProblem::LineIsNoSurface)?,
        };
        // Contact has no direction, but line-by-line detrending and pictures do.
        let turned = (recipe.direction == Direction::Y).then(|| map.turned());
        let map = turned.as_ref().unwrap_or(map);
        let detrend = recipe.preparation(repeats).detrend;
        let rest_m = detrended_m(map, detrend);
        let map =
            HeightMap::new(map.columns(), map.spacing_x_m(), map.spacing_y_m(), rest_m).map_err(broken)?;
        let provenance = format!(
            "map: {} ({}){}, SHA-256 {sha256}, detrend {detrend}",
            request.path,
            file.format,
            if turned.is_some() { ", turned" } else { "" }
        );
        let pressed_once = (recipe.direction == Direction::Both).then(|| {
            "direction both makes two spectra of a map but one surface, which is pressed as scanned"
                .to_owned()
        });
        let of_line =
            two_rows.map(|_| "the line is pressed as a surface that does not change across it".to_owned());
        let notes: Vec<String> = file.notes.iter().cloned().chain(pressed_once).chain(of_line).collect();
        let of_map = |note: Remark| note.about([file.name.as_str()]);
        let remarks = readings(&notes).into_iter().map(of_map).collect();
        Ok(MapOfFile { map, is_periodic: file.is_periodic, provenance, remarks })
    }
}
