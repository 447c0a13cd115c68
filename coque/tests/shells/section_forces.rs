//! What goes through a cut of a shell: what is applied beyond it.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use crate::common::refused::refused;
use crate::common::{last, ran};
use coque::Scene;

/// A cantilever under three forces at its end and a pressure, cut in its middle, in an analysis.
fn cantilever(analysis: &str, columns: &str) -> String {
    format!(
        "title = \"Cut cantilever\"\nunits = {{ length = \"m\", force = \"N\", time = \"s\" }}\nanalysis.{analysis}\n\
         geometry.plate = {{ lengths = [10.0, 2.0], particles = [21, 5] }}\n\
         material.elastic = {{ young = 1e7, poisson = 0.3, density = 1.0 }}\nsection.homogeneous.thickness = 0.2\n\
         supports = [{{ on = \"u0\", clamped = {{}} }}]\n\
         loads = [{{ on = \"u1\", force = {{ total = [3.0, 2.0, 1.0] }} }}, {{ on = \"half\", pressure = {{ value = 0.1 }} }}]\n\
         [sets]\nhalf.box = {{ min = [7.4, -1.0, -1.0], max = [11.0, 3.0, 1.0] }}\n{columns}"
    )
}

const THROUGH: &str = "through = { point = [4.6, 0.0, 0.0], normal = [1.0, 0.2, 0.0] }";

fn column(of: &str, axis: usize, more: &str) -> String {
    let mut direction = [0.0; 3];
    direction[axis] = 1.0;
    format!(
        "[[curve]]\nname = \"{of}-{axis}\"\nof = \"{of}\"\non = \"all\"\n{THROUGH}\ndirection = {direction:?}\n{more}\n"
    )
}

/// Force and moment through an oblique cut are those of the loads beyond it, about any point: in a linear answer to the rounding of its differences, in a
/// balance to the residual that Newton's method leaves.
#[test]
fn what_is_applied_beyond_goes_through_a_cut() {
    let about = "about = [4.6, 1.0, 0.3]";
    let list: String = (0..3)
        .map(|axis| column("section-force", axis, "") + &column("section-moment", axis, about))
        .collect();
    let small = |text: String| {
        text.replace("[3.0, 2.0, 1.0]", "[0.003, 0.002, 0.001]").replace("value = 0.1", "value = 0.0001")
    };
    let plain = cantilever("linear = {}", &list);
    let balance = small(cantilever("static = { levels = 1, tolerance = 1e-12 }", &list));
    // In balance: places of 10 m, rounded, make 5e-8 of so small a load in so stiff a sheet; arms of the moved body differ by 7e-5.
    for (text, size, of_forces, of_moments) in [(plain, 1.0, 1e-8, 1e-8), (balance, 1e-3, 1.5e-7, 2e-4)] {
        let found = ran(Scene::parse(&text, "cut.toml"));
        // A pressure of .1 along the normal on the cells of 2.5 m by 2 m: .5 N up.
        let force = [3.0, 2.0, 1.5];
        // About the point: the end's forces at (10, 1, 0), the pressure's at (8.75, 1, 0).
        let cross = |a: [f64; 3], b: [f64; 3]| {
            [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
        };
        let end = cross([5.4, 0.0, -0.3], [3.0, 2.0, 1.0]);
        let middle = cross([4.15, 0.0, -0.3], [0.0, 0.0, 0.5]);
        for axis in 0..3 {
            let [f, m] =
                ["section-force", "section-moment"].map(|of| last(&found, &format!("{of}-{axis}")) / size);
            assert!((f - force[axis]).abs() < of_forces * 3.0, "{axis}: {f} {force:?}");
            let exact = end[axis] + middle[axis];
            assert!((m - exact).abs() < of_moments * 10.0, "{axis}: {m} {exact}");
        }
    }
}

/// A cut beside the support bears what the support does.
#[test]
fn a_cut_beside_the_support_bears_its_reaction() {
    let near = THROUGH
        .replace("[4.6, 0.0, 0.0], normal = [1.0, 0.2, 0.0]", "[0.1, 0.0, 0.0], normal = [1.0, 0.0, 0.0]");
    let own = "[[curve]]\nname = \"held\"\nof = \"reaction-moment\"\non = \"u0\"\ndirection = [0.0, 1.0, 0.0]\n\
               [[curve]]\nname = \"pulls\"\nof = \"reaction\"\non = \"u0\"\ndirection = [0.0, 1.0, 0.0]\n";
    let list = column("section-moment", 1, "").replace(THROUGH, &near)
        + &column("section-force", 1, "").replace(THROUGH, &near)
        + own;
    let text = cantilever("static = { levels = 1, tolerance = 1e-12 }", &list);
    let found = ran(Scene::parse(&text, "cut.toml"));
    for (through, held) in [("section-moment-1", "held"), ("section-force-1", "pulls")] {
        let sum = last(&found, through) + last(&found, held);
        // Of some ten: what Newton's method leaves.
        assert!(sum.abs() < 1e-9, "{through}: {sum}");
    }
}

/// A set that holds all beyond the cut gives what all particles do.
#[test]
fn a_set_that_holds_all_beyond_the_cut_will_do() {
    let narrow = column("section-force", 2, "")
        .replace("on = \"all\"", "on = \"far\"")
        .replace("force-2", "force-far");
    let list = format!(
        "far.box = {{ min = [3.1, -1.0, -1.0], max = [11.0, 3.0, 1.0] }}\n{}{narrow}",
        column("section-force", 2, "")
    );
    let found = ran(Scene::parse(&cantilever("linear = {}", &list), "cut.toml"));
    let [all, far] = ["section-force-2", "section-force-far"].map(|name| last(&found, name));
    assert_eq!(all.to_bits(), far.to_bits());
    assert!(all > 1.0);
}

#[test]
fn cuts_that_are_none() {
    let text = cantilever("linear = {}", &column("section-force", 0, ""));
    let cases = [
        ("no cut", THROUGH, ""),
        ("beside the shell", "point = [4.6", "point = [14.6"),
        ("before the shell", "point = [4.6", "point = [-4.6"),
        ("a set that others join", "on = \"all\"", "on = \"v0\""),
        ("a part of a cut", "0.0] }\ndirection", "0.0], max = [5.0, 1.0, 1.0] }\ndirection"),
        ("a cut of no section", "of = \"section-force\"", "of = \"reaction\""),
        (
            "about a point",
            "direction = [1.0, 0.0, 0.0]",
            "direction = [1.0, 0.0, 0.0]\nabout = [0.0, 0.0, 0.0]",
        ),
        ("no direction", "\ndirection = [1.0, 0.0, 0.0]", ""),
        ("beside a rigid set", "[sets]", "rigid = [{ on = \"u1\" }]\n[sets]"),
    ];
    insta::assert_snapshot!(refused(&text, &cases));
}
