//! Properties of the two bodies of a scene besides their elastic constants: conductivities and resistivities, sources
//! of values in the table of materials, and the body that yields.

use asperity::{ElasticBody, MaterialPair};
use units::display::pressure;
use units::{Remark, RemarkCode};

use crate::body_properties::BodyProperty;
use crate::hardness_and_strength::{HARDNESS_OVER_STRENGTH, HardnessAndStrength};
use crate::material_spreads::MaterialSpreads;

/// One of the two bodies in contact.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Body {
    /// The rough body, \[material\] of a scene.
    Rough,
    /// The body that presses on the rough one, \[counterface\] of a scene.
    Counterface,
}

impl Body {
    /// Its name in sentences.
    #[must_use]
    pub fn words(self) -> &'static str {
        match self {
            Body::Rough => "the rough body",
            Body::Counterface => "the counterface",
        }
    }

    /// The rough body against its counterface, rigid where absent, with this one as the body that yields.
    #[must_use]
    pub fn pair(self, rough: ElasticBody, counterface: Option<ElasticBody>) -> MaterialPair {
        match (counterface, self) {
            (None, _) => MaterialPair::against_rigid(rough),
            (Some(counterface), Body::Rough) => MaterialPair::against(rough, counterface),
            (Some(counterface), Body::Counterface) => MaterialPair::against_yielding(rough, counterface),
        }
    }
}

/// Thermal and electrical transport properties of a body; no law of contact needs them.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Transport {
    /// Its thermal conductivity \[W/(m K)\], if given.
    pub thermal_conductivity_w_per_m_k: Option<f64>,
    /// Its electrical resistivity \[ohm m\], if given.
    pub resistivity_ohm_m: Option<f64>,
}

/// Values that a scene took from the table of materials, since it named one.
#[derive(Debug, Clone, PartialEq)]
pub struct FromTable {
    /// The name in the table.
    pub name: String,
    /// The missing properties that were filled, in the order of their keys in a scene.
    pub properties: Vec<BodyProperty>,
    /// Sources of the values in the table.
    pub sources: String,
}

/// The body that yields, if the counterface has a strength: the one with the smaller C S_y, C = 1.295 exp(0.736 nu)
/// (Jackson & Green 2005).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Softer {
    /// The one whose yield strength and hardness the models take.
    pub flows: Body,
    /// Its yield strength \[Pa\], a third of its hardness where that was given.
    pub yield_strength_pa: f64,
    /// Yield strength of the other body \[Pa\]; absent if none was given, and the body is then taken not to yield.
    pub other_pa: Option<f64>,
}

impl Softer {
    /// Decides which body yields, by the medians; `None` if the counterface has no strength. If both are equal, the
    /// rough body yields.
    #[must_use]
    pub fn between(
        (rough, rough_body): (&HardnessAndStrength, ElasticBody),
        (counterface, counterface_body): (&HardnessAndStrength, ElasticBody),
    ) -> Option<Self> {
        let counterface_pa = counterface.yield_strength_pa()?;
        let first_yield_pa =
            |body: ElasticBody, strength_pa| body.spherical_yield_coefficient() * strength_pa;
        let rough_yields = |rough_pa| {
            first_yield_pa(counterface_body, counterface_pa) >= first_yield_pa(rough_body, rough_pa)
        };
        match rough.yield_strength_pa() {
            // A strength in units of the hardness is refused where a model asks for it.
            None if rough.strength_is_in_hardnesses() => None,
            Some(rough_pa) if rough_yields(rough_pa) => Some(Softer {
                flows: Body::Rough,
                yield_strength_pa: rough_pa,
                other_pa: Some(counterface_pa),
            }),
            other_pa => {
                Some(Softer { flows: Body::Counterface, yield_strength_pa: counterface_pa, other_pa })
            }
        }
    }
}

/// Properties of both bodies besides their elastic constants.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Bodies {
    /// Transport properties of the rough body.
    pub transport: Transport,
    /// Transport properties of the counterface.
    pub counterface_transport: Transport,
    /// Values of the rough body filled from the table of materials.
    pub from_table: Option<FromTable>,
    /// Values of the counterface filled from the table of materials.
    pub counterface_from_table: Option<FromTable>,
}

impl Bodies {
    /// Returns a line for each fact that a scene does not state itself: values from the table, and the body that
    /// yields.
    #[must_use]
    pub fn describe(&self, softer: Option<Softer>, spreads: &MaterialSpreads) -> Vec<String> {
        let filled = [(Body::Rough, &self.from_table), (Body::Counterface, &self.counterface_from_table)];
        let mut lines: Vec<String> = filled
            .into_iter()
            .filter_map(|(body, from_table)| from_table.as_ref().and_then(|from_table| from_table.line(body)))
            .collect();
        lines.extend(softer.map(|softer| softer.line(spreads.strength.is_some())));
        lines
    }
}

impl FromTable {
    /// Returns true if the yield strength or the hardness is of the table.
    #[must_use]
    pub fn gives_strength(&self) -> bool {
        BodyProperty::STRENGTHS.iter().any(|strength| self.properties.contains(strength))
    }

    /// Describes the values that were filled; `None` if all were given.
    fn line(&self, body: Body) -> Option<String> {
        let (name, sources) = (&self.name, &self.sources);
        let filled = (!self.properties.is_empty()).then(|| {
            let keys: Vec<&str> = self.properties.iter().map(|property| property.key()).collect();
            keys.join(", ")
        })?;
        Some(format!("{} is {name}: {filled} from the table of materials ({sources})", body.words()))
    }
}

impl Softer {
    /// The note on whose hardness is used, if the other body has another one.
    #[must_use]
    pub fn remark(&self) -> Option<Remark> {
        let is_tie = self.other_pa == Some(self.yield_strength_pa);
        (!is_tie).then(|| Remark::new(RemarkCode::BodyThatFlows).with("flows", self.line(false)))
    }

    fn line(&self, is_uncertain: bool) -> String {
        let Softer { flows, yield_strength_pa, other_pa } = *self;
        let other = match flows {
            Body::Rough => Body::Counterface,
            Body::Counterface => Body::Rough,
        };
        let (flows, other) = (flows.words(), other.words());
        let hardness = |strength_pa: f64| pressure(HARDNESS_OVER_STRENGTH * strength_pa);
        let decided = if is_uncertain { "; medians decide, in every draw" } else { "" };
        match other_pa {
            Some(other_pa) if other_pa == yield_strength_pa => {
                format!("both bodies have a hardness of {}, and {flows} flows{decided}", hardness(other_pa))
            }
            Some(other_pa) if other_pa < yield_strength_pa => format!(
                "{flows} flows: its hardness is {}, that of {other} {}, but Poisson's ratio lets {flows} yield at the lower contact \
                 pressure{decided}",
                hardness(yield_strength_pa),
                hardness(other_pa)
            ),
            Some(other_pa) => format!(
                "{flows} flows, which is the softer: its hardness is {}, that of {other} {}{decided}",
                hardness(yield_strength_pa),
                hardness(other_pa)
            ),
            None => format!(
                "{flows} flows, at a hardness of {}: {other} was given no strength and is taken not to yield",
                hardness(yield_strength_pa)
            ),
        }
    }
}
