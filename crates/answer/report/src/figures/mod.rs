//! Figures as data that only a report has, and additions of the report to the figures of a scene.

pub mod elements_figure;
pub(crate) mod interface_figure;
pub(crate) mod intervals;
pub(crate) mod judged;
