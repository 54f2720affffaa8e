//! The documented form of results.json, as far as it is used here: these keys, and no other.

use std::collections::BTreeMap;

use serde::Deserialize;
use serde_json::Value;

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
#[expect(dead_code, reason = "a key is there to be allowed")]
pub(crate) struct Results {
    pub(crate) score: f64,
    pub(crate) output: String,
    output_format: Format,
    stdout_visibility: Visibility,
    extra_data: BTreeMap<String, Value>,
    pub(crate) tests: Vec<Test>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
#[allow(dead_code, reason = "a key is there to be allowed")]
pub(crate) struct Test {
    pub(crate) score: f64,
    pub(crate) max_score: f64,
    pub(crate) name: String,
    number: Option<String>,
    pub(crate) output: String,
}

#[derive(Debug, Deserialize)]
#[serde(rename_all = "snake_case")]
enum Format {
    Md,
}

#[derive(Debug, Deserialize)]
#[serde(rename_all = "snake_case")]
enum Visibility {
    Hidden,
}
