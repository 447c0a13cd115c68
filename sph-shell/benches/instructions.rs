//! Instructions a particle-step, counted by valgrind: repeatable to a per mille whatever else the machine does.
//!
//! The program runs itself under `valgrind --tool=callgrind` twice, for some steps and for more, and prints the
//! difference; set-up cancels. Without valgrind it says so and ends.

use std::process::Command;

use contact::{Law, ToolShape, stiffness};
use explicit_dynamics::{Amplitude, Clock};
use shell_kinematics::{
    Hardening, Isotropic, IsotropicSection, Logarithmic, Plastic, PlasticSection, StretchCorrected,
};
use sph_core::{Cell, Cloud, CubicSpline, EndWeights, Plate, Vec3, lattice};
use sph_shell::{
    Divergence, Formulation, LoadCase, OwnContact, Parts, Reach, Shell, Spring, SpringBetween, Springs, Tool,
    TurnSpring,
};

const SIDE: usize = 30;
const STEPS: [u64; 2] = [10, 60];

fn formulations() -> [Formulation; 3] {
    [
        Formulation::StressPoint(Reach::Cell),
        Formulation::Nodal { order: 1, smoothing: 1.2, consistent: false, kernel: &CubicSpline },
        Formulation::StrongForm {
            smoothing: 1.2,
            viscosity: 1.0,
            divergence: Divergence::Sum,
            kernel: &CubicSpline,
        },
    ]
}

/// Springs on all particles of the first formulation, by kind.
const SPRUNG: [&str; 3] = ["springs to the ground", "springs against turning", "springs between halves"];

/// Planes below the plate of the first formulation: many cells away, a fifth of a cell, and pressed in by a hundredth of the thickness.
const TOUCHED: [&str; 3] = ["a tool that is far", "a tool that is near", "a tool that all of it touches"];

/// Two sheets of the first formulation, of which one shell that touches itself is made: their distance over the thickness, whether it touches itself at
/// all, and whether edges are looked at.
const STACKED: [(&str, f64, bool, bool); 6] = [
    ("two sheets", 0.9, false, false),
    ("two sheets of a shell that may touch itself, far", 100.0, true, true),
    ("two sheets near each other", 2.0, true, false),
    ("two sheets near each other, with edges", 2.0, true, true),
    ("two sheets that touch all over", 0.9, true, false),
    ("two sheets that touch all over, with edges", 0.9, true, true),
];

/// The first formulation with strains for materials that yield: elastic, then of six slices by their curve of hardening, whose yield stress is so high
/// that none flows or so low that all do.
const YIELDING: [&str; 4] = [
    "logarithmic strains",
    "six slices, none flows",
    "six slices, all flow, linear",
    "six slices, all flow, table of four",
];

/// A plane at that distance; none beyond the kinds.
fn tools(kind: usize) -> Vec<Tool> {
    let Some(gap) = [1.0, 0.2 / SIDE as f64, -1e-4].get(kind) else { return Vec::new() };
    let shape = ToolShape::Plane { point: Vec3::z() * (-0.005 - gap), normal: Vec3::z() };
    let law = Law::new(0.05).expect("a law");
    let stiffness = stiffness(1e6, 0.01, 1.0 / SIDE as f64);
    vec![Tool {
        shape,
        moved: Vec3::zeros(),
        turn: 0.0,
        friction: 0.0,
        amplitude: Amplitude::Constant,
        case: LoadCase::Loading,
        law,
        stiffness,
    }]
}

/// Those springs; none beyond the kinds.
fn springs(kind: usize) -> Springs {
    let count = (SIDE * SIDE) as u32;
    let all = || (0..count).map(|a| (a, 1e-3)).collect();
    let pairs = (0..count / 2).map(|a| ([a, a + count / 2], 1e-3)).collect();
    match kind {
        0 => vec![Spring { stiffness: all(), direction: Vec3::z() }].into(),
        1 => {
            Springs { turning: vec![TurnSpring { stiffness: all(), axis: Vec3::x() }], ..Springs::default() }
        }
        2 => {
            let between = vec![SpringBetween { stiffness: pairs, direction: Vec3::z() }];
            Springs { between, ..Springs::default() }
        }
        _ => Springs::default(),
    }
}

fn main() {
    let arguments: Vec<String> = std::env::args().collect();
    if let [_, child, which, steps] = &arguments[..]
        && child == "--child"
    {
        let which = which.parse::<usize>().expect("a number");
        // Beyond the formulations those springs, then those tools, on the first of them.
        let formulation = *formulations().get(which).unwrap_or(&formulations()[0]);
        let kind = |before: usize| which.checked_sub(formulations().len() + before).unwrap_or(usize::MAX);
        let steps = steps.parse().expect("a number");
        if let Some(&(_, distance, touches, edges)) = STACKED.get(kind(SPRUNG.len() + TOUCHED.len())) {
            march(stack(distance, touches.then_some(edges)), steps);
            return;
        }
        let kind_of_yielding = kind(SPRUNG.len() + TOUCHED.len() + STACKED.len());
        if kind_of_yielding < YIELDING.len() {
            march(yielding(kind_of_yielding), steps);
            return;
        }
        march(plate(formulation, springs(kind(0)), tools(kind(SPRUNG.len()))), steps);
        return;
    }
    let names = formulations().map(|formulation| format!("{formulation:?}"));
    let acted = SPRUNG
        .into_iter()
        .chain(TOUCHED)
        .chain(STACKED.map(|(name, ..)| name))
        .chain(YIELDING)
        .map(String::from);
    let stacked = formulations().len() + SPRUNG.len() + TOUCHED.len();
    for (which, name) in names.into_iter().chain(acted).enumerate() {
        let counts = STEPS.map(|steps| count(which, steps));
        let [Some(few), Some(many)] = counts else {
            println!("instruction counts skipped: valgrind is not here, or it did not report a count");
            return;
        };
        let sheets = if (stacked..stacked + STACKED.len()).contains(&which) { 2 } else { 1 };
        let particle_steps = (STEPS[1] - STEPS[0]) * (sheets * SIDE * SIDE) as u64;
        println!("{name}: {} instructions a particle-step", (many - few) / particle_steps);
    }
}

/// Instructions of a whole child run, from callgrind's closing line `Collected : N`.
fn count(which: usize, steps: u64) -> Option<u64> {
    let output = Command::new("valgrind")
        .args(["--tool=callgrind", "--callgrind-out-file=/dev/null"])
        .arg(std::env::current_exe().ok()?)
        .args(["--child", &which.to_string(), &steps.to_string()])
        .output()
        .ok()?;
    let text = String::from_utf8_lossy(&output.stderr).into_owned();
    let line = text.lines().find(|line| line.contains("Collected :"))?;
    line.rsplit(' ').next()?.parse().ok()
}

fn parts(cloud: Cloud, formulation: Formulation) -> Parts {
    let material = Isotropic::new(1e6, 0.3).expect("a sound material");
    Parts {
        cloud,
        section: Box::new(IsotropicSection::new(material, 0.01).expect("a sound section")),
        strain: &StretchCorrected,
        material_axis: None,
        density: 1.0,
        formulation,
        supports: Vec::new(),
        loads: Vec::new(),
        threads: 1,
    }
}

fn plate(formulation: Formulation, springs: Springs, tools: Vec<Tool>) -> Shell {
    let cloud = lattice(&Plate { lengths: [1.0, 1.0] }, [SIDE, SIDE], EndWeights::Trapezoid)
        .expect("a sound lattice");
    Shell::builder(parts(cloud, formulation)).springs(springs).tools(tools).build().expect("a sound shell")
}

/// A plate with strains for materials that yield, by its kind.
fn yielding(kind: usize) -> Shell {
    let curve = match kind {
        1 => Hardening::linear(1e6, 1e3),
        2 => Hardening::linear(1e-6, 1e3),
        _ => Hardening::table(&[[0.0, 1e-6], [1e-6, 1e-3], [1e-4, 2e-3], [1e-2, 1e-2]]),
    };
    let cloud = lattice(&Plate { lengths: [1.0, 1.0] }, [SIDE, SIDE], EndWeights::Trapezoid)
        .expect("a sound lattice");
    let mut parts = Parts { strain: &Logarithmic, ..parts(cloud, formulations()[0]) };
    if kind > 0 {
        let elastic = Isotropic::new(1e6, 0.3).expect("a sound material");
        let material = Plastic::new(elastic, curve.expect("a sound curve"));
        parts.section = Box::new(PlasticSection::new(material, 0.01, 6).expect("a sound section"));
    }
    Shell::builder(parts).build().expect("a sound shell")
}

/// Two plates of unlike places at a distance over the thickness.
fn stack(distance: f64, edges: Option<bool>) -> Shell {
    let (count, spacing) = (SIDE as u32, 1.0 / (SIDE - 1) as f64);
    let (mut places, mut cells) = (Vec::new(), Vec::new());
    for shift in [Vec3::zeros(), Vec3::new(0.3 * spacing, 0.17 * spacing, 0.01 * distance)] {
        let first = places.len() as u32;
        let place = |a: u32| Vec3::new(f64::from(a % count), f64::from(a / count), 0.0) * spacing + shift;
        places.extend((0..count * count).map(place));
        let cell = |a: u32| Cell::quadrangle([a, a + 1, a + count + 1, a + count].map(|a| a + first));
        cells.extend((0..count * (count - 1)).filter(|a| a % count < count - 1).map(cell));
    }
    let normals = vec![Vec3::z(); places.len()];
    let cloud = Cloud::from_sheets(places, Some(normals), cells, Vec::new()).expect("sound sheets");
    let own = edges.map(|edges| OwnContact {
        law: Law::new(0.05).expect("a law"),
        stiffness: 0.5 * stiffness(1e6, 0.01, spacing),
        edges,
        friction: 0.0,
    });
    Shell::builder(parts(cloud, formulations()[0])).touching_itself(own).build().expect("a sound shell")
}

fn march(mut shell: Shell, steps: u64) {
    for a in 0..shell.len() {
        let x = shell.position(a);
        // An upper sheet that touches comes down, so that it does so to the last step.
        let down = if a >= SIDE * SIDE && x.z < 0.01 { -8.0 } else { 0.0 };
        shell.set_rate(a, Vec3::new(x.y, -x.x, x.x * x.y + down), Vec3::zeros());
    }
    let mut clock = Clock::start(&mut shell, 1.0, 0.2, 0.0).expect("a stable step");
    for _ in 0..steps {
        clock.step(&mut shell, f64::INFINITY, |_| 1.0).expect("a sound step");
    }
}
