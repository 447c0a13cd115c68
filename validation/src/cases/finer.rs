//! Bodies without a closed form, held against themselves on finer lattices: what the lattices of their model converge to.
//!
//! `finer_lattices` (benchmarks-ref) has their answers on three finer lattices, as `coque run` printed them; from these
//!
//! ```text
//! a(h) = a + C hᵖ
//! ```
//!
//! gives a, the truth that is stored nowhere. Where the three show no order between ½ and 4 the finest is taken.

use benchmarks_ref::reference;

use crate::judge::{Case, Headline, Run, Variant};
use crate::{JudgeError, Metric};

/// A body, and its numbers.
struct Body {
    scene: &'static str,
    lattice: &'static str,
    case: &'static str,
    title: &'static str,
    about: &'static str,
    /// Columns at times or levels.
    numbers: &'static [Number],
    reason: &'static str,
}

/// What a column has come by since the start at a time or level.
struct Number {
    name: &'static str,
    column: &'static str,
    at: f64,
    /// How far off it was when this was reviewed \[%\].
    measured: f64,
}

const fn number(name: &'static str, column: &'static str, at: f64, measured: f64) -> Number {
    Number { name, column, at, measured }
}

/// A short cantilever of bonds under its weight.
pub fn stub_of_bonds(method: &'static str) -> Case {
    const BODY: Body = Body {
        scene: include_str!("solid/stub-of-bonds.toml"),
        lattice: "20×10 cells",
        case: "stub-of-bonds",
        title: "A short cantilever of bonds under its weight",
        about: "Plane strain, twice as long as high, weights that are balanced at faces; the clamp has corners, at which strains grow without bound.",
        numbers: &[
            number("down", "down", 1.0, 0.9),
            number("corner", "corner", 1.0, 1.02),
            number("mean way down", "mean", 1.0, 0.25),
        ],
        reason: "a clamp is as wide as a horizon",
    };
    BODY.case(method)
}

/// A plate of bonds with a hole, pulled.
pub fn pulled_hole(method: &'static str) -> Case {
    const BODY: Body = Body {
        scene: include_str!("solid/pulled-hole.toml"),
        lattice: "25×25 cells",
        case: "pulled-hole",
        title: "A plate of bonds with a hole, pulled",
        about: "A quarter of a square plate in plane stress, the hole .4 of its side: its nodes stand on stairs.",
        numbers: &[number("along", "along", 1.0, 0.46), number("across", "across", 1.0, 2.0)],
        reason: "the hole is as large as the nodes that are left tell",
    };
    BODY.case(method)
}

/// A short cantilever without elements.
pub fn stub_solid(method: &'static str) -> Case {
    const BODY: Body = Body {
        scene: include_str!("galerkin/stub-solid.toml"),
        lattice: "12×4×4 cells",
        case: "stub-solid",
        title: "A short cantilever under a load on its upper face",
        about: "Three times as long as high, in space; the clamp has edges, at which strains grow without bound.",
        numbers: &[number("down", "down", 1.0, 1.3), number("along", "along", 1.0, 0.75)],
        reason: "few layers bend stiffly, and the clamp is as sharp as they are",
    };
    BODY.case(method)
}

/// A block pressed between plates that it sticks to.
pub fn pressed_pad(method: &'static str) -> Case {
    const BODY: Body = Body {
        scene: include_str!("galerkin/pressed-pad.toml"),
        lattice: "4×4×4 cells",
        case: "pressed-pad",
        title: "A block pressed by a tenth between plates that it sticks to",
        about: "An eighth of a square block as high as half its side; the plates hold its faces, and its sides bulge.",
        numbers: &[
            number("force at half", "force", 0.5, 0.8),
            number("force", "force", 1.0, 1.04),
            number("bulge at half", "bulge", 0.5, 2.0),
            number("bulge", "bulge", 1.0, 2.7),
        ],
        reason: "strains grow without bound at the edges of the plates",
    };
    BODY.case(method)
}

/// A square column of water in its first .3 s.
pub fn collapsing_column(method: &'static str) -> Case {
    const BODY: Body = Body {
        scene: include_str!("fluid/collapsing-column.toml"),
        lattice: "H/Δx 20",
        case: "collapsing-column",
        title: "A square column of water collapses, its first .3 s",
        about: "Place of its centre, and of its front: before anything breaks, numbers that converge.",
        numbers: &[
            number("way along at .15 s", "x", 0.15, 0.38),
            number("way down at .15 s", "y", 0.15, 2.2),
            number("front at .15 s", "front", 0.15, 21.0),
            number("way along at .3 s", "x", 0.3, 0.95),
            number("way down at .3 s", "y", 0.3, 1.7),
            number("front at .3 s", "front", 0.3, 12.0),
        ],
        reason: "half a spacing of the front, and artificial viscosity",
    };
    BODY.case(method)
}

/// Water beside an elastic wall.
pub fn leaning_wall(method: &'static str) -> Case {
    const BODY: Body = Body {
        scene: include_str!("coupled/leaning-wall.toml"),
        lattice: "H/Δx 16",
        case: "leaning-wall",
        title: "Water let go beside an elastic wall",
        about: "The wall, a strip clamped at its foot, leans and swings back under the water that was at rest; its tip, and the way of the \
                water's centre.",
        numbers: &[
            number("tip at .04 s", "tip", 0.04, 1.4),
            number("tip at .06 s", "tip", 0.06, 4.1),
            number("tip at .08 s", "tip", 0.08, 2.2),
            number("centre of the water at .06 s", "x", 0.06, 0.94),
        ],
        reason: "half a spacing between water and wall",
    };
    BODY.case(method)
}

impl Body {
    fn case(&'static self, method: &'static str) -> Case {
        let variant = Variant::scene(method, self.scene, self.lattice).unsettled().quick();
        Case {
            name: self.case,
            title: self.title,
            about: self.about,
            citation: "reference: the same model on three finer lattices, and their limit",
            variants: vec![variant.judged(|run, _| self.judged(run))],
            headline: Some(Headline::new(self.numbers[0].name, 0.01)),
            ..Case::default()
        }
    }

    fn judged(&self, run: &Run) -> Result<Vec<Metric>, JudgeError> {
        let timed = run.outcome.curve.columns.iter().any(|column| column.name == "time");
        let places = run.column(if timed { "time" } else { "level" })?;
        let metric = |number: &Number| {
            let values = run.column(number.column)?;
            let from = if places.first() == Some(&0.0) { values[0] } else { 0.0 };
            let row = places.iter().position(|place| (place - number.at).abs() < 1e-9);
            let found = Metric::compared(
                number.name,
                row.map(|row| values[row] - from),
                if number.column == "force" { "N" } else { "m" },
                truth(self.case, number)?,
            );
            Ok(found.near(number.measured, self.reason))
        };
        self.numbers.iter().map(metric).collect()
    }
}

/// The limit of the three answers that are stored, in the units of the scene.
fn truth(case: &str, of: &Number) -> Result<f64, JudgeError> {
    let table = reference("finer_lattices")?;
    for row in 0..table.rows.len() {
        let here = table.text(row, "case")? == case && table.text(row, "column")? == of.column;
        if here && (table.number(row, "at")? - of.at).abs() < 1e-9 {
            let mut answers = [[0.0; 2]; 3];
            for (number, answer) in answers.iter_mut().enumerate() {
                *answer = [
                    table.number(row, &format!("spacing {number}"))?,
                    table.number(row, &format!("answer {number}"))?,
                ];
            }
            return Ok(limit(answers));
        }
    }
    Ok(f64::NAN)
}

/// The a of a + C hᵖ through three answers on spacings that fall, p from ½ to 4; else the last answer.
fn limit([[h0, a0], [h1, a1], [h2, a2]]: [[f64; 2]; 3]) -> f64 {
    let ratio = (a0 - a1) / (a1 - a2);
    let power = |h: f64, p: f64| libm::pow(h / h2, p);
    // Grows with p.
    let left = |p: f64| (power(h0, p) - power(h1, p)) / (power(h1, p) - 1.0) - ratio;
    let (mut low, mut high) = (0.5, 4.0);
    if !(left(low) <= 0.0 && left(high) >= 0.0) {
        return a2;
    }
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if left(middle) > 0.0 { high = middle } else { low = middle }
    }
    a2 + (a2 - a1) / (power(h1, low) - 1.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn powers_are_met_and_what_has_no_order_is_its_last() {
        for p in [0.6, 1.0, 2.0, 3.0] {
            for spacings in [[0.5, 0.25, 0.125], [1.0 / 1.5, 0.5, 0.4]] {
                let answers = spacings.map(|h: f64| [h, 3.0 - 0.2 * libm::pow(h, p)]);
                assert!((limit(answers) - 3.0).abs() < 1e-9, "{p}");
            }
        }
        assert_eq!(limit([[0.5, 1.0], [0.25, 1.1], [0.125, 1.05]]), 1.05);
        assert_eq!(limit([[0.5, 1.0], [0.25, 1.1], [0.125, 1.3]]), 1.3);
    }

    #[test]
    fn every_number_has_its_answers() {
        for case in [
            stub_of_bonds("made up"),
            pulled_hole("made up"),
            stub_solid("made up"),
            pressed_pad("made up"),
            collapsing_column("made up"),
            leaning_wall("made up"),
        ] {
            let rows = (0..reference("finer_lattices").unwrap().rows.len())
                .filter(|&row| reference("finer_lattices").unwrap().text(row, "case").unwrap() == case.name);
            assert!(rows.count() >= 2, "{}", case.name);
        }
    }
}
