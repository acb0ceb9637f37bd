//! Real pressures above what asperities bear.

use study::plan::{Curve, CurveResult, NominalPressure};
use study::validity::MODULUS_OVER_LARGEST_PRESSURE;
use units::{Remark, RemarkCode};

/// Gathers the real pressures of curves, which may come part by part.
pub struct RealPressures {
    hardness_pa: Option<f64>,
    above_hardness: Above,
    above_third_modulus: Above,
    third_modulus_pa: f64,
}

/// The real pressures above one bound.
#[derive(Default)]
struct Above {
    highest: Option<(f64, String, String)>,
    curves: Vec<String>,
}

impl RealPressures {
    /// An empty collection; the hardness \[Pa\] is that of the material, if it yields.
    #[must_use]
    pub fn new(hardness_pa: Option<f64>) -> Self {
        RealPressures {
            hardness_pa,
            above_hardness: Above::default(),
            above_third_modulus: Above::default(),
            third_modulus_pa: f64::INFINITY,
        }
    }

    /// Adds the real pressure \[Pa\] of a curve under a load with this label.
    pub fn add(&mut self, curve: &Curve, pressure_pa: f64, label: impl Fn() -> String) {
        let third_modulus_pa = curve.model.pair().composite_modulus_pa() / MODULUS_OVER_LARGEST_PRESSURE;
        self.third_modulus_pa = self.third_modulus_pa.min(third_modulus_pa);
        // A strength that grows at small depths bears more than the hardness of the bulk.
        let hardness_pa = self.hardness_pa.filter(|_| !curve.model.strength_grows());
        if hardness_pa.is_some_and(|hardness_pa| pressure_pa > hardness_pa) {
            self.above_hardness.add(curve, pressure_pa, &label);
        }
        if pressure_pa > third_modulus_pa {
            self.above_third_modulus.add(curve, pressure_pa, &label);
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
        let of_hardness = self.above_hardness.remark(RemarkCode::RealAboveHardness).zip(self.hardness_pa);
        let of_hardness = of_hardness.map(|((pressure_pa, remark), hardness_pa)| {
            remark.with("hardness_pa", hardness_pa).with("in_hardnesses", pressure_pa / hardness_pa)
        });
        let of_modulus = self.above_third_modulus.remark(RemarkCode::RealAboveThirdModulus);
        let of_modulus = of_modulus.map(|(_, remark)| remark.with("bound_pa", self.third_modulus_pa));
        of_hardness.into_iter().chain(of_modulus).collect()
    }
}

impl Above {
    fn add(&mut self, curve: &Curve, pressure_pa: f64, label: &impl Fn() -> String) {
        if self.highest.as_ref().is_none_or(|(highest_pa, ..)| pressure_pa > *highest_pa) {
            self.highest = Some((pressure_pa, curve.name.clone(), label()));
        }
        if !self.curves.contains(&curve.name) {
            self.curves.push(curve.name.clone());
        }
    }

    /// Returns the highest pressure \[Pa\], and the remark on it.
    fn remark(self, code: RemarkCode) -> Option<(f64, Remark)> {
        let other_curves = self.curves.len().saturating_sub(1);
        let (pressure_pa, curve, load) = self.highest?;
        let remark = Remark::new(code).with("curve", curve).with("load", load);
        Some((pressure_pa, remark.with("pressure_pa", pressure_pa).with("other_curves", other_curves)))
    }
}
