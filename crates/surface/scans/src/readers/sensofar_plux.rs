//! Sensofar, S neox and later: `.plux`, a ZIP file with `index.xml` and layers of floating-point numbers in µm.
//!
//! The names of the elements are those that the readers of Gwyddion and SurfaceTopography know.

use roxmltree::Node;

use crate::archive::{Archive, is_named_in, is_zip};
use crate::channel::{Channel, Lateral, MOST_TEXT, Quantity, refuse_many, shortened};
use crate::error::{FilePlace, ScanReadError, quoted};
use crate::format::ScanFormat;
use crate::metadata::Probe;
use crate::numbers;
use crate::options::ScanOptions;
use crate::raster::{NumberType, Raster};
use crate::readers::{Reader, xml};
use units::LengthUnit;

const FORMAT: ScanFormat = ScanFormat::SensofarPlux;
const INDEX: &str = "index.xml";
const LAYER: &str = "LAYER_";
const GENERAL: &str = "GENERAL";
/// Files that are not made to be read have more.
const MOST_NODES: u32 = 100_000;
const LARGEST_INDEX: u64 = 16 << 20;
/// Items of the information that people write.
const TEXTS: [&str; 5] = ["Comment", "Comments", "Description", "Notes", "Title"];

pub(super) const READER: Reader = Reader { format: FORMAT, recognises, channels };

fn recognises(bytes: &[u8]) -> bool {
    is_zip(bytes) && is_named_in(bytes, INDEX) && is_named_in(bytes, "LAYER_0")
}

fn channels<'b>(bytes: &'b [u8], options: &ScanOptions) -> Result<Vec<Channel<'b>>, ScanReadError> {
    let mut archive = Archive::open(bytes, options.unpacked_bound())?;
    let index = archive.read_at_most(&path_of(&archive, INDEX), LARGEST_INDEX)?;
    let syntax = |problem: String| ScanReadError::Syntax { file: INDEX.to_owned(), problem };
    let text = std::str::from_utf8(&index).map_err(|error| syntax(format!("no UTF-8: {error}")))?;
    let text = text.trim_start_matches('\u{feff}');
    let document = xml::parse(text, MOST_NODES).map_err(syntax)?;
    let root = document.root_element();
    let general = child(root, GENERAL).ok_or_else(|| missing(INDEX, GENERAL))?;
    let size = [count(general, "IMAGE_SIZE_X")?, count(general, "IMAGE_SIZE_Y")?];
    let lateral = lateral(general, size[1]);
    let free_text = free_text(root);
    let mut channels = Vec::new();
    for layer in root.children().filter(|node| node.tag_name().name().starts_with(LAYER)) {
        refuse_many(FORMAT, channels.len() + 1)?;
        let samples = raster(&mut archive, layer, size).into();
        let name = layer.tag_name().name().replace(LAYER, "Layer ");
        let quantity = Quantity::Heights(Some(LengthUnit::MICROMETRE));
        channels.push(Channel {
            probe: Some(Probe::Microscope),
            free_text: free_text.clone(),
            ..Channel::new(Some(name), quantity, lateral.clone(), samples)
        });
    }
    Ok(channels)
}

/// Points without a height are stored as what is not a number.
fn raster<'b>(
    archive: &mut Archive,
    layer: Node,
    [columns, rows]: [usize; 2],
) -> Result<Raster<'b>, ScanReadError> {
    const FILE: &str = "FILENAME_Z";
    let file = child_text(layer, FILE).ok_or_else(|| missing(layer.tag_name().name(), FILE))?;
    let heights = archive.read(&path_of(archive, file))?;
    Ok(Raster::new(NumberType::F32, columns, rows, heights, 0))
}

/// A path as the archive has it: some writers put the folder itself before it.
fn path_of(archive: &Archive, path: &str) -> String {
    let is_same = |own: &&str| own.trim_start_matches("./") == path.trim_start_matches("./");
    archive.paths().find(is_same).unwrap_or(path).to_owned()
}

/// The fields of view are those of a point.
fn lateral(general: Node, rows: usize) -> Lateral {
    let spacing_m = |name: &str| {
        let spacing: f64 = child_text(general, name)?.parse().ok()?;
        numbers::positive(LengthUnit::MICROMETRE.to_m(spacing))
    };
    Lateral::spacings(spacing_m("FOV_X"), spacing_m("FOV_Y"), rows)
}

fn free_text(root: Node) -> String {
    let items = child(root, "INFO").into_iter().flat_map(|info| info.children());
    let text = |item: Node| {
        let name = child_text(item, "NAME")?;
        TEXTS.contains(&name).then(|| child_text(item, "VALUE").map(str::to_owned))?
    };
    shortened(items.filter_map(text).collect::<Vec<_>>().join("\n"), MOST_TEXT)
}

fn count(parent: Node, name: &str) -> Result<usize, ScanReadError> {
    let text = child_text(parent, name).ok_or_else(|| missing(parent.tag_name().name(), name))?;
    numbers::count(text).ok_or_else(|| {
        FORMAT.bad(
            FilePlace::Element(format!("{}/{name}", parent.tag_name().name())),
            "the text",
            quoted(text),
            "a whole number above 0",
            "export the file again",
        )
    })
}

fn child<'a, 'd>(parent: Node<'a, 'd>, name: &str) -> Option<Node<'a, 'd>> {
    parent.children().find(|node| node.is_element() && node.tag_name().name() == name)
}

fn child_text<'a>(parent: Node<'a, '_>, name: &str) -> Option<&'a str> {
    child(parent, name)?.text().map(str::trim).filter(|text| !text.is_empty())
}

fn missing(parent: &str, name: &str) -> ScanReadError {
    let mend = "export the file again";
    FORMAT.missing(FilePlace::Element(parent.to_owned()), format!("element '{name}'"), mend)
}
