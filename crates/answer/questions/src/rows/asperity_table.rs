//! `asperity`: the contact laws of one asperity as columns of a table.

use asperity::{Bound, ElasticBody, ElasticPlasticSinusoid, Hardness, Hertz, JacksonGreen, MaterialPair};
use numerics::parallel::Progress;
use tables::{Cells, InputTable, Refusal};

use super::strength_columns::{
    INDENTATION_HARDNESS, STRAIN_GRADIENT_LENGTH, YIELD_STRENGTH, assumed_strengths, yield_strengths_pa,
};
use super::{RowByRow, RowsError, rows_of};
use units::{Remark, RemarkCode};

const ELASTIC_COLUMNS: [(&str, Bound); 2] =
    [("youngs_modulus_pa", Bound::Magnitude), ("poisson_ratio", ElasticBody::POISSON_RATIO)];

const STRENGTH: Bound = Bound::Positive;

/// Modulus \[Pa\], Poisson's ratio and yield strength \[Pa\] of a row, and the inputs of its law.
type Inputs<const IN: usize> = ([f64; 3], [f64; IN]);

/// A law of a material pair, a yield strength \[Pa\] and its inputs.
type Law<const IN: usize, const OUT: usize> = fn(&MaterialPair, f64, [f64; IN]) -> ([f64; OUT], bool);

/// A law as columns: the inputs after the material, the results, and the law between them, which also returns true for
/// results within its fitted range.
struct Columns<const IN: usize, const OUT: usize> {
    inputs: [(&'static str, Bound); IN],
    results: [&'static str; OUT],
    law: Law<IN, OUT>,
    range: &'static str,
}

const SPHERE: Columns<2, 5> = Columns {
    inputs: [("radius_m", Bound::Positive), ("interference_m", Bound::AtLeast(0.0))],
    results: [
        "hertz_force_n",
        "hertz_area_m2",
        "jackson_green_force_n",
        "jackson_green_area_m2",
        "jackson_green_force_cosine_hardness_n",
    ],
    law: |pair, strength_pa, [radius_m, w_m]| {
        let hertz = Hertz::new(pair, radius_m);
        let [published, cosine] = [Hardness::JacksonGreen2005, Hardness::Cosine]
            .map(|hardness| JacksonGreen::new(pair, radius_m, strength_pa, hardness));
        let results = [
            hertz.force_n(w_m),
            hertz.area_m2(w_m),
            published.force_n(w_m),
            published.area_m2(w_m),
            cosine.force_n(w_m),
        ];
        (results, published.in_fitted_range(w_m))
    },
    range: "the range that Jackson & Green's sphere was fitted in, a/R <= 0.41 and Sy/E* <= 0.01",
};

const SINUSOID: Columns<2, 6> = Columns {
    inputs: [("aspect_ratio", Bound::Positive), ("pressure_pa", Bound::Positive)],
    results: [
        "complete_contact_pressure_elastic_pa",
        "area_fraction_elastic",
        "critical_aspect_ratio",
        "complete_contact_pressure_ep_pa",
        "area_fraction_ep",
        "mean_gap_over_amplitude",
    ],
    law: |pair, strength_pa, [aspect_ratio, pressure_pa]| {
        let sinusoid = ElasticPlasticSinusoid::new(pair, aspect_ratio, strength_pa);
        let results = [
            sinusoid.elastic().complete_contact_pressure_pa(),
            sinusoid.elastic().area_fraction(pressure_pa),
            sinusoid.critical_aspect_ratio(),
            sinusoid.complete_contact_pressure_pa(),
            sinusoid.area_fraction(pressure_pa),
            sinusoid.mean_gap_over_amplitude(pressure_pa),
        ];
        (results, sinusoid.in_fitted_range())
    },
    range: SINUSOID_RANGE,
};

const SINUSOID_INTERFERENCE: Columns<3, 4> = Columns {
    inputs: [
        ("wavelength_m", Bound::Positive),
        ("aspect_ratio", Bound::Positive),
        ("interference_m", Bound::Positive),
    ],
    results: ["pressure_elastic_pa", "area_fraction_elastic", "pressure_ep_pa", "area_fraction_ep"],
    law: |pair, strength_pa, [wavelength_m, aspect_ratio, interference_m]| {
        let sinusoid = ElasticPlasticSinusoid::new(pair, aspect_ratio, strength_pa);
        let over_amplitude = interference_m / (aspect_ratio * wavelength_m);
        let elastic_pa = sinusoid.elastic().pressure_at_interference_pa(over_amplitude);
        let plastic_pa = sinusoid.pressure_at_interference_pa(over_amplitude);
        let results = [
            elastic_pa,
            sinusoid.elastic().area_fraction(elastic_pa),
            plastic_pa,
            sinusoid.area_fraction(plastic_pa),
        ];
        (results, sinusoid.in_fitted_range())
    },
    range: SINUSOID_RANGE,
};

const SINUSOID_RANGE: &str = "B/B_c <= 100, up to which the elastic-plastic sinusoid is trusted";

/// The laws by the names of their tables.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum AsperityTable {
    /// A sphere at an interference (`docs/theory/models.md`, sections 2.1 and 2.2).
    Sphere,
    /// A sinusoid at a mean pressure (sections 2.3 to 2.5).
    Sinusoid,
    /// A sinusoid pressed to an interference (section 2.6).
    SinusoidInterference,
}

impl AsperityTable {
    /// The names of its result columns.
    pub fn results(self) -> &'static [&'static str] {
        match self {
            AsperityTable::Sphere => &SPHERE.results,
            AsperityTable::Sinusoid => &SINUSOID.results,
            AsperityTable::SinusoidInterference => &SINUSOID_INTERFERENCE.results,
        }
    }

    /// Sets the result columns of a table from its input columns, against a counterface, or a rigid one if `None`.
    /// Returns the number of rows beyond the range of the law.
    ///
    /// # Errors
    /// [`RowsError`] for a missing column, or listing the first bad cells with line, column, value and bound.
    pub fn set_results(
        self,
        input: &mut InputTable,
        counterface: Option<ElasticBody>,
    ) -> Result<usize, RowsError> {
        match self {
            AsperityTable::Sphere => SPHERE.set_results(input, counterface),
            AsperityTable::Sinusoid => SINUSOID.set_results(input, counterface),
            AsperityTable::SinusoidInterference => SINUSOID_INTERFERENCE.set_results(input, counterface),
        }
    }

    /// Checks the input columns.
    ///
    /// # Errors
    /// [`Refusal`] for a missing column, or of the bad cells.
    pub fn check(self, input: &InputTable) -> Result<(), Refusal> {
        match self {
            AsperityTable::Sphere => SPHERE.read(input).map(|_| ()),
            AsperityTable::Sinusoid => SINUSOID.read(input).map(|_| ()),
            AsperityTable::SinusoidInterference => SINUSOID_INTERFERENCE.read(input).map(|_| ()),
        }
    }

    /// The range that the law was fitted in.
    #[must_use]
    pub fn range(self) -> &'static str {
        match self {
            AsperityTable::Sphere => SPHERE.range,
            AsperityTable::Sinusoid => SINUSOID.range,
            AsperityTable::SinusoidInterference => SINUSOID_INTERFERENCE.range,
        }
    }
}

/// A table of asperities.
#[derive(Debug)]
pub struct Asperities {
    law: AsperityTable,
    counterface: Option<ElasticBody>,
    rows: usize,
    /// The number of rows beyond the range of the law.
    beyond: usize,
    /// The number of rows checked with a hardness and no yield strength.
    assumed: usize,
    /// The number of rows checked with a yield strength.
    given: usize,
}

impl Asperities {
    /// Asperities under a law, against a counterface, or a rigid one if `None`.
    #[must_use]
    pub fn new(law: AsperityTable, counterface: Option<ElasticBody>) -> Self {
        Asperities { law, counterface, rows: 0, beyond: 0, assumed: 0, given: 0 }
    }
}

impl RowByRow for Asperities {
    fn check(&mut self, block: &InputTable) -> Result<(), Refusal> {
        let assumed = assumed_strengths(block);
        self.assumed += assumed;
        self.given += block.table.rows() - assumed;
        self.law.check(block)
    }

    fn fill_in(&mut self, block: &mut InputTable, _: &dyn Progress) -> Result<Vec<Remark>, RowsError> {
        self.beyond += self.law.set_results(block, self.counterface)?;
        self.rows += block.table.rows();
        Ok(Vec::new())
    }

    fn knows(&self, column: &str) -> bool {
        [YIELD_STRENGTH, INDENTATION_HARDNESS, STRAIN_GRADIENT_LENGTH].contains(&column)
    }

    fn depends_on(&self, column: &str) -> bool {
        match column {
            YIELD_STRENGTH => self.given > 0,
            INDENTATION_HARDNESS => self.assumed > 0,
            _ => column != STRAIN_GRADIENT_LENGTH,
        }
    }

    fn notes(&self) -> Vec<Remark> {
        let (assumed, beyond, all) = (self.assumed, self.beyond, self.rows);
        let assumed = rows_of(RemarkCode::AssumedStrengths, assumed, all);
        let beyond = rows_of(RemarkCode::RowsOutOfRange, beyond, all);
        let beyond = beyond.map(|remark| remark.with("range", self.law.range()));
        assumed.into_iter().chain(beyond).collect()
    }
}

/// Modulus \[Pa\], Poisson's ratio and yield strength \[Pa\] of every row.
fn materials(input: &InputTable) -> Result<Vec<[f64; 3]>, Refusal> {
    let [modulus, ratio] = ELASTIC_COLUMNS;
    if !input.has(INDENTATION_HARDNESS) {
        return input.numbers([modulus, ratio, (YIELD_STRENGTH, STRENGTH)]);
    }
    let elastic = input.numbers([modulus, ratio])?.into_iter();
    let strengths_pa = yield_strengths_pa(input, STRENGTH)?;
    Ok(elastic
        .zip(strengths_pa)
        .map(|([modulus_pa, ratio], strength_pa)| [modulus_pa, ratio, strength_pa])
        .collect())
}

impl<const IN: usize, const OUT: usize> Columns<IN, OUT> {
    /// The material and the arguments of every row.
    fn read(&self, input: &InputTable) -> Result<Vec<Inputs<IN>>, Refusal> {
        Ok(materials(input)?.into_iter().zip(input.numbers(self.inputs)?).collect())
    }

    fn set_results(
        &self,
        input: &mut InputTable,
        counterface: Option<ElasticBody>,
    ) -> Result<usize, RowsError> {
        let rows = self.read(input)?;
        let mut results: [Vec<Option<f64>>; OUT] = std::array::from_fn(|_| Vec::with_capacity(rows.len()));
        let mut beyond = 0;
        for ([modulus_pa, poisson_ratio, strength_pa], arguments) in rows {
            let body = ElasticBody::new(modulus_pa, poisson_ratio)?;
            let pair = counterface
                .map_or(MaterialPair::against_rigid(body), |other| MaterialPair::against(body, other));
            let (values, in_range) = (self.law)(&pair, strength_pa, arguments);
            beyond += usize::from(!in_range);
            for (column, value) in results.iter_mut().zip(values) {
                column.push(Some(value));
            }
        }
        for (name, values) in self.results.into_iter().zip(results) {
            input.table.set(name, Cells::Numbers(values));
        }
        Ok(beyond)
    }
}
