//! Shapes of rigid bodies in fluids: faces on rows of particles, meshes beside the boxes that they are, thin and sharp ones, widths across a plane.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use std::fs;
use std::path::Path;

use crate::common::fluids::AFLOAT;
use crate::common::{column, overridden, ran};
use coque::{Outcome, Rendering, WarningKind, render};

const BOX: &str = "bodies.float.rigid.geometry.box";
const VELOCITY: &str = "bodies.float.rigid.velocity";
const DURATION: (&str, &str) = ("analysis.explicit.transient.duration", "0.02");

/// Greatest difference of a column over its greatest value, the other's times a factor.
fn apart(one: &Outcome, other: &Outcome, name: &str, factor: f64) -> f64 {
    let [one, other] = [one, other].map(|outcome| column(outcome, name));
    let most = one.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
    one.iter().zip(&other).fold(0.0_f64, |most, (x, y)| most.max((x - factor * y).abs())) / most
}

/// A prism along z, .08 wide, over a polygon that runs anticlockwise: the text of AFLOAT with its mesh.
fn prism(name: &str, corners: &[[f64; 2]]) -> String {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("prisms");
    fs::create_dir_all(&folder).unwrap();
    let (count, mut text) = (corners.len(), String::new());
    for z in [-0.04, 0.04] {
        text.extend(corners.iter().map(|[x, y]| format!("v {x} {y} {z}\n")));
    }
    for i in 0..count {
        let next = (i + 1) % count;
        text += &format!("f {} {} {} {}\n", i + 1, next + 1, next + count + 1, i + count + 1);
    }
    for i in 1..count - 1 {
        text += &format!("f 1 {} {}\nf {} {} {}\n", i + 2, i + 1, count + 1, count + i + 1, count + i + 2);
    }
    let file = folder.join(format!("{name}.obj"));
    fs::write(&file, text).unwrap();
    let given = "geometry.box = { min = [0.16, 0.14, -0.04], max = [0.32, 0.26, 0.04], spacing = 0.04 }";
    assert!(AFLOAT.contains(given));
    AFLOAT.replace(given, &format!("geometry.mesh = {{ file = '{}' }}", file.display()))
}

/// Faces on rows of particles, which rounding puts on either side, and a quarter of a spacing from them: as many particles are left out on the left as
/// in the mirror of x, those on faces and inside, and what follows is the same.
#[test]
fn faces_on_rows_of_particles_are_the_same_in_a_mirror() {
    let turned =
        "{ linear = [-0.2, 0.0, 0.0], spin = { axis = [0, 0, 1], point = [0.36, 0.2, 0.0], rate = -2.0 } }";
    for (least, greatest, bottom, left_out) in
        [(0.15, 0.31, 0.15, 27), (0.155, 0.315, 0.14, 24), (0.16, 0.32, 0.14, 24)]
    {
        let at = |low: f64, high: f64| {
            format!(
                "{{ min = [{low}, {bottom}, -0.04], max = [{high}, {}, 0.04], spacing = 0.04 }}",
                bottom + 0.1
            )
        };
        let (here, there) = (at(least, greatest), at(0.6 - greatest, 0.6 - least));
        let one = ran(overridden(AFLOAT, "afloat.toml", &[(BOX, &here)]));
        let other = ran(overridden(AFLOAT, "afloat.toml", &[(BOX, &there), (VELOCITY, turned)]));
        let line = format!("{left_out} particles of the geometry left out");
        for outcome in [&one, &other] {
            let lines = &outcome.summary.body.modelled;
            assert!(lines.iter().any(|own| own.contains(&line)), "{left_out}: {lines:?}");
        }
        for (name, factor) in [("x", -1.0), ("y", 1.0), ("roll", -1.0), ("lift", 1.0)] {
            let off = apart(&one, &other, name, factor);
            assert!(off < 1e-7, "{least} {name}: {off:e}");
        }
    }
}

/// A mesh of the box floats as the box does: its rows have the same points in another order.
#[test]
fn a_mesh_floats_as_the_box_that_it_is() {
    let mesh = prism("box", &[[0.16, 0.14], [0.32, 0.14], [0.32, 0.26], [0.16, 0.26]]);
    let [one, other] = [AFLOAT, &mesh].map(|text| ran(overridden(text, "afloat.toml", &[])));
    for name in ["x", "y", "roll", "lift"] {
        let off = apart(&one, &other, name, 1.0);
        assert!(off < 1e-7, "{name}: {off:e}");
    }
    assert!(other.summary.record.warnings.is_empty(), "{:?}", other.summary.record.warnings);
}

/// A plate of ¾ of a spacing has no row behind its faces; corners sharper than 50° have gaps.
#[test]
fn thin_meshes_are_refused_and_sharp_ones_warned_of() {
    let thin = prism("thin", &[[0.16, 0.14], [0.32, 0.14], [0.32, 0.155], [0.16, 0.155]]);
    let error = overridden(&thin, "afloat.toml", &[]).and_then(|scene| scene.build(1).map(drop)).unwrap_err();
    let said = render(&error, Rendering { width: 1000, colour: false });
    for part in ["geometry.mesh = ", "thinner than a spacing of the fluid, 0.02", "make it thicker"] {
        assert!(said.contains(part), "{said}");
    }
    let sharp = prism("sharp", &[[0.16, 0.14], [0.32, 0.14], [0.24, 0.2]]);
    let outcome = ran(overridden(&sharp, "afloat.toml", &[DURATION]));
    let warned = |kind| outcome.summary.record.warnings.iter().filter(|own| own.kind == kind).count();
    assert_eq!(warned(WarningKind::LeakyWall), 1, "{:?}", outcome.summary.record.warnings);
}

/// The fluid wets the sides of a plane body: what its mass is to that of the fluid does not hang on its width.
#[test]
fn added_mass_of_a_plane_body_is_that_of_its_sides() {
    let added = |half: f64| {
        let wide = format!("{{ min = [0.16, 0.14, -{half}], max = [0.32, 0.26, {half}], spacing = 0.04 }}");
        let outcome = ran(overridden(AFLOAT, "afloat.toml", &[(BOX, &wide), DURATION]));
        outcome.summary.record.fluid.as_ref().unwrap().added_mass[0]
    };
    let [narrow, wide] = [0.04, 0.4].map(added);
    assert!((narrow / wide - 1.0).abs() < 1e-12, "{narrow} {wide}");
}
