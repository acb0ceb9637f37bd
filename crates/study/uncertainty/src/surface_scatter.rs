//! What of a scene's surface is drawn anew: scans, or standard errors, or either of two surfaces.

use spectrum::{ProfilePsd, superpose};
use study::surface::Surface;

use crate::group::Group;
use crate::random::Streams;
use crate::scan_scatter::ScanScatter;
use crate::spectrum_errors::ErrorsOfSpectrum;

/// A surface, to be drawn.
#[derive(Debug)]
pub(crate) enum SurfaceScatter {
    /// A spectrum of which nothing is known besides.
    Certain(ProfilePsd, String),
    /// A spectrum with standard errors.
    Errors(ErrorsOfSpectrum),
    /// The composite of scans.
    Scans(Box<ScanScatter>),
    /// The sum of two.
    Sum(Box<[SurfaceScatter; 2]>),
}

/// Which draw the random numbers of each group are those of.
#[derive(Debug, Clone, Copy)]
pub(crate) struct DrawOf {
    /// Of the scans.
    pub scans: u64,
    /// Of the instruments.
    pub instruments: u64,
    /// Of the elastic constants.
    pub material: u64,
    /// Of the strength.
    pub strength: u64,
}

impl DrawOf {
    /// Every group of one draw.
    pub fn all(draw: u64) -> Self {
        DrawOf { scans: draw, instruments: draw, material: draw, strength: draw }
    }

    /// The same but for one group, which is of another draw.
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
    pub fn of(surface: &Surface) -> Self {
        if let Some(parts) = &surface.parts {
            return SurfaceScatter::Sum(Box::new([Self::of(&parts[0]), Self::of(&parts[1])]));
        }
        match &surface.made_from {
            Some(scans) => SurfaceScatter::Scans(Box::new(ScanScatter::of(scans))),
            None => match ErrorsOfSpectrum::of(&surface.psd, &surface.name) {
                Some(errors) if surface.roughness.is_some() => {
                    SurfaceScatter::Errors(errors.of_assumptions())
                }
                Some(errors) => SurfaceScatter::Errors(errors),
                None => SurfaceScatter::Certain(surface.psd.clone(), surface.name.clone()),
            },
        }
    }

    /// The surfaces that it is the sum of, or itself.
    pub fn parts(&self) -> Vec<&SurfaceScatter> {
        match self {
            SurfaceScatter::Sum(parts) => parts.iter().flat_map(SurfaceScatter::parts).collect(),
            one => vec![one],
        }
    }

    /// Whether the group takes part in its draws.
    pub fn has(&self, group: Group) -> bool {
        let of_part = |part: &&SurfaceScatter| match (part, group) {
            (SurfaceScatter::Errors(_), Group::Scans) => true,
            (SurfaceScatter::Scans(scans), Group::Scans) => scans.scatters(),
            (SurfaceScatter::Scans(scans), Group::Instruments) => scans.has_gains(),
            _ => false,
        };
        self.parts().iter().any(of_part)
    }

    /// The spectrum of a draw; none where its values leave the range of what a spectrum may have. The second surface of a sum
    /// has random numbers of its own.
    pub fn psd(&self, streams: Streams, draw: DrawOf) -> Option<ProfilePsd> {
        self.psd_of(streams, draw, 0)
    }

    /// The spectrum of the best estimates: nothing deviates but by what overlaps tell of the gains.
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
