//! plate-lattice: the thin plate on the lattice that was published for it, two layers of flat cells of bonds.

use crate::judge::{Case, Headline, Outcome, Run, Solver, Variant};
use crate::methods::STATE;
use crate::{JudgeError, Metric};

const PLATE: &str = include_str!("plate-lattice.toml");
const CORRECTION: &str = "bodies.plate.solid.formulation.state-based.correction";
const NAME: &str = "force";
const REFUSED: &str = "refused";
const UNSTABLE: &str = "unstable ways at rest";
/// Force of the flat plate at its shortening, and where it buckles \[kN\]: closed forms.
const PLATE_FORCE: f64 = 123.89;
const CRITICAL: f64 = 6.863;
/// The published force on this lattice \[kN\].
const PUBLISHED: f64 = 131.9;

/// What the lattice gives, and what is refused on it.
pub fn case() -> Case {
    let corrections = ["none", "energy-factor"];
    let mut variants: Vec<Variant> =
        corrections.into_iter().flat_map(|c| [compressed(c), buckled(c)]).collect();
    variants.extend([("even", ""), ("balanced", ", nodes = \"edges\"")].map(|(c, nodes)| refused(c, nodes)));
    Case {
        name: "plate-lattice",
        title: "Thin plate as two layers of 10 × 10 × 1 mm cells of bonds",
        about: "The lattice of the seed paper, horizon 14.2 mm. A bond that the shear across the plate strains is ten times as long \
                along it as across, so that no weights above zero hold extension and shear at once: exact ones (`even`, \
                `balanced`) would take hundreds of unstable ways at rest, and are refused. Weights above zero leave a stable body of \
                another stiffness; two sheets (case plate-stability) are the plate itself.",
        citation: "Timoshenko and Gere 1961; the published 131.9 kN in compression: plate_stability in this project's reference files",
        variants,
        headline: Some(Headline::new(NAME, 0.1)),
        ..Case::default()
    }
}

fn compressed(correction: &'static str) -> Variant {
    let plate = Variant::scene(STATE, PLATE, format!("compressed, {correction}"));
    plate.set(CORRECTION, format!("\"{correction}\"")).judged(|run, _| {
        let force = run.last("force")?.map(|force| 1e-3 * force.abs());
        Ok(vec![
            Metric::error(UNSTABLE, run.last("negative_pivots")?, "-")
                .within(0.0, "weights above zero make a body that resists every motion"),
            Metric::compared(NAME, force, "kN", PLATE_FORCE)
                .shown(format!("beside the plate; published on this lattice {PUBLISHED}, with a calibration that is not given")),
        ])
    })
}

fn buckled(correction: &'static str) -> Variant {
    let plate = Variant::scene(STATE, PLATE, format!("buckling, {correction}"));
    let plate = plate.set(CORRECTION, format!("\"{correction}\"")).set("analysis.buckling.modes", 1);
    plate.judged(move |run, runs| {
        let level = run.column("level")?.first().copied();
        let flat = runs.get(STATE, &format!("compressed, {correction}"))?;
        let flat = flat.map(|flat| flat.last("force")).transpose()?.flatten();
        let force = level.zip(flat).map(|(level, force)| 1e-3 * level * force.abs());
        Ok(vec![Metric::compared("critical force", force, "kN", CRITICAL).shown(
            "the plate's with its sides held; two layers lack bending what they have too much in their plane",
        )])
    })
}

/// The same with exact weights: an error that names the key, and what would be too flat.
fn refused(correction: &'static str, nodes: &'static str) -> Variant {
    Variant::study(STATE, &format!("refused, {correction}"), move || {
        let text = PLATE.replace("energy-factor", correction);
        let text =
            text.replace("spacing = [10.0, 10.0, 1.0]", &format!("spacing = [10.0, 10.0, 1.0]{nodes}"));
        let scene = coque::Scene::parse(&text, "plate-lattice.toml").map_err(|error| error.to_string())?;
        let wide = coque::Rendering { width: 1000, colour: false };
        let said = scene.build(1).err().map(|error| coque::render(&error, wide)).unwrap_or_default();
        let named = ["correction", "too flat", "unstable at rest"].iter().all(|word| said.contains(word));
        Ok(Outcome::row(Solver::Static, &[(REFUSED, "-", f64::from(u8::from(named)))]))
    })
    .quick()
    .judged(|run: &Run, _| -> Result<Vec<Metric>, JudgeError> {
        Ok(vec![
            Metric::compared(REFUSED, run.last(REFUSED)?, "-", 1.0)
                .within(0.0, "the error names the key, the axes and the instability"),
        ])
    })
}
