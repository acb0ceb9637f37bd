//! Marker of a publication under way. It stays where a program is killed between two renames.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use super::temporaries::{folder_of, remove_abandoned};

/// Name of the marker in a folder that gets files.
const MARKER: &str = ".truearea-unfinished";

/// The markers of a publication of several files.
pub(crate) struct Markers(Vec<PathBuf>);

impl Markers {
    /// Marks the folders of these targets; also returns those with the marker of an earlier publication.
    pub(crate) fn place<'t>(targets: impl ExactSizeIterator<Item = &'t Path>) -> (Self, Vec<PathBuf>) {
        let are_several = targets.len() > 1;
        let folders: BTreeSet<&Path> = targets.map(folder_of).collect();
        let unfinished = folders.iter().filter(|folder| folder.join(MARKER).exists());
        let unfinished: Vec<PathBuf> = unfinished.map(|folder| folder.to_path_buf()).collect();
        let markers: Vec<PathBuf> = folders.iter().map(|folder| folder.join(MARKER)).collect();
        folders.iter().for_each(|folder| remove_abandoned(folder));
        if are_several {
            // A folder that takes no marker takes no file either, and the first rename tells so.
            let _ = markers.iter().try_for_each(|marker| std::fs::write(marker, ""));
        }
        (Markers(markers), unfinished)
    }

    /// Removes the markers.
    pub(crate) fn remove(self) {
        for marker in self.0 {
            // Another program may have removed it.
            let _ = std::fs::remove_file(marker);
        }
    }
}
