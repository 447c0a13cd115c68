//! Stresses at particles from those of the cells round them: linear courses to the edges, peaks at holes, steps of the section.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use super::ply_stresses::{CARBON, columns, pulled, sheet};
use crate::common::fields::{self, Read, folder};
use crate::common::{last, ran, scenes};
use coque::{FieldFiles, Scene};

/// The first frame of a scene.
fn frame(name: &str, text: &str) -> Read {
    let scene = Scene::parse(text, name).unwrap();
    let files = folder(&format!("recovered-{name}"));
    let wanted = scene.output.fields.unwrap();
    fields::run(&scene, &mut FieldFiles::create(&files, FieldFiles::LONE, &wanted).unwrap());
    Read::new(&files.join("shell-0000.vtu"))
}

/// A strip bent by a force at its end bears F(L − x)/b: at the clamp F L/b, of which the cell beside it lacks a twentieth. One row of cells across, or
/// two, or three turned in space.
#[test]
fn moments_of_a_bent_strip_are_linear_up_to_its_clamp() {
    for (across, turned) in
        [(2, ""), (3, ""), (4, "orientation = { axis = [1.0, 2.0, -0.7], degrees = 37.0 }\n")]
    {
        let text = format!(
            "title = \"Strip\"\nunits = {{ length = \"mm\", force = \"N\", time = \"s\" }}\nanalysis.linear = {{}}\n{turned}\
             geometry.plate = {{ lengths = [10.0, 1.0], particles = [11, {across}] }}\nsection.homogeneous.thickness = 0.1\n\
             material.elastic = {{ young = 1000.0, poisson = 0.0, density = 1e-9 }}\nsupports = [{{ on = \"u0\", clamped = {{}} }}]\n\
             loads = [{{ on = \"u1\", force = {{ total = [0, 0, 1e-4] }} }}]\n\
             curve = [{{ name = \"w\", of = \"displacement\", on = \"u1\", direction = [0, 0, 1] }}]\n\
             output.fields = {{ stresses = true, recovered = true, principal = true }}\n"
        );
        let read = frame(&format!("strip-{across}"), &text);
        let (moments, stresses) = (read.get("nodal_moment"), read.get("nodal_principal_stress_bottom"));
        assert_eq!(read.place("nodal_moment"), Some("PointData"));
        let (clamped, of_cell) = (moments[0].abs(), read.get("moment")[0].abs());
        // Loads along z act across the strip as it lies in the plane, turned they turn along. Files are in single precision.
        for (a, moment) in moments.chunks(3).enumerate() {
            let exact = 1e-3 * (1.0 - 0.1 * (a / across) as f64);
            assert!((moment[0].abs() - exact).abs() < 2e-9 && moment[1].abs() < 2e-9, "{a}: {moment:?}");
            // 6 M/t² on the face that is pulled.
            assert!((stresses[2 * a] - 600.0 * exact).abs() < 2e-6, "{a}: {}", stresses[2 * a]);
        }
        assert!((of_cell / clamped - 0.95).abs() < 1e-6);
    }
}

/// Columns take what fields show: the moment at the clamp, the stress there, the greatest at a hole.
#[test]
fn columns_take_stresses_at_particles() {
    let strip = "title = \"Strip\"\nunits = { length = \"mm\", force = \"N\", time = \"s\" }\n\
         geometry.plate = { lengths = [10.0, 1.0], particles = [11, 3] }\nsection.homogeneous.thickness = 0.1\n\
         material.elastic = { young = 1000.0, poisson = 0.0, density = 1e-9 }\nsupports = [{ on = \"u0\", clamped = {} }]\n\
         loads = [{ on = \"u1\", force = { total = [0, 0, 1e-4] } }]\n";
    let columns = "curve = [{ name = \"M\", of = \"bending-moment\", on = \"u0\", direction = [1, 0, 0], recovered = true }, \
         { name = \"Q\", of = \"shear-force\", on = \"u0\", direction = [1, 0, 0], recovered = true }, \
         { name = \"s\", of = \"max-principal\", on = \"u0\", recovered = true }, \
         { name = \"t\", of = \"stress\", on = \"u0v0\", face = \"bottom\", direction = [1, 0, 0], recovered = true }, \
         { name = \"v\", of = \"von-mises\", on = \"all\", recovered = true }, { name = \"cells\", of = \"von-mises\", on = \"all\" }]\n";
    // The tip goes by .04 of the length: without the linear answer the arm is .001 shorter, a thousandth less of moment.
    for (analysis, off) in [("linear = {}", 1e-5), ("static.levels = 1", 3e-3)] {
        let found = ran(Scene::parse(&format!("{strip}{columns}analysis.{analysis}\n"), "strip.toml"));
        let of = |name: &str| last(&found, name);
        // F L/b = 1e-3, over t²/6 .6.
        let (moment, shear) = (of("M").abs(), of("Q").abs());
        assert!((moment / 1e-3 - 1.0).abs() < off && (shear / 1e-4 - 1.0).abs() < off, "{moment} {shear}");
        for name in ["s", "t", "v"] {
            assert!((of(name) / 0.6 - 1.0).abs() < off, "{name}: {}", of(name));
        }
        assert!((of("cells") / 0.57 - 1.0).abs() < off, "{}", of("cells"));
    }
}

/// An even stress is even at particles too, whatever the axes, and the axes are those of the particles as they lie now.
#[test]
fn an_even_stress_stays_even() {
    let steel = "elastic = { young = 210e3, poisson = 0.3, density = 1e-9 }";
    let list = columns(&["name = \"s\"\nof = \"max-principal\"\non = \"all\""]);
    let text = sheet("section.homogeneous.thickness = 0.5", &pulled(4.0), &list).replace(CARBON, steel)
        + "[output]\nfields = { recovered = true, principal = true }\n";
    let turned = "orientation = { axis = [1.0, 2.0, -0.7], degrees = 37.0 }\n";
    for (name, text) in [("even", text.clone()), ("turned", format!("{turned}{text}"))] {
        let read = frame(name, &text);
        for face in ["top", "middle", "bottom"] {
            let principal = read.get(&format!("nodal_principal_stress_{face}"));
            assert!(principal.chunks(2).all(|s| (s[0] - 8.0).abs() < 1e-6 && s[1].abs() < 1e-6));
        }
        assert!(read.get("nodal_von_mises_top").iter().all(|s| (s - 8.0).abs() < 1e-6));
        let t1 = read.get("nodal_t1");
        assert!(t1.chunks(3).all(|t| (libm::hypot(libm::hypot(t[0], t[1]), t[2]) - 1.0).abs() < 1e-6));
    }
}

/// The peak at the crown of a hole: the same plate cut three times finer has 162.27, as its own sequence 161.0, 162.05, 162.23 says; cells have their
/// middles off the edge and fall short by 6.9 %.
#[test]
fn the_peak_at_a_hole_is_that_of_its_edge() {
    let file = format!("{:?}", scenes().join("meshes/open-hole.inp"));
    let text = format!(
        "title = \"Hole\"\nunits = {{ length = \"mm\", force = \"N\", time = \"s\" }}\nanalysis.linear = {{}}\ngeometry.mesh.file = {file}\n\
         material.elastic = {{ young = 70000.0, poisson = 0.3, density = 1e-9 }}\nsection.homogeneous.thickness = 1.0\n\
         supports = [{{ on = \"LEFT\", symmetry = {{ normal = [1, 0, 0] }} }}, {{ on = \"BOTTOM\", symmetry = {{ normal = [0, 1, 0] }} }}, \
                     {{ on = \"all\", held = {{ displacement = [[0, 0, 1]] }} }}]\n\
         loads = [{{ on = \"RIGHT\", force = {{ total = [900.0, 0.0, 0.0] }} }}]\n\
         curve = [{{ name = \"s\", of = \"max-principal\", on = \"all\" }}]\noutput.fields = {{ recovered = true, principal = true }}\n"
    );
    let read = frame("hole", &text);
    let peak = |name: &str| read.get(name).iter().copied().fold(0.0, f64::max);
    let (nodal, cells) = (peak("nodal_principal_stress_middle"), peak("principal_stress_middle"));
    // Measured −.81 %; three times that.
    assert!((nodal / 162.27 - 1.0).abs() < 0.025, "{nodal}");
    assert!(cells < 0.94 * 162.27, "{cells}");
}

/// A strip whose thickness falls along it by less than a tenth from cell to cell is one section: its moment at the clamp is F L/b, from either end.
#[test]
fn moments_of_a_tapered_strip_reach_its_clamp() {
    let text = |clamp: &str, tip: &str, part: [f64; 2]| {
        let parts: String = (0..10)
            .map(|k| {
                let thickness = part[0] + part[1] * (f64::from(k) + 0.5);
                format!(
                    "[[parts]]\non = \"c{k}\"\nsection.homogeneous.thickness = {thickness:?}\n[sets.c{k}.box]\nmin = [{:?}, -9.0, -9.0]\nmax = [{:?}, 9.0, 9.0]\n",
                    f64::from(k) - 0.01,
                    f64::from(k) + 1.01
                )
            })
            .collect();
        format!(
            "title = \"Strip\"\nunits = {{ length = \"mm\", force = \"N\", time = \"s\" }}\nanalysis.linear = {{}}\n\
             geometry.plate = {{ lengths = [10.0, 1.0], particles = [11, 3] }}\nsection.homogeneous.thickness = 0.1\n\
             material.elastic = {{ young = 1000.0, poisson = 0.0, density = 1e-9 }}\nsupports = [{{ on = \"{clamp}\", clamped = {{}} }}]\n\
             loads = [{{ on = \"{tip}\", force = {{ total = [0, 0, 1e-4] }} }}]\n\
             curve = [{{ name = \"M\", of = \"bending-moment\", on = \"{clamp}\", direction = [1, 0, 0], recovered = true }}, \
                      {{ name = \"s\", of = \"max-principal\", on = \"{clamp}\", recovered = true }}]\n{parts}"
        )
    };
    let [one, other] = [text("u0", "u1", [0.12, -0.004]), text("u1", "u0", [0.08, 0.004])]
        .map(|text| ran(Scene::parse(&text, "taper.toml")));
    for found in [&one, &other] {
        assert!((last(found, "M").abs() / 1e-3 - 1.0).abs() < 1e-8, "{}", last(found, "M"));
        // 6 M/t² with the thickness that the cells lead to at the clamp, .12.
        assert!((last(found, "s") / (6e-3 / 0.0144) - 1.0).abs() < 1e-8, "{}", last(found, "s"));
    }
}

/// On a fold each sheet has stresses of its own: a column on the line reads both.
#[test]
fn a_column_on_a_junction_reads_all_sheets() {
    let mut mesh = String::from(
        "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nv 1 1 0\nv 2 1 0\nv 0 0 1\nv 1 0 1\nv 2 0 1\nv 0 -1 0\nv 1 -1 0\nv 2 -1 0\n",
    );
    mesh += "g flange\nf 1 2 5 4\nf 2 3 6 5\nf 10 11 2 1\nf 11 12 3 2\ng web\nf 1 2 8 7\nf 2 3 9 8\n";
    let file = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join("recovered-tee.obj");
    std::fs::write(&file, mesh).unwrap();
    let text = format!(
        "title = \"Tee\"\nunits = {{ length = \"mm\", force = \"N\", time = \"s\" }}\nanalysis.linear = {{}}\ngeometry.mesh.file = {file:?}\n\
         material.elastic = {{ young = 1000.0, poisson = 0.0, density = 1e-9 }}\nsection.homogeneous.thickness = 0.1\n\
         supports = [{{ on = \"flange\", clamped = {{}} }}]\nloads = [{{ on = \"top\", force = {{ total = [0, 0, 2.0] }} }}]\n\
         sets.top.plane = {{ point = [0, 0, 1], normal = [0, 0, 1] }}\nsets.foot.box = {{ min = [0.9, -0.1, -0.1], max = [1.1, 0.1, 0.1] }}\n\
         curve = [{{ name = \"s\", of = \"max-principal\", on = \"foot\", recovered = true }}]\n"
    );
    // 2 N over a width of 2 and a thickness of .1.
    let found = last(&ran(Scene::parse(&text, "tee.toml")), "s");
    assert!((found / 10.0 - 1.0).abs() < 1e-8, "{found}");
}

/// Where the thickness steps a particle has the stress of one side, of the thinner one where both have the same area, not a mean of both.
#[test]
fn stresses_at_a_step_are_those_of_the_thinner_side() {
    let steel = "elastic = { young = 210e3, poisson = 0.0, density = 1e-9 }";
    let list = columns(&["name = \"s\"\nof = \"max-principal\"\non = \"all\""]);
    let part = "[[parts]]\non = \"thick\"\nsection.homogeneous.thickness = 1.0\n[sets]\nthick = { box = { min = [-1, -1, -1], max = [5.01, 11, 1] } }\n";
    let text = sheet("section.homogeneous.thickness = 0.5", &pulled(4.0), &list).replace(CARBON, steel)
        + part
        + "[output]\nfields = { recovered = true }\n";
    let turned = "orientation = { axis = [0.0, 0.0, 1.0], degrees = 37.0 }\n";
    let [plain, other] = [frame("step", &text), frame("step-turned", &format!("{turned}{text}"))];
    for (a, at) in plain.get("Points").chunks(3).enumerate() {
        let side = if at[0] < 4.9 { 4.0 } else { 8.0 };
        for read in [&plain, &other] {
            let stress = read.get("nodal_von_mises_top")[a];
            assert!((stress - side).abs() < 1e-5, "{at:?}: {stress:?}");
        }
    }
}
