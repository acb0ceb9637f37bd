//! One answer of one engine, held against its reference.

use crate::reference::State;

/// An answer off by more than this is wrong, however fast it came.
pub const WRONG_FROM: f64 = 1e-2;

/// What a state is asked for by.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Given {
    /// p(d): the separation is given, pressure and area are wanted.
    Separation,
    /// d(p): the pressure is given, separation and area are wanted.
    Pressure,
}

impl Given {
    /// Both questions.
    pub const ALL: [Given; 2] = [Given::Separation, Given::Pressure];

    /// Its name in files.
    pub fn name(self) -> &'static str {
        match self {
            Given::Separation => "separation",
            Given::Pressure => "pressure",
        }
    }

    /// The question as it is written.
    pub fn question(self) -> &'static str {
        match self {
            Given::Separation => "p(d)",
            Given::Pressure => "d(p)",
        }
    }

    /// The larger of the two errors of an answer: relative for pressure and area, in units of sigma for the separation.
    /// Infinite where something is not a number.
    pub fn error(self, answer: &Answer, exact: &State) -> f64 {
        let area = (answer.area_fraction / exact.area_fraction - 1.0).abs();
        let other = match self {
            Given::Separation => (answer.pressure_pa / exact.pressure_pa - 1.0).abs(),
            Given::Pressure => (answer.separation_over_sigma - exact.separation_over_sigma).abs(),
        };
        if area.is_nan() || other.is_nan() { f64::INFINITY } else { area.max(other) }
    }
}

/// A state as an engine computed it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Answer {
    /// Separation over sigma.
    pub separation_over_sigma: f64,
    /// Nominal pressure \[Pa\].
    pub pressure_pa: f64,
    /// Real over nominal area.
    pub area_fraction: f64,
}

/// Who answers.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Engine {
    /// This program's library, built anew for every state.
    Ours,
    /// The same for a thousand states of one population, one after the other.
    OursBatch,
    /// scipy: `quad` between the law's breaks, `brentq` in ln p, laws tuned for single numbers.
    Quad,
    /// The same with the laws as numpy functions, written once for numbers and arrays.
    QuadNumpy,
    /// `ContactMechanics`: its `Fn`, and `brentq` around it.
    Fn,
    /// numpy: the trapezoidal rule on a fixed grid, a state at a time.
    Grid,
    /// The same for a thousand states at once.
    GridBatch,
}

impl Engine {
    /// Everybody, ourselves first.
    pub const ALL: [Engine; 7] = [
        Engine::Ours,
        Engine::Quad,
        Engine::Fn,
        Engine::Grid,
        Engine::GridBatch,
        Engine::OursBatch,
        Engine::QuadNumpy,
    ];

    /// Everybody else.
    pub const COMPETITORS: [Engine; 5] =
        [Engine::Quad, Engine::QuadNumpy, Engine::Fn, Engine::Grid, Engine::GridBatch];

    /// What of ours a competitor is held against: who computes a thousand states at once, against a thousand of ours.
    pub fn counterpart(self) -> Engine {
        match self {
            Engine::GridBatch | Engine::OursBatch => Engine::OursBatch,
            _ => Engine::Ours,
        }
    }

    /// Its name in tables.
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

    /// The settings it is asked at: tolerances, or numbers of nodes of a grid.
    pub fn settings(self) -> &'static [f64] {
        match self {
            Engine::Ours | Engine::OursBatch => {
                &[1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12, 1e-13]
            }
            Engine::QuadNumpy => &[1e-6, 1e-10],
            Engine::Quad => &[1e-4, 1e-6, 1e-8, 1e-10, 1e-12],
            // Its tolerance is scipy's default and cannot be chosen.
            Engine::Fn => &[1.49e-8],
            Engine::Grid => &[100.0, 1e3, 1e4, 1e5],
            Engine::GridBatch => &[100.0, 300.0, 1000.0, 3000.0],
        }
    }

    /// Whether it has the law at all.
    pub fn knows(self, model: &str) -> bool {
        self != Engine::Fn || model == "hertz"
    }
}

/// What became of a question.
#[derive(Debug, Clone, PartialEq)]
pub enum Outcome {
    /// A right answer, with its error.
    Right(f64),
    /// An answer further off than [`WRONG_FROM`], with its error.
    Wrong(f64),
    /// No answer, and why.
    Failed(String),
}

impl Outcome {
    /// An answer against its reference.
    pub fn of(given: Given, answer: &Answer, exact: &State) -> Self {
        match given.error(answer, exact) {
            error if error <= WRONG_FROM => Outcome::Right(error),
            error => Outcome::Wrong(error),
        }
    }
}

/// One answer: who gave it to what, how long it took, and how good it is.
#[derive(Debug, Clone, PartialEq)]
pub struct Point {
    /// The population's name.
    pub population: String,
    /// The law's name, with strain gradient where there is one.
    pub law: String,
    /// What the state was asked for by.
    pub given: Given,
    /// The separation in sigma, of the reference.
    pub separation_over_sigma: f64,
    /// Who answered.
    pub engine: Engine,
    /// At which tolerance or with how many nodes.
    pub setting: f64,
    /// Seconds for a state; 0 where there is no answer.
    pub seconds: f64,
    /// How good the answer is.
    pub outcome: Outcome,
}

impl Point {
    /// The error of a right answer.
    pub fn error(&self) -> Option<f64> {
        match self.outcome {
            Outcome::Right(error) => Some(error),
            _ => None,
        }
    }

    /// Whether two points answer the same question.
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
        assert!((Given::Pressure.error(&answer, &EXACT) - 1e-3).abs() < 1e-12);
        assert!((Given::Separation.error(&answer, &EXACT) - 1e-5).abs() < 1e-12);
        let undefined = Answer { area_fraction: f64::NAN, ..answer };
        assert_eq!(Outcome::of(Given::Pressure, &undefined, &EXACT), Outcome::Wrong(f64::INFINITY));
        let zero = Answer { pressure_pa: 0.0, area_fraction: 0.0, ..answer };
        assert_eq!(Outcome::of(Given::Separation, &zero, &EXACT), Outcome::Wrong(1.0));
    }
}
