//! The uncertain surface of a scene: scans, standard errors, or a sum of two surfaces.

use spectrum::{ProfilePsd, superpose};
use study::surface::Surface;

use crate::group::Group;
use crate::random::Streams;
use crate::scan_scatter::ScanScatter;
use crate::spectrum_errors::ErrorsOfSpectrum;

/// An uncertain surface.
#[derive(Debug)]
pub(crate) enum SurfaceScatter {
    /// A spectrum without uncertainty.
    Certain(ProfilePsd, String),
    /// A spectrum with standard errors.
    Errors(ErrorsOfSpectrum),
    /// The composite of scans.
    Scans(Box<ScanScatter>),
    /// The sum of two.
    Sum(Box<[SurfaceScatter; 2]>),
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
}

impl DrawOf {
    /// All groups from one draw.
    pub fn all(draw: u64) -> Self {
        DrawOf { scans: draw, instruments: draw, material: draw, strength: draw }
    }

    /// Takes one group from another draw.
    pub fn with(mut self, group: Group, draw: u64) -> Self {
        *match group {
            Group::Scans => &mut self.scans,
            Group::Instruments => &mut self.instruments,
            Group::Material => &mut self.material,
            Group::Strength => &mut self.strength,
        } = draw;
        self
    }
}

impl SurfaceScatter {
    pub fn from_surface(surface: &Surface) -> Self {
        if let Some(parts) = &surface.parts {
            return SurfaceScatter::Sum(Box::new([
                Self::from_surface(&parts[0]),
                Self::from_surface(&parts[1]),
            ]));
        }
        match &surface.made_from {
            Some(scans) => SurfaceScatter::Scans(Box::new(ScanScatter::from_scans(scans))),
            None => match ErrorsOfSpectrum::from_spectrum(&surface.psd, &surface.name) {
                Some(errors) if surface.roughness.is_some() => SurfaceScatter::Errors(errors.assumed()),
                Some(errors) => SurfaceScatter::Errors(errors),
                None => SurfaceScatter::Certain(surface.psd.clone(), surface.name.clone()),
            },
        }
    }

    /// The surfaces of the sum, or the surface itself.
    pub fn parts(&self) -> Vec<&SurfaceScatter> {
        match self {
            SurfaceScatter::Sum(parts) => parts.iter().flat_map(SurfaceScatter::parts).collect(),
            one => vec![one],
        }
    }

    /// True if the group is uncertain for this surface.
    pub fn has(&self, group: Group) -> bool {
        let of_part = |part: &&SurfaceScatter| match (part, group) {
            (SurfaceScatter::Errors(_), Group::Scans) => true,
            (SurfaceScatter::Scans(scans), Group::Scans) => scans.scatters(),
            (SurfaceScatter::Scans(scans), Group::Instruments) => scans.has_gains(),
            _ => false,
        };
        self.parts().iter().any(of_part)
    }

    /// The spectrum of a draw; `None` if its values leave the range of spectra. The second surface of a sum has random
    /// numbers of its own.
    pub fn psd(&self, streams: Streams, draw: DrawOf) -> Option<ProfilePsd> {
        self.psd_of(streams, draw, 0)
    }

    /// The spectrum of the best estimates: no deviations but the mean gains after overlaps.
    pub fn best(&self) -> Option<ProfilePsd> {
        match self {
            SurfaceScatter::Certain(psd, _) => Some(psd.clone()),
            SurfaceScatter::Errors(errors) => Some(errors.centre().clone()),
            SurfaceScatter::Scans(scans) => scans.psd(&scans.best()),
            SurfaceScatter::Sum(parts) => Some(superpose(&parts[0].best()?, &parts[1].best()?).psd),
        }
    }

    fn psd_of(&self, streams: Streams, draw: DrawOf, surface: u64) -> Option<ProfilePsd> {
        let numbers = |group, draw| streams.of_surface(group, draw, surface);
        match self {
            SurfaceScatter::Certain(psd, _) => Some(psd.clone()),
            SurfaceScatter::Errors(errors) => {
                errors.psd(&errors.deviations(&mut numbers(Group::Scans, draw.scans)))
            }
            SurfaceScatter::Scans(scans) => {
                let places = scans.places(&mut numbers(Group::Scans, draw.scans));
                let gains = scans.gains(&mut numbers(Group::Instruments, draw.instruments));
                scans.psd(&scans.composed(&places, &gains))
            }
            SurfaceScatter::Sum(parts) => {
                let [first, second] = &**parts;
                let first = first.psd_of(streams, draw, surface)?;
                let second = second.psd_of(streams, draw, surface + 1)?;
                Some(superpose(&first, &second).psd)
            }
        }
    }
}
