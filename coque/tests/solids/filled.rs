//! Solids that fill a surface from a file: the block where it is one, loads by area of the true size, sets that turn.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use crate::common::surfaces::Obj;
use crate::common::{column, last, overridden, ran, text};

/// A bar whose places are no binary numbers.
const LOW: [f64; 3] = [0.3, -0.7, 1.1];
const HIGH: [f64; 3] = [1.5, -0.1, 1.7];

fn bar(geometry: &str, rest: &str) -> String {
    format!(
        "title = \"Bar\"\nunits = {{ length = \"m\", force = \"N\", time = \"s\" }}\n{rest}\n\
         [bodies.bar.solid]\ngeometry.{geometry}\nmaterial.elastic = {{ young = 1000.0, poisson = 0.3, density = 2.0 }}\n\
         formulation.state-based = {{ horizon = 2.015 }}\n"
    )
}

fn filled(file: &str) -> String {
    format!("filled = {{ file = {file:?}, spacing = 0.1 }}")
}

const BLOCK: &str = "block = { lengths = [1.2, 0.6, 0.6], spacing = 0.1, origin = [0.3, -0.7, 1.1] }";

/// Nodes and volumes are the same to rounding, and so is what forces, gravity and prescribed motions do to them.
#[test]
fn a_bar_from_a_mesh_is_the_block() {
    let rest = "analysis.static = { levels = 2 }\n\
        supports = [{ on = \"root\", clamped = {} }, { on = \"x1\", moved = { direction = [0, 0, 1], by = 0.001 } }]\n\
        loads = [{ on = \"x1\", force = { total = [0.3, 0.0, -0.2] } }, { on = \"all\", gravity = { acceleration = [0, 9.81, 0] } }]\n\
        sets.root = { layer = { face = \"x0\", depth = 0.25 } }\n\
        curve = [{ name = \"u\", of = \"displacement\", on = \"x1\", direction = [1, 0, 0] }, \
                 { name = \"w\", of = \"displacement\", on = \"x1\", direction = [0, 0, 1] }, \
                 { name = \"R\", of = \"reaction\", on = \"root\", direction = [0, 1, 0] }]";
    let file = Obj::cuboid(LOW, HIGH).write("bar");
    let [block, mesh] =
        [BLOCK.to_string(), filled(&file)].map(|geometry| ran(overridden(&bar(&geometry, rest), "", &[])));
    for name in ["u", "w", "R"] {
        for (one, other) in column(&block, name).into_iter().zip(column(&mesh, name)) {
            // Measured 4e-12: places differ by 1e-16 of their coordinates; three times that.
            assert!((one - other).abs() <= 1.2e-11 * one.abs(), "{name}: {one} {other}");
        }
    }
}

/// What planes of symmetry bear is the pressure on the surface that the triangles cut out of them.
#[test]
fn the_pressure_in_a_cavity_is_borne_in_full() {
    let name = "meshes/hollow-ball.toml";
    let replaced = [
        ("bodies.ball.solid.geometry.filled.spacing", "12.5"),
        ("curve", "[{ name = \"R\", of = \"reaction\", on = \"x0\", direction = [1.0, 0.0, 0.0] }]"),
    ];
    let origin = crate::common::scenes().join(name);
    let found = last(&ran(overridden(&text(name), origin.to_str().unwrap(), &replaced)), "R");
    // Corners of the cavity in the plane x = 0 in order of their angle: triangles from the middle.
    let obj = Obj::parse(&text("meshes/hollow-ball.obj"));
    let mut rim: Vec<[f64; 2]> = obj
        .vertices
        .iter()
        .filter(|x| x[0] == 0.0 && x[1] * x[1] + x[2] * x[2] < 75.0 * 75.0)
        .map(|x| [x[1], x[2]])
        .collect();
    rim.sort_by(|a, b| (a[0] / a[1]).total_cmp(&(b[0] / b[1])));
    let area: f64 = rim.windows(2).map(|p| 0.5 * (p[1][0] * p[0][1] - p[0][0] * p[1][1])).sum();
    assert!((area / (std::f64::consts::PI * 625.0) - 1.0).abs() < 2e-3, "{area}");
    assert!((found / (-100.0 * area) - 1.0).abs() < 1e-8, "{found} {}", -100.0 * area);
}

/// Tractions and pressures on groups, on planes of the box, on all of the surface and on what a region holds of it.
#[test]
fn loads_by_area_have_the_size_of_their_part() {
    let file = Obj::cuboid(LOW, HIGH).write("loaded");
    let reaction = |load: &str, along: &str| {
        let rest = format!(
            "analysis.linear = {{}}\nsupports = [{{ on = \"root\", clamped = {{}} }}]\nloads = [{{ {load} }}]\n\
             sets.root = {{ layer = {{ face = \"x0\", depth = 0.25 }} }}\nsets.tip = {{ layer = {{ face = \"x1\", depth = 0.15 }} }}\n\
             curve = [{{ name = \"R\", of = \"reaction\", on = \"root\", direction = {along} }}]"
        );
        last(&ran(overridden(&bar(&filled(&file), &rest), "", &[])), "R")
    };
    let x = "[1, 0, 0]";
    for (load, along, wanted) in [
        ("on = \"x1\", traction = { value = [2, 0, 0] }", x, -0.72),
        ("on = \"side1\", traction = { value = [2, 0, 0] }", x, -0.72),
        ("on = \"x1\", traction = { value = [2, 0, 0], depth = 0.2 }", x, -0.72),
        ("on = \"x1\", pressure = { value = 2 }", x, 0.72),
        ("on = \"side3\", pressure = { value = 2 }", "[0, 1, 0]", 1.44),
        ("on = \"surface\", traction = { value = [1, 0, 0] }", x, -3.6),
        // The end, and two spacings of the four sides.
        ("on = \"tip\", traction = { value = [1, 0, 0] }", x, -0.84),
    ] {
        let found = reaction(load, along);
        assert!((found / wanted - 1.0).abs() < 1e-9, "{load}: {found}");
    }
    // An even pressure all round has no resultant.
    assert!(reaction("on = \"surface\", pressure = { value = 2 }", x).abs() < 1e-9);
}

/// A director that stays in a plane may not be turned out of it.
#[test]
fn a_held_director_does_not_turn() {
    let built = |axis: &str| {
        let held = "{ on = \"x0\", held = { director = [[1, 0, 0]] } }";
        let turned = format!("{{ on = \"x0\", turned = {{ axis = {axis}, by = 5 }} }}");
        let supports = format!("[{held}, {turned}]");
        crate::common::scene("plate-pd.toml", &[("supports", &supports)]).unwrap().build(1).map(|_| ())
    };
    // About y it would leave the plane normal to x; about x it stays in it.
    let fault = built("[0, 1, 0]").unwrap_err().to_string();
    assert!(fault.contains("node 0 is prescribed to move"), "{fault}");
    built("[1, 0, 0]").unwrap();
}

/// A set that is called as a group would be nodes to a support and the group to a pressure.
#[test]
fn a_set_may_not_be_called_as_a_group() {
    let file = Obj::cuboid(LOW, HIGH).write("named");
    let rest = "analysis.linear = {}\nsupports = [{ on = \"x0\", clamped = {} }]\n\
                sets.side1 = { layer = { face = \"x1\", depth = 0.2 } }\nloads = [{ on = \"side1\", pressure = { value = 1 } }]";
    let fault = overridden(&bar(&filled(&file), rest), "", &[]).unwrap().build(1).unwrap_err().to_string();
    assert!(
        fault.contains("`sets.side1`") && fault.contains("the file has a group that is called so"),
        "{fault}"
    );
}

/// What lies in a plane of symmetry is no surface: half of a bar under loads on all of its surface, or on a region, is half of it.
#[test]
fn a_half_bears_half_of_what_acts_on_its_surface() {
    let whole = Obj::cuboid(LOW, HIGH).write("whole");
    let half = Obj::cuboid([LOW[0], -0.4, LOW[2]], HIGH).write("half");
    let found = |file: &str, mirror: &str, on: &str| {
        let rest = format!(
            "analysis.linear = {{}}\nsupports = [{{ on = \"root\", clamped = {{}} }}{mirror}]\n\
             loads = [{{ on = \"{on}\", traction = {{ value = [2, 0, 0.3] }} }}]\n\
             sets.root = {{ layer = {{ face = \"x0\", depth = 0.25 }} }}\nsets.tip = {{ layer = {{ face = \"x1\", depth = 0.15 }} }}\n\
             curve = [{{ name = \"R\", of = \"reaction\", on = \"root\", direction = [1, 0, 0] }}, \
                      {{ name = \"u\", of = \"displacement\", on = \"x1\", direction = [1, 0, 0] }}]"
        );
        let outcome = ran(overridden(&bar(&filled(file), &rest), "", &[]));
        ["R", "u"].map(|name| last(&outcome, name))
    };
    for on in ["surface", "tip"] {
        let [reaction, u] = found(&whole, "", on);
        let mirror = ", { on = \"y0\", symmetry = { normal = [0, 1, 0] } }";
        let [of_half, u_of_half] = found(&half, mirror, on);
        assert!((2.0 * of_half / reaction - 1.0).abs() < 1e-9, "{on}: {of_half} {reaction}");
        assert!((u_of_half / u - 1.0).abs() < 1e-8, "{on}: {u_of_half} {u}");
    }
}

/// A dead pressure on the faces of a block is the traction against their normals, in a plane too.
#[test]
fn a_pressure_on_a_block_is_a_traction_inwards() {
    let plane = "block = { lengths = [1.2, 0.6], spacing = 0.1 }";
    for (geometry, face, inward) in
        [(BLOCK, "y1", "[0, -3, 0]"), (BLOCK, "x0", "[3, 0, 0]"), (plane, "y0", "[0, 3, 0]")]
    {
        let of = |load: &str| {
            let rest = format!(
                "analysis.linear = {{}}\nsupports = [{{ on = \"x1\", clamped = {{}} }}]\nloads = [{{ on = \"{face}\", {load} }}]\n\
                 curve = [{{ name = \"u\", of = \"displacement\", on = \"{face}\", direction = [1, 1, 0] }}]"
            );
            let scene = bar(geometry, &rest);
            let scene = if geometry == plane {
                scene.replace("2.015 }", "2.015, plane = \"stress\" }")
            } else {
                scene
            };
            last(&ran(overridden(&scene, "", &[])), "u")
        };
        let [pressed, pulled] =
            [of("pressure = { value = 3 }"), of(&format!("traction = {{ value = {inward} }}"))];
        assert!(pressed != 0.0 && pressed == pulled, "{pressed} {pulled}");
    }
}

/// The end of a bar turned by a right angle takes the rest along, and a bar turned at both ends against each other bears a torque.
#[test]
fn a_bar_goes_with_its_turned_end() {
    let turn = |by: f64| format!("turned = {{ axis = [0, 0, 1], point = [0.3, -0.7, 0], by = {by} }}");
    let rest = format!(
        "analysis.static = {{ levels = 6 }}\nsupports = [{{ on = \"x0\", {} }}]\nsets.corner = {{ nearest = [1.45, -0.65, 1.15] }}\n\
         curve = [{{ name = \"x\", of = \"position\", on = \"corner\", direction = [1, 0, 0] }}, {{ name = \"y\", of = \"position\", on = \"corner\", direction = [0, 1, 0] }}]",
        turn(90.0)
    );
    let outcome = ran(overridden(&bar(BLOCK, &rest), "", &[]));
    // The corner is 1.15 along x and .05 along y from the axis, which a right angle makes −.05 and 1.15.
    let [x, y] = ["x", "y"].map(|name| last(&outcome, name));
    assert!((x - 0.25).abs() < 1e-6 && (y - 0.45).abs() < 1e-6, "{x} {y}");
    let plane = "block = { lengths = [1.2, 0.6], spacing = 0.1 }";
    let scene = bar(plane, &rest)
        .replace("2.015 }", "2.015, plane = \"strain\" }")
        .replace("1.45, -0.65, 1.15", "1.15, 0.05, 0");
    let outcome = ran(overridden(&scene.replace("point = [0.3, -0.7, 0]", "point = [0, 0, 0]"), "", &[]));
    let [x, y] = ["x", "y"].map(|name| last(&outcome, name));
    assert!((x + 0.05).abs() < 1e-6 && (y - 1.15).abs() < 1e-6, "{x} {y}");
}

/// Ends that turn against each other bear one torque, that of Saint-Venant's bar but for six nodes across; about any point of space.
#[test]
fn turned_ends_bear_a_torque() {
    let rest = "analysis.linear = {}\n\
        supports = [{ on = \"root\", clamped = {} }, { on = \"tip\", turned = { axis = [1, 0, 0], point = [0, -0.4, 1.4], by = 0.1 } }]\n\
        sets.root = { layer = { face = \"x0\", depth = 0.2 } }\nsets.tip = { layer = { face = \"x1\", depth = 0.2 } }\n\
        curve = [{ name = \"M\", of = \"reaction-moment\", on = \"tip\", direction = [1, 0, 0], about = [9, -0.4, 1.4] }, \
                 { name = \"R\", of = \"reaction-moment\", on = \"root\", direction = [1, 0, 0] }]";
    let outcome = ran(overridden(&bar(BLOCK, rest), "", &[]));
    let [tip, root] = ["M", "R"].map(|name| last(&outcome, name));
    assert!((tip + root).abs() < 1e-7 * tip, "{tip} {root}");
    // G J θ/L, J = .1406 a⁴ of a square, .8 m free between the layers: measured below; bonds of two spacings across six nodes make .9 of it.
    let exact = 1000.0 / 2.6 * 0.1406 * 0.6_f64.powi(4) * 0.1_f64.to_radians() / 0.8;
    assert!((tip / exact - 1.0).abs() < 0.2, "{}", tip / exact);
}

/// Nodes of a loaded cavity lack bonds and move too far: a run that reads them warns of it, one that reads the other face does not.
#[test]
fn a_loaded_cavity_that_is_read_is_warned_of() {
    let name = "meshes/hollow-ball.toml";
    let origin = crate::common::scenes().join(name);
    let warned = |on: &str| {
        let changed = [("curve.0.on", on), ("bodies.ball.solid.geometry.filled.spacing", "12.5")];
        let model = overridden(&text(name), origin.to_str().unwrap(), &changed).unwrap().build(1).unwrap();
        model.warnings().iter().map(|warning| warning.kind).collect::<Vec<_>>()
    };
    assert_eq!(warned("cavity"), [coque::WarningKind::LoadedFace]);
    assert!(warned("outer").is_empty());
}

/// A fin that is too thin for nodes is warned of with a place of it; a spacing below its thickness ends that.
#[test]
fn a_fin_without_nodes_is_warned_of() {
    let fin = Obj::cuboid([1.5, -0.6, 1.38], [1.8, -0.2, 1.42]);
    let finned = Obj::cuboid(LOW, HIGH).with(&fin);
    let file = finned.write("finned");
    let rest = "analysis.linear = {}\nsupports = [{ on = \"x0\", clamped = {} }]\nloads = [{ on = \"side1\", pressure = { value = 1 } }]";
    let warned = |spacing: &str| {
        let scene = bar(&filled(&file).replace("spacing = 0.1", &format!("spacing = {spacing}")), rest);
        overridden(&scene, "", &[]).unwrap().build(1).unwrap().warnings().to_vec()
    };
    let [warning] = &warned("0.1")[..] else { panic!("one warning") };
    assert_eq!(warning.kind, coque::WarningKind::ThinFins);
    // Two of three cells of the fin are away: .0032 of .4368.
    assert!(warning.message.starts_with("0.73 % of the volume"), "{}", warning.message);
    assert!(warned("0.04").is_empty());
}
