//! Which column of a series holds what, and in which unit.

use units::UnitScale;

use crate::convention::Convention;
use crate::read::header::Abscissa;

/// How the rows of a series are to be read.
#[derive(Debug)]
pub(crate) struct Layout {
    /// The column the wavelengths come from.
    pub(crate) abscissa: AbscissaColumn,
    /// Columns that must agree with it.
    pub(crate) checks: Vec<AbscissaColumn>,
    pub(crate) density: DensityColumn,
    pub(crate) standard_error: Option<ErrorColumn>,
}

#[derive(Clone, Copy, Debug)]
pub(crate) struct AbscissaColumn {
    pub(crate) index: usize,
    pub(crate) quantity: Abscissa,
    pub(crate) scale: UnitScale,
}

#[derive(Clone, Copy, Debug)]
pub(crate) struct DensityColumn {
    pub(crate) index: usize,
    pub(crate) scale: UnitScale,
    pub(crate) convention: Convention,
}

/// The standard errors of the spectrum, in its convention.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ErrorColumn {
    pub(crate) index: usize,
    pub(crate) scale: UnitScale,
}
