//! Pictures of pressures and gaps: a frame with its scale as SVG, and the colours of the points that belong into it.

use std::fmt::Write;

use crate::plot::{Panel, escaped};
use elements::ContactField;
use units::display::{length, pressure};

/// Width of the frame's longer side.
const FRAME_PX: f64 = 400.0;
const MARGIN_PX: f64 = 24.0;
const TITLE_PX: f64 = 30.0;
const SCALE_PX: f64 = 46.0;
const STEPS: usize = 64;

/// Nine colours of viridis from dark to light, evenly spaced to the eye (Smith & van der Walt 2015, matplotlib).
const COLOURS: [[u8; 3]; 9] = [
    [68, 1, 84],
    [71, 44, 122],
    [59, 81, 139],
    [44, 113, 142],
    [33, 144, 141],
    [39, 173, 129],
    [92, 200, 99],
    [170, 220, 50],
    [253, 231, 37],
];

/// A picture of a field in two parts: the colours of its points are drawn over its frame.
#[derive(Debug, Clone, PartialEq)]
pub struct FieldPicture {
    /// Title, frame and scale.
    pub svg: String,
    /// The rectangle of the points in the picture: left, top, width and height in px.
    pub place: [f64; 4],
    /// Points along x.
    pub columns: usize,
    /// The colour of each point, red, green and blue, row by row from the top.
    pub colours: Vec<[u8; 3]>,
}

/// The pressures, white where there is no contact.
#[must_use]
pub fn of_pressure(field: &ContactField<'_>) -> FieldPicture {
    let relief = field.relief;
    let size_m = [relief.length_x_m, relief.length_y_m];
    of_pressures(field.nominal_pressure_pa, field.pressures_pa, relief.columns, size_m)
}

/// Pressures \[Pa\] row by row on a rectangle of a size in m, white where there is no contact.
#[must_use]
pub fn of_pressures(
    nominal_pressure_pa: f64,
    pressures_pa: &[f64],
    columns: usize,
    size_m: [f64; 2],
) -> FieldPicture {
    let touches = 1e-10 * nominal_pressure_pa;
    let largest_pa = pressures_pa.iter().fold(0.0, |largest: f64, &value| largest.max(value));
    let title = format!("pressure at {}", pressure(nominal_pressure_pa));
    picture(&title, pressures_pa, touches, [largest_pa, size_m[0], size_m[1]], columns, &pressure(largest_pa))
}

/// The gaps, white in contact.
#[must_use]
pub fn of_gap(field: &ContactField<'_>) -> FieldPicture {
    let largest_m = field.gaps_m.iter().fold(0.0, |largest: f64, &value| largest.max(value));
    // In contact the gap is zero within the tolerance; the pressure tells which points those are.
    let touches = 1e-10 * field.nominal_pressure_pa;
    let open = field.gaps_m.iter().zip(field.pressures_pa);
    let open_m: Vec<f64> =
        open.map(|(gap_m, pressure_pa)| if *pressure_pa > touches { 0.0 } else { *gap_m }).collect();
    let title = format!("gap at {}", pressure(field.nominal_pressure_pa));
    let relief = field.relief;
    let scales = [largest_m, relief.length_x_m, relief.length_y_m];
    picture(&title, &open_m, 0.0, scales, relief.columns, &length(largest_m))
}

/// Colours values above `nothing` up to the largest one, which `most` names, on a rectangle of a size in m.
fn picture(
    title: &str,
    values: &[f64],
    nothing: f64,
    [largest, x_m, y_m]: [f64; 3],
    columns: usize,
    most: &str,
) -> FieldPicture {
    let colour_of = |value: f64| if value > nothing { colour(value / largest) } else { [255; 3] };
    let colours = values.iter().map(|value| colour_of(*value)).collect();
    FieldPicture::new(title, [x_m, y_m], ["0", most], columns, colours, None)
}

impl FieldPicture {
    /// Draws points in their colours on a rectangle of this size in m; `ends` labels the first and the last colour.
    /// Another panel may stand beside.
    pub(crate) fn new(
        title: &str,
        [x_m, y_m]: [f64; 2],
        ends: [&str; 2],
        columns: usize,
        colours: Vec<[u8; 3]>,
        beside: Option<&Panel>,
    ) -> Self {
        let scale = FRAME_PX / x_m.max(y_m);
        let place = [MARGIN_PX, MARGIN_PX + TITLE_PX, (x_m * scale).max(1.0), (y_m * scale).max(1.0)];
        let frame = frame(title, place, &length(x_m), ends);
        let panel = match beside {
            Some(other) => frame.beside(other),
            None => frame,
        };
        FieldPicture { svg: panel.document(), place, columns, colours }
    }
}

/// The colour of a share of the largest value.
#[must_use]
pub fn colour(share: f64) -> [u8; 3] {
    let last = COLOURS.len() - 1;
    let at = share.clamp(0.0, 1.0) * last as f64;
    let below = (at as usize).min(last - 1);
    let part = at - below as f64;
    std::array::from_fn(|i| {
        let [from, to] = [COLOURS[below][i], COLOURS[below + 1][i]].map(f64::from);
        (from + part * (to - from)).round() as u8
    })
}

fn frame(title: &str, [left, top, width, height]: [f64; 4], side: &str, [least, most]: [&str; 2]) -> Panel {
    let title = escaped(title);
    let size = [left + width.max(0.6 * FRAME_PX) + MARGIN_PX, top + height + SCALE_PX + MARGIN_PX];
    let mut elements = format!(
        "<text x=\"{left}\" y=\"{}\">{title}; {side} wide</text>\n\
         <rect x=\"{left}\" y=\"{top}\" width=\"{width}\" height=\"{height}\" fill=\"none\" stroke=\"black\"/>\n",
        top - 0.4 * TITLE_PX
    );
    let bar = top + height + 14.0;
    let step = 0.5 * FRAME_PX / STEPS as f64;
    for at in 0..STEPS {
        let [red, green, blue] = colour(at as f64 / (STEPS - 1) as f64);
        let x = left + at as f64 * step;
        let _ = writeln!(
            elements,
            "<rect x=\"{x}\" y=\"{bar}\" width=\"{}\" height=\"12\" fill=\"rgb({red},{green},{blue})\"/>",
            step + 0.3
        );
    }
    let under = bar + 27.0;
    let _ = writeln!(
        elements,
        "<text x=\"{left}\" y=\"{under}\">{least}</text>\n<text x=\"{}\" y=\"{under}\" text-anchor=\"end\">{most}</text>",
        left + 0.5 * FRAME_PX
    );
    Panel { size, elements }
}
