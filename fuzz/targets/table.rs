//! A table as CSV or JSON, read whole and in blocks, written and read again.
#![no_main]

use std::io::Cursor;

use tables::{Format, InputTable, TableSource};

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    let whole = |bytes: &[u8]| TableSource::new("fuzz", Cursor::new(bytes.to_vec()))?.whole();
    let table = match whole(bytes) {
        Ok(InputTable { table, .. }) => table,
        Err(error) => return fuzz::check_message(&error.to_string(), bytes),
    };
    let mut rows = 0;
    let mut source = TableSource::new("fuzz", Cursor::new(bytes.to_vec())).expect("read before");
    source
        .blocks(2, |block| {
            rows += block.table.rows();
            Ok::<(), tables::TableError>(())
        })
        .expect("read before");
    assert_eq!(rows, table.rows());
    for format in [Format::Csv, Format::Json] {
        let mut written = Vec::new();
        table.write(format, &[], &mut written).expect("memory");
        if table.columns().any(|(name, _)| !name.trim().is_empty()) && table.rows() > 0 {
            let again = whole(&written).expect("a table that was written is read").table;
            assert_eq!(again.rows(), table.rows());
        }
    }
});
