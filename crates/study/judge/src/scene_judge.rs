//! The judge at work on a scene.

use gaussian_surfaces::AreaSpectrum;
use parallel::{NestedProgress, Progress};
use scene::Scene;
use spectrum::{Moments, Normalisation, amplitudes, cumulative_moments};
use study::plan::{PlanError, Results};

use crate::JudgeError;
use crate::assumptions::{Broken, first_broken, real_pressures};
use crate::body::Body;
use crate::hardness_of_scales::{AboveHardness, HardnessOfScales};
use crate::headline::Headline;
use crate::judgement::Judgement;
use crate::layout::{Asked, Extent, Ground, Layout};
use crate::on_windows;
use crate::phases::{OfMap, Pressed, of_maps};
use crate::reason::Reason;
use crate::settings::Settings;
use crate::solve::{Solutions, Solved, solve};
use crate::verdict::{ERRORS_GIVEN, Verdict};
use crate::verdicts::{Judged, OfCurve, OnWindow};
use crate::window::{Band, Window};
use crate::yielding::Yielding;

/// What Persson's theory for the longer waves and a uniform pressure on the last window leave open of a whole band's area,
/// relatively: one standard error.
const SEAM_ERROR: f64 = 0.1;

/// The rms pressure of full contact over E* from which on slopes are too large for a half-space.
pub const STEEP: f64 = 0.1;

/// What the judge will press for a scene: fixed by the budget before anything is solved.
pub struct JudgePlan<'s> {
    case: Case<'s>,
    settings: Settings,
    layout: Result<Layout, Reason>,
}

impl<'s> JudgePlan<'s> {
    /// Lays the spectrum of a scene out in windows, as fine as the budget allows.
    #[must_use]
    pub fn of(scene: &'s Scene, results: &'s Results, settings: &Settings) -> Self {
        let case = Case::of(scene, results);
        let layout = case.laid_out(settings);
        JudgePlan { case, settings: *settings, layout }
    }

    /// How many surfaces will be pressed, one for each pressure and realisation.
    #[must_use]
    pub fn solutions(&self) -> usize {
        self.layout.as_ref().map_or(0, |layout| layout.presses.len() * layout.realisations)
    }

    /// Presses the surfaces and holds every curve against them. A step of `progress` is a surface under one pressure; what is
    /// cancelled is not judged.
    ///
    /// # Errors
    /// [`JudgeError`] where a surface cannot be made or pressed, or a window cannot be given to the models.
    pub fn carry_out(&self, progress: &dyn Progress) -> Result<Judgement, JudgeError> {
        match &self.layout {
            Err(reason) => Ok(self.case.without_elements(*reason)),
            Ok(layout) => {
                let modulus_pa = self.case.composite_modulus_pa;
                let solutions = solve(layout, modulus_pa, self.settings.seed, progress)?;
                let maps = self.case.maps(layout, self.settings.seed, progress)?;
                let judgement = self.case.judgement(layout, &solutions, &self.settings)?;
                Ok(Judgement { maps, ..judgement })
            }
        }
    }
}

/// A scene's curves and loads as the judge sees them.
struct Case<'s> {
    scene: &'s Scene,
    results: &'s Results,
    composite_modulus_pa: f64,
    /// Moments of the spectrum at every cutoff but the longest.
    moments: Vec<Moments>,
    /// The surface of the spectrum; none where its samples are too few, or noise alone.
    surface: Option<AreaSpectrum>,
    /// The body of every curve.
    bodies: Vec<Body>,
    /// The bounds on pressure that elements are asked for; each once.
    saturations_pa: Vec<Option<f64>>,
    loads_by_pressure: Vec<usize>,
    /// The hardness of the bulk at each scale, where the material yields.
    constant_hardness: Option<HardnessOfScales>,
    /// The hardness that grows with the material's strain-gradient length, where it has one.
    growing_hardness: Option<HardnessOfScales>,
}

impl<'s> Case<'s> {
    fn of(scene: &'s Scene, results: &'s Results) -> Self {
        let bodies: Vec<Body> = scene.needs.curves.iter().map(|curve| Body::of(&curve.model)).collect();
        let mut saturations_pa: Vec<Option<f64>> = Vec::new();
        for bound in bodies.iter().map(|body| body.saturation_pa()) {
            if !saturations_pa.contains(&bound) {
                saturations_pa.push(bound);
            }
        }
        let pressure_pa = |load: &usize| scene.needs.loads[*load].nominal_pressure_pa();
        let mut loads_by_pressure: Vec<usize> = (0..scene.needs.loads.len()).collect();
        loads_by_pressure.sort_by(|a, b| pressure_pa(a).total_cmp(&pressure_pa(b)));
        let scales = amplitudes(&results.psd, scene.needs.amplitudes.unwrap_or_default());
        let hardness_of = |strain_gradient: bool| {
            let strength = scene.material.as_ref()?.strength(strain_gradient).ok()?;
            Some(HardnessOfScales::of(&strength, &scales))
        };
        Case {
            scene,
            results,
            composite_modulus_pa: scene.material.map_or(1.0, |material| material.pair.composite_modulus_pa()),
            moments: cumulative_moments(&results.psd, Normalisation::default()),
            surface: (results.psd.len() > 1).then(|| AreaSpectrum::from_profile(&results.psd).ok()).flatten(),
            bodies,
            saturations_pa,
            loads_by_pressure,
            constant_hardness: hardness_of(false),
            growing_hardness: hardness_of(true),
        }
    }

    /// The layout that the budget allows, or why there is none.
    fn laid_out(&self, settings: &Settings) -> Result<Layout, Reason> {
        let (psd, needs) = (&self.results.psd, &self.scene.needs);
        if needs.curves.is_empty() || needs.loads.is_empty() {
            return Err(Reason::NoSurface);
        }
        let surface = self.surface.as_ref().ok_or(Reason::NoSurface)?;
        let ground = Ground {
            surface,
            band: Band { longest_m: psd.longest_wavelength_m(), shortest_m: psd.shortest_wavelength_m() },
            composite_modulus_pa: self.composite_modulus_pa,
            saturations_pa: &self.saturations_pa,
            loads_by_pressure: &self.loads_by_pressure,
            pressure_pa: &|body, load, wavelength_m| self.pressure_pa(body, load, wavelength_m),
        };
        Layout::within(settings, &ground).ok_or(Reason::BeyondBudget)
    }

    /// The bound of a curve's body, by index.
    fn body_index(&self, curve: usize) -> usize {
        let bound = self.bodies[curve].saturation_pa();
        self.saturations_pa.iter().position(|other| *other == bound).unwrap_or(0)
    }

    /// The rms pressure \[Pa\] of full contact with all waves of the surface down to a wavelength \[m\], which are fewer than its
    /// profiles show: a long wave of a profile is a shorter one of the surface, seen askew.
    fn rms_pressure_pa(&self, wavelength_m: f64) -> f64 {
        let longest_m = self.results.psd.longest_wavelength_m();
        let waves = self.surface.as_ref().and_then(|surface| surface.cut(longest_m, wavelength_m).ok());
        // Of no waves there is no pressure.
        let mean_square = waves.map_or(0.0, |waves| waves.mean_square_gradient());
        0.5 * self.composite_modulus_pa * mean_square.sqrt()
    }

    /// The mean real pressure \[Pa\] that the waves down to a wavelength \[m\] leave, by Persson's theory.
    fn pressure_pa(&self, body: usize, load: usize, wavelength_m: f64) -> f64 {
        let nominal_pa = self.scene.needs.loads[load].nominal_pressure_pa();
        mean_real_pressure_pa(nominal_pa, self.rms_pressure_pa(wavelength_m), self.saturations_pa[body])
    }

    /// The measured maps that the spectrum was made of, beside Gaussian surfaces of their waves.
    fn maps(&self, layout: &Layout, seed: u64, progress: &dyn Progress) -> Result<Vec<OfMap>, JudgeError> {
        let maps = self.scene.surface.made_from.as_ref().map_or(&[][..], |scans| &scans.maps);
        let nominal_pa = |load: usize| self.scene.needs.loads[load].nominal_pressure_pa();
        let pressures_pa = |length_m: f64| {
            let rms_pa = self.rms_pressure_pa(length_m);
            let left = |load: &usize| (*load, mean_real_pressure_pa(nominal_pa(*load), rms_pa, None));
            layout.loads.iter().map(left).collect()
        };
        let pressed = Pressed {
            composite_modulus_pa: self.composite_modulus_pa,
            seed,
            grid: layout.grid,
            pressures_pa: &pressures_pa,
        };
        of_maps(maps, &pressed, &NestedProgress(progress))
    }

    fn judgement(
        &self,
        layout: &Layout,
        solutions: &Solutions,
        settings: &Settings,
    ) -> Result<Judgement, JudgeError> {
        let loads = self.scene.needs.loads.len();
        let broken: Vec<Vec<Option<Broken>>> = (0..self.bodies.len())
            .map(|curve| (0..loads).map(|load| self.broken(curve, load)).collect())
            .collect();
        let mut windows = Vec::new();
        for (at, window) in layout.windows.iter().enumerate() {
            // Every body has pressures of its own.
            let pressures_pa: Vec<Vec<f64>> = (0..self.saturations_pa.len())
                .map(|body| {
                    (0..loads).map(|load| self.pressure_pa(body, load, window.band.longest_m)).collect()
                })
                .collect();
            let areas = self.areas(window, &pressures_pa)?;
            for curve in 0..self.bodies.len() {
                let body = self.body_index(curve);
                for load in 0..loads {
                    let asked = layout.asked[body][at][load];
                    windows.push(self.on_window(Place {
                        curve,
                        load,
                        band: window.band,
                        pressure_pa: pressures_pa[body][load],
                        gradient_pa: self.composite_modulus_pa * window.rms_gradient,
                        area_fraction: areas[curve][load],
                        judged: judged(asked, solutions),
                        broken: broken[curve][load],
                    }));
                }
            }
        }
        let whole_band = layout.windows.len() == 1 && layout.left_out == 0;
        if !whole_band {
            let of_whole: Vec<OnWindow> = self.on_whole_band(&windows, &broken);
            windows.extend(of_whole);
        }
        let curves = (0..self.bodies.len())
            .flat_map(|curve| (0..loads).map(move |load| (curve, load)))
            .map(|(curve, load)| self.of_curve(curve, load, &windows, broken[curve][load], whole_band))
            .collect();
        let extent = Extent {
            grid: layout.grid,
            realisations: layout.realisations,
            seed: settings.seed,
            windows: layout.windows.len(),
            left_out: layout.left_out,
            solved: layout.presses.len(),
            loads: layout.loads.len(),
            reckoned: layout.cost,
            spent: solutions.spent,
            budget: settings.budget,
        };
        Ok(self.concluded(Some(extent), windows, curves))
    }

    /// The area fractions of all curves on a window, under the pressures \[Pa\] that are their bodies' under each load.
    fn areas(&self, window: &Window, pressures_pa: &[Vec<f64>]) -> Result<Vec<Vec<Option<f64>>>, JudgeError> {
        let mut areas = vec![vec![None; self.scene.needs.loads.len()]; self.bodies.len()];
        for (body, pressures_pa) in pressures_pa.iter().enumerate() {
            let is_of_body = |curve: &usize| self.body_index(*curve) == body;
            let (growing, steady): (Vec<usize>, Vec<usize>) = (0..self.bodies.len())
                .filter(is_of_body)
                .partition(|curve| self.bodies[*curve] == Body::Growing);
            let found = self.areas_of(window, &steady, pressures_pa)?;
            for (curve, found) in steady.into_iter().zip(found) {
                areas[curve] = found;
            }
            for curve in growing {
                for (load, pressure_pa) in pressures_pa.iter().enumerate() {
                    if self.yields_while_growing(curve, load).is_none() {
                        areas[curve][load] = self.area_while_growing(window, curve, *pressure_pa)?;
                    }
                }
            }
        }
        Ok(areas)
    }

    /// The area fraction of a curve whose strength grows; none where the window begins with more than that bears.
    fn area_while_growing(
        &self,
        window: &Window,
        curve: usize,
        pressure_pa: f64,
    ) -> Result<Option<f64>, JudgeError> {
        match self.areas_of(window, &[curve], &[pressure_pa]) {
            Ok(areas) => Ok(areas[0][0]),
            Err(JudgeError::Plan(PlanError::Hardness(_))) => Ok(None),
            Err(error) => Err(error),
        }
    }

    fn areas_of(
        &self,
        window: &Window,
        curves: &[usize],
        pressures_pa: &[f64],
    ) -> Result<Vec<Vec<Option<f64>>>, JudgeError> {
        on_windows::area_fractions(self.scene, &self.results.psd, window, curves, pressures_pa)
    }

    /// Every curve on the whole band, held against the elements' area on the last window times what Persson's theory says the
    /// longer waves leave to it.
    fn on_whole_band(&self, windows: &[OnWindow], broken: &[Vec<Option<Broken>>]) -> Vec<OnWindow> {
        let psd = &self.results.psd;
        let band = Band { longest_m: psd.longest_wavelength_m(), shortest_m: psd.shortest_wavelength_m() };
        let gradient_pa = 2.0 * self.rms_pressure_pa(band.shortest_m);
        let loads = 0..self.scene.needs.loads.len();
        let places = (0..self.bodies.len()).flat_map(|curve| loads.clone().map(move |load| (curve, load)));
        let of_place = |(curve, load): (usize, usize)| {
            let last = windows.iter().rev().find(|on| (on.curve, on.load) == (curve, load))?;
            let nominal_pa = self.scene.needs.loads[load].nominal_pressure_pa();
            let judged = last.judged_of_whole(nominal_pa).map(|judged| Judged {
                standard_error: judged.standard_error.hypot(SEAM_ERROR * judged.area_fraction),
                ..judged
            });
            let place = Place {
                curve,
                load,
                band,
                pressure_pa: nominal_pa,
                gradient_pa,
                area_fraction: self.final_area(curve, load),
                judged: judged.ok_or(last.reason),
                broken: broken[curve][load],
            };
            Some(OnWindow { is_whole_band: true, ..self.on_window(place) })
        };
        places.filter_map(of_place).collect()
    }

    fn without_elements(&self, reason: Reason) -> Judgement {
        let loads = self.scene.needs.loads.len();
        let of = |(curve, load): (usize, usize)| {
            let broken = self.broken(curve, load);
            OfCurve {
                curve,
                load,
                area_fraction: self.final_area(curve, load),
                judged: None,
                ratio: None,
                verdict: if broken.is_some() { Verdict::OutOfRange } else { Verdict::NotJudged },
                reason: broken.map_or(reason, Reason::Broken),
                broken,
            }
        };
        let places = (0..self.bodies.len()).flat_map(|curve| (0..loads).map(move |load| (curve, load)));
        self.concluded(None, Vec::new(), places.map(of).collect())
    }

    fn concluded(&self, extent: Option<Extent>, windows: Vec<OnWindow>, curves: Vec<OfCurve>) -> Judgement {
        let loads = 0..self.scene.needs.loads.len();
        let headlines = loads.clone().filter_map(|load| Headline::of(load, &windows, &curves)).collect();
        let steep = |moments: &&Moments| (0.5 * moments.m2).sqrt() > STEEP;
        Judgement {
            extent,
            windows,
            curves,
            headlines,
            maps: Vec::new(),
            yielding: loads.map(|load| self.yielding(load)).collect(),
            steep_from_m: self.moments.iter().find(steep).map(|moments| moments.wavelength_m),
            rms_gradient: self.moments.last().map_or(0.0, |moments| (2.0 * moments.m2).sqrt()),
        }
    }

    fn yielding(&self, load: usize) -> Yielding {
        Yielding::of(
            load,
            &self.elastic_pressures(load),
            self.constant_hardness.as_ref(),
            self.growing_hardness.as_ref(),
        )
    }

    /// The hardness that the material has at each scale, where it yields.
    fn hardness(&self) -> Option<&HardnessOfScales> {
        self.growing_hardness.as_ref().or(self.constant_hardness.as_ref())
    }

    /// The assumption of its own that a curve breaks first, under a load.
    fn broken(&self, curve: usize, load: usize) -> Option<Broken> {
        first_broken(self.scene, self.results, curve, load, self.hardness())
    }

    /// Where a curve whose strength grows would first be pressed beyond its hardness if nothing yielded: its own pressure, or
    /// that of an elastic contact, since what yields presses no harder than that.
    fn yields_while_growing(&self, curve: usize, load: usize) -> Option<AboveHardness> {
        let hardness = self.hardness()?;
        let own = hardness.first_above(real_pressures(self.scene, self.results, curve, load));
        own.or_else(|| hardness.first_above(self.elastic_pressures(load).into_iter()))
    }

    /// The mean real pressure \[Pa\] of Persson's elastic contact against cutoff \[m\].
    fn elastic_pressures(&self, load: usize) -> Vec<(f64, f64)> {
        let nominal_pa = self.scene.needs.loads[load].nominal_pressure_pa();
        let elastic = |moments: &Moments| {
            let rms_pa = self.composite_modulus_pa * (0.5 * moments.m2).sqrt();
            (moments.wavelength_m, mean_real_pressure_pa(nominal_pa, rms_pa, None))
        };
        self.moments.iter().map(elastic).collect()
    }

    fn final_area(&self, curve: usize, load: usize) -> Option<f64> {
        self.results.curves[curve].area_fractions(load).last().map(|(_, area)| *area)
    }

    fn on_window(&self, place: Place) -> OnWindow {
        let Place { curve, load, band, pressure_pa, gradient_pa, area_fraction, judged, broken } = place;
        let pressure_over_gradient = pressure_pa / gradient_pa;
        let grown =
            (self.bodies[curve] == Body::Growing).then(|| self.yields_while_growing(curve, load)).flatten();
        let (judged, reason) = match (judged, grown) {
            (_, Some(above)) => (None, Reason::StrengthGrows { wavelength_m: above.wavelength_m }),
            (Ok(judged), None) => (Some(judged), Reason::NoArea),
            (Err(reason), None) => (None, reason),
        };
        let of_areas = area_fraction.zip(judged).map(|(area_fraction, judged)| {
            let ratio = area_fraction / judged.area_fraction;
            let verdict = Verdict::of_ratio(ratio, judged.relative_error());
            let reason = Reason::Compared {
                longest_m: band.longest_m,
                shortest_m: band.shortest_m,
                ratio,
                pressure_over_gradient,
                agreeing: usize::from(verdict == Verdict::Agrees),
                windows: 1,
            };
            (verdict, reason)
        });
        // What breaks at some scale is broken at all shorter ones.
        let (verdict, reason) =
            match broken.filter(|broken| broken.wavelength_m() >= band.shortest_m * (1.0 - 1e-9)) {
                Some(broken) => (Verdict::OutOfRange, Reason::Broken(broken)),
                None => of_areas.unwrap_or((Verdict::NotJudged, reason)),
            };
        OnWindow {
            curve,
            load,
            longest_m: band.longest_m,
            shortest_m: band.shortest_m,
            is_whole_band: false,
            pressure_pa,
            pressure_over_gradient,
            area_fraction,
            judged,
            verdict,
            reason,
        }
    }

    /// A curve's verdict from those on its windows.
    fn of_curve(
        &self,
        curve: usize,
        load: usize,
        windows: &[OnWindow],
        broken: Option<Broken>,
        whole_band: bool,
    ) -> OfCurve {
        let own = || windows.iter().filter(move |on| (on.curve, on.load) == (curve, load));
        let worst =
            own().filter(|on| on.counted().is_some()).max_by(|a, b| badness(a).total_cmp(&badness(b)));
        let agreeing = own().filter(|on| on.verdict == Verdict::Agrees).count();
        let judged_windows = own().filter(|on| on.counted().is_some()).count();
        let (verdict, reason) = match (broken, worst) {
            (Some(broken), _) => (Verdict::OutOfRange, Reason::Broken(broken)),
            (None, Some(worst)) => (worst.verdict, counted(worst.reason, agreeing, judged_windows)),
            (None, None) => (Verdict::NotJudged, own().next_back().map_or(Reason::NoSurface, |on| on.reason)),
        };
        OfCurve {
            curve,
            load,
            area_fraction: self.final_area(curve, load),
            judged: own().next().and_then(|on| on.judged).filter(|_| whole_band),
            ratio: worst.and_then(OnWindow::ratio),
            verdict,
            reason,
            broken,
        }
    }
}

/// The mean real pressure \[Pa\] of Persson's contact under a nominal pressure \[Pa\], from the rms pressure of full contact
/// \[Pa\], where nothing yields or everything does at one hardness \[Pa\].
fn mean_real_pressure_pa(nominal_pa: f64, rms_pressure_pa: f64, hardness_pa: Option<f64>) -> f64 {
    match hardness_pa {
        None => nominal_pa / persson::elastic::area_fraction(nominal_pa, rms_pressure_pa),
        Some(hardness_pa) if nominal_pa >= hardness_pa => nominal_pa,
        Some(hardness_pa) => {
            nominal_pa / persson::constant_hardness::areas(nominal_pa, rms_pressure_pa, hardness_pa).contact()
        }
    }
}

/// All that is known of a curve on a window.
struct Place {
    curve: usize,
    load: usize,
    band: Band,
    pressure_pa: f64,
    gradient_pa: f64,
    area_fraction: Option<f64>,
    judged: Result<Judged, Reason>,
    broken: Option<Broken>,
}

/// How far a ratio is from one, either way, beyond the errors that it is given.
fn badness(on: &OnWindow) -> f64 {
    on.counted()
        .map_or(f64::NEG_INFINITY, |(ratio, error)| ratio.ln().abs() - (1.0 + ERRORS_GIVEN * error).ln())
}

fn counted(reason: Reason, agreeing: usize, windows: usize) -> Reason {
    match reason {
        Reason::Compared { longest_m, shortest_m, ratio, pressure_over_gradient, .. } => {
            Reason::Compared { longest_m, shortest_m, ratio, pressure_over_gradient, agreeing, windows }
        }
        other => other,
    }
}

fn judged(asked: Asked, solutions: &Solutions) -> Result<Judged, Reason> {
    let solved = match asked {
        Asked::Solved(press) => solutions.of_presses[press]?,
        Asked::Flowing { share } => Solved::between(share),
        Asked::TooLight => return Err(Reason::TooLight),
        Asked::NotChosen => return Err(Reason::LoadNotChosen),
    };
    Ok(Judged { area_fraction: solved.area_fraction, standard_error: solved.standard_error })
}
