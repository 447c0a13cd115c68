//! Heat that a body conducts, a shell along its mid-surface: what holds its temperature, and what gives it heat.

use explicit_dynamics::Amplitude;
use schemars::JsonSchema;
use serde::Deserialize;
use sph_shell::WetFaces;

use crate::scene::bounded::Positive;

/// What holds temperatures of a shell or of a solid, or gives it heat: exactly one kind is given. It belongs to `analysis.heat`, and to loads whose `temperature` is `conducted`.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct HeatScene {
    /// Particle set, or a list of sets: the union of them. Fluxes by area, films and radiation take its cells, of a solid the faces that lie in it.
    pub on: String,
    /// Temperature at which it is held, by any unit Θ of temperature \[Θ\].
    pub held: Option<f64>,
    /// Heat that enters the set in all: by tributary length on an edge, by area on cells and faces, else equally, of a solid by volume \[F L/T\].
    pub flow: Option<f64>,
    /// Heat that enters by area: of a shell by that of its mid-surface, that of a face, or of a source times the thickness \[F/(L T)\].
    pub flux: Option<f64>,
    /// Heat that enters through an edge of a shell, by area of its cross-section \[F/(L T)\].
    pub edge_flux: Option<f64>,
    /// Heat that comes into being in a solid, by volume \[F/(L² T)\].
    pub source: Option<f64>,
    /// Film between faces of cells and a surrounding of one temperature.
    pub film: Option<Film>,
    /// Radiation from faces of cells to a surrounding of one temperature.
    pub radiation: Option<RadiationScene>,
    /// Course in `[analysis.heat.transient]`, by which the number goes: the temperature or heat that is given, the ambient temperature of a film, that of
    /// what surrounds a face that radiates.
    pub amplitude: Option<Amplitude>,
}

/// Convection: heat enters by the coefficient times area times what the ambient is warmer.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Film {
    /// Film coefficient of a face \[F/(L T Θ)\].
    pub coefficient: Positive,
    /// Ambient temperature \[Θ\].
    pub ambient: f64,
    /// The faces of a shell that have it; left out, both alike.
    pub faces: Option<WetFaces>,
}

/// Radiation of grey faces.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RadiationScene {
    /// Emissivity, one of a black face \[–\].
    pub emissivity: f64,
    /// Constant of Stefan and Boltzmann in the units of the scene, 5.670374419e-8 in newtons, metres, seconds and kelvins \[F/(L T Θ⁴)\].
    pub constant: Positive,
    /// Temperature of what surrounds it \[Θ\].
    pub surroundings: f64,
    /// Absolute zero in the unit of temperature, 0 of kelvins, -273.15 of degrees Celsius \[Θ\].
    pub zero: f64,
    /// The faces of a shell that radiate; left out, both alike.
    pub faces: Option<WetFaces>,
}

impl HeatScene {
    /// Keys of the kinds.
    pub(crate) const WORDS: [&'static str; 7] =
        ["held", "flow", "flux", "edge_flux", "source", "film", "radiation"];

    /// The keys that are given.
    pub(crate) fn given(&self) -> Vec<&'static str> {
        let given = [
            self.held.is_some(),
            self.flow.is_some(),
            self.flux.is_some(),
            self.edge_flux.is_some(),
            self.source.is_some(),
            self.film.is_some(),
            self.radiation.is_some(),
        ];
        Self::WORDS.into_iter().zip(given).filter(|(_, given)| *given).map(|(word, _)| word).collect()
    }

    /// Whether temperatures follow from it: other heat comes whatever they are.
    pub(crate) fn tells(&self) -> bool {
        let radiates = self.radiation.is_some_and(|own| own.emissivity > 0.0);
        self.held.is_some() || self.film.is_some() || radiates
    }
}

/// How many faces of a shell take part.
pub(crate) fn count(faces: Option<WetFaces>) -> f64 {
    if faces.unwrap_or_default() == WetFaces::Both { 2.0 } else { 1.0 }
}

/// Temperatures that a body takes up as it conducts the heat of `[[heat]]`.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Conducted {
    /// Temperature at which the body is free of strain: the change is what the conducted temperature is over it \[Θ\].
    pub over: f64,
}
