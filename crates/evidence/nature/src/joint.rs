//! Rock joints: the aperture before a test as a map, the measured closure, and both pressed by elements.

use std::io::Read;

use elements::half_space::{Elements, Grid, Loading};
use elements::{Boundary, Outline, SpecimenCompliance, stiffness_without};

use numerics::parallel::{Unobserved, map_indices};
use numerics::solve;
use scans::{Scan, ScanOptions, ScanSize, read_scans};
use serde::{Deserialize, Serialize};
use units::LengthUnit;

use crate::NatureError;
use crate::table::rounded;

/// Radius of the discs \[m\].
pub const DISC_RADIUS_M: f64 = 61e-3;
/// Side of the published frame \[m\], pixels of it beyond those of a map, and pixels from its edge to the centre of the first point.
const FRAME_M: f64 = 140e-3;
const PIXELS_BEYOND: usize = 5;
const FIRST_PIXEL: f64 = 3.5;
/// Aperture of one step \[m\], and the aperture from which the published colours saturate \[m\].
const STEP_M: f64 = 2e-6;
const SATURATED_M: f64 = 0.98e-3;
/// Heights of points that never touch: holes, and points outside of the disc \[m\].
const HOLE_M: f64 = -1.5e-3;
const OUTSIDE_M: f64 = -5e-3;
/// Young's moduli of the granodiorite \[Pa\]; the authors state 10 to 12 GPa.
const YOUNGS_MODULI_PA: [f64; 3] = [10e9, 11e9, 12e9];
/// Poisson's ratio, assumed.
const POISSON_RATIO: f64 = 0.25;
const TOLERANCE: f64 = 1e-5;
/// Steps of loading that are all compared; of later ones every second is.
const FIRST_STEPS: usize = 5;

/// A step of loading.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ClosureStep {
    /// Mean normal stress \[Pa\].
    pub pressure_pa: f64,
    /// Measured stiffness \[Pa/m\], by differences to the neighbouring steps.
    pub stiffness_pa_per_m: f64,
}

/// Seat of the aperture map.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Seat {
    /// As the map is published.
    Published,
    /// Minus the plane through all points of the disc: both halves may tilt until they carry evenly.
    Levelled,
}

/// Apertures of a joint in a square frame around its disc.
#[derive(Clone, Debug, PartialEq)]
pub struct ApertureMap {
    rows: usize,
    columns: usize,
    spacing_m: f64,
    /// Aperture of each point \[m\]; `None` for holes.
    apertures_m: Vec<Option<f64>>,
}

/// A joint pressed under one load, beside the measurement.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct JointRow {
    /// Name of the joint.
    pub joint: String,
    /// Seat of the map.
    pub seat: Seat,
    /// Compliance of the specimen that was taken out of the stiffness.
    pub compliance: SpecimenCompliance,
    /// Young's modulus \[GPa\].
    pub youngs_modulus_gpa: f64,
    /// Mean normal stress \[MPa\].
    pub pressure_mpa: f64,
    /// True area over the area of the disc.
    pub area_fraction: f64,
    /// Computed stiffness of the interface \[Pa/m\].
    pub stiffness_pa_per_m: f64,
    /// Measured stiffness \[Pa/m\].
    pub measured_pa_per_m: f64,
}

#[derive(Deserialize)]
struct ClosureRecord {
    closure_m: f64,
    normal_stress_pa: f64,
}

/// Reads the steps of loading of a closure: those before the stress falls for the first time.
///
/// # Errors
/// [`NatureError`] for missing columns, and fewer than three steps.
pub fn read_closure(from: impl Read) -> Result<Vec<ClosureStep>, NatureError> {
    let records: Vec<ClosureRecord> =
        csv::Reader::from_reader(from).into_deserialize().collect::<Result<_, _>>()?;
    let rises = records.windows(2).take_while(|pair| pair[1].normal_stress_pa > pair[0].normal_stress_pa);
    let steps = records.len().min(1 + rises.count());
    if steps < 3 {
        return Err(NatureError::Closure(steps));
    }
    let slope = |from: usize, to: usize| {
        (records[to].normal_stress_pa - records[from].normal_stress_pa)
            / (records[to].closure_m - records[from].closure_m)
    };
    let step = |at: usize| {
        let stiffness_pa_per_m = if at == 0 {
            slope(0, 1)
        } else if at + 1 == steps {
            slope(at - 1, at)
        } else {
            // The parabola through three steps.
            let before_m = records[at].closure_m - records[at - 1].closure_m;
            let behind_m = records[at + 1].closure_m - records[at].closure_m;
            (behind_m * slope(at - 1, at) + before_m * slope(at, at + 1)) / (before_m + behind_m)
        };
        ClosureStep { pressure_pa: records[at].normal_stress_pa, stiffness_pa_per_m }
    };
    Ok((0..steps).map(step).collect())
}

impl ApertureMap {
    /// Reads a NumPy array of apertures in steps of 2 um, -1 where unknown.
    ///
    /// # Errors
    /// [`NatureError`] for files without a single map.
    pub fn read(bytes: &[u8], name: &str) -> Result<Self, NatureError> {
        // A side of 1 m keeps the reader content; the frame says how large the map is.
        let options = ScanOptions {
            unit: Some(LengthUnit::MICROMETRE),
            size: Some(ScanSize { x_m: 1.0, y_m: None }),
            ..ScanOptions::default()
        };
        let [file] =
            <[_; 1]>::try_from(read_scans(bytes, name, &options)?).map_err(|_| NatureError::NoMap)?;
        let Scan::Map(map) = file.complete()?.scan else { return Err(NatureError::NoMap) };
        let steps = map.heights_m().iter().map(|height_m| 1e6 * height_m);
        let aperture = |step: f64| {
            let aperture_m = STEP_M * step;
            (step > -0.5 && aperture_m < SATURATED_M).then_some(aperture_m)
        };
        Ok(Self {
            rows: map.rows(),
            columns: map.columns(),
            spacing_m: FRAME_M / (map.columns() + PIXELS_BEYOND) as f64,
            apertures_m: steps.map(aperture).collect(),
        })
    }

    /// Place of a point \[m\] from the centre of the disc.
    fn place_m(&self, point: usize) -> [f64; 2] {
        let [row, column] = [point / self.columns, point % self.columns];
        [column, row].map(|at| (at as f64 + FIRST_PIXEL) * self.spacing_m - 0.5 * FRAME_M)
    }

    /// True for points outside of the disc.
    fn outside(&self) -> Vec<bool> {
        let is_outside = |point| {
            let [x_m, y_m] = self.place_m(point);
            x_m.hypot(y_m) >= DISC_RADIUS_M
        };
        (0..self.apertures_m.len()).map(is_outside).collect()
    }

    /// Heights that face a flat \[m\], in a seat.
    fn heights_m(&self, seat: Seat) -> Vec<f64> {
        let outside = self.outside();
        let plane = match seat {
            Seat::Published => [0.0; 3],
            Seat::Levelled => self.plane(&outside).unwrap_or([0.0; 3]),
        };
        let height_m = |point: usize| match self.apertures_m[point] {
            _ if outside[point] => OUTSIDE_M,
            None => HOLE_M,
            Some(aperture_m) => {
                let [x_m, y_m] = self.place_m(point);
                -aperture_m - plane[0] * x_m - plane[1] * y_m - plane[2]
            }
        };
        (0..self.apertures_m.len()).map(height_m).collect()
    }

    /// Plane of least squares through the heights of the disc: slopes along x and y, and the height in the middle \[m\].
    fn plane(&self, outside: &[bool]) -> Option<[f64; 3]> {
        let (mut matrix, mut right) = ([[0.0; 3]; 3], [0.0; 3]);
        for (point, aperture_m) in self.apertures_m.iter().enumerate() {
            let Some(aperture_m) = aperture_m.filter(|_| !outside[point]) else { continue };
            let [x_m, y_m] = self.place_m(point);
            let terms = [x_m, y_m, 1.0];
            for (row, term) in terms.into_iter().enumerate() {
                right[row] -= term * aperture_m;
                terms.into_iter().enumerate().for_each(|(column, other)| matrix[row][column] += term * other);
            }
        }
        solve(matrix, right)
    }

    /// Presses the joint under the loads of a measured closure: both seats, all moduli, both compliances of the specimen.
    ///
    /// # Errors
    /// [`NatureError::Elements`] for maps that cannot be pressed.
    pub fn press(&self, joint: &str, closure: &[ClosureStep]) -> Result<Vec<JointRow>, NatureError> {
        let length_m = |points: usize| points as f64 * self.spacing_m;
        let grid = Grid::new(self.rows, self.columns, length_m(self.rows), length_m(self.columns))?;
        let outline = Outline::new(grid, Boundary::Free, &self.outside())?;
        let is_compared = |at: &usize| *at < FIRST_STEPS || at.is_multiple_of(2);
        let steps: Vec<ClosureStep> = (0..closure.len()).filter(is_compared).map(|at| closure[at]).collect();
        let mut rows = Vec::new();
        for seat in [Seat::Published, Seat::Levelled] {
            let heights_m = self.heights_m(seat);
            for youngs_modulus_pa in YOUNGS_MODULI_PA {
                let modulus_pa = 0.5 * youngs_modulus_pa / (1.0 - POISSON_RATIO * POISSON_RATIO);
                let pressed = map_indices(steps.len(), |at| {
                    let mut elements = Elements::free(grid, &heights_m)?;
                    let loading = Loading {
                        contact_modulus_pa: modulus_pa,
                        nominal_pressure_pa: steps[at].pressure_pa * outline.share(),
                        saturation_pa: None,
                        tolerance: TOLERANCE,
                    };
                    let contact = elements.press(&loading, &Unobserved)?;
                    let stiffness = elements.stiffness_pa_per_m(&contact, modulus_pa, &Unobserved)?;
                    Ok((contact.numbers.area_fraction_corrected / outline.share(), stiffness))
                });
                let pressed = pressed.into_iter().collect::<Result<Vec<_>, NatureError>>()?;
                for compliance in [SpecimenCompliance::Punch, SpecimenCompliance::Even] {
                    let compliance_m_per_pa =
                        outline.compliance_m_per_pa(compliance, modulus_pa, &Unobserved)?;
                    for (step, (area_fraction, stiffness)) in steps.iter().zip(&pressed) {
                        let of_disc = stiffness.map(|of_frame| of_frame / outline.share());
                        let Some(stiffness_pa_per_m) =
                            of_disc.and_then(|stiffness| stiffness_without(compliance_m_per_pa, stiffness))
                        else {
                            continue;
                        };
                        rows.push(JointRow {
                            joint: joint.to_owned(),
                            seat,
                            compliance,
                            youngs_modulus_gpa: rounded(1e-9 * youngs_modulus_pa),
                            pressure_mpa: rounded(1e-6 * step.pressure_pa),
                            area_fraction: rounded(*area_fraction),
                            stiffness_pa_per_m: rounded(stiffness_pa_per_m),
                            measured_pa_per_m: rounded(step.stiffness_pa_per_m),
                        });
                    }
                }
            }
        }
        Ok(rows)
    }
}
