//! The uncertain inputs of a scene: surface and bodies.

use scene::{Scene, UncertaintySettings};
use spectrum::ProfilePsd;
use study::plan::Curve;

use crate::group::Group;
use crate::material_draws::{DrawnMaterial, MaterialDraws};
use crate::random::Streams;
use crate::surface_scatter::{DrawOf, SurfaceScatter};

/// The uncertain surface and bodies.
#[derive(Debug)]
pub(crate) struct Inputs {
    pub surface: SurfaceScatter,
    material: Option<MaterialDraws>,
    /// The random numbers.
    pub streams: Streams,
    /// The groups that scatter.
    pub groups: Vec<Group>,
}

/// The uncertain groups of inputs of a scene, whatever its settings for draws.
#[must_use]
pub fn scattering_groups(scene: &Scene) -> Vec<Group> {
    Inputs::from_scene(scene, UncertaintySettings::default().seed)
        .map_or_else(Vec::new, |inputs| inputs.groups)
}

impl Inputs {
    /// The inputs of a scene; `None` if none is uncertain.
    pub fn from_scene(scene: &Scene, seed: u64) -> Option<Self> {
        let surface = SurfaceScatter::from_surface(&scene.surface);
        let material = MaterialDraws::from_scene(scene);
        let of_material = |scatters: fn(&MaterialDraws) -> bool| material.as_ref().is_some_and(scatters);
        let scatters = |group: &Group| match group {
            Group::Scans | Group::Instruments | Group::Holes => surface.has(*group),
            Group::Material => of_material(MaterialDraws::elastic_scatters),
            Group::Strength => of_material(MaterialDraws::strength_scatters),
        };
        let groups: Vec<Group> = Group::ALL.iter().copied().filter(scatters).collect();
        let inputs = Inputs { surface, material, streams: Streams::new(seed), groups };
        (scene.scatters() && !inputs.groups.is_empty()).then_some(inputs)
    }

    /// True if the surface is uncertain.
    pub fn surface_scatters(&self) -> bool {
        self.groups.iter().any(|group| matches!(group, Group::Scans | Group::Instruments | Group::Holes))
    }

    /// The spectrum of a draw. `Some(None)` keeps the spectrum of a certain surface; `None` is a draw out of the range
    /// of spectra.
    pub fn psd(&self, draw: DrawOf) -> Option<Option<ProfilePsd>> {
        if !self.surface_scatters() {
            return Some(None);
        }
        self.surface.psd(self.streams, draw).map(Some)
    }

    /// The spectrum of the best estimates, in the form of [`psd`](Self::psd).
    pub fn best_psd(&self) -> Option<Option<ProfilePsd>> {
        if !self.surface_scatters() {
            return Some(None);
        }
        self.surface.best().map(Some)
    }

    /// The bodies of a draw; `None` if they are exact.
    pub fn material(&self, draw: DrawOf) -> Option<DrawnMaterial> {
        let mut elastic = self.streams.of(Group::Material, draw.material);
        let mut strength = self.streams.of(Group::Strength, draw.strength);
        Some(self.material.as_ref()?.draw(&mut elastic, &mut strength))
    }

    /// The curves with the bodies of a draw.
    pub fn curves(&self, curves: &[Curve], draw: DrawOf) -> Vec<Curve> {
        let Some(drawn) = self.material(draw) else { return curves.to_vec() };
        let moved = |curve: &Curve| Curve { model: drawn.apply(&curve.model), ..curve.clone() };
        curves.iter().map(moved).collect()
    }
}
