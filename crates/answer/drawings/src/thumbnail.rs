//! Small pictures of scans, as SVG within a page: maps in colours, profiles as lines.

use std::fmt::Write;

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use scans::ScanFile;

use crate::field_picture::FieldPicture;
use crate::heights_picture::map;
use crate::plot::escaped;

/// The longer side of a map, and the width and height of a profile, in px.
const MAP_PX: f64 = 160.0;
const PROFILE_PX: [f64; 2] = [320.0, 90.0];

/// Draws a scan; `None` if no point has a height. `words` describe it to readers who cannot see it.
#[must_use]
pub fn of_scan(file: &ScanFile, words: &str) -> Option<String> {
    let ([width, height], content) = match file.scan.points() {
        (columns, Some(rows)) => of_map(&map(&file.name, file, columns, rows, None)?)?,
        (_, None) => (PROFILE_PX, of_profile(file)?),
    };
    let words = escaped(words);
    Some(format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" aria-label=\"{words}\" viewBox=\"0 0 {width:.0} {height:.0}\" \
         width=\"{width:.0}\" height=\"{height:.0}\">{content}</svg>"
    ))
}

/// The size and the element of a map.
fn of_map(picture: &FieldPicture) -> Option<([f64; 2], String)> {
    let [_, _, x, y] = picture.place;
    let scale = MAP_PX / x.max(y);
    let [width, height] = [x * scale, y * scale];
    let data = STANDARD.encode(png_bytes(picture)?);
    let element = format!(
        "<image width=\"{width:.0}\" height=\"{height:.0}\" preserveAspectRatio=\"none\" href=\"data:image/png;base64,{data}\"/>"
    );
    Some(([width, height], element))
}

fn png_bytes(picture: &FieldPicture) -> Option<Vec<u8>> {
    let mut bytes = Vec::new();
    let rows = picture.colours.len() / picture.columns;
    let mut encoder =
        png::Encoder::new(&mut bytes, u32::try_from(picture.columns).ok()?, u32::try_from(rows).ok()?);
    encoder.set_color(png::ColorType::Rgb);
    let mut writer = encoder.write_header().ok()?;
    writer.write_image_data(picture.colours.as_flattened()).ok()?;
    writer.finish().ok()?;
    Some(bytes)
}

/// The path of a profile, interrupted where points are missing.
fn of_profile(file: &ScanFile) -> Option<String> {
    let scan = &file.scan;
    let heights = || scan.heights_m().flatten();
    let (lowest_m, highest_m) = (heights().reduce(f64::min)?, heights().reduce(f64::max)?);
    let (points, _) = scan.points();
    let share = |index: usize| match scan.positions_m() {
        Some(positions_m) => (positions_m[index] - positions_m[0]) / scan.size_m().0,
        None => index as f64 / (points.max(2) - 1) as f64,
    };
    let [width, height] = PROFILE_PX;
    let mut path = String::new();
    let mut is_drawing = false;
    for (index, height_m) in scan.heights_m().enumerate() {
        if let Some(height_m) = height_m {
            let up = (height_m - lowest_m) / (highest_m - lowest_m).max(f64::MIN_POSITIVE);
            let command = if is_drawing { 'L' } else { 'M' };
            let _ = write!(path, "{command}{:.1} {:.1}", width * share(index), height * (0.98 - 0.96 * up));
        }
        is_drawing = height_m.is_some();
    }
    Some(format!("<path d=\"{path}\" fill=\"none\" stroke=\"currentColor\"/>"))
}
