//! The plan of a judgement: what is pressed, and in which order everything is compared.

use numerics::parallel::{NestedProgress, Progress};
use scene::{JudgeSettings, Scene};
use study::plan::Results;
use units::RemarkCode;

use crate::JudgeError;
use crate::case::Case;
use crate::comparison::{Comparisons, conclude, without_elements};
use crate::judgement::Judgement;
use crate::layout::Layout;
use crate::maps::{MapPressing, MapVerdict, compare_maps};
use crate::pressed_surface::PressedSurface;
use crate::solve::solve;
use crate::standing_maps::press_standing_maps;

/// The surfaces and pressures that the judge will solve for a scene. The budget fixes them before anything is solved.
pub struct JudgePlan<'s> {
    case: Case<'s>,
    settings: JudgeSettings,
    layout: Result<Layout, RemarkCode>,
}

impl<'s> JudgePlan<'s> {
    /// Cuts the spectrum of a scene into windows, as fine as the budget allows.
    #[must_use]
    pub fn new(scene: &'s Scene, results: &'s Results, settings: &JudgeSettings) -> Self {
        let case = Case::new(scene, results);
        let layout = layout(&case, settings);
        JudgePlan { case, settings: *settings, layout }
    }

    /// The number of solutions: one for each pressure and realisation.
    #[must_use]
    pub fn solutions(&self) -> usize {
        self.layout.as_ref().map_or(0, Layout::solutions)
    }

    /// Presses the surfaces and compares every curve with them. `progress` advances once per surface and pressure; surfaces
    /// that are cancelled are not judged.
    ///
    /// # Errors
    /// [`JudgeError`] if a surface cannot be made or pressed, or if a window cannot be given to the models.
    pub fn run(&self, progress: &dyn Progress) -> Result<Judgement, JudgeError> {
        let layout = match &self.layout {
            Err(reason) => return Ok(without_elements(&self.case, *reason)),
            Ok(layout) => layout,
        };
        let solutions = solve(layout, &self.case, self.settings.seed, progress)?;
        let standing = press_standing_maps(&self.case, &layout.loads, self.settings.budget, progress)?;
        let stands = |load: &usize| standing.areas.iter().any(|area| area.load == *load);
        let rest: Vec<usize> = layout.loads.iter().copied().filter(|load| !stands(load)).collect();
        let maps = self.maps(layout.grid, &rest, progress)?;
        let comparisons =
            Comparisons { case: &self.case, layout, solutions: &solutions, maps: &standing.areas };
        let mut windows = comparisons.on_windows()?;
        let whole_band = comparisons.on_whole_band();
        let curves = comparisons.verdicts(&windows, &whole_band);
        if !layout.is_whole_band() {
            windows.extend(whole_band);
        }
        let extent = layout.extent(&self.settings, solutions.spent);
        let references = comparisons.references();
        let mut judgement = conclude(&self.case, Some(extent), windows, curves, references, maps, &standing);
        let (headlines, seed) = (&judgement.headlines, self.settings.seed);
        judgement.surface = PressedSurface::new(&self.case, headlines, standing, seed, progress)?;
        Ok(judgement)
    }

    /// Compares the measured maps behind the spectrum with Gaussian surfaces of their waves.
    fn maps(
        &self,
        grid: usize,
        loads: &[usize],
        progress: &dyn Progress,
    ) -> Result<Vec<MapVerdict>, JudgeError> {
        let pressing = MapPressing { case: &self.case, loads, seed: self.settings.seed, grid };
        compare_maps(&pressing, &NestedProgress(progress))
    }
}

/// The finest layout within the budget, or the reason why there is none.
fn layout(case: &Case<'_>, settings: &JudgeSettings) -> Result<Layout, RemarkCode> {
    if case.curves() == 0 || case.loads() == 0 {
        return Err(RemarkCode::NoSurface);
    }
    let waves = case.waves.as_ref().ok_or(RemarkCode::NoSurface)?;
    Layout::within(settings, case, waves).ok_or(RemarkCode::BeyondBudget)
}
