//! Arrays in packed blocks, in any order.

use super::FORMAT;
use super::entry::Entry;
use crate::error::ScanReadError;
use crate::inflate::{StreamPlace, inflated};
use crate::room::Room;

/// The bytes of an array.
pub(super) struct Array {
    pub(super) bytes: Vec<u8>,
    pub(super) element_bytes: usize,
}

struct Block<'b> {
    /// The first of its elements.
    first: u64,
    elements: usize,
    packed: &'b [u8],
    offset: usize,
}

/// Unpacks an array of so many elements, each of one of these numbers of bytes.
pub(super) fn array(
    entry: &Entry,
    elements: usize,
    element_bytes: &[usize],
    room: &mut Room,
) -> Result<Array, ScanReadError> {
    let count = entry.required(&[1])?;
    let data = entry.required(&[2])?;
    let mut cursor = data.cursor();
    let found = count.u32("the number of elements of an array")?;
    if usize::try_from(found) != Ok(elements) {
        let field = "the number of elements of an array";
        return Err(cursor.bad(count.offset, field, found, &format!("that of its points, {elements}")));
    }
    let total = cursor.u64("the length of an array")?;
    let is_total =
        |bytes: &&usize| elements.checked_mul(**bytes).and_then(|all| u64::try_from(all).ok()) == Some(total);
    let element_bytes = *element_bytes.iter().find(is_total).ok_or_else(|| {
        let bound = format!("{elements} elements of {element_bytes:?} bytes");
        cursor.bad(data.offset, "the length of an array", total, &bound)
    })?;
    room.take(total, || "an array".to_owned())?;
    let mut blocks = Vec::new();
    while !cursor.rest().is_empty() {
        let offset = cursor.at;
        let first = cursor.u64("the first element of a block")?;
        let elements = cursor.u32("the number of elements of a block")? as usize;
        let packed_bytes = cursor.u32("the packed length of a block")? as usize;
        blocks.push(Block { first, elements, packed: cursor.take(packed_bytes, "a packed block")?, offset });
    }
    blocks.sort_by_key(|block| block.first);
    let mut bytes = Vec::new();
    for block in blocks {
        let next = bytes.len() / element_bytes;
        if usize::try_from(block.first) != Ok(next) || block.elements > elements - next {
            let value = format!("{} elements from {} on", block.elements, block.first);
            let bound = format!("elements from {next} on, at most {}", elements - next);
            return Err(cursor.bad(block.offset, "a block of an array", &value, &bound));
        }
        let place = StreamPlace { format: FORMAT, offset: block.offset };
        bytes.extend(inflated(&place, block.packed, block.elements * element_bytes)?);
    }
    Ok(Array { bytes, element_bytes })
}
