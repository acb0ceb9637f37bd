//! A list of scans with their options.
#![no_main]

use std::io::Cursor;

use measurements::requests_of_list;
use tables::TableSource;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    let Ok(list) = TableSource::new("fuzz", Cursor::new(bytes.to_vec())).and_then(TableSource::whole) else {
        return;
    };
    match requests_of_list("fuzz", &list) {
        Ok(requests) => assert!(requests.iter().all(|request| !request.path.is_empty())),
        Err(error) => fuzz::check_message(&error.to_string(), bytes),
    }
});
