//! Two bodies joined by links: what holds between two runs of them.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use coque::Outcome;

use crate::common::sittings::stopped_again_and_again;
use crate::common::{Replaced, column, overridden, ran};
use crate::links::{STRIP, unbalanced};

/// Two bodies that fly, joined off their middles by a cable, a table and a dashpot, one of them on a gap.
const PAIR: &str = r#"title = "Two bodies"
units = { length = "m", force = "N", time = "s" }
analysis.explicit.transient = { duration = 0.4, record_every = 0.02 }
curve = [
    { name = "x_a", of = "displacement", on = "a.all", direction = [1, 0, 0] },
    { name = "z_b", of = "displacement", on = "b.all", direction = [0, 0, 1] },
    { name = "turn", of = "rotation", on = "b.all", direction = [0, 1, 0] },
    { name = "pull", of = "link-force", on = "b.all", direction = [0, 0, 1] },
]
[bodies.a.rigid]
geometry.box = { min = [-0.1, -0.1, -0.1], max = [0.1, 0.1, 0.1], spacing = 0.1 }
mass = 2.0
velocity = { linear = [1.0, 0.0, 0.3] }
[bodies.b.rigid]
geometry.box = { min = [0.4, -0.1, 0.2], max = [0.6, 0.1, 0.4], spacing = 0.1 }
mass = 1.0
velocity = { linear = [0.0, 0.2, 1.0] }
[sets.corner]
of = "a"
nearest = [0.1, 0.1, 0.1]
[sets.edge]
of = "b"
nearest = [0.4, 0.1, 0.2]
[[links]]
on = "corner"
to = "edge"
length = 0.35
stiffness = 900.0
bears = "tension"
[[links]]
on = "corner"
to = "b.all"
table = [[-0.2, -10.0], [0.0, 0.0], [0.1, 20.0]]
[[links]]
on = "edge"
to = "corner"
damping = 3.0
[[links]]
on = "b.all"
direction = [0.0, 0.0, 1.0]
stiffness = 500.0
gap = 0.03
[[links]]
on = "a.all"
point = [0.0, 0.0, -0.5]
length = 9.0
stiffness = 1.0
bears = "tension"
"#;

fn pair(replaced: Replaced) -> Outcome {
    ran(overridden(PAIR, "pair.toml", replaced))
}

/// Greatest difference of each column over its greatest value; the other's times a factor each.
fn apart(one: &Outcome, other: &Outcome, factors: [f64; 4]) -> f64 {
    let names = ["x_a", "z_b", "turn", "pull"];
    let each = names.into_iter().zip(factors).map(|(name, factor)| {
        let [one, other] = [one, other].map(|outcome| column(outcome, name));
        let most = one.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        assert!(most > 0.0, "{name}");
        one.iter().zip(&other).fold(0.0_f64, |most, (x, y)| most.max((x - factor * y).abs())) / most
    });
    each.fold(0.0, f64::max)
}

/// Rounding alone: 1e-12 of the greatest value of a column in some hundred steps.
#[test]
fn mirrored_in_other_units_and_the_other_end_first_it_is_the_same() {
    let still = pair(&[]);
    assert!(unbalanced(&still) < 1e-3, "{}", unbalanced(&still));
    let mirrored = pair(&[
        ("curve[0].direction", "[-1, 0, 0]"),
        ("curve[2].direction", "[0, -1, 0]"),
        ("bodies.a.rigid.velocity.linear", "[-1.0, 0.0, 0.3]"),
        ("bodies.b.rigid.geometry.box", "{ min = [-0.6, -0.1, 0.2], max = [-0.4, 0.1, 0.4], spacing = 0.1 }"),
        ("sets.corner.nearest", "[-0.1, 0.1, 0.1]"),
        ("sets.edge.nearest", "[-0.4, 0.1, 0.2]"),
    ]);
    let found = apart(&still, &mirrored, [1.0; 4]);
    assert!(found < 1e-10, "{found}");
    // Links from their other ends; elongations along a line stay what they are.
    let swapped = pair(&[
        ("links[0].on", "'edge'"),
        ("links[0].to", "'corner'"),
        ("links[2].on", "'corner'"),
        ("links[2].to", "'edge'"),
    ]);
    let found = apart(&still, &swapped, [1.0; 4]);
    assert!(found < 1e-10, "{found}");
    // Millimetres, and tonnes beside them: forces stay newtons, seconds seconds.
    let small = [
        ("units.length", "'mm'"),
        ("bodies.a.rigid.geometry.box", "{ min = [-100, -100, -100], max = [100, 100, 100], spacing = 100 }"),
        ("bodies.b.rigid.geometry.box", "{ min = [400, -100, 200], max = [600, 100, 400], spacing = 100 }"),
        ("bodies.a.rigid.mass", "2e-3"),
        ("bodies.b.rigid.mass", "1e-3"),
        ("bodies.a.rigid.velocity.linear", "[1000, 0, 300]"),
        ("bodies.b.rigid.velocity.linear", "[0, 200, 1000]"),
        ("sets.corner.nearest", "[100, 100, 100]"),
        ("sets.edge.nearest", "[400, 100, 200]"),
        ("links[0].length", "350"),
        ("links[0].stiffness", "0.9"),
        ("links[1].table", "[[-200, -10], [0, 0], [100, 20]]"),
        ("links[2].damping", "3e-3"),
        ("links[3].stiffness", "0.5"),
        ("links[3].gap", "30"),
        ("links[4].length", "9000"),
        ("links[4].point", "[0, 0, -500]"),
        ("links[4].stiffness", "1e-3"),
    ];
    let found = apart(&still, &pair(&small), [1e-3, 1e-3, 1.0, 1.0]);
    assert!(found < 1e-10, "{found}");
}

/// What the dashpot saw of the last step is in the checkpoint.
#[test]
fn a_stopped_run_goes_on_to_the_same_bits() {
    stopped_again_and_again("links-march", PAIR, &[], 3);
    let strip = [
        ("links", "[{ on = 'u1', direction = [0, 0, 1], stiffness = 0.1, gap = 0.02 }]"),
        ("analysis", "{ static = { levels = 4 } }"),
    ];
    stopped_again_and_again("links-static", STRIP, &strip, 2);
}
