//! Answer of one engine, compared with its reference.

use crate::reference::State;

/// Error from which an answer is wrong, however fast it was.
pub const WRONG_FROM: f64 = 1e-2;

/// Given quantity of a question.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum GivenQuantity {
    /// The separation: pressure and area are wanted.
    Separation,
    /// The pressure: separation and area are wanted.
    Pressure,
}

impl GivenQuantity {
    /// Both questions.
    pub const ALL: [GivenQuantity; 2] = [GivenQuantity::Separation, GivenQuantity::Pressure];

    /// Name in files.
    pub fn name(self) -> &'static str {
        match self {
            GivenQuantity::Separation => "separation",
            GivenQuantity::Pressure => "pressure",
        }
    }

    /// Question in formula notation.
    pub fn question(self) -> &'static str {
        match self {
            GivenQuantity::Separation => "p(d)",
            GivenQuantity::Pressure => "d(p)",
        }
    }

    /// Larger of the two errors of an answer: relative for pressure and area, in units of sigma for the separation.
    /// Infinite if anything is NaN.
    pub fn error(self, answer: &Answer, exact: &State) -> f64 {
        let area = (answer.area_fraction / exact.area_fraction - 1.0).abs();
        let other = match self {
            GivenQuantity::Separation => (answer.pressure_pa / exact.pressure_pa - 1.0).abs(),
            GivenQuantity::Pressure => (answer.separation_over_sigma - exact.separation_over_sigma).abs(),
        };
        if area.is_nan() || other.is_nan() { f64::INFINITY } else { area.max(other) }
    }
}

/// State as computed by an engine.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Answer {
    /// Separation over sigma.
    pub separation_over_sigma: f64,
    /// Nominal pressure \[Pa\].
    pub pressure_pa: f64,
    /// Real over nominal area.
    pub area_fraction: f64,
}

/// Engine that answers.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Engine {
    /// This program's library, with a contact built anew for every state.
    Ours,
    /// This program's library for a thousand states of one population in a sweep.
    OursBatch,
    /// scipy: `quad` between the law's breaks, `brentq` in ln p, laws tuned for single numbers.
    Quad,
    /// scipy with the laws as numpy functions, written once for numbers and arrays.
    QuadNumpy,
    /// `ContactMechanics`: its `Fn`, and `brentq` around it.
    Fn,
    /// numpy: the trapezoidal rule on a fixed grid, a state at a time.
    Grid,
    /// numpy: the trapezoidal rule on a fixed grid, a thousand states at once.
    GridBatch,
}

impl Engine {
    /// All engines, ours first.
    pub const ALL: [Engine; 7] = [
        Engine::Ours,
        Engine::Quad,
        Engine::Fn,
        Engine::Grid,
        Engine::GridBatch,
        Engine::OursBatch,
        Engine::QuadNumpy,
    ];

    /// All engines but ours.
    pub const COMPETITORS: [Engine; 5] =
        [Engine::Quad, Engine::QuadNumpy, Engine::Fn, Engine::Grid, Engine::GridBatch];

    /// Engine of ours that a competitor is compared with: batches with batches.
    pub fn counterpart(self) -> Engine {
        match self {
            Engine::GridBatch | Engine::OursBatch => Engine::OursBatch,
            _ => Engine::Ours,
        }
    }

    /// Name in tables.
    pub fn name(self) -> &'static str {
        match self {
            Engine::Ours => "truearea",
            Engine::OursBatch => "truearea, batch",
            Engine::Quad => "scipy, laws tuned",
            Engine::QuadNumpy => "scipy, laws in numpy",
            Engine::Fn => "ContactMechanics",
            Engine::Grid => "grid",
            Engine::GridBatch => "grid, batch",
        }
    }

    /// Settings of the engine: tolerances, or numbers of nodes of a grid.
    pub fn settings(self) -> &'static [f64] {
        match self {
            Engine::Ours => &[1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12, 1e-13],
            Engine::OursBatch => {
                &[1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12, 1e-13]
            }
            Engine::QuadNumpy => &[1e-6, 1e-10],
            Engine::Quad => &[1e-4, 1e-6, 1e-8, 1e-10, 1e-12],
            // Its tolerance is scipy's default and cannot be chosen.
            Engine::Fn => &[1.49e-8],
            Engine::Grid => &[100.0, 1e3, 1e4, 1e5],
            Engine::GridBatch => &[100.0, 300.0, 1000.0, 3000.0],
        }
    }

    /// True if the engine has the law.
    pub fn knows(self, model: &str) -> bool {
        self != Engine::Fn || model == "hertz"
    }
}

/// Outcome of a question.
#[derive(Debug, Clone, PartialEq)]
pub enum Outcome {
    /// Right answer, with its error.
    Right(f64),
    /// Answer with an error beyond [`WRONG_FROM`].
    Wrong(f64),
    /// No answer, with the reason.
    Failed(String),
}

impl Outcome {
    /// Compares an answer with its reference.
    pub fn new(given: GivenQuantity, answer: &Answer, exact: &State) -> Self {
        match given.error(answer, exact) {
            error if error <= WRONG_FROM => Outcome::Right(error),
            error => Outcome::Wrong(error),
        }
    }
}

/// Answer of one engine to one question, with its time and error.
#[derive(Debug, Clone, PartialEq)]
pub struct Point {
    /// Name of the population.
    pub population: String,
    /// Name of the law, with strain gradient if it has one.
    pub law: String,
    /// Given quantity.
    pub given: GivenQuantity,
    /// Separation in sigma, of the reference.
    pub separation_over_sigma: f64,
    /// Engine that answered.
    pub engine: Engine,
    /// Tolerance or number of nodes.
    pub setting: f64,
    /// Seconds per state; 0 without an answer.
    pub seconds: f64,
    /// Outcome of the question.
    pub outcome: Outcome,
}

impl Point {
    /// Error of a right answer.
    pub fn error(&self) -> Option<f64> {
        match self.outcome {
            Outcome::Right(error) => Some(error),
            _ => None,
        }
    }

    /// True if two points answer the same question.
    pub fn same_question(&self, other: &Point) -> bool {
        self.given == other.given
            && self.separation_over_sigma == other.separation_over_sigma
            && self.law == other.law
            && self.population == other.population
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const EXACT: State =
        State { separation_m: 2e-9, separation_over_sigma: 2.0, pressure_pa: 1e6, area_fraction: 0.1 };

    #[test]
    fn the_worse_of_two_errors_counts_and_nothing_undefined_is_right() {
        let answer = Answer { separation_over_sigma: 2.001, pressure_pa: 1e6, area_fraction: 0.1 * 1.00001 };
        assert!((GivenQuantity::Pressure.error(&answer, &EXACT) - 1e-3).abs() < 1e-12);
        assert!((GivenQuantity::Separation.error(&answer, &EXACT) - 1e-5).abs() < 1e-12);
        let undefined = Answer { area_fraction: f64::NAN, ..answer };
        assert_eq!(Outcome::new(GivenQuantity::Pressure, &undefined, &EXACT), Outcome::Wrong(f64::INFINITY));
        let zero = Answer { pressure_pa: 0.0, area_fraction: 0.0, ..answer };
        assert_eq!(Outcome::new(GivenQuantity::Separation, &zero, &EXACT), Outcome::Wrong(1.0));
    }
}
