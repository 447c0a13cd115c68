//! Principal stresses of solids: columns against fields, fields against the stress itself.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use crate::common::fields::{self, Read, folder};
use crate::common::galerkin::ARC;
use crate::common::last;
use crate::common::solids::BAR;
use coque::{Checked, FieldFiles, Scene};
use nalgebra::Matrix3;
use sph_core::Vec3;

const COLUMNS: &str = "[
    { name = \"mises\", of = \"von-mises\", on = \"all\" },
    { name = \"tresca\", of = \"tresca\", on = \"all\" },
    { name = \"greatest\", of = \"max-principal\", on = \"all\" },
    { name = \"least\", of = \"min-principal\", on = \"all\" },
    { name = \"along\", of = \"stress\", on = \"all\", direction = [1.0, 2.0, 2.0], take = \"max\" },
]";

fn scene(text: &str, analysis: &str, replaced: &[(&str, &str)]) -> Checked {
    let more = [
        ("curve", COLUMNS),
        ("analysis", analysis),
        ("output.fields", "{ stresses = true, principal = true }"),
    ];
    let pairs: Vec<_> =
        more.iter().chain(replaced).map(|(path, value)| (path.to_string(), value.to_string())).collect();
    Scene::with_overrides(text, "solid.toml", &pairs).unwrap()
}

/// A stress whose shears stand at these places of a row: xy, yz, zx.
fn tensor(row: &[f64]) -> Matrix3<f64> {
    Matrix3::new(row[0], row[3], row[5], row[3], row[1], row[4], row[5], row[4], row[2])
}

/// Runs a scene and holds its fields against the stress field, which lies in axes, and its columns against its fields.
fn held(name: &str, scene: &Checked, axes: Matrix3<f64>) {
    let files = folder(&format!("principal-{name}"));
    let wanted = scene.output.fields.unwrap();
    let found = fields::run(scene, &mut FieldFiles::create(&files, FieldFiles::LONE, &wanted).unwrap());
    let last_frame = fields::listed(&files.join("shell.pvd")).last().unwrap().1.clone();
    let read = Read::new(&last_frame);
    let (stress, principal) = (read.get("stress"), read.get("principal_stress"));
    let [first, third] = ["principal_direction_1", "principal_direction_3"].map(|name| read.get(name));
    let size = principal.iter().fold(0.0_f64, |most, s| most.max(s.abs()));
    let (mut most, mut least, mut along) = (f64::MIN, f64::MAX, f64::MIN);
    let e = Vec3::new(1.0, 2.0, 2.0) / 3.0;
    for (node, row) in stress.chunks(6).enumerate() {
        let whole = axes * tensor(row) * axes.transpose();
        let s = &principal[3 * node..3 * node + 3];
        // Single precision of both, 6e-8.
        let near = |a: f64, b: f64| assert!((a - b).abs() < 2e-7 * size, "{name} {node}: {a} {b}");
        near(s.iter().sum(), whole.trace());
        for (n, value) in [(first, s[0]), (third, s[2])] {
            let n = Vec3::from_column_slice(&n[3 * node..3 * node + 3]);
            near((whole * n - n * value).norm(), 0.0);
        }
        near(read.get("tresca")[node], s[0] - s[2]);
        let mises = (0.5 * ((s[0] - s[1]).powi(2) + (s[1] - s[2]).powi(2) + (s[2] - s[0]).powi(2))).sqrt();
        near(read.get("von_mises")[node], mises);
        (most, least) = (most.max(s[0]), least.min(s[2]));
        along = along.max((whole * e).dot(&e));
    }
    for (column, exact) in [("greatest", most), ("least", least), ("along", along)] {
        let off = (last(&found, column) - exact).abs() / size;
        // Single precision, 6e-8.
        assert!(off < 1e-7, "{name} {column}: {} {exact}", last(&found, column));
    }
}

#[test]
fn principal_stresses_of_solids_are_those_of_their_stress() {
    let none = Matrix3::identity();
    let shear = ("loads", "[{ on = \"x1\", traction = { value = [2e-3, 1e-3, -5e-4] } }]");
    held("bonds", &scene(BAR, "{ static = { levels = 1 } }", &[shear]), none);
    held("bonds-linear", &scene(BAR, "{ linear = {} }", &[shear]), none);
    // Material axes turned by atan(4/3) about z.
    let turned = Matrix3::new(0.6, -0.8, 0.0, 0.8, 0.6, 0.0, 0.0, 0.0, 1.0);
    let axes = ("bodies.arc.solid.material.orthotropic.axes", "[[0.6, 0.8, 0.0], [-0.8, 0.6, 0.0]]");
    held("galerkin-linear", &scene(ARC, "{ linear = {} }", &[shear, axes]), turned);
}

/// A bar in tension without time: the axis of its greatest principal stress lies along it.
#[test]
fn a_pulled_bar_has_its_principal_axis_along_it() {
    let text = crate::common::galerkin::BAR;
    let planes = "[{ on = \"x0\", symmetry = { normal = [1, 0, 0] } }, { on = \"y0\", symmetry = { normal = [0, 1, 0] } }, \
                  { on = \"z0\", symmetry = { normal = [0, 0, 1] } }]";
    let scene = scene(text, "{ static = { levels = 1 } }", &[("supports", planes)]);
    let files = folder("principal-pulled");
    let wanted = scene.output.fields.unwrap();
    let found = fields::run(&scene, &mut FieldFiles::create(&files, FieldFiles::LONE, &wanted).unwrap());
    let read = Read::new(&fields::listed(&files.join("shell.pvd")).last().unwrap().1);
    // Two cells across, quadrature leaves 2.8 % at the worst node, beside a corner, and an axis that is 0.16° off: three times as much.
    let axes = read.get("principal_direction_1");
    let least = libm::cos(0.48_f64.to_radians());
    assert!(axes.chunks(3).all(|n| n[0].abs() > least), "{axes:?}");
    assert!((last(&found, "greatest") / 1e-3 - 1.0).abs() < 0.085);
}
