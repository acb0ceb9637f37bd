//! Integrals at all separations near one, and those built by earlier searches, kept for later ones.

use super::build::{self, Scratch};
use super::panels::Panels;
use super::{Cell, Precision, Sums, error_estimate};
use crate::asperities::answers::Asperities;
use crate::gaussian::density::DENSITY_SCALE;
use crate::gaussian::hertz_load::load_and_mean_height;
use crate::gaussian::moments::first_moment;
use crate::gaussian::window::Window;
use crate::state::Integrals as StateIntegrals;
use crate::summits::integrals::SummitIntegrals;

/// Largest number of frames kept, of a few kilobytes each: all between fifty standard deviations on the far side and
/// ten below.
const MOST_FRAMES: usize = 150;

/// Frames of a population at a precision, by their cells.
pub(crate) struct Frames<'a> {
    pub asperities: &'a dyn Asperities,
    pub sigma_s_m: f64,
    pub precision: Precision,
    /// The one frame of all cells, if they can share it.
    everywhere: Option<Frame<'a>>,
    /// Cells in the order of their frames.
    cells: Vec<Cell>,
    built: Vec<Frame<'a>>,
    /// Index of the frame last used, which is usually the next one used.
    last: usize,
    /// Index of the oldest frame, which is replaced next.
    oldest: usize,
    /// Law evaluations spent on frames of cells.
    spent_on_cells: usize,
    scratch: Scratch,
}

impl<'a> Frames<'a> {
    /// Creates an empty store.
    pub fn new(asperities: &'a dyn Asperities, sigma_s_m: f64, precision: Precision) -> Self {
        Frames {
            asperities,
            sigma_s_m,
            precision,
            everywhere: Frame::for_every_cell(asperities, sigma_s_m),
            cells: Vec::new(),
            built: Vec::new(),
            last: 0,
            oldest: 0,
            spent_on_cells: 0,
            scratch: Scratch::default(),
        }
    }

    /// Frame of a cell, built if missing.
    pub fn frame(&mut self, cell: Cell) -> &mut Frame<'a> {
        if !self.are_one() && self.cells.get(self.last) != Some(&cell) {
            self.last =
                self.cells.iter().position(|&other| other == cell).unwrap_or_else(|| self.build(cell));
        }
        match &mut self.everywhere {
            Some(frame) => frame,
            None => &mut self.built[self.last],
        }
    }

    /// Frame of the cell of a separation.
    pub fn at(&mut self, u: f64) -> &mut Frame<'a> {
        if self.are_one() { self.frame(Cell::ANY) } else { self.frame(Cell::containing(u)) }
    }

    /// Law evaluations spent.
    pub fn evaluations(&self) -> usize {
        self.spent_on_cells + self.everywhere.as_ref().map_or(0, Frame::evaluations)
    }

    /// True if all cells share one frame.
    pub fn are_one(&self) -> bool {
        self.everywhere.is_some()
    }

    /// True if the frame of a cell exists.
    pub fn have(&self, cell: Cell) -> bool {
        self.are_one() || self.cells.contains(&cell)
    }

    /// True if one closed form serves all separations.
    pub fn have_closed_form(&self) -> bool {
        self.everywhere.as_ref().is_some_and(Frame::is_closed)
    }

    /// The integrals of a state at a separation.
    pub fn integrals_at(&mut self, u: f64) -> StateIntegrals {
        self.at(u).integrals_at(u).1
    }

    /// The integrals at a separation, on the frame of its cell.
    pub fn sums_at(&mut self, u: f64) -> Sums {
        self.at(u).sums_at(u)
    }

    /// The integrals at a separation from a few nodes around it.
    pub fn rough_sums_at(&mut self, u: f64) -> Sums {
        if let Some(everywhere) = &mut self.everywhere {
            return everywhere.sums_at(u);
        }
        let mut frame = Frame::rough(self.asperities, self.sigma_s_m, u, &mut self.scratch);
        self.spent_on_cells += frame.evaluations();
        frame.sums_at(u)
    }

    /// Builds a frame, and returns its index.
    fn build(&mut self, cell: Cell) -> usize {
        let frame = Frame::for_cell(self.asperities, self.sigma_s_m, cell, self.precision, &mut self.scratch);
        self.spent_on_cells += frame.evaluations();
        if self.built.len() < MOST_FRAMES {
            self.cells.push(cell);
            self.built.push(frame);
            return self.built.len() - 1;
        }
        let place = self.oldest;
        self.oldest = (place + 1) % MOST_FRAMES;
        (self.cells[place], self.built[place]) = (cell, frame);
        place
    }
}

/// Integrals prepared around one separation.
pub(crate) struct Frame<'a> {
    /// Separation around which it is built.
    pub centre: f64,
    /// Interferences that contribute.
    window: Window,
    integrals: Integrals<'a>,
    /// Separation of the last sums.
    u: f64,
    /// Integrals at that separation, once computed.
    sums: Option<Sums>,
    /// Integrals at the centre, at which every search on the frame begins.
    sums_at_centre: Option<Sums>,
}

enum Integrals<'a> {
    /// Closed form: no asperity within the window leaves Hertz's law.
    Closed(HertzIntegrals),
    /// Summits: curvatures are spread as well as heights, and summed over anew at every separation.
    Summits {
        integrals: &'a SummitIntegrals,
        /// Relative error at the separation of the last sums.
        relative_error: f64,
        evaluations: usize,
    },
    Panels(Panels<'a>),
}

impl<'a> Frame<'a> {
    /// Returns the one frame that all separations share, if every asperity follows Hertz at any interference or is a
    /// summit of a surface.
    pub fn for_every_cell(asperities: &'a dyn Asperities, sigma_s_m: f64) -> Option<Self> {
        let window = Window::up_to(f64::INFINITY);
        if let Some(integrals) = asperities.summits() {
            let summits = Integrals::Summits { integrals, relative_error: 0.0, evaluations: 0 };
            return Some(Self::new(0.0, window, summits));
        }
        let hertz = HertzIntegrals::within(&window, asperities, sigma_s_m)?;
        Some(Self::new(0.0, window, Integrals::Closed(hertz)))
    }

    /// Returns the frame that serves a cell of separations at a precision.
    pub fn for_cell(
        asperities: &'a dyn Asperities,
        sigma_s_m: f64,
        cell: Cell,
        precision: Precision,
        scratch: &mut Scratch,
    ) -> Self {
        let precision = precision.around(cell.centre());
        let window = Window::new(cell.nearest(), cell.farthest(), precision.drop);
        let integrals = match HertzIntegrals::within(&window, asperities, sigma_s_m) {
            Some(hertz) => Integrals::Closed(hertz),
            None => {
                let panels = build::for_cell(asperities, sigma_s_m, cell, precision, &window, scratch);
                Integrals::Panels(panels)
            }
        };
        Self::new(cell.centre(), window, integrals)
    }

    /// Returns the pressure around one separation within a percent or so, for a few evaluations, without areas.
    pub fn rough(asperities: &'a dyn Asperities, sigma_s_m: f64, u: f64, scratch: &mut Scratch) -> Self {
        // Far below the mean plane ln p is flat: its curvature, of the order of 1/u^2, has to be resolved.
        const DIGITS: f64 = 10.0;
        let digits = DIGITS + 2.0 * (-u).max(0.0).ln_1p();
        let precision = Precision { tolerance: (-digits).exp(), digits, drop: digits };
        let window = Window::new(u, u, precision.drop);
        let integrals = match HertzIntegrals::within(&window, asperities, sigma_s_m) {
            Some(hertz) => Integrals::Closed(hertz),
            None => Integrals::Panels(build::rough(asperities, sigma_s_m, u, precision, &window, scratch)),
        };
        Self::new(u, window, integrals)
    }

    fn new(centre: f64, window: Window, integrals: Integrals<'a>) -> Self {
        Frame { centre, window, integrals, u: centre, sums: None, sums_at_centre: None }
    }

    /// True if the integrals have a closed form.
    pub fn is_closed(&self) -> bool {
        matches!(self.integrals, Integrals::Closed(_))
    }

    /// Law evaluations spent.
    pub fn evaluations(&self) -> usize {
        match &self.integrals {
            Integrals::Closed(_) => 0,
            Integrals::Summits { evaluations, .. } => *evaluations,
            Integrals::Panels(panels) => panels.evaluations,
        }
    }

    /// True if a separation is near enough to the centre.
    pub fn serves(&self, u: f64) -> bool {
        // Four times the half width of a cell: steps overshoot, and up to there a window cuts off little more than it
        // may.
        const REACH: f64 = 0.2;
        match &self.integrals {
            Integrals::Closed(_) | Integrals::Summits { .. } => true,
            Integrals::Panels(_) => {
                (u - self.centre).abs() < REACH * (1.0 + self.centre.max(0.0)) + 1e-15 * self.centre.abs()
            }
        }
    }

    /// The integrals at a separation near the centre.
    pub fn sums_at(&mut self, u: f64) -> Sums {
        if u != self.u {
            if let Integrals::Panels(panels) = &mut self.integrals {
                panels.go_to(u);
            }
            (self.u, self.sums) = (u, None);
        }
        let sums = *self.sums.get_or_insert_with(|| match &mut self.integrals {
            Integrals::Closed(hertz) => hertz.sums_at(u),
            Integrals::Summits { integrals, relative_error, evaluations } => {
                let found = integrals.sums_at(u);
                *relative_error = found.relative_error;
                *evaluations += found.evaluations;
                found.sums
            }
            Integrals::Panels(panels) => panels.sums(),
        });
        if u == self.centre {
            self.sums_at_centre = Some(sums);
        }
        sums
    }

    /// The integrals at the centre, without moving the frame there.
    pub fn sums_at_centre(&mut self) -> Sums {
        self.sums_at_centre.unwrap_or_else(|| self.sums_at(self.centre))
    }

    /// The integrals at a separation near the centre, with those of a state there.
    pub fn integrals_at(&mut self, u: f64) -> (Sums, StateIntegrals) {
        let sums = self.sums_at(u);
        let state = StateIntegrals {
            u,
            pressure_pa: sums.pressure_pa,
            area_fraction: sums.area_fraction,
            mean_height: -sums.log_pressure_slope(),
            relative_error: self.relative_error(),
            out_of_range_load_share: self.out_of_range_load_share(&sums),
        };
        (sums, state)
    }

    /// Estimate of the larger relative error of the two integrals at the separation of the last sums.
    fn relative_error(&self) -> f64 {
        match &self.integrals {
            Integrals::Closed(hertz) => hertz.relative_error(self.u),
            Integrals::Summits { relative_error, .. } => *relative_error,
            Integrals::Panels(panels) => {
                let saturates = panels.saturation.is_some_and(|(from, _)| from <= self.window.high);
                let left_out = self.window.left_out(self.u, saturates);
                error_estimate(panels.relative_error + left_out, self.u)
            }
        }
    }

    /// Share of the load carried at interferences outside the fitted range of the law.
    fn out_of_range_load_share(&self, sums: &Sums) -> f64 {
        let Integrals::Panels(panels) = &self.integrals else { return 0.0 };
        let above_pa = |at_m: f64| if at_m.is_finite() { panels.load_above_pa(at_m) } else { 0.0 };
        let load_pa: f64 = panels
            .asperities
            .out_of_fitted_range(self.window.high * panels.sigma_s_m)
            .into_iter()
            .filter(|(from_m, to_m)| from_m < to_m)
            .map(|(from_m, to_m)| above_pa(from_m) - above_pa(to_m))
            .sum();
        (load_pa / sums.pressure_pa).clamp(0.0, 1.0)
    }
}

/// Integrals at every separation at which no asperity within reach leaves Hertz's law.
#[derive(Debug, Clone, Copy)]
pub(crate) struct HertzIntegrals {
    pressure_pa: f64,
    area_fraction: f64,
    /// Interference, in units of sigma_s, up to which the law is Hertz's.
    until: f64,
}

impl HertzIntegrals {
    /// Returns `None` if asperities at the highest interference of the window no longer follow Hertz.
    pub fn within(window: &Window, asperities: &dyn Asperities, sigma_s_m: f64) -> Option<Self> {
        let hertz = asperities.hertzian()?;
        let until = hertz.until_m / sigma_s_m;
        (window.high <= until).then(|| HertzIntegrals {
            pressure_pa: DENSITY_SCALE * hertz.pressure_per_three_halves * sigma_s_m * sigma_s_m.sqrt(),
            area_fraction: hertz.area_per_m * sigma_s_m,
            until,
        })
    }

    /// The integrals at the separation u, over the reference density.
    pub fn sums_at(&self, u: f64) -> Sums {
        let (load, mean) = load_and_mean_height(u);
        // Integration by parts reduces the higher means to the first.
        let square = 2.5 + u * mean;
        let cube = 3.5 * mean + 1.5 * u + u * u * mean;
        Sums::new(self.pressure_pa * load, self.area_fraction * first_moment(u), [mean, square, cube])
    }

    /// Estimate of the relative error of the integrals.
    pub fn relative_error(&self, u: f64) -> f64 {
        let other_law =
            if self.until == f64::INFINITY { 0.0 } else { Window::up_to(self.until).left_out(u, false) };
        error_estimate(other_law, u)
    }
}

#[cfg(test)]
mod tests {
    use asperity::{ElasticBody, MaterialPair};

    use super::*;
    use crate::Population;
    use crate::asperities::elastic_sines::ElasticSines;

    #[test]
    fn a_frame_is_built_once_until_it_is_replaced() {
        let pair = MaterialPair::against_rigid(ElasticBody::new(1e11, 0.3).unwrap());
        let asperities = ElasticSines::new(&pair, &Population::new(1e-8, 1e13, 1e-9).unwrap());
        let mut frames = Frames::new(&asperities, 1e-9, Precision::new(1e-6));
        let first = frames.sums_at(0.0).pressure_pa;
        let once = frames.evaluations();
        assert_eq!(frames.sums_at(0.0).pressure_pa, first);
        assert_eq!(frames.evaluations(), once);
        for place in 1..MOST_FRAMES {
            frames.sums_at(-0.1 * place as f64);
        }
        assert!(frames.have(Cell::containing(0.0)));
        frames.sums_at(-0.1 * MOST_FRAMES as f64);
        assert!(!frames.have(Cell::containing(0.0)));
        assert_eq!(frames.built.len(), MOST_FRAMES);
        let before = frames.evaluations();
        assert_eq!(frames.sums_at(0.0).pressure_pa, first);
        assert_eq!(frames.evaluations(), before + once);
    }

    #[test]
    fn the_means_are_the_derivatives_of_the_logarithm() {
        let integrals =
            HertzIntegrals { pressure_pa: DENSITY_SCALE, area_fraction: 1.0, until: f64::INFINITY };
        for u in [-20.0f64, -4.0, -0.5, 0.7, 5.0, 30.0] {
            let slopes = |u: f64| integrals.sums_at(u).log_pressure_slopes();
            let step = 1e-4 * (1.0 + u.abs());
            for order in [0, 1] {
                let difference = (slopes(u + step)[order] - slopes(u - step)[order]) / (2.0 * step);
                let error = (difference / slopes(u)[order + 1] - 1.0).abs();
                assert!(error < 1e-5, "u = {u}, order {order}: {difference} and {:?}", slopes(u));
            }
        }
    }
}
