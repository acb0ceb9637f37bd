//! Draws of uncertain results: their numbers, and the promises of intervals and shares.

use uncertainty::quantiles::{Interval, area_interval_about, interval};
use uncertainty::sobol::indices;

use crate::tally::{Case, Refused, Trial};
use crate::{Draw, Reach};

/// Draws and a level; printed, it is a literal that recreates it.
#[derive(Debug, Clone, PartialEq)]
pub struct IntervalsCase {
    /// Draws: of any quantity, and with a sign changed where they are above 0, of the logarithm of an area.
    pub draws: Vec<f64>,
    /// Result of the best estimates.
    pub best: f64,
    /// Share of the draws that an interval holds.
    pub level: f64,
}

impl Case for IntervalsCase {
    fn draw(draw: &mut Draw) -> (Self, Reach) {
        const MOST_DRAWS: f64 = 60.0;
        let reach = Reach::draw(draw);
        let count = draw.one_of(&[1.0, 2.0, 3.0, MOST_DRAWS, MOST_DRAWS]);
        let count = draw.between(1.0, count + 1.0) as usize;
        let size = reach.number(draw, -12.0, 12.0);
        let centre = draw.one_of(&[-1.0, 1.0]) * size;
        let width = match reach {
            Reach::Usual => draw.decades(-3.0, 0.0),
            _ => draw.decades(-17.0, 8.0),
        };
        let kind = draw.between(0.0, 6.0) as usize;
        let mut one = || match kind {
            0 => centre,
            1 => draw.one_of(&[centre, centre.next_up()]),
            2 => draw.one_of(&[centre, centre * (1.0 + width)]),
            3 => draw.one_of(&[-1.0, 1.0]) * draw.decades(-300.0, 300.0),
            _ => centre * (1.0 + width * (draw.between(-1.0, 1.0) + draw.between(-1.0, 1.0))),
        };
        let draws: Vec<f64> = (0..count).map(|_| one().clamp(-1e300, 1e300)).collect();
        let far = centre * draw.decades(-3.0, 3.0);
        let best = draw.one_of(&[draws[0], centre, far]);
        let any = draw.between(0.01, 0.999);
        (IntervalsCase { draws, best, level: draw.one_of(&[0.95, 0.68, any, 1e-9, 1.0 - 1e-9]) }, reach)
    }

    fn test(trial: &mut Trial<Self>) -> Result<(), Refused> {
        let case = trial.case;
        let lowest = case.draws.iter().copied().fold(f64::INFINITY, f64::min);
        let highest = case.draws.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let Some(plain) = interval(&case.draws, case.level) else {
            trial.hold("draws have an interval", false);
            return Ok(());
        };
        sound(&plain, trial);
        let inside = lowest <= plain.low.value && plain.high.value <= highest;
        trial.hold("ends within the draws", inside);
        if lowest == highest {
            let errors = [plain.low, plain.median, plain.high].map(|end| end.standard_error);
            trial.hold(
                "equal draws have no width and no error",
                errors == [0.0; 3] && plain.low == plain.high,
            );
        }
        let mut turned = case.draws.clone();
        turned.reverse();
        trial.hold("the order of the draws does not matter", interval(&turned, case.level) == Some(plain));
        let power = 2f64.powi(trial.draw.between(-20.0, 20.0) as i32);
        let scaled: Vec<f64> = case.draws.iter().map(|value| power * value).collect();
        if trial.reach != Reach::Edge
            && let Some(there) = interval(&scaled, case.level)
        {
            let pairs = [(there.low, plain.low), (there.median, plain.median), (there.high, plain.high)];
            let same = pairs.iter().all(|(there, here)| there.value == power * here.value);
            let normal = case.draws.iter().all(|value| (1e-250..1e250).contains(&value.abs()));
            trial.hold("units do not matter", same || !normal);
        }
        of_area(trial);
        shares(trial);
        Ok(())
    }
}

/// Checks the order of the ends and their errors.
fn sound(interval: &Interval, trial: &mut Trial<IntervalsCase>) {
    let Interval { low, median, high, length_standard_error } = *interval;
    trial.hold("low, median, high", low.value <= median.value && median.value <= high.value);
    let errors = [low.standard_error, median.standard_error, high.standard_error, length_standard_error];
    trial.hold("errors no NaN, at least 0", errors.iter().all(|error| *error >= 0.0));
    trial.hold("relative error no NaN", interval.relative_error() >= 0.0);
    let values = [low.value, median.value, high.value];
    trial.hold("ends finite", values.iter().all(|value| value.is_finite()));
}

/// Checks the interval of the logarithm of an area.
fn of_area(trial: &mut Trial<IntervalsCase>) {
    let case = trial.case;
    // Areas are doubles: their logarithms are at least -745.
    let negative = |value: &f64| -value.abs().min(745.0);
    let logarithms: Vec<f64> = case.draws.iter().map(negative).collect();
    let best = negative(&case.best);
    let Some(about) = area_interval_about(best, &logarithms, case.level) else {
        trial.hold("draws have an interval of the area", false);
        return;
    };
    sound(&about, trial);
    trial.hold("an area stays at most 1", about.high.value <= 0.0);
    if logarithms.iter().all(|value| *value == logarithms[0]) {
        trial.hold("equal areas have no width", about.low.value == about.high.value);
    }
}

/// Checks the shares of a group that does everything, and of one that does nothing.
fn shares(trial: &mut Trial<IntervalsCase>) {
    let case = trial.case;
    let half = case.draws.len() / 2;
    let (a, b) = (&case.draws[..half], &case.draws[half..]);
    let mixed: Vec<f64> =
        a.iter().zip(b).map(|(a, b)| if trial.draw.chance(0.5) { *a } else { *b }).collect();
    for (ab, total) in [(a, Some(0.0)), (&b[..half], Some(1.0)), (&mixed[..], None)] {
        let found = indices(a, b, ab);
        for index in [found.first_order, found.total] {
            trial.hold("indices finite", index.value.is_finite() && index.standard_error >= 0.0);
        }
        let known = found.total.standard_error < 1.0 && found.total.standard_error > 0.0;
        if let (Some(total), true) = (total, known) {
            let value = if total == 0.0 { found.total.value } else { found.first_order.value };
            trial.bound("indices of everything and of nothing", (value - total).abs(), 1e-6);
        }
    }
}
