//! Answers to questions, with notes and errors in terms of arguments.

use numpy::PyArray1;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use questions::{Answer, Note, NoteLevel, NotePlace, OptionName, QuestionError, Spelling, note_code};
use report::question_words;
use study::material::MaterialError;
use tables::{Cell, Cells, Table};
use topography::Severity;

use crate::errors::input;
use crate::work::{Observer, Watch, carry_out};

/// The columns of a table, and the notes on it.
#[pyclass(frozen, name = "Answer", module = "truearea._native")]
pub struct PyAnswer {
    #[pyo3(get)]
    columns: Py<PyDict>,
    pub notes: Vec<Note>,
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

    /// Sets notes before those of the answer.
    pub fn behind(self, notes: Vec<Note>) -> Self {
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

/// A note in words, its level, the code of its kind, and its place.
pub type Told = (String, &'static str, String, Place);

/// Files, row, line and key that a note is about.
type Place = (Vec<String>, Option<usize>, Option<usize>, Option<String>);

/// Notes in words; checks that were passed are left out.
pub fn words(notes: &[Note]) -> Vec<Told> {
    let with_level = notes.iter().filter_map(|note| Some((note, note.level()?)));
    let lines = with_level.flat_map(|(note, level)| {
        question_words::lines(note, &Keywords).into_iter().map(move |line| {
            let is_warning = line.severity == Severity::Warning;
            let text = if is_warning { format!("warning: {}", line.text) } else { line.text };
            (text, level.name(), note_code(note), in_keywords(note.place()))
        })
    });
    lines.collect()
}

/// A note that is text already, with the code of its kind.
pub fn in_text(text: String, code: &str, place: NotePlace) -> Told {
    (text, NoteLevel::Note.name(), code.to_owned(), in_keywords(place))
}

fn in_keywords(place: NotePlace) -> Place {
    let NotePlace { files, row, line, option, key } = place;
    (files, row, line, key.or_else(|| option.map(|option| Keywords.option(option))))
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
