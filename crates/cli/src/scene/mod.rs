//! Scenes: a surface, a material, loads, and what to compute and draw of them.
//!
//! A scene file is read in two stages: [`raw`] is what may be typed, [`Scene`] what it means, in SI units and checked.

mod diagnostic;
mod raw;
mod resolve;
mod template;

pub use resolve::Overrides;
pub use template::Template;

use std::path::Path;

use asperity::Hardness;

use crate::failure::Failure;
use crate::figure::Figure;
use crate::material::Material;
use crate::plan::{Needs, Plan, Sampling};
use crate::surface::Surface;

/// A checked scene.
#[derive(Debug, Clone)]
pub struct Scene {
    /// What it is about.
    pub title: String,
    /// The surface and its spectrum.
    pub surface: Surface,
    /// The material; absent where no curve needs one.
    pub material: Option<Material>,
    /// Form of the hardness of elastic-plastic spheres.
    pub hardness: Hardness,
    /// Which scales take part.
    pub sampling: Sampling,
    /// What has to be computed for its curves and figures.
    pub needs: Needs,
    /// The figures to draw.
    pub figures: Vec<Figure>,
}

impl Scene {
    /// Reads a scene. `name` stands for it in messages, and paths in it are relative to `folder`.
    ///
    /// # Errors
    /// [`Failure::Input`] with file, line, key, value and bound.
    pub fn parse(text: &str, name: &str, folder: &Path, overrides: &Overrides) -> Result<Self, Failure> {
        let render = |error: diagnostic::SceneError| Failure::Input(error.render(text, name));
        let raw = raw::RawScene::parse(text).map_err(render)?;
        resolve::resolve(raw, folder, overrides).map_err(render)
    }

    /// A scene that comes with the program.
    ///
    /// # Errors
    /// None, unless the program was built with a broken scene.
    pub fn builtin(template: Template) -> Result<Self, Failure> {
        Self::parse(template.text(), template.name(), Path::new("."), &Overrides::default())
    }

    /// What carries the scene out.
    pub fn plan(&self) -> Plan<'_> {
        Plan { psd: &self.surface.psd, sampling: self.sampling, needs: self.needs.clone() }
    }
}
