//! Scans with missing points: their heights, and the promises from heights to spectra.

use scans::{NonuniformLineScan, Scan, ScanFile};
use topography::{
    BandLimits, CompositeSpectrum, Detrend, GapTreatment, Preparation, Recipe, ScanSpectrum, TransformError,
    Window, areal_spectrum, line_spectrum, without_gaps,
};

use crate::drawn_scan::DrawnScan;
use crate::tally::{Case, Refused, Trial};
use crate::{Draw, Reach};

/// Scan and its treatment; printed, it is a literal that recreates it.
#[derive(Debug, Clone, PartialEq)]
pub struct ScansCase {
    /// The scan.
    pub scan: DrawnScan,
    /// Treatment of missing points.
    pub treatment: GapTreatment,
    /// Preparation of the heights.
    pub preparation: Preparation,
}

impl ScansCase {
    fn recipe(&self) -> Recipe {
        Recipe {
            detrend: Some(self.preparation.detrend),
            window: Some(self.preparation.window),
            gaps: self.treatment,
            ..Recipe::default()
        }
    }

    /// Complete scan.
    fn complete(&self, at_missing_m: f64) -> Option<Result<ScanFile<Scan>, TransformError>> {
        let file = self.scan.file(at_missing_m)?;
        if let Some(positions_m) = &self.scan.positions_m {
            let line = NonuniformLineScan::new(positions_m.clone(), self.scan.heights_m.clone()).ok()?;
            return Some(file.try_map(|_| Ok(Scan::NonuniformLine(line))));
        }
        Some(without_gaps(file, self.treatment))
    }
}

impl Case for ScansCase {
    fn draw(draw: &mut Draw) -> (Self, Reach) {
        let reach = Reach::draw(draw);
        let scan = DrawnScan::draw(draw, reach);
        let preparation =
            Preparation { detrend: draw.one_of(Detrend::ALL), window: draw.one_of(Window::ALL) };
        (ScansCase { scan, treatment: draw.one_of(GapTreatment::ALL), preparation }, reach)
    }

    fn test(trial: &mut Trial<Self>) -> Result<(), Refused> {
        let case = trial.case;
        let Some(file) = case.complete(0.0) else {
            return Err(Refused);
        };
        let junk_m = trial.draw.one_of(&[-1.0, 1.0]) * trial.draw.decades(-30.0, 30.0);
        let again = case.complete(junk_m);
        let file = match file {
            Ok(file) => file,
            Err(error) => {
                refused_for_a_reason(&error, trial);
                trial.hold("missing points have no value", again.is_some_and(|again| again.is_err()));
                return Err(Refused);
            }
        };
        let same = again.and_then(Result::ok).is_some_and(|again| again.scan == file.scan);
        trial.hold("missing points have no value", same);
        filled_within(&file.scan, trial);
        let spectrum = line_spectrum(&file.scan, case.preparation);
        let densities = &spectrum.c1d_m3;
        if trial.reach != Reach::Edge {
            trial.hold(
                "densities finite, at least 0",
                densities.iter().all(|value| *value >= 0.0 && value.is_finite()),
            );
            let share = spectrum.parseval_share();
            let is_even = spectrum.spacing_m.is_some();
            let largest_m =
                case.scan.heights_m.iter().fold(0.0f64, |most, height_m| most.max(height_m.abs()));
            // A variance that rounding left has no digits.
            if is_even && spectrum.variance_m2 > 1e-280 && spectrum.variance_m2.sqrt() > 1e-7 * largest_m {
                trial.bound("Parseval", (share - 1.0).abs(), 1e-9);
            }
        } else {
            trial.hold("densities no NaN", densities.iter().all(|value| !value.is_nan()));
        }
        if let Scan::Map(map) = &file.scan {
            let areal = areal_spectrum(map, case.preparation);
            let sound = areal.bins.iter().all(|bin| bin.ciso_m4() >= 0.0);
            trial.hold("densities of the area no NaN, at least 0", sound);
        }
        whole_way(file, trial);
        if trial.reach != Reach::Edge {
            scaled(densities, trial);
        }
        Ok(())
    }
}

/// Checks that a scan is refused only with missing points, or for what it is.
fn refused_for_a_reason(error: &TransformError, trial: &mut Trial<ScansCase>) {
    let case = trial.case;
    let missing = case.scan.missing.len();
    let reason = match error {
        TransformError::Gaps(_) => {
            matches!(case.treatment, GapTreatment::Refuse | GapTreatment::Keep) && missing > 0
        }
        TransformError::TooManyGaps { share, bound } => {
            share > bound && case.treatment == GapTreatment::Harmonic
        }
        TransformError::NoHeights { points } => missing == *points,
        TransformError::NoLines { .. } => case.treatment == GapTreatment::Lines && missing > 0,
        _ => false,
    };
    trial.hold("a scan is refused for its missing points", reason);
}

/// Checks the maximum principle of filled heights.
fn filled_within(scan: &Scan, trial: &mut Trial<ScansCase>) {
    let case = trial.case;
    let filled_m = match scan {
        Scan::Map(map) => map.heights_m(),
        Scan::UniformLine(line) => line.heights_m(),
        Scan::NonuniformLine(_) | Scan::Lines(_) => return,
    };
    let measured = (0..filled_m.len()).filter(|point| !case.scan.missing.contains(point));
    let (mut lowest_m, mut highest_m) = (f64::INFINITY, f64::NEG_INFINITY);
    for point in measured {
        trial.hold("measured heights stay", filled_m[point] == case.scan.heights_m[point]);
        (lowest_m, highest_m) = (lowest_m.min(filled_m[point]), highest_m.max(filled_m[point]));
    }
    let rounding_m = 1e-9 * (highest_m - lowest_m) + 1e-14 * lowest_m.abs().max(highest_m.abs());
    for &point in &case.scan.missing {
        let over_m = (filled_m[point] - highest_m).max(lowest_m - filled_m[point]);
        trial.bound("filled heights between the measured ones", over_m, rounding_m);
    }
}

/// Checks the way from a complete scan to the composite spectrum.
fn whole_way(file: ScanFile<Scan>, trial: &mut Trial<ScansCase>) {
    let case = trial.case;
    let recipe = case.recipe();
    let Ok(spectrum) = ScanSpectrum::new(file, BandLimits::default(), &recipe) else { return };
    let _ = spectrum.remarks();
    match CompositeSpectrum::new(vec![spectrum], &recipe) {
        Err(error) => trial.hold("one spectrum makes a composite", is_known(&error)),
        Ok(composite) => {
            let _ = composite.remarks();
            let bins = &composite.composite.bins;
            trial.hold(
                "bins finite, above 0",
                bins.iter().all(|bin| bin.c1d_m3 > 0.0 && bin.c1d_m3.is_finite()),
            );
            let errors = bins.iter().filter_map(|bin| bin.standard_error_m3);
            trial.hold("errors of bins no NaN", errors.into_iter().all(|error| error >= 0.0));
        }
    }
}

fn is_known(error: &TransformError) -> bool {
    matches!(
        error,
        TransformError::SingleBin { .. }
            | TransformError::NothingReliable { .. }
            | TransformError::Overflow(_)
            | TransformError::BeyondNumbers
    )
}

/// Checks that units do not matter.
fn scaled(densities: &[f64], trial: &mut Trial<ScansCase>) {
    let case = trial.case;
    let [length, height] = [0, 1].map(|_| 2f64.powi(trial.draw.between(-15.0, 15.0) as i32));
    let other = ScansCase { scan: case.scan.scaled(length, height), ..case.clone() };
    let Some(Ok(file)) = other.complete(0.0) else {
        trial.hold("units do not matter", false);
        return;
    };
    let spectrum = line_spectrum(&file.scan, other.preparation);
    let largest = densities.iter().copied().fold(0.0, f64::max);
    if !(1e-250..1e250).contains(&largest) || spectrum.c1d_m3.len() != densities.len() {
        trial.hold("units do not matter", spectrum.c1d_m3.len() == densities.len());
        return;
    }
    let off = spectrum.c1d_m3.iter().zip(densities);
    let off = off.map(|(there, here)| (there / (length * height * height) - here).abs()).fold(0.0, f64::max);
    trial.bound("units do not matter", off / largest, 1e-10);
}
