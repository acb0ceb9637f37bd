//! Assignment of the columns of a series to quantities and units.

use units::UnitScale;

use crate::convention::Convention;
use crate::read::header::Abscissa;

/// Columns of a series with their quantities and units.
#[derive(Debug)]
pub(crate) struct Layout {
    /// Column of the wavelengths.
    pub(crate) abscissa: AbscissaColumn,
    /// Further abscissae, which must agree with the first.
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
