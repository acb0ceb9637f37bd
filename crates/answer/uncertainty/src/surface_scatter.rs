//! The uncertain surface of a scene: scans, standard errors and holes, of one surface or a sum of two.

use chacha20::ChaCha8Rng;
use spectrum::{ProfilePsd, superpose};
use study::surface::Surface;

use crate::group::Group;
use crate::hole_scatter::HoleScatter;
use crate::random::Streams;
use crate::scan_scatter::ScanScatter;
use crate::spectrum_errors::ErrorsOfSpectrum;

/// An uncertain surface: the sum of one or two parts.
#[derive(Debug)]
pub(crate) struct SurfaceScatter {
    parts: Vec<PartScatter>,
}

/// A surface measured by itself.
#[derive(Debug)]
struct PartScatter {
    source: SpectrumSource,
    holes: HoleScatter,
}

/// The source of a spectrum, with what it says about its own scatter.
#[derive(Debug)]
pub(crate) enum SpectrumSource {
    /// A spectrum without uncertainty.
    Certain(ProfilePsd, String),
    /// A spectrum with standard errors.
    Errors(ErrorsOfSpectrum),
    /// The composite of scans.
    Scans(Box<ScanScatter>),
}

/// The draw from which each group takes its random numbers.
#[derive(Debug, Clone, Copy)]
pub(crate) struct DrawOf {
    /// The draw of the scans.
    pub scans: u64,
    /// The draw of the instruments.
    pub instruments: u64,
    /// The draw of the elastic constants.
    pub material: u64,
    /// The draw of the strength.
    pub strength: u64,
    /// The draw of the holes of spectra.
    pub holes: u64,
}

impl DrawOf {
    /// All groups from one draw.
    pub fn all(draw: u64) -> Self {
        DrawOf { scans: draw, instruments: draw, material: draw, strength: draw, holes: draw }
    }

    /// Takes one group from another draw.
    pub fn with(mut self, group: Group, draw: u64) -> Self {
        *match group {
            Group::Scans => &mut self.scans,
            Group::Instruments => &mut self.instruments,
            Group::Material => &mut self.material,
            Group::Strength => &mut self.strength,
            Group::Holes => &mut self.holes,
        } = draw;
        self
    }
}

impl SurfaceScatter {
    pub fn from_surface(surface: &Surface) -> Self {
        SurfaceScatter { parts: surface.each().into_iter().map(PartScatter::from_surface).collect() }
    }

    /// The sources of all parts.
    pub fn sources(&self) -> impl Iterator<Item = &SpectrumSource> {
        self.parts.iter().map(|part| &part.source)
    }

    /// The source of a surface that is not a sum.
    pub fn single_source(&self) -> Option<&SpectrumSource> {
        match &self.parts[..] {
            [part] => Some(&part.source),
            _ => None,
        }
    }

    /// True if the group is uncertain for this surface.
    pub fn has(&self, group: Group) -> bool {
        self.parts.iter().any(|part| part.has(group))
    }

    /// The spectrum of a draw; `None` if its values leave the range of spectra. The second surface of a sum has random
    /// numbers of its own.
    pub fn psd(&self, streams: Streams, draw: DrawOf) -> Option<ProfilePsd> {
        self.sum(|part, surface| part.psd(|group, draw| streams.of_surface(group, draw, surface), draw))
    }

    /// The spectrum of the best estimates: no deviations but the mean gains after overlaps.
    pub fn best(&self) -> Option<ProfilePsd> {
        self.sum(|part, _| part.best())
    }

    fn sum(&self, psd: impl Fn(&PartScatter, u64) -> Option<ProfilePsd>) -> Option<ProfilePsd> {
        let mut parts = self.parts.iter().zip(0..).map(|(part, surface)| psd(part, surface));
        let first = parts.next()??;
        parts.try_fold(first, |sum, part| Some(superpose(&sum, &part?).psd))
    }
}

impl PartScatter {
    fn from_surface(surface: &Surface) -> Self {
        let source = match &surface.made_from {
            Some(scans) => SpectrumSource::Scans(Box::new(ScanScatter::from_scans(scans))),
            None => match ErrorsOfSpectrum::from_spectrum(&surface.psd, &surface.name) {
                Some(errors) if surface.roughness.is_some() => SpectrumSource::Errors(errors.assumed()),
                Some(errors) => SpectrumSource::Errors(errors),
                None => SpectrumSource::Certain(surface.psd.clone(), surface.name.clone()),
            },
        };
        PartScatter { source, holes: HoleScatter::from_spectrum(&surface.psd) }
    }

    fn has(&self, group: Group) -> bool {
        match (&self.source, group) {
            (SpectrumSource::Errors(_), Group::Scans) => true,
            (SpectrumSource::Scans(scans), Group::Scans) => scans.scatters(),
            (SpectrumSource::Scans(scans), Group::Instruments) => scans.has_gains(),
            (_, Group::Holes) => self.holes.scatters(),
            _ => false,
        }
    }

    fn psd(&self, numbers: impl Fn(Group, u64) -> ChaCha8Rng, draw: DrawOf) -> Option<ProfilePsd> {
        let measured = match &self.source {
            SpectrumSource::Certain(psd, _) => psd.clone(),
            SpectrumSource::Errors(errors) => {
                errors.psd(&errors.deviations(&mut numbers(Group::Scans, draw.scans)))?
            }
            SpectrumSource::Scans(scans) => {
                let places = scans.places(&mut numbers(Group::Scans, draw.scans));
                let gains = scans.gains(&mut numbers(Group::Instruments, draw.instruments));
                scans.psd(&scans.composed(&places, &gains))?
            }
        };
        self.holes.drawn(measured, &mut numbers(Group::Holes, draw.holes))
    }

    fn best(&self) -> Option<ProfilePsd> {
        let measured = match &self.source {
            SpectrumSource::Certain(psd, _) => psd.clone(),
            SpectrumSource::Errors(errors) => errors.centre().clone(),
            SpectrumSource::Scans(scans) => scans.psd(&scans.best())?,
        };
        self.holes.bridged(measured)
    }
}
