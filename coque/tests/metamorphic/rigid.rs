//! A rigid ball that spins and hits a plate off its middle: mirrored, turned, in other units, moved against moved, whichever is named first.

use super::{common::text, difference, judge, ran};
use coque::Outcome;

const SCENE: &str = "
title = \"A ball hits a plate\"
units = { length = \"m\", force = \"N\", time = \"s\" }
[bodies.ball.rigid]
geometry.ball = { centre = [0.05, 0.02, 0.0515], radius = 0.05, spacing = 0.02 }
mass = 0.2
velocity = { linear = [0.3, 0.1, -1.0], spin = { axis = [0.2, 1.0, 0.4], point = [0.05, 0.02, 0.0515], rate = 30.0 } }
[bodies.plate.shell]
geometry.plate = { lengths = [0.4, 0.4], particles = [17, 17] }
placed = { origin = [-0.2, -0.2, 0.0], u = [1, 0, 0], v = [0, 1, 0] }
material.elastic = { young = 2.0e11, poisson = 0.3, density = 7850.0 }
section.homogeneous = { thickness = 0.002 }
velocity = { linear = [0.0, 0.0, 0.0] }
[[contact]]
between = [\"ball\", \"plate\"]
[analysis.explicit.transient]
duration = 0.0016
record_every = 2e-4
[[curve]]
name = \"force\"
of = \"contact-force\"
on = \"ball.all\"
direction = [0, 0, 1]
[[curve]]
name = \"way\"
of = \"displacement\"
on = \"ball.all\"
direction = [0, 0, 1]
[[curve]]
name = \"turn\"
of = \"rotation\"
on = \"ball.all\"
direction = [0, 1, 0]
";

const BALL: &str = "bodies.ball.rigid.geometry.ball";
const VELOCITY: &str = "bodies.ball.rigid.velocity";

fn still() -> Outcome {
    let still = ran(SCENE, &[], 1);
    let most = still.curve.rows.iter().map(|row| row[6]).fold(0.0, f64::max);
    assert!(most > 10.0, "it hits: {most}");
    still
}

fn held(relation: &str, still: &Outcome, other: &Outcome, factors: &[f64], bound: f64) {
    let mut failures = Vec::new();
    judge(&mut failures, relation, "a ball on a plate", difference(still, other, factors), bound);
    assert!(failures.is_empty(), "{failures:#?}");
}

/// In the mirror of x, where spins keep their x and change the sign of the others; turned from x to y to z to x, which the ball of triangles
/// does not show. What rounding lets grow in the steps of an impact: 1e-10.
#[test]
fn mirrored_and_turned_it_is_the_same() {
    let still = still();
    let ones = vec![1.0; still.curve.columns.len()];
    let mirrored = [
        (BALL, "{ centre = [-0.05, 0.02, 0.0515], radius = 0.05, spacing = 0.02 }"),
        (
            VELOCITY,
            "{ linear = [-0.3, 0.1, -1.0], spin = { axis = [0.2, -1.0, -0.4], point = [-0.05, 0.02, 0.0515], rate = 30.0 } }",
        ),
        ("curve[2].direction", "[0, -1, 0]"),
    ];
    held("mirrored", &still, &ran(SCENE, &mirrored, 1), &ones, 1e-8);
    let turned = [
        (BALL, "{ centre = [0.0515, 0.05, 0.02], radius = 0.05, spacing = 0.02 }"),
        (
            VELOCITY,
            "{ linear = [-1.0, 0.3, 0.1], spin = { axis = [0.4, 0.2, 1.0], point = [0.0515, 0.05, 0.02], rate = 30.0 } }",
        ),
        ("bodies.plate.shell.placed", "{ origin = [0.0, -0.2, -0.2], u = [0, 1, 0], v = [0, 0, 1] }"),
        ("curve[0].direction", "[1, 0, 0]"),
        ("curve[1].direction", "[1, 0, 0]"),
        ("curve[2].direction", "[0, 0, 1]"),
    ];
    held("turned", &still, &ran(SCENE, &turned, 1), &ones, 1e-8);
}

/// In mm, N and s every column is multiplied by the factor of its unit.
#[test]
fn in_other_units_it_is_the_same() {
    let still = still();
    let scaled = [
        ("units", "{ length = \"mm\", force = \"N\", time = \"s\" }"),
        (BALL, "{ centre = [50.0, 20.0, 51.5], radius = 50.0, spacing = 20.0 }"),
        ("bodies.ball.rigid.mass", "0.2e-3"),
        (
            VELOCITY,
            "{ linear = [300.0, 100.0, -1000.0], spin = { axis = [0.2, 1.0, 0.4], point = [50.0, 20.0, 51.5], rate = 30.0 } }",
        ),
        ("bodies.plate.shell.geometry.plate.lengths", "[400.0, 400.0]"),
        ("bodies.plate.shell.placed.origin", "[-200.0, -200.0, 0.0]"),
        ("bodies.plate.shell.material.elastic", "{ young = 2.0e5, poisson = 0.3, density = 7850.0e-12 }"),
        ("bodies.plate.shell.section.homogeneous.thickness", "2.0"),
    ];
    let factor = |column: &coque::Column| match column.unit.as_str() {
        "m" | "N m" => 1e3,
        _ => 1.0,
    };
    let factors: Vec<f64> = still.curve.columns.iter().map(factor).collect();
    held("in other units", &still, &ran(SCENE, &scaled, 1), &factors, 1e-8);
}

/// The plate comes to the ball instead: forces and turns are the same, and the way of the ball less that of whoever looks on.
#[test]
fn moved_against_moved_it_is_the_same() {
    let still = still();
    let moved = [
        ("bodies.ball.rigid.velocity.linear", "[0.3, 0.1, 0.0]"),
        ("bodies.plate.shell.velocity.linear", "[0.0, 0.0, 1.0]"),
    ];
    let other = ran(SCENE, &moved, 1);
    let most = still.curve.rows.iter().map(|row| row[6].abs()).fold(0.0, f64::max);
    for (one, other) in still.curve.rows.iter().zip(&other.curve.rows) {
        assert!((one[0] - other[0]).abs() < 1e-12);
        assert!((one[6] - other[6]).abs() < 1e-7 * most, "{} {}", one[6], other[6]);
        assert!((one[7] - (other[7] - one[0])).abs() < 1e-10, "{} {}", one[7], other[7]);
    }
}

#[test]
fn whichever_is_named_first_it_is_the_same_to_the_bit() {
    let swapped = [("contact[0].between", "[\"plate\", \"ball\"]")];
    assert_eq!(still().curve, ran(SCENE, &swapped, 1).curve);
    for threads in [2, 3] {
        assert_eq!(still().curve, ran(SCENE, &[], threads).curve);
    }
}

/// A rigid mass on a column of bonds: whichever the contact names first changes no bit; along x in place of z the same, but for rounding.
#[test]
fn a_mass_hits_a_column_the_same_way_along_another_axis() {
    let scene = text("mass-on-column.toml");
    let still = ran(&scene, &[], 1);
    let named = ran(&scene, &[("contact", "[{ between = [\"column\", \"mass\"], rounding = 0.001 }]")], 1);
    assert_eq!(still.curve.rows, named.curve.rows);
    let column = |name: &str, of: &str, on: &str| {
        format!("{{ name = \"{name}\", of = \"{of}\", on = \"{on}.all\", direction = [1, 0, 0] }}")
    };
    let columns = [
        column("F", "contact-force", "mass"),
        column("F_column", "contact-force", "column"),
        column("v", "velocity", "mass"),
    ];
    let mirror = |face: &str, normal: &str| {
        format!("{{ on = \"column.{face}\", symmetry = {{ normal = {normal} }} }}")
    };
    let [x, y, z] = ["[1, 0, 0]", "[0, 1, 0]", "[0, 0, 1]"];
    let mirrors = [mirror("y0", y), mirror("y1", y), mirror("z0", z), mirror("z1", z), mirror("x0", x)];
    let along = ran(
        &scene,
        &[
            (
                "bodies.mass.rigid.geometry.box",
                "{ min = [1.0001, -0.1, -0.1], max = [1.2, 0.3, 0.3], spacing = 0.2 }",
            ),
            ("bodies.mass.rigid.velocity.linear", "[-10.0, 0.0, 0.0]"),
            ("bodies.column.solid.geometry.block.lengths", "[1.0, 0.2, 0.2]"),
            ("supports", &format!("[{}]", mirrors.join(", "))),
            ("curve", &format!("[{}]", columns.join(", "))),
        ],
        1,
    );
    // Nothing acts from outside: that work holds rounding alone.
    for name in ["v", "F", "F_column", "internal"] {
        let [one, other] = [&still, &along].map(|outcome| outcome.curve.column(name).unwrap());
        let size = one.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
        let off = one.iter().zip(&other).fold(0.0_f64, |most, (a, b)| most.max((a - b).abs())) / size;
        println!("along x: {off:.1e} {name}");
        assert!(off < 1e-9, "{name}: {off:e}");
    }
}
