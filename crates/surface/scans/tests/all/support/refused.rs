//! Errors by their kind and their data.

/// Asserts the kind of an error, and some of its fields.
macro_rules! refused {
    ($error:expr, Measurement { measurement: $name:expr, source: $kind:ident $fields:tt }) => {
        match &$error {
            scans::ScanReadError::Measurement { measurement, source, .. } => {
                assert_eq!(*measurement, $name);
                refused!(**source, $kind $fields);
            }
            other => panic!("{other:?}"),
        }
    };
    ($error:expr, Scan($kind:ident { $($field:ident: $value:expr),* $(,)? })) => {
        match &$error {
            scans::ScanReadError::Scan(scans::ScanError::$kind { $($field,)* .. }) => {
                $(assert_eq!(*$field, $value);)*
            }
            other => panic!("{other:?}"),
        }
    };
    ($error:expr, $kind:ident { $($field:ident: $value:expr),* $(,)? }) => {
        match &$error {
            scans::ScanReadError::$kind { $($field,)* .. } => {
                $(assert_eq!(*$field, $value);)*
            }
            other => panic!("{other:?}"),
        }
    };
}
