//! Real pressures above what asperities bear.

use study::models::Choice;
use study::plan::{Curve, CurveResult, NominalPressure};
use study::validity::MODULUS_OVER_LARGEST_PRESSURE;
use units::display::pressure;
use units::{Remark, RemarkCode};

/// Relative rounding of a real pressure, so that a contact that flows everywhere bears its hardness.
pub const ROUNDING: f64 = 1e-9;

/// Gathers the real pressures of contacts, which may come part by part.
pub struct RealPressures {
    hardness_pa: Option<f64>,
    remedy: Option<(&'static str, &'static str)>,
    above_hardness: Above,
    above_third_modulus: Above,
    third_modulus_pa: f64,
}

/// The real pressures above one bound.
#[derive(Default)]
struct Above {
    highest: Option<(f64, Remark)>,
    curves: Vec<String>,
}

impl RealPressures {
    /// An empty collection; the hardness \[Pa\] is that of the material, if it yields.
    #[must_use]
    pub fn new(hardness_pa: Option<f64>) -> Self {
        RealPressures {
            hardness_pa,
            remedy: None,
            above_hardness: Above::default(),
            above_third_modulus: Above::default(),
            third_modulus_pa: f64::INFINITY,
        }
    }

    /// Names what counts the yielding: `model` or `saturation`, and its value.
    #[must_use]
    pub fn with_remedy(self, remedy: Option<(&'static str, &'static str)>) -> Self {
        RealPressures { remedy, ..self }
    }

    /// Adds the real pressure \[Pa\] of a curve under a load with this label.
    pub fn add(&mut self, curve: &Curve, pressure_pa: f64, label: impl Fn() -> String) {
        // A strength that grows at small depths bears more than the hardness of the bulk.
        let hardness_pa = self.hardness_pa.filter(|_| !curve.model.strength_grows());
        let modulus_pa = curve.model.pair().composite_modulus_pa();
        let is_elastic = !curve.model.entry.has(Choice::Strength);
        let bodies = PressedBodies { name: &curve.name, modulus_pa, hardness_pa, is_elastic };
        self.add_contact(&bodies, pressure_pa, label);
    }

    /// Adds the real pressure \[Pa\] of a contact under a load with this label.
    pub fn add_contact(&mut self, bodies: &PressedBodies<'_>, pressure_pa: f64, label: impl Fn() -> String) {
        let third_modulus_pa = bodies.modulus_pa / MODULUS_OVER_LARGEST_PRESSURE;
        self.third_modulus_pa = self.third_modulus_pa.min(third_modulus_pa);
        if bodies.hardness_pa.is_some_and(|hardness_pa| pressure_pa > hardness_pa * (1.0 + ROUNDING)) {
            self.above_hardness.add(RemarkCode::RealAboveHardness, bodies, pressure_pa, &label);
        }
        if pressure_pa > third_modulus_pa {
            self.above_third_modulus.add(RemarkCode::RealAboveThirdModulus, bodies, pressure_pa, &label);
        }
    }

    /// Adds the real pressures of a part of a curve: first under these nominal pressures \[Pa\], then at separations.
    pub fn add_part(&mut self, curve: &Curve, rows: &CurveResult, pressures_pa: &[f64]) {
        for block in 0..rows.blocks() {
            let highest_pa = rows.highest_real_pressure_pa(block);
            let label = || match pressures_pa.get(block).and_then(|&pa| NominalPressure::new(pa).ok()) {
                Some(pressure) => pressure.label(),
                None => "a separation".to_owned(),
            };
            self.add(curve, highest_pa, label);
        }
    }

    /// The doubts about the pressures added so far.
    #[must_use]
    pub fn doubts(self) -> Vec<Remark> {
        let of_hardness = self.above_hardness.remark().zip(self.hardness_pa);
        let of_hardness = of_hardness.map(|((pressure_pa, remark), hardness_pa)| {
            let remark =
                remark.with("hardness_pa", hardness_pa).with("in_hardnesses", pressure_pa / hardness_pa);
            self.remedy.into_iter().fold(remark, |remark, (name, value)| remark.with(name, value))
        });
        let of_modulus = self.above_third_modulus.remark();
        let of_modulus = of_modulus.map(|(_, remark)| remark.with("bound_pa", self.third_modulus_pa));
        of_hardness.into_iter().chain(of_modulus).collect()
    }
}

/// Bodies pressed by a model or a method, and the pressure that they may bear.
pub struct PressedBodies<'n> {
    /// Name of the model or the method.
    pub name: &'n str,
    /// Composite modulus E* \[Pa\].
    pub modulus_pa: f64,
    /// Hardness \[Pa\]; `None` if nothing is known to yield, or if it grows at small scales.
    pub hardness_pa: Option<f64>,
    /// True if the model does not count the yielding.
    pub is_elastic: bool,
}

/// The doubts about a contact under nominal pressures \[Pa\], each with the share in contact. Every command that presses something asks
/// here, or gathers its [`RealPressures`] part by part. A `remedy` is what counts the yielding: `model` or `saturation`, and its value.
#[must_use]
pub fn of_contact(
    bodies: &PressedBodies<'_>,
    remedy: Option<(&'static str, &'static str)>,
    loads: &[(f64, f64)],
) -> Vec<Remark> {
    let mut real = RealPressures::new(bodies.hardness_pa).with_remedy(remedy.filter(|_| bodies.is_elastic));
    for (pressure_pa, area_fraction) in loads.iter().filter(|(_, area_fraction)| *area_fraction > 0.0) {
        let real_pa = pressure_pa / area_fraction;
        real.add_contact(bodies, real_pa, || pressure(*pressure_pa));
    }
    let nominal = loads.iter().filter_map(|(pressure_pa, _)| NominalPressure::new(*pressure_pa).ok());
    let nominal = super::of_pressures(nominal.map(|nominal| (nominal, None)), bodies.hardness_pa);
    nominal.into_iter().chain(real.doubts()).collect()
}

impl Above {
    fn add(
        &mut self,
        code: RemarkCode,
        bodies: &PressedBodies<'_>,
        pressure_pa: f64,
        label: &impl Fn() -> String,
    ) {
        if self.highest.as_ref().is_none_or(|(highest_pa, _)| pressure_pa > *highest_pa) {
            let remark = Remark::new(code).with("curve", bodies.name).with("load", label());
            let remark = remark.with("pressure_pa", pressure_pa);
            let elastic = bodies.is_elastic.then_some("this elastic model says");
            let remark = elastic.into_iter().fold(remark, |remark, model| remark.with("elastic", model));
            self.highest = Some((pressure_pa, remark));
        }
        if !self.curves.iter().any(|other| other == bodies.name) {
            self.curves.push(bodies.name.to_owned());
        }
    }

    /// Returns the highest pressure \[Pa\], and the remark on it.
    fn remark(self) -> Option<(f64, Remark)> {
        let other_curves = self.curves.len().saturating_sub(1);
        self.highest.map(|(pressure_pa, remark)| (pressure_pa, remark.with("other_curves", other_curves)))
    }
}
