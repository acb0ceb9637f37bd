//! Options of a layer on the rough body.

use clap::Args as ClapArgs;
use questions::LayerInput;
use study::layer_base::LayerBase;
use units::{Length, Modulus};

use super::parsers::{one_of, parse_poisson_ratio};

/// A layer bonded to the rough body.
#[derive(Debug, Clone, ClapArgs)]
#[command(next_help_heading = "Options for a layer on the rough body")]
pub(crate) struct LayerArgs {
    /// Thickness of an elastic layer bonded to the rough body, which carries the roughness; a hardness is then that of the layer
    #[arg(long, value_name = "L", allow_hyphen_values = true)]
    pub layer_thickness: Option<Length>,
    /// Young's modulus of the layer
    #[arg(long, value_name = "P", allow_hyphen_values = true)]
    pub layer_youngs_modulus: Option<Modulus>,
    /// Poisson's ratio of the layer, from 0 to 0.5
    #[arg(long, value_name = "NU", value_parser = parse_poisson_ratio, allow_hyphen_values = true)]
    pub layer_poisson_ratio: Option<f64>,
    /// Base of the layer: the material of the rough body (where not given), or rigid, which takes no material
    #[arg(long, value_parser = one_of::<LayerBase, _>(LayerBase::ALL))]
    pub layer_base: Option<LayerBase>,
}

impl LayerArgs {
    /// All options of a layer.
    pub const OPTIONS: [&str; 4] =
        ["layer_thickness", "layer_youngs_modulus", "layer_poisson_ratio", "layer_base"];

    /// The layer as questions take it, if any part of it is given.
    pub fn input(&self) -> Option<LayerInput> {
        let layer = LayerInput {
            thickness_m: self.layer_thickness.map(|thickness| thickness.m),
            youngs_modulus_pa: self.layer_youngs_modulus.map(|modulus| modulus.pa),
            poisson_ratio: self.layer_poisson_ratio,
            base: self.layer_base.unwrap_or_default(),
        };
        if self.layer_base.is_some() { Some(layer) } else { layer.given() }
    }
}
