//! The columns of the strength of the rough body: yield strength, hardness, or both.

use asperity::Bound;
use study::hardness_and_strength::HardnessAndStrength;
use tables::{InputTable, Refusal, Row};
use units::{IndentationHardness, Pressure};

/// The column of the yield strength S0.
pub(crate) const YIELD_STRENGTH: &str = "yield_strength_pa";

/// The column of the hardness H, in place of the strength or beside it.
pub(crate) const INDENTATION_HARDNESS: &str = "indentation_hardness_pa";

/// The column of the length below which the strength grows.
pub(crate) const STRAIN_GRADIENT_LENGTH: &str = "strain_gradient_length_m";

/// The hardness and the strength of a row, as far as its cells are filled.
pub(crate) fn hardness_and_strength(row: &Row<'_>, bound: Bound) -> Result<HardnessAndStrength, String> {
    let hardness = row.optional_number(INDENTATION_HARDNESS, bound)?.map(|pa| IndentationHardness { pa });
    let strength = row.optional_number(YIELD_STRENGTH, bound)?.map(Pressure::Pascals);
    HardnessAndStrength::new(hardness, strength)
        .map_err(|error| format!("columns {INDENTATION_HARDNESS} and {YIELD_STRENGTH}: {error}"))
}

/// The yield strength \[Pa\] of every row: as given, or a third of the hardness.
pub(crate) fn yield_strengths_pa(input: &InputTable, bound: Bound) -> Result<Vec<f64>, Refusal> {
    input.rows(&[], |row| {
        hardness_and_strength(row, bound)?.yield_strength_pa().ok_or_else(|| {
            format!("columns {INDENTATION_HARDNESS} and {YIELD_STRENGTH} are both empty; fill one")
        })
    })
}

/// The number of rows with a hardness and no strength.
pub(crate) fn assumed_strengths(input: &InputTable) -> usize {
    let assumed = |row: &Row<'_>| {
        let filled = |column| !row.text(column).trim().is_empty();
        Ok(filled(INDENTATION_HARDNESS) && !filled(YIELD_STRENGTH))
    };
    let rows = if input.has(INDENTATION_HARDNESS) { input.rows(&[], assumed) } else { Ok(Vec::new()) };
    rows.map_or(0, |rows| rows.into_iter().filter(|assumed| *assumed).count())
}
