//! Answers to questions, with notes and errors in terms of arguments.

use numpy::PyArray1;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use questions::{Answer, QuestionError};
use report::question_words;
use study::material::MaterialError;
use tables::{Cell, Cells, Table};
use units::{Remark, RemarkLevel, RemarkPlace, Spelling};

use crate::errors::input;
use crate::work::{Observer, Watch, carry_out};

/// The columns of a table, and the notes on it.
#[pyclass(frozen, name = "Answer", module = "truearea._native")]
pub struct PyAnswer {
    #[pyo3(get)]
    columns: Py<PyDict>,
    pub notes: Vec<Remark>,
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
    pub fn new(py: Python<'_>, table: &Table, notes: Vec<Remark>) -> PyResult<Self> {
        Ok(Self::of_columns(columns(py, table)?, notes))
    }

    pub fn of_columns(columns: Bound<'_, PyDict>, notes: Vec<Remark>) -> Self {
        PyAnswer { columns: columns.unbind(), notes }
    }

    /// Sets notes before those of the answer.
    pub fn behind(self, notes: Vec<Remark>) -> Self {
        PyAnswer { notes: [notes, self.notes].concat(), ..self }
    }

    /// Carries out the work of an answer.
    pub fn carry_out(
        py: Python<'_>,
        observer: Option<&Observer<'_>>,
        work: impl FnOnce(&&Watch) -> Result<Answer, QuestionError> + Send,
    ) -> PyResult<Self> {
        let answer = carry_out(py, observer, work)?.map_err(refused)?;
        Self::new(py, &answer.table, answer.notes)
    }
}

/// Arguments of functions, as `interference_law`.
pub struct Keywords;

impl Spelling for Keywords {
    fn option(&self, option: &str) -> String {
        if option == "missing_points" { "gaps".to_owned() } else { option.to_owned() }
    }

    fn with_value(&self, option: &str, value: &str) -> String {
        let quote = if value.parse::<f64>().is_ok() { "" } else { "\"" };
        format!("{}={quote}{value}{quote}", self.option(option))
    }

    fn model(&self, name: &str) -> String {
        format!("model {name}")
    }

    fn of_scan(&self, option: &str, value: &str) -> String {
        format!("set {}", self.with_value(option, value))
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

/// A note in words, its level, the code of its kind, and its place.
pub type Told = (String, &'static str, String, Place);

/// Files, row, line and key that a note is about.
type Place = (Vec<String>, Option<usize>, Option<usize>, Option<String>);

/// Remarks in words; checks that were passed are left out.
pub fn words(remarks: &[Remark]) -> Vec<Told> {
    let shown = remarks.iter().filter(|remark| remark.level != RemarkLevel::Passed);
    let in_words = |remark: &Remark| {
        let (text, code) = (remark.words(&Keywords), remark.code_name());
        in_text(text, code, remark.level, (*remark.place).clone())
    };
    shown.map(in_words).collect()
}

/// A note in words, with the code of its kind.
pub fn in_text(text: String, code: String, level: RemarkLevel, place: RemarkPlace) -> Told {
    let doubt = if level == RemarkLevel::Caution { "warning: " } else { "" };
    (format!("{doubt}{text}"), level.name(), code, in_keywords(place))
}

fn in_keywords(place: RemarkPlace) -> Place {
    let RemarkPlace { files, surface, row, line, option, key } = place;
    let files = if files.is_empty() { surface.into_iter().collect() } else { files };
    (files, row, line, key.or_else(|| option.map(|option| Keywords.option(&option))))
}

/// The columns of a table by their names: numbers as arrays of doubles, NaN where a cell is empty, as data frames have it;
/// anything else as a list of text.
pub fn columns<'py>(py: Python<'py>, table: &Table) -> PyResult<Bound<'py, PyDict>> {
    let columns = PyDict::new(py);
    table.columns().try_for_each(|(name, cells)| match cells {
        Cells::Numbers(numbers) => {
            let numbers = numbers.iter().map(|number| number.unwrap_or(f64::NAN));
            columns.set_item(name, PyArray1::from_iter(py, numbers))
        }
        Cells::Words(words) => columns.set_item(name, words),
        Cells::Typed(cells) => columns.set_item(name, cells.iter().map(Cell::text).collect::<Vec<_>>()),
    })?;
    Ok(columns)
}
