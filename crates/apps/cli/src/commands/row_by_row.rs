//! Tables of any length, checked as a whole and then computed block by block.

use questions::{LoadInput, MaterialInput, QuestionError};

use super::{Context, say_all, say_notes};
use crate::failure::Failure;
use crate::files::open_table;
use crate::flags::Flags;
use crate::inputs::refuse_replaced;
use crate::output::{Stopped, publish_over_input};
use crate::place::Place;
use crate::progress::Progress;
use crate::timings::Timings;
use questions::rows::RowByRow;
use report::provenance::program;
use study::Progress as _;
use study::material::{MaterialError, NeededFor};
use tables::staging::StagedFiles;
use tables::{Refusal, TableError};
use units::{Remark, RemarkCode, Spelling};

/// Rows that are in memory together.
const BLOCK: usize = 1 << 12;

/// Values that options give to every row.
#[derive(Debug, Default)]
pub(super) struct Constants {
    /// The option, the column that it stands for, and its cell.
    values: Vec<(&'static str, &'static str, String)>,
    /// True if a pressure is in units of the hardness.
    in_hardnesses: bool,
}

impl Constants {
    /// The first option that gives one of these columns, unless a pressure is in units of it.
    fn first_of(&self, columns: &[&str]) -> Option<&'static str> {
        let is_one = |(_, column, _): &&(&str, &str, String)| columns.contains(column) && !self.in_hardnesses;
        self.values.iter().find(is_one).map(|(option, ..)| *option)
    }

    /// Gives every row a text.
    pub fn add(&mut self, option: &'static str, column: &'static str, text: impl Into<String>) {
        self.values.push((option, column, text.into()));
    }

    /// Gives every row a number, to its last digit.
    pub fn add_number(&mut self, option: &'static str, column: &'static str, value: Option<f64>) {
        if let Some(value) = value {
            self.add(option, column, format!("{value:e}"));
        }
    }

    /// The elastic constants of the rough body.
    pub fn add_elastic(&mut self, material: &MaterialInput) -> Result<(), Failure> {
        material.body().map(|body| body.body("poisson_ratio")).transpose()?;
        self.add_number("youngs_modulus", "youngs_modulus_pa", material.youngs_modulus_pa);
        self.add_number("poisson_ratio", "poisson_ratio", material.poisson_ratio);
        Ok(())
    }

    /// The hardness and the strength of the rough body.
    pub fn add_strength(&mut self, material: &MaterialInput) -> Result<(), Failure> {
        let in_hardnesses = QuestionError::from(MaterialError::StrengthInHardnesses);
        let strength_pa = material.yield_strength.map(|strength| strength.pascals(None).ok_or(in_hardnesses));
        let strength_pa = strength_pa.transpose()?;
        material.hardness_and_strength()?;
        if material.counterface_yields()? {
            return Err(Failure::input(
                "the counterface is the softer body, and rows take the strength of the rough one; exchange --material and --on",
            ));
        }
        self.add_number("yield_strength", "yield_strength_pa", strength_pa);
        let hardness_pa = material.indentation_hardness_pa;
        self.add_number("indentation_hardness", "indentation_hardness_pa", hardness_pa);
        Ok(())
    }

    /// Nominal pressures, in units of a hardness \[Pa\] or not.
    pub fn add_pressure(&mut self, pressures: &[LoadInput], hardness_pa: Option<f64>) -> Result<(), Failure> {
        for LoadInput { pressure, label } in pressures {
            let pressure_pa = pressure.pascals(hardness_pa).ok_or_else(|| QuestionError::Load {
                option: "pressure",
                label: Some(label.clone()),
                error: MaterialError::Missing(NeededFor::PressureInHardnesses),
            })?;
            self.in_hardnesses |= pressure.pascals(None).is_none();
            self.add_number("pressure", "pressure_pa", Some(pressure_pa));
        }
        Ok(())
    }
}

/// Reads the table at a place twice, to check all of it before anything is computed, and writes it as it is filled in.
pub(super) fn run(
    input: &Place,
    constants: &Constants,
    rows: &mut dyn RowByRow,
    context: &Context<'_>,
) -> Result<(), Failure> {
    // A table may be extended in its own place, but not at its end.
    if let Err(refusal) = refuse_replaced(input) {
        match &context.shared.output {
            Place::Standard => return Err(Failure::reading(&input.name(), &refusal)),
            Place::File(path) => say_notes([format!("{} is replaced by its extended table", path.display())]),
        }
    }
    let mut timings = Timings::start();
    let mut source = open_table(input)?;
    for (option, column, text) in &constants.values {
        source.set_constant(column, text.clone()).map_err(|error| {
            Failure::Input(format!("{error}: leave {} out, or the column", Flags.option(option)))
        })?;
    }
    let mut count = 0;
    let mut refusal = Refusal::default();
    let mut filled: Vec<&str> = Vec::new();
    source.blocks(BLOCK, |block| {
        count += block.table.rows();
        refusal.extend(rows.check(&block).err().unwrap_or_default());
        let is_new = |column: &&str| block.is_filled(column) && !filled.contains(column);
        let new: Vec<_> = rows.unused().into_iter().filter(is_new).collect();
        filled.extend(new);
        Ok::<(), TableError>(())
    })?;
    refusal.into_result()?;
    let unused: Vec<_> = rows.unused().into_iter().filter(|column| filled.contains(column)).collect();
    if let Some(option) = constants.first_of(&unused).or_else(|| rows.unused_option()) {
        return Err(Failure::Input(Remark::new(RemarkCode::NoRowUsesIt).on(option).words(&Flags)));
    }
    if !unused.is_empty() {
        say_all(&[Remark::new(RemarkCode::UnusedColumn).with("columns", unused.join(", "))], &Flags);
    }
    timings.lap("checking");
    let progress = Progress::towards(count, "rows");
    let mut comments = context.wanted(&[program(context.typed)]).to_vec();
    // Comment lines that came with the table stay with it.
    comments.append(&mut source.comments);
    let say = |notes: Vec<Remark>| progress.aside(|| say_all(&notes, &Flags));
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
    publish_over_input(files)?;
    timings.lap("computing and writing");
    timings.report(context.shared.timings);
    Ok(())
}
