//! What a table of settings may hold so that a file can hold it too.

use pforms_kernel::{Error, Result};
use serde_json::Value;

use crate::Settings;

/// How deep tables and lists of settings may lie in one another.
pub(crate) const DEPTH: usize = 32;

/// Complains about nothingness, whole numbers beyond 64 bits, and depths beyond [`DEPTH`].
pub(crate) fn check_settings(settings: &Settings) -> Result<()> {
    settings.iter().try_for_each(|(key, item)| check(key, item, DEPTH))
}

fn check(key: &str, item: &Value, depth: usize) -> Result<()> {
    let refused = |message: &str| Err(Error::format("settings", None, format!("{key}: {message}")));
    let Some(depth) = depth.checked_sub(1) else {
        return refused("tables and lists lie too deep in one another");
    };
    match item {
        Value::Null => refused("nothing cannot be saved; leave the key out"),
        Value::Number(number) if number.is_u64() && !number.is_i64() => {
            refused("a whole number beyond 64 bits with sign")
        }
        Value::Array(items) => items.iter().try_for_each(|item| check(key, item, depth)),
        Value::Object(entries) => {
            entries.iter().try_for_each(|(key, item)| check(key, item, depth))
        }
        _ => Ok(()),
    }
}
