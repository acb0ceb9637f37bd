//! Populations pressed to many separations or pressures, with inputs and results as columns of numbers.

use std::sync::{Mutex, PoisonError};

use findings::doubts::ROUNDING;
use numerics::parallel::{Progress, fill_blocks};
use stat_contact::{Condition, ContactState};
use study::material::{Material, MaterialError};
use study::models::{Choice, ModelEntry, ModelOptions, Pressable};
use study::plan::Tolerance;
use units::{Remark, RemarkCode};

use super::{NarrowSpectra, RowsError, StateCounts, rows_of};

/// The number of states that are computed one after the other and share work.
const BLOCK: usize = 1024;

/// A statistical model with its options, for rows of any material and population.
#[derive(Debug, Clone)]
pub struct ContactStates {
    /// The model.
    pub entry: &'static ModelEntry,
    /// The options of the model.
    pub options: ModelOptions,
    /// Relative tolerance of the states.
    pub tolerance: Tolerance,
    /// Leaves rows whose request cannot be met without results, instead of ending with the first.
    pub skips_bad_rows: bool,
}

/// The three numbers of a row's roughness, in the order of [`RowRoughness::columns`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RowRoughness(pub [f64; 3]);

impl RowRoughness {
    /// McCool's parameters, which most models take.
    pub const ASPERITIES: [&'static str; 3] = ["radius_m", "density_per_m2", "sigma_s_m"];

    /// The moments of profiles, which a model of the summits takes instead.
    pub const MOMENTS: [&'static str; 3] = ["m0_m2", "m2", "m4_per_m2"];

    /// The roughness columns of a model.
    #[must_use]
    pub fn columns(entry: &ModelEntry) -> [&'static str; 3] {
        if entry.takes_moments { Self::MOMENTS } else { Self::ASPERITIES }
    }
}

/// The request of one row.
#[derive(Debug, Clone, Copy)]
pub struct StateRequest<'m> {
    /// The bodies in contact.
    pub material: &'m Material,
    /// The roughness.
    pub roughness: RowRoughness,
    /// The separation or pressure.
    pub at: Condition,
}

/// A result column of a state.
type StateColumn = (&'static str, fn(&ContactState) -> Option<f64>);

/// The result columns: separation \[m\], pressure over the nominal area \[Pa\], real over nominal area, natural
/// logarithms of the pressure in Pa and of that area, stiffness over the nominal area \[Pa/m\], an estimate of the relative
/// numerical error of pressure and area, and the share of the load on asperities outside the range of their law.
pub const STATE_COLUMNS: [StateColumn; 8] = [
    ("separation_m", |state| state.separation_m),
    ("pressure_pa", |state| Some(state.pressure_pa)),
    ("area_fraction", |state| Some(state.area_fraction)),
    ("ln_pressure", |state| Some(state.ln_pressure_pa)),
    ("ln_area_fraction", |state| Some(state.ln_area_fraction)),
    ("stiffness_pa_per_m", ContactState::stiffness_pa_per_m),
    ("error_estimate", |state| Some(state.error_estimate)),
    ("out_of_range_load_share", |state| Some(state.out_of_range_load_share)),
];

/// Counts over all rows, for notes.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct StatesFound {
    /// States at a bound, or outside the range of their law.
    pub counts: StateCounts,
    /// Rows that have no summits to press.
    pub narrow: NarrowSpectra,
    /// The number of rows that use a third of the hardness as the strength.
    pub assumed_strengths: usize,
    /// The number of rows of an elastic model whose real pressure exceeds the hardness.
    pub above_hardness: usize,
    /// The number of rows left without results because their request cannot be met.
    pub bad: usize,
    /// The first such row, counted from 0.
    pub first_bad: Option<usize>,
    /// The number of rows without asperities.
    pub without_asperities: usize,
}

impl ContactStates {
    /// Computes the columns, as [`STATE_COLUMNS`] names them, from the request of each row. NaN marks a missing value: a
    /// separation beyond complete contact, or a state of a spectrum narrower than that of any surface. Neighbouring rows of
    /// one material and population share work; the digits depend neither on the order of rows nor on the number of threads.
    /// `progress` advances once per row.
    ///
    /// # Errors
    /// [`RowsError`] of the first bad row, or where `progress` is cancelled.
    pub fn compute<'m>(
        &self,
        rows: usize,
        asked: impl Fn(usize) -> StateRequest<'m> + Sync,
        progress: &dyn Progress,
    ) -> Result<([Vec<f64>; 8], StatesFound), RowsError> {
        let mut columns: [Vec<f64>; 8] = std::array::from_fn(|_| vec![0.0; rows]);
        let found = Mutex::new(StatesFound::default());
        fill_blocks(columns.each_mut().map(Vec::as_mut_slice), BLOCK, |first, columns| {
            if progress.is_cancelled() {
                return Err(RowsError::Cancelled);
            }
            let rows = columns[0].len();
            let of_block = self.fill_block(first, columns, &asked)?;
            found.lock().unwrap_or_else(PoisonError::into_inner).add(&of_block);
            progress.advance(rows);
            Ok(())
        })?;
        Ok((columns, found.into_inner().unwrap_or_else(PoisonError::into_inner)))
    }

    fn fill_block<'m>(
        &self,
        first: usize,
        mut columns: [&mut [f64]; 8],
        asked: &impl Fn(usize) -> StateRequest<'m>,
    ) -> Result<StatesFound, RowsError> {
        let requests: Vec<StateRequest<'m>> = (0..columns[0].len()).map(|row| asked(first + row)).collect();
        let (mut found, mut row) = (StatesFound::default(), 0);
        for run in requests.chunk_by(StateRequest::presses_the_same_as) {
            let is_plastic = self.entry.has(Choice::Strength);
            let pressed = self.contact(&run[0]);
            let assumes =
                is_plastic && pressed.is_ok() && run[0].material.assumed_yield_strength_pa().is_some();
            let hardness_pa = run[0].material.hardness_pa().filter(|_| !is_plastic);
            let mut sweep = match &pressed {
                Ok(Pressable::Contact(contact)) => Some(contact.sweep(self.tolerance.value())),
                _ => None,
            };
            for request in run {
                found.assumed_strengths += usize::from(assumes);
                let state = match (&pressed, &mut sweep) {
                    (Ok(_), Some(sweep)) => sweep.at(request.at).map(Some).map_err(MaterialError::from),
                    (Ok(Pressable::TooNarrow { alpha }), _) => {
                        found.narrow.add(*alpha);
                        Ok(None)
                    }
                    (Ok(Pressable::Contact(_)), None) => unreachable!("a contact has its sweep"),
                    (Err(problem), _) => Err(problem.clone()),
                };
                match state {
                    Ok(state) => {
                        found.counts.add(&state);
                        found.above_hardness += usize::from(is_above(state.as_ref(), hardness_pa));
                        set(&mut columns, row, state.as_ref());
                    }
                    Err(_) if self.skips_bad_rows => {
                        found.add_bad(first + row);
                        set(&mut columns, row, None);
                    }
                    Err(problem) => return Err(RowsError::Row { row: first + row, problem }),
                }
                row += 1;
            }
        }
        Ok(found)
    }

    /// The contact of a row.
    fn contact(&self, request: &StateRequest<'_>) -> Result<Pressable, MaterialError> {
        let model = self.entry.build(request.material, &self.options)?;
        let Some(statistical) = model.statistical() else {
            unreachable!("populations are pressed by statistical models");
        };
        Ok(statistical.press(request.roughness.0)?)
    }
}

impl StateRequest<'_> {
    fn presses_the_same_as(&self, other: &Self) -> bool {
        // Mostly it is one material for all rows, which need not be looked at.
        self.roughness == other.roughness
            && (std::ptr::eq(self.material, other.material) || self.material == other.material)
    }
}

/// Sets a row of the columns, in the order of [`STATE_COLUMNS`].
fn set(columns: &mut [&mut [f64]; 8], row: usize, state: Option<&ContactState>) {
    for (column, (_, of)) in columns.iter_mut().zip(STATE_COLUMNS) {
        column[row] = state.and_then(of).unwrap_or(f64::NAN);
    }
}

/// Returns true if the real pressure of a state exceeds the hardness \[Pa\].
pub(super) fn is_above(state: Option<&ContactState>, hardness_pa: Option<f64>) -> bool {
    let real_pa = state.map(|state| state.pressure_pa / state.area_fraction);
    real_pa.zip(hardness_pa).is_some_and(|(real_pa, hardness_pa)| real_pa > hardness_pa * (1.0 + ROUNDING))
}

impl StatesFound {
    /// Makes the remarks on strengths that were assumed, and on pressures above the hardness, of so many rows.
    pub(crate) fn of_strength(&self, all: usize) -> impl Iterator<Item = Remark> {
        let assumed = rows_of(RemarkCode::AssumedStrengths, self.assumed_strengths, all);
        assumed.into_iter().chain(rows_of(RemarkCode::RowsAboveHardness, self.above_hardness, all))
    }

    fn add(&mut self, other: &StatesFound) {
        self.counts += other.counts;
        self.narrow += other.narrow;
        self.assumed_strengths += other.assumed_strengths;
        self.above_hardness += other.above_hardness;
        self.bad += other.bad;
        self.first_bad = self.first_bad.into_iter().chain(other.first_bad).min();
        self.without_asperities += other.without_asperities;
    }

    fn add_bad(&mut self, row: usize) {
        self.bad += 1;
        self.first_bad.get_or_insert(row);
    }
}

#[cfg(test)]
mod tests {
    use asperity::{ElasticBody, MaterialPair};
    use numerics::parallel::Unobserved;
    use stat_contact::{AsperityLaw, Population, StatisticalContact};
    use study::material::GivenMaterial;
    use study::models::{Framework, named};

    use super::*;

    fn material(modulus_pa: f64) -> Material {
        Material::new(GivenMaterial::new(ElasticBody::new(modulus_pa, 0.3).unwrap()))
    }

    fn states_of(model: &str) -> ContactStates {
        let entry = named(Framework::Statistical, model).unwrap();
        ContactStates {
            entry,
            options: ModelOptions::default(),
            tolerance: Tolerance::default(),
            skips_bad_rows: false,
        }
    }

    type Filled = Result<([Vec<f64>; 8], StatesFound), RowsError>;

    fn filled<'m>(model: &str, rows: usize, asked: impl Fn(usize) -> StateRequest<'m> + Sync) -> Filled {
        states_of(model).compute(rows, asked, &Unobserved)
    }

    #[test]
    fn every_row_has_the_digits_that_it_has_alone() {
        let materials = [material(2e11), material(7e10)];
        let rows = 2 * BLOCK + 77;
        let pressure_pa = |row: usize| 1e4 * (1 + row % 513) as f64;
        let radius_m = |row: usize| if row / 700 == 1 { 2e-6 } else { 1e-6 };
        let which = |row: usize| row / 500 % 2;
        let (columns, found) = filled("hertz", rows, |row| StateRequest {
            material: &materials[which(row)],
            roughness: RowRoughness([radius_m(row), 1e12, 1e-8]),
            at: Condition::Pressure(pressure_pa(row)),
        })
        .unwrap();
        assert_eq!(found.counts.all, rows);
        for row in [0, 1, 499, 500, 699, 700, BLOCK - 1, BLOCK, rows - 1] {
            let body = ElasticBody::new([2e11, 7e10][which(row)], 0.3).unwrap();
            let population = Population::new(radius_m(row), 1e12, 1e-8).unwrap();
            let pair = MaterialPair::against_rigid(body);
            let contact = StatisticalContact::new(&pair, &population, &AsperityLaw::Hertz);
            let alone = contact.at_pressure(pressure_pa(row), 1e-12, None).unwrap();
            assert_eq!(columns[0][row], alone.separation_m.unwrap(), "row {row}");
            assert_eq!(columns[2][row], alone.area_fraction, "row {row}");
            assert_eq!(columns[5][row], alone.stiffness_pa_per_m().unwrap(), "row {row}");
        }
    }

    #[test]
    fn skipped_rows_are_counted_and_the_first_is_known() {
        let steel = material(2e11);
        let asked = |row: usize| StateRequest {
            material: &steel,
            roughness: RowRoughness([if row % 1500 == 1499 { -1.0 } else { 1e-6 }, 1e12, 1e-8]),
            at: Condition::Separation(0.0),
        };
        let states = ContactStates { skips_bad_rows: true, ..states_of("hertz") };
        let (columns, found) = states.compute(3000, asked, &Unobserved).unwrap();
        assert_eq!((found.bad, found.first_bad), (2, Some(1499)));
        assert!(columns[2][1499].is_nan() && columns[2][1500] > 0.0);
    }

    #[test]
    fn the_first_bad_row_is_told_and_narrow_spectra_are_counted() {
        let steel = material(2e11);
        let asked = |row: usize| StateRequest {
            material: &steel,
            roughness: RowRoughness([if row < 1500 { 1e-6 } else { -1.0 }, 1e12, 1e-8]),
            at: Condition::Separation(0.0),
        };
        assert!(matches!(filled("hertz", 3000, asked), Err(RowsError::Row { row: 1500, .. })));
        let narrow = |row: usize| StateRequest {
            material: &steel,
            roughness: RowRoughness([1e-16, 1e-2, if row == 1 { 1e11 } else { 1e13 }]),
            at: Condition::Separation(1e-8),
        };
        let (columns, found) = filled("bgt", 3, narrow).unwrap();
        assert!(columns[2][1].is_nan() && columns[2][0] > 0.0 && columns[2][2] > 0.0);
        assert_eq!((found.narrow.count, found.counts.all), (1, 2));
    }
}
