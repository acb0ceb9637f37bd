//! Process that runs the competitors, with a line of JSON per question and answer, so that their runs can alternate
//! with ours.

use std::collections::BTreeMap;
use std::io::{BufRead, BufReader, Write};
use std::process::{Child, ChildStdin, ChildStdout, Stdio};

use serde::{Deserialize, Serialize};

use super::environment::{Environment, MissingPackage};
use crate::reference::Case;

/// Question to an engine.
#[derive(Debug, Serialize)]
pub struct Question<'a> {
    /// Name of the engine in `worker.py`.
    pub engine: &'a str,
    /// Tolerance or number of nodes of the engine.
    pub setting: Setting,
    /// True if ln p is given rather than the separation over sigma.
    pub by_pressure: bool,
    /// Population and law.
    pub case: &'a Case,
    /// States, by the given quantity.
    pub at: States,
    /// Seconds for repetitions.
    pub seconds: f64,
}

/// Setting of an engine: a tolerance stays a fraction, a number of nodes is an integer.
#[derive(Debug, Serialize)]
#[serde(untagged)]
pub enum Setting {
    /// Relative tolerance.
    Tolerance(f64),
    /// Number of nodes.
    Nodes(u32),
}

impl Setting {
    /// Converts a number of a table.
    pub fn from_number(number: f64) -> Self {
        if number < 1.0 { Setting::Tolerance(number) } else { Setting::Nodes(number as u32) }
    }
}

/// One interference, or several states.
#[derive(Debug, Serialize)]
#[serde(untagged)]
pub enum States {
    /// Interference over sigma.
    One(f64),
    /// Separations over sigma, or logarithms of pressures in Pa.
    Many(Vec<f64>),
}

/// Answer: its numbers, and the seconds it took.
#[derive(Debug, Clone, PartialEq, Deserialize)]
pub struct Row {
    /// Separation over sigma, pressure \[Pa\] and area fraction; only the last two for a single asperity.
    pub numbers: Vec<Option<f64>>,
    /// Seconds per answer.
    pub seconds: f64,
}

impl Row {
    /// Returns a number, NaN if it is missing.
    pub fn number(&self, at: usize) -> f64 {
        self.numbers.get(at).copied().flatten().unwrap_or(f64::NAN)
    }
}

#[derive(Deserialize)]
struct Greeting {
    versions: BTreeMap<String, String>,
    missing: BTreeMap<String, String>,
}

#[derive(Deserialize)]
#[serde(rename_all = "kebab-case")]
enum Reply {
    Rows(Vec<Row>),
    Error(String),
}

/// Process of the competitors; it ends when this is dropped.
#[derive(Debug)]
pub struct Worker {
    child: Child,
    questions: Option<ChildStdin>,
    answers: BufReader<ChildStdout>,
    /// Versions of the packages it uses, by name.
    pub versions: BTreeMap<String, String>,
    /// Packages that could not be loaded.
    pub missing: Vec<MissingPackage>,
}

impl Worker {
    /// Starts the process, on one thread.
    ///
    /// # Errors
    /// A message if it does not start.
    pub fn start(environment: &Environment) -> Result<Self, String> {
        let mut command = environment.command("worker.py");
        command.stdin(Stdio::piped()).stdout(Stdio::piped());
        let mut child = command.spawn().map_err(|error| error.to_string())?;
        let questions = child.stdin.take();
        let answers = BufReader::new(child.stdout.take().ok_or("no output")?);
        let (versions, missing) = (BTreeMap::new(), Vec::new());
        let mut worker = Worker { child, questions, answers, versions, missing };
        let greeting: Greeting = parse(&worker.line()?)?;
        worker.versions = greeting.versions;
        worker.missing = greeting
            .missing
            .into_iter()
            .map(|(package, reason)| MissingPackage { package, reason })
            .collect();
        Ok(worker)
    }

    /// Returns the answers, one per state.
    ///
    /// # Errors
    /// The engine's error message.
    pub fn ask(&mut self, asked: &Question<'_>) -> Result<Vec<Row>, String> {
        let question = serde_json::to_string(asked).map_err(|error| error.to_string())?;
        let questions = self.questions.as_mut().ok_or("the worker has ended")?;
        writeln!(questions, "{question}").map_err(|error| error.to_string())?;
        rows(&self.line()?)
    }

    fn line(&mut self) -> Result<String, String> {
        let mut line = String::new();
        match self.answers.read_line(&mut line) {
            Ok(0) => Err("the worker has ended".to_owned()),
            Ok(_) => Ok(line),
            Err(error) => Err(error.to_string()),
        }
    }
}

impl Drop for Worker {
    fn drop(&mut self) {
        // Closing its input ends the process.
        self.questions = None;
        let _ = self.child.wait();
    }
}

/// Parses JSON with NaN and infinities, which Python writes as words that JSON does not have.
fn parse<T: for<'a> Deserialize<'a>>(line: &str) -> Result<T, String> {
    let line = line.replace("-Infinity", "null").replace("Infinity", "null").replace("NaN", "null");
    serde_json::from_str(&line).map_err(|error| format!("{error} in {line}"))
}

fn rows(line: &str) -> Result<Vec<Row>, String> {
    match parse(line)? {
        Reply::Rows(rows) => Ok(rows),
        Reply::Error(error) => Err(error),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn answers_with_nan_are_read() {
        let rows = rows(r#"{"rows": [{"numbers": [3.0, NaN, -Infinity], "seconds": 1e-3}]}"#).unwrap();
        assert_eq!((rows[0].number(0), rows[0].seconds), (3.0, 1e-3));
        assert!(rows[0].number(1).is_nan() && rows[0].number(2).is_nan() && rows[0].number(7).is_nan());
    }

    #[test]
    fn an_error_is_the_engines_answer() {
        assert_eq!(rows(r#"{"error": "ValueError: no bracket"}"#).unwrap_err(), "ValueError: no bracket");
        assert!(rows("Traceback").is_err());
    }

    #[test]
    fn tolerances_and_nodes_are_distinguished() {
        let written = |number| serde_json::to_string(&Setting::from_number(number)).unwrap();
        assert_eq!((written(1e-4).as_str(), written(1e5).as_str()), ("0.0001", "100000"));
    }
}
