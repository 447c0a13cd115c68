//! From the parts of a scene to sections of cells: which cell is whose, what it is made of, how high it lies.

use std::collections::BTreeMap;

use shell_kinematics::{Isotropic, StrainMeasure};
use sph_core::{Cloud, Vec3};
use sph_shell::Region;

use super::build::Builder;
use super::cells::CellSets;
use super::heat::isotropic;
use super::imported::Imported;
use super::material::SectionSpec;
use super::sections::Sections;
use crate::bodies::refusal::model_error;
use crate::scene::error::SceneError;
use crate::scene::scope::Scope;
use crate::scene::{Analysis, MaterialSection, ShellScene};

/// Cells of one section.
struct UniformPart {
    /// Group of the file whose section they have.
    group: Option<String>,
    cells: Vec<u32>,
    spec: SectionSpec,
    density: f64,
    height: f64,
    axis: Option<Vec3>,
    strain: &'static dyn StrainMeasure,
}

impl Builder<'_> {
    /// The sections of all cells of a cloud that is not turned yet.
    ///
    /// # Errors
    /// [`SceneError`] for parts without cells, cells in two parts, thicknesses that are not positive, what a file lacks.
    pub(super) fn sections(
        &self,
        cloud: &Cloud,
        sets: &CellSets<'_>,
        imported: Option<&Imported>,
    ) -> Result<Sections, SceneError> {
        let (shell, scope) = (self.scene.shell, self.scene.body_scope());
        if !shell.has_parts() {
            let base = self.section(&self.spec(shell, &scope)?, &scope)?;
            let (density, axis) = (shell.density().unwrap_or_default(), self.material_axis(shell));
            return Ok(Sections {
                base,
                density,
                axis,
                strain: self.strain(shell, &scope)?,
                regions: Vec::new(),
                areal: Vec::new(),
                said: Vec::new(),
            });
        }
        let mut own: Vec<Vec<u32>> = self.owned(cloud, sets, &scope)?;
        let mut all = Vec::new();
        let mut said = Vec::new();
        for (i, part) in shell.parts.iter().enumerate() {
            let (at, cells) = (scope.below(&format!("parts[{i}]")), std::mem::take(&mut own[i + 1]));
            let found = self.uniform(&shell.in_part(i), &at, cells, cloud, imported)?;
            let curvature = part.formulation.as_ref().and_then(|own| own.curvature());
            let curvature = curvature.map(|name| format!(", {name} curvature"));
            let lines = described(&part.on, part.offset, &found).into_iter();
            said.extend(lines.map(|line| line + curvature.as_deref().unwrap_or_default()));
            all.extend(
                found
                    .into_iter()
                    .map(|uniform| UniformPart { height: uniform.height + part.offset, ..uniform }),
            );
        }
        let rest = std::mem::take(&mut own[0]);
        if !rest.is_empty() {
            let found = self.uniform(shell, &scope, rest, cloud, imported)?;
            let lines = described(if shell.parts.is_empty() { "all" } else { "all others" }, 0.0, &found);
            said.splice(0..0, lines);
            all.extend(found);
        }
        let mut areal = vec![0.0; cloud.cells.len()];
        for uniform in &all {
            let by_area = uniform.density * uniform.spec.thickness();
            uniform.cells.iter().for_each(|&cell| areal[cell as usize] = by_area);
        }
        // What most cells on their particles have is the section of the shell; alone, it is the only one.
        let on_particles = all.iter().enumerate().filter(|(_, uniform)| uniform.height == 0.0);
        let most =
            on_particles.max_by_key(|(i, uniform)| (uniform.cells.len(), usize::MAX - i)).map(|(i, _)| i);
        let first = &all[most.unwrap_or_default()];
        let (base, density, axis, strain) =
            (self.section(&first.spec, &scope)?, first.density, first.axis, first.strain);
        if let Some(most) = most {
            all.remove(most);
        }
        let region = |UniformPart { cells, spec, density, height, axis, strain, .. }: UniformPart| {
            let section = self.section(&spec, &scope)?;
            Ok(Region { cells, section: section.into(), density, height, axis, strain: Some(strain) })
        };
        let regions = all.into_iter().map(region).collect::<Result<_, SceneError>>()?;
        Ok(Sections { base, density, axis, strain, regions, areal, said })
    }

    /// Cells of no part, then those of each part.
    pub(super) fn owned(
        &self,
        cloud: &Cloud,
        sets: &CellSets<'_>,
        scope: &Scope<'_>,
    ) -> Result<Vec<Vec<u32>>, SceneError> {
        let parts = &self.scene.shell.parts;
        let mut of_cell = vec![0; cloud.cells.len()];
        for (i, part) in parts.iter().enumerate() {
            let path = scope.path(&format!("parts[{i}].on"));
            for cell in sets.at(&path, &part.on)? {
                let before = std::mem::replace(&mut of_cell[cell as usize], i + 1);
                if before > 0 {
                    let centre = cloud.cells[cell as usize].geometry(&cloud.positions).centroid;
                    let bound = format!(
                        "but the cell at [{:.4}, {:.4}, {:.4}] lies in parts[{}] on \"{}\" too",
                        centre.x,
                        centre.y,
                        centre.z,
                        before - 1,
                        parts[before - 1].on
                    );
                    let value = format!("\"{}\"", part.on);
                    let repair = "let each cell lie in one part: name sets that do not overlap";
                    return Err(SceneError::Set(self.scene.source.fault(&path, &value, &bound, repair)));
                }
            }
        }
        let mut own = vec![Vec::new(); parts.len() + 1];
        (0..).zip(of_cell).for_each(|(cell, part): (u32, usize)| own[part].push(cell));
        Ok(own)
    }

    /// The cells of a part, grouped by thickness and material; one by one where either goes with the place.
    fn uniform(
        &self,
        shell: &ShellScene,
        at: &Scope<'_>,
        cells: Vec<u32>,
        cloud: &Cloud,
        imported: Option<&Imported>,
    ) -> Result<Vec<UniformPart>, SceneError> {
        let density = shell.density().unwrap_or_default();
        let axis = self.material_axis(shell);
        let strain = self.strain(shell, at)?;
        match shell.material_section(at)? {
            MaterialSection::OfFile(..) => self.alike_in_file(shell, at, &cells, imported),
            MaterialSection::Plastic(_, section) | MaterialSection::Rubber(_, section)
                if section.varies() =>
            {
                let thicknesses = self.thicknesses(section, at, &cells, cloud)?;
                let spec = self.spec(shell, at)?;
                let one = |(cell, thickness): (u32, f64)| UniformPart {
                    group: None,
                    cells: vec![cell],
                    spec: spec.with_thickness(thickness),
                    density,
                    height: 0.0,
                    axis,
                    strain,
                };
                Ok(cells.iter().copied().zip(thicknesses).map(one).collect())
            }
            MaterialSection::Homogeneous(elastic, section)
                if section.varies() || elastic.young_values.is_some() || elastic.by_temperature.is_some() =>
            {
                let thickness = self.thicknesses(section, at, &cells, cloud)?;
                let young = self.young(elastic, at, &cells, cloud)?;
                let points = section.gauss_points.as_deref().copied();
                let one = |(cell, (thickness, young)): (u32, (f64, f64))| {
                    let material = self.isotropic_at(young, elastic, at, cell)?;
                    let spec = SectionSpec::Isotropic(material, thickness, points);
                    let cells = vec![cell];
                    Ok(UniformPart { group: None, cells, spec, density, height: 0.0, axis, strain })
                };
                cells.iter().copied().zip(thickness.into_iter().zip(young)).map(one).collect()
            }
            _ => {
                let spec = self.spec(shell, at)?;
                Ok(vec![UniformPart { group: None, cells, spec, density, height: 0.0, axis, strain }])
            }
        }
    }

    /// The same with what the file says of each cell.
    fn alike_in_file(
        &self,
        shell: &ShellScene,
        at: &Scope<'_>,
        cells: &[u32],
        imported: Option<&Imported>,
    ) -> Result<Vec<UniformPart>, SceneError> {
        let key = if shell.density().is_none() { "material.file" } else { "section.file" };
        let refuse = |value: &str, bound: &str, repair: &str| {
            Err(SceneError::Mesh(at.fault(key, value, bound, repair)))
        };
        let MaterialSection::OfFile(elastic, section) = shell.material_section(at)? else {
            return Ok(Vec::new());
        };
        let mut of_sections: BTreeMap<usize, Vec<u32>> = BTreeMap::new();
        let found = |cell: u32| imported.and_then(|imported| imported.section_of(cell));
        for &cell in cells {
            match found(cell) {
                Some((number, ..)) => of_sections.entry(number).or_default().push(cell),
                None => {
                    return refuse(
                        "a cell in no section",
                        "a section for every cell",
                        "name its faces in the file",
                    );
                }
            }
        }
        let mut all = Vec::new();
        let strain = self.strain(shell, at)?;
        for cells in of_sections.into_values() {
            let Some((_, given, material)) = found(cells[0]) else { continue };
            let weighs = self.scene.loads.iter().any(|load| load.gravity.is_some());
            let swings = |analysis: &Analysis| {
                matches!(analysis, Analysis::Explicit(_) | Analysis::Modal(_)) || analysis.swings()
            };
            let needed = weighs || swings(self.scene.analysis);
            let (moduli, density) = match (elastic, material.elastic) {
                (Some(own), _) => (isotropic(own.young.get(), own), own.density.get()),
                (None, None) => {
                    let value = format!("material \"{}\" has no isotropic *Elastic", given.material);
                    return refuse(&value, "Young's modulus and Poisson's ratio", "add them to the file");
                }
                // Where nothing has a mass any density will do.
                (None, Some([young, poisson])) => match material.density {
                    None if !needed => (Isotropic::new(young, poisson), 1.0),
                    Some(density) if density > 0.0 => (Isotropic::new(young, poisson), density),
                    _ => {
                        let value = format!("material \"{}\" has no positive *Density", given.material);
                        return refuse(&value, "one where masses count", "add it to the file");
                    }
                },
            };
            let thickness = section.map_or(given.thickness, |section| section.thickness.get());
            let gauss_points = section.and_then(|section| section.gauss_points.as_deref().copied());
            let spec = moduli.map(|material| SectionSpec::Isotropic(material, thickness, gauss_points));
            let spec =
                spec.map_err(|error| model_error(self.scene.source, &at.path(key), &error.to_string()))?;
            let (group, height) = (Some(given.group.clone()), given.offset * thickness);
            all.push(UniformPart { group, cells, spec, density, height, axis: None, strain });
        }
        Ok(all)
    }
}

/// A part in a line, or in one for each section that the file gives to it.
fn described(name: &str, offset: f64, all: &[UniformPart]) -> Vec<String> {
    if let Some(groups) = all.iter().map(|uniform| uniform.group.as_ref()).collect::<Option<Vec<_>>>() {
        let of = |(group, uniform): (&String, &UniformPart)| {
            line(&format!("{name}, section {group} of the file"), offset, std::slice::from_ref(uniform))
        };
        return groups.into_iter().zip(all).map(of).collect();
    }
    vec![line(name, offset, all)]
}

fn line(name: &str, offset: f64, all: &[UniformPart]) -> String {
    let count: usize = all.iter().map(|uniform| uniform.cells.len()).sum();
    let cells = if count == 1 { "1 cell".to_string() } else { format!("{count} cells") };
    let range = |numbers: &mut dyn Iterator<Item = f64>| {
        numbers.fold([f64::INFINITY, 0.0], |[least, most], t| [least.min(t), f64::max(most, t)])
    };
    let [least, most] = range(&mut all.iter().map(|uniform| uniform.spec.thickness()));
    let thickness = if least == most { format!("{least}") } else { format!("{least:.4e} to {most:.4e}") };
    let [least, most] = range(&mut all.iter().filter_map(|uniform| uniform.spec.young()));
    let young =
        if least < most { format!(", Young's modulus {least:.4e} to {most:.4e}") } else { String::new() };
    let offset = if offset == 0.0 { String::new() } else { format!(", offset {offset}") };
    let law = match all.first().map(|uniform| &uniform.spec) {
        Some(SectionSpec::Plastic(_, _, slices)) => format!(", yields, {slices} slices"),
        Some(SectionSpec::Yielding(plies)) => format!(", {} plies, which yield", plies.len()),
        Some(SectionSpec::Rubber(..)) => ", rubber".into(),
        Some(SectionSpec::Given(..)) => ", of given stiffness".into(),
        _ => String::new(),
    };
    format!("part {name}: {cells}, thickness {thickness}{young}{law}{offset}")
}
