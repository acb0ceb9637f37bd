//! The datasets of a file, with what is needed of them, read by the library within bounds.

use hdf5_reader::group::Group;
use hdf5_reader::{Attribute, ByteOrder as StoredOrder, Dataset, Datatype, Hdf5File, OpenOptions};

use super::FORMAT;
use crate::cursor::ByteOrder;
use crate::error::{FilePlace, ScanReadError};
use crate::options::ScanOptions;
use crate::raster::{NumberType, Raster};
use crate::room::Room;

/// Groups within groups, and datasets, of files that are made to be read; links may lead in circles.
const DEEPEST: usize = 8;
const MOST_DATASETS: usize = 1000;
/// Largest ratio of unpacked to packed size: the most that deflate, the filter in use, attains.
const LARGEST_RATIO: u64 = 1032;
/// Bytes that any file may unpack to.
const SMALL: u64 = 1 << 20;

pub(super) struct Content {
    pub(super) entries: Vec<Entry>,
    /// The groups below the root, each with its path.
    pub(super) groups: Vec<(String, Group)>,
    room: Room,
}

pub(super) struct Entry {
    /// From the root, with slashes between.
    pub(super) path: String,
    pub(super) dataset: Dataset,
}

impl Content {
    pub(super) fn read(bytes: &[u8], options: &ScanOptions) -> Result<Self, ScanReadError> {
        // Datasets that were never written have any size and no bytes.
        let packed = LARGEST_RATIO.saturating_mul(bytes.len() as u64).max(SMALL);
        let bound = options.unpacked_bound().min(packed);
        let most = usize::try_from(bound).unwrap_or(usize::MAX);
        let limits = OpenOptions::default().with_max_read_bytes(most).with_max_chunk_bytes(most);
        let file = Hdf5File::from_bytes_with_options(bytes, limits).map_err(failure)?;
        let mut content = Self { entries: Vec::new(), groups: Vec::new(), room: Room::new(bound) };
        content.collect(&file.root_group().map_err(failure)?, "", 0)?;
        Ok(content)
    }

    /// Adds the datasets of a group and of those in it.
    fn collect(&mut self, group: &Group, path: &str, depth: usize) -> Result<(), ScanReadError> {
        let (groups, datasets) = group.members().map_err(failure)?;
        for dataset in datasets {
            self.entries.push(Entry { path: format!("{path}{}", dataset.name()), dataset });
        }
        if self.entries.len() + self.groups.len() + groups.len() > MOST_DATASETS {
            let what = "the HDF5 file".to_owned();
            return Err(ScanReadError::ArchiveTooLarge {
                what,
                bound: MOST_DATASETS as u64,
                unit: "datasets and groups",
            });
        }
        if depth == DEEPEST {
            return Ok(());
        }
        for group in groups {
            let path = format!("{path}{}", group.name());
            self.collect(&group, &format!("{path}/"), depth + 1)?;
            self.groups.push((path, group));
        }
        Ok(())
    }

    /// A dataset by its path.
    pub(super) fn find(&self, path: &str) -> Option<usize> {
        self.entries.iter().position(|entry| entry.path == path)
    }

    /// The numbers of a dataset, the last of its axes that have more than one point running along x.
    pub(super) fn raster<'b>(&mut self, at: usize) -> Result<Raster<'b>, ScanReadError> {
        let entry = &self.entries[at];
        let (columns, rows) = match entry.axes()[..] {
            [] => (1, 1),
            [columns] => (columns, 1),
            [rows, columns] => (columns, rows),
            _ => return Err(entry.bad("the number of axes", entry.axes().len(), "1 or 2")),
        };
        let Some((number, byte_order)) = entry.number() else {
            return Err(entry.bad("the type", format!("{:?}", entry.dataset.dtype()), "a real number"));
        };
        let size = entry.dataset.raw_byte_len().map_err(failure)?;
        self.room.take(size as u64, || format!("'{}'", entry.path))?;
        let bytes = entry.dataset.read_raw_bytes().map_err(failure)?;
        Ok(Raster { byte_order, ..Raster::new(number, columns, rows, bytes, 0) })
    }

    /// The numbers of a dataset as they are; those that are not finite are left out.
    pub(super) fn values(&mut self, at: usize) -> Result<Vec<f64>, ScanReadError> {
        Ok(self.raster(at)?.decode(FORMAT)?.values)
    }
}

impl Entry {
    /// The lengths of the axes that have more than one point.
    pub(super) fn axes(&self) -> Vec<usize> {
        let lengths = self.dataset.shape().iter().filter(|&&length| length != 1);
        lengths.map(|&length| usize::try_from(length).unwrap_or(usize::MAX)).collect()
    }

    /// The type of its numbers; none if it is not a real number.
    pub(super) fn number(&self) -> Option<(NumberType, ByteOrder)> {
        let (number, order) = match *self.dataset.dtype() {
            Datatype::FloatingPoint { size: 4, byte_order } => (NumberType::F32, byte_order),
            Datatype::FloatingPoint { size: 8, byte_order } => (NumberType::F64, byte_order),
            Datatype::FixedPoint { size, signed, byte_order } => {
                let number = match (size, signed) {
                    (1, true) => NumberType::I8,
                    (1, false) => NumberType::U8,
                    (2, true) => NumberType::I16,
                    (2, false) => NumberType::U16,
                    (4, true) => NumberType::I32,
                    (4, false) => NumberType::U32,
                    (8, true) => NumberType::I64,
                    (8, false) => NumberType::U64,
                    _ => return None,
                };
                (number, byte_order)
            }
            _ => return None,
        };
        let is_big = matches!(order, StoredOrder::BigEndian);
        Some((number, if is_big { ByteOrder::Big } else { ByteOrder::Little }))
    }

    pub(super) fn attribute(&self, name: &str) -> Option<Attribute> {
        self.dataset.attributes().into_iter().find(|attribute| attribute.name == name)
    }

    /// An attribute that is a number.
    pub(super) fn number_of(&self, name: &str) -> Option<f64> {
        let attribute = self.attribute(name)?;
        attribute.read_as_f64().ok().filter(|number| number.is_finite())
    }

    /// An attribute that is a text.
    pub(super) fn text_of(&self, name: &str) -> Option<String> {
        let attribute = self.attribute(name)?;
        attribute.read_string().ok().or_else(|| attribute.read_strings().ok()?.into_iter().next())
    }

    pub(super) fn bad(&self, field: &str, value: impl ToString, bound: &str) -> ScanReadError {
        FORMAT.bad(
            FilePlace::Element(self.path.clone()),
            field,
            value.to_string().chars().take(60).collect::<String>(),
            bound,
            "export the file again",
        )
    }
}

pub(super) fn failure(error: hdf5_reader::error::Error) -> ScanReadError {
    ScanReadError::Syntax { file: "HDF5".to_owned(), problem: error.to_string() }
}
