//! Laws of one asperity for a population, built from their own crate alone: the integrals of `stat-contact` must not
//! be compared with its own laws.

use std::f64::consts::TAU;

use asperity::{
    AsperityError, BemSinusoid, ElasticPlasticSinusoid, ElasticSinusoid, Hardness, Hertz, JacksonGreen,
    MaterialPair, NixGao,
};
use stat_contact::{AsperityLaw, InterferenceLaw};

use crate::{Kind, Material};

/// Population under a law: eta F and eta A at an interference.
#[derive(Debug, Clone, Copy)]
pub struct Response {
    kind: Kind,
    pair: MaterialPair,
    strength: NixGao,
    hardness: Hardness,
    radius_m: f64,
    density_per_m2: f64,
    /// Amplitude of the sinusoid with this density and curvature (Jackson & Jacobs, Eqs. 6 and 7).
    amplitude_m: f64,
    aspect_ratio: f64,
}

impl Response {
    /// Creates asperities of radius R \[m\], eta of them per area \[m^-2\].
    ///
    /// # Errors
    /// [`AsperityError`] if a number of the material is refused.
    pub fn new(
        kind: Kind,
        material: &Material,
        hardness: Hardness,
        radius_m: f64,
        density_per_m2: f64,
    ) -> Result<Self, AsperityError> {
        let wavelength_m = (2.0 / density_per_m2).sqrt();
        let amplitude_m = (wavelength_m / TAU) * (wavelength_m / TAU / radius_m);
        Ok(Response {
            kind,
            pair: material.pair()?,
            strength: material.strength()?,
            hardness,
            radius_m,
            density_per_m2,
            amplitude_m,
            aspect_ratio: amplitude_m / wavelength_m,
        })
    }

    /// Law as the statistical model names it.
    pub fn law(&self) -> AsperityLaw {
        let (strength, hardness) = (self.strength, self.hardness);
        match self.kind {
            Kind::Hertz => AsperityLaw::Hertz,
            Kind::EpSphere | Kind::GradientSphere => {
                AsperityLaw::EpSphere { strength, hardness, held_from: None }
            }
            Kind::ElasticSine => AsperityLaw::ElasticSine { interference: InterferenceLaw::RostamiJackson },
            Kind::BemSine => AsperityLaw::ElasticSine { interference: InterferenceLaw::Bem },
            Kind::EpSine | Kind::GradientSine => AsperityLaw::EpSine { strength },
        }
    }

    /// Pressure eta F \[Pa\] and area fraction eta A at the interference w > 0 \[m\].
    pub fn at(&self, interference_m: f64) -> (f64, f64) {
        let ratio = interference_m / self.amplitude_m;
        match self.kind {
            Kind::Hertz => {
                let sphere = Hertz::new(&self.pair, self.radius_m);
                self.times_density(sphere.force_n(interference_m), sphere.area_m2(interference_m))
            }
            Kind::EpSphere | Kind::GradientSphere => {
                let sphere = self.sphere(interference_m);
                self.times_density(sphere.force_n(interference_m), sphere.area_m2(interference_m))
            }
            Kind::ElasticSine => {
                let sinusoid = ElasticSinusoid::new(&self.pair, self.aspect_ratio);
                let pressure_pa = sinusoid.pressure_at_interference_pa(ratio);
                (pressure_pa, if ratio < 1.0 { sinusoid.area_fraction(pressure_pa) } else { 1.0 })
            }
            Kind::BemSine => {
                let sinusoid = BemSinusoid::new(&self.pair, self.aspect_ratio);
                let pressure_pa = sinusoid.pressure_at_interference_pa(ratio);
                (pressure_pa, if ratio < 1.0 { sinusoid.area_fraction(pressure_pa) } else { 1.0 })
            }
            Kind::EpSine | Kind::GradientSine => {
                let sinusoid = self.sinusoid(interference_m);
                let pressure_pa = sinusoid.pressure_at_interference_pa(ratio);
                (pressure_pa, if ratio < 1.0 { sinusoid.area_fraction(pressure_pa) } else { 1.0 })
            }
        }
    }

    /// Interferences \[m\] at which the law announces a kink or jump; with a strain gradient those that follow from
    /// the strength alone, and the one at which the area of spheres is complete.
    pub fn breaks_m(&self) -> Vec<f64> {
        let mut breaks_m: Vec<f64> = match self.kind {
            Kind::Hertz => Vec::new(),
            Kind::EpSphere => self.sphere(1.0).breaks().map(|b| b.at).collect(),
            Kind::GradientSphere => {
                let onset_m = self.gradient_onset_m();
                vec![onset_m, self.gradient_cap_m(onset_m)]
            }
            Kind::ElasticSine => {
                let sinusoid = ElasticSinusoid::new(&self.pair, self.aspect_ratio);
                sinusoid
                    .breaks()
                    .map(|b| self.amplitude_m * sinusoid.deformation_over_amplitude(b.at))
                    .collect()
            }
            Kind::BemSine => {
                let sinusoid = BemSinusoid::new(&self.pair, self.aspect_ratio);
                sinusoid
                    .breaks()
                    .map(|b| self.amplitude_m * sinusoid.deformation_over_amplitude(b.at))
                    .collect()
            }
            Kind::EpSine => {
                let sinusoid = self.sinusoid(1.0);
                let onset_pa = sinusoid.flow_onset_pressure_pa().unwrap_or(f64::INFINITY);
                let ratio = |at_pa: f64| {
                    if at_pa <= onset_pa {
                        sinusoid.elastic().deformation_over_amplitude(at_pa)
                    } else {
                        sinusoid.deformation_over_amplitude(at_pa)
                    }
                };
                let own = sinusoid.breaks().chain(sinusoid.elastic().breaks()).map(|b| b.at);
                own.chain([onset_pa]).map(|at_pa| self.amplitude_m * ratio(at_pa)).collect()
            }
            Kind::GradientSine => {
                let weakest = self.sinusoid(f64::INFINITY);
                let critical_pa =
                    weakest.aspect_ratio_over_critical() * self.strength.macroscopic_strength_pa();
                vec![self.amplitude_m, self.strength.depth_of_strength_m(critical_pa).unwrap_or(0.0)]
            }
        };
        if matches!(self.kind, Kind::GradientSine | Kind::GradientSphere) {
            breaks_m.extend(self.strength.cap_depth_m());
        }
        breaks_m.retain(|at_m| *at_m > 0.0 && at_m.is_finite());
        breaks_m
    }

    /// Interferences \[m\] between two others at which the law has a kink or jump: those of
    /// [`breaks_m`](Self::breaks_m), and for a sinusoid with a strain gradient also the changes of branch, which it
    /// does not announce.
    pub fn kinks_m(&self, from_m: f64, to_m: f64) -> Vec<f64> {
        // Nine decades at ten samples each; two changes between two of them are not seen.
        const SAMPLES: u32 = 90;
        const DECADES: f64 = 9.0;
        const HALVINGS: usize = 60;
        let mut kinks_m = self.breaks_m();
        if self.kind != Kind::GradientSine {
            return kinks_m;
        }
        let to_m = to_m.min(self.amplitude_m * (1.0 - f64::EPSILON));
        let low = (from_m.max(to_m * 10f64.powf(-DECADES))).ln();
        let sample = |i: u32| low + (to_m.ln() - low) * f64::from(i) / f64::from(SAMPLES);
        for i in 0..SAMPLES {
            let (mut before, mut behind) = (sample(i), sample(i + 1));
            let branch = self.branch(before.exp());
            if branch == self.branch(behind.exp()) {
                continue;
            }
            for _ in 0..HALVINGS {
                let middle = 0.5 * (before + behind);
                if self.branch(middle.exp()) == branch { before = middle } else { behind = middle }
            }
            kinks_m.push(behind.exp());
        }
        kinks_m
    }

    /// Branch of a sinusoid at an interference: yields, has a plastic pressure, has complete area, and would have an
    /// elastic area on the limit of heavy loads.
    fn branch(&self, interference_m: f64) -> [bool; 4] {
        let ratio = interference_m / self.amplitude_m;
        let sinusoid = self.sinusoid(interference_m);
        let pressure_pa = sinusoid.pressure_at_interference_pa(ratio);
        let elastic_pa = sinusoid.elastic().pressure_at_interference_pa(ratio);
        let is_plastic = pressure_pa < elastic_pa * (1.0 - 1e-12);
        let joined_up_to_pa =
            ElasticSinusoid::JOINED_UP_TO * sinusoid.elastic().complete_contact_pressure_pa();
        [
            sinusoid.yields_at(pressure_pa),
            is_plastic,
            sinusoid.area_fraction(pressure_pa) >= 1.0,
            pressure_pa >= joined_up_to_pa,
        ]
    }

    fn times_density(&self, force_n: f64, area_m2: f64) -> (f64, f64) {
        (self.density_per_m2 * force_n, self.density_per_m2 * area_m2)
    }

    fn sphere(&self, depth_m: f64) -> JacksonGreen {
        JacksonGreen::new(&self.pair, self.radius_m, self.strength.at_depth_pa(depth_m), self.hardness)
    }

    fn sinusoid(&self, depth_m: f64) -> ElasticPlasticSinusoid {
        ElasticPlasticSinusoid::new(&self.pair, self.aspect_ratio, self.strength.at_depth_pa(depth_m))
    }

    /// Positive root of w^2 - 1.9 w_c0 (w + h*).
    fn gradient_onset_m(&self) -> f64 {
        let half_m = 0.5 * self.sphere(f64::INFINITY).plastic_onset_m();
        let length_m = self.strength.strain_gradient_length_m().unwrap_or(0.0);
        half_m + (half_m * (half_m + 2.0 * length_m)).sqrt()
    }

    /// Interference at which the area of a sphere whose strength depends on the depth reaches its cross-section: w =
    /// R while Hertzian, else between the onset and R, by bisection.
    fn gradient_cap_m(&self, onset_m: f64) -> f64 {
        const HALVINGS: usize = 64;
        if onset_m >= self.radius_m {
            return self.radius_m;
        }
        let (mut low, mut high) = (onset_m.ln(), self.radius_m.ln());
        for _ in 0..HALVINGS {
            let middle = 0.5 * (low + high);
            let depth_m = middle.exp();
            if self.sphere(depth_m).log_area_over_cross_section(depth_m) < 0.0 {
                low = middle;
            } else {
                high = middle;
            }
        }
        high.exp()
    }
}
