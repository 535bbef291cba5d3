//! The messages of the kernel's family of errors in French.

use pforms_kernel::{Error, Fault, Place, limit};

/// The message of an error; what the caller wrote and numbers stay as they are.
pub(crate) fn of_error(error: &Error) -> String {
    match error {
        Error::Shape(fault)
        | Error::Domain(fault)
        | Error::Degenerate(fault)
        | Error::Accuracy(fault) => of_fault(fault),
        Error::Format { what, place: Some(Place { line, column }), message } => {
            format!("{what}, ligne {line}, colonne {column} : {message}")
        }
        Error::Format { what, message, .. } => format!("{what} : {message}"),
        Error::Limit { what, bytes, cap } => format!(
            "{what}, {} : refusé, le plafond est {}",
            limit::readable(*bytes),
            limit::readable(*cap)
        ),
    }
}

fn of_fault(fault: &Fault) -> String {
    format!("{} : reçu {}, attendu {}", fault.argument, fault.received, fault.expected)
}
