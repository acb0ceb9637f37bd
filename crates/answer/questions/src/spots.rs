//! Resistance of the spots of surfaces while they are pressed.

use std::collections::BTreeSet;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, PoisonError};

use elements::{Boundary, ContactField, PressedLoad, SpecimenCompliance};
use interface::conductance::Resistivities;
use study::body_properties::BodyProperty;
use study::materials::TabledMaterial;
use tables::Table;
use transport::spots::{FieldSpots, SpotConduction, SpotsError, spots_table, with_resistances};
use units::{Remark, RemarkCode, Resistivity};

use crate::{ElementsQuestion, QuestionError};

/// Resistivities of both bodies, and what lies between them.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct SpotsInput {
    /// Resistivity of the rough body \[ohm m\].
    pub resistivity_ohm_m: Option<f64>,
    /// Resistivity of the counterface \[ohm m\].
    pub counterface_resistivity_ohm_m: Option<f64>,
    /// Specific resistance of a film \[ohm m^2\]; no film if absent.
    pub film_resistance_ohm_m2: Option<f64>,
    /// Mean free path of electrons \[m\]; short against the spots if absent.
    pub mean_free_path_m: Option<f64>,
}

impl SpotsInput {
    /// Takes resistivities that are not given from the table of materials.
    #[must_use]
    pub fn filled_from(self, rough: Option<&TabledMaterial>, counterface: Option<&TabledMaterial>) -> Self {
        let tabled = |body: Option<&TabledMaterial>| {
            let resistivity: Option<Resistivity> = body?.quantity(BodyProperty::Resistivity);
            resistivity.map(|resistivity| resistivity.ohm_m)
        };
        SpotsInput {
            resistivity_ohm_m: self.resistivity_ohm_m.or_else(|| tabled(rough)),
            counterface_resistivity_ohm_m: self.counterface_resistivity_ohm_m.or_else(|| tabled(counterface)),
            ..self
        }
    }

    /// Returns how the bodies conduct.
    ///
    /// # Errors
    /// [`QuestionError`] for a resistivity that is missing, and for values out of bounds.
    pub fn conduction(&self) -> Result<SpotConduction, QuestionError> {
        let given = |option, value: Option<f64>| value.ok_or_else(|| QuestionError::Missing(vec![option]));
        let own = given("resistivity", self.resistivity_ohm_m)?;
        let other = given("counterface_resistivity", self.counterface_resistivity_ohm_m)?;
        let of = |option| move |error| QuestionError::Value { option, error };
        let mut conduction = SpotConduction::new(Resistivities::new(own, other).map_err(of("resistivity"))?);
        if let Some(film_ohm_m2) = self.film_resistance_ohm_m2 {
            conduction = conduction.with_film(film_ohm_m2).map_err(of("film_resistance"))?;
        }
        if let Some(path_m) = self.mean_free_path_m {
            conduction = conduction.with_mean_free_path(path_m).map_err(of("mean_free_path"))?;
        }
        Ok(conduction)
    }
}

/// Spots of surfaces, found while they are pressed.
#[derive(Debug)]
pub struct PressedSpots {
    conduction: SpotConduction,
    found: Mutex<Vec<FieldSpots>>,
    /// True if a map has free edges.
    has_free_edges: AtomicBool,
}

impl PressedSpots {
    /// Takes how the bodies of a question conduct.
    ///
    /// # Errors
    /// [`QuestionError`] for layers, through which no spot conducts as between half-spaces, and for a compliance that is taken out of the
    /// stiffness alone.
    pub fn new(input: &SpotsInput, question: &ElementsQuestion) -> Result<Self, QuestionError> {
        let conduction = input.conduction()?;
        let other = if question.material.layer.is_some() {
            "a layer: spots conduct between two half-spaces; leave out the layer"
        } else if question.compliance.is_some_and(|kind| kind != SpecimenCompliance::None) {
            "a compliance that is taken out: spots conduct through the whole of both bodies; leave out the compliance"
        } else {
            return Ok(PressedSpots {
                conduction,
                found: Mutex::default(),
                has_free_edges: AtomicBool::new(false),
            });
        };
        Err(QuestionError::Other(format!("spots with {other}")))
    }

    /// Solves the spots of one surface under one load, and keeps them. Where it is asked for, returns the share of the current through
    /// the spot of each point, row by row, 0 between spots; `None` if the spots could not be solved.
    ///
    /// # Errors
    /// [`QuestionError`] for a line.
    pub fn solve(
        &self,
        field: &ContactField<'_>,
        asks_shares: bool,
    ) -> Result<Option<Vec<f64>>, QuestionError> {
        let of_error = |error: SpotsError| QuestionError::Other(error.to_string());
        let spots = FieldSpots::new(field, self.conduction).map_err(of_error)?;
        if field.relief.boundary == Boundary::Free {
            self.has_free_edges.store(true, Ordering::Relaxed);
        }
        let shares = if asks_shares { spots.shares_at_points(field).map_err(of_error)? } else { None };
        self.found.lock().unwrap_or_else(PoisonError::into_inner).push(spots);
        Ok(shares)
    }

    /// Adds the resistances to a table of pressed surfaces, of their means or of each, and notes on them; returns the table of the spots
    /// as well.
    ///
    /// # Errors
    /// [`QuestionError`] for a stiffness out of bounds.
    pub fn tables(
        self,
        table: Table,
        loads: &[PressedLoad],
        notes: &mut Vec<Remark>,
        of_each: bool,
    ) -> Result<[Table; 2], QuestionError> {
        let found = self.found.into_inner().unwrap_or_else(PoisonError::into_inner);
        let table = with_resistances(table, loads, of_each, &found)
            .map_err(|error| QuestionError::Value { option: "spots", error })?;
        if let [field] = &found[..]
            && let Ok(solved) = &field.solved
        {
            let [share, area] = [solved.largest_share(), solved.area_fraction];
            let note = Remark::new(RemarkCode::Spots).with("spots", solved.spots.len());
            notes.push(note.with("share", share).with("area", area));
        }
        let is_out = |field: &&FieldSpots| match &field.solved {
            Ok(solved) => !solved.is_in_range,
            Err(error) => matches!(error, SpotsError::Indefinite { .. }),
        };
        match found.iter().filter(is_out).count() {
            0 => {}
            out => notes.push(
                Remark::new(RemarkCode::SpotsOutOfRange).with("out", out).with("contacts", found.len()),
            ),
        }
        let errors =
            found.iter().filter(|field| !is_out(field)).filter_map(|field| field.solved.as_ref().err());
        let reasons: BTreeSet<String> = errors.map(ToString::to_string).collect();
        let unsolved = |reason: String| Remark::new(RemarkCode::SpotsUnsolved).with("reason", reason);
        notes.extend(reasons.into_iter().map(unsolved));
        if self.has_free_edges.into_inner() {
            notes.push(Remark::new(RemarkCode::CurrentSpreads));
        }
        Ok([table, spots_table(&found)])
    }
}
