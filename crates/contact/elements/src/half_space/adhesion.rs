//! Adhesive contact: an exponential attraction between a periodic rough surface and the half-space, with the gap as the
//! unknown.
//!
//! The gap g of least energy `<(g + h) K^-1 (g + h)>/2 - w <exp(-g/rho)> + p <g>` under g >= 0 is found by Newton's
//! method on the points that are free: those with a gap, or with a contact pressure that is not positive. The linear
//! problems are solved by preconditioned conjugate gradients in single precision, the outer steps are in double.

use numerics::parallel::Progress;
use thiserror::Error;
use units::display::{length, pressure};
use units::{Bound, OutOfBounds};

use crate::half_space::area::count;
use crate::half_space::elements::is_flat;
use crate::half_space::operators::wave_number;
use crate::half_space::transform::Convolution;
use crate::half_space::{Grid, HalfSpaceError, sums};

/// Process zones per spacing below which points flip one by one, and results are refused.
pub const LEAST_RESOLUTION: f64 = 1.0;

/// Process zones per spacing at which results are good to 1 %.
pub const GOOD_RESOLUTION: f64 = 2.0;

const MOST_NEWTON_STEPS: usize = 400;
const MOST_INNER_STEPS: usize = 300;
const MOST_HALVINGS: usize = 40;

/// Smallest relative residual of the linear problems, which are solved in single precision.
const INNER_FLOOR: f64 = 1e-5;

/// Attraction (w/rho) exp(-g/rho) at the gap g.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Adhesion {
    /// Work of adhesion w \[J/m^2\].
    pub work_j_per_m2: f64,
    /// Range rho \[m\].
    pub range_m: f64,
}

/// Quantity that is held while the gap adjusts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Control {
    /// Nominal pressure \[Pa\]; negative values pull.
    PressurePa(f64),
    /// Mean gap \[m\].
    MeanGapM(f64),
}

/// State that the solver starts from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Start {
    /// The surface just touches the half-space.
    Apart,
    /// The whole surface touches.
    Contact,
    /// The last solved state.
    Last,
}

/// Numbers of an adhesive contact in equilibrium.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct AdhesiveNumbers {
    /// Nominal pressure \[Pa\]: mean contact pressure less mean attraction.
    pub nominal_pressure_pa: f64,
    /// Share of the points without a gap.
    pub area_fraction: f64,
    /// Area fraction less the staircase around each spot.
    pub area_fraction_corrected: f64,
    /// Share of the points without a gap and with a net compression.
    pub repulsive_area_fraction: f64,
    /// Mean gap over all points \[m\].
    pub mean_gap_m: f64,
    /// Mean attraction over all points, those in contact included \[Pa\].
    pub mean_attraction_pa: f64,
    /// Largest contact pressure \[Pa\], the attraction not subtracted.
    pub largest_contact_pressure_pa: f64,
    /// Largest violation of equilibrium over the larger of the nominal pressure and the rms pressure of full contact.
    pub residual: f64,
}

/// Adhesive contact in equilibrium.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct AdhesiveContact {
    /// Its numbers.
    pub numbers: AdhesiveNumbers,
    /// Newton steps.
    pub iterations: usize,
    /// Number of times that tractions were computed from displacements, in single or double precision.
    pub operators: usize,
    /// True if rounding kept the residual above the tolerance.
    pub is_rounded: bool,
    /// Gap of every point \[m\].
    pub gaps_m: Vec<f64>,
    /// Net pressure of every point \[Pa\]: contact pressure less attraction.
    pub pressures_pa: Vec<f64>,
}

/// Reason why an adhesive contact was not solved.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum AdhesionError {
    /// The surface cannot be pressed.
    #[error(transparent)]
    HalfSpace(#[from] HalfSpaceError),
    /// The grid does not resolve the process zone.
    #[error(
        "adhesion: the process zone E* rho^2/w of {} is shorter than the spacing of {}; use {points} points along the longer \
         side, a longer range or less work of adhesion",
        length(*.process_zone_m), length(*.spacing_m)
    )]
    Unresolved {
        /// Process zone E* rho^2/w \[m\].
        process_zone_m: f64,
        /// Spacing of the grid \[m\].
        spacing_m: f64,
        /// Points along the longer side that resolve the process zone by two spacings.
        points: usize,
    },
    /// No state in contact carries the load.
    #[error(
        "adhesion: the contact does not hold a nominal pressure of {} and is pulled off",
        pressure(*.nominal_pressure_pa)
    )]
    PulledOff {
        /// Nominal pressure \[Pa\].
        nominal_pressure_pa: f64,
    },
    /// The steps ran out.
    #[error("adhesion: a residual of {residual:e} remains")]
    NotConverged {
        /// Residual reached.
        residual: f64,
    },
}

impl From<OutOfBounds> for AdhesionError {
    fn from(error: OutOfBounds) -> Self {
        HalfSpaceError::from(error).into()
    }
}

impl Adhesion {
    /// Process zone E* rho^2/w \[m\], the length that a grid has to resolve.
    #[must_use]
    pub fn process_zone_m(&self, contact_modulus_pa: f64) -> f64 {
        contact_modulus_pa * self.range_m * (self.range_m / self.work_j_per_m2)
    }

    /// Process zone over the larger spacing of a grid.
    ///
    /// # Errors
    /// [`AdhesionError::Unresolved`] below [`LEAST_RESOLUTION`], and numbers out of their bounds.
    pub fn resolution(&self, grid: &Grid, contact_modulus_pa: f64) -> Result<f64, AdhesionError> {
        Bound::Magnitude.check("work of adhesion in J/m^2", self.work_j_per_m2)?;
        Bound::Magnitude.check("range of adhesion in m", self.range_m)?;
        Bound::Magnitude.check("contact modulus in Pa", contact_modulus_pa)?;
        let process_zone_m = self.process_zone_m(contact_modulus_pa);
        let sides = [(grid.columns(), grid.length_x_m()), (grid.rows(), grid.length_y_m())];
        let waved = sides.iter().filter(|(count, _)| *count > 1 || grid.points() == 1);
        let spacing_m = waved.clone().map(|(count, length_m)| length_m / *count as f64).fold(0.0, f64::max);
        let longest_m = waved.map(|(_, length_m)| *length_m).fold(0.0, f64::max);
        let resolution = process_zone_m / spacing_m;
        if resolution >= LEAST_RESOLUTION {
            return Ok(resolution);
        }
        let points = (GOOD_RESOLUTION * longest_m / process_zone_m).ceil() as usize;
        Err(AdhesionError::Unresolved { process_zone_m, spacing_m, points })
    }
}

/// Boundary elements with adhesion under a periodic rough surface: plans and buffers, kept between states.
pub struct AdhesiveElements {
    grid: Grid,
    contact_modulus_pa: f64,
    adhesion: Adhesion,
    unit_m: f64,
    unit_pa: f64,
    /// Range in units of `unit_m`.
    range: f64,
    /// Largest attraction w/rho in units of `unit_pa`.
    strength: f64,
    heights: Vec<f64>,
    /// Tractions of full contact, and their rms.
    full: Vec<f64>,
    full_rms: f64,
    tractions_of: Convolution<f64>,
    inner_tractions_of: Convolution<f32>,
    precondition: Convolution<f32>,
    gaps: Vec<f64>,
    /// Tractions K^-1 (g + h).
    tractions: Vec<f64>,
    operators: usize,
}

/// Free points, their gradient, and the nominal pressure.
struct Gradient {
    pressure: f64,
    residual: f64,
    values: Vec<f64>,
    is_free: Vec<bool>,
}

impl AdhesiveElements {
    /// Lays out the elements under `heights_m`, row by row, of a surface that repeats itself along x and y.
    ///
    /// # Errors
    /// [`AdhesionError`] for heights that do not match the points, numbers out of their bounds, and a grid that does
    /// not resolve the process zone.
    pub fn new(
        grid: Grid,
        heights_m: &[f64],
        contact_modulus_pa: f64,
        adhesion: Adhesion,
    ) -> Result<Self, AdhesionError> {
        grid.check_heights(heights_m)?;
        adhesion.resolution(&grid, contact_modulus_pa)?;
        let count = grid.points();
        let mean_m = sums::over(count, |at| [heights_m[at]])[0] / count as f64;
        let [squares] = sums::over(count, |at| [(heights_m[at] - mean_m).powi(2)]);
        // A flat surface has no unit of its own; the range will do.
        let unit_m = if is_flat(heights_m.iter().copied()) {
            adhesion.range_m
        } else {
            (squares / count as f64).sqrt()
        };
        let unit_pa = 0.5 * contact_modulus_pa * grid.unit_wave_number_per_m() * unit_m;
        let heights: Vec<f64> = heights_m.iter().map(|height_m| (height_m - mean_m) / unit_m).collect();
        let map = [grid.rows(), grid.columns()];
        let waves = wave_number(grid);
        let mut tractions_of = Convolution::new(map, map, waves);
        let mut full = vec![0.0; count];
        tractions_of.apply(&heights, &mut full);
        let [squares] = sums::over(count, |at| [full[at] * full[at]]);
        Ok(Self {
            grid,
            contact_modulus_pa,
            adhesion,
            unit_m,
            unit_pa,
            range: adhesion.range_m / unit_m,
            strength: adhesion.work_j_per_m2 / adhesion.range_m / unit_pa,
            full_rms: (squares / count as f64).sqrt(),
            tractions: full.clone(),
            full,
            tractions_of,
            inner_tractions_of: Convolution::new(map, map, waves),
            precondition: Convolution::new(map, map, |row, column| 1.0 / waves(row, column).max(0.5)),
            gaps: vec![0.0; count],
            heights,
            operators: 0,
        })
    }

    /// Process zone over the larger spacing.
    ///
    /// # Errors
    /// The errors of [`Adhesion::resolution`].
    pub fn resolution(&self) -> Result<f64, AdhesionError> {
        self.adhesion.resolution(&self.grid, self.contact_modulus_pa)
    }

    /// Finds a state in equilibrium, from `start` downhill in energy.
    ///
    /// # Errors
    /// [`AdhesionError`] for numbers out of their bounds, for a contact that is pulled off, if steps run out, and if
    /// `progress` cancels.
    pub fn solve(
        &mut self,
        control: Control,
        start: Start,
        tolerance: f64,
        progress: &dyn Progress,
    ) -> Result<AdhesiveContact, AdhesionError> {
        Bound::LeftOpen { above: 0.0, at_most: 0.1 }.check("tolerance", tolerance)?;
        match control {
            Control::PressurePa(pressure_pa) => Bound::Signed.check("nominal pressure in Pa", pressure_pa)?,
            Control::MeanGapM(gap_m) => Bound::Magnitude.check("mean gap in m", gap_m)?,
        };
        self.operators = 0;
        self.begin(start, control);
        let mut iterations = 0;
        let mut is_rounded = false;
        let gradient = loop {
            if progress.is_cancelled() {
                return Err(HalfSpaceError::Cancelled.into());
            }
            let gradient = self.gradient(control);
            self.check_hold(control, &gradient)?;
            if gradient.residual <= tolerance {
                break gradient;
            }
            if iterations == MOST_NEWTON_STEPS {
                return Err(AdhesionError::NotConverged { residual: gradient.residual });
            }
            iterations += 1;
            let newton = self.newton_direction(&gradient, control);
            if !self.descend(&gradient, &newton, control) {
                let steepest = self.steepest_direction(&gradient, control);
                if !self.descend(&gradient, &steepest, control) {
                    if gradient.residual > 1e-6 {
                        return Err(AdhesionError::NotConverged { residual: gradient.residual });
                    }
                    is_rounded = true;
                    break gradient;
                }
            }
        };
        Ok(self.contact(&gradient, iterations, is_rounded))
    }

    fn begin(&mut self, start: Start, control: Control) {
        let highest = self.heights.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        match start {
            Start::Apart => {
                self.gaps.iter_mut().zip(&self.heights).for_each(|(gap, height)| *gap = highest - height);
            }
            Start::Contact => self.gaps.fill(0.0),
            Start::Last => {}
        }
        if let Control::MeanGapM(gap_m) = control {
            bring_to_mean(&mut self.gaps, &vec![true; self.heights.len()], gap_m / self.unit_m);
        }
        let shape: Vec<f64> = self.gaps.iter().zip(&self.heights).map(|(gap, height)| gap + height).collect();
        self.tractions_of.apply(&shape, &mut self.tractions);
        self.operators += 1;
    }

    fn attraction(&self, gap: f64) -> f64 {
        self.strength * (-gap / self.range).exp()
    }

    fn gradient(&self, control: Control) -> Gradient {
        let count = self.gaps.len();
        let mut values: Vec<f64> =
            (0..count).map(|at| self.tractions[at] + self.attraction(self.gaps[at])).collect();
        let pressure = match control {
            Control::PressurePa(pressure_pa) => pressure_pa / self.unit_pa,
            Control::MeanGapM(_) => {
                let [sum, open] =
                    sums::over(count, |at| if self.gaps[at] > 0.0 { [values[at], 1.0] } else { [0.0; 2] });
                -sum / open.max(1.0)
            }
        };
        let mut worst = 0.0f64;
        let mut is_free = vec![true; count];
        for ((value, &gap), is_free) in values.iter_mut().zip(&self.gaps).zip(&mut is_free) {
            *value += pressure;
            *is_free = gap > 0.0 || *value <= 0.0;
            worst = worst.max(if gap > 0.0 { value.abs() } else { -*value });
        }
        let scale = pressure.abs().max(self.full_rms).max(f64::MIN_POSITIVE);
        Gradient { pressure, residual: worst / scale, values, is_free }
    }

    /// Refuses a state without contact that the load pulls further apart: no minimum of the energy lies beyond.
    fn check_hold(&self, control: Control, gradient: &Gradient) -> Result<(), AdhesionError> {
        let Control::PressurePa(nominal_pressure_pa) = control else { return Ok(()) };
        let is_apart = nominal_pressure_pa <= 0.0 && self.gaps.iter().all(|&gap| gap > 0.0);
        let [net] = sums::over(self.gaps.len(), |at| [gradient.values[at]]);
        if is_apart && net < 0.0 {
            return Err(AdhesionError::PulledOff { nominal_pressure_pa });
        }
        Ok(())
    }

    /// Solves the linear problem of Newton's method on the free points, up to a negative curvature.
    fn newton_direction(&mut self, gradient: &Gradient, control: Control) -> Vec<f64> {
        let count = self.gaps.len();
        let holds_mean = matches!(control, Control::MeanGapM(_));
        let softening: Vec<f32> = self
            .gaps
            .iter()
            .map(|&gap| {
                let softening = (self.attraction(gap) / self.range) as f32;
                if softening > 1e-30 { softening } else { 0.0 }
            })
            .collect();
        let largest = gradient.values.iter().zip(&gradient.is_free).filter(|(_, free)| **free);
        let unit = largest.map(|(value, _)| value.abs()).fold(0.0, f64::max).max(f64::MIN_POSITIVE);
        let mut rest: Vec<f32> = gradient.values.iter().map(|value| (-value / unit) as f32).collect();
        project(&mut rest, &gradient.is_free, holds_mean);
        let mut step = vec![0.0f32; count];
        let mut direction = vec![0.0f32; count];
        let mut conditioned = vec![0.0f32; count];
        let mut response = vec![0.0f32; count];
        let goal = (0.1 * gradient.residual.sqrt().min(0.1)).max(INNER_FLOOR);
        let first = dot(&rest, &rest).sqrt();
        let mut last_weight = 0.0;
        for inner in 0..MOST_INNER_STEPS {
            self.precondition.apply(&rest, &mut conditioned);
            project(&mut conditioned, &gradient.is_free, holds_mean);
            let weight = dot(&rest, &conditioned);
            let keep = if inner == 0 { 0.0 } else { (weight / last_weight) as f32 };
            last_weight = weight;
            direction.iter_mut().zip(&conditioned).for_each(|(to, new)| *to = new + keep * *to);
            self.inner_tractions_of.apply(&direction, &mut response);
            self.operators += 1;
            response
                .iter_mut()
                .zip(&softening)
                .zip(&direction)
                .for_each(|((to, softening), direction)| *to -= softening * direction);
            project(&mut response, &gradient.is_free, holds_mean);
            let curvature = dot(&direction, &response);
            if curvature <= 0.0 {
                if inner == 0 {
                    step.copy_from_slice(&direction);
                }
                break;
            }
            let length = (weight / curvature) as f32;
            step.iter_mut().zip(&direction).for_each(|(to, direction)| *to += length * direction);
            rest.iter_mut().zip(&response).for_each(|(to, response)| *to -= length * response);
            if dot(&rest, &rest).sqrt() <= goal * first {
                break;
            }
        }
        step.iter().map(|&step| unit * f64::from(step)).collect()
    }

    fn steepest_direction(&self, gradient: &Gradient, control: Control) -> Vec<f64> {
        let stiffest = self.grid.rows().max(self.grid.columns()) as f64;
        let values = gradient.values.iter().zip(&gradient.is_free);
        let mut step: Vec<f64> =
            values.map(|(value, &free)| if free { -value / stiffest } else { 0.0 }).collect();
        if matches!(control, Control::MeanGapM(_)) {
            let [sum, free] = sums::over(step.len(), |at| [step[at], f64::from(gradient.is_free[at])]);
            let mean = sum / free.max(1.0);
            step.iter_mut().zip(&gradient.is_free).filter(|(_, free)| **free).for_each(|(to, _)| *to -= mean);
        }
        step
    }

    /// Steps along a direction, halved until the energy falls; returns false if it never does.
    fn descend(&mut self, gradient: &Gradient, direction: &[f64], control: Control) -> bool {
        let count = self.gaps.len();
        let mut response = vec![0.0; count];
        let mut share = 1.0;
        for _ in 0..MOST_HALVINGS {
            let mut gaps: Vec<f64> =
                self.gaps.iter().zip(direction).map(|(gap, step)| (gap + share * step).max(0.0)).collect();
            if let Control::MeanGapM(gap_m) = control {
                gaps.iter_mut().enumerate().for_each(|(at, gap)| {
                    if gradient.is_free[at] {
                        *gap = self.gaps[at] + share * direction[at];
                    }
                });
                bring_to_mean(&mut gaps, &gradient.is_free, gap_m / self.unit_m);
            }
            let change: Vec<f64> = gaps.iter().zip(&self.gaps).map(|(new, old)| new - old).collect();
            self.tractions_of.apply(&change, &mut response);
            self.operators += 1;
            // The gradient times the change, and what the curvature adds: nearly equal energies are not subtracted.
            let [fall] = sums::over(count, |at| {
                let elastic = 0.5 * response[at] * change[at];
                let adhesive =
                    self.range * self.attraction(self.gaps[at]) * beyond_first_order(change[at] / self.range);
                [gradient.values[at] * change[at] + elastic + adhesive]
            });
            if fall < 0.0 {
                self.gaps = gaps;
                self.tractions.iter_mut().zip(&response).for_each(|(to, response)| *to += response);
                return true;
            }
            share *= 0.5;
        }
        false
    }

    fn contact(&self, gradient: &Gradient, iterations: usize, is_rounded: bool) -> AdhesiveContact {
        let points = self.gaps.len();
        let net = |at: usize| gradient.values[at].max(0.0) - self.strength;
        let touching = count(&self.grid, true, points, |at| self.gaps[at] == 0.0);
        let repulsive = count(&self.grid, true, points, |at| self.gaps[at] == 0.0 && net(at) > 0.0);
        let [gap, attraction] = sums::over(points, |at| [self.gaps[at], self.attraction(self.gaps[at])]);
        let closed = (0..points).filter(|&at| self.gaps[at] == 0.0);
        let pressures_pa = (0..points).map(|at| {
            let contact = if self.gaps[at] == 0.0 { gradient.values[at].max(0.0) } else { 0.0 };
            self.unit_pa * (contact - self.attraction(self.gaps[at]))
        });
        let numbers = AdhesiveNumbers {
            nominal_pressure_pa: gradient.pressure * self.unit_pa,
            area_fraction: touching.share,
            area_fraction_corrected: (touching.share - touching.perimeter).clamp(0.0, 1.0),
            repulsive_area_fraction: repulsive.share,
            mean_gap_m: self.unit_m * gap / points as f64,
            mean_attraction_pa: self.unit_pa * attraction / points as f64,
            largest_contact_pressure_pa: self.unit_pa
                * closed.map(|at| gradient.values[at]).fold(0.0, f64::max),
            residual: gradient.residual,
        };
        AdhesiveContact {
            numbers,
            iterations,
            operators: self.operators,
            is_rounded,
            gaps_m: self.gaps.iter().map(|gap| gap * self.unit_m).collect(),
            pressures_pa: pressures_pa.collect(),
        }
    }

    /// Least nominal pressure under which full contact is a local minimum \[Pa\].
    #[must_use]
    pub fn full_contact_pressure_pa(&self) -> f64 {
        let least = self.full.iter().copied().fold(f64::INFINITY, f64::min);
        -self.unit_pa * (least + self.strength)
    }
}

/// 1 - exp(-x) - x, without cancellation.
fn beyond_first_order(x: f64) -> f64 {
    if x.abs() < 1e-3 {
        x * x * (-0.5 + x * (1.0 / 6.0 - x * (1.0 / 24.0 - x / 120.0)))
    } else {
        -(-x).exp_m1() - x
    }
}

/// Shifts the free values by one number, and clips them at 0, such that all have a mean.
fn bring_to_mean(values: &mut [f64], is_free: &[bool], mean: f64) {
    let wanted = mean * values.len() as f64;
    let mut free: Vec<f64> =
        values.iter().zip(is_free).filter(|(_, free)| **free).map(|(value, _)| *value).collect();
    if free.is_empty() {
        return;
    }
    free.sort_unstable_by(|a, b| b.total_cmp(a));
    let (mut sum, mut shift) = (0.0, 0.0);
    for (at, value) in free.iter().enumerate() {
        if at > 0 && value + shift <= 0.0 {
            break;
        }
        sum += value;
        shift = (wanted - sum) / (at + 1) as f64;
    }
    values
        .iter_mut()
        .zip(is_free)
        .filter(|(_, free)| **free)
        .for_each(|(value, _)| *value = (*value + shift).max(0.0));
}

/// Removes what is not free, and the mean of the rest if it is held.
fn project(values: &mut [f32], is_free: &[bool], holds_mean: bool) {
    values.iter_mut().zip(is_free).for_each(|(value, &free)| {
        if !free {
            *value = 0.0;
        }
    });
    if holds_mean {
        let [sum, free] = sums::over(values.len(), |at| [f64::from(values[at]), f64::from(is_free[at])]);
        let mean = (sum / free.max(1.0)) as f32;
        values.iter_mut().zip(is_free).filter(|(_, free)| **free).for_each(|(value, _)| *value -= mean);
    }
}

fn dot(a: &[f32], b: &[f32]) -> f64 {
    sums::over(a.len(), |at| [f64::from(a[at]) * f64::from(b[at])])[0]
}
