//! Flow through gaps: of pressed surfaces, and of gap fields from elsewhere.

use std::sync::{Mutex, PoisonError};

use elements::half_space::{Grid, HalfSpaceError, OpenPaths};
use elements::{Boundary, ContactField, ElementsError, PressedLoad, Surfaces, means_table, states_table};
use measurements::{Files, Loaded, ScanRequest, TopographyError};
use numerics::parallel::{NestedProgress, Progress};
use tables::Table;
use topography::readings;
use transport::GapField;
use transport::flow::{self, Ends, FlowDirection, FlowError, SolvedFlow};
use units::display::three_digits;
use units::{Bound, OutOfBounds, Remark, RemarkCode, named};

use crate::{Answer, QuestionError};

/// Share of points with a negative gap above which the field is doubted.
const MOST_NEGATIVE: f64 = 0.1;
/// Name of the channel that is read as gaps, in files that have it.
const GAP_CHANNEL: &str = "gap";

/// Conditions at the edges of a gap.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FlowEdges {
    /// The gap and the flow repeat themselves in both directions.
    Periodic,
    /// One reservoir feeds a whole edge across the flow, another drains the opposite one; at its sides the gap repeats itself.
    Reservoirs,
    /// Reservoirs as above, and walls at the sides.
    Channel,
}

named!(FlowEdges, "kind of edges", {
    Periodic => "periodic", Reservoirs => "reservoirs", Channel => "channel",
});

/// Flow through a gap along x and along y.
#[derive(Debug, Clone, PartialEq)]
pub struct GapFlow {
    /// Flow under a mean pressure gradient along x.
    pub along_x: SolvedFlow,
    /// Flow under a mean pressure gradient along y.
    pub along_y: SolvedFlow,
    /// Errors of both factors that come from the spacing of the points; none for fields of a few points.
    pub spacing_errors: [Option<f64>; 2],
}

impl GapFlow {
    fn solve(gap: &GapField<'_>, edges: FlowEdges, progress: &dyn Progress) -> Result<Self, QuestionError> {
        let (along_x, x_error) = solve_along(FlowDirection::X, gap, edges, progress)?;
        let (along_y, y_error) = solve_along(FlowDirection::Y, gap, edges, progress)?;
        Ok(GapFlow { along_x, along_y, spacing_errors: [x_error, y_error] })
    }

    /// Returns the directions in which a path leads through.
    #[must_use]
    pub fn open_paths(&self) -> OpenPaths {
        OpenPaths { along_x: self.along_x.is_open(), along_y: self.along_y.is_open() }
    }

    /// Returns the flow through each of so many points over the mean flow by names of variables: under a gradient along x and along y
    /// its components along both.
    #[must_use]
    pub fn variables(&self, points: usize) -> [(&'static str, Vec<f64>); 4] {
        let component = |flow: &SolvedFlow, axis: usize| {
            (0..points).map(|at| flow.flux.get(at).map_or(0.0, |flow| flow[axis])).collect()
        };
        [
            ("flow_along_x_x", component(&self.along_x, 0)),
            ("flow_along_x_y", component(&self.along_x, 1)),
            ("flow_along_y_x", component(&self.along_y, 0)),
            ("flow_along_y_y", component(&self.along_y, 1)),
        ]
    }

    /// Returns the larger residual of the two directions.
    #[must_use]
    pub fn residual(&self) -> f64 {
        self.along_x.residual.max(self.along_y.residual)
    }
}

/// Solves the flow along one direction, with the error of its factor. The field of a channel has closed rows or columns more.
fn solve_along(
    direction: FlowDirection,
    gap: &GapField<'_>,
    edges: FlowEdges,
    progress: &dyn Progress,
) -> Result<(SolvedFlow, Option<f64>), QuestionError> {
    let ends = if edges == FlowEdges::Periodic { Ends::Periodic } else { Ends::Reservoirs };
    let solved = |gap: &GapField<'_>| {
        let flow = flow::solve(gap, direction, ends, progress)?;
        let error = flow::spacing_error(flow.flow_factor, gap, direction, ends, progress)?;
        // A field that is closed everywhere has no mean gap.
        Ok((flow, error.filter(|error| error.is_finite())))
    };
    if edges != FlowEdges::Channel {
        return solved(gap).map_err(unsolved);
    }
    let (grid, rows, columns) = (gap.grid(), gap.grid().rows(), gap.grid().columns());
    // Every second point of an even number of rows leaves a wall of two rows closed.
    let widened = |points: usize| points + 2 + points % 2;
    let (all_rows, all_columns) = match direction {
        FlowDirection::X => (widened(rows), columns),
        FlowDirection::Y => (rows, widened(columns)),
    };
    let inside = |point: usize| {
        let (row, column) = (point / all_columns, point % all_columns);
        (row < rows && column < columns).then(|| row * columns + column)
    };
    let gaps_m: Vec<f64> =
        (0..all_rows * all_columns).map(|at| inside(at).map_or(0.0, |point| gap.gap_m(point))).collect();
    let length_x_m = grid.length_x_m() / columns as f64 * all_columns as f64;
    let length_y_m = grid.length_y_m() / rows as f64 * all_rows as f64;
    let walled = Grid::new(all_rows, all_columns, length_x_m, length_y_m).map_err(ElementsError::from)?;
    let (mut flow, error) = solved(&field(walled, &gaps_m)?).map_err(unsolved)?;
    // The walls widen the channel and thin the mean gap, with whose cube the slot conducts.
    let share = (rows * columns) as f64 / (all_rows * all_columns) as f64;
    flow.flow_factor *= share * share;
    let kept = flow.flux.iter().enumerate().filter(|(at, _)| inside(*at).is_some());
    flow.flux = kept.map(|(_, flow)| flow.map(|component| component * share)).collect();
    // The walls alone make fields of a few points wide enough for an estimate.
    let error = error.filter(|_| rows.min(columns) >= 4).map(|error| error * share * share);
    Ok((flow, error))
}

fn field(grid: Grid, gaps_m: &[f64]) -> Result<GapField<'_>, QuestionError> {
    GapField::new(grid, gaps_m).map_err(|error| QuestionError::Other(error.to_string()))
}

fn unsolved(error: FlowError) -> QuestionError {
    match error {
        FlowError::Cancelled => ElementsError::from(HalfSpaceError::Cancelled).into(),
        error => QuestionError::Other(error.to_string()),
    }
}

/// Reason why a file is no map of gaps.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum GapMapError {
    /// The file cannot be read.
    #[error(transparent)]
    File(#[from] TopographyError),
    /// The file holds no map, but something else.
    #[error("{file}: {found}; give one map of gaps at equal distances")]
    NoMap {
        /// The file.
        file: String,
        /// Its content.
        found: String,
    },
}

/// Gaps on a grid.
#[derive(Debug, Clone, PartialEq)]
pub struct GapMap {
    /// The grid.
    pub grid: Grid,
    /// Gap \[m\] at each point, row by row; contact where it is not above 0, and where it is missing (NaN).
    pub gaps_m: Vec<f64>,
    /// Conditions at the edges of the surface that was pressed or measured, if they are known.
    pub own_edges: Option<FlowEdges>,
    /// Assumptions made on reading.
    pub notes: Vec<Remark>,
    /// The file with its SHA-256; empty if there is none.
    pub provenance: String,
}

impl GapMap {
    /// Reads a map of gaps: the channel `gap` of files that have one, unless another is asked for, and else the heights. A line is a
    /// gap that does not change across.
    ///
    /// # Errors
    /// [`GapMapError`] with the file.
    pub fn read(request: &ScanRequest, files: &dyn Files) -> Result<Self, GapMapError> {
        request.check_takes(&["unit", "height-unit", "channel", "size"])?;
        let of_gaps = ScanRequest { channel: Some(GAP_CHANNEL.to_owned()), ..request.clone() };
        // Standard input is read only once.
        let is_looked_for = request.channel.is_none() && request.path != "-";
        let found = if is_looked_for { Loaded::read(&of_gaps, files).ok() } else { None };
        let has_gaps =
            |loaded: &Loaded| loaded.scans.iter().all(|scan| scan.channel.as_deref() == Some(GAP_CHANNEL));
        let Loaded { mut scans, sha256 } = match found.filter(has_gaps) {
            Some(found) => found,
            None => Loaded::read(request, files)?,
        };
        let no_map = |found| GapMapError::NoMap { file: request.path.clone(), found };
        let (Some(file), 0) = (scans.pop(), scans.len()) else {
            return Err(no_map(format!("it holds {} scans", scans.len() + 1)));
        };
        if file.scan.positions_m().is_some() {
            return Err(no_map("its points are unevenly spaced".to_owned()));
        }
        let (columns, rows) = file.scan.points();
        let (rows, (x_m, y_m)) = (rows.unwrap_or(1), file.scan.size_m());
        let y_m = y_m.unwrap_or(x_m / columns as f64 * rows as f64);
        let grid = Grid::new(rows, columns, x_m, y_m).map_err(|error| no_map(error.to_string()))?;
        // Fields of pressed surfaces say whether these repeat themselves; other files only say where they do.
        let is_field = file.channel.as_deref() == Some(GAP_CHANNEL);
        let own_edges = match file.is_periodic {
            true => Some(FlowEdges::Periodic),
            false => is_field.then_some(FlowEdges::Channel),
        };
        let of_file = |note: Remark| note.about([file.name.as_str()]);
        Ok(GapMap {
            grid,
            gaps_m: file.scan.heights_m().map(|gap_m| gap_m.unwrap_or(f64::NAN)).collect(),
            own_edges,
            notes: readings(&file.notes).into_iter().map(of_file).collect(),
            provenance: format!("gaps: {} ({}), SHA-256 {sha256}", request.path, file.format),
        })
    }

    /// Solves the flow under these conditions; without any, under its own, or else as if the gaps repeated themselves.
    ///
    /// Columns: `flow_factor_x, flow_factor_y, flow_factor_x_error, flow_factor_y_error, mean_gap_m, closed_fraction, open_along_x,
    /// open_along_y, residual, iterations`.
    ///
    /// # Errors
    /// [`QuestionError`] for gaps that no surface has, for equations without a solution, and if `progress` cancels.
    pub fn flow(
        &self,
        edges: Option<FlowEdges>,
        progress: &dyn Progress,
    ) -> Result<(GapFlow, Answer), QuestionError> {
        let gap = field(self.grid, &self.gaps_m)?;
        let open_m = || self.gaps_m.iter().copied().filter(|gap_m| *gap_m > 0.0 && gap_m.is_finite());
        if let Some(largest_m) = open_m().reduce(f64::max) {
            let error = |error: OutOfBounds| QuestionError::Other(error.to_string());
            Bound::Magnitude.check("the largest gap in m", largest_m).map_err(error)?;
        }
        let own_edges = self.own_edges.unwrap_or(FlowEdges::Periodic);
        let found = GapFlow::solve(&gap, edges.unwrap_or(own_edges), progress)?;
        let OpenPaths { along_x, along_y } = found.open_paths();
        let iterations = found.along_x.iterations.max(found.along_y.iterations);
        let [x_error, y_error] = found.spacing_errors;
        let columns = [
            ("flow_factor_x", Some(found.along_x.flow_factor)),
            ("flow_factor_y", Some(found.along_y.flow_factor)),
            ("flow_factor_x_error", x_error),
            ("flow_factor_y_error", y_error),
            ("mean_gap_m", Some(gap.mean_gap_m())),
            ("closed_fraction", Some(gap.closed_share())),
            ("open_along_x", Some(f64::from(u8::from(along_x)))),
            ("open_along_y", Some(f64::from(u8::from(along_y)))),
            ("residual", Some(found.residual())),
            ("iterations", Some(iterations as f64)),
        ];
        let table =
            columns.iter().fold(Table::default(), |table, (name, value)| table.with_numbers(name, [*value]));
        let mut notes = self.notes.clone();
        let assumed = match self.own_edges {
            None => Some(RemarkCode::GapTakenPeriodic),
            Some(FlowEdges::Periodic) => None,
            Some(_) => Some(RemarkCode::GapInChannel),
        };
        notes.extend(assumed.filter(|_| edges.is_none()).map(Remark::new));
        let points = self.gaps_m.len();
        let closed = (0..points).filter(|&point| gap.gap_m(point) == 0.0).count();
        if closed > 0 {
            let reasons = [
                ("missing", self.gaps_m.iter().filter(|gap_m| !gap_m.is_finite()).count()),
                ("tiny", open_m().count() - (points - closed)),
            ];
            let note = Remark::new(RemarkCode::ClosedGaps).with("closed", closed).with("points", points);
            let given = reasons.into_iter().filter(|(_, count)| *count > 0);
            notes.push(given.fold(note, |note, (name, count)| note.with(name, count)));
        }
        let negative = self.gaps_m.iter().filter(|gap_m| **gap_m < 0.0).count();
        // Elements that overlap by rounding leave few.
        if negative as f64 > MOST_NEGATIVE * points as f64 {
            let note = Remark::new(RemarkCode::GapsBelowZero).with("negative", negative);
            notes.push(note.with("points", points));
        }
        Ok((found, Answer { table, notes, figure: None }))
    }
}

/// Flow factors of one surface under one load.
#[derive(Debug, Clone, Copy)]
struct SurfaceFlow {
    load: usize,
    surface: usize,
    factors: [f64; 2],
    errors: [Option<f64>; 2],
    residual: f64,
}

/// Flow through the gaps of surfaces while they are pressed.
#[derive(Debug)]
pub struct PressedFlow {
    edges: FlowEdges,
    is_chosen: bool,
    found: Mutex<Vec<SurfaceFlow>>,
}

impl PressedFlow {
    /// Takes conditions at the edges; without any, gaps of surfaces that repeat themselves are periodic, and all others channels.
    ///
    /// # Errors
    /// [`QuestionError`] for surfaces with missing points, where the gap is unknown.
    pub fn new(edges: Option<FlowEdges>, surfaces: &Surfaces) -> Result<Self, QuestionError> {
        let mut own = FlowEdges::Periodic;
        if let Surfaces::Maps(maps) = surfaces {
            let missing: usize =
                maps.iter().flat_map(|map| &map.is_missing).filter(|is_missing| **is_missing).count();
            if missing > 0 {
                return Err(QuestionError::Other(format!(
                    "flow: {missing} points of the map have no height, and the gap there is unknown; fill them (gaps=harmonic behind the file)"
                )));
            }
            if maps.iter().any(|map| map.boundary == Boundary::Free) {
                own = FlowEdges::Channel;
            }
        }
        let is_chosen = edges.is_some();
        Ok(PressedFlow { edges: edges.unwrap_or(own), is_chosen, found: Mutex::default() })
    }

    /// Solves the flow of one surface under one load, and keeps its factors.
    ///
    /// # Errors
    /// [`QuestionError`] for equations without a solution, and if `progress` cancels.
    pub fn solve(&self, field: &ContactField<'_>, progress: &dyn Progress) -> Result<GapFlow, QuestionError> {
        let gap = GapField::from_contact(field).map_err(|error| QuestionError::Other(error.to_string()))?;
        let flow = GapFlow::solve(&gap, self.edges, &NestedProgress(progress))?;
        self.found.lock().unwrap_or_else(PoisonError::into_inner).push(SurfaceFlow {
            load: field.load,
            surface: field.surface,
            factors: [flow.along_x.flow_factor, flow.along_y.flow_factor],
            errors: flow.spacing_errors,
            residual: flow.residual(),
        });
        Ok(flow)
    }

    /// Returns the means of the surfaces under each load, with paths that are open if fluid flows. The notes on paths are those of the flow
    /// as well.
    #[must_use]
    pub(crate) fn means(self, loads: &mut [PressedLoad], notes: &mut Vec<Remark>) -> Vec<MeanFlow> {
        let found = self.settled(loads, notes);
        found.chunk_by(|one, next| one.load == next.load).map(MeanFlow::new).collect()
    }

    /// Makes the table of pressed surfaces, of their means or of each, with the flow factors.
    ///
    /// Further columns: `flow_factor_x, flow_factor_y`, of means `flow_factor_x_sd, flow_factor_y_sd` (standard deviation over the
    /// surfaces), `flow_factor_x_error, flow_factor_y_error` (mean error by the spacing of the points), and `flow_residual`.
    #[must_use]
    pub fn table(self, loads: &mut [PressedLoad], notes: &mut Vec<Remark>, of_each: bool) -> Table {
        let found = self.settled(loads, notes);
        let is_together = |one: &SurfaceFlow, next: &SurfaceFlow| !of_each && one.load == next.load;
        let groups: Vec<&[SurfaceFlow]> = found.chunk_by(is_together).collect();
        let means: Vec<MeanFlow> = groups.iter().copied().map(MeanFlow::new).collect();
        let mut table = if of_each { states_table(loads) } else { means_table(loads) };
        for (axis, name) in ["flow_factor_x", "flow_factor_y"].into_iter().enumerate() {
            table = table.with_numbers(name, means.iter().map(|mean| mean.factors[axis]));
        }
        if !of_each {
            for (axis, name) in ["flow_factor_x_sd", "flow_factor_y_sd"].into_iter().enumerate() {
                table = table.with_numbers(name, means.iter().map(|mean| mean.deviations[axis]));
            }
        }
        for (axis, name) in ["flow_factor_x_error", "flow_factor_y_error"].into_iter().enumerate() {
            table = table.with_numbers(name, means.iter().map(|mean| mean.errors[axis]));
        }
        let residual = |group: &&[SurfaceFlow]| group.iter().map(|flow| flow.residual).fold(0.0, f64::max);
        table.with_numbers("flow_residual", groups.iter().map(residual))
    }

    /// Sorts the flows by load and surface, and tells loads and notes of them.
    fn settled(self, loads: &mut [PressedLoad], notes: &mut Vec<Remark>) -> Vec<SurfaceFlow> {
        let mut found = self.found.into_inner().unwrap_or_else(PoisonError::into_inner);
        found.sort_by_key(|flow| (flow.load, flow.surface));
        for SurfaceFlow { load, surface, factors: [along_x, along_y], .. } in &found {
            loads[*load].states[*surface].open =
                OpenPaths { along_x: *along_x > 0.0, along_y: *along_y > 0.0 };
        }
        notes.retain(|note| note.code != RemarkCode::ClosedPaths);
        if !self.is_chosen && self.edges == FlowEdges::Channel {
            notes.push(Remark::new(RemarkCode::FlowInChannel));
        }
        notes.extend(closed_from(loads));
        found
    }
}

/// Flow factors along x and y: means of surfaces, their standard deviations, and the mean errors by the spacing of the points.
#[derive(Debug, Clone, Copy)]
pub(crate) struct MeanFlow {
    pub factors: [f64; 2],
    pub deviations: [Option<f64>; 2],
    pub errors: [Option<f64>; 2],
}

impl MeanFlow {
    fn new(flows: &[SurfaceFlow]) -> Self {
        let factors = |axis: usize| flows.iter().map(move |flow| flow.factors[axis]);
        let error = |axis: usize| {
            let errors: Option<Vec<f64>> = flows.iter().map(|flow| flow.errors[axis]).collect();
            errors.map(|errors| mean(errors.into_iter()))
        };
        MeanFlow {
            factors: [0, 1].map(|axis| mean(factors(axis))),
            deviations: [0, 1].map(|axis| deviation(factors(axis))),
            errors: [0, 1].map(error),
        }
    }
}

fn mean(values: impl ExactSizeIterator<Item = f64>) -> f64 {
    let count = values.len() as f64;
    values.sum::<f64>() / count
}

/// Standard deviation; `None` of a single value.
fn deviation(values: impl ExactSizeIterator<Item = f64> + Clone) -> Option<f64> {
    let mean = mean(values.clone());
    let freedom = values.len() - 1;
    (freedom > 0).then(|| (values.map(|value| (value - mean).powi(2)).sum::<f64>() / freedom as f64).sqrt())
}

/// The areas up to which paths are open, and from which they are closed; `None` if every surface is open under every load.
fn closed_from(loads: &[PressedLoad]) -> Option<Remark> {
    let along = |name: &str, is_open: fn(&OpenPaths) -> bool| {
        // Areas under which at least one surface is open, or closed.
        let areas = |open: bool| {
            let has_one =
                move |load: &&PressedLoad| load.states.iter().any(|state| is_open(&state.open) == open);
            loads.iter().filter(has_one).map(|load| load.mean().best_area_fraction())
        };
        let first_closed = areas(false).reduce(f64::min)?;
        let last_open = areas(true).fold(f64::NEG_INFINITY, f64::max);
        let up_to = areas(true).filter(|area| *area < first_closed).reduce(f64::max);
        let from = areas(false).filter(|area| *area > last_open).reduce(f64::min);
        let [every, none] = if loads.iter().any(|load| load.states.len() > 1) {
            ["open on every surface", "on none"]
        } else {
            ["open", "closed"]
        };
        let up_to = up_to.map(|area| format!("{every} up to A = {}", three_digits(area)));
        let from = from.map(|area| format!("{none} from A = {}", three_digits(area)));
        let clauses: Vec<String> = up_to.into_iter().chain(from).collect();
        let some = format!("on some surfaces from A = {}", three_digits(first_closed));
        Some(format!("along {name} {}", if clauses.is_empty() { some } else { clauses.join(", ") }))
    };
    let both = [along("x", |open| open.along_x), along("y", |open| open.along_y)];
    let clauses: Vec<String> = both.into_iter().flatten().collect();
    (!clauses.is_empty()).then(|| Remark::new(RemarkCode::FlowPaths).with("paths", clauses.join("; ")))
}
