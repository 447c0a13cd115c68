//! A notched strip of bonds that is drawn apart until it tears.

/// The strip, its notch at half of the height and as deep as half of the width; or its upper half above a mirror.
pub fn strip(half: bool) -> String {
    let (height, origin) = if half { (0.5, 0.0) } else { (1.0, -0.5) };
    let lower = if half {
        r#"{ on = "y0", symmetry = { normal = [0, 1, 0] } }"#
    } else {
        r#"{ on = "y0", moved = { direction = [0, -1, 0], by = 2e-4 } }"#
    };
    let beside = if half { "" } else { r#", { on = "corner", held = { displacement = [[1, 0, 0]] } }"# };
    format!(
        r#"title = "Strip that tears"
units = {{ length = "m", force = "N", time = "s" }}
analysis.static = {{ levels = [0.2, 0.4, 0.6, 0.8, 1.0] }}
supports = [{{ on = "y1", moved = {{ direction = [0, 1, 0], by = 2e-4 }} }}, {lower},
            {{ on = "above", held = {{ displacement = [[1, 0, 0]] }} }}{beside}]
sets.corner = {{ nearest = [0.0, {origin}, 0.0] }}
sets.above = {{ nearest = [0.0, 0.5, 0.0] }}
curve = [{{ name = "P", of = "reaction", on = "y1", direction = [0, 1, 0] }}]
[bodies.strip.solid]
geometry.block = {{ lengths = [1.0, {height:?}], origin = [0.0, {origin}], spacing = 0.0625 }}
material.elastic = {{ young = 1.0, poisson = 0.3333333333333333, density = 1.0 }}
formulation.bond-based = {{ plane = "stress", horizon = 3.015 }}
fracture = {{ energy = 1e-8 }}
cracks = [{{ from = [-0.5, 0.0], to = [0.5, 0.0] }}]
"#
    )
}
