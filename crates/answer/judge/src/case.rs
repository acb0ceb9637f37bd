//! A scene as the judge sees it: its bodies and their hardness, and the pressures that closed forms give at each scale.

use asperity::LayerCompliance;
use elements::half_space::{Elements, Grid, HalfSpaceError};
use measurements::MapPatch;
use scene::Scene;
use spectrum::random_surfaces::AreaSpectrum;
use spectrum::{Moments, Normalisation, amplitudes, cumulative_moments};
use study::plan::Results;
use study::validity::SMALL_SLOPE_PRESSURE;

use units::Remark;

use crate::assumptions::{CurveAtLoad, first_broken, real_pressures};
use crate::body::{BodyKind, Reference};
use crate::closed_form::ClosedForm;
use crate::hardness_of_scales::{AboveHardness, HardnessOfScales};
use crate::seam::{self, Seam};
use crate::waves::Waves;
use crate::window::{Band, Window};
use crate::yielding::Yielding;

/// The most maps that are pressed.
const MAX_MAPS: usize = 3;

/// The closed forms about a window; those of longer waves are `None` if there are none.
#[derive(Debug, Clone, Copy)]
pub(crate) struct WindowForms {
    pub band: Band,
    /// The waves longer than the window.
    longer: Option<ClosedForm>,
    /// All waves down to the end of the window.
    all: Option<ClosedForm>,
    /// The window's own waves.
    own: ClosedForm,
}

/// The curves and loads of a scene with what does not depend on how they are judged.
pub(crate) struct Case<'s> {
    pub scene: &'s Scene,
    pub results: &'s Results,
    pub composite_modulus_pa: f64,
    /// Displacement of the layer under waves, if the rough body is one.
    layer: Option<LayerCompliance>,
    /// The waves of the spectrum's surface; `None` if the spectrum has too few samples, or is noise alone.
    pub waves: Option<Waves>,
    /// The distinct bodies of elements that the curves and the material need.
    pub references: Vec<Reference>,
    /// The loads by index, from light to heavy.
    pub loads_by_pressure: Vec<usize>,
    /// Moments of the spectrum at every cutoff but the longest.
    moments: Vec<Moments>,
    /// The body of every curve.
    bodies: Vec<BodyKind>,
    /// The place in `references` of the elements that every curve under every load is compared with, in the order of
    /// [`all`](Self::all).
    compared_with: Vec<usize>,
    /// The bulk hardness at each scale, for a material that yields.
    constant_hardness: Option<HardnessOfScales>,
    /// The hardness that grows with the strain-gradient length, for a material that has one.
    growing_hardness: Option<HardnessOfScales>,
    /// The first broken assumption of every curve under every load, with the wavelength \[m\] from which on it is broken, in the
    /// order of [`all`](Self::all).
    broken: Vec<Option<(f64, Remark)>>,
}

impl<'s> Case<'s> {
    pub fn new(scene: &'s Scene, results: &'s Results) -> Self {
        let bodies: Vec<BodyKind> =
            scene.needs.curves.iter().map(|curve| BodyKind::from_model(&curve.model)).collect();
        let pressure_pa = |load: &usize| scene.needs.loads[*load].nominal_pressure_pa();
        let mut loads_by_pressure: Vec<usize> = (0..scene.needs.loads.len()).collect();
        loads_by_pressure.sort_by(|a, b| pressure_pa(a).total_cmp(&pressure_pa(b)));
        let scales = amplitudes(&results.psd, scene.needs.amplitudes.unwrap_or_default());
        let hardness = |strain_gradient: bool| {
            let strength = scene.material.as_ref()?.strength(strain_gradient).ok()?;
            Some(HardnessOfScales::new(&strength, &scales))
        };
        let layer = scene.material.and_then(|material| material.pair.layer_compliance());
        let surface =
            (results.psd.len() > 1).then(|| AreaSpectrum::from_profile(&results.psd).ok()).flatten();
        let mut case = Case {
            scene,
            results,
            composite_modulus_pa: scene.material.map_or(1.0, |material| material.pair.composite_modulus_pa()),
            layer,
            waves: surface.map(|surface| Waves::new(surface, layer.as_ref())),
            references: Vec::new(),
            compared_with: Vec::new(),
            loads_by_pressure,
            moments: cumulative_moments(&results.psd, Normalisation::default()),
            bodies,
            constant_hardness: hardness(false),
            growing_hardness: hardness(true),
            broken: Vec::new(),
        };
        case.find_references();
        case.broken = case.all().map(|at| first_broken(scene, results, at, case.hardness())).collect();
        case
    }

    /// Every curve under every load, curve by curve.
    pub fn all(&self) -> impl Iterator<Item = CurveAtLoad> + use<> {
        let loads = 0..self.loads();
        (0..self.curves()).flat_map(move |curve| loads.clone().map(move |load| CurveAtLoad { curve, load }))
    }

    pub fn curves(&self) -> usize {
        self.bodies.len()
    }

    pub fn loads(&self) -> usize {
        self.scene.needs.loads.len()
    }

    /// The band of the whole spectrum.
    pub fn band(&self) -> Band {
        let psd = &self.results.psd;
        Band { longest_m: psd.longest_wavelength_m(), shortest_m: psd.shortest_wavelength_m() }
    }

    pub fn nominal_pressure_pa(&self, load: usize) -> f64 {
        self.scene.needs.loads[load].nominal_pressure_pa()
    }

    /// True if the strength of a curve's body grows at small scales.
    pub fn strength_grows(&self, curve: usize) -> bool {
        matches!(self.bodies[curve], BodyKind::Growing | BodyKind::GrowingByOwnLaw)
    }

    /// The scale from which on a curve yields by a hardness law of its own, which no elements have.
    pub fn yields_by_own_law(&self, at: CurveAtLoad) -> Option<AboveHardness> {
        (self.bodies[at.curve] == BodyKind::GrowingByOwnLaw).then(|| self.yields_while_growing(at)).flatten()
    }

    /// Finds the elements that every curve is compared with, and those that the material needs besides.
    fn find_references(&mut self) {
        let of_curves: Vec<Reference> = self.all().map(|at| self.reference_of_curve(at)).collect();
        let of_material = (0..self.loads()).flat_map(|load| self.references_of_material(load));
        let mut references: Vec<Reference> = Vec::new();
        let needed = of_curves.iter().copied().chain(of_material);
        for reference in needed.flat_map(|reference| [Some(reference), self.softer_than(reference)]).flatten()
        {
            if !references.contains(&reference) {
                references.push(reference);
            }
        }
        let place = |reference: &Reference| references.iter().position(|other| other == reference);
        self.compared_with = of_curves.iter().filter_map(place).collect();
        self.references = references;
    }

    /// The elements that match a curve. A body whose strength grows is elastic under loads at which it never yields.
    fn reference_of_curve(&self, at: CurveAtLoad) -> Reference {
        match self.bodies[at.curve].reference() {
            Reference::Growing if self.yields_while_growing(at).is_none() => Reference::Elastic,
            reference => reference,
        }
    }

    /// The bodies that the material may be under a load: elastic unless an elastic contact would exceed its hardness. If that
    /// grows at small scales, bodies with the constant hardness touch the most that is possible.
    fn references_of_material(&self, load: usize) -> Vec<Reference> {
        let yielding = self.yielding(load);
        let constant = self.scene.material.and_then(|material| material.hardness_pa());
        let Some(hardness_pa) = constant.filter(|_| yielding.above_constant.is_some()) else {
            return vec![Reference::Elastic];
        };
        let constant = Reference::Yielding { hardness_pa };
        match (yielding.hardness_grows, yielding.above_growing) {
            (false, _) => vec![constant],
            (true, None) => vec![Reference::Elastic, constant],
            (true, Some(_)) => vec![Reference::Growing],
        }
    }

    /// The bodies as soft as bodies can be whose hardness grows: those with the material's constant hardness.
    fn softer_than(&self, reference: Reference) -> Option<Reference> {
        let hardness_pa = self.scene.material.and_then(|material| material.hardness_pa())?;
        (reference == Reference::Growing).then_some(Reference::Yielding { hardness_pa })
    }

    /// The place in `references` of the bodies with the constant hardness, for a body whose hardness grows.
    pub fn constant_body(&self, body: usize) -> Option<usize> {
        let constant = self.softer_than(self.references[body])?;
        self.references.iter().position(|other| *other == constant)
    }

    /// The bound \[Pa\] on the pressure of a body's elements on the waves about a wavelength \[m\]; `None` for an elastic body.
    pub fn saturation_pa(&self, reference: Reference, wavelength_m: f64) -> Option<f64> {
        match reference {
            Reference::Elastic => None,
            Reference::Yielding { hardness_pa } => Some(hardness_pa),
            Reference::Growing => self.growing_hardness.as_ref().map(|hardness| hardness.at_pa(wavelength_m)),
        }
    }

    /// The least area fraction of elements on the surface: a nominal pressure takes that share of a surface that flows. 0 of
    /// elastic elements.
    pub fn least_area(&self, reference: Reference, load: usize) -> f64 {
        self.saturation_pa(reference, self.band().shortest_m)
            .map_or(0.0, |bound_pa| (self.nominal_pressure_pa(load) / bound_pa).min(1.0))
    }

    /// The elements that a curve is compared with.
    pub fn reference(&self, at: CurveAtLoad) -> Reference {
        self.references[self.body(at)]
    }

    /// The place in `references` of the elements that a curve is compared with.
    pub fn body(&self, at: CurveAtLoad) -> usize {
        self.compared_with[self.place(at)]
    }

    /// The place of a curve under a load in the order of [`all`](Self::all).
    fn place(&self, CurveAtLoad { curve, load }: CurveAtLoad) -> usize {
        curve * self.loads() + load
    }

    /// The area fraction of a curve at the shortest wavelength.
    pub fn final_area(&self, at: CurveAtLoad) -> Option<f64> {
        self.results.curves[at.curve].area_fractions(at.load).last().map(|(_, area)| *area)
    }

    /// The rms pressure \[Pa\] of full contact with all waves of the surface down to a wavelength \[m\]. These are fewer waves
    /// than profiles show: a long wave of a profile is a shorter wave of the surface, cut at an angle.
    pub fn rms_pressure_pa(&self, wavelength_m: f64) -> f64 {
        let gradient = self.waves_down_to(wavelength_m).map_or(0.0, |waves| waves.flattening_gradient());
        0.5 * self.composite_modulus_pa * gradient
    }

    /// The waves of the surface down to a wavelength \[m\]; `None` if there are none.
    fn waves_down_to(&self, wavelength_m: f64) -> Option<Waves> {
        let longest_m = self.results.psd.longest_wavelength_m();
        self.waves.as_ref().and_then(|waves| waves.cut(longest_m, wavelength_m).ok())
    }

    /// The closed form for all waves of the surface down to a wavelength \[m\]; `None` if there are none.
    pub fn closed_form(&self, wavelength_m: f64) -> Option<ClosedForm> {
        let waves = self.waves_down_to(wavelength_m)?;
        Some(ClosedForm::new(&waves, self.composite_modulus_pa))
    }

    /// The closed forms about a window.
    pub fn forms(&self, window: &Window) -> WindowForms {
        let Band { longest_m, shortest_m } = window.band;
        let longer = self.closed_form(longest_m);
        WindowForms {
            band: window.band,
            longer,
            all: longer.and_then(|_| self.closed_form(shortest_m)),
            own: ClosedForm::new(&window.waves, self.composite_modulus_pa),
        }
    }

    /// The mean real pressure \[Pa\] that longer waves leave on a body.
    pub fn pressure_pa(&self, forms: &WindowForms, reference: Reference, load: usize) -> f64 {
        let nominal_pa = self.nominal_pressure_pa(load);
        let bound_pa = self.saturation_pa(reference, forms.band.longest_m);
        nominal_pa / forms.longer.map_or(1.0, |longer| longer.area_fraction(nominal_pa, bound_pa))
    }

    /// The closed form's area fraction of a window, and the share of the surface that longer waves leave in contact.
    pub fn area_and_share(&self, forms: &WindowForms, reference: Reference, load: usize) -> (f64, f64) {
        let pressure_pa = self.pressure_pa(forms, reference, load);
        let bound_pa = self.saturation_pa(reference, forms.band.middle_m());
        (forms.own.area_fraction(pressure_pa, bound_pa), self.nominal_pressure_pa(load) / pressure_pa)
    }

    /// The step from the area of elements on a window under a heavier mean pressure \[Pa\] to their area under a load.
    pub fn down_to_load(&self, forms: &WindowForms, reference: Reference, load: usize, from_pa: f64) -> Seam {
        let bound_pa = self.saturation_pa(reference, forms.band.middle_m());
        let to_pa = self.pressure_pa(forms, reference, load);
        let area = |pressure_pa: f64| forms.own.area_fraction(pressure_pa, bound_pa);
        Seam::down(area(to_pa) / area(from_pa), from_pa / to_pa)
    }

    /// The relative standard error of areas on the whole band from its end, where C1D holds waves beyond it.
    pub fn error_of_spectrum_end(&self) -> f64 {
        self.waves.as_ref().map_or(0.0, |waves| waves.surface.conversion().end_error)
    }

    /// The mean real pressure \[Pa\] under a load of bodies whose pressure is bounded, with all waves down to a wavelength \[m\].
    pub fn pressure_at_pa(&self, wavelength_m: f64, bound_pa: Option<f64>, load: usize) -> f64 {
        let nominal_pa = self.nominal_pressure_pa(load);
        let waves = self.closed_form(wavelength_m);
        nominal_pa / waves.map_or(1.0, |waves| waves.area_fraction(nominal_pa, bound_pa))
    }

    /// The step from the area of elements on a window to that of the surface, with all waves down to the end of the window.
    pub fn seam(&self, forms: &WindowForms, reference: Reference, load: usize) -> Seam {
        let (Some(longer), Some(all)) = (forms.longer, forms.all) else { return Seam::NONE };
        let bound_pa = self.saturation_pa(reference, forms.band.middle_m());
        let (on_window, by_share) = self.area_and_share(forms, reference, load);
        let by_closed_form = all.area_fraction(self.nominal_pressure_pa(load), bound_pa) / on_window;
        let on_layer = seam::error_on_layer(all.exponent_of_stiffness);
        let light = seam::error_of_light_load(self.nominal_pressure_pa(load) / longer.gradient_pa());
        Seam::new(by_share, by_closed_form, bound_pa.is_some()).with_error(on_layer).with_error(light)
    }

    /// The mean real pressure \[Pa\] of Persson's elastic contact against cutoff \[m\].
    fn elastic_pressures(&self, load: usize) -> Vec<(f64, f64)> {
        let nominal_pa = self.nominal_pressure_pa(load);
        let elastic = |moments: &Moments| {
            let real_pa =
                nominal_pa / persson::elastic::area_fraction(nominal_pa, self.flattening_rms_pa(moments));
            (moments.wavelength_m, real_pa)
        };
        self.moments.iter().map(elastic).collect()
    }

    /// The rms pressure \[Pa\] of full contact with all waves of these moments.
    fn flattening_rms_pa(&self, moments: &Moments) -> f64 {
        self.composite_modulus_pa * (0.5 * moments.m2).sqrt() * self.stiffening(moments.wavelength_m)
    }

    /// The area of Persson's contact that flows at the constant hardness over that of an elastic one, over the whole band.
    fn flowing_over_elastic(&self, load: usize) -> Option<f64> {
        let hardness_pa = self.scene.material?.hardness_pa()?;
        let (nominal_pa, rms_pa) =
            (self.nominal_pressure_pa(load), self.flattening_rms_pa(self.moments.last()?));
        let flowing = persson::constant_hardness::areas(nominal_pa, rms_pa, hardness_pa).contact();
        Some(flowing / persson::elastic::area_fraction(nominal_pa, rms_pa))
    }

    /// The rms pressure of full contact with all waves down to a wavelength \[m\] over that on half-spaces of E*.
    fn stiffening(&self, wavelength_m: f64) -> f64 {
        match self.layer {
            Some(_) => self.waves_down_to(wavelength_m).map_or(1.0, |waves| waves.stiffening()),
            None => 1.0,
        }
    }

    /// The elements under heights \[m\] that repeat themselves, on the bodies of the scene.
    pub fn elements(&self, grid: Grid, heights_m: &[f64]) -> Result<Elements, HalfSpaceError> {
        match self.layer {
            Some(layer) => Elements::periodic_on(grid, heights_m, |wavevector_rad_per_m| {
                layer.relative_at(wavevector_rad_per_m)
            }),
            None => Elements::periodic(grid, heights_m),
        }
    }

    pub fn yielding(&self, load: usize) -> Yielding {
        let elastic = self.elastic_pressures(load);
        let [constant, growing] = [&self.constant_hardness, &self.growing_hardness].map(Option::as_ref);
        Yielding::new(load, &elastic, constant, growing, self.flowing_over_elastic(load))
    }

    /// The wavelength \[m\] from which on slopes are too steep for a half-space.
    pub fn steep_from_m(&self) -> Option<f64> {
        let is_steep = |moments: &&Moments| (0.5 * moments.m2).sqrt() > SMALL_SLOPE_PRESSURE;
        self.moments.iter().find(is_steep).map(|moments| moments.wavelength_m)
    }

    /// The first measured maps behind the spectrum, which are pressed.
    pub fn maps(&self) -> &[MapPatch] {
        let maps = self.scene.surface.maps();
        &maps[..maps.len().min(MAX_MAPS)]
    }

    /// The rms gradient of the surface over the whole band.
    pub fn rms_gradient(&self) -> f64 {
        self.moments.last().map_or(0.0, |moments| (2.0 * moments.m2).sqrt())
    }

    /// The assumption of its own that a curve breaks first.
    pub fn broken_assumption(&self, at: CurveAtLoad) -> Option<&(f64, Remark)> {
        self.broken[self.place(at)].as_ref()
    }

    /// Finds the first scale at which the pressure on a curve whose strength grows exceeds its hardness. The pressure
    /// is the curve's own, or that of an elastic contact, an upper bound.
    fn yields_while_growing(&self, at: CurveAtLoad) -> Option<AboveHardness> {
        let hardness = self.hardness()?;
        let own = hardness.first_above(real_pressures(self.scene, self.results, at));
        own.or_else(|| hardness.first_above(self.elastic_pressures(at.load).into_iter()))
    }

    /// The hardness at each scale, for a material that yields.
    fn hardness(&self) -> Option<&HardnessOfScales> {
        self.growing_hardness.as_ref().or(self.constant_hardness.as_ref())
    }
}
