#![doc = include_str!("../README.md")]

mod adhesion;
mod adhesion_figure;
mod ball_figure;
mod choices;
mod conductance;
mod counts;
mod curve;
mod elements;
mod error;
mod gap;
mod indenter;
mod layer;
mod loads;
mod map_question;
mod material;
mod note;
mod note_facts;
mod option;
mod report_question;
mod retune;
pub mod rows;
mod sampling;
mod scene_run;
mod spectrum;
mod states;
mod tangential;
mod text;
mod uncertain_areas;

pub use adhesion::{AdhesionQuestion, BranchChoice, PreparedAdhesion};
pub use conductance::{FoundConductance, GasInput, LawAnswer, LawQuantity, LawTableQuestion, TransportInput};
pub use counts::{CurveCounts, CutCounts, LevelCounts};
pub use curve::{CurveQuestion, CurveStream, PreparedCurve};
pub use elements::{ElementsLoad, ElementsQuestion, PreparedElements, RandomInput};
pub use error::QuestionError;
pub use gap::{FoundLaw, GapModel, GapQuestion, LawForm, LawQuestion};
pub use indenter::{IndenterQuestion, PreparedIndenter};
pub use layer::LayerInput;
pub use loads::{LoadInput, RangeInput};
pub use map_question::MapQuestion;
pub use material::{BodyInput, MaterialInput};
pub use note::{AdhesionNote, FEW_TOUCH, GapCounts, MadeSurfaces, Note, OutsideFit, SampledScales};
pub use note_facts::{NoteLevel, NotePlace, note_code};
pub use option::{OptionName, Reason, Spelling, UnusedOption};
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

use study::figure::FigureData;
use tables::Table;

/// The answer to a question: a table, notes and perhaps a figure.
#[derive(Debug)]
pub struct Answer {
    /// The table, as every front end writes it.
    pub table: Table,
    /// Notes for the reader of the table.
    pub notes: Vec<Note>,
    /// The figure, if the question asks for one.
    pub figure: Option<FigureData>,
}
