//! Evidence for the claims: the computed curves of one of the paper's scenes.

use std::error::Error;

use findings::features::Point;
use measurements::NoFiles;
use scene::{Overrides, Scene, Template};
use stacked_contact::{Level, StackedModel};
use stat_contact::{ContactState, NoSeparation};
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

/// Reading of the paper's text: options of a scene that fill what the text leaves open.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Reading {
    /// Name in tables.
    pub name: &'static str,
    /// Lines that replace the one of the paper's scenes.
    options: &'static str,
}

impl Reading {
    /// The reading of the paper's scenes.
    pub const PROGRAM: Reading = Reading { name: "program", options: "flattening = \"area\"" };
    /// The force of a flattened sphere is held with its area.
    pub const FORCE_HELD: Reading =
        Reading { name: "force held", options: "flattening = \"area-and-force\"" };
    /// The area of a scale that yields is the elastic one at p/p*_ep.
    pub const ELASTIC_SHAPE: Reading = Reading {
        name: "elastic shape of yielding scales",
        options: "flattening = \"area\"\nelastic_plastic_area = \"elastic-shape\"",
    };
    /// All readings, among them those with the factor 1 of the moments that Eq. (1) prints.
    pub const ALL: [Reading; 5] = [
        Self::PROGRAM,
        Self::FORCE_HELD,
        Reading {
            name: "moments as printed",
            options: "flattening = \"area\"\nnormalisation = \"as-printed\"",
        },
        Reading {
            name: "force held, moments as printed",
            options: "flattening = \"area-and-force\"\nnormalisation = \"as-printed\"",
        },
        Self::ELASTIC_SHAPE,
    ];
}

/// Scene of the paper with its results.
pub struct Evidence {
    /// Reading of the paper's text.
    pub reading: Reading,
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
        Self::read_as(Reading::PROGRAM, template)
    }

    /// Computes a scene that comes with the program in a reading of the paper.
    ///
    /// # Errors
    /// The error of the scene or its plan.
    pub fn read_as(reading: Reading, template: Template) -> Result<Self, Box<dyn Error>> {
        let text = template.text().replace(Reading::PROGRAM.options, reading.options);
        let scene = Scene::parse(&text, &NoFiles, &Overrides::default())?;
        let results = scene.plan().compute()?;
        Ok(Evidence { reading, template, scene, results })
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

    /// Area over cutoff, for every load that the asperities carry at every cutoff.
    pub(crate) fn areas(&self, name: Name) -> Vec<Vec<Point>> {
        self.areas_of([name]).into_iter().map(|[curve]| curve).collect()
    }

    /// Areas over cutoff of several curves, for every load that the asperities of all of them carry at every cutoff.
    pub(crate) fn areas_of<const N: usize>(&self, names: [Name; N]) -> Vec<[Vec<Point>; N]> {
        let carried = (0..self.scene.needs.loads.len()).filter(|&load| {
            names.iter().all(|name| {
                let states = self.results.curves[self.index(*name)].statistical();
                let rows = states.map_or(&[][..], |blocks| &blocks[load][..]);
                rows.iter().filter_map(|row| row.contact).all(|(_, state)| is_carried(&state))
            })
        });
        let curve = |name, load| self.results.curves[self.index(name)].area_fractions(load);
        carried.map(|load| names.map(|name| curve(name, load))).collect()
    }

    /// Loads \[Pa\] and areas at the shortest cutoff, for every load that has a state there.
    pub(crate) fn final_areas(&self, name: Name) -> Vec<Point> {
        let result = &self.results.curves[self.index(name)];
        let at_end = |(load, load_pa): (usize, f64)| {
            let last = result.statistical().and_then(|blocks| blocks[load].last()?.contact);
            let (_, area) = *result.area_fractions(load).last()?;
            last.is_none_or(|(_, state)| is_carried(&state)).then_some((load_pa, area))
        };
        self.loads_pa().into_iter().enumerate().filter_map(at_end).collect()
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

/// True unless a pressure is more than all asperities carry once flattened.
pub(crate) fn is_carried(state: &ContactState) -> bool {
    state.no_separation() != Some(NoSeparation::AllFlattened)
}
