//! The names of the columns of a series.

use crate::read::error::{LineProblem, ReadError};
use crate::read::header::{Heading, trailing_unit};
use crate::read::options::{GivenUnits, ReadOptions};
use crate::read::unit::Unit;

/// The names of a file's columns with the caller's options.
pub(crate) struct Header<'h> {
    pub(crate) line: usize,
    pub(crate) names: &'h [String],
    pub(crate) options: &'h ReadOptions,
    pub(crate) units: &'h GivenUnits<'h>,
}

impl Header<'_> {
    pub(crate) fn headings(&self) -> impl Iterator<Item = (usize, Heading<'_>)> {
        self.names.iter().enumerate().filter_map(|(index, name)| Some((index, Heading::parse(name)?)))
    }

    /// Parses the unit in the name of a column.
    pub(crate) fn stated_unit(&self, index: usize) -> Option<Unit> {
        let name = &self.names[index];
        match Heading::parse(name) {
            Some(heading) => heading.unit.and_then(Unit::parse),
            None => trailing_unit(name),
        }
    }

    pub(crate) fn missing_column(&self, quantity: &'static str, accepted: &'static str) -> ReadError {
        LineProblem::MissingColumn { quantity, accepted, found: self.names.to_vec() }.at(self.line)
    }

    pub(crate) fn duplicate(&self, quantity: &'static str, first: usize, second: usize) -> ReadError {
        let (first, second) = (self.names[first].clone(), self.names[second].clone());
        LineProblem::DuplicateColumn { quantity, first, second }.at(self.line)
    }
}
