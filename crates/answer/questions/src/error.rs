//! Why a question has no answer.

use elements::{AdhesiveError, ElementsError, IndenterError};
use interface::conductance::PlasticCorrelation;
use interface::finite_elements::SamplingError;
use interface::tangential::ShearError;
use persson::hardness_laws::HardnessError;
use study::gap_law::GapError;
use study::interface::GasError;
use study::material::MaterialError;
use study::models::ModelEntry;
use study::plan::PlanError;
use units::{Remark, RemarkCode};

/// Why a question has no answer; a front end words it in its own spelling (`report::question_words::error`).
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum QuestionError {
    /// An option is given that changes nothing.
    #[error("{0:?} has no effect here")]
    Unused(Box<Remark>),
    /// None of some options is given, and one is needed.
    #[error("one of {0:?} is needed")]
    Missing(Vec<&'static str>),
    /// An elastic constant is missing.
    #[error("{0} is needed: every model is at least elastic")]
    ElasticConstant(&'static str),
    /// The material lacks something, or contradicts itself.
    #[error(transparent)]
    Material(#[from] MaterialError),
    /// A load that the material does not define, or out of bounds.
    #[error("{error}")]
    Load {
        /// The option that gives it.
        option: &'static str,
        /// The text it was typed in.
        label: Option<String>,
        /// The reason.
        error: MaterialError,
    },
    /// A cutoff below all data.
    #[error(
        "the cutoff {cutoff_m} m leaves nothing out: the shortest wavelength of {surface} is {shortest_m} m"
    )]
    CutoffBelowData {
        /// The cutoff \[m\].
        cutoff_m: f64,
        /// The shortest wavelength \[m\].
        shortest_m: f64,
        /// The name of the surface.
        surface: String,
    },
    /// A figure with more lines than a reader can distinguish.
    #[error("a figure with {lines} lines is unreadable; at most {most} are drawn")]
    TooManyLines {
        /// Kind of line and its conditions, e.g. `loop for each pressure and tangential stress`.
        drawn: &'static str,
        /// One line for each of these.
        lines: usize,
        /// The most that are drawn.
        most: usize,
    },
    /// A figure of loops under loads that all slide.
    #[error("every tangential stress reaches friction times pressure, and no loop can be drawn")]
    NoLoop,
    /// A correlation of conductances, which has no overclosure.
    #[error("{0} is a correlation of conductances and has no overclosure")]
    ConductanceOnly(PlasticCorrelation),
    /// A hardness that Persson's theory does not take.
    #[error(transparent)]
    Hardness(#[from] HardnessError),
    /// The computation failed or was cancelled.
    #[error(transparent)]
    Plan(#[from] PlanError),
    /// The model or the spectrum has no gaps.
    #[error(transparent)]
    Gap(#[from] GapError),
    /// The law cannot be sampled between its pressures.
    #[error(transparent)]
    Sampling(#[from] SamplingError<GapError>),
    /// The model has no exponential law of light loads.
    #[error("{0} has no exponential law of light loads")]
    NoExponentialLaw(&'static ModelEntry),
    /// Boundary elements failed or were cancelled.
    #[error(transparent)]
    Elements(#[from] ElementsError),
    /// An indenter cannot be pressed onto the surfaces.
    #[error(transparent)]
    Indenter(#[from] IndenterError),
    /// Adhesive surfaces cannot be pressed.
    #[error(transparent)]
    Adhesion(#[from] AdhesiveError),
    /// Random surfaces cannot be made of the spectrum.
    #[error("{surface}: {error}")]
    RandomSurfaces {
        /// The name of the surface.
        surface: String,
        /// The reason.
        error: spectrum::random_surfaces::RandomSurfaceError,
    },
    /// A saturation in units of a hardness that the material does not have.
    #[error("the saturation is given in H, and the material has no hardness")]
    SaturationWithoutHardness,
    /// The model yields, and only elastic contacts are sheared.
    #[error("{} yields, and only elastic contacts are sheared", .0.name)]
    NotElastic(&'static ModelEntry),
    /// The model has no stiffness under a pressure.
    #[error("there is no stiffness under {pressure_pa} Pa")]
    NoStiffness {
        /// The pressure \[Pa\].
        pressure_pa: f64,
    },
    /// The stiffness of the normal law falls with the pressure.
    #[error("the stiffness falls on the way to {pressure_pa} Pa")]
    FallingStiffness {
        /// The pressure \[Pa\].
        pressure_pa: f64,
    },
    /// No input of the uncertainty analysis is uncertain.
    #[error("nothing of the surface or the material is known to scatter")]
    NothingScatters,
    /// No draw has an area.
    #[error(
        "no model has an area at the shortest wavelength under any of the pressures, so that nothing can be drawn"
    )]
    NothingToDraw,
    /// A value out of bounds.
    #[error("{option}: {error}")]
    Value {
        /// The option that gives it.
        option: &'static str,
        /// The bound.
        error: units::OutOfBounds,
    },
    /// Any other reason, in its own words.
    #[error("{0}")]
    Other(String),
}

impl QuestionError {
    pub(crate) fn missing(option: &'static str) -> Self {
        QuestionError::Missing(vec![option])
    }

    /// Returns true if the user cancelled the work.
    #[must_use]
    pub fn is_cancelled(&self) -> bool {
        use elements::half_space::{AdhesionError, HalfSpaceError};
        matches!(
            self,
            QuestionError::Plan(PlanError::Cancelled)
                | QuestionError::Sampling(SamplingError::Source(GapError::Cancelled))
                | QuestionError::Elements(ElementsError::HalfSpace(HalfSpaceError::Cancelled))
                | QuestionError::Indenter(IndenterError::HalfSpace(HalfSpaceError::Cancelled))
                | QuestionError::Adhesion(AdhesiveError::Adhesion(AdhesionError::HalfSpace(
                    HalfSpaceError::Cancelled
                )))
        )
    }
}

impl From<GasError> for QuestionError {
    fn from(error: GasError) -> Self {
        match error {
            GasError::Beside(option, other) => {
                let remark = Remark::new(RemarkCode::Replaced).on(option);
                QuestionError::Unused(Box::new(remark.with("other", other)))
            }
            GasError::Needs(_, other) => QuestionError::missing(other),
            GasError::Value(option, error) => QuestionError::Value { option, error },
        }
    }
}

impl From<Box<Remark>> for QuestionError {
    fn from(unused: Box<Remark>) -> Self {
        QuestionError::Unused(unused)
    }
}

impl From<ShearError<QuestionError>> for QuestionError {
    fn from(error: ShearError<QuestionError>) -> Self {
        match error {
            ShearError::Stiffness(error) => error,
            ShearError::FallingStiffness { pressure_pa } => QuestionError::FallingStiffness { pressure_pa },
        }
    }
}
