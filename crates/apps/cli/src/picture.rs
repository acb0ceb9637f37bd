//! Pictures of figures: SVG as drawn, or PNG or PDF made from it.

use std::path::PathBuf;
use std::str::FromStr;

use report::chart::maps::FieldPicture;

use crate::place::Place;

/// A file for a picture, in the format that its name ends in.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Picture {
    /// The file.
    pub path: PathBuf,
    format: PictureFormat,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum PictureFormat {
    Svg,
    #[cfg(feature = "png")]
    Png,
    #[cfg(feature = "png")]
    Pdf,
}

/// Reason that there is no picture.
#[derive(Debug, thiserror::Error)]
pub(crate) enum PictureError {
    /// A name that ends in none of the formats.
    #[error("'{name}' must end in {endings}, the formats in which figures are drawn")]
    Ending {
        /// The name.
        name: String,
        /// The endings that would do.
        endings: &'static str,
    },
    /// A picture of points, by a build that draws none.
    #[cfg(not(feature = "png"))]
    #[error("drawing {}: this program was built without pictures of maps", path.display())]
    NoPoints {
        /// The file.
        path: PathBuf,
    },
    /// A picture of points as a PDF.
    #[cfg(feature = "png")]
    #[error("drawing {}: maps are drawn as .svg or .png", path.display())]
    NoPdfOfPoints {
        /// The file.
        path: PathBuf,
    },
    /// The SVG could not be turned into another format.
    #[cfg(feature = "png")]
    #[error("drawing {}: {why}", path.display())]
    Drawing {
        /// The file.
        path: PathBuf,
        /// The message of the drawing library.
        why: String,
    },
}

#[cfg(feature = "png")]
const ENDINGS: &str = ".svg, .png or .pdf";
#[cfg(not(feature = "png"))]
const ENDINGS: &str = ".svg";

impl FromStr for Picture {
    type Err = PictureError;

    fn from_str(name: &str) -> Result<Self, PictureError> {
        let path = PathBuf::from(name);
        let ending = path.extension().map(|ending| ending.to_ascii_lowercase());
        let format = match ending.as_ref().and_then(|ending| ending.to_str()) {
            Some("svg") => PictureFormat::Svg,
            #[cfg(feature = "png")]
            Some("png") => PictureFormat::Png,
            #[cfg(feature = "png")]
            Some("pdf") => PictureFormat::Pdf,
            _ => return Err(PictureError::Ending { name: name.to_owned(), endings: ENDINGS }),
        };
        Ok(Picture { path, format })
    }
}

impl Picture {
    /// The place of the file.
    pub fn place(&self) -> Place {
        Place::File(self.path.clone())
    }

    /// Returns a picture of this format in another file.
    pub fn with_path(&self, path: PathBuf) -> Self {
        Picture { path, format: self.format }
    }

    /// The bytes of the file, of points over their frame. In an SVG document they stand as an image.
    ///
    /// # Errors
    /// [`PictureError::Drawing`], [`PictureError::NoPdfOfPoints`].
    #[cfg(feature = "png")]
    pub fn bytes_of_field(&self, field: &FieldPicture) -> Result<Vec<u8>, PictureError> {
        let drawing = |why| PictureError::Drawing { path: self.path.clone(), why };
        match self.format {
            PictureFormat::Png => png::of_field(field).map_err(drawing),
            PictureFormat::Svg => Ok(field.document().into_bytes()),
            PictureFormat::Pdf => Err(PictureError::NoPdfOfPoints { path: self.path.clone() }),
        }
    }

    /// The bytes of the file, of points over their frame.
    ///
    /// # Errors
    /// [`PictureError::NoPoints`]: this build draws none.
    #[cfg(not(feature = "png"))]
    pub fn bytes_of_field(&self, _: &FieldPicture) -> Result<Vec<u8>, PictureError> {
        Err(PictureError::NoPoints { path: self.path.clone() })
    }

    /// Refuses a format in which no points are drawn, before they are computed.
    ///
    /// # Errors
    /// [`PictureError::NoPdfOfPoints`], or [`PictureError::NoPoints`] of a build without them.
    pub fn check_of_points(&self) -> Result<(), PictureError> {
        #[cfg(feature = "png")]
        return match self.format {
            PictureFormat::Pdf => Err(PictureError::NoPdfOfPoints { path: self.path.clone() }),
            PictureFormat::Png | PictureFormat::Svg => Ok(()),
        };
        #[cfg(not(feature = "png"))]
        Err(PictureError::NoPoints { path: self.path.clone() })
    }

    /// The bytes of the file, of an SVG document.
    ///
    /// # Errors
    /// [`PictureError::Drawing`].
    pub fn bytes(&self, svg: String) -> Result<Vec<u8>, PictureError> {
        #[cfg(feature = "png")]
        let drawing = |why| PictureError::Drawing { path: self.path.clone(), why };
        match self.format {
            PictureFormat::Svg => Ok(svg.into_bytes()),
            #[cfg(feature = "png")]
            PictureFormat::Png => png::of(&svg).map_err(drawing),
            #[cfg(feature = "png")]
            PictureFormat::Pdf => png::pdf(&svg).map_err(drawing),
        }
    }
}

/// The PNG of a field; none where the program draws no PNG.
///
/// # Errors
/// [`PictureError::Drawing`] with the message of the drawing library.
#[cfg(feature = "png")]
pub(crate) fn png_of_field(picture: &FieldPicture) -> Result<Option<Vec<u8>>, PictureError> {
    png::of_field(picture).map(Some).map_err(|why| PictureError::Drawing { path: PathBuf::new(), why })
}

/// The PNG of a field; none where the program draws no PNG.
///
/// # Errors
/// None.
#[cfg(not(feature = "png"))]
pub(crate) fn png_of_field(_: &FieldPicture) -> Result<Option<Vec<u8>>, PictureError> {
    Ok(None)
}

#[cfg(feature = "png")]
mod png {
    use std::sync::Arc;

    use ::png::{ColorType, Encoder, EncodingError, PixelDimensions, Unit};
    use report::chart::maps::FieldPicture;
    use resvg::tiny_skia::{Color, FilterQuality, IntSize, Pixmap, PixmapPaint, Transform};
    use resvg::usvg::fontdb::Database;
    use resvg::usvg::{Options, Tree};
    use svg2pdf::{ConversionOptions, PageOptions};

    /// Pixels of the picture of a map for a pixel of the SVG: 300 dots per inch where it is 10 cm wide.
    const SCALE: f32 = 2.5;

    /// Dots per inch of print of the picture of a figure.
    const PRINTED_DOTS: f32 = 600.0;

    /// Pixels of SVG in an inch.
    const DOTS_PER_INCH: f32 = 96.0;

    /// Most pixels of a picture, which take some 20 bytes each until they are written.
    const MOST_PIXELS: u64 = 1 << 25;

    const FONT: &str = "DejaVu Sans";

    /// The PNG of an SVG document, or what is wrong with that.
    pub(super) fn of(svg: &str) -> Result<Vec<u8>, String> {
        let tree = tree(svg)?;
        let at = |scale: f32| drawn(&tree, scale).map(|picture| (picture, scale * DOTS_PER_INCH));
        // A picture too large for print is drawn as finely as a map.
        let (picture, dots_per_inch) = at(PRINTED_DOTS / DOTS_PER_INCH).or_else(|_| at(SCALE))?;
        encoded(&picture, dots_per_inch).map_err(|error| error.to_string())
    }

    /// An opaque picture as PNG, with its size in print.
    fn encoded(picture: &Pixmap, dots_per_inch: f32) -> Result<Vec<u8>, EncodingError> {
        let mut written = Vec::new();
        let mut encoder = Encoder::new(&mut written, picture.width(), picture.height());
        encoder.set_color(ColorType::Rgba);
        let per_metre = (dots_per_inch / 0.0254).round() as u32;
        encoder.set_pixel_dims(Some(PixelDimensions { xppu: per_metre, yppu: per_metre, unit: Unit::Meter }));
        encoder.write_header()?.write_image_data(picture.data())?;
        Ok(written)
    }

    /// The PDF of an SVG document, in its size in print and with its letters as text.
    pub(super) fn pdf(svg: &str) -> Result<Vec<u8>, String> {
        let size = PageOptions { dpi: DOTS_PER_INCH };
        let pdf = svg2pdf::to_pdf(&tree(svg)?, ConversionOptions::default(), size)
            .map_err(|error| error.to_string())?;
        // The library lists resources in the order of a hash, which differs from run to run.
        let mut lines: Vec<&[u8]> = pdf.split(|byte| *byte == b'\n').collect();
        let is_resource = |line: &&[u8]| line.trim_ascii_start().starts_with(b"/") && line.ends_with(b" 0 R");
        lines.chunk_by_mut(|a, b| is_resource(a) && is_resource(b)).for_each(<[_]>::sort_unstable);
        Ok(lines.join(&b'\n'))
    }

    /// The PNG of a field: its points over its frame.
    pub(super) fn of_field(picture: &FieldPicture) -> Result<Vec<u8>, String> {
        let mut drawn = drawn(&tree(&picture.svg)?, SCALE)?;
        let points = points(picture)?;
        let [left, top, width, height] = picture.place.map(|px| px as f32 * SCALE);
        let (x, y) = (width / points.width() as f32, height / points.height() as f32);
        // Points larger than pixels keep their edges; smaller ones are averaged as far as the library does.
        let quality = if x >= 1.0 { FilterQuality::Nearest } else { FilterQuality::Bilinear };
        let paint = PixmapPaint { quality, ..PixmapPaint::default() };
        let place = Transform::from_row(x, 0.0, 0.0, y, left, top);
        drawn.draw_pixmap(0, 0, points.as_ref(), &paint, place, None);
        drawn.encode_png().map_err(|error| error.to_string())
    }

    /// The points alone, a pixel each.
    fn points(picture: &FieldPicture) -> Result<Pixmap, String> {
        let rows = picture.colours.len() / picture.columns;
        let [red_green_blue_alpha, size] = [4 * picture.colours.len(), picture.columns];
        let mut bytes = Vec::with_capacity(red_green_blue_alpha);
        picture.colours.iter().for_each(|[red, green, blue]| bytes.extend([*red, *green, *blue, 255]));
        let too_large = || format!("a picture of {size} by {rows} points is too large");
        let [columns, lines] = [size, rows].map(|points| u32::try_from(points).ok());
        let size = columns.zip(lines).and_then(|(columns, lines)| IntSize::from_wh(columns, lines));
        size.and_then(|size| Pixmap::from_vec(bytes, size)).ok_or_else(too_large)
    }

    /// An SVG document. Its letters are those of a font that comes with the program, so that it is the same picture
    /// everywhere.
    fn tree(svg: &str) -> Result<Tree, String> {
        let mut fonts = Database::new();
        for font in [dejavu::sans::regular(), dejavu::sans::bold()] {
            fonts.load_font_data(font.to_vec());
        }
        fonts.set_sans_serif_family(FONT);
        let options = Options {
            dpi: DOTS_PER_INCH,
            font_family: FONT.to_owned(),
            fontdb: Arc::new(fonts),
            ..Options::default()
        };
        Tree::from_str(svg, &options).map_err(|error| error.to_string())
    }

    /// An SVG document in pixels, some for each of its own.
    fn drawn(tree: &Tree, scale: f32) -> Result<Pixmap, String> {
        let pixels = |length: f32| (length * scale).ceil() as u32;
        let (width, height) = (pixels(tree.size().width()), pixels(tree.size().height()));
        let is_small = u64::from(width) * u64::from(height) <= MOST_PIXELS;
        let mut picture = Pixmap::new(width, height).filter(|_| is_small).ok_or_else(|| {
            format!(
                "a picture of {width} by {height} pixels is too large; make it smaller, or draw .svg or .pdf"
            )
        })?;
        picture.fill(Color::WHITE);
        resvg::render(tree, Transform::from_scale(scale, scale), &mut picture.as_mut());
        Ok(picture)
    }
}
