//! Formats of scans.

use std::fmt;

/// Check of a reader against other programs, which are named.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FormatCheck {
    /// On files of instruments, or of the program whose format it is.
    RealFiles(&'static str),
    /// On files that were made for the check: no other could be had.
    MadeFiles(&'static str),
    /// No file is read.
    NoFile,
}

/// Note on a format whose reader has seen no file of an instrument.
pub(crate) const UNCHECKED: &str = "layout after documentation, not checked on a real file";

/// Defines the formats, each with its name in messages and tables and how its reader was checked.
macro_rules! formats {
    ($($(#[$doc:meta])* $format:ident = $name:literal, $check:ident $(($readers:literal))?;)*) => {
        /// A format that scans are read from.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        #[non_exhaustive]
        pub enum ScanFormat {
            $($(#[$doc])* $format,)*
        }

        impl ScanFormat {
            /// Every format.
            pub const ALL: &[ScanFormat] = &[$(ScanFormat::$format),*];

            /// Returns how the reader of the format was checked.
            #[must_use]
            pub fn check(self) -> FormatCheck {
                match self {
                    $(Self::$format => FormatCheck::$check $(($readers))?,)*
                }
            }
        }

        impl fmt::Display for ScanFormat {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str(match self {
                    $(Self::$format => $name,)*
                })
            }
        }
    };
}

formats! {
    /// Columns or a matrix of numbers.
    Text = "text", RealFiles("SurfaceTopography");
    /// No file at all: heights that are in memory.
    Memory = "memory", NoFile;
    /// Nanoscope and Dimension atomic force microscopes: `.001`, `.di`, `.spm`.
    Nanoscope = "Nanoscope", RealFiles("Gwyddion, SurfaceTopography, AFMReader");
    /// NetCDF classic, in the layout of contact.engineering.
    NetCdf = "NetCDF", RealFiles("SurfaceTopography");
    /// ISO 25178-72.
    X3p = "X3P", RealFiles("Gwyddion");
    /// ZIP file of contact.engineering, with `meta.yml` or `index.json`.
    Container = "container", RealFiles("SurfaceTopography");
    /// Gwyddion's own: `.gwy`.
    Gwyddion = "Gwyddion", RealFiles("Gwyddion, gwyfile");
    /// Digital Surf: `.sur`, `.pro`.
    DigitalSurf = "Digital Surf", RealFiles("Gwyddion, SurfaceTopography");
    /// Documents of MountainsMap: `.mnt`.
    MountainsMap = "MountainsMap", MadeFiles("SurfaceTopography");
    /// Igor binary waves, as Asylum Research writes them: `.ibw`.
    Igor = "Igor", RealFiles("Gwyddion, SurfaceTopography, AFMReader");
    /// Wyko and Vision: `.opd`, and their text, `.asc`.
    Wyko = "Wyko", RealFiles("Gwyddion, SurfaceTopography, surfalize");
    /// Zygo's text of points: `.xyz`.
    ZygoXyz = "Zygo XYZ", MadeFiles("the layout that public programs read");
    /// Bruker Vision64: `.opdx`.
    Vision64 = "Vision64", RealFiles("Gwyddion, SurfaceTopography");
    /// Sensofar: `.plu`, `.apx`.
    Sensofar = "Sensofar", RealFiles("Gwyddion, SurfaceTopography");
    /// Sensofar: `.plux`.
    SensofarPlux = "Sensofar PLUX", MadeFiles("Gwyddion, SurfaceTopography");
    /// Alicona Imaging: `.al3d`.
    Alicona = "Alicona", RealFiles("Gwyddion, SurfaceTopography");
    /// Zygo MetroPro: `.dat`.
    MetroPro = "MetroPro", RealFiles("Gwyddion, SurfaceTopography");
    /// ISO 25178-71, text and binary: `.sdf`.
    Sdf = "SDF", RealFiles("Gwyddion, SurfaceTopography");
    /// Nanosurf: `.nid`.
    Nanosurf = "Nanosurf", RealFiles("Gwyddion, NSFopen");
    /// Agilent and Molecular Imaging PicoSPM: `.mi`.
    MolecularImaging = "Molecular Imaging", RealFiles("Gwyddion, SurfaceTopography");
    /// WSxM of Nanotec: `.stp`, `.top`.
    Wsxm = "WSxM", RealFiles("SurfaceTopography, AFMReader");
    /// FRT MicroProf: `.frt`.
    Frt = "FRT", RealFiles("Gwyddion, SurfaceTopography");
    /// NanoFocus: `.nms`.
    NanoFocus = "NanoFocus", MadeFiles("surfalize");
    /// Park Systems: `.tiff`.
    ParkTiff = "Park TIFF", RealFiles("Gwyddion, SurfaceTopography");
    /// TrueGage TrueMap: `.tmd`.
    TrueMap = "TrueMap", RealFiles("SurfaceTopography");
    /// Image Metrology BCR-STM: `.bcr`, `.bcrf`.
    Bcr = "BCR", RealFiles("Gwyddion, SurfaceTopography");
    /// Keyence laser scanning microscopes: `.vk4`, `.vk6`, `.vk7`.
    Keyence = "Keyence", MadeFiles("Gwyddion, SurfaceTopography");
    /// Arrays of NumPy: `.npy`, `.npz`.
    Numpy = "NumPy", RealFiles("NumPy");
    /// HDF5 and NetCDF-4.
    Hdf5 = "HDF5", RealFiles("h5py, AFMReader");
    /// Workbooks of profilometers: `.xlsx`.
    Workbook = "workbook", RealFiles("SurfaceTopography");
    /// JPK Instruments: `.jpk`, `.jpk-qi-image`.
    Jpk = "JPK", RealFiles("Gwyddion, AFMReader");
    /// Digital Metrology OmniSurf3D: `.os3d`.
    OmniSurf = "OmniSurf3D", MadeFiles("SurfaceTopography");
    /// KLA Zeta: `.zmg`.
    Zeta = "Zeta", MadeFiles("SurfaceTopography");
    /// Mahr MarWin: `.qep`.
    MarWin = "MarWin", MadeFiles("SurfaceTopography");
    /// NT-MDT: `.mdt`.
    NtMdt = "NT-MDT", RealFiles("Gwyddion");
    /// Gwyddion Simple Field: `.gsf`.
    Gsf = "GSF", RealFiles("gsffile, Gwyddion");
    /// Nanonis scanning probe microscopes: `.sxm`.
    Nanonis = "Nanonis", MadeFiles("Gwyddion");
    /// MATLAB, version 5: `.mat`.
    Matlab = "MATLAB", RealFiles("SciPy");
}
