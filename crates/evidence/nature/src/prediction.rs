//! Rules that predict a thermal contact from what its row states. They were written before any prediction was compared; what was
//! changed after looking is listed in `docs/guide/nature.md`.
//!
//! A row states materials, Ra, nominal pressure, gas and temperature. Everything else is an [`Unknown`]: a range from literature, with its
//! geometric mean as the central value. The prediction has all unknowns at their central values. Each is then moved to either end with
//! the others at rest; the logarithms of what that changes add in squares, those that raise the conductance apart from those that
//! lower it.
//!
//! Squares, not corners: if each range holds the truth in nine of ten cases and the unknowns have nothing to do with each other, the
//! root of the sum of squares holds it in about nine of ten as well. Corners, where all unknowns conspire, hold it almost always and say
//! nothing.
//!
//! The formulas:
//! * rms height of a face sigma = sqrt(pi/2) Ra (Gaussian heights); both faces add in squares, as do their slopes;
//! * spots that flow: h = 1.25 k_s (m/sigma) (p/H)^0.95 (Yovanovich 1982);
//! * spots that stay elastic, where E* m/sqrt(2) < H (Mikic 1974, Int. J. Heat Mass Transfer 17:205): Barber's analogy with K = p/u_0,
//!   u_0 = 0.39 sigma, between 0.3 sigma of Mikic's elastic correlation and 0.5 sigma of Persson's theory without roll-off (2007,
//!   Phys. Rev. Lett. 99:125502);
//! * gas: k_g <1/(g + M)> over Gaussian gaps ([`interface::gas`]);
//! * flatness: two limits of [`interface::flatness`], a long wave as a smooth ridge, and a cap; each loads a part of the faces, with a
//!   constriction in series and gas around it.

use std::f64::consts::{FRAC_PI_2, SQRT_2};

use asperity::{ElasticBody, MaterialPair};
use interface::conductance::{
    Conductivities, CutSurface, PlasticCorrelation, PressureRatio, RelativeStiffness,
};
use interface::flatness::{Deviation, Flatness, LIMITS_WITHIN};
use interface::gas::{GapGas, plastic_separation_m};
use study::body_properties::BodyProperty;
use study::materials;
use units::{IndentationHardness, Modulus, OutOfBounds, Pressure, ThermalConductivity};

use crate::NatureError;
use crate::resistance::{GasPressure, MeasuredResistance, Solid};

/// Input of a prediction that a row leaves open, or states with a spread.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unknown {
    /// Which of the stated Ra each face has: both the lower, or both the higher.
    Ra,
    /// Conductivity of the grade of the solids: 10 %, 20 % above 100 C, since the table is for room temperature.
    Conductivity,
    /// Hardness of the softer solid: see [`SOLIDS`](crate::resistance::SOLIDS).
    Hardness,
    /// Scatter of measured conductances about the correlations where slope and hardness are measured as well: a factor of 1.3 (Yovanovich
    /// 1982 has 12 to 18 % rms; ends are at nine of ten). It also is the range of u_0 of elastic spots.
    Scatter,
    /// Gas parameter, by the accommodation of walls that are neither clean nor known: a factor of 1.5.
    Accommodation,
    /// Slope of the faces, by three correlations: 0.076 sqrt(sigma) (Lambert & Fletcher 1997), 0.124 sigma^0.743 up to sigma = 1.6
    /// (Antonetti, Whittle & Simons 1991), and 0.152 sigma^0.4 (Tanaka), sigma in um.
    Slope,
    /// Limit of flatness: long wave, or cap.
    FlatnessLimit,
    /// Height of the flatness of the first face: 1 to 10 um. Those of both faces add.
    FirstFlatness,
    /// Height of the flatness of the second face.
    SecondFlatness,
    /// Error of both limits of flatness against elements: a factor of [`LIMITS_WITHIN`].
    FlatnessTheory,
    /// Length of the flatness, and diameter of the specimen: 20 to 40 mm.
    FlatnessLength,
    /// Repeatability of the measurement: a factor of 1.4. Four pairs of rows differ in nothing but the name of a gas at 8 Pa, which carries
    /// less than 1 %, and have 0.5 to 50 % between them: 20 % rms for each value.
    Repeatability,
}

/// Value of every unknown: -1 is its lower end, 0 the geometric mean, 1 the upper end.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Positions([f64; Unknown::ALL.len()]);

/// Prediction of a conductance \[W/(m^2 K)\].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Prediction {
    /// With all unknowns at their central values.
    pub central: f64,
    /// Range over all unknowns.
    pub range: [f64; 2],
    /// Range over the inputs that the row states: without those of slope and flatness.
    pub stated: [f64; 2],
    /// Without gas, with all unknowns at their central values.
    pub without_gas: f64,
    /// By the limits of flatness, a long wave and a cap.
    pub limits: [f64; 2],
}

impl Unknown {
    /// Every unknown.
    pub const ALL: [Self; 12] = [
        Self::Ra,
        Self::Conductivity,
        Self::Hardness,
        Self::Scatter,
        Self::Accommodation,
        Self::Slope,
        Self::FlatnessLimit,
        Self::FirstFlatness,
        Self::SecondFlatness,
        Self::FlatnessTheory,
        Self::FlatnessLength,
        Self::Repeatability,
    ];

    /// Returns true for what the row states, if with a spread.
    #[must_use]
    pub fn is_stated(self) -> bool {
        matches!(self, Self::Ra | Self::Conductivity | Self::Hardness | Self::Scatter | Self::Accommodation)
    }
}

impl Positions {
    /// Moves one unknown from the centre to a position.
    #[must_use]
    pub fn only(unknown: Unknown, position: f64) -> Self {
        Self::default().and(unknown, position)
    }

    /// Moves one more unknown.
    #[must_use]
    pub fn and(mut self, unknown: Unknown, position: f64) -> Self {
        self.0[unknown as usize] = position;
        self
    }

    /// Value between the ends of a range, in equal steps of its logarithm.
    fn within(&self, unknown: Unknown, [low, high]: [f64; 2]) -> f64 {
        low * (high / low).powf(0.5 * (1.0 + self.0[unknown as usize]))
    }

    /// Factor between 1/most and most.
    fn factor(&self, unknown: Unknown, most: f64) -> f64 {
        most.powf(self.0[unknown as usize])
    }
}

/// Solid as the table of materials has it.
struct TabledSolid {
    body: ElasticBody,
    conductivity_w_per_m_k: f64,
    /// Range of its microhardness \[Pa\].
    hardness_pa: [f64; 2],
}

impl TabledSolid {
    fn new(solid: &Solid) -> Result<Self, NatureError> {
        let lacks = |what: &'static str| move || NatureError::Unknown(what, solid.tabled.to_owned());
        let row = materials::named(solid.tabled).map_err(|_| lacks("material")())?;
        let modulus: Modulus = row.quantity(BodyProperty::YoungsModulus).ok_or_else(lacks("modulus of"))?;
        let poisson_ratio = row.poisson_ratio().ok_or_else(lacks("Poisson's ratio of"))?;
        let conductivity: ThermalConductivity =
            row.quantity(BodyProperty::ThermalConductivity).ok_or_else(lacks("conductivity of"))?;
        let hardness: Option<IndentationHardness> = row.quantity(BodyProperty::IndentationHardness);
        let strength: Option<Pressure> = row.quantity(BodyProperty::YieldStrength);
        let by_strength = || Some(3.0 * strength?.pascals(None)?);
        let hardness_pa = hardness.map(|hardness| hardness.pa).or_else(by_strength);
        let hardness_pa = hardness_pa.ok_or_else(lacks("hardness of"))?;
        Ok(Self {
            body: ElasticBody::new(modulus.pa, poisson_ratio)?,
            conductivity_w_per_m_k: conductivity.w_per_m_k,
            hardness_pa: solid.hardening.map(|factor| factor * hardness_pa),
        })
    }
}

/// Joint of a row with every unknown in its place.
struct Joint {
    conductivities: Conductivities,
    modulus_pa: f64,
    /// Pressure on the spots: the hardness, or E* m/sqrt(2) of spots that stay elastic \[Pa\].
    spot_pressure_pa: f64,
    is_elastic: bool,
    slope: f64,
    sigma_m: f64,
    scatter: f64,
    gas: GapGas,
    flatness: Flatness,
    pressure_pa: f64,
}

impl Joint {
    fn new(row: &MeasuredResistance, gas_pressure_pa: f64, at: &Positions) -> Result<Self, NatureError> {
        let solids = [TabledSolid::new(row.solids[0])?, TabledSolid::new(row.solids[1])?];
        // One face of each Ra in the middle, both of the lower or the higher at the ends.
        let [low_m, high_m] = row.ra_m;
        let position = at.0[Unknown::Ra as usize];
        let faces_m = [low_m, high_m].map(|ra_m| {
            let end_m = if position < 0.0 { low_m } else { high_m };
            FRAC_PI_2.sqrt() * ra_m * (end_m / ra_m).powf(position.abs())
        });
        let sigma_m = faces_m[0].hypot(faces_m[1]);
        let slopes = faces_m.map(|face_m| at.within(Unknown::Slope, slope_range(face_m)));
        let slope = slopes[0].hypot(slopes[1]);
        let middle = |solid: &TabledSolid| (solid.hardness_pa[0] * solid.hardness_pa[1]).sqrt();
        let softer = if middle(&solids[0]) < middle(&solids[1]) { &solids[0] } else { &solids[1] };
        let is_hot = row.temperature_k > HOT_K;
        // Aged aluminium and steel lose up to half of their strength at 200 to 350 C (ASM Metals Handbook, vol. 1 and 2).
        let [low_pa, high_pa] = softer.hardness_pa;
        let hardness_pa = at.within(Unknown::Hardness, [if is_hot { 0.5 * low_pa } else { low_pa }, high_pa]);
        let modulus_pa = MaterialPair::against(solids[0].body, solids[1].body).composite_modulus_pa();
        let elastic_pa = modulus_pa * slope / SQRT_2;
        let grade = at.factor(Unknown::Conductivity, if is_hot { 1.2 } else { 1.1 });
        let [one, other] = solids.each_ref().map(|solid| grade * solid.conductivity_w_per_m_k);
        // Two rows are a little hotter than the conductivities of gases reach.
        let gas = GapGas::new(
            row.gas.conductivity_w_per_m_k(row.temperature_k.min(HOTTEST_GAS_K))?,
            row.gas.parameter_m(row.temperature_k, gas_pressure_pa)? * at.factor(Unknown::Accommodation, 1.5),
        )?;
        let faces_off_m = [Unknown::FirstFlatness, Unknown::SecondFlatness]
            .map(|unknown| at.within(unknown, [1e-6, 10e-6]));
        Ok(Self {
            conductivities: Conductivities::new(one, other)?,
            modulus_pa,
            spot_pressure_pa: hardness_pa.min(elastic_pa),
            is_elastic: elastic_pa < hardness_pa,
            slope,
            sigma_m,
            scatter: at.factor(Unknown::Scatter, 1.3),
            gas,
            flatness: Flatness::new(
                faces_off_m.iter().sum(),
                at.within(Unknown::FlatnessLength, [20e-3, 40e-3]),
            )?,
            pressure_pa: row.pressure_pa,
        })
    }

    /// Conductance of the spots under a local pressure, of heights with an rms value.
    fn spots(&self, pressure_pa: f64, sigma_m: f64) -> Result<f64, OutOfBounds> {
        let conductance = if self.is_elastic {
            RelativeStiffness::from_light_load(pressure_pa, self.modulus_pa, ELASTIC_DECAY * sigma_m)?
                .thermal_conductance_w_per_m2_k(&self.conductivities)
        } else {
            PlasticCorrelation::Yovanovich.conductance_w_per_m2_k(
                &self.conductivities,
                &CutSurface::new(sigma_m, self.slope)?,
                PressureRatio::new(pressure_pa, self.spot_pressure_pa)?,
            )
        };
        Ok(self.scatter * conductance)
    }

    /// Distance of the mean planes under a local pressure \[m\].
    fn separation_m(&self, pressure_pa: f64, sigma_m: f64) -> Result<f64, OutOfBounds> {
        let ratio = PressureRatio::new(pressure_pa, self.spot_pressure_pa)?;
        Ok(plastic_separation_m(sigma_m, ratio).unwrap_or(0.0))
    }

    fn gas(&self, separation_m: f64, sigma_m: f64) -> f64 {
        self.gas.conductance_w_per_m2_k(separation_m, sigma_m)
    }

    /// Conductance of a ridge or a cap on a flat; without the gas as well. The constriction towards the loaded part is in series with what
    /// it conducts, and the gas around it is beside both.
    fn on(&self, deviation: &impl Deviation) -> Result<[f64; 2], OutOfBounds> {
        let macroscopic = self.conductivities.harmonic_mean_w_per_m_k()
            / (self.modulus_pa * deviation.compliance_m_per_pa()).max(f64::MIN_POSITIVE);
        let in_series = |inside: f64| 1.0 / (1.0 / macroscopic + 1.0 / inside);
        // At the rim of the contact the pressure falls to 0, where nothing conducts.
        let inside = |of: &dyn Fn(f64) -> Result<f64, OutOfBounds>| {
            deviation.mean_inside(|pressure_pa| of(pressure_pa).unwrap_or(0.0))
        };
        let spots = inside(&|pressure_pa| self.spots(pressure_pa, self.sigma_m));
        let gas_inside =
            inside(&|pressure_pa| Ok(self.gas(self.separation_m(pressure_pa, self.sigma_m)?, self.sigma_m)));
        let apart_m = self.separation_m(self.pressure_pa, self.sigma_m)?;
        let gas_outside = deviation.mean_outside(|gap_m| self.gas(apart_m + gap_m, self.sigma_m));
        Ok([in_series(spots + gas_inside) + gas_outside, in_series(spots)])
    }
}

/// Temperature from which conductivity and hardness at room temperature say less \[K\].
const HOT_K: f64 = 373.15;
/// Highest temperature of tabled conductivities of gases \[K\].
const HOTTEST_GAS_K: f64 = 600.0;
/// Distance over which the pressure of elastic spots falls by a factor e, over the rms height.
const ELASTIC_DECAY: f64 = 0.387;

/// Least and largest mean slope of a face of an rms height \[m\].
fn slope_range(sigma_m: f64) -> [f64; 2] {
    let sigma_um = 1e6 * sigma_m;
    let lambert_fletcher = 0.076 * sigma_um.sqrt();
    let tanaka = 0.152 * sigma_um.powf(0.4);
    let antonetti = (sigma_um <= 1.6).then(|| 0.124 * sigma_um.powf(0.743));
    let all = [Some(lambert_fletcher), Some(tanaka), antonetti];
    let of = |better: fn(f64, f64) -> f64| all.iter().flatten().copied().reduce(better);
    [of(f64::min).unwrap_or(lambert_fletcher), of(f64::max).unwrap_or(tanaka)]
}

/// Conductance of a row with every unknown in its place, and without gas \[W/(m^2 K)\]; `gas_pressure_pa` is that of the gas.
///
/// # Errors
/// [`NatureError`] for numbers out of bounds, and for properties that the table of materials lacks.
pub fn conductances(
    row: &MeasuredResistance,
    gas_pressure_pa: f64,
    at: &Positions,
) -> Result<[f64; 2], NatureError> {
    let joint = Joint::new(row, gas_pressure_pa, at)?;
    let wave = joint.on(&joint.flatness.ridge(joint.pressure_pa, joint.modulus_pa))?;
    let cap = joint.on(&joint.flatness.cap(joint.pressure_pa, joint.modulus_pa))?;
    let between = |with: usize| {
        let position = at.0[Unknown::FlatnessLimit as usize];
        at.factor(Unknown::Repeatability, 1.4)
            * at.factor(Unknown::FlatnessTheory, LIMITS_WITHIN)
            * wave[with]
            * (cap[with] / wave[with]).powf(0.5 * (1.0 + position))
    };
    Ok([between(0), between(1)])
}

/// Predicts the conductance of a row; `None` if the pressure of its gas is doubtful.
///
/// # Errors
/// [`NatureError`] for numbers out of bounds, and for properties that the table of materials lacks.
pub fn predict(row: &MeasuredResistance) -> Result<Option<Prediction>, NatureError> {
    let GasPressure::Known(gas_pressure_pa) = row.gas_pressure else { return Ok(None) };
    let [central, without_gas] = conductances(row, gas_pressure_pa, &Positions::default())?;
    let mut squares = [[0.0; 2]; 2];
    for unknown in Unknown::ALL {
        let mut changes = [0.0f64; 2];
        for position in [-1.0, 1.0] {
            let [moved, _] = conductances(row, gas_pressure_pa, &Positions::only(unknown, position))?;
            let change = (moved / central).ln();
            changes = [changes[0].min(change), changes[1].max(change)];
        }
        for (end, change) in changes.into_iter().enumerate() {
            squares[0][end] += change * change;
            squares[1][end] += if unknown.is_stated() { change * change } else { 0.0 };
        }
    }
    let range = |[down, up]: [f64; 2]| [central * (-down.sqrt()).exp(), central * up.sqrt().exp()];
    let limits = [-1.0, 1.0].map(|position| Positions::only(Unknown::FlatnessLimit, position));
    let [wave, cap] = limits.map(|at| conductances(row, gas_pressure_pa, &at));
    let limits = [wave?[0], cap?[0]];
    Ok(Some(Prediction { limits, central, range: range(squares[0]), stated: range(squares[1]), without_gas }))
}
