//! Formats of scans.

use std::fmt;

/// A format that scans are read from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum ScanFormat {
    /// Columns or a matrix of numbers.
    Text,
    /// No file at all: heights that are in memory.
    Memory,
    /// Nanoscope and Dimension atomic force microscopes: `.001`, `.di`, `.spm`.
    Nanoscope,
    /// NetCDF classic, in the layout of contact.engineering.
    NetCdf,
    /// ISO 25178-72.
    X3p,
    /// ZIP file of contact.engineering, with `meta.yml` or `index.json`.
    Container,
    /// Gwyddion's own: `.gwy`.
    Gwyddion,
    /// Digital Surf: `.sur`, `.pro`.
    DigitalSurf,
    /// Documents of MountainsMap: `.mnt`.
    MountainsMap,
    /// Igor binary waves, as Asylum Research writes them: `.ibw`.
    Igor,
    /// Wyko and Vision: `.opd`.
    Wyko,
    /// Bruker Vision64: `.opdx`.
    Vision64,
    /// Sensofar: `.plu`, `.apx`.
    Sensofar,
    /// Sensofar: `.plux`.
    SensofarPlux,
    /// Alicona Imaging: `.al3d`.
    Alicona,
    /// Zygo MetroPro: `.dat`.
    MetroPro,
    /// ISO 25178-71, text and binary: `.sdf`.
    Sdf,
    /// Nanosurf: `.nid`.
    Nanosurf,
    /// Agilent and Molecular Imaging PicoSPM: `.mi`.
    MolecularImaging,
    /// WSxM of Nanotec: `.stp`, `.top`.
    Wsxm,
    /// FRT MicroProf: `.frt`.
    Frt,
    /// NanoFocus: `.nms`.
    NanoFocus,
    /// Park Systems: `.tiff`.
    ParkTiff,
    /// TrueGage TrueMap: `.tmd`.
    TrueMap,
    /// Image Metrology BCR-STM: `.bcr`, `.bcrf`.
    Bcr,
    /// Keyence laser scanning microscopes: `.vk4`, `.vk6`, `.vk7`.
    Keyence,
    /// Arrays of NumPy: `.npy`, `.npz`.
    Numpy,
    /// HDF5 and NetCDF-4.
    Hdf5,
    /// Workbooks of profilometers: `.xlsx`.
    Workbook,
    /// JPK Instruments: `.jpk`, `.jpk-qi-image`.
    Jpk,
    /// Digital Metrology OmniSurf3D: `.os3d`.
    OmniSurf,
    /// KLA Zeta: `.zmg`.
    Zeta,
    /// Mahr MarWin: `.qep`.
    MarWin,
    /// NT-MDT: `.mdt`.
    NtMdt,
}

impl fmt::Display for ScanFormat {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Text => "text",
            Self::Memory => "memory",
            Self::Nanoscope => "Nanoscope",
            Self::NetCdf => "NetCDF",
            Self::X3p => "X3P",
            Self::Container => "container",
            Self::Gwyddion => "Gwyddion",
            Self::DigitalSurf => "Digital Surf",
            Self::MountainsMap => "MountainsMap",
            Self::Igor => "Igor",
            Self::Wyko => "Wyko",
            Self::Vision64 => "Vision64",
            Self::Sensofar => "Sensofar",
            Self::SensofarPlux => "Sensofar PLUX",
            Self::Alicona => "Alicona",
            Self::MetroPro => "MetroPro",
            Self::Sdf => "SDF",
            Self::Nanosurf => "Nanosurf",
            Self::MolecularImaging => "Molecular Imaging",
            Self::Wsxm => "WSxM",
            Self::Frt => "FRT",
            Self::NanoFocus => "NanoFocus",
            Self::ParkTiff => "Park TIFF",
            Self::TrueMap => "TrueMap",
            Self::Bcr => "BCR",
            Self::Keyence => "Keyence",
            Self::Numpy => "NumPy",
            Self::Hdf5 => "HDF5",
            Self::Workbook => "workbook",
            Self::Jpk => "JPK",
            Self::OmniSurf => "OmniSurf3D",
            Self::Zeta => "Zeta",
            Self::MarWin => "MarWin",
            Self::NtMdt => "NT-MDT",
        })
    }
}
