//! `*Shell Section` and `*Material` of Abaqus input: homogeneous sections of isotropic elastic materials.
//!
//! What is given in another way (composites, offsets by name of a field, materials with axes) is passed over with a note: a
//! surface can be read without it, and a scene that asks for it misses it by name.

use std::collections::BTreeMap;

use super::keyword::Keyword;
use crate::surface::sections::{FileMaterial, FileSection};

/// Sections and materials so far.
#[derive(Default)]
pub(super) struct ShellSections {
    sections: Vec<FileSection>,
    materials: BTreeMap<String, FileMaterial>,
    /// The material whose options follow, in small letters.
    material: Option<String>,
    /// Whether data of the keyword before are still awaited.
    open: bool,
    left: Vec<String>,
}

impl ShellSections {
    /// Takes a keyword that speaks of sections or materials; false for any other.
    pub fn begin(&mut self, keyword: &Keyword) -> bool {
        self.open = false;
        match keyword.name.as_str() {
            "shell section" => {
                let plain = ["composite", "nodal thickness", "shell thickness", "orientation", "layup"];
                let known = plain.iter().all(|key| !keyword.has(key));
                match (offset(keyword).filter(|_| known), keyword.get("elset"), keyword.get("material")) {
                    (Some(offset), Some(group), Some(material)) => {
                        self.sections.push(FileSection {
                            group: group.into(),
                            faces: Vec::new(),
                            thickness: 0.0,
                            offset,
                            material: material.into(),
                            line: keyword.line,
                        });
                        self.open = true;
                    }
                    _ => self.left.push("*shell section that is not plainly homogeneous".into()),
                }
            }
            "material" => {
                self.material = keyword.get("name").map(str::to_lowercase);
                if let Some(name) = &self.material {
                    self.materials.entry(name.clone()).or_default();
                }
            }
            "elastic" => {
                self.open = self.material.is_some()
                    && keyword.get("type").is_none_or(|kind| kind.eq_ignore_ascii_case("isotropic"));
                if !self.open {
                    self.left.push("*elastic that is not isotropic".into());
                }
            }
            "density" => self.open = self.material.is_some(),
            _ => return false,
        }
        true
    }

    /// Takes the first line of data after such a keyword; those behind it are for other temperatures.
    pub fn data(&mut self, keyword: &Keyword, fields: &[&str]) {
        if !std::mem::take(&mut self.open) {
            return;
        }
        let number = |i: usize| -> Option<f64> {
            let word = fields.get(i)?.replace(['D', 'd'], "e");
            word.parse().ok().filter(|x: &f64| x.is_finite())
        };
        let material = self.material.as_ref().and_then(|name| self.materials.get_mut(name));
        match (keyword.name.as_str(), material) {
            ("shell section", _) => {
                if let (Some(section), Some(thickness)) = (self.sections.last_mut(), number(0)) {
                    section.thickness = thickness;
                }
            }
            ("elastic", Some(material)) => {
                material.elastic = number(0).zip(number(1)).map(|(young, poisson)| [young, poisson]);
            }
            ("density", Some(material)) => material.density = number(0),
            _ => {}
        }
    }

    /// Sections with the faces of their groups, materials, and what was passed over.
    pub fn finish(
        &mut self,
        faces: impl Fn(&str) -> Option<Vec<u32>>,
    ) -> (Vec<FileSection>, BTreeMap<String, FileMaterial>, Vec<String>) {
        for section in &mut self.sections {
            section.faces = faces(&section.group).unwrap_or_default();
            section.faces.sort_unstable();
            section.faces.dedup();
        }
        // A section whose data line is missing or no number has no thickness.
        let (sections, without): (Vec<_>, Vec<_>) =
            std::mem::take(&mut self.sections).into_iter().partition(|section| section.thickness > 0.0);
        if !without.is_empty() {
            self.left.push("*shell section without a thickness".into());
        }
        (sections, std::mem::take(&mut self.materials), std::mem::take(&mut self.left))
    }
}

/// From the nodes to the middle of the thickness, in thicknesses; Abaqus counts the other way. None if it is no number.
fn offset(keyword: &Keyword) -> Option<f64> {
    let word = keyword.get("offset").unwrap_or("0").to_uppercase();
    let to_nodes: f64 = match word.as_str() {
        "SPOS" => 0.5,
        "SNEG" => -0.5,
        number => number.parse().ok()?,
    };
    to_nodes.is_finite().then_some(0.0 - to_nodes)
}
