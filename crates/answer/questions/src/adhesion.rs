//! Surfaces that attract each other, pressed and pulled apart by boundary elements.

use asperity::MaterialPair;
use elements::half_space::{Adhesion, GOOD_RESOLUTION};
use elements::{
    AdhesivePressing, AdhesiveState, Branch, Pressing, Relief, Surfaces, adhesive_means, adhesive_table,
};
use findings::doubts::{self, PressedBodies};
use interface::adhesion::{NOT_STICKY_ABOVE, StickyContact};
use numerics::parallel::Progress;
use serde::{Deserialize, Serialize};
use spectrum::random_surfaces::AreaSpectrum;
use study::interface::AdhesionRequest;
use study::surface::Surface;
use units::display::three_digits;
use units::{Pressure, PressureRange, Remark, RemarkCode};

use crate::adhesion_figure;
use crate::elements::{ELEMENTS, Prepared, RandomInput, notes_on_maps, notes_on_spectrum, random_surfaces};
use crate::loads::{LoadInput, nominal_pressure, pressures_pa};
use crate::{Answer, MaterialInput, QuestionError};

/// Difference of areas above which two branches count as two states.
const SAME_AREA: f64 = 1e-3;

/// The branches of a contact with adhesion, by the history of the load.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum BranchChoice {
    /// From the surfaces that just touch.
    #[default]
    Apart,
    /// From full contact.
    Contact,
    /// Both, one behind the other.
    Both,
}

units::named!(BranchChoice, "branch", { Apart => "apart", Contact => "contact", Both => "both" });

impl BranchChoice {
    fn branches(self) -> Vec<Branch> {
        match self {
            BranchChoice::Apart => vec![Branch::Apart],
            BranchChoice::Contact => vec![Branch::Contact],
            BranchChoice::Both => vec![Branch::Apart, Branch::Contact],
        }
    }
}

/// A surface that attracts what presses on it.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct AdhesionQuestion {
    /// Bodies in contact; the roughness is that of both.
    pub material: MaterialInput,
    /// Nominal pressures; negative ones pull.
    pub pressures: Vec<LoadInput>,
    /// Nominal pressures as ranges, behind the others.
    pub pressure_ranges: Vec<PressureRange>,
    /// Work of adhesion w \[J/m^2\].
    pub work_of_adhesion_j_per_m2: f64,
    /// Range rho of the attraction (w/rho) exp(-g/rho) \[m\].
    pub range_m: f64,
    /// The branches that are followed.
    pub branch: BranchChoice,
    /// True to pull the surfaces apart in place of loads.
    pub pull_off: bool,
    /// Largest residual, above 0 and at most 0.1; [`Pressing::TOLERANCE`] if absent.
    pub tolerance: Option<f64>,
    /// A row for each surface instead of their mean.
    pub per_realisation: bool,
    /// Random surfaces, for a spectrum.
    pub random: RandomInput,
}

/// Adhesive surfaces ready to be pressed, or to be pulled apart as the question asks.
pub type PreparedAdhesion = Prepared<(AdhesivePressing, AdhesionQuestion)>;

impl AdhesionQuestion {
    /// Finds input that contradicts itself or is missing.
    ///
    /// # Errors
    /// [`QuestionError`] with the first of it.
    pub fn check(&self) -> Result<(), QuestionError> {
        self.pressing().map(drop)
    }

    /// Prepares random surfaces of a spectrum.
    ///
    /// # Errors
    /// [`QuestionError`].
    pub fn on(&self, surface: &Surface) -> Result<PreparedAdhesion, QuestionError> {
        let material = self.material.of_half_spaces("adhesion")?;
        let mut notes = notes_on_spectrum(&material, surface);
        let elastic = Pressing::elastic(material.pair.composite_modulus_pa());
        let (random, made) = random_surfaces(surface, &self.random, &elastic)?;
        notes.extend(made);
        notes.extend(self.indicators(&random.band, &material.pair));
        self.prepared(Surfaces::Random(random), notes)
    }

    /// Prepares maps as measured, which must be periodic.
    ///
    /// # Errors
    /// [`QuestionError`].
    pub fn on_maps(&self, maps: Vec<Relief>) -> Result<PreparedAdhesion, QuestionError> {
        let material = self.material.of_half_spaces("adhesion")?;
        let notes = notes_on_maps(&material, &maps);
        self.prepared(Surfaces::Maps(maps), notes)
    }

    fn prepared(
        &self,
        surfaces: Surfaces,
        mut notes: Vec<Remark>,
    ) -> Result<PreparedAdhesion, QuestionError> {
        let pressing = self.pressing()?;
        let first = surfaces.relief(0).map_err(elements::AdhesiveError::from)?;
        let points = pressing.resolution(&first)?;
        drop(first);
        if points < GOOD_RESOLUTION {
            notes.push(Remark::new(RemarkCode::ProcessZoneCoarse).with("process_zone_points", points));
        }
        let hardness_pa = self.material.material()?.hardness_pa();
        Ok(Prepared { surfaces, notes, pressing: (pressing, self.clone()), hardness_pa })
    }

    fn pressing(&self) -> Result<AdhesivePressing, QuestionError> {
        let material = self.material.of_half_spaces("adhesion")?;
        let load_pa = |LoadInput { pressure, label }: &LoadInput| match pressure {
            // Negative ones pull, which nominal pressures do not.
            Pressure::Pascals(load_pa) => Ok(*load_pa),
            _ => {
                nominal_pressure("pressure", Some(label), *pressure, &material).map(|pressure| pressure.pa())
            }
        };
        let loads_pa = self.pressures.iter().map(load_pa).collect::<Result<Vec<f64>, QuestionError>>()?;
        let loads_pa = [loads_pa, pressures_pa(&[], &self.pressure_ranges, &material)?].concat();
        Ok(AdhesivePressing {
            contact_modulus_pa: material.pair.composite_modulus_pa(),
            adhesion: Adhesion { work_j_per_m2: self.work_of_adhesion_j_per_m2, range_m: self.range_m },
            pressures_pa: loads_pa,
            branches: self.branch.branches(),
            tolerance: self.tolerance.unwrap_or(Pressing::TOLERANCE),
        })
    }

    /// The indicators of the waves that are pressed.
    fn indicators(&self, waves: &AreaSpectrum, pair: &MaterialPair) -> Option<Remark> {
        let (moments, contact_modulus_pa) = (waves.moments(), pair.composite_modulus_pa());
        let adhesion =
            AdhesionRequest { work_j_per_m2: self.work_of_adhesion_j_per_m2, range_m: Some(self.range_m) };
        let left_side = adhesion.pastewka_robbins(&moments, contact_modulus_pa).ok().flatten()?;
        let remark = Remark::new(RemarkCode::AdhesionIndicators)
            .with("pastewka_robbins", left_side)
            .with("sticky_below", three_digits(StickyContact::LIMIT))
            .with("not_sticky_above", three_digits(NOT_STICKY_ABOVE));
        Some(match adhesion.fuller_tabor(&moments, contact_modulus_pa).ok().flatten() {
            Some(theta) => remark.with("fuller_tabor", theta),
            None => remark,
        })
    }
}

impl PreparedAdhesion {
    /// Presses the surfaces, or pulls them apart. The table has the columns of [`adhesive_table`](elements::adhesive_table).
    ///
    /// # Errors
    /// [`QuestionError::Adhesion`] for a load that pulls the surfaces apart, and for numbers out of their bounds.
    pub fn answer(&self, progress: &dyn Progress) -> Result<Answer, QuestionError> {
        let (pressing, question) = &self.pressing;
        if question.pull_off {
            let states = pressing.pull_apart(&self.surfaces, progress)?;
            let strongest = strongest_pulls(&states);
            let notes = pull_off(&strongest).into_iter().collect();
            return Ok(Answer {
                table: adhesive_table(&states, self.surfaces.count() > 1),
                notes,
                figure: Some(adhesion_figure::pull_off_curve(&states, &strongest)),
            });
        }
        let states = pressing.press(&self.surfaces, progress)?;
        let means = adhesive_means(&states);
        let mut notes: Vec<Remark> = hysteresis(&means).into_iter().collect();
        if states.iter().any(|state| state.numbers.nominal_pressure_pa < 0.0) {
            notes.push(Remark::new(RemarkCode::Metastable));
        }
        let (modulus_pa, hardness_pa) = (pressing.contact_modulus_pa, self.hardness_pa);
        let bodies = PressedBodies { name: ELEMENTS, modulus_pa, hardness_pa, is_elastic: true };
        let areas: Vec<_> = means
            .iter()
            .map(|mean| (mean.numbers.nominal_pressure_pa, mean.numbers.area_fraction_corrected))
            .collect();
        notes.extend(doubts::of_contact(&bodies, None, &areas));
        let rows = if question.per_realisation { &states } else { &means };
        Ok(Answer {
            table: adhesive_table(rows, question.per_realisation),
            notes,
            figure: Some(adhesion_figure::area_on_branches(&means)),
        })
    }
}

/// The load at which the branches differ most, if they do.
fn hysteresis(means: &[AdhesiveState]) -> Option<Remark> {
    let (apart, contact): (Vec<&AdhesiveState>, Vec<&AdhesiveState>) =
        means.iter().partition(|state| state.branch == Branch::Apart);
    let pairs = apart.iter().zip(&contact);
    let difference = |pair: &(&&AdhesiveState, &&AdhesiveState)| {
        pair.1.numbers.area_fraction - pair.0.numbers.area_fraction
    };
    let widest = pairs.max_by(|a, b| difference(a).total_cmp(&difference(b)))?;
    (difference(&widest) > SAME_AREA).then(|| {
        Remark::new(RemarkCode::Hysteresis)
            .with("hysteresis_pressure_pa", widest.0.numbers.nominal_pressure_pa)
            .with("hysteresis_apart_area_fraction", widest.0.numbers.area_fraction)
            .with("hysteresis_contact_area_fraction", widest.1.numbers.area_fraction)
    })
}

/// The state of every surface under its largest pull.
fn strongest_pulls(states: &[AdhesiveState]) -> Vec<AdhesiveState> {
    let surfaces = states.chunk_by(|one, other| one.surface == other.surface);
    let strongest = |of_surface: &[AdhesiveState]| {
        of_surface
            .iter()
            .copied()
            .min_by(|a, b| a.numbers.nominal_pressure_pa.total_cmp(&b.numbers.nominal_pressure_pa))
    };
    surfaces.filter_map(strongest).collect()
}

/// The largest pull of every surface, averaged.
fn pull_off(strongest: &[AdhesiveState]) -> Option<Remark> {
    if strongest.is_empty() {
        return None;
    }
    let mean = |of: fn(&AdhesiveState) -> f64| strongest.iter().map(of).sum::<f64>() / strongest.len() as f64;
    let remark = Remark::new(RemarkCode::PullOff)
        .with("pull_off_pressure_pa", mean(|state| state.numbers.nominal_pressure_pa))
        .with("pull_off_mean_gap_m", mean(|state| state.numbers.mean_gap_m))
        .with("pull_off_area_fraction", mean(|state| state.numbers.area_fraction));
    Some(remark)
}
