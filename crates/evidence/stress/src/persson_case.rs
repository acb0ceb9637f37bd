//! States of Persson's theory: their numbers, and the promises of every result.

use std::f64::consts::PI;

use asperity::{AsperityError, ElasticBody, Layer, MaterialPair};
use bilby::AdaptiveIntegrator;
use persson::Band;
use persson::corrections::Correction;
use persson::hardness_laws::{CappedHardness, HardnessError, HardnessGrowth, HardnessTable};
use persson::sealing::{PercolationThreshold, SealingLaw};
use persson::separation::SeparationLaw;
use persson::{ContactAreas, Cut, EnergyFactor, PerssonModel, Place, Roughness, RoughnessSample};
use spectrum::random_surfaces::AreaSpectrum;
use spectrum::{AmplitudeDefinition, Normalisation, ProfilePsd, amplitudes, cumulative_moments};

use crate::drawn_spectrum::drawn_spectrum;
use crate::tally::{Case, Refused, Trial};
use crate::{Draw, Reach};

/// Rounding of areas of the elastic theory and of a constant hardness.
const ROUNDING: f64 = 1e-12;
/// Difference of two areas under a growing hardness, each of which its documentation states to 1e-6 of the contact.
const GROWING: f64 = 2e-6;

/// Growth of a hardness as plain numbers.
#[derive(Debug, Clone, PartialEq)]
pub enum Growth {
    /// None.
    Constant,
    /// A power of the wavevector.
    Power(f64),
    /// A strain-gradient length \[m\].
    Length(f64),
    /// Contact sizes \[m\] and hardnesses \[Pa\].
    Table(Vec<(f64, f64)>),
}

/// Deformation as plain numbers.
#[derive(Debug, Clone, PartialEq)]
pub enum Deformation {
    /// Elastic, with a correction if any.
    Elastic(Option<Correction>),
    /// Elastic up to a hardness \[Pa\] that grows, with an upper limit \[Pa\] if any.
    Plastic(f64, Growth, Option<f64>),
}

/// Layer as plain numbers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Coating {
    /// Thickness \[m\].
    pub thickness_m: f64,
    /// Young's modulus \[Pa\] and Poisson's ratio of the base; rigid if `None`.
    pub base: Option<(f64, f64)>,
}

/// Spectrum, bodies and load; printed, it is a literal that recreates it.
#[derive(Debug, Clone, PartialEq)]
pub struct PerssonCase {
    /// Young's modulus of the rough body \[Pa\].
    pub youngs_modulus_pa: f64,
    /// Poisson's ratio of the rough body.
    pub poisson_ratio: f64,
    /// Layer that the rough body is, if it is one.
    pub coating: Option<Coating>,
    /// Wavelengths \[m\] and densities C1D \[m^3\].
    pub spectrum: Vec<(f64, f64)>,
    /// Band that a cutoff lets through.
    pub band: Band,
    /// Deformation.
    pub deformation: Deformation,
    /// Elastic energy factor g; the fitted form if `None`.
    pub energy_factor: Option<f64>,
    /// Share in contact at which channels close.
    pub threshold: f64,
    /// Nominal pressure \[Pa\].
    pub pressure_pa: f64,
}

/// Everything that a load needs.
struct Prepared {
    model: PerssonModel,
    roughness: Roughness,
    separation: SeparationLaw,
    energy_factor: EnergyFactor,
    contact_modulus_pa: f64,
}

impl Prepared {
    fn areas(&self, pressure_pa: f64) -> Result<Vec<ContactAreas>, HardnessError> {
        self.model.areas(&self.roughness, pressure_pa)
    }

    /// Spread \[Pa\] of the pressure that flattens all waves.
    fn spread_pa(&self) -> f64 {
        self.roughness.places().last().map_or(0.0, |last| last.variance_pa2(self.contact_modulus_pa)).sqrt()
    }
}

impl PerssonCase {
    fn pair(&self, coating: Option<Coating>) -> Result<MaterialPair, AsperityError> {
        let body = ElasticBody::new(self.youngs_modulus_pa, self.poisson_ratio)?;
        let layer = coating
            .map(|Coating { thickness_m, base }| {
                let base = base.map(|(modulus_pa, ratio)| ElasticBody::new(modulus_pa, ratio)).transpose()?;
                Layer::new(body, thickness_m, base)
            })
            .transpose()?;
        Ok(MaterialPair::against_rigid(body).bonded(layer))
    }

    fn model(
        &self,
        contact_modulus_pa: f64,
        deformation: &Deformation,
    ) -> Result<PerssonModel, HardnessError> {
        Ok(match deformation {
            Deformation::Elastic(correction) => {
                PerssonModel::Elastic { contact_modulus_pa, correction: *correction }
            }
            &Deformation::Plastic(hardness_pa, ref growth, cap_pa) => {
                let growth = match growth {
                    Growth::Constant => HardnessGrowth::Constant { hardness_pa },
                    &Growth::Power(exponent) => HardnessGrowth::Power { hardness_pa, exponent },
                    &Growth::Length(length_m) => HardnessGrowth::NixGao { hardness_pa, length_m },
                    Growth::Table(rows) => HardnessGrowth::Table(HardnessTable::new(rows.iter().copied())?),
                };
                PerssonModel::ElasticPlastic {
                    contact_modulus_pa,
                    hardness: CappedHardness::new(growth, cap_pa)?,
                }
            }
        })
    }

    fn energy_factor(&self) -> EnergyFactor {
        self.energy_factor
            .map_or(EnergyFactor::FITTED, |light| EnergyFactor::new(light).expect("drawn within its bounds"))
    }

    fn prepared(&self) -> Result<Prepared, Refused> {
        self.prepared_as(self.coating, &self.deformation)
    }

    fn prepared_as(&self, coating: Option<Coating>, deformation: &Deformation) -> Result<Prepared, Refused> {
        let pair = self.pair(coating)?;
        let contact_modulus_pa = pair.composite_modulus_pa();
        let (wavelengths_m, c1d_m3) = self.spectrum.iter().copied().unzip();
        let psd = ProfilePsd::new(wavelengths_m, c1d_m3)?;
        let roughness = roughness(&psd, self.band);
        let roughness = match pair.layer_compliance() {
            Some(layer) => roughness.on_layer(layer),
            None => roughness,
        };
        let model = self.model(contact_modulus_pa, deformation)?;
        let energy_factor = self.energy_factor();
        let separation = model.separation(&roughness, energy_factor);
        Ok(Prepared { model, roughness, separation, energy_factor, contact_modulus_pa })
    }

    /// Scales the case: lengths times 2^`lengths` and pressures times 2^`pressures`.
    fn scaled(&self, lengths: i32, pressures: i32) -> Self {
        let [length, pressure] = [lengths, pressures].map(|power| 2f64.powi(power));
        let coating = self.coating.map(|Coating { thickness_m, base }| Coating {
            thickness_m: length * thickness_m,
            base: base.map(|(modulus_pa, ratio)| (pressure * modulus_pa, ratio)),
        });
        let deformation = match self.deformation.clone() {
            Deformation::Plastic(hardness_pa, growth, cap_pa) => {
                let growth = match growth {
                    Growth::Length(length_m) => Growth::Length(length * length_m),
                    Growth::Table(rows) => {
                        Growth::Table(rows.iter().map(|row| (length * row.0, pressure * row.1)).collect())
                    }
                    other => other,
                };
                Deformation::Plastic(pressure * hardness_pa, growth, cap_pa.map(|cap_pa| pressure * cap_pa))
            }
            elastic @ Deformation::Elastic(_) => elastic,
        };
        PerssonCase {
            youngs_modulus_pa: pressure * self.youngs_modulus_pa,
            coating,
            spectrum: self.spectrum.iter().map(|row| (length * row.0, length.powi(3) * row.1)).collect(),
            deformation,
            pressure_pa: pressure * self.pressure_pa,
            ..self.clone()
        }
    }

    fn area_tolerance(&self) -> f64 {
        match self.deformation {
            Deformation::Plastic(_, ref growth, _) if *growth != Growth::Constant => GROWING,
            _ => ROUNDING,
        }
    }
}

/// Roughness of a spectrum, as a plan computes it.
fn roughness(psd: &ProfilePsd, band: Band) -> Roughness {
    let moments = cumulative_moments(psd, Normalisation::Parseval);
    let moments = moments.iter().map(|moments| [moments.m0_m2, moments.m2, moments.m4_per_m2]);
    let scales = amplitudes(psd, AmplitudeDefinition::Eq5);
    let samples: Vec<RoughnessSample> = std::iter::once([0.0; 3])
        .chain(moments)
        .zip(&scales)
        .zip(psd.c1d_m3())
        .map(|((moments, scale), &c1d_m3)| RoughnessSample {
            wavelength_m: scale.wavelength_m,
            c1d_m3,
            moments,
            amplitude_m: scale.amplitude_m,
        })
        .collect();
    let of_surface = || {
        let surface = AreaSpectrum::from_profile(psd).ok()?;
        Some(surface.mean_square_gradients(psd.wavelengths_m()))
    };
    let of_surface = if band == Band::Surface { of_surface() } else { None };
    Roughness::new(&samples, of_surface.as_deref())
}

impl Case for PerssonCase {
    fn draw(draw: &mut Draw) -> (Self, Reach) {
        let reach = Reach::draw(draw);
        let youngs_modulus_pa = reach.modulus_pa(draw);
        let ordinary = draw.between(0.0, 0.5);
        let poisson_ratio = draw.one_of(&[ordinary, ordinary, 0.0, 0.5]);
        let spectrum = drawn_spectrum(draw, reach);
        let (longest_m, shortest_m) = (spectrum[0].0, spectrum[spectrum.len() - 1].0);
        let base_modulus_pa = youngs_modulus_pa * draw.decades(-6.0, 6.0);
        let base = draw.chance(0.6).then_some((base_modulus_pa, draw.between(0.0, 0.5)));
        let thickness_m = draw.one_of(&[longest_m, shortest_m]) * reach.number(draw, -4.0, 4.0);
        let coating = draw.chance(0.25).then_some(Coating { thickness_m, base });
        let light = draw.between(0.05, 1.0);
        let mut case = PerssonCase {
            youngs_modulus_pa,
            poisson_ratio,
            coating,
            spectrum,
            band: draw.one_of(Band::ALL),
            deformation: Deformation::Elastic(None),
            energy_factor: draw.one_of(&[None, Some(0.45), Some(1.0), Some(light)]),
            threshold: draw.between(0.01, 0.99),
            pressure_pa: 1.0,
        };
        let spread_pa = case.prepared().map_or(0.0, |prepared| prepared.spread_pa());
        let unit_pa = if spread_pa.is_normal() { spread_pa } else { youngs_modulus_pa };
        case.pressure_pa = match reach {
            Reach::Usual => unit_pa * draw.decades(-6.0, 1.2),
            _ if draw.chance(0.5) => unit_pa * reach.number(draw, -12.0, 2.0),
            _ => reach.number(draw, -12.0, 15.0),
        };
        let hardness_pa = case.pressure_pa * draw.decades(-0.3, 4.0);
        let hardness_pa = if draw.chance(0.1) { draw.near(case.pressure_pa) } else { hardness_pa };
        let exponent = draw.between(0.0, 2.0);
        let growth = match draw.between(0.0, 1.0) {
            share if share < 0.35 => Growth::Constant,
            share if share < 0.6 => Growth::Power(draw.one_of(&[exponent, exponent, 0.0])),
            share if share < 0.8 => Growth::Length(longest_m * draw.decades(-8.0, 4.0)),
            _ => {
                let mut row = (longest_m * draw.decades(-1.0, 1.0), hardness_pa);
                let mut step = || {
                    let next = (row.0 * draw.decades(-2.0, -0.01), row.1 * draw.decades(0.0, 1.0));
                    std::mem::replace(&mut row, next)
                };
                Growth::Table((0..4).map(|_| step()).collect())
            }
        };
        let cap_pa = draw.chance(0.3).then_some(hardness_pa * draw.decades(0.0, 3.0));
        let correction = draw.one_of(Correction::ALL);
        case.deformation = match draw.between(0.0, 1.0) {
            share if share < 0.25 => Deformation::Elastic(None),
            share if share < 0.45 => Deformation::Elastic(Some(correction)),
            _ => Deformation::Plastic(hardness_pa, growth, cap_pa),
        };
        (case, reach)
    }

    fn test(trial: &mut Trial<Self>) -> Result<(), Refused> {
        let case = trial.case;
        let prepared = case.prepared()?;
        let Prepared { model, roughness, separation, .. } = &prepared;
        let pressure_pa = case.pressure_pa;
        if !asperity::Bound::Magnitude.admits(pressure_pa) {
            return Err(Refused);
        }
        let cuts = model.along(roughness, separation, pressure_pa)?;
        sound(&prepared, &cuts, trial);
        let Some(last) = cuts.last() else { return Ok(()) };
        let at_last = model.at_last(roughness, separation, pressure_pa);
        let again = at_last.is_ok_and(|cut| cut.is_some_and(|cut| cut == *last));
        trial.hold("the last cut alone and along the spectrum", again);
        if trial.reach == Reach::Edge {
            return Ok(());
        }
        let more_pa = pressure_pa * (1.0 + trial.draw.decades(-6.0, 0.0));
        rises_with_load(&prepared, (last, pressure_pa), more_pa, trial);
        between_limits(&prepared, last.areas, trial);
        scaled(&cuts, trial);
        if let Deformation::Plastic(hardness_pa, Growth::Constant, _) = case.deformation {
            eigenfunctions(&prepared, last.areas, pressure_pa, hardness_pa, trial);
        }
        let first = (prepared.roughness.places(), case);
        if let (Deformation::Elastic(correction), [_, .., _]) = (&case.deformation, first.0) {
            seal(&prepared, *correction, trial);
            light_load(&prepared, *correction, trial);
        }
        if trial.draw.chance(0.1) {
            stiffness_is_the_slope(&prepared, pressure_pa, 1e-9, trial);
        }
        if let (Some(coating), true) = (case.coating, trial.draw.chance(0.3)) {
            trivial_layer(coating, trial);
        }
        Ok(())
    }
}

/// Checks shares and separations of every cut.
fn sound(prepared: &Prepared, cuts: &[Cut], trial: &mut Trial<PerssonCase>) {
    let case = trial.case;
    let tolerance = case.area_tolerance();
    for cut in cuts {
        let ContactAreas { elastic, plastic, gap } = cut.areas;
        let shares = [elastic, plastic, gap].iter().all(|share| (0.0..=1.0).contains(share));
        trial.hold("shares in [0, 1]", shares);
        trial.bound("shares add up to 1", (elastic + plastic + gap - 1.0).abs(), ROUNDING);
        trial.hold("pressure and gradient no NaN", !cut.real_pressure_pa.is_nan() && cut.rms_gradient >= 0.0);
        trial.hold("mean gap finite, at least 0", cut.mean_gap_m.is_none_or(|gap_m| gap_m >= 0.0));
        trial.hold("stiffness at least 0", cut.stiffness_pa_per_m.is_none_or(|stiffness| stiffness >= 0.0));
    }
    let depends_on_alpha = case.deformation == Deformation::Elastic(Some(Correction::AlgebraicNayak));
    if !depends_on_alpha {
        let rise = |pair: &[Cut]| pair[1].areas.contact() - pair[0].areas.contact();
        let largest = cuts.windows(2).map(rise).fold(0.0, f64::max);
        trial.bound("area falls along the spectrum", largest, tolerance);
    }
    let gradient = |place: &Place| place.mean_square_gradient;
    let gradients: Vec<f64> = prepared.roughness.places().iter().map(gradient).collect();
    trial.hold("gradients rise along the spectrum", gradients.is_sorted());
    if let Deformation::Plastic(..) = case.deformation {
        let PerssonModel::ElasticPlastic { hardness, .. } = &prepared.model else { return };
        let Ok(first_pa) = hardness.at_longest_pa(&prepared.roughness) else { return };
        let carried = cuts.iter().map(|cut| cut.areas.plastic * first_pa).fold(0.0, f64::max);
        if case.pressure_pa < first_pa {
            let allowed_pa = case.pressure_pa * (1.0 + 1e-9) + tolerance * first_pa;
            trial.bound("plastic share times hardness within the load", carried, allowed_pa);
        }
    }
}

/// Checks that a larger load closes the contact.
fn rises_with_load(
    prepared: &Prepared,
    (last, pressure_pa): (&Cut, f64),
    more_pa: f64,
    trial: &mut Trial<PerssonCase>,
) {
    let case = trial.case;
    let more = prepared.model.at_last(&prepared.roughness, &prepared.separation, more_pa);
    let Ok(Some(more)) = more else { return };
    let tolerance = case.area_tolerance();
    let loss = last.areas.contact() - more.areas.contact();
    trial.bound("area rises with the load", loss, tolerance * last.areas.contact().max(1e-3));
    trial.bound("gap share falls with the load", more.areas.gap - last.areas.gap, tolerance);
    let [less, more] = [pressure_pa, more_pa].map(|pressure_pa| prepared.separation.whole(pressure_pa));
    trial.bound("mean gap falls with the load", more.mean_gap_m, less.mean_gap_m * (1.0 + 1e-12));
    let softer = less.stiffness_pa_per_m / more.stiffness_pa_per_m;
    trial.bound("stiffness rises with the load", if softer.is_nan() { 0.0 } else { softer }, 1.0 + 1e-9);
}

/// Checks that plastic contact lies between the elastic theory and a constant hardness.
fn between_limits(prepared: &Prepared, areas: ContactAreas, trial: &mut Trial<PerssonCase>) {
    let case = trial.case;
    let Deformation::Plastic(hardness_pa, growth, _) = &case.deformation else { return };
    let last = |deformation: &Deformation| -> Option<ContactAreas> {
        let prepared = case.prepared_as(case.coating, deformation).ok()?;
        prepared.areas(case.pressure_pa).ok()?.last().copied()
    };
    let tolerance = case.area_tolerance();
    if let Some(elastic) = last(&Deformation::Elastic(None)) {
        trial.bound("at least the elastic area", elastic.contact() - areas.contact(), tolerance);
    }
    let PerssonModel::ElasticPlastic { hardness, .. } = &prepared.model else { return };
    let Ok(first_pa) = hardness.at_longest_pa(&prepared.roughness) else { return };
    if let Some(constant) = last(&Deformation::Plastic(first_pa, Growth::Constant, None)) {
        trial.bound(
            "at most the area of a constant hardness",
            areas.contact() - constant.contact(),
            tolerance,
        );
        if *growth == Growth::Power(0.0) {
            let off =
                (areas.contact() - constant.contact()).abs().max((areas.plastic - constant.plastic).abs());
            trial.bound("a power of 0 is a constant hardness", off, tolerance);
        }
    }
    trial.hold(
        "the hardness at the long end is the given one or above",
        first_pa >= hardness_pa * (1.0 - 1e-12),
    );
}

/// Checks that units do not matter.
fn scaled(cuts: &[Cut], trial: &mut Trial<PerssonCase>) {
    let case = trial.case;
    let [lengths, pressures] = [0, 1].map(|_| trial.draw.between(-20.0, 20.0) as i32);
    let other = case.scaled(lengths, pressures);
    let Ok(prepared) = other.prepared() else { return };
    if !asperity::Bound::Magnitude.admits(other.pressure_pa) {
        return;
    }
    let Prepared { model, roughness, separation, .. } = prepared;
    let Ok(others) = model.along(&roughness, &separation, other.pressure_pa) else {
        trial.hold("units do not matter", false);
        return;
    };
    let length = 2f64.powi(lengths);
    let mut off = 0.0f64;
    for (here, there) in cuts.iter().zip(&others) {
        let differences =
            [here.areas.elastic - there.areas.elastic, here.areas.plastic - there.areas.plastic];
        off = differences.iter().fold(off, |off, difference| off.max(difference.abs()));
        if let (Some(here_m), Some(there_m)) = (here.mean_gap_m, there.mean_gap_m)
            && here_m > 1e-200
        {
            off = off.max((there_m / length / here_m - 1.0).abs());
        }
    }
    trial.bound("units do not matter", off, 0.1 * case.area_tolerance() + 1e-12);
}

/// Compares a constant hardness with a plain sum of eigenfunctions.
fn eigenfunctions(
    prepared: &Prepared,
    areas: ContactAreas,
    pressure_pa: f64,
    hardness_pa: f64,
    trial: &mut Trial<PerssonCase>,
) {
    let (load, spread) = (pressure_pa / hardness_pa, prepared.spread_pa() / hardness_pa);
    if load >= 1.0 || spread < 0.02 {
        return;
    }
    let (mut elastic, mut plastic) = (0.0, load);
    for n in 1..200 {
        let mode = f64::from(n) * PI;
        let term = 2.0 / mode * (mode * load).sin() * (-0.5 * (mode * spread).powi(2)).exp();
        elastic += if n % 2 == 1 { 2.0 * term } else { 0.0 };
        plastic += if n % 2 == 1 { -term } else { term };
    }
    let off = (elastic - areas.elastic).abs().max((plastic - areas.plastic).abs());
    trial.bound("a plain sum of eigenfunctions agrees", off, 1e-12);
}

/// Checks the seal of an elastic contact.
fn seal(prepared: &Prepared, correction: Option<Correction>, trial: &mut Trial<PerssonCase>) {
    let case = trial.case;
    let Prepared { roughness, energy_factor, contact_modulus_pa, .. } = prepared;
    let threshold = PercolationThreshold::new(case.threshold).expect("drawn within its bounds");
    let law = SealingLaw::new(roughness, *contact_modulus_pa, *energy_factor, correction, threshold);
    let tight_pa = law.tight_pressure_pa();
    trial.hold("tight pressure finite", tight_pa.is_finite());
    let constriction = law.critical_constriction(case.pressure_pa);
    match constriction {
        None => trial.bound("tight from its pressure on", tight_pa, case.pressure_pa * (1.0 + 1e-9)),
        Some(place) => {
            trial.bound("leaks below its pressure", case.pressure_pa, tight_pa * (1.0 + 1e-9));
            let off = (place.area_fraction / case.threshold - 1.0).abs();
            trial.bound("the threshold touches at the constriction", off, 1e-9);
            trial.hold("gap at the constriction", place.mean_gap_m >= 0.0 && place.mean_gap_m.is_finite());
            let opening = place.opening_gap_m;
            trial.hold("opening gap finite", opening.is_none_or(|gap_m| gap_m.is_finite()));
        }
    }
    for place in roughness.places() {
        let contact = law.contact_at(place.wavevector_rad_per_m, case.pressure_pa);
        let shares = (0.0..=1.0).contains(&contact.area_fraction) && contact.mean_gap_m >= 0.0;
        trial.hold("contact at a magnification", shares);
    }
}

/// Checks the limit of light loads, without a correction.
fn light_load(prepared: &Prepared, correction: Option<Correction>, trial: &mut Trial<PerssonCase>) {
    let spread_pa = prepared.spread_pa();
    let pressure_pa = spread_pa * trial.draw.decades(-9.0, -5.0);
    if correction.is_none() && spread_pa > 0.0 {
        let areas = prepared.areas(pressure_pa).expect("elastic contact has no hardness");
        let linear = (2.0 / PI).sqrt() * (pressure_pa / spread_pa);
        let area = areas.last().map_or(0.0, ContactAreas::contact);
        trial.bound("area of light loads", (area / linear - 1.0).abs(), 1e-9);
    }
    match prepared.separation.light_loads() {
        None => {
            let gap_m = prepared.separation.whole(pressure_pa).mean_gap_m;
            trial.hold("no roughness, no gap", gap_m == 0.0 || gap_m.is_nan() && spread_pa == 0.0);
        }
        Some(light) => {
            let share = light.share_of_first_decade;
            let sizes = light.decay_length_m > 0.0 && light.reference_pressure_pa > 0.0;
            trial.hold("numbers of light loads", sizes && (0.0..=1.0).contains(&share));
            let first = prepared.roughness.places().iter();
            let least_pa = first
                .map(|place| place.variance_pa2(prepared.contact_modulus_pa).sqrt())
                .find(|spread_pa| *spread_pa > 0.0);
            // Below every spread the whole law is that of light loads.
            let light_pa = 1e-6 * least_pa.unwrap_or(0.0);
            if asperity::Bound::Magnitude.admits(light_pa) {
                let gap_m = prepared.separation.whole(light_pa).mean_gap_m;
                let limit_m = light.decay_length_m * (light.reference_pressure_pa.ln() - light_pa.ln());
                trial.note("gap of light loads off the limit", (gap_m / limit_m - 1.0).abs());
            }
        }
    }
}

/// Checks that 1/K integrated over the load is the difference of gaps.
fn stiffness_is_the_slope(
    prepared: &Prepared,
    pressure_pa: f64,
    tolerance: f64,
    trial: &mut Trial<PerssonCase>,
) {
    let separation = &prepared.separation;
    let compliance = |log_pa: f64| {
        let at_pa = log_pa.exp();
        let stiffness = separation.whole(at_pa).stiffness_pa_per_m;
        if stiffness.is_finite() { at_pa / stiffness } else { 0.0 }
    };
    let [from, to] = [pressure_pa, 2.0 * pressure_pa];
    let gaps_m = [from, to].map(|pressure_pa| separation.whole(pressure_pa).mean_gap_m);
    let integrator = AdaptiveIntegrator::default().with_abs_tol(0.0).with_rel_tol(1e-9).with_max_evals(3_000);
    let Ok(result) = integrator.integrate(from.ln(), to.ln(), compliance) else { return };
    let error_m = result.error_estimate;
    if error_m < 1e-7 * gaps_m[0] && gaps_m[0] > 1e-200 {
        let off_m = (gaps_m[0] - gaps_m[1] - result.value).abs();
        trial.bound("1/K is the slope of the gap", off_m / gaps_m[0], tolerance + 2.0 * error_m / gaps_m[0]);
    }
}

/// Checks that a layer of the material of its base has no effect.
fn trivial_layer(coating: Coating, trial: &mut Trial<PerssonCase>) {
    let case = trial.case;
    let base = Some((case.youngs_modulus_pa, case.poisson_ratio));
    let deformation = Deformation::Elastic(None);
    let both = [Some(Coating { base, ..coating }), None].map(|coating| {
        let prepared = case.prepared_as(coating, &deformation).ok()?;
        let areas = prepared.areas(case.pressure_pa).ok()?;
        Some((areas.last()?.contact(), prepared.separation.whole(case.pressure_pa).mean_gap_m))
    });
    if let [Some(layer), Some(half_space)] = both {
        let gap = if half_space.1 > 1e-200 { (layer.1 / half_space.1 - 1.0).abs() } else { 0.0 };
        let off = (layer.0 - half_space.0).abs().max(gap);
        trial.bound("a layer of the material of its base is none", off, 1e-9);
    }
}
