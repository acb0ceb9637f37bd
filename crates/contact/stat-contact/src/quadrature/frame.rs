//! Integrals at all separations near one.

use super::build;
use super::builder::Scratch;
use super::cell::Cell;
use super::hertz_integrals::HertzIntegrals;
use super::panels::Panels;
use super::precision::{Precision, error_estimate};
use super::sums::Sums;
use crate::asperities::answers::Asperities;
use crate::gaussian::window::Window;
use crate::state::Integrals as StateIntegrals;
use crate::summits::integrals::{SummitIntegrals, SummitSums};

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
    /// Summits: curvatures are spread as well as heights.
    Summits(SummitFrame<'a>),
    Panels(Panels<'a>),
}

/// Summits of any curvature, which are summed over anew at every separation.
struct SummitFrame<'a> {
    integrals: &'a SummitIntegrals,
    /// Relative error at the separation of the last sums.
    relative_error: f64,
    evaluations: usize,
}

impl SummitFrame<'_> {
    fn sums_at(&mut self, u: f64) -> Sums {
        let SummitSums { sums, relative_error, evaluations } = self.integrals.sums_at(u);
        self.relative_error = relative_error;
        self.evaluations += evaluations;
        sums
    }
}

impl<'a> Frame<'a> {
    /// Returns the one frame that all separations share, if every asperity follows Hertz at any interference or is a
    /// summit of a surface.
    pub fn for_every_cell(asperities: &'a dyn Asperities, sigma_s_m: f64) -> Option<Self> {
        let window = Window::up_to(f64::INFINITY);
        if let Some(integrals) = asperities.summits() {
            let summits = SummitFrame { integrals, relative_error: 0.0, evaluations: 0 };
            return Some(Self::new(0.0, window, Integrals::Summits(summits)));
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
            Integrals::Summits(summits) => summits.evaluations,
            Integrals::Panels(panels) => panels.evaluations,
        }
    }

    /// True if a separation is near enough to the centre.
    pub fn serves(&self, u: f64) -> bool {
        // Four times the half width of a cell: steps overshoot, and up to there a window cuts off little more than it
        // may.
        const REACH: f64 = 0.2;
        match &self.integrals {
            Integrals::Closed(_) | Integrals::Summits(_) => true,
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
            Integrals::Summits(summits) => summits.sums_at(u),
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

    /// Moves the frame to a separation near the centre, for further questions there.
    pub fn at(&mut self, u: f64) -> FrameState<'_, 'a> {
        let sums = self.sums_at(u);
        FrameState { frame: self, u, sums }
    }
}

/// A frame at a separation near its centre.
pub(crate) struct FrameState<'f, 'a> {
    frame: &'f Frame<'a>,
    pub u: f64,
    pub sums: Sums,
}

impl FrameState<'_, '_> {
    /// Integrals of a state there.
    pub fn integrals(&self) -> StateIntegrals {
        StateIntegrals {
            u: self.u,
            pressure_pa: self.sums.pressure_pa,
            area_fraction: self.sums.area_fraction,
            mean_height: -self.sums.log_pressure_slope(),
            relative_error: self.relative_error(),
            out_of_range_load_share: self.out_of_range_load_share(),
        }
    }

    /// Estimate of the larger relative error of the two integrals.
    fn relative_error(&self) -> f64 {
        let Frame { window, integrals, .. } = self.frame;
        match integrals {
            Integrals::Closed(hertz) => hertz.relative_error(self.u),
            Integrals::Summits(summits) => summits.relative_error,
            Integrals::Panels(panels) => {
                let saturates = panels.saturation.is_some_and(|(from, _)| from <= window.high);
                let left_out = window.left_out(self.u, saturates);
                error_estimate(panels.relative_error + left_out, self.u)
            }
        }
    }

    /// Share of the load carried at interferences outside the fitted range of the law.
    fn out_of_range_load_share(&self) -> f64 {
        let Frame { window, integrals: Integrals::Panels(panels), .. } = self.frame else { return 0.0 };
        let above_pa = |at_m: f64| if at_m.is_finite() { panels.load_above_pa(at_m) } else { 0.0 };
        let load_pa: f64 = panels
            .asperities
            .out_of_fitted_range(window.high * panels.sigma_s_m)
            .into_iter()
            .filter(|(from_m, to_m)| from_m < to_m)
            .map(|(from_m, to_m)| above_pa(from_m) - above_pa(to_m))
            .sum();
        (load_pa / self.sums.pressure_pa).clamp(0.0, 1.0)
    }
}
