//! Answers to questions, with notes and errors in terms of arguments.

use numpy::PyArray1;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use questions::{Note, OptionName, QuestionError, Spelling};
use report::question_words;
use study::material::MaterialError;
use tables::{Cell, Cells, Table};
use topography::Severity;

use crate::errors::input;

/// The columns of a table, and the notes on it.
#[pyclass(frozen, name = "Answer", module = "truearea._native")]
pub struct PyAnswer {
    #[pyo3(get)]
    columns: Py<PyDict>,
    notes: Vec<Note>,
}

#[pymethods]
impl PyAnswer {
    /// The notes in words.
    #[getter]
    fn notes(&self) -> Vec<Told> {
        words(&self.notes)
    }

    /// The notes as data.
    #[getter]
    fn facts(&self) -> Vec<String> {
        self.notes.iter().map(|note| format!("{note:?}")).collect()
    }
}

impl PyAnswer {
    pub fn new(py: Python<'_>, table: &Table, notes: Vec<Note>) -> PyResult<Self> {
        Ok(Self::of_columns(columns(py, table)?, notes))
    }

    pub fn of_columns(columns: Bound<'_, PyDict>, notes: Vec<Note>) -> Self {
        PyAnswer { columns: columns.unbind(), notes }
    }
}

/// Arguments of functions, as `interference_law`.
pub struct Keywords;

impl Spelling for Keywords {
    fn option(&self, option: OptionName) -> String {
        match option {
            OptionName::MissingPoints => "gaps".to_owned(),
            option => option.snake_case(),
        }
    }

    fn with_value(&self, option: OptionName, value: &str) -> String {
        let quote = if value.parse::<f64>().is_ok() { "" } else { "\"" };
        format!("{}={quote}{value}{quote}", self.option(option))
    }

    fn model(&self, name: &str) -> String {
        format!("model {name}")
    }

    fn of_material(&self) -> &'static str {
        "the material "
    }
}

/// Converts an error of a question, with the argument that mends it.
pub fn refused(error: QuestionError) -> PyErr {
    input(question_words::error(&error, &Keywords))
}

/// Words an error of a material, with the argument that mends it.
pub fn of_material(error: &MaterialError) -> String {
    question_words::of_material(error, &Keywords)
}

/// A note in words, its level, `note` or `caution`, and the code of its kind.
pub type Told = (String, &'static str, String);

/// Notes in words; checks that were passed are left out.
pub fn words(notes: &[Note]) -> Vec<Told> {
    let lines = notes.iter().flat_map(|note| {
        let is_doubt = matches!(note, Note::Doubt(_));
        let code = code(note);
        question_words::lines(note, &Keywords).into_iter().filter_map(move |line| match line.severity {
            Severity::Passed => None,
            Severity::Note => Some((line.text, if is_doubt { "caution" } else { "note" }, code.clone())),
            Severity::Warning => Some((format!("warning: {}", line.text), "caution", code.clone())),
        })
    });
    lines.collect()
}

/// The kind of a note by the names of its types: `doubt.steep-surface` of `Doubt(SteepSurface { .. })`.
pub fn code(note: &impl std::fmt::Debug) -> String {
    let text = format!("{note:?}");
    let names = text.split('(').map_while(|part| {
        let name: String = part.chars().take_while(|letter| letter.is_ascii_alphanumeric()).collect();
        name.starts_with(|first: char| first.is_ascii_uppercase()).then_some(name)
    });
    let kebab = names.map(|name| {
        let letters = name.char_indices().flat_map(|(at, letter)| {
            let dash = (at > 0 && letter.is_ascii_uppercase()).then_some('-');
            dash.into_iter().chain([letter.to_ascii_lowercase()])
        });
        letters.collect::<String>()
    });
    kebab.collect::<Vec<_>>().join(".")
}

/// The columns of a table by their names: numbers as arrays of doubles, NaN where a cell is empty, as data frames have it;
/// anything else as a list of text.
pub fn columns<'py>(py: Python<'py>, table: &Table) -> PyResult<Bound<'py, PyDict>> {
    let columns = PyDict::new(py);
    for (name, cells) in table.columns() {
        match cells {
            Cells::Numbers(numbers) => {
                let numbers = numbers.iter().map(|number| number.unwrap_or(f64::NAN));
                columns.set_item(name, PyArray1::from_iter(py, numbers))?;
            }
            Cells::Words(words) => columns.set_item(name, words)?,
            Cells::Typed(cells) => {
                columns.set_item(name, cells.iter().map(Cell::text).collect::<Vec<_>>())?;
            }
        }
    }
    Ok(columns)
}
