//! Checks of materials that yield and of rubber: their numbers, and the methods and analyses that have them.

use shell_kinematics::MOST_BACK_STRESSES;

use crate::scene::analysis::Analysis;
use crate::scene::body_in_scene::BodyInScene;
use crate::scene::check::shell::material::check_poisson;
use crate::scene::error::{SceneError, Verdict};
use crate::scene::scope::Scope;
use crate::scene::shell::ShellScene;
use crate::scene::shell::formulation::{Formulation, Reach};
use crate::scene::shell::plastic::{Hardening, Plastic, Rate};
use crate::scene::shell::plies::Ply;
use crate::scene::shell::rubber::{Rubber, RubberLaw};
use crate::scene::shell::section::Section;

impl ShellScene {
    /// The numbers of a material that yields, and of the section beside it.
    pub(super) fn check_plastic_material(&self, plastic: &Plastic, s: &Scope<'_>) -> Verdict {
        check_plastic(plastic, s)?;
        if let Some(anisotropy) = &plastic.anisotropy {
            s.direction("material.plastic.anisotropy.axis", anisotropy.axis)?;
        }
        self.check_own_section("a material that yields", "give `slices` in its place: 6 are usual", s)
    }

    /// The rows of rubber, and the section beside it.
    pub(super) fn check_rubber_material(&self, rubber: &Rubber, s: &Scope<'_>) -> Verdict {
        if let RubberLaw::Ogden(rows) = &rubber.law {
            let path = "material.rubber.law.ogden";
            if rows.is_empty() {
                return Err(s.value(path, "empty", "rows of μ and α", "give at least one: [[1.0, 2.0]]"));
            }
            for (i, row) in rows.iter().enumerate() {
                s.sized_all(&format!("{path}[{i}]"), row)?;
                if row[0] * row[1] <= 0.0 {
                    let repair = "give μ the sign of α";
                    return Err(s.value(
                        &format!("{path}[{i}]"),
                        row[0] * row[1],
                        "a positive product μ α",
                        repair,
                    ));
                }
            }
        }
        self.check_own_section("rubber", "remove it: rubber has three", s)
    }

    /// None of the Gauss points of an elastic material.
    fn check_own_section(&self, of: &str, without: &str, s: &Scope<'_>) -> Verdict {
        let Section::Homogeneous(section) = &self.section else { return Ok(()) };
        if section.gauss_points.is_some() {
            let (path, bound) = ("section.homogeneous.gauss_points", format!("none of {of}"));
            return Err(SceneError::Choice(s.fault(path, "Gauss points", &bound, without)));
        }
        Ok(())
    }
}

/// The numbers of a material that yields, of a shell or a solid.
pub(in crate::scene::check) fn check_plastic(plastic: &Plastic, s: &Scope<'_>) -> Verdict {
    check_poisson("material.plastic.poisson", plastic.poisson, s)?;
    if let Some(Rate::CowperSymonds(law)) = &plastic.rate {
        let (path, exponent) = ("material.plastic.rate.cowper-symonds.exponent", law.exponent.get());
        if exponent < 1.0 {
            return Err(s.value(path, exponent, "at least 1", "it is the p of (ε̇/D)^(1/p), 5 of mild steel"));
        }
    }
    if plastic.back_stresses.len() > MOST_BACK_STRESSES {
        let (path, many) = ("material.plastic.back-stresses", plastic.back_stresses.len());
        return Err(s.value(
            path,
            format!("{many} back stresses"),
            "three at most",
            "two or three are usual",
        ));
    }
    match &plastic.hardening {
        Hardening::Table(rows) => check_table(rows, s),
        _ => Ok(()),
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

/// Refuses materials with a law of their own, of the shell or of a part, where it does not hold: one that yields where nothing keeps what its points went
/// through.
pub(super) fn check_own_law(scene: &BodyInScene<'_>, shell: &ShellScene, s: &Scope<'_>) -> Verdict {
    check_law_of(scene, shell, "", s)?;
    for i in 0..shell.parts.len() {
        check_law_of(scene, &shell.in_part(i), &format!("parts[{i}]."), s)?;
    }
    Ok(())
}

/// The same for one of them, whose material stands below a key.
fn check_law_of(scene: &BodyInScene<'_>, shell: &ShellScene, below: &str, s: &Scope<'_>) -> Verdict {
    let Some(measure) = shell.measure_of_law() else { return Ok(()) };
    let (own, word) = law_of(shell);
    let refuse = |path: &str, value: &str, bound: &str, repair: &str| {
        Err(SceneError::Choice(s.fault(path, value, bound, repair)))
    };
    let (path, of) = (format!("{below}{own}material.{word}"), format!("[material.{word}]"));
    if !matches!(&shell.formulation, Formulation::StressPoint(f) if f.support == Reach::Cell) {
        let bound = "none but where strains are sampled in cells";
        let repair = "use [formulation.stress-point] without `support`, the default";
        return refuse(&path, &of, bound, repair);
    }
    if shell.curvature() != measure {
        let (value, bound) = (format!("\"{}\"", shell.curvature()), format!("\"{measure}\" beside {of}"));
        let repair = if below.is_empty() {
            format!("remove it, or write \"{measure}\"")
        } else {
            format!("give the part formulation.stress-point.curvature = \"{measure}\"")
        };
        return refuse(&path_of_curvature(scene, below), &value, &bound, &repair);
    }
    if !shell.initial_stress.is_empty() {
        let (bound, repair) = (format!("none in {of}"), "remove it, or make the material elastic");
        return refuse("initial_stress[0]", "an initial stress", &bound, repair);
    }
    let at_rest =
        matches!(scene.analysis, Analysis::Linear(_) | Analysis::Buckling(_)) || scene.analysis.swings();
    if shell.yields_itself() && at_rest {
        let bound =
            format!("none in {}, which takes the material as it is at rest", scene.analysis.kind().name);
        let repair = "use [analysis.static], [analysis.arc-length] or a march, or [material.elastic]";
        return refuse(&path, &of, &bound, repair);
    }
    if let Some(ply) = shell.rated()
        && !scene.analysis.kind().passes_time
    {
        let of_ply = ply.map_or_else(String::new, |number| format!("section.layered.plies[{number}]."));
        let bound = format!("none in {}, whose steps take no real time", scene.analysis.kind().name);
        let repair = "remove it, or use [analysis.explicit.transient]";
        return refuse(&format!("{below}{of_ply}material.plastic.rate"), "a law of rates", &bound, repair);
    }
    Ok(())
}

/// The path to the first material with a law of its own, and the word of it.
fn law_of(shell: &ShellScene) -> (String, &'static str) {
    let own = shell.material.word();
    let Section::Layered(section) = &shell.section else { return (String::new(), own) };
    let has_law = |ply: &Ply| ply.material.as_ref().is_some_and(|own| own.curvature().is_some());
    match section.plies.iter().position(has_law) {
        Some(number) if shell.material.curvature().is_none() => {
            let of_ply = section.plies[number].material(&shell.material);
            (format!("section.layered.plies[{number}]."), of_ply.word())
        }
        _ => (String::new(), own),
    }
}

/// Where the strain measure stands: with the part, if it has one of its own, else with the shell.
fn path_of_curvature(scene: &BodyInScene<'_>, below: &str) -> String {
    let own = scene.as_shell().is_some_and(|shell| {
        (0..shell.parts.len()).any(|i| {
            below == format!("parts[{i}].")
                && shell.parts[i].formulation.as_ref().is_some_and(|own| own.curvature().is_some())
        })
    });
    format!("{}formulation.stress-point.curvature", if own { below } else { "" })
}
