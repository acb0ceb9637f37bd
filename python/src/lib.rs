//! The core of truearea for Python: arguments become the core's types, and its tables arrays. The Python
//! modules beside this crate document each call and its result.

mod answer;
mod arguments;
mod boundary_elements;
mod contact;
mod curves;
mod errors;
mod flow;
mod law;
mod material;
mod names;
mod picture;
mod scans;
mod scene;
mod surface;
mod threads;
mod uncertainty;
mod work;

/// The functions and types that the Python modules stand on.
#[pyo3::pymodule]
mod _native {
    #[pymodule_export]
    use super::{
        answer::PyAnswer,
        arguments::{in_metres, si_number, truth, without_unit},
        boundary_elements::{press_adhesive, press_ball, press_flat},
        contact::contact_states,
        curves::{curve, gaps, tangential},
        errors::InputError,
        flow::{flow_of_gap, flow_picture},
        law::PyFoundLaw,
        material::PyMaterial,
        names::{materials_table, models_table, pressure_in_words, way_out},
        picture::{axis_label, figure_svg, model_style, pressures_picture},
        scans::{PyScan, channels_of, composite, scans_of},
        scene::{PyScene, scene_template, scene_text, scene_with_keys, write_files},
        surface::PySurface,
        threads::{set_threads, threads},
        uncertainty::uncertainty_of,
    };

    /// The version of the program.
    #[pymodule_export]
    const VERSION: &str = env!("CARGO_PKG_VERSION");

    /// The files that describe the scans beside them.
    #[pymodule_export]
    const METADATA_FILES: [&str; 2] = measurements::METADATA_FILES;
}
