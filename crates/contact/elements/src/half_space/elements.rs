//! Boundary elements: a surface, its operators, and the solution for a load.

use numerics::parallel::Progress;

use units::Bound;

use crate::half_space::area::{Count, count};
use crate::half_space::contact::{Contact, ContactNumbers};
use crate::half_space::descent::{Outcome, descend};
use crate::half_space::loading::{Approach, Closing, Loading};
use crate::half_space::problem::{Held, Operators, Problem, State};
use crate::half_space::stiffness::approach_per_pressure;
use crate::half_space::{Grid, HalfSpaceError, operators, sums};
use crate::outline::Outline;

/// Number of progress steps of a solve: the residual's way to the tolerance, in decades, is divided into as many.
pub const PROGRESS_STEPS: usize = 100;

/// Smallest mean pressure in units of the problem: under less, fewer points touch than one in a map of any size, and what
/// they move is near the rounding of the heights.
const LEAST_LOAD: f64 = 1e-13;

/// Boundary elements under a rigid rough surface: plans and buffers, kept between loads.
pub struct Elements {
    grid: Grid,
    periodic: bool,
    /// Heights over their mean, in units of `unit_m`; minus infinity at points that are left out, which never touch.
    heights: Vec<f64>,
    /// Number of points that are not left out.
    laid_out: usize,
    /// Number of points of the nominal area.
    nominal_points: usize,
    mean_height_m: f64,
    /// Unit of length; that of a flat surface, which has none of its own, is chosen with each load.
    unit_m: f64,
    is_flat: bool,
    /// Displacement under the longest wave of the grid, over that of the half-space; 1 without a layer.
    longest_wave: f64,
    operators: Operators,
    state: State,
}

impl Elements {
    /// Lays out the elements under `heights_m`, row by row, of a surface that repeats itself along x and y; high
    /// points touch first.
    ///
    /// A wave of pressure of the wave vector q displaces the half-space by 2/(E* |q|) times its pressure (Westergaard
    /// 1939); displacements have a mean of 0.
    ///
    /// # Errors
    /// [`HalfSpaceError`] for heights that do not match the points, are not finite, or exceed 1e30 m.
    pub fn periodic(grid: Grid, heights_m: &[f64]) -> Result<Self, HalfSpaceError> {
        Self::new(grid, true, heights_m, 1.0, || operators::periodic(&grid))
    }

    /// Lays out the elements of [`periodic`](Self::periodic) on a body that is not a half-space, such as a layer on a base: a wave
    /// of pressure of the wave vector q displaces it by `relative_displacement(|q|)` times as much as the half-space, above 0,
    /// with |q| in rad/m. Displacements have a mean of 0 here too, so gaps leave out what uniform pressure displaces.
    ///
    /// # Errors
    /// [`HalfSpaceError`] for heights that do not match the points, are not finite, or exceed 1e30 m.
    pub fn periodic_on(
        grid: Grid,
        heights_m: &[f64],
        relative_displacement: impl Fn(f64) -> f64,
    ) -> Result<Self, HalfSpaceError> {
        let longest_wave = relative_displacement(grid.unit_wave_number_per_m());
        Self::new(grid, true, heights_m, longest_wave, || {
            operators::periodic_on(&grid, |wave_number| {
                relative_displacement(wave_number * grid.unit_wave_number_per_m()) / longest_wave
            })
        })
    }

    /// Lays out the elements under `heights_m`, row by row, of a surface of finite size, alone on the half-space; high
    /// points touch first.
    ///
    /// Each element carries a uniform pressure and displaces all others by Love's coefficients (1929); zeros pad the
    /// grid to twice its size, so that no load meets its own image. The nominal pressure is the force over the area of
    /// the grid. Points at the edge of a map carry load here, like those of a punch: results for a map cut from a
    /// larger surface are not comparable with those of a periodic one.
    ///
    /// # Errors
    /// [`HalfSpaceError`] for heights that do not match the points, are not finite, or exceed 1e30 m.
    pub fn free(grid: Grid, heights_m: &[f64]) -> Result<Self, HalfSpaceError> {
        Self::new(grid, false, heights_m, 1.0, || operators::free(&grid))
    }

    fn new(
        grid: Grid,
        periodic: bool,
        heights_m: &[f64],
        longest_wave: f64,
        operators: impl FnOnce() -> Operators,
    ) -> Result<Self, HalfSpaceError> {
        grid.check_heights(heights_m)?;
        let points = heights_m.len();
        let mut elements = Self {
            grid,
            periodic,
            heights: Vec::new(),
            laid_out: points,
            nominal_points: points,
            mean_height_m: 0.0,
            unit_m: 0.0,
            is_flat: false,
            longest_wave,
            operators: operators(),
            state: State::new(points),
        };
        elements.scale(heights_m, |_| false);
        Ok(elements)
    }

    /// Leaves out the missing points of an outline: they never touch. Loads and areas are then over the area of the specimen.
    pub(crate) fn on(mut self, outline: &Outline, heights_m: &[f64], is_missing: &[bool]) -> Self {
        self.laid_out = is_missing.iter().filter(|is_missing| !**is_missing).count();
        self.nominal_points = outline.points();
        self.scale(heights_m, |point| is_missing[point]);
        self
    }

    /// Counts heights from the mean of those that are not missing, in units of their rms.
    fn scale(&mut self, heights_m: &[f64], is_missing: impl Fn(usize) -> bool) {
        let points = self.laid_out as f64;
        let laid_out = || (0..heights_m.len()).filter(|&point| !is_missing(point));
        // Over the first height, so that those far above their rms height lose no digits.
        let first_m = laid_out().next().map_or(0.0, |point| heights_m[point]);
        let over_first_m = |point: usize| if is_missing(point) { 0.0 } else { heights_m[point] - first_m };
        let [sum] = sums::over(heights_m.len(), |point| [over_first_m(point)]);
        let mean_over_first_m = sum / points;
        let over_mean_m = |point: usize| over_first_m(point) - mean_over_first_m;
        self.mean_height_m = first_m + mean_over_first_m;
        self.is_flat = is_flat(laid_out().map(|point| heights_m[point]));
        self.unit_m = if self.is_flat {
            self.grid.length_x_m()
        } else {
            let largest_m = laid_out().fold(0.0f64, |largest, point| largest.max(over_mean_m(point).abs()));
            let [squares] = sums::over(heights_m.len(), |point| {
                let height = if is_missing(point) { 0.0 } else { over_mean_m(point) / largest_m };
                [height * height]
            });
            largest_m * (squares / points).sqrt()
        };
        let height = |point: usize| match () {
            () if is_missing(point) => f64::NEG_INFINITY,
            () if self.is_flat => 0.0,
            () => over_mean_m(point) / self.unit_m,
        };
        self.heights = (0..heights_m.len()).map(height).collect();
    }

    /// Share of the grid that the nominal area covers.
    fn nominal_share(&self) -> f64 {
        self.nominal_points as f64 / self.heights.len() as f64
    }

    /// Grid of points.
    #[must_use]
    pub fn grid(&self) -> &Grid {
        &self.grid
    }

    /// Unit of pressure: the pressure that makes one wave of the unit's height along the longer side.
    fn unit_pa(&self, contact_modulus_pa: f64) -> f64 {
        0.5 * contact_modulus_pa * (self.grid.unit_wave_number_per_m() * self.unit_m) / self.longest_wave
    }

    /// Presses the surface with a force over its nominal area; `progress` receives [`PROGRESS_STEPS`] steps.
    ///
    /// # Errors
    /// [`HalfSpaceError`] for a load, modulus, saturation or tolerance out of bounds, for a load that cannot be
    /// carried below the saturation or is lost in the rounding of the heights, and if `progress` cancels.
    pub fn press(&mut self, loading: &Loading, progress: &dyn Progress) -> Result<Contact, HalfSpaceError> {
        self.press_from(None, loading, progress)
    }

    /// Presses the surface as [`press`](Self::press) does, from its contact under another load, which saves steps the more the
    /// closer the loads are. The solution is the same within the tolerance.
    ///
    /// # Errors
    /// Returns the errors of [`press`](Self::press), and [`HalfSpaceError`] for a contact of another grid.
    pub fn press_from(
        &mut self,
        start: Option<&Contact>,
        loading: &Loading,
        progress: &dyn Progress,
    ) -> Result<Contact, HalfSpaceError> {
        loading.check()?;
        if self.is_flat {
            self.unit_m *= loading.nominal_pressure_pa / self.unit_pa(loading.contact_modulus_pa);
        }
        let unit_pa = self.unit_pa(loading.contact_modulus_pa);
        let least_pa = LEAST_LOAD * unit_pa;
        if loading.nominal_pressure_pa < least_pa {
            let nominal_pressure_pa = loading.nominal_pressure_pa;
            return Err(HalfSpaceError::TooLight { nominal_pressure_pa, least_pa });
        }
        if let Some(saturation_pa) = loading.saturation_pa
            && saturation_pa * self.laid_out as f64
                <= loading.nominal_pressure_pa * self.nominal_points as f64
        {
            let nominal_pressure_pa = loading.nominal_pressure_pa;
            return Err(HalfSpaceError::CannotBeCarried { nominal_pressure_pa, saturation_pa });
        }
        if let Some(start) = start {
            self.grid.check_size(start.pressures_pa.len())?;
            let from = self.state.pressures.iter_mut().zip(&start.pressures_pa);
            from.for_each(|(pressure, pressure_pa)| *pressure = pressure_pa / unit_pa);
        }
        let outcome = self.descend(
            start.is_some(),
            Held::Mean(loading.nominal_pressure_pa / unit_pa * self.nominal_share()),
            loading.saturation_pa.map(|saturation_pa| saturation_pa / unit_pa),
            loading.tolerance,
            progress,
        )?;
        Ok(self.contact(loading, unit_pa, &outcome))
    }

    /// Presses the surface to a distance, whatever load that takes; `progress` receives [`PROGRESS_STEPS`] steps.
    ///
    /// # Errors
    /// [`HalfSpaceError`] for a distance, modulus, saturation or tolerance out of bounds, for a distance at which nothing
    /// touches or no gap is left, and if `progress` cancels.
    pub fn press_to(
        &mut self,
        closing: &Closing,
        progress: &dyn Progress,
    ) -> Result<Contact, HalfSpaceError> {
        closing.check()?;
        if let (true, Approach::IndentationM(indentation_m)) = (self.is_flat, closing.approach) {
            self.unit_m = indentation_m;
        }
        let unit_pa = self.unit_pa(closing.contact_modulus_pa);
        let offset = self.offset(closing.approach)?;
        let cap = closing.saturation_pa.map(|saturation_pa| saturation_pa / unit_pa);
        let outcome = self.descend(false, Held::Offset(offset), cap, closing.tolerance, progress)?;
        let [sum] = sums::over(self.heights.len(), |point| [self.state.pressures[point]]);
        let loading = Loading {
            contact_modulus_pa: closing.contact_modulus_pa,
            nominal_pressure_pa: sum / self.nominal_points as f64 * unit_pa,
            saturation_pa: closing.saturation_pa,
            tolerance: closing.tolerance,
        };
        Ok(self.contact(&loading, unit_pa, &outcome))
    }

    /// Offset of the gaps at a distance, in units of the problem.
    fn offset(&self, approach: Approach) -> Result<f64, HalfSpaceError> {
        let highest = self.heights.iter().fold(f64::NEG_INFINITY, |highest, height| highest.max(*height));
        let highest_m = highest * self.unit_m;
        match approach {
            Approach::MeanGapM(_) if !self.periodic => Err(HalfSpaceError::NoMeanGap),
            Approach::MeanGapM(mean_gap_m) if mean_gap_m >= highest_m => {
                Err(HalfSpaceError::Apart { mean_gap_m, highest_m })
            }
            Approach::MeanGapM(mean_gap_m) => Ok(-mean_gap_m / self.unit_m),
            Approach::IndentationM(indentation_m) if self.periodic && indentation_m >= highest_m => {
                Err(HalfSpaceError::Closed { indentation_m, highest_m })
            }
            Approach::IndentationM(indentation_m) => Ok(indentation_m / self.unit_m - highest),
        }
    }

    /// Finds pressures in equilibrium, in units of the problem, from even ones or from those that the state holds.
    fn descend(
        &mut self,
        goes_on: bool,
        held: Held,
        cap: Option<f64>,
        tolerance: f64,
        progress: &dyn Progress,
    ) -> Result<Outcome, HalfSpaceError> {
        let problem = Problem { heights: &self.heights, held, cap: cap.unwrap_or(f64::INFINITY), tolerance };
        let mut reported = ReportedProgress { tolerance, first: None, steps: 0 };
        let outcome = descend(&problem, &mut self.operators, &mut self.state, goes_on, |residual| {
            progress.advance(reported.steps_after(residual));
            !progress.is_cancelled()
        });
        let outcome = outcome.ok_or(HalfSpaceError::Cancelled)?;
        progress.advance(PROGRESS_STEPS - reported.steps);
        Ok(outcome)
    }

    /// Returns the mean pressure that closes the bodies by 1 m from a state in equilibrium, -dp/du \[Pa/m\], with u
    /// the distance of the mean planes. `None` if the whole of a periodic surface touches and no gap is left to close.
    ///
    /// The points in contact stay together and no other joins, which is exact for a small change of load. Where
    /// points flow, this is the elastic stiffness on unloading (which electrical and thermal contact depend on); on
    /// loading it is less. One linear problem, solved by conjugate gradients to 1e-8.
    ///
    /// # Errors
    /// [`HalfSpaceError`] for a contact of another grid, for a modulus out of bounds, and if `progress` cancels.
    pub fn stiffness_pa_per_m(
        &mut self,
        contact: &Contact,
        contact_modulus_pa: f64,
        progress: &dyn Progress,
    ) -> Result<Option<f64>, HalfSpaceError> {
        self.grid.check_size(contact.pressures_pa.len())?;
        let touching: Vec<u32> = (0u32..)
            .zip(contact.touching())
            .filter_map(|(point, touches)| touches.then_some(point))
            .collect();
        if self.periodic && touching.len() == self.heights.len() {
            return Ok(None);
        }
        let over_grid = self.stiffness_together(&touching, contact_modulus_pa, progress)?;
        Ok(Some(over_grid / self.nominal_share()))
    }

    /// Returns the mean pressure over the grid that closes the bodies by 1 m \[Pa/m\] while some points stay together and no
    /// other joins, to 1e-8.
    ///
    /// # Errors
    /// [`HalfSpaceError`] for a modulus out of bounds, and if `progress` cancels.
    pub(crate) fn stiffness_together(
        &mut self,
        together: &[u32],
        contact_modulus_pa: f64,
        progress: &dyn Progress,
    ) -> Result<f64, HalfSpaceError> {
        Bound::Magnitude.check("contact modulus in Pa", contact_modulus_pa)?;
        let (points, operators, state) = (self.heights.len(), &mut self.operators, &mut self.state);
        let approach = approach_per_pressure(points, together, operators, state, || !progress.is_cancelled());
        let approach = approach.ok_or(HalfSpaceError::Cancelled)?;
        Ok(self.unit_pa(contact_modulus_pa) / (approach * self.unit_m))
    }

    /// Returns the mean displacement of some points that all carry the same pressure, per mean pressure over the grid \[m/Pa\].
    ///
    /// # Errors
    /// [`HalfSpaceError`] for a modulus out of bounds.
    pub(crate) fn mean_displacement_m_per_pa(
        &mut self,
        loaded: &[u32],
        contact_modulus_pa: f64,
    ) -> Result<f64, HalfSpaceError> {
        Bound::Magnitude.check("contact modulus in Pa", contact_modulus_pa)?;
        let [pressures, displacements, ..] = self.state.maps();
        pressures.fill(0.0);
        loaded.iter().for_each(|&point| pressures[point as usize] = 1.0);
        self.operators.compliance.apply(pressures, displacements);
        let [sum] = sums::over(loaded.len(), |at| [displacements[loaded[at] as usize]]);
        let count = loaded.len() as f64;
        let per_mean = sum / count * (self.heights.len() as f64 / count);
        Ok(per_mean * self.unit_m / self.unit_pa(contact_modulus_pa))
    }

    /// Converts the solved state to SI.
    fn contact(&self, loading: &Loading, unit_pa: f64, outcome: &Outcome) -> Contact {
        let points = self.heights.len();
        let pressures_pa: Vec<f64> = self.state.pressures.iter().map(|pressure| pressure * unit_pa).collect();
        let gaps_m: Vec<f64> =
            self.state.gaps.iter().map(|gap| (gap - outcome.offset) * self.unit_m).collect();
        let touching = count(&self.grid, self.periodic, self.nominal_points, |point| {
            loading.touches_at(pressures_pa[point])
        });
        let flowing = loading.saturation_pa.map_or(Count::NONE, |_| {
            count(&self.grid, self.periodic, self.nominal_points, |point| {
                loading.yields_at(pressures_pa[point])
            })
        });
        let [open_m, sunk_m, work] = sums::over(points, |point| {
            let gap_m = gaps_m[point];
            if gap_m == f64::INFINITY {
                return [0.0; 3];
            }
            let displacement = self.state.gaps[point] + self.heights[point];
            [gap_m.max(0.0), (-gap_m).max(0.0), pressures_pa[point] * displacement]
        });
        let count = self.laid_out as f64;
        Contact {
            numbers: ContactNumbers {
                nominal_pressure_pa: loading.nominal_pressure_pa,
                area_fraction: touching.share,
                area_fraction_corrected: (touching.share - touching.perimeter).clamp(0.0, 1.0),
                plastic_area_fraction: flowing.share,
                plastic_area_fraction_corrected: (flowing.share + flowing.perimeter)
                    .clamp(0.0, touching.share),
                mean_gap_m: open_m / count,
                mean_plastic_depth_m: sunk_m / count,
                largest_pressure_pa: pressures_pa
                    .iter()
                    .fold(0.0, |largest, &pressure_pa| largest.max(pressure_pa)),
                iterations: outcome.iterations,
                operators: outcome.operators,
                residual: outcome.residual,
                ending: outcome.ending,
            },
            energy_j_per_m2: 0.5 * self.unit_m * work / self.nominal_points as f64,
            offset_m: outcome.offset * self.unit_m - self.mean_height_m,
            pressures_pa,
            gaps_m,
        }
    }
}

/// Returns true if the heights have no size of their own: if they span less than any length in bounds. The mean of equal heights
/// is off by rounding, so distances from it do not tell.
pub(crate) fn is_flat(heights_m: impl Iterator<Item = f64>) -> bool {
    let ends = |(low, high): (f64, f64), height_m: f64| (low.min(height_m), high.max(height_m));
    let (lowest_m, highest_m) = heights_m.fold((f64::INFINITY, f64::NEG_INFINITY), ends);
    !Bound::Magnitude.admits(highest_m - lowest_m)
}

/// Progress reported so far.
struct ReportedProgress {
    tolerance: f64,
    first: Option<f64>,
    steps: usize,
}

impl ReportedProgress {
    /// Number of steps to report at a residual, which may rise and fall.
    fn steps_after(&mut self, residual: f64) -> usize {
        let first = *self.first.get_or_insert(residual.max(2.0 * self.tolerance));
        let way = (first / residual.max(self.tolerance)).ln() / (first / self.tolerance).ln();
        let steps = ((way * PROGRESS_STEPS as f64) as usize).clamp(self.steps, PROGRESS_STEPS);
        steps - std::mem::replace(&mut self.steps, steps)
    }
}
