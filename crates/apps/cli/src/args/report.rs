//! Arguments of `report`.

use std::path::PathBuf;

use clap::Args as ClapArgs;
use measurements::ScanRequest;
use questions::BodyText;

use super::groups::{CounterfaceSurfaceArgs, NamedMaterialArgs};
use super::scans::FileDefaults;

/// Scans or a spectrum, the bodies and the loads. Quantities are checked as a scene checks them, so that they may carry
/// uncertainties.
#[derive(Debug, ClapArgs)]
pub(crate) struct ReportArgs {
    /// Scans of one face in any format, or its power spectrum; a scan takes options of its own: FILE:unit=um,tip-radius=2um
    #[arg(required = true, value_name = "FILE")]
    pub files: Vec<ScanRequest>,
    #[command(flatten)]
    pub other: CounterfaceSurfaceArgs,
    #[command(flatten)]
    pub named: NamedMaterialArgs,
    /// Nominal pressure, as 10MPa or 1e-3H; repeatable
    #[arg(long, value_name = "P", allow_hyphen_values = true)]
    pub pressure: Vec<String>,
    /// Flatness of the nominal contact, as "5 um over 40 mm": height from valley to peak over its length; flat where not given
    #[arg(long, value_name = "H over L", allow_hyphen_values = true)]
    pub flatness: Option<String>,
    /// Ask from which pressure on the contact seals
    #[arg(long)]
    pub seal: bool,
    /// Open the report in the browser
    #[arg(long)]
    pub open: bool,
    /// The folder for the report, its scene, figures and data; else FILE-report in the current folder
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Print every note and number that the summary leaves out
    #[arg(short, long)]
    pub verbose: bool,
    /// Title of the report
    #[arg(long, value_name = "TEXT")]
    pub title: Option<String>,
    /// Young's modulus of the rough body, as 210GPa or '210 GPa +- 5 GPa'
    #[arg(long, value_name = "P", allow_hyphen_values = true)]
    pub youngs_modulus: Option<String>,
    /// Poisson's ratio of the rough body
    #[arg(long, value_name = "NU", allow_hyphen_values = true)]
    pub poisson_ratio: Option<String>,
    /// Yield strength of the rough body
    #[arg(long, value_name = "P", allow_hyphen_values = true)]
    pub yield_strength: Option<String>,
    /// Indentation hardness of the rough body, a pressure or 300HV, 200HBW, 60HRC
    #[arg(long, value_name = "P", allow_hyphen_values = true)]
    pub indentation_hardness: Option<String>,
    /// Let the strength grow where the deformation is shallower than this length (Nix & Gao)
    #[arg(long, value_name = "L", allow_hyphen_values = true)]
    pub strain_gradient_length: Option<String>,
    /// Upper limit of the depth-dependent yield strength
    #[arg(long, value_name = "P", allow_hyphen_values = true)]
    pub strength_cap: Option<String>,
    /// Young's modulus of the counterface
    #[arg(long, value_name = "P", allow_hyphen_values = true)]
    pub counterface_youngs_modulus: Option<String>,
    /// Poisson's ratio of the counterface
    #[arg(long, value_name = "NU", allow_hyphen_values = true)]
    pub counterface_poisson_ratio: Option<String>,
    #[command(flatten)]
    pub defaults: FileDefaults,
}

impl ReportArgs {
    /// The rough body.
    pub fn material(&self) -> BodyText {
        BodyText {
            name: self.named.material.as_ref().map(|material| material.name.clone()),
            youngs_modulus: self.youngs_modulus.clone(),
            poisson_ratio: self.poisson_ratio.clone(),
            yield_strength: self.yield_strength.clone(),
            indentation_hardness: self.indentation_hardness.clone(),
            strain_gradient_length: self.strain_gradient_length.clone(),
        }
    }

    /// The counterface.
    pub fn counterface(&self) -> BodyText {
        BodyText {
            name: self.named.on.as_ref().map(|material| material.name.clone()),
            youngs_modulus: self.counterface_youngs_modulus.clone(),
            poisson_ratio: self.counterface_poisson_ratio.clone(),
            ..BodyText::default()
        }
    }
}
