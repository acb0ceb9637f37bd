//! Options of `law --quantity asperity-pressure`.

use clap::Args as ClapArgs;
use clap::builder::{PossibleValuesParser, TypedValueParser};
use questions::{
    LawQuantity, LawQuestion, LawTableQuestion, LubricationQuestion, LubricationRange, SummitInput,
};
use units::{Area, Length};

use super::LawArgs;
use crate::args::{CounterfaceSurfaceArgs, ReadingArgs};

/// Quantity of a table for finite elements, or the asperity pressure of mixed lubrication if there is none.
#[derive(Debug, Clone, Copy)]
pub(crate) struct LawQuantityArg(pub Option<LawQuantity>);

pub(super) fn law_quantity() -> impl TypedValueParser<Value = LawQuantityArg> {
    let names = LawQuantity::ALL.iter().map(|quantity| quantity.name());
    PossibleValuesParser::new(names.chain([LubricationQuestion::QUANTITY]))
        .map(|name| LawQuantityArg(name.parse().ok()))
}

/// Options of asperity pressures.
#[derive(Debug, ClapArgs)]
#[command(next_help_heading = "Options for --quantity asperity-pressure")]
pub(crate) struct LubricationArgs {
    /// The least and the largest separation of the mean planes over the rms height, in place of pressures
    #[arg(long, value_name = "FROM:TO", value_parser = parse_separations, conflicts_with = "pressure_range")]
    pub separation_range: Option<[f64; 2]>,
    /// Press the scanned map itself in place of random surfaces of its spectrum, with --model bem
    #[arg(long)]
    pub as_scanned: bool,
    /// Summits per area of each of two alike faces, in place of a surface and a model: Greenwood & Tripp's eta, as 1.25e9/m^2
    #[arg(long, value_name = "ETA", value_parser = parse_density, requires_all = ["summit_radius", "rms_height"], conflicts_with_all = ["psd", "model"], conflicts_with_all = ReadingArgs::OPTIONS, conflicts_with_all = CounterfaceSurfaceArgs::OPTIONS)]
    pub summit_density: Option<f64>,
    /// Radius of these summits, beta
    #[arg(long, value_name = "L", requires = "summit_density")]
    pub summit_radius: Option<Length>,
    /// Rms height of both faces together, sigma
    #[arg(long, value_name = "L", requires = "summit_density")]
    pub rms_height: Option<Length>,
}

impl LawArgs {
    /// The question of asperity pressures that these options ask.
    pub fn lubrication(&self) -> LubricationQuestion {
        let &LubricationArgs { separation_range, as_scanned, summit_density, summit_radius, rms_height } =
            &self.lubrication;
        let LawTableQuestion { law: LawQuestion { by, from, to }, .. } = self.question();
        let summits = summit_density.zip(summit_radius).zip(rms_height);
        LubricationQuestion {
            by,
            range: separation_range
                .map_or(LubricationRange::Pressures([from, to]), LubricationRange::Separations),
            random: self.random.input(),
            as_scanned,
            summits: summits.map(|((density_per_m2, radius), height)| SummitInput {
                density_per_m2,
                radius_m: radius.m,
                rms_height_m: height.m,
            }),
        }
    }

    /// Options that tables for finite elements ignore, and whether they are given.
    pub fn of_lubrication(&self) -> [(&'static str, bool); 3] {
        let LubricationArgs { separation_range, as_scanned, summit_density, .. } = &self.lubrication;
        [
            ("separation_range", separation_range.is_some()),
            ("as_scanned", *as_scanned),
            ("summit_density", summit_density.is_some()),
        ]
    }
}

fn parse_separations(text: &str) -> Result<[f64; 2], String> {
    let ends = text
        .split_once(':')
        .and_then(|(from, to)| Some([from.trim().parse().ok()?, to.trim().parse().ok()?]));
    ends.ok_or_else(|| {
        format!("'{text}' is not a range of separations over the rms height; write FROM:TO, as in 0.5:3")
    })
}

/// Parses a number per area.
fn parse_density(text: &str) -> Result<f64, String> {
    let parsed = text.split_once('/').and_then(|(number, area)| {
        let area: Area = format!("1 {}", area.trim()).parse().ok()?;
        let number = number.trim();
        let number: f64 = number.strip_suffix(" 1").unwrap_or(number).parse().ok()?;
        (number > 0.0).then_some(number / area.m2)
    });
    parsed.ok_or_else(|| {
        format!("'{text}' is not a number per area; write it as 1.25e9/m^2, or per mm^2 or um^2")
    })
}
