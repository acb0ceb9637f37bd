//! The detrended heights of one map, or of two that face each other, for boundary elements.

use scans::{HeightMap, MissingPoints, Scan, ScanError};
use topography::{Direction, Recipe, TransformError, readings};
use units::Remark;

use crate::error::{ScanProblem, TopographyError};
use crate::facing::PartialMap;
use crate::files::Files;
use crate::load::{Loaded, bytes_of_scans, load_heights};
use crate::only_map::{map_in, only_scan, untransformed};
use crate::request::ScanRequest;

/// A measured map.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct MapOfFile {
    /// Heights minus their trend; points without a height are missing where they are kept.
    pub heights: PartialMap,
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
        let recipe = request.recipe(recipe);
        let raw = RawMap::read(request, bytes, files, &recipe, repeats)?;
        raw.detrended(request, &recipe)
    }

    /// Reads a map as [`read`](Self::read) does, and adds the map of another file that [faces](PartialMap::facing) it. The trend is
    /// that of the sum, so it is not an option of the other file.
    ///
    /// # Errors
    /// [`TopographyError`] as of `read` for either file, if only one of them is a line.
    pub fn read_facing(
        [request, other]: [&ScanRequest; 2],
        bytes: &[u8],
        files: &dyn Files,
        recipe: &Recipe,
        repeats: bool,
    ) -> Result<Self, TopographyError> {
        request.check_takes(&ScanRequest::OF_MAPS)?;
        other.check_takes(&ScanRequest::OF_FACING_MAPS)?;
        let own_recipe = request.recipe(recipe);
        let own = RawMap::read(request, bytes, files, &own_recipe, repeats);
        let bytes = bytes_of_scans(other, files)?;
        let faced = RawMap::read(other, &bytes, files, &other.recipe(recipe), repeats);
        let line_facing = |line: &ScanRequest, map: &ScanRequest| {
            TopographyError::for_file(&line.path, ScanProblem::LineFacesMap { map: map.path.clone() })
        };
        // A line of which only its kind is wrong is the fault of the pair.
        let is_line = |raw: &Result<RawMap, TopographyError>| match raw {
            Ok(raw) => raw.is_line,
            Err(error) => matches!(error.problem, ScanProblem::LineIsNoSurface),
        };
        match (is_line(&own), is_line(&faced)) {
            (true, false) if faced.is_ok() => return Err(line_facing(request, other)),
            (false, true) if own.is_ok() => return Err(line_facing(other, request)),
            _ => {}
        }
        let (own, faced) = (own?, faced?);
        let heights = own.heights.facing(&faced.heights).map_err(|error| broken(other, error))?;
        let (own_name, faced_name) =
            ((own.name.as_str(), &own.heights), (faced.name.as_str(), &faced.heights));
        let notes = heights.remarks_on_sum(own_name, faced_name);
        let is_whole = own.heights.has_grid_of(&faced.heights);
        let sum = RawMap {
            heights,
            is_periodic: own.is_periodic && faced.is_periodic && is_whole,
            repeats: repeats || own.repeats && faced.repeats && is_whole,
            is_line: own.is_line,
            provenance: format!("{}, facing {}", own.provenance, faced.provenance),
            remarks: [own.remarks, faced.remarks, notes].concat(),
            name: own.name,
        };
        sum.detrended(request, &own_recipe)
    }
}

/// A map as measured.
struct RawMap {
    heights: PartialMap,
    is_periodic: bool,
    repeats: bool,
    /// True if the map is a line that does not change across.
    is_line: bool,
    name: String,
    provenance: String,
    remarks: Vec<Remark>,
}

impl RawMap {
    fn read(
        request: &ScanRequest,
        bytes: &[u8],
        files: &dyn Files,
        recipe: &Recipe,
        repeats: bool,
    ) -> Result<Self, TopographyError> {
        let Loaded { scans, sha256 } = load_heights(request, bytes, files)?;
        let (file, missing) = only_scan(request, scans, recipe.gaps, ScanProblem::NotOneSurface)?;
        let repeats = repeats || file.is_periodic;
        let two_rows = match &file.scan {
            Scan::UniformLine(line) if repeats => {
                let (heights_m, spacing_m) = (line.heights_m(), line.spacing_m());
                let map = HeightMap::new(heights_m.len(), spacing_m, spacing_m, heights_m.repeat(2));
                Some(map.map_err(|error| broken(request, error))?)
            }
            _ => None,
        };
        let map = match &two_rows {
            Some(map) => map,
            None => map_in(request, &file, ScanProblem::LineIsNoSurface)?,
        };
        // Both rows of a line lack the same points.
        let second_row = missing.indices().filter(|_| two_rows.is_some()).map(|at| at + map.columns());
        let missing: MissingPoints = missing.indices().chain(second_row).collect();
        let points = map.columns() * map.rows();
        if missing.count() >= points {
            return Err(untransformed(request, TransformError::NoHeights { points }));
        }
        // Contact has no direction, but line-by-line detrending and pictures do.
        let is_turned = recipe.direction == Direction::Y;
        let heights = if is_turned {
            let (rows, columns) = (map.rows(), map.columns());
            let turned = |point: usize| point % columns * rows + point / columns;
            PartialMap { map: map.turned(), missing: missing.indices().map(turned).collect() }
        } else {
            PartialMap { map: map.clone(), missing }
        };
        let turned = if is_turned { ", turned" } else { "" };
        let provenance = format!("{} ({}){turned}, SHA-256 {sha256}", request.path, file.format);
        let pressed_once = (recipe.direction == Direction::Both).then(|| {
            "direction both makes two spectra of a map but one surface, which is pressed as scanned"
                .to_owned()
        });
        let is_line = two_rows.is_some();
        let of_line =
            is_line.then(|| "the line is pressed as a surface that does not change across it".to_owned());
        let notes: Vec<String> = file.notes.iter().cloned().chain(pressed_once).chain(of_line).collect();
        let of_map = |note: Remark| note.about([file.name.as_str()]);
        let remarks = readings(&notes).into_iter().map(of_map).collect();
        let (is_periodic, name) = (file.is_periodic, file.name);
        Ok(Self { heights, is_periodic, repeats, is_line, name, provenance, remarks })
    }

    /// Subtracts the trend through the points that have a height.
    fn detrended(self, request: &ScanRequest, recipe: &Recipe) -> Result<MapOfFile, TopographyError> {
        let detrend = recipe.preparation(self.repeats).detrend;
        let rest_m = self.heights.detrended_m(detrend);
        let PartialMap { map, missing } = self.heights;
        let map = HeightMap::new(map.columns(), map.spacing_x_m(), map.spacing_y_m(), rest_m);
        Ok(MapOfFile {
            heights: PartialMap { map: map.map_err(|error| broken(request, error))?, missing },
            is_periodic: self.is_periodic,
            provenance: format!("map: {}, detrend {detrend}", self.provenance),
            remarks: self.remarks,
        })
    }
}

fn broken(request: &ScanRequest, error: ScanError) -> TopographyError {
    TopographyError::for_file(&request.path, ScanProblem::Format(Box::new(error.into())))
}
