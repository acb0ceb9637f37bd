//! Stacks of scales: their numbers, and the promises of every level.

use asperity::{AsperityError, Bound};
use stacked_contact::{Level, Scale, StackedModel, largest_full_contact_pressure_pa, levels};

use crate::tally::{Case, Refused, Trial};
use crate::{Draw, Material, Reach};

/// Stack under a nominal pressure; printed, it is a literal that recreates it.
#[derive(Debug, Clone, PartialEq)]
pub struct StackCase {
    /// Bodies in contact.
    pub material: Material,
    /// True if they yield.
    pub plastic: bool,
    /// Nominal pressure \[Pa\].
    pub pressure_pa: f64,
    /// Scales from long to short.
    pub scales: Vec<Scale>,
}

impl StackCase {
    /// Deformation law of its scales.
    ///
    /// # Errors
    /// [`AsperityError`] if a number is refused.
    pub fn model(&self) -> Result<StackedModel, AsperityError> {
        let pair = self.material.pair()?;
        Ok(if self.plastic {
            let strength = self.material.strength()?;
            StackedModel::ElasticPlastic { pair, strength, area: Default::default() }
        } else {
            StackedModel::Elastic { pair }
        })
    }
}

impl Case for StackCase {
    fn draw(draw: &mut Draw) -> (Self, Reach) {
        let reach = Reach::draw(draw);
        let [pressure, longest, ratio] = match reach {
            Reach::Usual => [(2.0, 11.0), (-7.0, -2.0), (-4.0, 0.0)],
            _ => [(-30.0, 20.0), (-12.0, 3.0), (-20.0, 6.0)],
        };
        let mut wavelength_m = draw.decades(longest.0, longest.1);
        let number = draw.between(1.0, 40.0) as usize;
        let scales = (0..number).map(|_| {
            wavelength_m *= draw.decades(-0.5, -0.01);
            Scale { wavelength_m, amplitude_m: wavelength_m * reach.number(draw, ratio.0, ratio.1) }
        });
        let scales: Vec<Scale> = scales.collect();
        let gradient = draw.chance(0.4);
        let material = Material::draw(draw, reach, gradient, 1e-6);
        let plastic = draw.chance(0.8);
        (
            StackCase { material, plastic, pressure_pa: reach.number(draw, pressure.0, pressure.1), scales },
            reach,
        )
    }

    fn test(trial: &mut Trial<Self>) -> Result<(), Refused> {
        let case = trial.case;
        // Numbers beyond thirty decades are outside of the laws' range.
        let admitted = case.scales.iter().all(|scale| Bound::Magnitude.admits(scale.aspect_ratio()));
        let model = case.model()?;
        if !admitted {
            return Err(Refused);
        }
        let curve: Vec<Level> = levels(&model, case.pressure_pa, case.scales.iter().copied()).collect();
        for level in &curve {
            trial.hold("stack: area fraction in [0, 1]", (0.0..=1.0).contains(&level.area_fraction));
            trial.hold("stack: pressure no NaN, never falls", level.real_pressure_pa >= level.pressure_in_pa);
            trial.hold(
                "stack: strength no NaN",
                level.yield_strength_pa.is_none_or(|strength_pa| strength_pa > 0.0),
            );
            if trial.reach != Reach::Edge {
                trial.hold("stack: finite", level.real_pressure_pa.is_finite());
                let load_pa = level.area_fraction * level.real_pressure_pa;
                trial.bound("stack: load", (load_pa / case.pressure_pa - 1.0).abs(), 4.0 * f64::EPSILON);
            }
        }
        trial.hold(
            "stack: area falls",
            curve.is_sorted_by(|long, short| long.area_fraction >= short.area_fraction),
        );
        if let (Some(last), true) = (curve.last(), trial.reach != Reach::Edge)
            && let Some(largest_pa) = largest_full_contact_pressure_pa(&model, case.scales.iter().copied())
        {
            let bound_pa = largest_pa.max(case.pressure_pa) * (1.0 + 1e-12);
            trial.bound("stack: pressure within complete contact", last.real_pressure_pa, bound_pa);
        }
        Ok(())
    }
}
