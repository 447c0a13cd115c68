//! smooth-box: a slice of bonds between smooth walls, whose modes are those of plane waves.

use crate::judge::{Case, Headline, Run, Variant};
use crate::methods::{PAIRWISE, STATE};
use crate::{JudgeError, Metric};

const SCENE: &str = include_str!("smooth-box.toml");
/// Sides of the slice \[m\]; Young's modulus and density are one.
const SIDES: [f64; 2] = [1.0, 0.75];
/// Modes that are asked for.
const MODES: usize = 4;
const NAMES: [&str; MODES] = ["first frequency", "second frequency", "third frequency", "fourth frequency"];

/// The slice, its closed form, and how far the two may differ.
pub fn case() -> Case {
    Case {
        name: "smooth-box",
        title: "A slice between smooth walls: four modes",
        about: "Plane strain; mirrors on all four sides. Waves of pressure and of shear fit in with whole numbers of half-waves, l and m: \
                f = c/2 √((l/a)² + (m/b)²), of shear with l and m from one on.",
        citation: "closed form: plane waves of the isotropic continuum",
        variants: [
            (PAIRWISE, 0.25, "{ bond-based = { plane = \"strain\" } }"),
            (STATE, 0.3, "{ state-based = { plane = \"strain\" } }"),
        ]
        .into_iter()
        .map(|(method, poisson, formulation)| {
            Variant::scene(method, SCENE, "24×18")
                .set("bodies.block.solid.formulation", formulation)
                .set("bodies.block.solid.material.elastic.poisson", poisson)
                .quick()
                .judged(move |run, _| judged(run, poisson))
        })
        .collect(),
        headline: Some(Headline::new(NAMES[0], 0.01)),
        ..Case::default()
    }
}

/// The least frequencies in order \[1/s\].
fn exact(poisson: f64) -> Vec<f64> {
    let shear = 0.5 / (1.0 + poisson);
    let pressure = 2.0 * shear * (1.0 - poisson) / (1.0 - 2.0 * poisson);
    let number = |l: u8, m: u8| libm::hypot(f64::from(l) / SIDES[0], f64::from(m) / SIDES[1]);
    let mut found = Vec::new();
    for (l, m) in (0..4).flat_map(|l| (0..4).map(move |m| (l, m))).filter(|&both| both != (0, 0)) {
        found.push(0.5 * pressure.sqrt() * number(l, m));
        if l > 0 && m > 0 {
            found.push(0.5 * shear.sqrt() * number(l, m));
        }
    }
    found.sort_by(f64::total_cmp);
    found
}

fn judged(run: &Run, poisson: f64) -> Result<Vec<Metric>, JudgeError> {
    let found = run.column("frequency")?;
    let metric = |(mode, (name, exact)): (usize, (&str, f64))| {
        Metric::compared(name, found.get(mode).copied(), "1/s", exact)
            .near(1.0, "bonds soften waves by the square of the horizon over their length")
    };
    Ok(NAMES.into_iter().zip(exact(poisson)).enumerate().map(metric).collect())
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use super::*;

    #[test]
    fn the_least_mode_is_one_of_shear() {
        let shear = 0.4_f64.sqrt();
        let least = exact(0.25)[0];
        assert!((2.0 * PI * least - shear * PI * libm::hypot(1.0, 1.0 / 0.75)).abs() < 1e-12, "{least}");
        assert!((exact(0.25)[1] - 0.5 * 1.2_f64.sqrt()).abs() < 1e-12);
    }
}
