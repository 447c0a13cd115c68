//! Fields of stresses: principal stresses, plies, reserve factors against closed forms and against columns.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use super::ply_stresses::{CARBON, RESERVE, columns, layup, pulled, sheet};
use crate::common::fields::{self, Read, folder};
use crate::common::last;
use coque::{FieldFiles, Scene};

/// Pure shear: principal stresses ±τ at 45°, Tresca's 2τ; fields show the same, with the axis in space, however the sheet lies.
#[test]
fn pure_shear_has_its_axes_at_45_degrees() {
    let steel = "elastic = { young = 210e3, poisson = 0.3, density = 1e-9, strength = 250.0 }";
    // 4 N/mm on all edges of a thickness of 0.5: 8 N/mm².
    let edge =
        |on: &str, x: f64, y: f64| format!("{{ on = \"{on}\", force = {{ total = [{x:?}, {y:?}, 0.0] }} }}");
    let loads = format!(
        "loads = [{}, {}, {}, {}]",
        edge("u1", 0.0, 40.0),
        edge("u0", 0.0, -40.0),
        edge("v1", 40.0, 0.0),
        edge("v0", -40.0, 0.0)
    );
    let of = |name: &str, more: &str| format!("name = \"{name}\"\nof = \"{name}\"\non = \"all\"\n{more}");
    let angle = of("principal-angle", "face = \"bottom\"\ndirection = [1.0, 0.0, 0.0]");
    let list = columns(&[
        &of("max-principal", ""),
        &of("min-principal", "face = \"middle\""),
        &of("tresca", "face = \"top\""),
        &angle,
    ]);
    let text = sheet("section.homogeneous.thickness = 0.5", &loads, &list).replace(CARBON, steel)
        + "[output]\nfields = { principal = true, reserve = \"von-mises\" }\n";
    let turned = "orientation = { axis = [1.0, 2.0, -0.7], degrees = 37.0 }\n";
    for (k, text) in [text.clone(), format!("{turned}{text}")].into_iter().enumerate() {
        let scene = Scene::parse(&text, "sheet.toml").unwrap();
        let files = folder(&format!("principal-{k}"));
        let wanted = scene.output.fields.unwrap();
        let found = fields::run(&scene, &mut FieldFiles::create(&files, FieldFiles::LONE, &wanted).unwrap());
        let exact = [("max-principal", 8.0), ("min-principal", -8.0), ("tresca", 16.0)];
        for (name, exact) in exact {
            // An even stress, but for what the solver leaves, 3e-12.
            assert!((last(&found, name) / exact - 1.0).abs() < 1e-11, "{name}: {}", last(&found, name));
        }
        let quarter = std::f64::consts::FRAC_PI_4;
        assert!((last(&found, "principal-angle") / quarter - 1.0).abs() < 1e-12);
        // Files are in single precision, 6e-8 of a number.
        let read = Read::new(&files.join("shell-0000.vtu"));
        let axis = match k {
            0 => sph_core::Vec3::new(1.0, 1.0, 0.0).normalize(),
            _ => {
                scene.as_shell().unwrap().orientation.unwrap().rotation()
                    * sph_core::Vec3::new(1.0, 1.0, 0.0).normalize()
            }
        };
        for name in ["top", "middle", "bottom"] {
            let principal = read.get(&format!("principal_stress_{name}"));
            assert!(principal.chunks(2).all(|s| (s[0] - 8.0).abs() < 1e-6 && (s[1] + 8.0).abs() < 1e-6));
            let axes = read.get(&format!("principal_direction_{name}"));
            assert!(
                axes.chunks(3)
                    .all(|n| { (sph_core::Vec3::from_column_slice(n).dot(&axis).abs() - 1.0).abs() < 1e-6 })
            );
            assert!(read.get(&format!("tresca_{name}")).iter().all(|s| (s - 16.0).abs() < 2e-6));
        }
        let reserve = 250.0 / (8.0 * 3.0_f64.sqrt());
        assert!(read.get("reserve_factor").iter().all(|r| (r / reserve - 1.0).abs() < 1e-7));
        assert!(read.get("worst_ply").iter().all(|&ply| ply == 1.0));
    }
}

/// The files hold what the columns take, and the number of the worst ply.
#[test]
fn fields_hold_what_columns_take() {
    let index = "name = \"index\"\nof = \"failure-index\"\non = \"all\"\ncriterion = \"tsai-wu\"";
    let ply =
        "name = \"ply\"\nof = \"ply-stress\"\non = \"all\"\nply = 3\nface = \"top\"\ncomponent = \"across\"";
    let second = "name = \"second\"\nof = \"reserve-factor\"\non = \"all\"\nply = 2\ncriterion = \"tsai-wu\"";
    let text = sheet(&layup(&[0.0, 45.0, 90.0]), &pulled(10.0), &columns(&[RESERVE, index, ply, second]))
        + "[output]\nfields = { plies = true, reserve = \"tsai-wu\" }\n";
    let scene = Scene::parse(&text, "sheet.toml").unwrap();
    let files = folder("plies");
    let wanted = scene.output.fields.unwrap();
    let found = fields::run(&scene, &mut FieldFiles::create(&files, FieldFiles::LONE, &wanted).unwrap());
    let read = Read::new(&files.join("shell-0000.vtu"));
    let least = |name: &str| read.get(name).iter().copied().fold(f64::INFINITY, f64::min);
    // Single precision.
    let near = |a: f64, b: f64| assert!((a / b - 1.0).abs() < 1e-7, "{a} {b}");
    near(least("reserve_factor"), last(&found, "reserve"));
    near(least("ply_2_reserve_factor"), last(&found, "second"));
    let index = read.get("failure_index").iter().copied().fold(0.0, f64::max);
    near(index, last(&found, "index"));
    near(read.get("ply_3_top")[1], last(&found, "ply"));
    // The ply across the load is the weakest.
    assert!(read.get("worst_ply").iter().all(|&ply| ply == 3.0));
    assert!(read.place("stress_top").is_none() && read.place("membrane_force").is_none());
}

/// Where the build of a part is not known nothing is judged: column and field say the same, and the rest of the sheet counts.
#[test]
fn a_part_of_given_stiffness_is_not_judged() {
    let matrix = |factor: f64| {
        format!(
            "[[{0:?}, {1:?}, 0.0], [{1:?}, {0:?}, 0.0], [0.0, 0.0, {2:?}]]",
            40e3 * factor,
            9e3 * factor,
            12e3 * factor
        )
    };
    let part = format!(
        "[[parts]]\non = \"given\"\nmaterial.smeared.density = 1e-9\n\
         section.stiffness = {{ thickness = 0.375, axis = [1.0, 0.0, 0.0], membrane = {}, bending = {}, shear = [[1e3, 0.0], [0.0, 1e3]] }}\n",
        matrix(1.0),
        matrix(0.012)
    );
    let of = |name: &str, on: &str, of: &str| {
        format!("name = \"{name}\"\nof = \"{of}\"\non = \"{on}\"\ncriterion = \"tsai-wu\"")
    };
    let list = columns(&[
        RESERVE,
        &of("index", "all", "failure-index"),
        &(of("greatest", "all", "reserve-factor") + "\ntake = \"max\""),
        &(of("least_index", "all", "failure-index") + "\ntake = \"min\""),
    ]);
    let text = sheet(&layup(&[0.0, 45.0, 90.0]), &pulled(10.0), &list)
        + &part
        + "[sets]\ngiven.box = { min = [-1.0, -1.0, -1.0], max = [5.1, 11.0, 1.0] }\n[output]\nfields = { plies = true, reserve = \"tsai-wu\" }\n";
    let scene = Scene::parse(&text, "sheet.toml").unwrap();
    let files = folder("given-part");
    let wanted = scene.output.fields.unwrap();
    let found = fields::run(&scene, &mut FieldFiles::create(&files, FieldFiles::LONE, &wanted).unwrap());
    let read = Read::new(&files.join("shell-0000.vtu"));
    let fold = |name: &str, of: fn(f64, f64) -> f64| read.get(name).iter().copied().reduce(of).unwrap();
    // Single precision.
    let near = |a: f64, b: f64| assert!((a - b).abs() < 1e-7 * b, "{a} {b}");
    near(fold("reserve_factor", f64::min), last(&found, "reserve"));
    near(fold("failure_index", f64::max), last(&found, "index"));
    assert!(last(&found, "reserve") > 1.0 && last(&found, "reserve") < 100.0);
    for greatest in
        [last(&found, "greatest"), fold("reserve_factor", f64::max), fold("ply_2_reserve_factor", f64::max)]
    {
        assert_eq!(greatest, 1e3);
    }
    assert_eq!(last(&found, "least_index"), 0.0);
}

/// Frames of a linear answer of cooled plies hold what its columns take: heat is read back from forces that grow with the load.
#[test]
fn frames_of_cooled_plies_hold_what_columns_take() {
    let ply =
        "name = \"ply\"\nof = \"ply-stress\"\non = \"all\"\nply = 2\nface = \"top\"\ncomponent = \"across\"";
    let cooled = "loads = [{ on = \"all\", temperature = { change = -100.0, difference = 20.0 } }]";
    let text = sheet(&layup(&[0.0, 90.0, 90.0, 0.0]), cooled, &columns(&[RESERVE, ply]))
        + "[output]\nfields = { plies = true, reserve = \"tsai-wu\" }\n";
    for (k, text) in [text.clone(), text.replace("linear = {}", "static.levels = 1")].iter().enumerate() {
        let scene = Scene::parse(text, "sheet.toml").unwrap();
        let files = folder(&format!("cooled-plies-{k}"));
        let wanted = scene.output.fields.unwrap();
        let found = fields::run(&scene, &mut FieldFiles::create(&files, FieldFiles::LONE, &wanted).unwrap());
        let last_frame = fields::listed(&files.join("shell.pvd")).last().unwrap().1.clone();
        let read = Read::new(&last_frame);
        let across: Vec<f64> = read.get("ply_2_top").chunks(3).map(|own| own[1]).collect();
        let mean = across.iter().sum::<f64>() / across.len() as f64;
        // Single precision.
        assert!((mean / last(&found, "ply") - 1.0).abs() < 1e-7, "{mean} {}", last(&found, "ply"));
        let least = read.get("reserve_factor").iter().copied().fold(f64::INFINITY, f64::min);
        assert!((least / last(&found, "reserve") - 1.0).abs() < 1e-7);
    }
}
