//! Which support, load, initial stress and velocity goes with which analysis: small scenes of each, read and built.

use super::analysis_kind::{ANALYSES, AnalysisKind};
use super::problem::Scene;

const HEAD: &str = "
## What goes with which analysis

Found by building a small scene of each. \"in time\": with an `amplitude` beside it, which other analyses refuse. Modes of vibration
are those of the unloaded shell, or of the preloaded one: other loads change nothing, other prescribed motions stand still.
";

/// A row of the table: its name, the table it stands in, what it says.
const ROWS: [(&str, &str, &str); 43] = [
    ("`clamped`", "supports", "on = 'u1', clamped = {}"),
    ("`hinged`", "supports", "on = 'u1', hinged = {}"),
    ("`symmetry`", "supports", "on = 'u1', symmetry = { normal = [1, 0, 0] }"),
    ("`diaphragm`", "supports", "on = 'u1', diaphragm = { axis = [1, 0, 0] }"),
    ("`held`", "supports", "on = 'u1', held = { displacement = [[0, 0, 1]] }"),
    (
        "`moved`, one particle, nothing beside it",
        "supports",
        "on = 'u1v1', moved = { direction = [0, 0, 1], by = 1 }",
    ),
    (
        "`moved`, one particle, beside a load",
        "supports",
        "on = 'u1v1', moved = { direction = [0, 0, 1], by = 1 }",
    ),
    ("`moved`, more particles", "supports", "on = 'u1', moved = { direction = [0, 0, 1], by = 1 }"),
    (
        "`moved`, more particles, beside a load",
        "supports",
        "on = 'u1', moved = { direction = [0, 0, 1], by = 1 }",
    ),
    ("`rotated`", "supports", "on = 'u1', rotated = { axis = [0, 1, 0], by = 1 }"),
    ("`turned`", "supports", "on = 'u1', turned = { axis = [1, 0, 0], by = 1 }"),
    ("`moved`, of a rigid set", "supports", "on = 'u1', moved = { direction = [0, 0, 1], by = 1 }"),
    ("`turned`, of a rigid set", "supports", "on = 'u1', turned = { axis = [1, 0, 0], by = 1 }"),
    ("`spring`", "supports", "on = 'u1', spring = { direction = [0, 0, 1], stiffness = 1 }"),
    ("`spring` against turning", "supports", "on = 'u1', spring = { axis = [0, 1, 0], stiffness = 1 }"),
    (
        "`spring` to another set",
        "supports",
        "on = 'u1', spring = { direction = [0, 0, 1], stiffness = 1, to = 'u0' }",
    ),
    (
        "`links`, a cable to the ground",
        "links",
        "on = 'u1', point = [1, 0, 1], stiffness = 1, bears = 'tension'",
    ),
    ("`links`, a dashpot", "links", "on = 'u1', direction = [0, 0, 1], damping = 1"),
    ("`force`", "loads", "on = 'u1', force = { total = [0, 0, 1] }"),
    ("`couple`", "loads", "on = 'u1', couple = { moment = 1, axis = 'edge' }"),
    ("`pressure`, dead", "loads", "on = 'all', pressure = { value = 1 }"),
    ("`pressure`, follower", "loads", "on = 'all', pressure = { value = 1, follower = true }"),
    ("`gas`, behind held edges", "loads", "on = 'all', gas = { pressure = 1, beside = 1 }"),
    (
        "`volume`, behind held edges",
        "loads",
        "on = 'all', volume = { added = 1, bulk_modulus = 1, beside = 1 }",
    ),
    ("`gravity`", "loads", "on = 'all', gravity = { acceleration = [0, 0, 1] }"),
    ("`traction`, and `force` by area", "loads", "on = 'all', traction = { value = [0, 0, 1] }"),
    ("`temperature`", "loads", "on = 'all', temperature = { change = 1 }"),
    ("`pressure` on cells, follower", "loads", "on = 'half', pressure = { value = 1, follower = true }"),
    (
        "`preload` of a motion",
        "supports",
        "on = 'u1', moved = { direction = [0, 0, 1], by = 1 }, preload = true",
    ),
    ("`preload` of a load", "preload", "on = 'u1', force = { total = [0, 0, 1] }, preload = true"),
    ("`initial_stress`", "initial_stress", "on = 'all', membrane = [1, 1, 0]"),
    ("`initial_stress`, nothing beside it", "initial_stress", "on = 'all', membrane = [1, 1, 0]"),
    (
        "`stiffeners`",
        "stiffeners",
        "on = 'v1', eccentricity = 0.1, section.rectangle = { width = 0.1, height = 0.1 }",
    ),
    ("`velocity`", "velocity", "linear = [0, 0, 1]"),
    ("`moved`, of a solid", "supports", "on = 'x1', moved = { direction = [0, 0, 1], by = 1 }"),
    ("`turned`, of a solid", "supports", "on = 'x1', turned = { axis = [1, 0, 0], by = 1 }"),
    ("`pressure`, dead, of a solid", "loads", "on = 'x1', pressure = { value = 1 }"),
    ("`traction`, of a solid", "loads", "on = 'x1', traction = { value = [0, 0, 1] }"),
    ("`velocity` of a set", "velocity", "on = 'u1', linear = [0, 0, 1]"),
    ("`velocity`, of a solid", "velocity", "linear = [0, 0, 1]"),
    ("`moved`, of a Galerkin solid", "supports", "on = 'x1', moved = { direction = [0, 0, 1], by = 1 }"),
    ("`traction`, of a Galerkin solid", "loads", "on = 'x1', traction = { value = [0, 0, 1] }"),
    (
        "`pressure`, follower, of a Galerkin solid",
        "loads",
        "on = 'x1', pressure = { value = 1, follower = true }",
    ),
];

/// The shell and the solids of the small scenes, with the edges that are held and loaded.
const SHELL: [&str; 3] = [
    "geometry.plate = { lengths = [1, 1], particles = [3, 3] }
     material.elastic = { young = 1, poisson = 0, density = 1, expansion = 1e-3 }
     section.homogeneous = { thickness = 0.1 }",
    "u0",
    "v1",
];
const SOLID: [&str; 3] = [
    "bodies.block.solid.geometry.block = { lengths = [1, 1, 1], spacing = 0.3 }
     bodies.block.solid.material.elastic = { young = 1, poisson = 0, density = 1 }
     bodies.block.solid.formulation.state-based = { horizon = 1.5 }",
    "x0",
    "y1",
];

const GALERKIN: [&str; 3] = [
    "bodies.block.solid.geometry.block = { lengths = [1, 1, 1], spacing = 0.5 }
     bodies.block.solid.material.elastic = { young = 1, poisson = 0, density = 1 }
     bodies.block.solid.formulation.galerkin = {}",
    "x0",
    "y1",
];

/// The table, in Markdown.
pub(super) fn goes_with() -> String {
    let words = ANALYSES.map(|kind| format!("`{}`", kind.word)).join(" | ");
    let mut text = format!("{HEAD}\n| | {words} |\n|---|{}\n", "---|".repeat(ANALYSES.len()));
    for (name, table, says) in ROWS {
        let cell = |kind: &AnalysisKind| {
            let plain = builds(kind, name, table, says);
            let in_time = || {
                !["velocity", "initial_stress", "stiffeners"].contains(&table)
                    && builds(kind, name, table, &format!("{says}, amplitude = {{ ramp = 1 }}"))
            };
            match () {
                () if plain => "yes",
                () if in_time() => "in time",
                () => "–",
            }
        };
        text.push_str(&format!("| {name} | {} |\n", ANALYSES.each_ref().map(cell).join(" | ")));
    }
    text
}

/// Whether a small cantilever with one thing more can be built.
fn builds(kind: &AnalysisKind, name: &str, table: &str, says: &str) -> bool {
    let options = match kind.word {
        "explicit.quasi-static" => "levels = 1, period = 1",
        "explicit.transient" => "duration = 1, record_every = 1",
        "static" | "relaxation" => "levels = 1",
        "arc-length" => "until = 1",
        "modal" | "buckling" => "modes = 1",
        "harmonic" => "frequencies = [1.0], damping.structural = 0.1",
        "response-spectrum" => {
            "modes = 1, damping.ratio = 0.1, base = [{ acceleration = [0, 0, 1], by = 'period', amplitude = { table = [[0, 1]] } }]"
        }
        "random-vibration" => {
            "modes = 1, damping.ratio = 0.1, frequencies = [1], loads = { density = [[1, 1], [2, 1]] }"
        }
        _ => "",
    };
    let galerkin = name.ends_with("of a Galerkin solid");
    let of_solid = galerkin || name.ends_with("of a solid");
    let [body, held, loaded] = match () {
        () if galerkin => GALERKIN,
        () if of_solid => SOLID,
        () => SHELL,
    };
    let mut supports = vec![format!("{{ on = '{held}', clamped = {{}} }}")];
    if name.ends_with("behind held edges") {
        supports.extend(["u1", "v0", "v1"].map(|edge| format!("{{ on = '{edge}', hinged = {{}} }}")));
    }
    let mut loads = Vec::new();
    let mut own = String::new();
    match table {
        "supports" => supports.push(format!("{{ {says} }}")),
        "loads" | "preload" => loads.push(format!("{{ {says} }}")),
        "links" => own = format!("links = [{{ {says} }}]"),
        "initial_stress" | "stiffeners" => own = format!("{table} = [{{ {says} }}]"),
        _ if of_solid => own = format!("bodies.block.solid.velocity = {{ {says} }}"),
        _ => own = format!("velocity = {{ {says} }}"),
    }
    if name.ends_with("of a rigid set") {
        own = "rigid = [{ on = 'u1' }]".into();
    }
    let alone = table == "loads"
        || name.ends_with("stress`, nothing beside it")
        || (name.starts_with("`moved`") && !name.ends_with("beside a load"));
    // Its answers have no sign, and loads beside it are refused.
    if !alone && kind.word != "response-spectrum" {
        loads.push(format!("{{ on = '{loaded}', force = {{ total = [0, 0, 1] }} }}"));
    }
    let sets = match of_solid {
        true => "",
        false => "sets.half.box = { min = [0, 0, 0], max = [0.5, 1, 0] }",
    };
    let text = format!(
        "title = ''
        units = {{ length = '-', force = '-', time = '-' }}
        {body}
        analysis.{} = {{ {options} }}
        {sets}
        supports = [{}]
        loads = [{}]
        {own}",
        kind.word,
        supports.join(", "),
        loads.join(", ")
    );
    Scene::parse(&text, "").and_then(|scene| scene.build(1)).is_ok()
}
