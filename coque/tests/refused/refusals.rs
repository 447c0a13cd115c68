//! What a user reads when a scene is wrong: one broken scene each, rendered as in a terminal.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use std::fs;
use std::path::Path;

use coque::{Checked, Rendering, Scene, SceneError, render};

fn text(name: &str) -> String {
    fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("../scenes").join(name)).unwrap()
}

/// Reads and builds the ring after replacing `from` by `to`; renders what is refused.
fn broken(from: &str, to: &str) -> String {
    let text = text("ring.toml");
    assert!(text.contains(from), "the ring no longer says {from}");
    refused(Scene::parse(&text.replacen(from, to, 1), "ring.toml"))
}

fn refused(scene: Result<Checked, SceneError>) -> String {
    match scene.and_then(|scene| scene.build(1)) {
        Ok(_) => "not refused".into(),
        Err(error) => render(&error, Rendering { width: 100, colour: false }),
    }
}

#[test]
fn broken_scenes() {
    let cases = [
        ("not TOML", "[section.homogeneous]", "[section.homogeneous"),
        ("misspelt key", "young = 1200.0", "yuong = 1200.0"),
        ("unknown table at the top", "[section.homogeneous]", "[sections.homogeneous]"),
        ("misspelt alternative", "[material.elastic]", "[material.elastik]"),
        ("missing key", "density = 1.0\n", ""),
        ("wrong type", "young = 1200.0", "young = \"stiff\""),
        ("unknown unit", "force = \"N\"", "force = \"kg\""),
        ("mixed units", "force = \"N\"", "force = \"-\""),
        ("not a number", "young = 1200.0", "young = nan"),
        ("too big for a number", "young = 1200.0", "young = 1e400"),
        ("negative thickness", "thickness = 1.0", "thickness = -1.0"),
        ("incompressible", "poisson = 0.0", "poisson = 0.5"),
        ("one particle", "particles = [50, 5]", "particles = [50, 1]"),
        ("too many particles", "particles = [50, 5]", "particles = [50000, 5000]"),
        ("even row has no centre", "particles = [50, 5]", "particles = [50, 4]"),
        ("unknown set", "on = \"u1\"", "on = \"u2\""),
        ("two conditions", "clamped = {}", "clamped = {}\nhinged = {}"),
        ("no condition", "clamped = {}\n", ""),
        ("zero direction", "normal = [0.0, 1.0, 0.0]", "normal = [0.0, 0.0, 0.0]"),
        (
            "couple about the edge on a point",
            "on = \"u1\"\ncouple = { moment = 62.83185307179586, axis = [0.0, -1.0, 0.0] }",
            "on = \"u1v1\"\ncouple = { moment = 62.83185307179586, axis = \"edge\" }",
        ),
        ("levels out of order", "0.25, 0.375", "0.375, 0.25"),
        ("no levels", "levels = [0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875, 1.0]", "levels = []"),
        (
            "safety",
            "[analysis.explicit.quasi-static]",
            "[analysis.explicit]\nsafety = 1.5\n[analysis.explicit.quasi-static]",
        ),
        (
            "two analyses",
            "[analysis.explicit.quasi-static]",
            "[analysis.explicit.transient]\nduration = 1.0\nrecord_every = 0.1\n[analysis.explicit.quasi-static]",
        ),
        (
            "amplitude along a path",
            "axis = [0.0, -1.0, 0.0] }",
            "axis = \"edge\" }\namplitude = { smooth = 2.0 }\n#",
        ),
        ("column twice", "name = \"W_tip\"", "name = \"minus_U_tip\""),
        ("unit of something else", "name = \"W_tip\"", "name = \"W_tip\"\nunit = \"kN\""),
        (
            "unknown unit of a force by area",
            "name = \"W_tip\"\nof = \"displacement\"\non = \"u1\"\ndirection = [0.0, 0.0, 1.0]",
            "name = \"W_tip\"\nof = \"stress\"\non = \"u1\"\nface = \"top\"\ndirection = [1.0, 0.0, 0.0]\nunit = \"psi\"",
        ),
        ("plot of nothing", "y = \"level\"", "y = \"W_tipp\""),
        ("unknown kernel", "thickness = 1.0", "thickness = 1.0\n[formulation.nodal]\nkernel = \"gaussian\""),
        (
            "support below four particles",
            "thickness = 1.0",
            "thickness = 1.0\n[formulation.stress-point]\nsupport = 0.9",
        ),
        (
            "too few particles for the order",
            "particles = [50, 5]\n",
            "particles = [50, 2]\n[formulation.nodal]\norder = 3\nsmoothing = 1.4\n",
        ),
        (
            "empty box",
            "[[supports]]\non = \"u0\"",
            "[sets]\ntip = { box = { min = [11.0, 0.0, 0.0], max = [12.0, 1.0, 1.0] } }\n[[supports]]\non = \"u0\"",
        ),
        ("free rotation", "clamped = {}", "hinged = {}"),
        ("free to move", "clamped = {}", "symmetry = { normal = [1.0, 0.0, 0.0] }"),
    ];
    let mut all = String::new();
    for (name, from, to) in cases {
        all.push_str(&format!("━━━ {name} ━━━\n{}\n", broken(from, to).trim_end()));
    }
    assert!(!all.contains("not refused"), "{all}");
    insta::assert_snapshot!(all);
}

/// The ring with its shell as the body `strip`.
fn named() -> String {
    ["geometry.plate", "material.elastic", "section.homogeneous"]
        .into_iter()
        .fold(text("ring.toml"), |text, key| {
            text.replace(&format!("[{key}]"), &format!("[bodies.strip.shell.{key}]"))
        })
}

#[test]
fn broken_bodies() {
    let whole = named();
    assert_eq!(refused(Scene::parse(&whole, "ring.toml")), "not refused");
    let cases = [
        ("negative thickness", "thickness = 1.0", "thickness = -1.0"),
        ("misspelt key", "young = 1200.0", "yuong = 1200.0"),
        ("misspelt key of the body", "[bodies.strip.shell.section.", "[bodies.strip.shell.sections."),
        ("missing key", "density = 1.0\n", ""),
        ("missing table", "[bodies.strip.shell.section.homogeneous]\nthickness = 1.0\n", ""),
        ("one particle", "particles = [50, 5]", "particles = [50, 1]"),
        ("even row has no centre", "particles = [50, 5]", "particles = [50, 4]"),
        (
            "section of another material",
            "[bodies.strip.shell.section.homogeneous]\nthickness = 1.0",
            "[bodies.strip.shell.section.layered]\naxis = [1, 0, 0]\nplies = [{ thickness = 1.0, angle = 0.0 }]",
        ),
        (
            "unknown formulation",
            "thickness = 1.0",
            "thickness = 1.0\n[bodies.strip.shell.formulation.galerkin]",
        ),
        (
            "no such order",
            "thickness = 1.0",
            "thickness = 1.0\n[bodies.strip.shell.formulation.nodal]\norder = 4",
        ),
        (
            "too few particles for the order",
            "particles = [50, 5]\n",
            "particles = [50, 2]\n[bodies.strip.shell.formulation.nodal]\norder = 3\nsmoothing = 1.4\n",
        ),
        ("both forms", "[bodies.strip.shell.section.homogeneous]", "[section.homogeneous]"),
        (
            "no body",
            &whole[..],
            "title = \"nothing\"\nunits = { length = \"m\", force = \"N\", time = \"s\" }\nanalysis.modal.modes = 1",
        ),
        ("no kind", "[bodies.strip.shell.section.homogeneous]", "[bodies.shell.section.homogeneous]"),
        ("unknown kind", "[bodies.strip.shell.", "[bodies.strip.beam."),
        (
            "two kinds",
            "[bodies.strip.shell.section.homogeneous]\n",
            "[bodies.strip.solid]\n[bodies.strip.shell.section.homogeneous]\n",
        ),
        (
            "two bodies",
            "[analysis",
            "[bodies.plate.shell]\ngeometry.plate = { lengths = [1.0, 1.0], particles = [3, 3] }\nmaterial.elastic = { young = 1.0, poisson = 0.0, density = 1.0 }\nsection.homogeneous = { thickness = 0.1 }\n[analysis",
        ),
        ("a name with a dot", "[bodies.strip.", "[bodies.\"a.strip\"."),
        ("set of no body", "on = \"u1\"", "on = \"stripe.u1\""),
        (
            "region of no body",
            "[output]",
            "[sets]\ntip = { of = \"stripe\", nearest = [10.0, 0.5, 0.0] }\n[output]",
        ),
    ];
    let mut all = String::new();
    for (name, from, to) in cases {
        assert!(whole.contains(from), "the ring no longer says {from}");
        let broken = whole.replace(from, to);
        let message = refused(Scene::parse(&broken, "ring.toml"));
        all.push_str(&format!("━━━ {name} ━━━\n{}\n", message.trim_end()));
    }
    assert!(!all.contains("not refused"), "{all}");
    insta::assert_snapshot!(all);
}

#[test]
fn broken_overrides() {
    let abyss = "a.".repeat(50_000) + "a";
    let refused_at = refused(Scene::with_overrides(&text("ring.toml"), "ring.toml", &[(abyss, "1".into())]));
    assert!(refused_at.contains("50001 keys"));
    let cases = [
        ("unknown path", "material.elastic.yuong", "3.0"),
        ("unknown table", "materials.elastic.young", "3.0"),
        ("no such item", "loads[3].couple.moment", "3.0"),
        ("item within an appended one", "loads[+].force.total", "[0, 0, 1]"),
        ("appended to a table", "material[+]", "1"),
        ("below a number", "material.elastic.young.real", "3.0"),
        ("no value", "material.elastic.young", ""),
        ("not TOML", "geometry.plate.particles", "[3, "),
        ("out of bounds", "section.homogeneous.thickness", "-2"),
        ("wrong type", "section.homogeneous.thickness", "thick"),
        ("not finite", "section.homogeneous.thickness", "inf"),
    ];
    let mut all = String::new();
    for (name, path, value) in cases {
        let pair = [(path.to_string(), value.to_string())];
        let message = refused(Scene::with_overrides(&text("ring.toml"), "ring.toml", &pair));
        all.push_str(&format!("━━━ {name} ━━━\n{}\n", message.trim_end()));
    }
    insta::assert_snapshot!(all);
}

#[test]
fn motion_without_its_course() {
    let transient = ("analysis.explicit", "{ transient = { duration = 0.003, record_every = 0.001 } }");
    let refusal = |more: &[(&str, &str)]| {
        let pairs: Vec<_> = more.iter().map(|(path, value)| (path.to_string(), value.to_string())).collect();
        refused(Scene::with_overrides(&text("panel.toml"), "panel.toml", &pairs))
    };
    let mut all = refusal(&[transient]);
    for amplitude in ["\"constant\"", "{ table = [[0.0, 1.0], [0.003, 2.0]] }", "{ table = [] }"] {
        all.push_str(&refusal(&[transient, ("supports[3].amplitude", amplitude)]));
    }
    all.push_str(&refusal(&[("supports[3].amplitude", "{ ramp = 0.003 }")]));
    all.push_str(&refusal(&[transient, ("supports[0].amplitude", "{ ramp = 0.003 }")]));
    insta::assert_snapshot!(all);
    assert_eq!(refusal(&[transient, ("supports[3].amplitude", "{ ramp = 0.003 }")]), "not refused");
}

#[test]
fn broken_motions() {
    let free = ("supports", "[]");
    let transient = ("analysis.explicit", "{ transient = { duration = 1.0, record_every = 0.1 } }");
    let rotated = ("supports[+]", "{ on = \"u1\", rotated = { axis = [0, 1, 0], by = 90 } }");
    let cases: [(&str, &[(&str, &str)]); 11] = [
        ("velocity along a path", &[("velocity.linear", "[1, 0, 0]")]),
        ("no velocity", &[free, transient, ("velocity", "{}")]),
        ("spin without an axis", &[free, transient, ("velocity.spin", "{ axis = [0, 0, 0], rate = 1 }")]),
        ("spin without a rate", &[free, transient, ("velocity.spin", "{ axis = [0, 0, 1] }")]),
        (
            "rotation without an axis",
            &[("supports[+]", "{ on = \"u1\", rotated = { axis = [0, 0, 0], by = 90 } }")],
        ),
        ("rotation without its course", &[transient, rotated]),
        ("rotation and motion", &[rotated, ("supports[2].moved", "{ direction = [0, 0, 1], by = 1 }")]),
        (
            "no rotation",
            &[rotated, ("supports[2].rotated.by", "0"), ("loads", "[]"), ("analysis.static.levels", "1")],
        ),
        ("loose relaxation", &[("analysis.relaxation.levels", "4"), ("analysis.relaxation.tolerance", "1")]),
        (
            "relaxation without iterations",
            &[("analysis.relaxation.levels", "4"), ("analysis.relaxation.iterations", "0")],
        ),
        (
            "unknown damping",
            &[("analysis.relaxation.levels", "4"), ("analysis.relaxation.damping", "viscous")],
        ),
    ];
    let mut all = String::new();
    for (name, replaced) in cases {
        let pairs: Vec<_> =
            replaced.iter().map(|(path, value)| (path.to_string(), value.to_string())).collect();
        let message = refused(Scene::with_overrides(&text("ring.toml"), "ring.toml", &pairs));
        all.push_str(&format!("━━━ {name} ━━━\n{}\n", message.trim_end()));
    }
    assert!(!all.contains("not refused"), "{all}");
    insta::assert_snapshot!(all);
}

#[test]
fn contradicting_motion() {
    let message =
        text("panel.toml").replace("direction = [0.0, 0.0, -1.0], by", "direction = [1.0, 0.0, -1.0], by");
    insta::assert_snapshot!(refused(Scene::parse(&message, "panel.toml")));
}

/// What other programs have or call otherwise.
#[test]
fn words_of_other_programs() {
    let cases = [
        ("material.plastic", "{ yield = 250.0 }"),
        ("friction", "0.3"),
        ("analysis.implicit", "{}"),
        ("supports[0].fixed", "true"),
        ("material.elastic.nu", "0.3"),
        ("section", "[{ thickness = 1.0 }]"),
        ("velocity", "[0, 0, 1]"),
    ];
    let mut all = String::new();
    for (path, value) in cases {
        let replaced = [(path.to_string(), value.to_string())];
        let scene = Scene::with_overrides(&text("ring.toml"), "ring.toml", &replaced);
        all.push_str(&format!("━━━ {path} ━━━\n{}\n", refused(scene).trim_end()));
    }
    assert!(!all.contains("not refused"), "{all}");
    insta::assert_snapshot!(all);
}

#[test]
fn broken_layers() {
    let homogeneous = ("section.homogeneous.thickness", "12.7");
    let elastic = ("material.elastic", "{ young = 3300.0, poisson = 0.3, density = 7.8e-9 }");
    let cases: [(&str, &[(&str, &str)]); 14] = [
        ("orthotropic in a homogeneous section", &[homogeneous]),
        ("isotropic in a layered section", &[elastic]),
        ("no plies", &[("section.layered.plies", "[]")]),
        ("ply without thickness", &[("section.layered.plies[1].thickness", "0.0")]),
        ("ply without an angle", &[("section.layered.plies", "[{ thickness = 1.0 }]")]),
        ("angle not finite", &[("section.layered.plies[1].angle", "inf")]),
        ("angle beyond a turn", &[("section.layered.plies[1].angle", "450.0")]),
        ("thicker than the radius", &[("section.layered.plies[2].thickness", "2540.0")]),
        ("no axis", &[("section.layered.axis", "[0.0, 0.0, 0.0]")]),
        ("axis that stands on the surface", &[("section.layered.axis", "[0.0, 0.0, 1.0]")]),
        ("negative modulus", &[("material.orthotropic.young_across", "-1100.0")]),
        ("no shear across", &[("material.orthotropic.shear_across", "0.0")]),
        ("minor Poisson's ratio beyond the bound", &[("material.orthotropic.poisson", "1.75")]),
        ("misspelt modulus", &[("material.orthotropic.young_accross", "1100.0")]),
    ];
    let mut all = String::new();
    for (name, replaced) in cases {
        // A crown with a cell of its own, whose normal is z.
        let crown =
            [("geometry.cylinder.angles", "[-5.0, 5.0]"), ("geometry.cylinder.particles", "[10, 11]")];
        let pairs: Vec<_> =
            crown.iter().chain(replaced).map(|(path, value)| (path.to_string(), value.to_string())).collect();
        let scene = Scene::with_overrides(&text("panel-laminated.toml"), "panel-laminated.toml", &pairs);
        all.push_str(&format!("━━━ {name} ━━━\n{}\n", refused(scene).trim_end()));
    }
    assert!(!all.contains("not refused"), "{all}");
    insta::assert_snapshot!(all);
}

#[test]
fn broken_places() {
    let scattered = "scattered = { spacing = 0.25, seed = 1 }";
    let cases = [
        ("both ways", "particles = [50, 5]\nscattered = { spacing = 0.2, seed = 1 }"),
        ("neither way", ""),
        ("no seed", "scattered = { spacing = 0.2 }"),
        ("spacing of nothing", "scattered = { spacing = 0.0, seed = 1 }"),
        ("wider than an edge", "scattered = { spacing = 1.5, seed = 1 }"),
        ("too fine", "scattered = { spacing = 1e-4, seed = 1 }"),
        (
            "disorder of nothing",
            "scattered = { spacing = 0.2, seed = 1 }\ndisorder = { fraction = 0.1, seed = 1 }",
        ),
        ("grading of nothing", "scattered = { spacing = 0.2, seed = 1 }\ngrading = [2.0, 1.0]"),
        ("grading without bound", "particles = [50, 5]\ngrading = [1.0, 5000.0]"),
        ("grading backwards", "particles = [50, 5]\ngrading = [-2.0, 1.0]"),
        ("middle row of scattered particles", scattered),
    ];
    let mut all = String::new();
    for (name, to) in cases {
        all.push_str(&format!("━━━ {name} ━━━\n{}\n", broken("particles = [50, 5]", to).trim_end()));
    }
    assert!(!all.contains("not refused"), "{all}");
    insta::assert_snapshot!(all);
}
