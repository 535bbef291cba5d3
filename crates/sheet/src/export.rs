//! All that a sheet knows, as JSON: what `pforms eval --json` prints.

use pforms_catalogue::{Arithmetic, Language};
use pforms_formula::Address;
use serde_json::{Map, Value as Json, json};

use crate::Sheet;

impl<S: Arithmetic> Sheet<S> {
    /// Every cell as last computed, with the title and the names.
    pub fn to_json(&self, language: Language) -> Json {
        let cells: Map<String, Json> =
            self.addresses().map(|at| (at.to_string(), self.cell_to_json(at, language))).collect();
        let names: Map<String, Json> = self
            .document
            .names()
            .map(|(name, at)| (name.to_owned(), at.to_string().into()))
            .collect();
        let code = match language {
            Language::English => "en",
            Language::French => "fr",
        };
        json!({ "title": self.document.title(code), "names": names, "cells": cells })
    }

    /// One cell: `source`, `kind`, `text`, `value`, `cost`, and `error` when it is one.
    ///
    /// The value is written as [`pforms_catalogue::Value::to_json`] says.
    pub fn cell_to_json(&self, at: Address, language: Language) -> Json {
        let info = self.info(at, language);
        let mut cell = json!({
            "source": info.source,
            "kind": info.kind,
            "text": info.text,
            "value": self.value(at).to_json(),
            "cost": info.cost,
        });
        if let Some(failure) = &info.error {
            cell["error"] = json!({
                "family": failure.family(),
                "message": failure.message(language),
                "hint": failure.hint(language),
                "origin": failure.origin(),
            });
        }
        if info.pending {
            cell["pending"] = true.into();
        }
        cell
    }
}
