//! Draws of a composite without contact: the effect of each instrument's scans and height scale on ln A for small
//! deviations.

use crate::gains::Gains;
use crate::group::Group;
use crate::influence::Influence;
use crate::inputs::Inputs;
use crate::random::Streams;
use crate::scan_scatter::ScanScatter;
use crate::surface_scatter::SpectrumSource;

/// The number of such draws.
pub(crate) const LIGHT_DRAWS: usize = 1000;

/// The deviations of ln C of each instrument in one draw, in parts of the spectrum.
pub(crate) struct LightDraw {
    /// For every instrument, from its scans.
    places: Vec<Vec<f64>>,
    /// For every instrument, from its gain.
    gains: Vec<Vec<f64>>,
    /// For every instrument, from all gains if its own is known.
    gains_without: Vec<Vec<f64>>,
}

/// The effects of such draws on ln A.
pub(crate) struct Contributions {
    /// For every instrument, from its scans.
    pub places: Vec<Vec<f64>>,
    /// For every instrument, from its gain.
    pub gains: Vec<Vec<f64>>,
    /// For every instrument, from all gains if its own is known.
    pub gains_without: Vec<Vec<f64>>,
    /// For every draw, the total in each part of the spectrum.
    pub parts: Vec<Vec<f64>>,
}

impl LightDraw {
    /// Draws an uncertain surface.
    pub fn all(inputs: &Inputs, influence: &Influence) -> Vec<LightDraw> {
        let streams = inputs.streams;
        let draws = 0..LIGHT_DRAWS as u64;
        match inputs.surface.single_source() {
            Some(SpectrumSource::Scans(scans)) => {
                let without = scans.gains_without_each();
                draws.map(|draw| LightDraw::from_scans(scans, &without, streams, draw, influence)).collect()
            }
            Some(SpectrumSource::Errors(errors)) => {
                let deviations = |draw| errors.deviations(&mut streams.of(Group::Scans, draw));
                let light = |draw| LightDraw {
                    places: vec![influence.in_parts(&deviations(draw))],
                    gains: Vec::new(),
                    gains_without: Vec::new(),
                };
                draws.map(light).collect()
            }
            Some(SpectrumSource::Certain(..)) | None => Vec::new(),
        }
    }

    fn from_scans(
        scans: &ScanScatter,
        without: &[Gains],
        streams: Streams,
        draw: u64,
        influence: &Influence,
    ) -> LightDraw {
        let in_parts = |deviations: Vec<Vec<f64>>| -> Vec<Vec<f64>> {
            let weighted = |(instrument, deviations): (usize, &Vec<f64>)| {
                let weights = scans.weights(instrument);
                let of_composite: Vec<f64> =
                    deviations.iter().zip(weights).map(|(off, weight)| off * weight).collect();
                influence.in_parts(&of_composite)
            };
            deviations.iter().enumerate().map(weighted).collect()
        };
        let of_gains =
            |gains: &Gains| in_parts(scans.of_gains(&gains.draw(&mut streams.of(Group::Instruments, draw))));
        let sum = |parts: Vec<Vec<f64>>| parts.into_iter().reduce(added).unwrap_or_default();
        LightDraw {
            places: in_parts(scans.places(&mut streams.of(Group::Scans, draw))),
            gains: in_parts(scans.gains(&mut streams.of(Group::Instruments, draw))),
            gains_without: without.iter().map(|gains| sum(of_gains(gains))).collect(),
        }
    }
}

impl Contributions {
    /// The effects of draws on ln A of an area.
    pub fn new(area: usize, influence: &Influence, draws: &[LightDraw]) -> Self {
        let total = |in_parts: &Vec<f64>| influence.on(area, in_parts).iter().sum::<f64>();
        let by_instrument = |of: fn(&LightDraw) -> &Vec<Vec<f64>>| -> Vec<Vec<f64>> {
            let count = draws.first().map_or(0, |draw| of(draw).len());
            (0..count).map(|at| draws.iter().map(|draw| total(&of(draw)[at])).collect()).collect()
        };
        let parts = |draw: &LightDraw| {
            let all = draw.places.iter().chain(&draw.gains).cloned().reduce(added).unwrap_or_default();
            influence.on(area, &all)
        };
        Contributions {
            places: by_instrument(|draw| &draw.places),
            gains: by_instrument(|draw| &draw.gains),
            gains_without: by_instrument(|draw| &draw.gains_without),
            parts: draws.iter().map(parts).collect(),
        }
    }
}

fn added(mut a: Vec<f64>, b: Vec<f64>) -> Vec<f64> {
    a.iter_mut().zip(b).for_each(|(a, b)| *a += b);
    a
}
