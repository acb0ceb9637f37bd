//! The facts about a curve that decide the look of its lines, so that a model looks alike in every figure.

use serde::Serialize;

use crate::models::CurveModel;
use crate::plan::Curve;

/// The model of a curve and its place among curves of that model.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub struct CurveLook {
    /// The name of the model.
    pub model: &'static str,
    /// The setting of the model that most changes its area.
    pub variant: Variant,
    /// The number of earlier curves of the scene that have model and variant in common with one before them.
    pub repeat: usize,
}

/// A setting of a model that most changes its area.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Variant {
    /// The model with neither.
    Plain,
    /// The strength grows at small scales.
    Hardening,
    /// Persson's theory with a correction.
    Corrected,
}

impl CurveLook {
    /// Returns the look of each curve of a scene.
    #[must_use]
    pub fn of_curves(curves: &[Curve]) -> Vec<Self> {
        let mut looks: Vec<Self> = Vec::with_capacity(curves.len());
        let mut repeats = 0;
        for curve in curves {
            let (model, variant) = (curve.model.entry.name, Variant::of(&curve.model));
            let is_repeated = looks.iter().any(|look| (look.model, look.variant) == (model, variant));
            repeats += usize::from(is_repeated);
            looks.push(CurveLook { model, variant, repeat: if is_repeated { repeats } else { 0 } });
        }
        looks
    }
}

impl Variant {
    fn of(model: &CurveModel) -> Self {
        if model.strength_grows() {
            return Variant::Hardening;
        }
        match model.persson().and_then(|law| law.correction) {
            Some(_) => Variant::Corrected,
            None => Variant::Plain,
        }
    }
}
