//! Spectra of every kind on which the judge of scenes is tried, as scenes.

use scene::{Overrides, Scene};
use serde::{Deserialize, Serialize};
use spectrum::random_surfaces::AreaSpectrum;
use spectrum::{Convention, Psd};

use crate::TrialError;
use crate::spectra::SpectrumFile;

/// Contact modulus E* of all trials \[Pa\].
pub(crate) const CONTACT_MODULUS_PA: f64 = 100e9;
/// Rms gradient h' of every surface.
pub(crate) const RMS_GRADIENT: f64 = 0.05;
/// The shortest wavelength \[m\]. Areas do not depend on it.
pub(crate) const SHORTEST_M: f64 = 1e-8;
/// Loads p/(E* h') of every trial.
pub const LOADS: [f64; 3] = [0.005, 0.03, 0.2];
/// Samples per decade of the spectra.
const PER_DECADE: f64 = 40.0;
/// Decades beyond the shortest wavelength over which profiles see shorter waves of the surface.
const BEYOND_DECADES: f64 = 2.5;
/// Spectra of each kind in a set.
const OF_A_KIND: u32 = 5;
/// Spectra of each kind that only the reported set has.
const OF_A_FURTHER_KIND: u32 = 3;

/// Part of the trials.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Set {
    /// The errors that the judge states were measured on these.
    Calibration,
    /// These were pressed afterwards, and changed nothing.
    #[default]
    Report,
}

/// Form of a spectrum.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Kind {
    /// Hurst exponents from 0.2 to 0.9 over the whole band.
    #[default]
    SelfAffine,
    /// Level at long wavelengths.
    RollOff,
    /// Two humps with little between them.
    TwoHumps,
    /// One hump on a self-affine spectrum.
    Hump,
    /// A band with less or more roughness than its neighbours.
    Step,
    /// Steeper than any fractal at long wavelengths.
    Steep,
    /// Level, or nearly so, over the whole band: Nayak's alpha near 2.
    Flat,
    /// Two humps at the ends of a band of 2.1 decades: Nayak's alpha up to 1,000 and more.
    FarApart,
}

/// Spectrum of a trial.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct JudgeTrial {
    /// Set to which it belongs.
    pub set: Set,
    /// Form of the spectrum.
    pub kind: Kind,
    /// Number of the trial among all of both sets, from 1.
    pub number: u32,
}

/// All trials of a set.
#[must_use]
pub fn trials(set: Set) -> Vec<JudgeTrial> {
    let of_kinds = |kinds: &'static [Kind], of_a_kind: u32, first: u32| {
        let members = kinds.iter().flat_map(move |&kind| (0..of_a_kind).map(move |_| kind));
        members.zip(first..).map(move |(kind, number)| JudgeTrial { set, kind, number })
    };
    let in_both = OF_A_KIND * Kind::IN_BOTH_SETS.len() as u32;
    match set {
        Set::Calibration => of_kinds(&Kind::IN_BOTH_SETS, OF_A_KIND, 1).collect(),
        Set::Report => of_kinds(&Kind::IN_BOTH_SETS, OF_A_KIND, 1 + in_both)
            .chain(of_kinds(&Kind::FURTHER, OF_A_FURTHER_KIND, 1 + 2 * in_both))
            .collect(),
    }
}

impl JudgeTrial {
    /// Longest over shortest wavelength.
    pub(crate) fn width(&self) -> f64 {
        match self.kind {
            Kind::FarApart => 128.0,
            Kind::Flat => 32.0,
            _ => 64.0,
        }
    }

    /// Points of the truth's grid on the shortest wavelength, as the judge has them: the error of the grid is that of both.
    pub(crate) fn points_per_shortest(&self) -> f64 {
        if self.kind == Kind::Flat { 8.0 } else { 4.0 }
    }

    /// Four numbers between 0 and 1 that spread evenly over the trials.
    fn draws(&self) -> [f64; 4] {
        // Powers of the inverse of the root of x^5 = x + 1, the generalised golden ratio of four dimensions.
        const ROOT: f64 = 1.167_303_978_261_418_7;
        [1, 2, 3, 4].map(|power| (0.5 + f64::from(self.number) * ROOT.powi(-power)).fract())
    }

    /// Ciso at a wavelength in units of the shortest, up to a factor.
    fn ciso(&self, wavelength: f64) -> f64 {
        let [a, b, c, d] = self.draws();
        let between = |low: f64, high: f64, share: f64| low * (high / low).powf(share);
        let self_affine = |hurst: f64, rolloff: f64| wavelength.min(rolloff).powf(2.0 + 2.0 * hurst);
        let hump = |centre: f64, width: f64| (-0.5 * ((wavelength / centre).ln() / width).powi(2)).exp();
        match self.kind {
            Kind::SelfAffine => self_affine(0.2 + 0.7 * a, f64::INFINITY),
            Kind::RollOff => self_affine(0.2 + 0.7 * a, between(2.0, 32.0, b)),
            Kind::TwoHumps => {
                let long = hump(between(25.0, 60.0, a), 0.2 + 0.3 * b);
                let short = between(0.03, 1.0, c) * hump(between(1.5, 6.0, d), 0.2 + 0.3 * b);
                self_affine(1.0, f64::INFINITY) * (1e-4 + long + short)
            }
            Kind::Hump => {
                let height = between(3.0, 1000.0, c);
                self_affine(0.3 + 0.6 * a, f64::INFINITY)
                    * (1.0 + height * hump(between(1.5, 50.0, b), 0.15 + 0.35 * d))
            }
            Kind::Step => {
                let end = between(1.5, 8.0, b);
                let inside = (end..end * between(3.0, 8.0, d)).contains(&wavelength);
                self_affine(0.3 + 0.6 * a, f64::INFINITY) * if inside { between(1e-3, 30.0, c) } else { 1.0 }
            }
            Kind::Steep => {
                let knee = between(2.0, 32.0, b);
                self_affine(1.7 + 0.5 * c, f64::INFINITY)
                    * (1.0 + (knee / wavelength).powi(2)).powf(1.0 + 0.5 * a)
            }
            Kind::Flat => wavelength.powf(1.5 * a),
            Kind::FarApart => {
                let long = hump(between(70.0, 115.0, a), 0.15 + 0.2 * b);
                let short = between(0.1, 1.0, c) * hump(between(1.3, 2.5, d), 0.15 + 0.2 * b);
                self_affine(1.0, f64::INFINITY) * (1e-4 + long + short)
            }
        }
    }

    /// Spectrum of the profiles of a surface whose waves go on below the shortest wavelength, as scans see it.
    fn profile(&self) -> Result<(Vec<f64>, Vec<f64>), TrialError> {
        let width = self.width();
        let decades = width.log10();
        let steps = |decades: f64| (PER_DECADE * decades).ceil();
        let place = |at: u32, of: f64, decades: f64| width * 10f64.powf(-decades * f64::from(at) / of);
        let all_decades = decades + BEYOND_DECADES;
        let fine = 4.0 * steps(all_decades);
        let wavelengths: Vec<f64> = (0..=fine as u32).map(|at| place(at, fine, all_decades)).collect();
        // Beyond the band the spectrum falls as it does at its end.
        let slope = (self.ciso(1.01) / self.ciso(1.0)).ln() / 1.01f64.ln();
        let ciso = |&wavelength: &f64| {
            if wavelength < 1.0 {
                self.ciso(1.0) * wavelength.powf(slope.max(3.0))
            } else {
                self.ciso(wavelength)
            }
        };
        let values = wavelengths.iter().map(ciso).collect();
        let wavelengths_m = wavelengths.iter().map(|wavelength| wavelength * SHORTEST_M).collect();
        let surface = AreaSpectrum::from_psd(&Psd::new(wavelengths_m, values, Convention::Ciso)?)?;
        let own_gradient =
            surface.cut(width * SHORTEST_M, SHORTEST_M * (1.0 + 1e-9))?.mean_square_gradient().sqrt();
        let of_band = steps(decades);
        let sampled: Vec<f64> =
            (0..=of_band as u32).map(|at| place(at, of_band, decades) * SHORTEST_M).collect();
        let scale = (RMS_GRADIENT / own_gradient).powi(2);
        let c1d_m3 = surface.profile(&sampled)?.c1d_m3().iter().map(|value| scale * value).collect();
        Ok((sampled, c1d_m3))
    }

    /// Scene of the trial, with all models that apply or Persson's theory alone.
    pub(crate) fn scene(&self, all_models: bool) -> Result<Scene, TrialError> {
        let pressures_pa = LOADS.map(|load| load * CONTACT_MODULUS_PA * RMS_GRADIENT);
        let material =
            format!("[material]\nyoungs_modulus = \"{CONTACT_MODULUS_PA} Pa\"\npoisson_ratio = 0\n");
        self.scene_with(&material, &pressures_pa, all_models)
    }

    /// Scene of the spectrum with the sections of a material, under some nominal pressures.
    pub(crate) fn scene_with(
        &self,
        material: &str,
        pressures_pa: &[f64],
        all_models: bool,
    ) -> Result<Scene, TrialError> {
        let (wavelengths_m, c1d_m3) = self.profile()?;
        let mut csv = "wavelength_m,C1D_m3\n".to_owned();
        for (wavelength_m, c1d_m3) in wavelengths_m.iter().zip(&c1d_m3) {
            csv += &format!("{wavelength_m:e},{c1d_m3:e}\n");
        }
        let loads: Vec<String> =
            pressures_pa.iter().map(|pressure_pa| format!("\"{pressure_pa} Pa\"")).collect();
        let loads = loads.join(", ");
        let text = format!(
            "title = \"trial\"\n[surface]\npsd = \"s.csv\"\n{material}[judge]\nall_models = {all_models}\n\
             [loads]\npressures = [{loads}]\n[[curve]]\nmodel = \"persson\"\n"
        );
        Scene::parse(&text, &SpectrumFile(csv), &Overrides::default())
            .map_err(|error| TrialError::Scene(error.to_string()))
    }
}

impl Kind {
    /// Kinds of both sets.
    pub(crate) const IN_BOTH_SETS: [Kind; 6] =
        [Kind::SelfAffine, Kind::RollOff, Kind::TwoHumps, Kind::Hump, Kind::Step, Kind::Steep];
    /// Kinds of the reported set alone.
    pub(crate) const FURTHER: [Kind; 2] = [Kind::Flat, Kind::FarApart];

    pub(crate) fn name(self) -> &'static str {
        match self {
            Kind::SelfAffine => "self-affine",
            Kind::RollOff => "roll-off",
            Kind::TwoHumps => "two humps",
            Kind::Hump => "one hump",
            Kind::Step => "step or hole",
            Kind::Steep => "steep",
            Kind::Flat => "flat",
            Kind::FarApart => "two humps, 2.1 decades",
        }
    }
}

/// Layer of a trial, of the contact modulus E*, against a rigid counterface.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum LayerKind {
    /// A soft coat: the base is ten times as stiff, the thickness a tenth of the longest wavelength.
    StiffBase,
    /// A stiff coat: the base is a tenth as stiff, the thickness a twentieth of the longest wavelength.
    SoftBase,
    /// A rigid base under a tenth of the longest wavelength.
    RigidBase,
    /// A rigid base under a fiftieth of the longest wavelength: a bed of springs for the long waves.
    ThinOnRigid,
    /// A rigid base under a nearly incompressible layer, a twentieth of the longest wavelength.
    ThinRubber,
}

units::named!(LayerKind, "layer", {
    StiffBase => "base ten times as stiff, t = λ/10",
    SoftBase => "base ten times as soft, t = λ/20",
    RigidBase => "rigid base, ν 0.3, t = λ/10",
    ThinOnRigid => "rigid base, ν 0.3, t = λ/50",
    ThinRubber => "rigid base, ν 0.48, t = λ/20",
});

impl LayerKind {
    /// Longest wavelength over thickness.
    pub(crate) fn wavelengths(self) -> f64 {
        match self {
            LayerKind::StiffBase | LayerKind::RigidBase => 10.0,
            LayerKind::SoftBase | LayerKind::ThinRubber => 20.0,
            LayerKind::ThinOnRigid => 50.0,
        }
    }

    pub(crate) fn poisson_ratio(self) -> f64 {
        if self == LayerKind::ThinRubber { 0.48 } else { 0.3 }
    }

    /// Stiffness of the base over that of the layer; none if it is rigid.
    pub(crate) fn base_over_layer(self) -> Option<f64> {
        match self {
            LayerKind::StiffBase => Some(10.0),
            LayerKind::SoftBase => Some(0.1),
            _ => None,
        }
    }
}
