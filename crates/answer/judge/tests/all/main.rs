//! The judge: scenes of spectra, and measured maps.

mod judgement;
mod maps;
mod numbers;
mod pressed_surface;
mod scenes;
