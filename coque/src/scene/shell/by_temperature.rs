//! How the numbers of a material go with the temperature, as a scene says it.

use explicit_dynamics::Amplitude;
use schemars::JsonSchema;
use serde::Deserialize;

/// Numbers of an elastic material by tables over the temperature, straight lines between `[temperature, factor]` \[Θ, –\]: in a cell that of its temperature once
/// all loads are there in full, at any level.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ByTemperature {
    /// Temperature at which the material is free of strain: from it on count the changes of loads \[Θ\].
    pub reference: f64,
    /// Factors of `young`.
    pub young: Option<Vec<[f64; 2]>>,
    /// Factors of `poisson`.
    pub poisson: Option<Vec<[f64; 2]>>,
    /// Factors of `expansion`, the mean one between `reference` and the temperature (the secant).
    pub expansion: Option<Vec<[f64; 2]>>,
    /// Factors of `conductivity`, in a cell that of its temperature as heat runs.
    pub conductivity: Option<Vec<[f64; 2]>>,
}

impl ByTemperature {
    /// The tables that are given, by the names of their keys.
    pub(crate) fn tables(&self) -> impl Iterator<Item = (&'static str, &[[f64; 2]])> {
        let tables = [
            ("young", &self.young),
            ("poisson", &self.poisson),
            ("expansion", &self.expansion),
            ("conductivity", &self.conductivity),
        ];
        tables.into_iter().filter_map(|(key, table)| Some((key, table.as_deref()?)))
    }

    /// Factors of Young's modulus, of Poisson's ratio and of the expansion at a temperature \[–\]; none beyond the ends of a table, with its key.
    pub(crate) fn factors(&self, temperature: f64) -> Result<[f64; 3], &'static str> {
        let of = |table: &Option<Vec<[f64; 2]>>, key| {
            table.as_ref().map_or(Ok(1.0), |table| between(table, temperature).ok_or(key))
        };
        Ok([of(&self.young, "young")?, of(&self.poisson, "poisson")?, of(&self.expansion, "expansion")?])
    }
}

/// The number of a table on its straight lines; none beyond its ends.
fn between(table: &[[f64; 2]], at: f64) -> Option<f64> {
    let (first, last) = (table.first()?, table.last()?);
    (first[0] <= at && at <= last[0]).then(|| Amplitude::along(table, at))
}
