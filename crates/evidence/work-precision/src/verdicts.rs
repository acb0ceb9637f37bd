//! Competitors that are both faster and more accurate than we are, if any, and our lead where all are right.

use crate::point::{Engine, GivenQuantity, Point};

/// Laws on the work-precision plots.
pub const FOUR_LAWS: [&str; 4] = ["hertz", "ep-sphere", "elastic-sine", "ep-sine"];

/// Comparison of the points of a competitor with ours.
#[derive(Debug, Clone, PartialEq)]
pub struct Standing<'a> {
    /// Engine of the competitor.
    pub engine: Engine,
    /// Engine of ours that it is compared with.
    pub against: Engine,
    /// Number of right answers.
    pub right: usize,
    /// Number of wrong answers.
    pub wrong: usize,
    /// Number of questions without an answer.
    pub failed: usize,
    /// Right answers that are both faster and more accurate than some answer of ours.
    pub ahead: Vec<&'a Point>,
    /// Right answers that no answer of ours matches in both speed and accuracy, except for rounding: its part of the
    /// front.
    pub unmatched: Vec<&'a Point>,
}

/// Compares a competitor with some of our points.
pub fn standing(points: &[Point], engine: Engine, against: Engine) -> Standing<'_> {
    let theirs = || points.iter().filter(|point| point.engine == engine);
    let ours: Vec<&Point> = points.iter().filter(|point| point.engine == against).collect();
    let right: Vec<&Point> = theirs().filter(|point| point.error().is_some()).collect();
    let failed = theirs().filter(|point| matches!(point.outcome, crate::point::Outcome::Failed(_))).count();
    let comparable =
        |point: &Point| ours.iter().copied().filter(|our| our.same_question(point)).collect::<Vec<_>>();
    Standing {
        engine,
        against,
        wrong: theirs().count() - right.len() - failed,
        failed,
        ahead: right.iter().copied().filter(|p| comparable(p).iter().any(|our| dominates(p, our))).collect(),
        unmatched: right
            .iter()
            .copied()
            .filter(|p| !comparable(p).iter().any(|our| matches(our, p)))
            .collect(),
        right: right.len(),
    }
}

/// Returns true if a right answer is both faster and more accurate than another.
fn dominates(a: &Point, b: &Point) -> bool {
    match (a.error(), b.error()) {
        (Some(error), Some(other)) => a.seconds < b.seconds && error < other,
        _ => false,
    }
}

/// Returns true if an answer is at least as fast and as accurate as another, where errors within rounding are equal.
fn matches(our: &Point, their: &Point) -> bool {
    let rounding = rounding(their.separation_over_sigma);
    match (our.error(), their.error()) {
        (Some(error), Some(other)) => our.seconds <= their.seconds && error <= other.max(rounding),
        _ => false,
    }
}

/// Relative change of the pressure by the last bits of a separation: it falls like exp(-u^2/2).
fn rounding(separation_over_sigma: f64) -> f64 {
    4.0 * f64::EPSILON * separation_over_sigma.powi(2).max(1.0)
}

/// Mean seconds of an engine over the right answers to a question about a law; `None` without any.
pub fn mean_seconds(
    points: &[Point],
    engine: Engine,
    setting: f64,
    law: &str,
    given: GivenQuantity,
) -> Option<f64> {
    mean(selected(points, engine, setting, law, given).filter(|p| p.error().is_some()).map(|p| p.seconds))
}

/// Worst error of an engine over the right answers to a question about a law; `None` without any.
pub fn worst_error(
    points: &[Point],
    engine: Engine,
    setting: f64,
    law: &str,
    given: GivenQuantity,
) -> Option<f64> {
    selected(points, engine, setting, law, given).filter_map(Point::error).reduce(f64::max)
}

/// Mean seconds over the four laws with equal weight; `None` if one of them is missing.
pub fn mean_of_four(points: &[Point], engine: Engine, setting: f64, given: GivenQuantity) -> Option<f64> {
    let means = FOUR_LAWS.map(|law| mean_seconds(points, engine, setting, law, given));
    means.into_iter().sum::<Option<f64>>().map(|sum| sum / FOUR_LAWS.len() as f64)
}

fn selected<'a>(
    points: &'a [Point],
    engine: Engine,
    setting: f64,
    law: &'a str,
    given: GivenQuantity,
) -> impl Iterator<Item = &'a Point> {
    points.iter().filter(move |point| {
        point.engine == engine && point.setting == setting && point.law == law && point.given == given
    })
}

fn mean(values: impl Iterator<Item = f64>) -> Option<f64> {
    let (sum, count) = values.fold((0.0, 0u32), |(sum, count), value| (sum + value, count + 1));
    (count > 0).then(|| sum / f64::from(count))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::point::Outcome;

    fn point(engine: Engine, seconds: f64, error: f64) -> Point {
        Point {
            population: "steel".to_owned(),
            law: "hertz".to_owned(),
            given: GivenQuantity::Separation,
            separation_over_sigma: 0.0,
            engine,
            setting: 1e-8,
            seconds,
            outcome: if error <= 1e-2 { Outcome::Right(error) } else { Outcome::Wrong(error) },
        }
    }

    #[test]
    fn a_slower_and_a_less_accurate_competitor_are_matched() {
        let points = [
            point(Engine::Ours, 1e-6, 1e-12),
            point(Engine::Ours, 5e-7, 1e-6),
            point(Engine::Quad, 1e-3, 1e-8),
            point(Engine::Quad, 1e-3, 1e-15),
        ];
        let standing = standing(&points, Engine::Quad, Engine::Ours);
        assert_eq!((standing.right, standing.ahead.len()), (2, 0));
        assert_eq!(standing.unmatched, [&points[3]], "three digits more than we have");
    }

    #[test]
    fn errors_within_rounding_are_the_same() {
        let points = [point(Engine::Ours, 1e-6, 8e-16), point(Engine::Quad, 1e-3, 1e-16)];
        assert!(standing(&points, Engine::Quad, Engine::Ours).unmatched.is_empty());
    }

    #[test]
    fn a_faster_and_more_accurate_competitor_is_listed_and_a_wrong_one_is_not() {
        let points = [
            point(Engine::Ours, 1e-6, 1e-5),
            point(Engine::GridBatch, 5e-7, 1e-6),
            point(Engine::GridBatch, 1e-9, 0.5),
        ];
        let standing = standing(&points, Engine::GridBatch, Engine::Ours);
        assert_eq!((standing.right, standing.wrong), (1, 1));
        assert_eq!((standing.ahead, standing.unmatched), (vec![&points[1]], vec![&points[1]]));
    }

    #[test]
    fn only_answers_to_the_same_question_are_compared() {
        let ours = point(Engine::Ours, 1e-6, 1e-5);
        let other = Point { separation_over_sigma: 3.0, ..point(Engine::Quad, 5e-7, 1e-6) };
        let points = [ours, other];
        let standing = standing(&points, Engine::Quad, Engine::Ours);
        assert!(standing.ahead.is_empty());
        assert_eq!(standing.unmatched.len(), 1);
    }

    #[test]
    fn a_mean_of_four_laws_needs_all_of_them() {
        let points: Vec<Point> = FOUR_LAWS
            .iter()
            .map(|law| Point { law: (*law).to_owned(), ..point(Engine::Quad, 2e-3, 0.0) })
            .collect();
        let mean = |points: &[Point]| mean_of_four(points, Engine::Quad, 1e-8, GivenQuantity::Separation);
        assert_eq!(mean(&points), Some(2e-3));
        assert_eq!(mean(&points[..3]), None);
    }
}
