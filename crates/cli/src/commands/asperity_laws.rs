//! `asperity`: the contact law of one asperity, row by row of a table.

use asperity::{Bound, ElasticBody, ElasticPlasticSinusoid, Hardness, Hertz, JacksonGreen, MaterialPair};

use super::Context;
use crate::args::AsperityLaw;
use crate::failure::Failure;
use crate::provenance::program;
use crate::table::{Cells, InputTable};

const MATERIAL_COLUMNS: [(&str, Bound); 3] = [
    ("youngs_modulus_pa", Bound::Positive),
    ("poisson_ratio", ElasticBody::POISSON_RATIO),
    ("yield_strength_pa", Bound::Positive),
];

/// A law as a table sees it: input columns after the material's, result columns, and what lies between.
struct Columns<const IN: usize, const OUT: usize> {
    inputs: [(&'static str, Bound); IN],
    results: [&'static str; OUT],
    law: fn(&MaterialPair, f64, [f64; IN]) -> [f64; OUT],
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
        [
            hertz.force_n(w_m),
            hertz.area_m2(w_m),
            published.force_n(w_m),
            published.area_m2(w_m),
            cosine.force_n(w_m),
        ]
    },
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
        [
            sinusoid.elastic().complete_contact_pressure_pa(),
            sinusoid.elastic().area_fraction(pressure_pa),
            sinusoid.critical_aspect_ratio(),
            sinusoid.complete_contact_pressure_pa(),
            sinusoid.area_fraction(pressure_pa),
            sinusoid.mean_gap_over_amplitude(pressure_pa),
        ]
    },
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
        [
            elastic_pa,
            sinusoid.elastic().area_fraction(elastic_pa),
            plastic_pa,
            sinusoid.area_fraction(plastic_pa),
        ]
    },
};

pub(super) fn run(law: &AsperityLaw, context: &Context<'_>) -> Result<(), Failure> {
    let input = match law {
        AsperityLaw::Sphere(args) | AsperityLaw::Sinusoid(args) | AsperityLaw::SinusoidInterference(args) => {
            InputTable::read(&args.input)?
        }
    };
    match law {
        AsperityLaw::Sphere(_) => extend(input, &SPHERE, context),
        AsperityLaw::Sinusoid(_) => extend(input, &SINUSOID, context),
        AsperityLaw::SinusoidInterference(_) => extend(input, &SINUSOID_INTERFERENCE, context),
    }
}

fn extend<const IN: usize, const OUT: usize>(
    mut input: InputTable,
    columns: &Columns<IN, OUT>,
    context: &Context<'_>,
) -> Result<(), Failure> {
    let materials = input.numbers(MATERIAL_COLUMNS)?;
    let arguments = input.numbers(columns.inputs)?;
    let counterface = context.counterface()?;
    let mut results: [Vec<Option<f64>>; OUT] = std::array::from_fn(|_| Vec::with_capacity(materials.len()));
    for ([modulus_pa, poisson_ratio, strength_pa], arguments) in materials.into_iter().zip(arguments) {
        let body = ElasticBody::new(modulus_pa, poisson_ratio).map_err(Failure::input)?;
        let pair =
            counterface.map_or(MaterialPair::against_rigid(body), |other| MaterialPair::against(body, other));
        for (column, value) in results.iter_mut().zip((columns.law)(&pair, strength_pa, arguments)) {
            column.push(Some(value));
        }
    }
    for (name, values) in columns.results.into_iter().zip(results) {
        input.table.set(name, Cells::Numbers(values));
    }
    let mut comments = vec![program(context.typed)];
    comments.extend(input.comments);
    context.write(&input.table, &comments)
}
