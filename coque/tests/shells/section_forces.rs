//! What goes through a cut of a shell: what is applied beyond it.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use std::fmt::Write as _;
use std::fs;
use std::path::Path;

use crate::common::refused::refused;
use crate::common::{column as values, last, ran, run, scenes};
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

/// Force and moment through an oblique cut are those of the loads beyond it, about any point: in a linear answer to the rounding of its differences, 3e-8 N and 1e-8 N m, in a
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
    for (text, size, of_forces, of_moments) in [(plain, 1.0, 3e-8, 4e-9), (balance, 1e-3, 1.5e-7, 2e-4)] {
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
        ("a part of a cut", "0.0] }\ndirection", "0.0], max = [5.0, 1.0, 1.0] }\ndirection"),
        ("a cut of no section", "of = \"section-force\"", "of = \"reaction\""),
        (
            "about a point",
            "direction = [1.0, 0.0, 0.0]",
            "direction = [1.0, 0.0, 0.0]\nabout = [0.0, 0.0, 0.0]",
        ),
        ("no direction", "\ndirection = [1.0, 0.0, 0.0]", ""),
        ("beside a rigid set", "[sets]", "rigid = [{ on = \"u1\" }]\n[sets]"),
        ("a set beyond the cut", "on = \"all\"", "on = \"half\""),
        ("a set before the cut", "on = \"all\"", "on = \"u0\""),
        (
            "a set that others join beyond the cut",
            "[[curve]]\nname = \"section-force-0\"\nof = \"section-force\"\non = \"all\"",
            "strip.box = { min = [2.4, -1.0, -1.0], max = [7.6, 1.1, 1.0] }\n[[curve]]\nname = \"section-force-0\"\nof = \"section-force\"\non = \"strip\"",
        ),
    ];
    insta::assert_snapshot!(refused(&text, &cases));
}

/// A fork in a file: a stem of 3 by 5 and two prongs, each 7 by 2, pulled by forces of their own.
fn fork(columns: &str) -> String {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("section-forces");
    fs::create_dir_all(&folder).unwrap();
    let (mut nodes, mut faces) = (String::new(), Vec::new());
    let number = |i: usize, j: usize| 6 * i + j + 1;
    for (i, j) in (0..11).flat_map(|i| (0..6).map(move |j| (i, j))) {
        writeln!(nodes, "{} {i} {j} 0", number(i, j)).unwrap();
        if i < 10 && j < 5 && (i < 3 || j != 2) {
            faces.push([(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)].map(|(i, j)| number(i, j)));
        }
    }
    let mut text = format!(
        "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n66\n{nodes}$EndNodes\n$Elements\n{}\n",
        faces.len()
    );
    for (k, [a, b, c, d]) in faces.into_iter().enumerate() {
        writeln!(text, "{} 3 2 1 1 {a} {b} {c} {d}", k + 1).unwrap();
    }
    text.push_str("$EndElements\n");
    let file = folder.join("fork.msh");
    fs::write(&file, text).unwrap();
    format!(
        "title = \"Fork\"\nunits = {{ length = \"m\", force = \"N\", time = \"s\" }}\nanalysis.linear = {{}}\n\
         geometry.mesh.file = {file:?}\nmaterial.elastic = {{ young = 1e7, poisson = 0.3, density = 1.0 }}\n\
         section.homogeneous.thickness = 0.2\nsupports = [{{ on = \"foot\", clamped = {{}} }}]\n\
         loads = [{{ on = \"lower_end\", force = {{ total = [3.0, 2.0, 1.0] }} }}, {{ on = \"upper_end\", force = {{ total = [-5.0, 1.0, 2.0] }} }}]\n\
         [sets]\nfoot.box = {{ min = [-0.1, -0.1, -0.1], max = [0.1, 5.1, 0.1] }}\n\
         lower.box = {{ min = [2.9, -0.1, -0.1], max = [10.1, 2.1, 0.1] }}\nupper.box = {{ min = [2.9, 2.9, -0.1], max = [10.1, 5.1, 0.1] }}\n\
         lower_end.box = {{ min = [9.9, -0.1, -0.1], max = [10.1, 2.1, 0.1] }}\nupper_end.box = {{ min = [9.9, 2.9, -0.1], max = [10.1, 5.1, 0.1] }}\n{columns}"
    )
}

/// Through a prong of a fork goes what is applied to it, through both their sum, whichever plane cuts them.
#[test]
fn a_prong_bears_what_is_applied_to_it() {
    let list: String = ["all", "lower", "upper"]
        .iter()
        .flat_map(|on| {
            (0..3).map(move |axis| {
                column("section-force", axis, "")
                    .replace("\"all\"", &format!("\"{on}\""))
                    .replace(&format!("force-{axis}\""), &format!("{on}-{axis}\""))
            })
        })
        .collect();
    let found = ran(Scene::parse(&fork(&list), "fork.toml"));
    for (on, exact) in [("lower", [3.0, 2.0, 1.0]), ("upper", [-5.0, 1.0, 2.0]), ("all", [-2.0, 3.0, 3.0])] {
        for (axis, exact) in exact.into_iter().enumerate() {
            let through = last(&found, &format!("section-{on}-{axis}"));
            // 2.4e-8 N of 5 N: what the differences of a linear answer round.
            assert!((through - exact).abs() < 7e-8, "{on} {axis}: {through} {exact}");
        }
    }
}

/// A free bar that is pulled at one end, without Poisson's ratio: what goes through a cut of it is what is applied beyond less the change of momentum there.
#[test]
fn through_a_cut_in_time_goes_the_load_less_inertia() {
    let (force, step) = (3.0, 2e-5);
    let rows: Vec<usize> = (11..21).collect();
    let mut columns = column("section-force", 0, "");
    let back = THROUGH.replace("normal = [1.0, 0.2, 0.0]", "normal = [-1.0, -0.2, 0.0]");
    columns += &column("section-force", 0, "").replace(THROUGH, &back).replace("section-force-0", "back");
    let mut sets = String::new();
    for row in &rows {
        let x = 0.5 * *row as f64;
        writeln!(
            sets,
            "row{row}.box = {{ min = [{:?}, -1.0, -1.0], max = [{:?}, 3.0, 1.0] }}",
            x - 0.1,
            x + 0.1
        )
        .unwrap();
        writeln!(
            columns,
            "[[curve]]\nname = \"v{row}\"\nof = \"velocity\"\non = \"row{row}\"\ndirection = [1.0, 0.0, 0.0]"
        )
        .unwrap();
    }
    let straight = |text: String| {
        text.replace("[4.6, 0.0, 0.0], normal = [1.0, 0.2, 0.0]", "[5.2, 0.0, 0.0], normal = [1.0, 0.0, 0.0]")
    };
    let columns = straight(columns)
        .replace("[4.6, 0.0, 0.0], normal = [-1.0, -0.2, 0.0]", "[5.2, 0.0, 0.0], normal = [-1.0, 0.0, 0.0]");
    let text = format!(
        "title = \"Bar\"\nunits = {{ length = \"m\", force = \"N\", time = \"s\" }}\n\
         analysis.explicit.transient = {{ duration = 8e-3, record_every = {step:?} }}\n\
         geometry.plate = {{ lengths = [10.0, 2.0], particles = [21, 5] }}\n\
         material.elastic = {{ young = 1e7, poisson = 0.0, density = 1.0 }}\nsection.homogeneous.thickness = 0.2\n\
         loads = [{{ on = \"u1\", force = {{ total = [{force:?}, 0.0, 0.0] }} }}]\n[sets]\n{sets}{columns}"
    );
    let found = ran(Scene::parse(&text, "bar.toml"));
    let (through, back) = (values(&found, "section-force-0"), values(&found, "back"));
    // Rows of 0.5 by 2 by 0.2 of the density 1; the last is half as wide.
    let speeds: Vec<Vec<f64>> = rows.iter().map(|row| values(&found, &format!("v{row}"))).collect();
    let momentum: Vec<f64> = (0..through.len())
        .map(|i| {
            rows.iter().zip(&speeds).map(|(&row, v)| if row == 20 { 0.1 * v[i] } else { 0.2 * v[i] }).sum()
        })
        .collect();
    // Velocities are those half a step later: forces act for half of the first step, for a whole one of each other.
    let (mut impulse, mut most, mut greatest) = (0.0, 0.0_f64, 0.0_f64);
    for (i, momentum) in momentum.iter().enumerate() {
        impulse += (if i == 0 { 0.5 * step } else { step }) * (force - through[i]);
        most = most.max((impulse - momentum).abs());
        greatest = greatest.max(momentum.abs());
    }
    // The wave has run to both ends and back: the cut has borne more than the load, and all between.
    let [low, high] = [f64::min, f64::max].map(|of| through.iter().copied().reduce(of).unwrap());
    assert!(low < 0.0 && high > force, "{low} {high}");
    // Rounding, 1e-15.
    assert!(most < 4e-15 * greatest, "{most:e} {greatest:e}");
    // Internal forces of a free body add up to nothing: rounding, 1.2e-15 of the load.
    let uneven = through.iter().zip(&back).fold(0.0_f64, |most, (a, b)| most.max((a + b).abs()));
    assert!(uneven < 4e-15 * force, "{uneven:e}");
}

/// The ligament beside a hole bears the load.
#[test]
fn the_load_goes_through_the_ligament() {
    let file = format!("{:?}", scenes().join("meshes/open-hole.inp"));
    let found = run("meshes/open-hole.toml", &[("geometry.mesh.file", &file)]);
    let off = last(&found, "through_ligament") / 900.0 - 1.0;
    assert!(off.abs() < 2e-13, "{off:e}");
}
