//! States of the statistical model: their numbers, and how they are drawn.

use asperity::{AsperityError, Hardness};
pub use stat_contact::Condition as Question;
use stat_contact::{ContactState, Population, StatisticalContact};

use crate::law::Response;
use crate::{Draw, Material, Reach};

/// Laws of the statistical model; those with a strain gradient are separate.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Kind {
    /// Elastic spheres.
    Hertz,
    /// Elastic-plastic spheres.
    EpSphere,
    /// Elastic-plastic spheres with a strain gradient.
    GradientSphere,
    /// Elastic sinusoids.
    ElasticSine,
    /// Elastic sinusoids by boundary elements.
    BemSine,
    /// Elastic-plastic sinusoids.
    EpSine,
    /// Elastic-plastic sinusoids with a strain gradient.
    GradientSine,
}

units::named!(Kind, "law", {
    Hertz => "hertz",
    EpSphere => "ep-sphere",
    GradientSphere => "ep-sphere, strain gradient",
    ElasticSine => "elastic-sine",
    BemSine => "elastic-sine, bem",
    EpSine => "ep-sine",
    GradientSine => "ep-sine, strain gradient",
});

impl Kind {
    /// True if the force of an asperity never falls with its interference.
    pub fn force_rises(self) -> bool {
        !matches!(self, Kind::EpSphere | Kind::GradientSphere | Kind::GradientSine)
    }

    /// True if the area of an asperity never falls: that of Johnson's sinusoid steps down where its branches meet.
    pub(crate) fn area_rises(self) -> bool {
        !matches!(self, Kind::ElasticSine | Kind::EpSine | Kind::GradientSine)
    }

    fn has_gradient(self) -> bool {
        matches!(self, Kind::GradientSphere | Kind::GradientSine)
    }
}

/// Population of asperities of a material, and a given quantity; printed, it is a literal that recreates it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StatisticalCase {
    /// Law of the asperities.
    pub kind: Kind,
    /// Bodies in contact.
    pub material: Material,
    /// Hardness form of spheres.
    pub hardness: Hardness,
    /// Radius R \[m\].
    pub radius_m: f64,
    /// Density eta \[m^-2\].
    pub density_per_m2: f64,
    /// Standard deviation of the heights sigma_s \[m\].
    pub sigma_s_m: f64,
    /// Relative tolerance.
    pub tolerance: f64,
    /// Given quantity.
    pub question: Question,
}

impl StatisticalCase {
    /// Draws a random case, with the range of its numbers.
    pub fn draw(draw: &mut Draw, kind: Kind) -> (Self, Reach) {
        let reach = Reach::draw(draw);
        let (sigma_s_m, radius_m, density_per_m2) = match reach {
            Reach::Usual => {
                let sigma_s_m = draw.decades(-10.0, -5.0);
                let radius_m = sigma_s_m * draw.decades(-1.0, 4.0);
                (sigma_s_m, radius_m, draw.decades(-3.0, -0.5) / (radius_m * sigma_s_m))
            }
            _ => (
                reach.number(draw, -15.0, 0.0),
                reach.number(draw, -15.0, 3.0),
                reach.number(draw, -3.0, 28.0),
            ),
        };
        let material = Material::draw(draw, reach, kind.has_gradient(), sigma_s_m);
        let digits = draw.between(1.0, 14.0);
        let tolerance = draw.one_of(&[10f64.powf(-digits), 10f64.powf(-digits), 1e-12, 1e-10]);
        let mut case = StatisticalCase {
            kind,
            material,
            hardness: draw.one_of(Hardness::ALL),
            radius_m,
            density_per_m2,
            sigma_s_m,
            tolerance,
            question: Question::Separation(0.0),
        };
        case.question = case.draw_question(draw, reach);
        (case, reach)
    }

    fn draw_question(&self, draw: &mut Draw, reach: Reach) -> Question {
        if draw.chance(0.3) {
            return Question::Pressure(match reach {
                Reach::Usual => self.material.youngs_modulus_pa * draw.decades(-9.0, 0.0),
                _ => reach.number(draw, -12.0, 15.0),
            });
        }
        let near = draw.between(-8.0, 12.0);
        let far = draw.one_of(&[-1.0, 1.0]) * draw.decades(-6.0, 3.0);
        let beyond = draw.one_of(&[-1.0, 1.0]) * draw.decades(3.0, 12.0);
        let fixed = draw.one_of(&[0.0, -0.0, -1e6, 5e-324, 60.0, -60.0]);
        let u = match draw.between(0.0, 1.0) {
            share if share < 0.5 => near,
            share if share < 0.75 => far,
            share if share < 0.80 => beyond,
            share if share < 0.85 || reach == Reach::Edge => draw.near(fixed),
            _ => {
                let at_a_break_m = self.draw_separation_at_a_break_m(draw);
                return Question::Separation(at_a_break_m.unwrap_or(near * self.sigma_s_m));
            }
        };
        let edge = reach == Reach::Edge && draw.chance(0.1);
        Question::Separation(if edge { draw.one_of(&[-1.0, 1.0]) * draw.edge() } else { u * self.sigma_s_m })
    }

    /// Draws a separation at which the mean height, or one a few standard deviations beside it, is at a break of the
    /// law.
    fn draw_separation_at_a_break_m(&self, draw: &mut Draw) -> Option<f64> {
        let breaks_m = self.response().ok()?.breaks_m();
        if breaks_m.is_empty() {
            return None;
        }
        let at_m = -draw.one_of(&breaks_m);
        let beside = draw.between(-4.0, 4.0);
        Some(if draw.chance(0.5) { draw.near(at_m) } else { at_m + beside * self.sigma_s_m })
    }

    /// Law of its asperities.
    ///
    /// # Errors
    /// [`AsperityError`] if a number is refused.
    pub fn response(&self) -> Result<Response, AsperityError> {
        Response::new(self.kind, &self.material, self.hardness, self.radius_m, self.density_per_m2)
    }

    /// Contact of its population.
    ///
    /// # Errors
    /// [`AsperityError`] if a number is refused.
    pub fn contact(&self) -> Result<StatisticalContact, AsperityError> {
        let population = Population::new(self.radius_m, self.density_per_m2, self.sigma_s_m)?;
        Ok(StatisticalContact::new(&self.material.pair()?, &population, &self.response()?.law()))
    }

    /// State at the given quantity.
    ///
    /// # Errors
    /// [`AsperityError`] if a number is refused.
    pub fn state(&self) -> Result<ContactState, AsperityError> {
        self.state_of(&self.contact()?)
    }

    pub(crate) fn state_of(&self, contact: &StatisticalContact) -> Result<ContactState, AsperityError> {
        contact.at(self.question, self.tolerance, None)
    }
}
