//! Checks of materials that yield: their numbers, and the methods and analyses that have them.

use crate::scene::analysis::Analysis;
use crate::scene::body_in_scene::BodyInScene;
use crate::scene::check::shell::material::check_poisson;
use crate::scene::error::{SceneError, Verdict};
use crate::scene::scope::Scope;
use crate::scene::shell::ShellScene;
use crate::scene::shell::formulation::{Formulation, Reach};
use crate::scene::shell::material::Section;
use crate::scene::shell::plastic::{Hardening, Plastic};

impl ShellScene {
    /// The numbers of a material that yields, and of the section beside it.
    pub(super) fn check_plastic_material(&self, plastic: &Plastic, s: &Scope<'_>) -> Verdict {
        check_poisson("material.plastic.poisson", plastic.poisson, s)?;
        if let Hardening::Table(rows) = &plastic.hardening {
            check_table(rows, s)?;
        }
        let Section::Homogeneous(section) = &self.section else { return Ok(()) };
        let refuse = |key: &str, value: &str, bound: &str, repair: &str| {
            Err(SceneError::Choice(s.fault(&format!("section.homogeneous.{key}"), value, bound, repair)))
        };
        if section.gauss_points.is_some() {
            let repair = "give `slices` in its place: 6 are usual";
            return refuse("gauss-points", "Gauss points", "none of a material that yields", repair);
        }
        if section.varies() {
            let key = match (&section.taper, &section.table) {
                (Some(_), _) => "taper",
                (_, Some(_)) => "table",
                _ => "values",
            };
            let bound = "one thickness of a material that yields";
            return refuse(key, "a thickness that varies", bound, "remove it");
        }
        Ok(())
    }
}

/// A table of hardening begins at zero, rises in its strains and does not fall in its stresses.
fn check_table(rows: &[[f64; 2]], s: &Scope<'_>) -> Verdict {
    let path = "material.plastic.hardening.table";
    if rows.len() < 2 {
        let repair = "give at least two rows: [[0, 248], [0.1, 320]]";
        return Err(s.value(path, format!("{} rows", rows.len()), "two rows or more", repair));
    }
    for (i, &[strain, stress]) in rows.iter().enumerate() {
        let at = |column: usize| format!("{path}[{i}][{column}]");
        s.sized_all(&format!("{path}[{i}]"), &[strain, stress])?;
        let [least, weakest] = i.checked_sub(1).map_or([0.0, 0.0], |before| rows[before]);
        if i == 0 && strain != 0.0 {
            let repair = "the first row is the stress at which it begins to flow";
            return Err(s.value(&at(0), strain, "zero in the first row", repair));
        }
        if i > 0 && strain <= least {
            let bound = format!("above {least}, the strain of the row before");
            return Err(s.value(&at(0), strain, &bound, "order the rows by their strain"));
        }
        if stress <= 0.0 || stress < weakest {
            let bound = if i == 0 {
                "positive".into()
            } else {
                format!("at least {weakest}, that of the row before")
            };
            let repair = "a stress that falls has no length in which it does: give a hardening curve";
            return Err(s.value(&at(1), stress, &bound, repair));
        }
    }
    Ok(())
}

/// Refuses a material that yields where nothing keeps what its points went through.
pub(super) fn check_plastic(scene: &BodyInScene<'_>, shell: &ShellScene, s: &Scope<'_>) -> Verdict {
    let in_parts = (0..shell.parts.len()).find(|part| shell.in_part(*part).material.yields());
    if !shell.material.yields() && in_parts.is_none() {
        return Ok(());
    }
    let yields = "a material that yields";
    let refuse = |path: &str, value: &str, bound: &str, repair: &str| {
        Err(SceneError::Choice(s.fault(path, value, bound, repair)))
    };
    if shell.has_parts() {
        let (bound, repair) = ("none beside it", "give the whole shell one material and one section");
        return match in_parts {
            Some(part) => {
                refuse(&format!("parts[{part}].material.plastic"), yields, "none in a part", repair)
            }
            None => refuse(shell.key_of_parts(), "sections of their own in cells", bound, repair),
        };
    }
    if !matches!(&shell.formulation, Formulation::StressPoint(f) if f.support == Reach::Cell) {
        let bound = "none but where strains are sampled in cells";
        let repair = "use [formulation.stress-point] without `support`, the default";
        return refuse("material.plastic", yields, bound, repair);
    }
    if shell.curvature() != "logarithmic" {
        let (value, bound) =
            (format!("\"{}\"", shell.curvature()), "\"logarithmic\" where a material yields");
        return refuse(
            "formulation.stress-point.curvature",
            &value,
            bound,
            "remove it, or write \"logarithmic\"",
        );
    }
    if !shell.initial_stress.is_empty() {
        let bound = "none in a material that yields";
        return refuse(
            "initial_stress[0]",
            "an initial stress",
            bound,
            "remove it, or make the material elastic",
        );
    }
    if matches!(scene.analysis, Analysis::Linear(_) | Analysis::Buckling(_)) {
        let bound =
            format!("none in {}, which takes the material as it is at rest", scene.analysis.kind().name);
        let repair = "use [analysis.static], [analysis.arc-length] or a march, or [material.elastic]";
        return refuse("material.plastic", yields, &bound, repair);
    }
    Ok(())
}
