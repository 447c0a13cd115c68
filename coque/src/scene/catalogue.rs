//! What a scene may name, a line each: from the descriptions in the schema and the tables of the layers below.

use serde_json::Value;

use super::analysis_kind::ANALYSES;
use super::loads::Load;
use super::schema::schema;
use super::sets::{BUILT_IN, OF_FILLED, OF_FLUIDS, OF_SOLIDS};
use super::supports::Support;

/// Things of one kind.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CatalogueEntry {
    /// What they are, as in `coque list`.
    pub name: &'static str,
    /// Where a scene names them.
    pub place: &'static str,
    /// Word and description of each.
    pub entries: Vec<(String, String)>,
}

/// Everything that a scene may name, by kind.
pub fn catalogue() -> Vec<CatalogueEntry> {
    let schema = schema();
    let types = &schema["$defs"];
    let mut analyses = alternatives(&types["Analysis"]);
    let marches = keys(&types["Explicit"], &["quasi-static", "transient"]);
    analyses.extend(marches.into_iter().map(|(word, line)| (format!("explicit.{word}"), line)));
    let analyses =
        ANALYSES.iter().filter_map(|kind| analyses.iter().find(|(word, _)| word == kind.word).cloned());
    let shelf = |name, place, entries| CatalogueEntry { name, place, entries };
    let kernels = sph_core::kernels().map(|kernel| (kernel.name().into(), kernel.describe().into()));
    let strains = shell_kinematics::strain_measures().map(|m| (m.name().into(), m.describe().into()));
    let sets = [
        (BUILT_IN.join(", "), "of a shell: all particles, edges, corners, middle rows".into()),
        (OF_SOLIDS.join(", "), "of a solid: all nodes, those on the faces of its block".into()),
        (
            OF_FILLED[7].into(),
            "of a solid that fills a surface: its nodes at the surface; groups of the file beside it".into(),
        ),
        (
            OF_FLUIDS.join(", "),
            "of a fluid: all particles; of walls: all places, of a basin also its sides".into(),
        ),
    ];
    vec![
        shelf("analyses", "[analysis.…]", analyses.collect()),
        shelf("bodies", "[bodies.NAME.…]", alternatives(&types["BodyScene"])),
        shelf("geometries", "[geometry.…]", alternatives(&types["Geometry"])),
        shelf("materials", "[material.…]", alternatives(&types["Material"])),
        shelf("sections", "[section.…]", alternatives(&types["Section"])),
        shelf("formulations", "[formulation.…]", alternatives(&types["Formulation"])),
        shelf(
            "solid-formulations",
            "[bodies.NAME.solid.formulation.…]",
            alternatives(&types["SolidFormulation"]),
        ),
        shelf("cut-outs", "[bodies.NAME.solid.geometry] cut_outs", alternatives(&types["CutOut"])),
        shelf("fluids", "[bodies.NAME.fluid.geometry.…]", alternatives(&types["FluidGeometry"])),
        shelf("walls", "[bodies.NAME.walls.geometry.…]", alternatives(&types["WallGeometry"])),
        shelf("rigid-bodies", "[bodies.NAME.rigid.geometry.…]", alternatives(&types["RigidGeometry"])),
        shelf("kernels", "formulation.….kernel", kernels.into()),
        shelf("strains", "formulation.….curvature", strains.into()),
        shelf("sets", "on = \"…\"", sets.into()),
        shelf("regions", "[sets]", keys(&types["Region"], &[])),
        shelf("supports", "[[supports]]", keys(&types["Support"], &Support::WORDS)),
        shelf("loads", "[[loads]]", keys(&types["Load"], &Load::WORDS)),
        shelf("amplitudes", "amplitude = …", alternatives(&types["Amplitude"])),
        shelf("probes", "[[curve]] of = \"…\"", alternatives(&types["Measured"])),
        shelf("outputs", "[output]", keys(&types["Output"], &[])),
    ]
}

/// Words of a type of which a scene gives one.
fn alternatives(kind: &Value) -> Vec<(String, String)> {
    let choices = kind["oneOf"].as_array().into_iter().flatten();
    choices.filter_map(|choice| Some((word(choice)?, line(choice)))).collect()
}

/// The word of an alternative: a constant, or the key of its table.
fn word(choice: &Value) -> Option<String> {
    let table = || choice["properties"].as_object()?.keys().next().cloned();
    choice["const"].as_str().map(str::to_owned).or_else(table)
}

/// Keys of a table, those named here or all.
fn keys(table: &Value, wanted: &[&str]) -> Vec<(String, String)> {
    let all = table["properties"].as_object().into_iter().flatten();
    all.filter(|(word, _)| wanted.is_empty() || wanted.contains(&word.as_str()))
        .map(|(word, key)| (word.clone(), line(key)))
        .collect()
}

fn line(described: &Value) -> String {
    described["description"].as_str().unwrap_or_default().to_owned()
}
