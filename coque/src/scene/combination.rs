//! Combinations of load cases.

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::Deserialize;

/// Load cases that act at once, each times a factor.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Combination {
    /// Its name, other than that of any case.
    pub name: String,
    /// Factor of each case, by its name; cases that are not named do not act \[–\].
    pub of: BTreeMap<String, f64>,
    /// Of steady vibration, by how much each case is ahead of those that are not named here \[degrees\].
    #[serde(default)]
    pub phases: BTreeMap<String, f64>,
}
