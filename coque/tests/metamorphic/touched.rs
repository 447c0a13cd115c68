//! Contact with tools: half against quarter, the tool moved against the shell moved, mirrored, tools in another order.

use super::{common::text, difference, judge, ran};

const QUARTER: &str = "ring-between-plates.toml";
/// Early levels of the ring, before and after its crown flattens, on a coarser lattice.
const COARSE: [(&str, &str); 2] =
    [("geometry.cylinder.particles", "[21, 3]"), ("analysis.static.levels", "[0.2, 0.5, 0.6]")];

/// The half of the ring from crown to foot between two plates that both come nearer, read at its upper half.
fn half() -> String {
    let plate = |name: &str, z: f64| {
        format!(
            "[[tools]]\nname = \"{name}\"\nplane = {{ point = [0.0, 0.0, {}], normal = [0.0, 0.0, {}] }}\nmoved = [0.0, 0.0, {}]\n",
            1.01 * z,
            -z,
            -0.7 * z
        )
    };
    let symmetry =
        |on: &str, normal: &str| format!("[[supports]]\non = \"{on}\"\nsymmetry = {{ normal = {normal} }}\n");
    // Its middle is held along z: between two smooth plates nothing else does.
    let supports = [
        symmetry("u0", "[1.0, 0.0, 0.0]"),
        symmetry("u1", "[1.0, 0.0, 0.0]"),
        symmetry("v0", "[0.0, 1.0, 0.0]"),
        symmetry("v1", "[0.0, 1.0, 0.0]"),
        "[[supports]]\non = \"side\"\nheld = { displacement = [[0.0, 0.0, 1.0]] }\n".into(),
    ];
    let column = |name: &str, of: &str, on: &str, direction: &str, factor: f64| {
        format!(
            "[[curve]]\nname = \"{name}\"\nof = \"{of}\"\non = \"{on}\"\ndirection = {direction}\nfactor = {factor:.1}\n"
        )
    };
    format!(
        "title = \"Half\"\nunits = {{ length = \"m\", force = \"N\", time = \"s\" }}\n\
         geometry.cylinder = {{ radius = 1.0, angles = [0.0, 180.0], length = 0.1, particles = [41, 3] }}\n\
         material.elastic = {{ young = 1.2e6, poisson = 0.0, density = 1000.0 }}\n\
         section.homogeneous = {{ thickness = 0.02 }}\nanalysis.static = {{ levels = [0.2, 0.5, 0.6] }}\n\
         sets.side.box = {{ min = [0.99, -1.0, -0.01], max = [1.01, 1.0, 0.01] }}\n\
         sets.above.box = {{ min = [-0.01, -1.0, 0.0], max = [1.1, 1.0, 1.1] }}\n{}{}{}{}{}{}",
        plate("above", 1.0),
        plate("below", -1.0),
        supports.concat(),
        column("P", "contact-force", "above", "[0.0, 0.0, -1.0]", 2.0),
        column("w", "displacement", "u0", "[0.0, 0.0, -1.0]", 1.0),
        column("side", "displacement", "side", "[1.0, 0.0, 0.0]", 1.0),
    )
}

/// Energies are those of twice as much.
#[test]
fn half_a_ring_between_two_plates_is_two_quarters_under_one() {
    let mut failures = Vec::new();
    let (whole, quarter) = (ran(&half(), &[], 1), ran(&text(QUARTER), &COARSE, 1));
    let twice: Vec<f64> =
        whole.curve.columns.iter().map(|column| if column.name == "internal" { 0.5 } else { 1.0 }).collect();
    judge(&mut failures, "half", QUARTER, difference(&whole, &quarter, &twice), 1e-8);
    assert!(failures.is_empty(), "{failures:#?}");
}

/// The plate stands and the sides of the ring come up, as much as the plate came down: all that is seen from the ring is the same. Newton's method
/// stops at a part of the forces, among which there are those that move the sides: measured 2.5e-8.
#[test]
fn a_ring_moved_against_a_plate_is_a_plate_moved_against_the_ring() {
    let mut failures = Vec::new();
    let pushed = ran(&text(QUARTER), &COARSE, 1);
    let up = "{ on = 'u1', held = { director = [[0, 0, 1]] } }, { on = 'u1', moved = { direction = [0, 0, 1], by = 0.7 } }";
    let symmetry = |on: &str, normal: &str| format!("{{ on = '{on}', symmetry = {{ normal = {normal} }} }}");
    let supports = format!(
        "[{}, {up}, {}, {}]",
        symmetry("u0", "[1, 0, 0]"),
        symmetry("v0", "[0, 1, 0]"),
        symmetry("v1", "[0, 1, 0]")
    );
    // Of the crown what it comes nearer to the sides.
    let columns = "[{ name = 'P', of = 'contact-force', on = 'all', direction = [0, 0, -1], factor = 2.0 }, \
                    { name = 'side', of = 'displacement', on = 'u1', direction = [1, 0, 0] }]";
    let replaced = [
        &COARSE[..],
        &[("tools[0].moved", "[0, 0, 0]"), ("supports", &supports), ("curve", columns), ("output", "{}")],
    ]
    .concat();
    let moved = ran(&text(QUARTER), &replaced, 1);
    let still = ran(&text(QUARTER), &[&COARSE[..], &[("curve", columns), ("output", "{}")]].concat(), 1);
    assert_eq!(pushed.curve.column("P"), still.curve.column("P"));
    let ones = vec![1.0; moved.curve.columns.len()];
    judge(&mut failures, "moved", QUARTER, difference(&still, &moved, &ones), 8e-8);
    assert!(failures.is_empty(), "{failures:#?}");
}

/// From below in place of from above.
#[test]
fn a_plate_from_below_is_one_from_above() {
    let mut failures = Vec::new();
    let above = ran(&text(QUARTER), &COARSE, 1);
    let mirrored = text(QUARTER)
        .replace("angles = [0.0, 90.0]", "angles = [90.0, 180.0]")
        .replace("\"u0\"", "\"foot\"")
        .replace("\"u1\"", "\"u0\"")
        .replace("\"foot\"", "\"u1\"")
        .replace(
            "point = [0.0, 0.0, 1.01], normal = [0.0, 0.0, -1.0]",
            "point = [0.0, 0.0, -1.01], normal = [0.0, 0.0, 1.0]",
        )
        .replace("moved = [0.0, 0.0, -0.7]", "moved = [0.0, 0.0, 0.7]")
        .replace("direction = [0.0, 0.0, -1.0]", "direction = [0.0, 0.0, 1.0]");
    let below = ran(&mirrored, &COARSE, 1);
    let ones = vec![1.0; below.curve.columns.len()];
    judge(&mut failures, "mirrored", QUARTER, difference(&above, &below, &ones), 1e-8);
    assert!(failures.is_empty(), "{failures:#?}");
}

#[test]
fn tools_in_another_order_do_the_same() {
    let mut failures = Vec::new();
    let plate =
        "{ name = 'plate', plane = { point = [0, 0, 1.01], normal = [0, 0, -1] }, moved = [0, 0, -0.7] }";
    // It meets the side of the ring, on its way outward, at half of the way.
    let wall = "{ name = 'wall', plane = { point = [1.25, 0, 0], normal = [-1, 0, 0] } }";
    let [one, other] = [[plate, wall], [wall, plate]].map(|order| {
        let tools = format!("[{}]", order.join(", "));
        let columns = "[{ name = 'P', of = 'contact-force', on = 'all', direction = [0, 0, -1] }, \
                        { name = 'Q', of = 'contact-force', on = 'all', direction = [-1, 0, 0] }]";
        ran(
            &text(QUARTER),
            &[&COARSE[..], &[("tools", &tools), ("curve", columns), ("output", "{}")]].concat(),
            1,
        )
    });
    assert!(one.curve.column("Q").unwrap()[3] > 0.0, "the wall is not touched");
    let ones = vec![1.0; one.curve.columns.len()];
    judge(&mut failures, "order", QUARTER, difference(&one, &other, &ones), 1e-10);
    assert!(failures.is_empty(), "{failures:#?}");
}
