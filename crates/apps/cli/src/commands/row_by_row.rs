//! Tables of any length, checked as a whole and then computed block by block.

use super::material_options::elastic_body;
use super::{Context, say_notes};
use crate::failure::Failure;
use crate::files::open_table;
use crate::output::{Place, Stopped, publish};
use crate::progress::Progress;
use report::provenance::program;
use report::row_notes;
use staging::StagedFiles;
use state_tables::{RowByRow, RowsNote};
use study::Progress as _;
use study::hardness_and_strength::HardnessAndStrength;
use study::material::MaterialError;
use tables::{Refusal, TableError};
use units::{IndentationHardness, Modulus, Pressure};

/// Rows that are in memory together.
const BLOCK: usize = 1 << 12;

/// What options give to every row: the option, the column that it stands for, and its cell.
#[derive(Debug, Default)]
pub(super) struct Constants(Vec<(&'static str, &'static str, String)>);

impl Constants {
    /// Gives every row a text.
    pub fn add(&mut self, option: &'static str, column: &'static str, text: impl Into<String>) {
        self.0.push((option, column, text.into()));
    }

    /// Gives every row a number, to its last digit.
    pub fn add_number(&mut self, option: &'static str, column: &'static str, value: Option<f64>) {
        if let Some(value) = value {
            self.add(option, column, format!("{value:e}"));
        }
    }

    /// The elastic constants of the rough body.
    pub fn add_elastic(
        &mut self,
        modulus: Option<Modulus>,
        poisson_ratio: Option<f64>,
    ) -> Result<(), Failure> {
        if let (Some(modulus), Some(ratio)) = (modulus, poisson_ratio) {
            elastic_body(modulus, "--poisson-ratio", ratio)?;
        }
        self.add_number("--youngs-modulus", "youngs_modulus_pa", modulus.map(|modulus| modulus.pa));
        self.add_number("--poisson-ratio", "poisson_ratio", poisson_ratio);
        Ok(())
    }

    /// The hardness and the strength of the rough body.
    pub fn add_strength(
        &mut self,
        hardness: Option<IndentationHardness>,
        strength: Option<Pressure>,
    ) -> Result<HardnessAndStrength, Failure> {
        let pascals = |strength: Pressure| strength.pascals(None).ok_or(MaterialError::StrengthInHardnesses);
        let strength_pa = strength.map(pascals).transpose()?;
        let both = HardnessAndStrength::new(hardness, strength).map_err(MaterialError::from)?;
        self.add_number("--yield-strength", "yield_strength_pa", strength_pa);
        let hardness_pa = hardness.map(|hardness| hardness.pa);
        self.add_number("--indentation-hardness", "indentation_hardness_pa", hardness_pa);
        Ok(both)
    }
}

/// Reads the table at a place twice, to check all of it before anything is computed, and writes it as it is filled in.
pub(super) fn run(
    input: &Place,
    constants: &Constants,
    rows: &mut dyn RowByRow,
    context: &Context<'_>,
) -> Result<(), Failure> {
    // A table may be extended in its own place.
    context.targets(None)?;
    let mut source = open_table(input)?;
    for (option, column, text) in &constants.0 {
        source
            .set_constant(column, text.clone())
            .map_err(|error| Failure::Input(format!("{error}: leave {option} out, or the column")))?;
    }
    let mut count = 0;
    let mut refusal = Refusal::default();
    source.blocks(BLOCK, |block| {
        count += block.table.rows();
        refusal.extend(rows.check(&block).err().unwrap_or_default());
        Ok::<(), TableError>(())
    })?;
    refusal.into_result()?;
    let progress = Progress::towards(count, "rows");
    let mut comments = context.wanted(&[program(context.typed)]).to_vec();
    // What somebody else has written above the table belongs to it.
    comments.append(&mut source.comments);
    let say = |notes: Vec<RowsNote>| progress.aside(|| say_notes(notes.iter().flat_map(row_notes::lines)));
    let mut files = StagedFiles::default();
    context.stage_blocks(&mut files, &context.shared.output, &comments, |out| {
        source.blocks(BLOCK, |mut block| {
            let filled = rows.fill_in(&mut block, &progress);
            if progress.is_cancelled() {
                return Err(Failure::Interrupted.into());
            }
            say(filled.map_err(Failure::input)?);
            Ok::<(), Stopped>(out.block(&block.table)?)
        })?;
        say(rows.notes());
        Ok(())
    })?;
    publish(files)
}
