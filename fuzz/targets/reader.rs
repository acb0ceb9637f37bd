//! A file of any format that is read as it is. Which reader sees it, the inputs decide that the search starts from: formats are
//! told by their content.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| fuzz::read(bytes));
