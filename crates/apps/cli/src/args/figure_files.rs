//! Arguments of `figure`.

use std::path::PathBuf;

use clap::Args as ClapArgs;
use clap::builder::PossibleValuesParser;
use scene::FigureChoice;
use units::Length;

#[derive(Debug, ClapArgs)]
pub(crate) struct FigureFilesArgs {
    /// A folder that `report` made, or a scene file
    #[arg(value_name = "FOLDER|SCENE")]
    pub scene: PathBuf,
    /// Draw these figures only, by name
    #[arg(long, value_name = "NAMES", value_delimiter = ',')]
    pub only: Vec<String>,
    /// The formats of the files, py for a script that draws with matplotlib; else those of the scene
    #[arg(long, value_name = "FORMATS", value_delimiter = ',',
        value_parser = PossibleValuesParser::new(["svg", "png", "pdf", "py"]))]
    pub picture: Vec<String>,
    /// The width in print, such as 85mm
    #[arg(long, value_name = "L", allow_hyphen_values = true)]
    pub width: Option<Length>,
    /// The size of letters in print, in points; 8 if only the width is given
    #[arg(long, value_name = "POINTS")]
    pub font_size: Option<f64>,
    /// Draw neither title nor subject
    #[arg(long)]
    pub no_title: bool,
    /// Draw the curves of these models only
    #[arg(long, value_name = "MODELS", value_delimiter = ',')]
    pub models: Vec<String>,
    /// Draw these loads of the scene only
    #[arg(long, value_name = "PRESSURES", value_delimiter = ',')]
    pub loads: Vec<String>,
    /// Skip the boundary elements
    #[arg(long)]
    pub no_judge: bool,
    /// The folder for the files, made where absent
    #[arg(long, value_name = "DIR", default_value = ".")]
    pub out: PathBuf,
}

impl FigureFilesArgs {
    /// The choice among the figures of the scene, and their look.
    pub fn choice(&self) -> FigureChoice {
        FigureChoice {
            only: self.only.clone(),
            width: self.width,
            font_size_pt: self.font_size,
            hides_title: self.no_title,
            models: self.models.clone(),
            loads: self.loads.clone(),
        }
    }
}
