//! Heights as NumPy arrays, which keep every digit.

/// Bytes of a file: a line, or a map with `columns` points per row.
pub(crate) fn array(heights_m: &[f64], columns: usize) -> Vec<u8> {
    let rows = heights_m.len() / columns;
    let shape = if rows == 1 { format!("({columns},)") } else { format!("({rows}, {columns})") };
    let header = format!("{{'descr': '<f8', 'fortran_order': False, 'shape': {shape}, }}\n");
    let mut bytes = b"\x93NUMPY\x01\x00".to_vec();
    bytes.extend((header.len() as u16).to_le_bytes());
    bytes.extend(header.as_bytes());
    bytes.extend(heights_m.iter().flat_map(|height_m| height_m.to_le_bytes()));
    bytes
}
