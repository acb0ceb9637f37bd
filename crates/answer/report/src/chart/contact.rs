//! The picture of a contact: spots that touch, over the relief of the surface.

use std::fmt::Write;

use judge::{PressedSurface, SeenContact};
use units::display::length;

use super::canvas::{Rect, escaped};
use super::palette::{CONTACT, relief_grey};
use super::raster::{Pixels, image, png};

/// The longer side of the picture.
const SIDE_PX: f64 = 208.0;
/// The most pixels along the longer side of the relief, and of the spots.
const RELIEF_POINTS: usize = 128;
const SPOT_POINTS: usize = 320;
/// The opacities of pixels without contact, with a part of it, and full of it. A spot smaller than a pixel is seen all the same.
const OPACITIES: [u8; 3] = [0, 170, 255];
/// The share of the heights beyond the greys at either end.
const BEYOND: f64 = 0.005;
/// Slopes of one standard deviation change the grey by this share of its range.
const SHADE: f64 = 0.2;
/// The longest scale bar over the width.
const LONGEST_BAR: f64 = 0.4;

/// Draws the relief of a surface once, and over it the spots of each contact in a group of the class that `class_of` gives its load.
/// `words` describe the picture to readers who cannot see it. `None` for a surface without points.
pub(crate) fn picture(
    surface: &PressedSurface,
    contacts: &[&SeenContact],
    class_of: impl Fn(usize) -> String,
    words: &str,
) -> Option<String> {
    let scale = SIDE_PX / surface.length_x_m.max(surface.length_y_m);
    let [width, height] = [surface.length_x_m, surface.length_y_m].map(|side_m| (side_m * scale).max(1.0));
    let place = || Rect { left: 0.0, top: 0.0, right: width, bottom: height };
    let mut drawn = image(&relief(surface)?, place(), "");
    for contact in contacts {
        let spots = spots(surface, contact)?;
        let _ = write!(drawn, "<g class=\"{}\">{}</g>", class_of(contact.load), image(&spots, place(), ""));
    }
    let bar_m = round_below(LONGEST_BAR * surface.length_x_m);
    let (bar, y) = (bar_m * scale, height - 8.0);
    Some(format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" aria-label=\"{}\" viewBox=\"0 0 {width:.1} {height:.1}\">{drawn}<g class=\"bar\">\
         <rect x=\"5\" y=\"{:.1}\" width=\"{:.1}\" height=\"21\" rx=\"3\"/><path d=\"M10 {y:.1}h{bar:.1}\"/><text x=\"10\" y=\"{:.1}\">{}</text></g></svg>",
        escaped(words),
        height - 26.0,
        (bar + 10.0).max(60.0),
        height - 12.0,
        escaped(&length(bar_m))
    ))
}

/// 1, 2 or 5 times a power of ten, at most a length.
fn round_below(length_m: f64) -> f64 {
    let decade = 10f64.powf(length_m.log10().floor());
    let steps = [5.0, 2.0, 1.0].map(|step| step * decade);
    // Rounding may leave the length a bit below its own power of ten.
    steps.into_iter().find(|step| *step <= length_m * (1.0 + 1e-9)).unwrap_or(0.5 * decade)
}

/// Values of a grid averaged over blocks, so that it has at most so many points along a side.
struct Blocks {
    columns: usize,
    values: Vec<f64>,
}

impl Blocks {
    fn new(points: usize, columns: usize, most: usize, value: impl Fn(usize) -> f64) -> Option<Self> {
        let rows = points.checked_div(columns)?;
        let step = columns.max(rows).div_ceil(most).max(1);
        let (across, down) = (columns.div_ceil(step), rows.div_ceil(step));
        let mean = |block: usize| {
            let (left, top) = (block % across * step, block / across * step);
            let (right, bottom) = ((left + step).min(columns), (top + step).min(rows));
            let sum: f64 =
                (top..bottom).flat_map(|y| (left..right).map(move |x| y * columns + x)).map(&value).sum();
            sum / ((right - left) * (bottom - top)) as f64
        };
        (points > 0).then(|| Blocks { columns: across, values: (0..across * down).map(mean).collect() })
    }

    fn png(&self, pixels: Pixels, bytes: &[u8]) -> Option<Vec<u8>> {
        png([self.columns, self.values.len() / self.columns], pixels, bytes)
    }
}

/// Greys of the heights, lit from the left.
fn relief(surface: &PressedSurface) -> Option<Vec<u8>> {
    let heights_m = &surface.heights_m;
    let blocks = Blocks::new(heights_m.len(), surface.columns, RELIEF_POINTS, |at| heights_m[at])?;
    let mut sorted = blocks.values.clone();
    sorted.sort_by(f64::total_cmp);
    let beyond = (BEYOND * (sorted.len() - 1) as f64) as usize;
    let (low_m, high_m) = (sorted[beyond], sorted[sorted.len() - 1 - beyond]);
    let range_m = (high_m - low_m).max(f64::MIN_POSITIVE);
    let rise_m = |at: usize| match at % blocks.columns {
        0 => 0.0,
        _ => blocks.values[at] - blocks.values[at - 1],
    };
    let squares: f64 = (0..blocks.values.len()).map(|at| rise_m(at).powi(2)).sum();
    let typical_m = (squares / blocks.values.len() as f64).sqrt().max(f64::MIN_POSITIVE);
    let grey = |at: usize| {
        relief_grey((blocks.values[at] - low_m) / range_m + SHADE * (rise_m(at) / typical_m).clamp(-2.0, 2.0))
    };
    let greys: Vec<u8> = (0..blocks.values.len()).map(grey).collect();
    blocks.png(Pixels::Greys, &greys)
}

/// Spots in the colour of contact, clear between them.
fn spots(surface: &PressedSurface, contact: &SeenContact) -> Option<Vec<u8>> {
    let touching = &contact.touching;
    let share = |at: usize| if touching[at] { 1.0 } else { 0.0 };
    let blocks = Blocks::new(touching.len(), surface.columns, SPOT_POINTS, share)?;
    let level = |share: &f64| u8::from(*share > 0.0) + u8::from(*share == 1.0);
    let pack = |row: &[f64]| -> Vec<u8> {
        let byte = |four: &[f64]| {
            four.iter().enumerate().fold(0, |byte, (at, share)| byte | (level(share) << (6 - 2 * at)))
        };
        row.chunks(4).map(byte).collect()
    };
    let bytes: Vec<u8> = blocks.values.chunks(blocks.columns).flat_map(pack).collect();
    let colours = CONTACT.repeat(OPACITIES.len());
    blocks.png(Pixels::Indexed { colours, opacities: OPACITIES.to_vec() }, &bytes)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn scale_bars_are_round_and_at_most_as_long_as_asked() {
        for (length_m, expected_m) in
            [(1e-6, 1e-6), (1.9e-6, 1e-6), (2.1e-6, 2e-6), (9.9e-4, 5e-4), (3e-9, 2e-9)]
        {
            assert!((round_below(length_m) / expected_m - 1.0).abs() < 1e-9, "{length_m}");
        }
    }

    #[test]
    fn spots_of_a_picture_are_those_of_the_contact() {
        let columns = 6;
        let touching: Vec<bool> = (0..24).map(|at| at % 7 == 0).collect();
        let surface = PressedSurface {
            map: None,
            heights_m: vec![0.0; 24],
            columns,
            length_x_m: 6e-6,
            length_y_m: 4e-6,
            shortest_m: None,
            contacts: Vec::new(),
        };
        let contact = SeenContact { load: 0, touching: touching.clone() };
        let pixels = decoded(&spots(&surface, &contact).unwrap());
        let seen: Vec<bool> = pixels.chunks(4).map(|rgba| rgba[3] == 255).collect();
        assert_eq!(seen, touching);
        let svg = picture(&surface, &[&contact], |load| format!("l{load}"), "a \"map\"").unwrap();
        assert!(
            svg.contains("class=\"l0\"")
                && svg.contains("viewBox=\"0 0 208.0 138.7\"")
                && svg.contains(">2 µm<")
        );
        assert_eq!(svg.matches("<image x=\"0\" y=\"0\" width=\"208\" height=\"138.6").count(), 2);
    }

    /// The bytes of a PNG, colours of a palette with their opacity.
    fn decoded(png: &[u8]) -> Vec<u8> {
        let mut decoder = png::Decoder::new(png);
        decoder.set_transformations(png::Transformations::EXPAND);
        let mut reader = decoder.read_info().unwrap();
        let mut pixels = vec![0; reader.output_buffer_size()];
        reader.next_frame(&mut pixels).unwrap();
        pixels
    }

    #[test]
    fn reliefs_grow_lighter_with_height_and_on_slopes_that_rise_from_the_left() {
        let greys = |height_m: fn(usize, usize) -> f64| {
            let surface = PressedSurface {
                map: None,
                heights_m: (0..100).map(|at| height_m(at % 10, at / 10)).collect(),
                columns: 10,
                length_x_m: 1e-6,
                length_y_m: 1e-6,
                shortest_m: None,
                contacts: Vec::new(),
            };
            decoded(&relief(&surface).unwrap())
        };
        // Steps along y have no slope along x: nine greys between the ends of the palette, evenly.
        let steps = greys(|_, y| 3e-9 * y as f64 - 5e-9);
        let column: Vec<u8> = steps.iter().copied().step_by(10).collect();
        assert_eq!(column, (0..10).map(|step| relief_grey(f64::from(step) / 9.0)).collect::<Vec<u8>>());
        assert_eq!([0.0, 0.5, 1.0, 2.0].map(relief_grey), [120, 183, 245, 245]);
        assert!(steps.chunks(10).all(|row| row.iter().all(|grey| *grey == row[0])));
        // Of a zigzag about one height, what rises is lighter than flat ground and what falls darker, by a fifth of the palette.
        let zigzag = greys(|x, y| {
            if y == 0 {
                -10e-9
            } else if y == 9 {
                10e-9
            } else {
                [0.0, 1e-9][x % 2]
            }
        });
        let row = &zigzag[50..60];
        let typical = (8.0 * 9.0 / 100.0f64).sqrt();
        for (at, share) in [(0, 0.5), (1, 0.55 + SHADE / typical), (2, 0.5 - SHADE / typical)] {
            assert_eq!(row[at], relief_grey(share), "{at}");
        }
    }

    #[test]
    fn blocks_average_points_and_the_last_ones_are_smaller() {
        let blocks = Blocks::new(15, 5, 3, |at| at as f64).unwrap();
        assert_eq!((blocks.columns, blocks.values), (3, vec![3.0, 5.0, 6.5, 10.5, 12.5, 14.0]));
        assert!(Blocks::new(0, 0, 3, |_| 0.0).is_none());
    }
}
