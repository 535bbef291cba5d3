//! pforms for the browser: the headless sheet behind typed messages.

use wasm_bindgen::prelude::wasm_bindgen;

/// The version of pforms that this module was built from.
#[wasm_bindgen]
pub fn version() -> String {
    env!("CARGO_PKG_VERSION").to_owned()
}
