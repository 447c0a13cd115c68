//! Checks of parts: what each has of its own, and whether strains are sampled in cells.

use super::initial_stress::check_initial_stress;
use super::own_law::check_own_law;
use super::rigid::check_rigid;
use super::stiffeners::check_stiffeners;
use crate::scene::body_in_scene::BodyInScene;
use crate::scene::check::sets::check_set_name;
use crate::scene::error::{SceneError, Verdict};
use crate::scene::scope::Scope;
use crate::scene::shell::ShellScene;
use crate::scene::shell::formulation::{Formulation, Reach};
use crate::scene::shell::material::Material;
use crate::scene::shell::parts::{LumpedMass, PartFormulation, ShellTie};
use crate::scene::shell::section::Section;

impl ShellScene {
    /// Whether sections may differ from cell to cell.
    pub(crate) fn has_parts(&self) -> bool {
        let tapered = matches!(&self.section, Section::Homogeneous(section) if section.varies());
        tapered
            || self.young_varies()
            || self.goes_with_temperature()
            || !self.parts.is_empty()
            || self.takes_from_file()
    }

    /// Whether material or section stand in the file of the mesh.
    pub(crate) fn takes_from_file(&self) -> bool {
        self.density().is_none() || self.section.thickness().is_none()
    }

    /// Whether Young's modulus differs from cell to cell.
    fn young_varies(&self) -> bool {
        matches!(&self.material, Material::Elastic(elastic) if elastic.young_values.is_some())
    }

    /// Whether numbers of its material go with the temperature.
    fn goes_with_temperature(&self) -> bool {
        matches!(&self.material, Material::Elastic(elastic) if elastic.by_temperature.is_some())
    }

    /// Key of what makes sections differ, of the first.
    pub(super) fn key_of_parts(&self) -> &'static str {
        if !self.parts.is_empty() {
            "parts[0]"
        } else if self.takes_from_file() {
            if self.section.thickness().is_none() { "section.file" } else { "material.file" }
        } else if self.young_varies() {
            "material.elastic.young-values"
        } else if self.goes_with_temperature() {
            "material.elastic.by_temperature"
        } else {
            match &self.section {
                Section::Homogeneous(section) if section.values.is_some() => "section.homogeneous.values",
                Section::Homogeneous(section) if section.table.is_some() => "section.homogeneous.table",
                _ => "section.homogeneous.taper",
            }
        }
    }

    /// The shell as it is in one of its parts.
    pub(crate) fn in_part(&self, number: usize) -> Self {
        let mut own = self.clone();
        if let Some(part) = self.parts.get(number) {
            own.material = part.material.clone().unwrap_or(own.material);
            own.section = part.section.clone().unwrap_or(own.section);
            let curvature = part.formulation.as_ref().and_then(|formulation| formulation.curvature());
            if let (Formulation::StressPoint(points), Some(curvature)) = (&mut own.formulation, curvature) {
                points.curvature = Some(curvature.into());
            }
        }
        own.parts = Vec::new();
        own
    }
}

/// A part has the curvature of its cells for itself; stencils tie particles across its border.
fn check_formulation_of_part(formulation: &PartFormulation, own: &Scope<'_>) -> Verdict {
    if let Some(key) = formulation.of_whole_shell() {
        let bound = "none in a part: it makes the neighbours of a particle, which has one list of them on both sides of a border";
        let repair =
            "give the part formulation.stress-point.curvature alone, or the whole shell its sampling";
        let fault = own.fault(&format!("formulation.{key}"), "a sampling of its own", bound, repair);
        return Err(SceneError::Choice(fault));
    }
    let measures = shell_kinematics::strain_measures().map(|measure| measure.name());
    let curvature = formulation.curvature().unwrap_or(measures[0]);
    own.word("formulation.stress-point.curvature", curvature, &measures)
}

/// Refuses masses that are none, parts without anything of their own, numbers out of bounds, and parts where there are no cells or a fluid.
pub(in crate::scene::check) fn check_parts(
    scene: &BodyInScene<'_>,
    shell: &ShellScene,
    s: &Scope<'_>,
) -> Verdict {
    for (i, LumpedMass { on, .. }) in shell.masses.iter().enumerate() {
        let own = s.below(&format!("masses[{i}]"));
        check_set_name(scene, &own.path("on"), on)?;
    }
    check_ties(scene, shell, s)?;
    check_stiffeners(scene, shell, s)?;
    check_rigid(scene, shell, s)?;
    check_initial_stress(scene, shell, s)?;
    check_own_law(scene, shell, s)?;
    if !shell.has_parts() {
        return Ok(());
    }
    let refuse = |found: &str, bound: &str, repair: &str| {
        Err(SceneError::Choice(s.fault(shell.key_of_parts(), found, bound, repair)))
    };
    let several = "sections of their own in cells";
    if !matches!(&shell.formulation, Formulation::StressPoint(f) if f.support == Reach::Cell) {
        let bound = "none but where strains are sampled in cells";
        return refuse(several, bound, "use [formulation.stress-point] without `support`, the default");
    }
    if scene.in_fluid {
        return refuse(several, "none in a fluid", "give the shell one material and one thickness");
    }
    for (i, part) in shell.parts.iter().enumerate() {
        let own = s.below(&format!("parts[{i}]"));
        check_set_name(scene, &own.path("on"), &part.on)?;
        if let Some(formulation) = &part.formulation {
            check_formulation_of_part(formulation, &own)?;
        }
        let curvature = part.formulation.as_ref().and_then(|formulation| formulation.curvature());
        let nothing = part.material.is_none() && part.section.is_none() && curvature.is_none();
        if nothing && part.offset == 0.0 {
            let repair = "give the part a material, a section, an offset or a formulation, or remove it";
            let (path, bound) = (format!("parts[{i}]"), "`material`, `section`, `offset` or `formulation`");
            return Err(SceneError::Choice(s.fault(&path, "nothing of its own", bound, repair)));
        }
        own.sized("offset", part.offset)?;
        shell.in_part(i).check_material(&own)?;
    }
    Ok(())
}

/// Refuses ties of names that are no sets, where there are no cells, and in a fluid.
fn check_ties(scene: &BodyInScene<'_>, shell: &ShellScene, s: &Scope<'_>) -> Verdict {
    for (i, ShellTie { edge, to }) in shell.ties.iter().enumerate() {
        let own = s.below(&format!("ties[{i}]"));
        check_set_name(scene, &own.path("edge"), edge)?;
        check_set_name(scene, &own.path("to"), to)?;
    }
    if shell.ties.is_empty() {
        return Ok(());
    }
    let refuse =
        |bound: &str, repair: &str| Err(SceneError::Choice(s.fault("ties[0]", "a tie", bound, repair)));
    if !matches!(&shell.formulation, Formulation::StressPoint(f) if f.support == Reach::Cell) {
        let bound = "none but where strains are sampled in cells";
        return refuse(bound, "use [formulation.stress-point] without `support`, the default");
    }
    if scene.in_fluid {
        return refuse("none in a fluid", "mesh the shell so that its sheets share nodes where they meet");
    }
    Ok(())
}
