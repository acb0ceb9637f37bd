//! The waves of a surface, and the pressure that flattens them on half-spaces or on a layer.

use asperity::LayerCompliance;
use spectrum::random_surfaces::{AreaSpectrum, RandomSurface, RandomSurfaceError, Synthesis};
use spectrum::{Moments, ProfilePsd};

/// Factor by which wavevectors are raised for the exponent of the stiffness.
const STEP: f64 = 1.01;

/// Returns the exponent n of the modulus E*(q) ~ q^n of a layer, averaged over the variance of the pressure of full contact on
/// a surface: -1 on a bed of springs. `None` for a spectrum that no surface has.
#[must_use]
pub fn exponent_of_stiffness(psd: &ProfilePsd, layer: &LayerCompliance) -> Option<f64> {
    Some(Waves::new(AreaSpectrum::from_profile(psd).ok()?, Some(layer)).exponent_of_stiffness())
}

/// The waves of a surface between bodies one of which may be a layer.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Waves {
    /// The spectrum of the surface itself.
    pub surface: AreaSpectrum,
    on_layer: Option<OnLayer>,
}

/// Surfaces that half-spaces of the modulus E* flatten by the same pressures as the layer does.
#[derive(Debug, Clone, PartialEq)]
struct OnLayer {
    /// Those with the stiffness of the layer.
    alike: AreaSpectrum,
    /// Those with the stiffness of the layer for slightly shorter waves.
    alike_of_shorter: AreaSpectrum,
}

impl Waves {
    /// Takes the waves of a surface. A wave on a layer takes the pressure (E*(q)/2) q h, with the layer's E*(q) in place of E*.
    pub fn new(surface: AreaSpectrum, layer: Option<&LayerCompliance>) -> Self {
        let on_layer = layer.map(|layer| {
            let stiffened = |raised: f64| surface.weighted(|q| layer.relative_at(raised * q).powi(-2));
            OnLayer { alike: stiffened(1.0), alike_of_shorter: stiffened(STEP) }
        });
        Waves { surface, on_layer }
    }

    /// Cuts the waves to a band \[m\].
    pub fn cut(&self, longest_m: f64, shortest_m: f64) -> Result<Self, RandomSurfaceError> {
        let cut = |spectrum: &AreaSpectrum| spectrum.cut(longest_m, shortest_m);
        let on_layer = |OnLayer { alike, alike_of_shorter }: &OnLayer| {
            Ok::<_, RandomSurfaceError>(OnLayer {
                alike: cut(alike)?,
                alike_of_shorter: cut(alike_of_shorter)?,
            })
        };
        Ok(Waves {
            surface: cut(&self.surface)?,
            on_layer: self.on_layer.as_ref().map(on_layer).transpose()?,
        })
    }

    /// The spectrum of the surface that half-spaces of the modulus E* flatten by the same pressures.
    pub fn flattened_alike(&self) -> &AreaSpectrum {
        self.on_layer.as_ref().map_or(&self.surface, |on_layer| &on_layer.alike)
    }

    /// The rms gradient of [`flattened_alike`](Self::flattened_alike): twice the rms pressure of full contact over E*. On
    /// half-spaces it is that of the surface.
    pub fn flattening_gradient(&self) -> f64 {
        self.flattened_alike().mean_square_gradient().sqrt()
    }

    /// Nayak's m0 m4/m2^2 of [`flattened_alike`](Self::flattened_alike).
    pub fn alpha(&self) -> f64 {
        let Moments { m0_m2, m2, m4_per_m2, .. } = self.flattened_alike().moments();
        m0_m2 * m4_per_m2 / (m2 * m2)
    }

    /// The flattening gradient over the gradient of the surface: 1 on half-spaces.
    pub fn stiffening(&self) -> f64 {
        match &self.on_layer {
            Some(OnLayer { alike, .. }) => {
                (alike.mean_square_gradient() / self.surface.mean_square_gradient()).sqrt()
            }
            None => 1.0,
        }
    }

    /// The exponent n of E*(q) ~ q^n, averaged over the variance of the pressure of full contact: 0 on half-spaces, -1 on a bed
    /// of springs, above 0 on a stiff coat.
    pub fn exponent_of_stiffness(&self) -> f64 {
        self.on_layer.as_ref().map_or(0.0, |OnLayer { alike, alike_of_shorter }| {
            let grown = alike_of_shorter.mean_square_gradient() / alike.mean_square_gradient();
            0.5 * grown.ln() / STEP.ln()
        })
    }

    /// Makes a surface of these waves, scaled so that it has their flattening gradient: the area depends on that first of all.
    pub fn realised(
        &self,
        synthesis: &Synthesis,
        realisation: u64,
    ) -> Result<RandomSurface, RandomSurfaceError> {
        let surface = self.surface.surface(synthesis, realisation)?;
        let mean_square = match &self.on_layer {
            // The same random numbers: the same waves, each with its stiffness.
            Some(OnLayer { alike, .. }) => alike.surface(synthesis, realisation)?.mean_square_gradient(),
            None => surface.mean_square_gradient(),
        };
        Ok(surface.scaled(self.flattening_gradient() / mean_square.sqrt()))
    }
}
