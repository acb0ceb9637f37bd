//! Formats of scans.

use std::fmt;

/// Defines the formats, each with its name in messages and tables.
macro_rules! formats {
    ($($(#[$doc:meta])* $format:ident = $name:literal,)*) => {
        /// A format that scans are read from.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        #[non_exhaustive]
        pub enum ScanFormat {
            $($(#[$doc])* $format,)*
        }

        impl ScanFormat {
            /// Every format.
            pub const ALL: &[ScanFormat] = &[$(ScanFormat::$format),*];
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
    Text = "text",
    /// No file at all: heights that are in memory.
    Memory = "memory",
    /// Nanoscope and Dimension atomic force microscopes: `.001`, `.di`, `.spm`.
    Nanoscope = "Nanoscope",
    /// NetCDF classic, in the layout of contact.engineering.
    NetCdf = "NetCDF",
    /// ISO 25178-72.
    X3p = "X3P",
    /// ZIP file of contact.engineering, with `meta.yml` or `index.json`.
    Container = "container",
    /// Gwyddion's own: `.gwy`.
    Gwyddion = "Gwyddion",
    /// Digital Surf: `.sur`, `.pro`.
    DigitalSurf = "Digital Surf",
    /// Documents of MountainsMap: `.mnt`.
    MountainsMap = "MountainsMap",
    /// Igor binary waves, as Asylum Research writes them: `.ibw`.
    Igor = "Igor",
    /// Wyko and Vision: `.opd`, and their text, `.asc`.
    Wyko = "Wyko",
    /// Zygo's text of points: `.xyz`.
    ZygoXyz = "Zygo XYZ",
    /// Bruker Vision64: `.opdx`.
    Vision64 = "Vision64",
    /// Sensofar: `.plu`, `.apx`.
    Sensofar = "Sensofar",
    /// Sensofar: `.plux`.
    SensofarPlux = "Sensofar PLUX",
    /// Alicona Imaging: `.al3d`.
    Alicona = "Alicona",
    /// Zygo MetroPro: `.dat`.
    MetroPro = "MetroPro",
    /// ISO 25178-71, text and binary: `.sdf`.
    Sdf = "SDF",
    /// Nanosurf: `.nid`.
    Nanosurf = "Nanosurf",
    /// Agilent and Molecular Imaging PicoSPM: `.mi`.
    MolecularImaging = "Molecular Imaging",
    /// WSxM of Nanotec: `.stp`, `.top`.
    Wsxm = "WSxM",
    /// FRT MicroProf: `.frt`.
    Frt = "FRT",
    /// NanoFocus: `.nms`.
    NanoFocus = "NanoFocus",
    /// Park Systems: `.tiff`.
    ParkTiff = "Park TIFF",
    /// TrueGage TrueMap: `.tmd`.
    TrueMap = "TrueMap",
    /// Image Metrology BCR-STM: `.bcr`, `.bcrf`.
    Bcr = "BCR",
    /// Keyence laser scanning microscopes: `.vk4`, `.vk6`, `.vk7`.
    Keyence = "Keyence",
    /// Arrays of NumPy: `.npy`, `.npz`.
    Numpy = "NumPy",
    /// HDF5 and NetCDF-4.
    Hdf5 = "HDF5",
    /// Workbooks of profilometers: `.xlsx`.
    Workbook = "workbook",
    /// JPK Instruments: `.jpk`, `.jpk-qi-image`.
    Jpk = "JPK",
    /// Digital Metrology OmniSurf3D: `.os3d`.
    OmniSurf = "OmniSurf3D",
    /// KLA Zeta: `.zmg`.
    Zeta = "Zeta",
    /// Mahr MarWin: `.qep`.
    MarWin = "MarWin",
    /// NT-MDT: `.mdt`.
    NtMdt = "NT-MDT",
    /// Gwyddion Simple Field: `.gsf`.
    Gsf = "GSF",
    /// Nanonis scanning probe microscopes: `.sxm`.
    Nanonis = "Nanonis",
    /// MATLAB, version 5: `.mat`.
    Matlab = "MATLAB",
}
