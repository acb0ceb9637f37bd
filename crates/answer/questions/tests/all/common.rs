//! Surfaces, bodies and loads that the tests share, and looks at answers.

use std::collections::BTreeMap;
use std::sync::atomic::{AtomicUsize, Ordering};

use numerics::parallel::Progress;
use questions::{GapModel, LoadInput, MaterialInput, QuestionError, RandomInput};
use spectrum::ReadOptions;
use study::models::{MODELS, ModelEntry};
use study::surface::Surface;
use tables::{Cells, Table};
use units::{Pressure, Remark, RemarkCode};

/// Steel with 200 GPa and 0.3.
pub fn steel() -> MaterialInput {
    MaterialInput { youngs_modulus_pa: Some(200e9), poisson_ratio: Some(0.3), ..MaterialInput::default() }
}

/// E* of [`steel`] against a rigid body \[Pa\].
pub const STEEL_MODULUS_PA: f64 = 200e9 / 0.91;

/// Steel with a hardness \[Pa\].
pub fn hard(hardness_pa: f64) -> MaterialInput {
    MaterialInput { indentation_hardness_pa: Some(hardness_pa), ..steel() }
}

/// A surface whose spectrum falls with a power of the wavevector, from 100 um down to 1 um.
pub fn power_law(exponent: f64) -> Surface {
    let row = |i: i32| {
        let wavelength_m = 1e-4 * 10f64.powf(f64::from(-i) / 10.0);
        format!("{wavelength_m:e},{:e}\n", 2e-23 * (wavelength_m / 1e-6).powf(exponent))
    };
    spectrum_of(&(0..=20).map(row).collect::<String>())
}

/// A rough surface with a Hurst exponent of 0.8.
pub fn surface() -> Surface {
    power_law(2.6)
}

/// A surface with the rows of a spectrum: wavelength \[m\], C1D \[m^3\].
pub fn spectrum_of(rows: &str) -> Surface {
    let text = format!("wavelength_m,C1D_m3\n{rows}");
    let files = BTreeMap::from([("rough.csv".to_owned(), text.into_bytes())]);
    Surface::load("rough.csv", &files, &ReadOptions::default()).unwrap()
}

/// A few random surfaces on a small grid.
pub fn small(realisations: usize) -> RandomInput {
    RandomInput {
        grid: Some(32),
        realisations: Some(realisations),
        shortest_m: Some(16e-6),
        ..RandomInput::default()
    }
}

pub fn load(pressure_pa: f64) -> LoadInput {
    LoadInput { pressure: Pressure::Pascals(pressure_pa), label: format!("{pressure_pa} Pa") }
}

pub fn loads(pressures_pa: &[f64]) -> Vec<LoadInput> {
    pressures_pa.iter().copied().map(load).collect()
}

pub fn model(name: &str) -> Option<&'static ModelEntry> {
    Some(MODELS.iter().find(|entry| entry.name == name).unwrap_or_else(|| panic!("no model {name}")))
}

/// A model of gaps between steel and a rigid flat; boundary elements without a name.
pub fn by(name: Option<&str>) -> GapModel {
    GapModel { model: name.and_then(model), material: steel(), ..GapModel::default() }
}

/// The first note with a code.
pub fn note(notes: &[Remark], code: RemarkCode) -> Option<&Remark> {
    notes.iter().find(|note| note.code == code)
}

/// Returns true if a note has the code.
pub fn has(notes: &[Remark], code: RemarkCode) -> bool {
    note(notes, code).is_some()
}

/// The numbers of a note, by name.
pub fn numbers_of<const N: usize>(notes: &[Remark], code: RemarkCode, names: [&str; N]) -> [f64; N] {
    let note = note(notes, code).unwrap_or_else(|| panic!("no {code:?} among {notes:?}"));
    names.map(|name| note.number(name).unwrap_or_else(|| panic!("{name} of {note:?}")))
}

/// The text of a value of a note.
pub fn text_of(notes: &[Remark], code: RemarkCode, name: &str) -> String {
    let note = note(notes, code).unwrap_or_else(|| panic!("no {code:?} among {notes:?}"));
    match note.numbers.iter().find(|(of, _)| *of == name) {
        Some((_, units::RemarkValue::Text(text))) => text.clone(),
        other => panic!("{name} is {other:?}"),
    }
}

/// A column of a table, whether typed or computed; `None` for an empty cell.
pub fn column(table: &Table, name: &str) -> Vec<Option<f64>> {
    match table.column(name).unwrap_or_else(|| panic!("no column {name}")) {
        Cells::Numbers(numbers) => numbers.clone(),
        Cells::Typed(cells) => cells.iter().map(|cell| cell.text().trim().parse().ok()).collect(),
        Cells::Words(words) => panic!("{name} has the words {words:?}"),
    }
}

/// A column whose cells are all filled.
pub fn filled(table: &Table, name: &str) -> Vec<f64> {
    column(table, name).into_iter().map(|cell| cell.unwrap_or_else(|| panic!("empty {name}"))).collect()
}

pub fn assert_near(found: f64, expected: f64, relative: f64) {
    assert!((found - expected).abs() <= relative * expected.abs(), "{found:e} is not {expected:e}");
}

pub fn assert_all_near(found: &[f64], expected: &[f64], relative: f64) {
    assert_eq!(found.len(), expected.len(), "{found:?} {expected:?}");
    found.iter().zip(expected).for_each(|(found, expected)| assert_near(*found, *expected, relative));
}

/// The option that a refused question names, if it is refused for one without effect.
pub fn unused<T>(answer: Result<T, QuestionError>) -> Option<String> {
    match answer {
        Err(QuestionError::Unused(remark)) => remark.place.option.clone(),
        _ => None,
    }
}

/// The options of which a question lacks one.
pub fn missing<T>(answer: Result<T, QuestionError>) -> Vec<&'static str> {
    match answer {
        Err(QuestionError::Missing(options)) => options,
        _ => Vec::new(),
    }
}

/// Counts steps, and cancels from a number of steps on.
pub struct Counted {
    pub steps: AtomicUsize,
    pub cancels_at: usize,
}

impl Counted {
    pub fn new() -> Self {
        Counted { steps: AtomicUsize::new(0), cancels_at: usize::MAX }
    }

    /// Is cancelled from the beginning.
    pub fn cancelled() -> Self {
        Counted { cancels_at: 0, ..Counted::new() }
    }

    pub fn count(&self) -> usize {
        self.steps.load(Ordering::Relaxed)
    }
}

impl Progress for Counted {
    fn advance(&self, steps: usize) {
        self.steps.fetch_add(steps, Ordering::Relaxed);
    }

    fn is_cancelled(&self) -> bool {
        self.count() >= self.cancels_at
    }
}
