//! Evidence for the claims: the computed curves of one of the paper's scenes.

use std::error::Error;

use findings::features::Point;
use scene::{Scene, Template};
use stacked_contact::{Level, StackedModel};
use stat_contact::ContactState;
use study::plan::Results;

/// Name of a curve of the paper, as in the scenes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Name(pub &'static str);

pub(crate) const ELASTIC: Name = Name("elastic");
pub(crate) const PLASTIC: Name = Name("elastic-plastic");
pub(crate) const PLASTIC_GRADIENT: Name = Name("elastic-plastic-strain-gradient");
pub(crate) const HERTZ: Name = Name("hertz");
pub(crate) const SPHERE: Name = Name("ep-sphere");
pub(crate) const SPHERE_GRADIENT: Name = Name("ep-sphere-strain-gradient");
pub(crate) const SINE_ELASTIC: Name = Name("elastic-sine");
pub(crate) const SINE: Name = Name("ep-sine");
pub(crate) const SINE_GRADIENT: Name = Name("ep-sine-strain-gradient");

/// All curves of the paper.
pub(crate) const ALL: [Name; 9] =
    [ELASTIC, PLASTIC, PLASTIC_GRADIENT, HERTZ, SPHERE, SPHERE_GRADIENT, SINE_ELASTIC, SINE, SINE_GRADIENT];

/// Pairs of an elastic-plastic curve and the elastic one of the same asperities.
pub(crate) const PLASTIC_AND_ELASTIC: [(Name, Name); 3] =
    [(PLASTIC, ELASTIC), (SPHERE, HERTZ), (SINE, SINE_ELASTIC)];

/// Pairs of a curve with scale-dependent strength and the one without.
pub(crate) const GRADIENT_AND_PLAIN: [(Name, Name); 3] =
    [(PLASTIC_GRADIENT, PLASTIC), (SPHERE_GRADIENT, SPHERE), (SINE_GRADIENT, SINE)];

/// Scene of the paper with its results.
pub struct Evidence {
    /// Template of the scene, which names its spectrum.
    pub template: Template,
    /// Scene as parsed.
    pub scene: Scene,
    /// Results of the scene.
    pub results: Results,
}

impl Evidence {
    /// Computes a scene that comes with the program.
    ///
    /// # Errors
    /// The error of the scene or its plan.
    pub fn compute(template: Template) -> Result<Self, Box<dyn Error>> {
        let scene = Scene::builtin(template)?;
        let results = scene.plan().compute()?;
        Ok(Evidence { template, scene, results })
    }

    /// True if the spectrum was reconstructed from numbers that the paper prints.
    pub(crate) fn is_reconstruction(&self) -> bool {
        self.template == Template::UncdReconstructed
    }

    /// Shortest wavelength of the spectrum \[m\].
    pub(crate) fn shortest_m(&self) -> f64 {
        self.results.psd.shortest_wavelength_m()
    }

    /// Aspect ratio over wavelength.
    pub(crate) fn aspect_ratios(&self) -> Vec<Point> {
        self.results.scales.iter().map(|scale| (scale.wavelength_m, scale.aspect_ratio())).collect()
    }

    /// Loads \[Pa\].
    pub(crate) fn loads_pa(&self) -> Vec<f64> {
        self.scene.needs.loads.iter().map(|load| load.nominal_pressure_pa()).collect()
    }

    /// Hardness \[Pa\].
    pub(crate) fn hardness_pa(&self) -> f64 {
        self.scene.hardness_pa().expect("the paper's material has a strength")
    }

    /// Area over cutoff, for every load.
    pub(crate) fn areas(&self, name: Name) -> Vec<Vec<Point>> {
        let result = &self.results.curves[self.index(name)];
        (0..self.scene.needs.loads.len()).map(|load| result.area_fractions(load)).collect()
    }

    /// Area at the shortest cutoff, for every load.
    pub(crate) fn final_areas(&self, name: Name) -> Vec<f64> {
        let last = |curve: &Vec<Point>| curve.last().expect("the paper's curves have areas at every load").1;
        self.areas(name).iter().map(last).collect()
    }

    /// Stacked curve: its model, and its levels for every load.
    pub(crate) fn stack(&self, name: Name) -> (StackedModel, &[Vec<Level>]) {
        let index = self.index(name);
        let model = self.scene.needs.curves[index].model.stacked();
        let (model, levels) = model
            .zip(self.results.curves[index].stacked())
            .unwrap_or_else(|| panic!("{} is stacked in the paper's scenes", name.0));
        (*model, levels)
    }

    /// Statistical curve over load: for every cutoff multiple, the states under rising pressures \[Pa\].
    pub(crate) fn sweeps(&self, name: Name) -> Vec<(f64, &[f64], &[ContactState])> {
        let index = self.index(name);
        let sweeps = self.scene.needs.sweeps.iter().zip(&self.results.sweeps);
        sweeps
            .filter(|(sweep, _)| sweep.curve == index)
            .map(|(sweep, found)| (sweep.cutoff_multiple, &sweep.pressures_pa[..], &found.states[..]))
            .collect()
    }

    /// Contact modulus E* \[Pa\].
    pub(crate) fn contact_modulus_pa(&self) -> f64 {
        let material = self.scene.material.expect("the paper's scenes have a material");
        material.pair.composite_modulus_pa()
    }

    fn index(&self, name: Name) -> usize {
        let curves = &self.scene.needs.curves;
        let index = curves.iter().position(|curve| curve.name == name.0);
        index.unwrap_or_else(|| panic!("the paper's scenes have a curve {}", name.0))
    }
}
