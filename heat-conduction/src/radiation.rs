//! What a place radiates, and takes up of what its surroundings radiate.

/// A surface that radiates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Radiation {
    /// Emissivity times the constant of Stefan and Boltzmann, of all faces together \[F/(L T Θ⁴)\]; of a place times its area.
    pub factor: f64,
    /// Temperature of what surrounds it \[Θ\].
    pub surroundings: f64,
    /// Absolute zero \[Θ\].
    pub zero: f64,
}

impl Radiation {
    /// Heat that enters at a temperature; below absolute zero, where iterations may come, it goes on as an odd function.
    pub(crate) fn entering(&self, temperature: f64) -> [f64; 2] {
        let power = |t: f64| self.factor * (t - self.zero).powi(3).abs() * (t - self.zero);
        [power(self.surroundings), -power(temperature)]
    }

    /// How much less enters by degree.
    pub(crate) fn slope(&self, temperature: f64) -> f64 {
        4.0 * self.factor * (temperature - self.zero).powi(3).abs()
    }
}
