//! Instructions a particle-step, counted by valgrind: repeatable to a per mille whatever else the machine does.
//!
//! The program runs itself under `valgrind --tool=callgrind` twice, for some steps and for more, and prints the
//! difference; set-up cancels. Without valgrind it says so and ends.

use std::process::Command;

use explicit_dynamics::Clock;
use shell_kinematics::{Isotropic, IsotropicSection, StretchCorrected};
use sph_core::{CubicSpline, EndWeights, Plate, Vec3, lattice};
use sph_shell::{Formulation, Parts, Reach, Shell};

const SIDE: usize = 30;
const STEPS: [u64; 2] = [10, 60];

fn formulations() -> [Formulation; 3] {
    [
        Formulation::StressPoint(Reach::Cell),
        Formulation::Nodal { order: 1, smoothing: 1.2, consistent: false, kernel: &CubicSpline },
        Formulation::StrongForm { smoothing: 1.2, viscosity: 1.0, kernel: &CubicSpline },
    ]
}

fn main() {
    let arguments: Vec<String> = std::env::args().collect();
    if let [_, child, which, steps] = &arguments[..]
        && child == "--child"
    {
        march(formulations()[which.parse::<usize>().expect("a number")], steps.parse().expect("a number"));
        return;
    }
    for (which, formulation) in formulations().iter().enumerate() {
        let counts = STEPS.map(|steps| count(which, steps));
        let [Some(few), Some(many)] = counts else {
            println!("instruction counts skipped: valgrind is not here, or it did not report a count");
            return;
        };
        let particle_steps = (STEPS[1] - STEPS[0]) * (SIDE * SIDE) as u64;
        println!("{formulation:?}: {} instructions a particle-step", (many - few) / particle_steps);
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

fn march(formulation: Formulation, steps: u64) {
    let cloud = lattice(&Plate { lengths: [1.0, 1.0] }, [SIDE, SIDE], EndWeights::Trapezoid)
        .expect("a sound lattice");
    let material = Isotropic::new(1e6, 0.3).expect("a sound material");
    let mut shell = Shell::new(Parts {
        cloud,
        section: Box::new(IsotropicSection::new(material, 0.01).expect("a sound section")),
        strain: &StretchCorrected,
        material_axis: None,
        density: 1.0,
        formulation,
        supports: Vec::new(),
        loads: Vec::new(),
        threads: 1,
    })
    .expect("a sound shell");
    for a in 0..shell.len() {
        let x = shell.position(a);
        shell.set_rate(a, Vec3::new(x.y, -x.x, x.x * x.y), Vec3::zeros());
    }
    let mut clock = Clock::start(&mut shell, 1.0, 0.2, 0.0).expect("a stable step");
    for _ in 0..steps {
        clock.step(&mut shell, f64::INFINITY, |_| 1.0).expect("a sound step");
    }
}
