#![doc = include_str!("../README.md")]

mod adhesion;
mod adhesion_figure;
mod ball_figure;
mod choices;
mod conductance;
mod counts;
mod curve;
mod elements;
mod elements_law;
mod elements_law_question;
mod error;
#[cfg(feature = "transport")]
pub mod flow;
mod gap;
mod indenter;
mod layer;
mod loads;
mod lubrication;
mod map_question;
mod material;
mod note;
mod option;
mod report_question;
mod retune;
pub mod rows;
mod sampling;
mod scene_run;
mod spectrum;
#[cfg(feature = "transport")]
pub mod spots;
mod states;
mod tangential;
mod uncertain_areas;

pub use adhesion::{AdhesionQuestion, BranchChoice, PreparedAdhesion};
pub use conductance::{FoundConductance, LawAnswer, LawQuantity, LawTableQuestion, TransportInput};
pub use counts::{CurveCounts, CutCounts, LevelCounts};
pub use curve::{CurveQuestion, CurveStream, PreparedCurve};
pub use elements::{ElementsLoad, ElementsQuestion, Prepared, PreparedElements, RandomInput};
pub use elements_law::ElementsLaw;
pub use elements_law_question::{ElementsLawAnswer, ElementsLawQuestion};
pub use error::QuestionError;
pub use gap::{FoundLaw, GapModel, GapQuestion, LawForm, LawQuestion, remarks_on_gap_law};
pub use indenter::{IndenterQuestion, PreparedIndenter};
pub use layer::LayerInput;
pub use loads::LoadInput;
pub use lubrication::{FoundLubrication, LubricationQuestion, LubricationRange, SummitInput};
pub use map_question::{MapQuestion, relief, relief_of_map};
pub use material::{BodyInput, MaterialInput};
pub use note::{remark_on_sampling, remarks_on_separation};
pub use report_question::{BodyText, ReportQuestion, ReportSurface};
pub use retune::{ConditionError, retune};
pub use sampling::SamplingInput;
pub use scene_run::{Phase, RunError, RunOptions, SceneOutcome, Unwatched, Watch, run_scene};
pub use spectrum::{SpectrumQuantity, SpectrumQuestion};
pub use states::StatesQuestion;
pub use tangential::TangentialQuestion;
pub use uncertain_areas::{UncertainAreas, UncertaintyQuestion};

pub use interface::conductance::PlasticCorrelation;
pub use interface::gas::NamedGas;
pub use study::interface::GasInput;

use study::figure::FigureData;
use tables::Table;
use units::Remark;

/// The answer to a question: a table, notes and perhaps a figure.
#[derive(Debug)]
pub struct Answer {
    /// The table, as every front end writes it.
    pub table: Table,
    /// Notes for the reader of the table.
    pub notes: Vec<Remark>,
    /// The figure, if the question asks for one.
    pub figure: Option<FigureData>,
}
