#![doc = include_str!("../README.md")]

mod all_parameters;
mod autocorrelation;
mod gaussian_filter;
mod heights;
mod material_ratio;
mod parameter;
mod relief;
mod scales;
mod slopes;

pub use all_parameters::parameters;
pub use autocorrelation::{Autocorrelation, AutocorrelationNormalisation, Reach};
pub use heights::{EvaluatedExtent, HeightParameters};
pub use material_ratio::{Core, MaterialRatioCurve};
pub use parameter::{Parameter, ParameterValue};
pub use relief::{Evaluation, FormRemoval, ScaleLimitedSurface, ScaleLimitedSurfaceError};
pub use scales::{GradientAndCurvature, ScaleParameters, scale_parameters};
pub use slopes::{Differences, Triangles, developed_area_excess, rms_gradient};
