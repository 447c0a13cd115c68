//! Loads on cells, parts of a shell, sections of files: closed forms, the same from every source, what is refused.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use std::fs;
use std::path::Path;

use crate::common::refused::refused;
use crate::strip::{THIN, last, run, strip};
use coque::{Rendering, Scene, render};

/// Deflection of the end of a cantilever of length 10 under a line load of one from 6 to 10: that of the whole less that
/// of the first part, `q L⁴/8EI − (q a⁴/8EI + q a³ (L − a)/6EI)`.
fn under_the_tip(stiffness: f64) -> f64 {
    (1e4 / 8.0 - (6.0_f64.powi(4) / 8.0 + 6.0_f64.powi(3) * 4.0 / 6.0)) / stiffness
}

#[test]
fn what_acts_by_area_acts_on_cells() {
    let stiffness = 1e6 * 0.2_f64.powi(3) / 12.0;
    let exact = under_the_tip(stiffness);
    for load in [
        "pressure = { value = 1.0 }",
        "pressure = { value = 1.0, follower = true }",
        "traction = { value = [0.0, 0.0, 1.0] }",
        "force = { total = [0.0, 0.0, 4.0], by_area = true }",
        "gravity = { acceleration = [0.0, 0.0, 2.5] }",
    ] {
        let outcome = run(&strip(THIN, &format!("loads = [{{ on = \"tip\", {load} }}]")));
        // Shear is 1e-4 of it; one curvature a cell leaves .03 %.
        assert!((last(&outcome) / exact - 1.0).abs() < 2e-3, "{load}: {} {exact}", last(&outcome));
        let loads = outcome.summary.body.resultants.as_ref().unwrap();
        let (name, found) = &loads.loads[0];
        assert!(name.ends_with("on tip"), "{name}");
        // Four in all, its middle at x = 8, three from the centroid.
        assert!((found.force[2] - 4.0).abs() < 1e-12 && (found.moment[1] + 12.0).abs() < 1e-11, "{found:?}");
        let supports = outcome.summary.supports.unwrap();
        assert!(
            (supports.force[2] + 4.0).abs() < 1e-8 && (supports.moment[1] - 12.0).abs() < 1e-6,
            "{supports:?}"
        );
    }
}

#[test]
fn an_explicit_run_finds_what_a_static_one_does_under_a_patch() {
    let load = "loads = [{ on = \"tip\", pressure = { value = 4.0, follower = true } }]";
    let text = strip(THIN, load).replace("particles = [41, 5]", "particles = [21, 3]");
    let at_rest = last(&run(&text.replace("analysis.linear = {}", "analysis.static.levels = 1")));
    let marched = text.replace(
        "analysis.linear = {}",
        "analysis.explicit.quasi-static = { levels = 1, period = 4.4, tolerance = 1e-6 }",
    );
    let outcome = run(&marched);
    assert!((last(&outcome) / at_rest - 1.0).abs() < 1e-3, "{} {at_rest}", last(&outcome));
    // It follows the strip: its size stays, its direction does not.
    let [x, _, z] = outcome.summary.supports.unwrap().force;
    assert!((libm::hypot(x, z) / 16.0 - 1.0).abs() < 1e-2 && x > 5.0, "{x} {z}");
}

/// The stepped cantilever under a force at its end, `P/3E [(L³ − l³)/I₁ + l³/I₂]` with shear.
fn stepped() -> f64 {
    let (thick, thin) = (0.4_f64, 0.2_f64);
    let stiff = |t: f64| 1e6 * t.powi(3) / 12.0;
    let shear = |length: f64, t: f64| length / (5.0 / 6.0 * 0.5e6 * t);
    (1000.0 - 64.0) / (3.0 * stiff(thick)) + 64.0 / (3.0 * stiff(thin)) + shear(6.0, thick) + shear(4.0, thin)
}

const END: &str = "loads = [{ on = \"u1\", force = { total = [0.0, 0.0, 1.0] } }]";

#[test]
fn a_stepped_strip_bends_as_two_beams() {
    let parts = "parts = [{ on = \"root\", section.homogeneous.thickness = 0.4 }]";
    let outcome = run(&strip(&format!("{THIN}\n{parts}"), END));
    assert!((last(&outcome) / stepped() - 1.0).abs() < 1e-3, "{} {}", last(&outcome), stepped());
    let lines = &outcome.summary.body.modelled;
    assert!(lines.contains(&"part root: 96 cells, thickness 0.4".to_string()), "{lines:?}");
    assert!(lines.contains(&"part all others: 64 cells, thickness 0.2".to_string()), "{lines:?}");
}

#[test]
fn a_tapered_strip_bends_as_its_integral() {
    // t = 0.4 − 0.02 x: with s = t/t₁ between 1 and ½, w = P ∫ (L − x)²/EI dx.
    let section =
        "section.homogeneous = { thickness = 0.4, taper = { point = [0, 0, 0], gradient = [-0.02, 0, 0] } }";
    let n = 20_000;
    let at = |i: usize| {
        let x = 10.0 * (i as f64 + 0.5) / f64::from(n);
        let t = 0.4 - 0.02 * x;
        (10.0 - x).powi(2) / (1e6 * t.powi(3) / 12.0) + 1.0 / (5.0 / 6.0 * 0.5e6 * t)
    };
    let exact: f64 = (0..n as usize).map(at).sum::<f64>() * 10.0 / f64::from(n);
    let found = last(&run(&strip(section, END)));
    assert!((found / exact - 1.0).abs() < 1e-3, "{found} {exact}");
}

#[test]
fn one_part_over_all_of_a_shell_is_the_shell() {
    let plain = run(&strip(THIN, END));
    let part = "parts = [{ on = \"all\", section.homogeneous.thickness = 0.2 }]";
    let other = run(&strip(&format!("section.homogeneous.thickness = 7.0\n{part}"), END));
    assert_eq!(last(&plain).to_bits(), last(&other).to_bits());
}

/// The stepped strip as a file: nodes along x fastest, quadrangles or triangles, groups `thick` and `thin`.
fn file(format: &str) -> String {
    let (nx, ny) = (40, 4);
    let node = |i: usize, j: usize| 1 + i + (nx + 1) * j;
    let mut nodes = String::new();
    for (j, i) in (0..=ny).flat_map(|j| (0..=nx).map(move |i| (j, i))) {
        let comma = if format == "inp" { ", " } else { " " };
        let row = [
            node(i, j).to_string(),
            (0.25 * i as f64).to_string(),
            (0.25 * j as f64).to_string(),
            "0".into(),
        ];
        nodes.push_str(&format!("{}\n", row.join(comma)));
    }
    let corners = |i: usize, j: usize| [node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)];
    let cells = (0..ny).flat_map(|j| (0..nx).map(move |i| (i, j)));
    if format == "inp" {
        let of = |thick: bool| {
            let own = cells.clone().filter(|(i, _)| (*i < 24) == thick);
            own.map(|(i, j)| {
                let [a, b, c, d] = corners(i, j);
                format!("{}, {a}, {b}, {c}, {d}\n", 1 + i + nx * j)
            })
            .collect::<String>()
        };
        return format!(
            "*Node\n{nodes}*Element, type=S4R, elset=Thick\n{}*Element, type=S4R, elset=thin\n{}\
             *Nset, nset=left, generate\n1, {}, {}\n*Nset, nset=right, generate\n{}, {}, {}\n\
             *Shell Section, elset=thick, material=Steel\n0.4, 5\n*Shell Section, elset=thin, material=STEEL\n0.2\n\
             *Material, name=steel\n*Elastic\n1e6, 0.0\n",
            of(true),
            of(false),
            node(0, ny),
            nx + 1,
            nx + 1,
            node(nx, ny),
            nx + 1
        );
    }
    let mut elements = Vec::new();
    for (i, j) in cells {
        let ([a, b, c, d], group) = (corners(i, j), if i < 24 { 3 } else { 4 });
        elements.push(format!("2 2 {group} {group} {a} {b} {c}"));
        elements.push(format!("2 2 {group} {group} {a} {c} {d}"));
    }
    for j in 0..ny {
        elements.push(format!("1 2 1 1 {} {}", node(0, j), node(0, j + 1)));
        elements.push(format!("1 2 2 2 {} {}", node(nx, j), node(nx, j + 1)));
    }
    let lines: String = (1..).zip(&elements).map(|(k, line)| format!("{k} {line}\n")).collect();
    format!(
        "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n4\n1 1 \"left\"\n1 2 \"right\"\n2 3 \"thick\"\n2 4 \"thin\"\n\
         $EndPhysicalNames\n$Nodes\n{}\n{nodes}$EndNodes\n$Elements\n{}\n{lines}$EndElements\n",
        (nx + 1) * (ny + 1),
        elements.len()
    )
}

/// A scene on such a file.
fn on_file(name: &str, text: &str, more: &str) -> String {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR"));
    fs::write(folder.join(name), text).unwrap();
    let mesh = folder.join(name).to_string_lossy().replace('\\', "/");
    strip(more, END)
        .replace(
            "geometry.plate = { lengths = [10.0, 1.0], particles = [41, 5] }",
            &format!("geometry.mesh.file = \"{mesh}\""),
        )
        .replace("\"u0\"", "\"left\"")
        .replace("\"u1\"", "\"right\"")
}

#[test]
fn groups_of_files_are_parts() {
    let parts = "parts = [{ on = \"thick\", section.homogeneous.thickness = 0.4 }]";
    let gmsh = run(&on_file("stepped.msh", &file("msh"), &format!("{THIN}\n{parts}")));
    assert!((last(&gmsh) / stepped() - 1.0).abs() < 1e-3, "{} {}", last(&gmsh), stepped());
    // Triangles are joined in their group: none of the pairs lies across the step.
    assert!(gmsh.summary.body.modelled.iter().any(|line| line.starts_with("part thick: 96 cells")));
    let abaqus = on_file("stepped.inp", &file("inp"), "section.file = {}")
        .replace("material.elastic = { young = 1e6, poisson = 0.0, density = 2.0 }", "material.file = {}");
    let abaqus = run(&abaqus);
    assert!((last(&abaqus) / last(&gmsh) - 1.0).abs() < 1e-6, "{} {}", last(&abaqus), last(&gmsh));
    // One of the two from the scene.
    let own = run(&on_file("stepped.inp", &file("inp"), "section.file = {}"));
    assert_eq!(last(&own).to_bits(), last(&abaqus).to_bits());
}

#[test]
fn offsets_of_files_go_against_those_of_the_program_that_wrote_them() {
    // The nodes lie on the upper face of the thick part and in the middle of the thin one.
    let flush = file("inp").replace("elset=thick, material", "elset=thick, offset=SPOS, material");
    let outcome = run(&on_file("flush.inp", &flush, "section.file = {}"));
    let by_hand = "parts = [{ on = \"Thick\", section.homogeneous.thickness = 0.4, offset = -0.2 }]";
    let expected = run(&on_file("plain.inp", &file("inp"), &format!("{THIN}\n{by_hand}")));
    assert_eq!(last(&outcome).to_bits(), last(&expected).to_bits());
}

#[test]
fn broken_parts() {
    let parts = "[[parts]]\non = \"root\"\nsection.homogeneous.thickness = 0.4\n";
    let text = format!("{}{parts}", strip(THIN, END));
    let cases = [
        ("no such set", "on = \"root\"", "on = \"rot\""),
        ("nothing of its own", "section.homogeneous.thickness = 0.4\n", ""),
        ("negative thickness", "thickness = 0.4", "thickness = -0.4"),
        ("offset without size", "thickness = 0.4", "thickness = 0.4\noffset = nan"),
        (
            "section of another material",
            "section.homogeneous.thickness = 0.4",
            "section.layered = { axis = [1, 0, 0], plies = [{ thickness = 1.0, angle = 0.0 }] }",
        ),
        (
            "two parts on a cell",
            parts,
            "[[parts]]\non = \"root\"\noffset = 0.1\n[[parts]]\non = \"all\"\noffset = 0.2\n",
        ),
        ("no cell", "on = \"root\"", "on = \"u0\""),
        ("no cell in a region", "max = [6.0, 1.0, 0.0]", "max = [0.1, 1.0, 0.0]"),
        ("wide stencils", "[sets]", "[formulation.stress-point]\nsupport = 1.4\n[sets]"),
        ("no file", "section.homogeneous.thickness = 0.4", "section.file = {}"),
        (
            "taper to nothing",
            "thickness = 0.4",
            "thickness = 0.4\nsection.homogeneous.taper = { point = [0, 0, 0], gradient = [-0.1, 0, 0] }",
        ),
        (
            "taper without direction",
            "thickness = 0.4",
            "thickness = 0.4\nsection.homogeneous.taper = { point = [0, 0, 0], gradient = [0, 0, 0] }",
        ),
        ("misspelt key", "section.homogeneous.thickness = 0.4", "thickness = 0.4"),
        ("no mass", "[[parts]]", "[[masses]]\non = \"root\"\nmass = 0.0\n[[parts]]"),
        ("a mass nowhere", "[[parts]]", "[[masses]]\non = \"engine\"\nmass = 1.0\n[[parts]]"),
    ];
    insta::assert_snapshot!(refused(&text, &cases));
}

#[test]
fn broken_loads_on_cells() {
    let text = strip(THIN, "loads = [{ on = \"tip\", pressure = { value = 1.0 } }]");
    let cases = [
        ("no such set", "on = \"tip\", p", "on = \"tipp\", p"),
        ("an edge", "on = \"tip\", p", "on = \"u1\", p"),
        (
            "a point",
            "on = \"tip\", pressure = { value = 1.0 }",
            "on = \"u1v1\", gravity = { acceleration = [0, 0, 1] }",
        ),
        ("a depth", "pressure = { value = 1.0 }", "traction = { value = [0, 0, 1], depth = 1.0 }"),
        ("a traction without numbers", "pressure = { value = 1.0 }", "traction = { value = [0, 0, nan] }"),
    ];
    insta::assert_snapshot!(refused(&text, &cases));
}

#[test]
fn broken_sections_of_files() {
    let whole = file("inp");
    let text = |name: &str, from: &str, to: &str| {
        assert!(whole.contains(from), "{from}");
        on_file(name, &whole.replacen(from, to, 1), "section.file = {}")
            .replace("material.elastic = { young = 1e6, poisson = 0.0, density = 2.0 }", "material.file = {}")
    };
    let cases = [
        ("no section", text("a.inp", "*Shell Section, elset=thick, material=Steel\n0.4, 5\n", "")),
        ("two sections", text("b.inp", "elset=thin, material", "elset=thick, material")),
        ("no material", text("c.inp", "*Material, name=steel", "*Material, name=iron")),
        ("no moduli", text("d.inp", "*Elastic\n1e6, 0.0\n", "")),
        ("bad moduli", text("e.inp", "1e6, 0.0", "1e6, 0.7")),
        ("a composite", text("f.inp", "material=Steel\n0.4, 5", "composite\n0.4, 5, steel")),
        (
            "masses count",
            text("g.inp", "0.4, 5", "0.4, 5").replace("analysis.linear = {}", "analysis.modal.modes = 2"),
        ),
        (
            "scaled",
            text("h.inp", "0.4, 5", "0.4, 5")
                .replace("mesh.file = ", "mesh.scale = 2.0\ngeometry.mesh.file = "),
        ),
        ("no sections at all", on_file("i.msh", &file("msh"), "section.file = {}")),
    ];
    let mut all = String::new();
    for (name, text) in cases {
        let scene = Scene::parse(&text, "scene.toml").and_then(|scene| scene.build(1));
        let error = scene.err().unwrap_or_else(|| panic!("{name} is not refused"));
        // Wide enough for the path of any folder in one line.
        let said = render(&error, Rendering { width: 400, colour: false });
        all.push_str(&format!("━━━ {name} ━━━\n{}\n", said.trim_end()));
    }
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).to_string_lossy().replace('\\', "/");
    insta::assert_snapshot!(all.replace(&folder, "…"));
}

/// Columns on the strip, `name of more`.
fn columns(list: &[(&str, &str, &str)]) -> String {
    list.iter()
        .map(|(name, of, more)| format!("[[curve]]\nname = \"{name}\"\nof = \"{of}\"\n{more}\n"))
        .collect()
}

#[test]
fn columns_of_strains_are_those_of_a_beam() {
    // A stepped cantilever under a force at its end and one along it.
    let parts = "parts = [{ on = \"root\", section.homogeneous.thickness = 0.4 }]";
    let loads = "loads = [{ on = \"u1\", force = { total = [3.0, 0.0, 1.0] } }]";
    let along = "direction = [1.0, 0.0, 0.0]";
    let list = columns(&[
        ("n", "membrane-force", &format!("on = \"tip\"\n{along}")),
        ("m", "bending-moment", &format!("on = \"first\"\n{along}")),
        ("q", "shear-force", &format!("on = \"tip\"\n{along}")),
        ("top", "stress", &format!("on = \"first\"\n{along}\nface = \"top\"\ntake = \"max\"")),
        ("bottom", "stress", &format!("on = \"first\"\n{along}\nface = \"bottom\"\ntake = \"min\"")),
        ("greatest", "von-mises", "on = \"root\""),
        ("of_root", "energy", "on = \"root\""),
        ("of_tip", "energy", "on = \"tip\""),
        ("fixing", "reaction-moment", "on = \"u0\"\ndirection = [0.0, 1.0, 0.0]\nabout = [4.0, 0.0, 0.0]"),
    ]);
    let text = strip(&format!("{THIN}\n{parts}"), loads).replace(
        "[sets]\n",
        &format!("{list}[sets]\nfirst.box = {{ min = [0.0, 0.0, 0.0], max = [0.2, 1.0, 0.0] }}\n"),
    );
    let small = |text: &str| {
        text.replace("analysis.linear = {}", "analysis.static.levels = 1")
            .replace("[3.0, 0.0, 1.0]", "[0.003, 0.0, 0.001]")
    };
    for (text, size) in [(text.clone(), 1.0), (small(&text), 1e-3)] {
        let outcome = run(&text);
        let value = |name: &str| *outcome.curve.column(name).unwrap().last().unwrap();
        let near = |found: f64, exact: f64, within: f64| {
            assert!((found / exact - 1.0).abs() < within, "{found} {exact}");
        };
        // The first cell has its centre at x = .125: the moment there is −P (L − x), pulling the lower face.
        let arm = 10.0 - 0.125;
        near(value("n"), 3.0 * size, 1e-4);
        near(value("m").abs(), arm * size, 1e-3);
        near(value("q").abs(), 1.0 * size, 1e-3);
        let bending = 6.0 * arm / 0.16;
        let pull = 3.0 / 0.4;
        let [low, high] = [value("top").min(value("bottom")), value("top").max(value("bottom"))];
        near(high, (pull + bending) * size, 1e-3);
        near(low, (pull - bending) * size, 1e-3);
        near(value("greatest"), (pull + bending) * size, 1e-3);
        // ½ ∫ M²/EI + N²/EA + Q²/GA, the first of the thick part from L to l, of the thin one from l to 0.
        let energy = |from: f64, to: f64, t: f64| {
            let stiff = 1e6 * t.powi(3) / 12.0;
            let own = 9.0 / (1e6 * t) + 1.0 / (5.0 / 6.0 * 0.5e6 * t);
            0.5 * ((from.powi(3) - to.powi(3)) / (3.0 * stiff) + own * (from - to)) * size * size
        };
        near(value("of_root"), energy(10.0, 4.0, 0.4), 1e-3);
        near(value("of_tip"), energy(4.0, 0.0, 0.2), 2e-3);
        // The supports bear the moment of the force about x = 4: 6 about −y.
        near(value("fixing"), 6.0 * size, 1e-3);
        let total: f64 = value("of_root") + value("of_tip");
        near(outcome.summary.record.energies.internal, total, 1e-3);
    }
}

#[test]
fn broken_columns_of_strains() {
    let list = columns(&[("s", "stress", "on = \"tip\"\ndirection = [1.0, 0.0, 0.0]\nface = \"top\"")]);
    let text = strip(THIN, END).replace("[sets]", &format!("{list}[sets]"));
    let cases = [
        ("no face", "\nface = \"top\"", ""),
        ("a face of no stress", "\"stress\"", "\"membrane-force\""),
        ("no direction", "direction = [1.0, 0.0, 0.0]\nface", "face"),
        ("a direction of a number", "\"stress\"", "\"von-mises\""),
        ("across the surface", "direction = [1.0, 0.0, 0.0]\nface", "direction = [0.0, 0.0, 1.0]\nface"),
        ("no cells", "on = \"tip\"\ndirection", "on = \"u0\"\ndirection"),
        ("a point of no moment", "face = \"top\"", "face = \"top\"\nabout = [0, 0, 0]"),
        ("unknown face", "face = \"top\"", "face = \"left\""),
    ];
    insta::assert_snapshot!(refused(&text, &cases));
}
