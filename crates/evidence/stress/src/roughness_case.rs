//! Roughness parameters of small and degenerate scans: their promises.

use std::collections::BTreeMap;

use roughness::{
    Evaluation, FormRemoval, HeightParameters, MaterialRatioCurve, Parameter, ScaleLimitedSurface,
    ScaleLimitedSurfaceError, parameters,
};
use scans::{NonuniformLineScan, Scan};

use crate::drawn_scan::DrawnScan;
use crate::tally::{Case, Refused, Trial};
use crate::{Draw, Reach};

/// Height \[m\] near the smallest double, where digits are lost.
const TINY_M: f64 = 1e-300;

/// Rounding \[m\] of a mean of heights below the normal doubles, where it does not shrink with them: four smallest doubles.
const DENORMAL_M: f64 = 4.0 * 5e-324;

/// Scan and how it is evaluated; printed, it is a literal that recreates it.
#[derive(Debug, Clone, PartialEq)]
pub struct RoughnessCase {
    /// The scan.
    pub scan: DrawnScan,
    /// Form that is subtracted.
    pub form: FormRemoval,
    /// Cut-offs \[m\] of the filters against long and short waves.
    pub cutoffs_m: [Option<f64>; 2],
}

impl RoughnessCase {
    fn evaluation(&self) -> Evaluation {
        let [longest_m, shortest_m] = self.cutoffs_m;
        Evaluation { form: self.form, longest_m, shortest_m }
    }

    fn relief(&self, at_missing_m: f64) -> Option<Result<ScaleLimitedSurface, ScaleLimitedSurfaceError>> {
        let measured = match &self.scan.positions_m {
            Some(positions_m) => {
                let line = NonuniformLineScan::new(positions_m.clone(), self.scan.heights_m.clone()).ok()?;
                Scan::NonuniformLine(line).into()
            }
            None => self.scan.file(at_missing_m)?.scan,
        };
        Some(ScaleLimitedSurface::new(&measured, &self.evaluation()))
    }

    /// First values of all parameters.
    fn values(&self) -> Option<BTreeMap<&'static str, f64>> {
        let relief = self.relief(0.0)?.ok()?;
        Some(values(&parameters(&relief, 0.0)))
    }
}

fn values(parameters: &[Parameter]) -> BTreeMap<&'static str, f64> {
    let first = parameters.iter().filter(|parameter| parameter.is_first);
    first.filter_map(|parameter| Some((parameter.symbol, parameter.value.known()?))).collect()
}

impl Case for RoughnessCase {
    fn draw(draw: &mut Draw) -> (Self, Reach) {
        let reach = Reach::draw(draw);
        let scan = DrawnScan::draw(draw, reach);
        let mut cutoff_m = |share: f64| draw.chance(share).then(|| scan.length_x_m * draw.decades(-2.0, 0.3));
        let cutoffs_m = [cutoff_m(0.3), cutoff_m(0.2)];
        (RoughnessCase { scan, form: draw.one_of(FormRemoval::ALL), cutoffs_m }, reach)
    }

    fn test(trial: &mut Trial<Self>) -> Result<(), Refused> {
        let case = trial.case;
        let Some(relief) = case.relief(0.0) else {
            return Err(Refused);
        };
        let relief = match relief {
            Ok(relief) => relief,
            Err(error) => {
                let has_none = case.scan.missing.len() == case.scan.heights_m.len();
                let is_filtered = case.cutoffs_m.iter().any(Option::is_some);
                let is_empty = error == ScaleLimitedSurfaceError::NoHeights;
                let is_cut =
                    case.scan.rows.is_none() && case.cutoffs_m[0].is_some() && !case.scan.missing.is_empty();
                let reason = if is_empty { has_none || is_cut } else { is_filtered };
                trial.hold("a scan is refused for what it is", reason);
                return Err(Refused);
            }
        };
        let all = parameters(&relief, 0.0);
        let known = all.iter().filter_map(|parameter| parameter.value.known());
        if trial.reach == Reach::Edge {
            trial.hold("parameters no NaN", known.into_iter().all(|value| !value.is_nan()));
            return Ok(());
        }
        trial.hold("parameters finite", known.into_iter().all(f64::is_finite));
        let junk_m = trial.draw.one_of(&[-1.0, 1.0]) * trial.draw.decades(-30.0, 30.0);
        let again = case.relief(junk_m).and_then(Result::ok);
        trial.hold("missing points have no value", again.is_some_and(|again| again == relief));
        let found = values(&all);
        ordered(&found, trial);
        curve(&relief, trial);
        turned(&found, trial);
        scaled(&found, trial);
        heights_alone(&found, trial);
        Ok(())
    }
}

/// Checks bounds and orders of parameters, of maps and of profiles alike.
fn ordered(found: &BTreeMap<&str, f64>, trial: &mut Trial<RoughnessCase>) {
    let of = |areal: &str, profile: &str| found.get(areal).or_else(|| found.get(profile)).copied();
    if let (Some(mean), Some(rms), Some(total)) = (of("Sa", "Ra"), of("Sq", "Rq"), of("Sz", "Rt")) {
        trial.bound("Sa at most Sq", mean, rms * (1.0 + 1e-12) + DENORMAL_M);
        trial.bound("Sq at most Sz", rms, total * (1.0 + 1e-12) + DENORMAL_M);
        trial.hold("heights at least 0", mean >= 0.0);
    }
    let has_digits = of("Sq", "Rq").is_some_and(|rms_m| rms_m > TINY_M);
    if let (Some(skewness), Some(kurtosis), true) = (of("Ssk", "Rsk"), of("Sku", "Rku"), has_digits) {
        trial.bound("Sku at least 1 + Ssk^2", 1.0 + skewness * skewness, kurtosis * (1.0 + 1e-9));
    }
    for (areal, profile, promise) in [
        ("Spk", "Rpk", "Spk at least 0"),
        ("Svk", "Rvk", "Svk at least 0"),
        ("Sk", "Rk", "Sk at least 0"),
        ("Sdr", "Rdr", "Sdr at least 0"),
        ("Vmp", "", "Vmp at least 0"),
        ("Vmc", "", "Vmc at least 0"),
        ("Vvc", "", "Vvc at least 0"),
        ("Vvv", "", "Vvv at least 0"),
        ("Sdq", "Rdq", "Sdq at least 0"),
        ("Sal", "", "Sal at least 0"),
        ("", "Rz", "Rz at least 0"),
    ] {
        if let Some(value) = of(areal, profile) {
            let size = of("Sz", "Rt").unwrap_or(0.0);
            trial.bound(promise, -value, 1e-12 * size + TINY_M);
        }
    }
    let shares = [of("Smr", "Rmr"), of("Smr1", "Rmr1"), of("Smr2", "Rmr2"), found.get("Str").copied()];
    let inside = shares.iter().flatten().all(|share| (0.0..=1.0).contains(share));
    trial.hold("shares in [0, 1]", inside);
    if let [_, Some(from), Some(to), _] = shares {
        trial.bound("Smr1 at most Smr2", from, to + 1e-12);
    }
}

/// Checks the identity of void and material.
fn curve(relief: &ScaleLimitedSurface, trial: &mut Trial<RoughnessCase>) {
    let curve = MaterialRatioCurve::new(relief);
    let ratio = trial.draw.between(0.0, 1.0);
    let (highest_m, lowest_m) = (curve.height_m(0.0), curve.height_m(1.0));
    let mean_m = curve.material_m(1.0) + lowest_m;
    let size_m = highest_m - lowest_m;
    let off_m = curve.void_m(ratio) - curve.material_m(ratio) - curve.height_m(ratio) + mean_m;
    trial.bound("Vv = Vm + c - mean", off_m.abs(), 1e-12 * size_m + TINY_M);
    let share = curve.share_at_or_above(curve.height_m(ratio));
    trial.hold("share at a height in [0, 1]", (0.0..=1.0).contains(&share));
}

/// Checks that the transposed map has the same parameters.
fn turned(found: &BTreeMap<&str, f64>, trial: &mut Trial<RoughnessCase>) {
    let case = trial.case;
    let Some(rows) = case.scan.rows else { return };
    let columns = case.scan.columns;
    let places: Vec<usize> =
        (0..columns).flat_map(|column| (0..rows).map(move |row| row * columns + column)).collect();
    let scan = DrawnScan {
        columns: rows,
        rows: Some(columns),
        length_x_m: case.scan.length_y_m,
        length_y_m: case.scan.length_x_m,
        heights_m: places.iter().map(|place| case.scan.heights_m[*place]).collect(),
        missing: (0..places.len()).filter(|at| case.scan.missing.contains(&places[*at])).collect(),
        positions_m: None,
    };
    let Some(there) = (RoughnessCase { scan, ..case.clone() }).values() else {
        trial.hold("transposed map", false);
        return;
    };
    same(found, |symbol| there.get(symbol).copied(), "transposed map", trial);
}

/// Checks that units do not matter.
fn scaled(found: &BTreeMap<&str, f64>, trial: &mut Trial<RoughnessCase>) {
    let case = trial.case;
    let size = 2f64.powi(trial.draw.between(-15.0, 15.0) as i32);
    let cutoffs_m = case.cutoffs_m.map(|cutoff_m| cutoff_m.map(|cutoff_m| size * cutoff_m));
    let other = RoughnessCase { scan: case.scan.scaled(size, size), cutoffs_m, ..case.clone() };
    let Some(there) = other.values() else {
        trial.hold("units do not matter", false);
        return;
    };
    let is_length = |symbol: &str| {
        !matches!(symbol, "Ssk" | "Sku" | "Rsk" | "Rku" | "Sdq" | "Rdq" | "Sdr" | "Str")
            && !symbol.starts_with("Smr")
            && !symbol.starts_with("Rmr")
    };
    let at =
        |symbol: &str| there.get(symbol).map(|value| if is_length(symbol) { value / size } else { *value });
    same(found, at, "units do not matter", trial);
}

/// Compares parameters that rounding does not decide.
fn same(
    found: &BTreeMap<&str, f64>,
    there: impl Fn(&str) -> Option<f64>,
    promise: &'static str,
    trial: &mut Trial<RoughnessCase>,
) {
    let case = trial.case;
    let largest_m = case.scan.heights_m.iter().fold(0.0f64, |most, height_m| most.max(height_m.abs()));
    let rms_m = found.get("Sq").or_else(|| found.get("Rq")).copied().unwrap_or(0.0);
    // Parameters of a surface that is flat within rounding have no digits.
    if rms_m < 1e-6 * largest_m || rms_m < 1e-200 {
        return;
    }
    let continuous = ["Sa", "Sq", "Sp", "Sv", "Sz", "Sdq", "Sdr", "Ra", "Rq", "Rp", "Rv", "Rt", "Rdq"];
    for symbol in continuous {
        if let (Some(here), there) = (found.get(symbol), there(symbol)) {
            let off =
                there.map_or(f64::INFINITY, |there| (there - here).abs() / here.abs().max(f64::MIN_POSITIVE));
            let size = if symbol.len() > 2 && *here < 1e-9 { 0.0 } else { off };
            trial.bound(promise, size * rms_m / largest_m, 1e-9);
        }
    }
}

/// Checks that heights alone have the same parameters as a whole evaluation by the default.
fn heights_alone(found: &BTreeMap<&str, f64>, trial: &mut Trial<RoughnessCase>) {
    let case = trial.case;
    if case.form != FormRemoval::Plane || case.cutoffs_m != [None, None] || case.scan.positions_m.is_some() {
        return;
    }
    let Some(file) = case.scan.file(0.0) else { return };
    let Some(heights) = HeightParameters::from_scan(&file.scan) else {
        trial.hold("heights alone", false);
        return;
    };
    let there = values(&heights.parameters());
    same(
        found,
        |symbol| there.get(symbol).copied().or_else(|| found.get(symbol).copied()),
        "heights alone",
        trial,
    );
}
