//! Sinusoids shared by the tests of several files.

use crate::{ElasticBody, ElasticPlasticSinusoid, MaterialPair};

/// Ultrananocrystalline diamond against a rigid flat.
pub(crate) fn pair() -> MaterialPair {
    MaterialPair::against_rigid(ElasticBody::new(463e9, 0.2).unwrap())
}

/// Sinusoid of that diamond with r times the critical aspect ratio.
pub(crate) fn at_ratio(r: f64) -> ElasticPlasticSinusoid {
    let critical = ElasticPlasticSinusoid::new(&pair(), 1.0, 1.8e9).critical_aspect_ratio();
    ElasticPlasticSinusoid::new(&pair(), r * critical, 1.8e9)
}
