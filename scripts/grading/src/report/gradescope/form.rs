//! The documented form of results.json: every key that may be there, and no other.

use std::collections::BTreeMap;

use serde::Deserialize;
use serde_json::Value;

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
#[expect(dead_code, reason = "a key is there to be allowed")]
pub(crate) struct Results {
    pub(crate) score: Option<f64>,
    execution_time: Option<f64>,
    pub(crate) output: Option<String>,
    visibility: Option<Visibility>,
    stdout_visibility: Option<Visibility>,
    extra_data: Option<BTreeMap<String, Value>>,
    pub(crate) tests: Option<Vec<Test>>,
    leaderboard: Option<Vec<Standing>>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
#[allow(dead_code, reason = "a key is there to be allowed")]
pub(crate) struct Test {
    pub(crate) score: Option<f64>,
    pub(crate) max_score: Option<f64>,
    pub(crate) name: Option<String>,
    number: Option<String>,
    pub(crate) output: Option<String>,
    tags: Option<Vec<String>>,
    visibility: Option<Visibility>,
    extra_data: Option<BTreeMap<String, Value>>,
}

#[derive(Debug, Deserialize)]
#[serde(rename_all = "snake_case")]
enum Visibility {
    Hidden,
    AfterDueDate,
    AfterPublished,
    Visible,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
#[expect(dead_code, reason = "a key is there to be allowed")]
struct Standing {
    name: String,
    value: Value,
    order: Option<String>,
}

impl Results {
    /// Reads such a file, if it is one.
    pub(crate) fn read(value: Value) -> Result<Self, String> {
        let results: Self = serde_json::from_value(value).map_err(|e| e.to_string())?;
        // "Optional, but required if there is no score on each test", and the other way round.
        let tests = results.tests.as_deref().unwrap_or_default();
        if results.score.is_none() && tests.iter().any(|test| test.score.is_none()) {
            return Err("there is neither a score nor one on each test".into());
        }
        Ok(results)
    }
}
