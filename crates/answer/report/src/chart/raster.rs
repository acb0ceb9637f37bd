//! Pictures of points: PNG, and their element in an SVG document.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;

use super::canvas::Rect;

/// The meaning of the bytes of a picture.
pub(crate) enum Pixels {
    /// Red, green and blue of each point.
    Colours,
    /// A grey of each point.
    Greys,
    /// An index of two bits for each point, four in a byte, a row in whole bytes.
    Indexed {
        /// Red, green and blue of each index.
        colours: Vec<u8>,
        /// The opacity of each index.
        opacities: Vec<u8>,
    },
}

/// Writes points row by row from the top as a PNG; `None` for more than it holds.
pub(crate) fn png([columns, rows]: [usize; 2], pixels: Pixels, bytes: &[u8]) -> Option<Vec<u8>> {
    let mut written = Vec::new();
    let [columns, rows] = [columns, rows].map(u32::try_from);
    let mut encoder = png::Encoder::new(&mut written, columns.ok()?, rows.ok()?);
    match pixels {
        Pixels::Colours => encoder.set_color(png::ColorType::Rgb),
        Pixels::Greys => encoder.set_color(png::ColorType::Grayscale),
        Pixels::Indexed { colours, opacities } => {
            encoder.set_color(png::ColorType::Indexed);
            encoder.set_depth(png::BitDepth::Two);
            encoder.set_palette(colours);
            encoder.set_trns(opacities);
        }
    }
    let mut writer = encoder.write_header().ok()?;
    writer.write_image_data(bytes).ok()?;
    writer.finish().ok()?;
    Some(written)
}

/// Makes the element of a PNG in a rectangle, with further attributes.
pub(crate) fn image(png: &[u8], Rect { left, top, right, bottom }: Rect, more: &str) -> String {
    let data = STANDARD.encode(png);
    format!(
        "<image x=\"{left}\" y=\"{top}\" width=\"{}\" height=\"{}\" preserveAspectRatio=\"none\"{more} href=\"data:image/png;base64,{data}\"/>",
        right - left,
        bottom - top
    )
}
