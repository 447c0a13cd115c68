//! Heat so great that strains are no longer small, and numbers that are not those of the heat at a level.

use super::look::Look;
use crate::scene::{Analysis, Material, Section, ShellScene, Temperature};

/// Strain of a free fibre beyond which lengths grow by more than two percent less than αθ: √(1 + 2αθ) is 1 + αθ (1 − αθ/2).
const LARGE: f64 = 0.04;

/// A change of temperature by which what is free would strain by more than that.
pub(super) fn hot(look: &Look<'_>) -> Option<String> {
    let scene = look.scene?;
    let change = |Temperature { change, difference, values, .. }: &Temperature| {
        let size = |of: &Option<f64>| of.unwrap_or_default().abs();
        let numbers = values.as_ref().and_then(|name| scene.scene.arrays.get(name));
        let most = numbers.map_or(1.0, |all| all.iter().fold(0.0_f64, |most, x| most.max(x.abs())));
        most * (size(change) + 0.5 * size(difference))
    };
    let changes = scene.loads.iter().filter_map(|load| load.temperature.as_ref()).map(change);
    let greatest = changes.fold(0.0, f64::max);
    let shell = scene.shell;
    let parts = (0..shell.parts.len()).map(|part| shell.in_part(part)).chain([shell.clone()]);
    let strain = greatest * parts.map(|part| expansion(&part)).fold(0.0, f64::max);
    (strain > LARGE).then(|| {
        format!(
            "free, the shell would strain by {strain:.2} as it is heated, at most {LARGE} of them is a small strain, by which `expansion` is meant: mind \
             the units of `expansion` and `temperature`"
        )
    })
}

/// A level sought of loads that heat, where moduli or expansions go with the temperature: they are made once, of the whole heat.
pub(super) fn whole(look: &Look<'_>) -> Option<String> {
    let scene = look.scene?;
    let sought = matches!(scene.analysis, Analysis::Buckling(_) | Analysis::ArcLength(_));
    let heats = scene.loads.iter().any(|load| load.temperature.is_some() && !load.preload);
    let shell = scene.shell;
    let parts = (0..shell.parts.len()).map(|part| shell.in_part(part)).chain([shell.clone()]);
    let mut tabled = parts.map(|part| match part.material {
        Material::Elastic(elastic) => elastic
            .by_temperature
            .is_some_and(|own| own.young.is_some() || own.poisson.is_some() || own.expansion.is_some()),
        _ => false,
    });
    (sought && heats && tabled.any(|tabled| tabled)).then(|| {
        "numbers by temperature are those of the whole change at every level: a level is right where it is 1; scale the change of temperature until it is".into()
    })
}

/// Greatest coefficient of expansion of a shell without parts.
fn expansion(shell: &ShellScene) -> f64 {
    let of = |material: &Material| match material {
        Material::Elastic(own) => own.expansion.map_or(0.0, f64::abs),
        Material::Orthotropic(own) => {
            own.expansion.map_or(0.0, |[along, across]| along.abs().max(across.abs()))
        }
        Material::Plastic(_) | Material::Rubber(_) | Material::Smeared(_) | Material::File(_) => 0.0,
    };
    match &shell.section {
        Section::Layered(plies) => plies.materials(&shell.material).map(of).fold(0.0, f64::max),
        Section::Homogeneous(_) | Section::Stiffness(_) | Section::File(_) => of(&shell.material),
    }
}
