//! What contact of a shell with itself costs a step: far, near and touching all over, against the same shell without.
//!
//! Two sheets of 22 472 particles together, one thread, v/c = 10⁻³. Bursts of steps with and without take turns, so that the ratio holds on a
//! busy machine too; the median of all ratios is printed. `cargo bench -p sph-shell --bench touching`

use std::time::Instant;

use contact::{Law, stiffness};
use explicit_dynamics::Clock;
use shell_kinematics::{Isotropic, IsotropicSection, StretchCorrected};
use sph_core::{Cell, Cloud, Vec3};
use sph_shell::{Formulation, OwnContact, Parts, Reach, Shell};

/// Particles along a side; cells are one wide.
const SIDE: u32 = 106;
const THICKNESS: f64 = 0.2;
const YOUNG: f64 = 1e6;
/// Pairs of bursts.
const TURNS: usize = 41;

/// Two sheets at a distance of their middles, on unlike places.
fn sheets(distance: f64) -> Cloud {
    let (mut places, mut cells) = (Vec::new(), Vec::new());
    for (shift, height) in [(0.0, 0.0), (0.3, distance)] {
        let first = places.len() as u32;
        let place =
            |a: u32| Vec3::new(f64::from(a % SIDE) + shift, f64::from(a / SIDE) + 0.57 * shift, height);
        places.extend((0..SIDE * SIDE).map(place));
        let cell = |a: u32| Cell::quadrangle([a, a + 1, a + SIDE + 1, a + SIDE].map(|a| a + first));
        cells.extend((0..SIDE * (SIDE - 1)).filter(|a| a % SIDE < SIDE - 1).map(cell));
    }
    let normals = vec![Vec3::z(); places.len()];
    Cloud::from_sheets(places, Some(normals), cells, Vec::new()).expect("sound sheets")
}

fn shell(distance: f64, own: Option<OwnContact>) -> Shell {
    let material = Isotropic::new(YOUNG, 0.3).expect("a sound material");
    let parts = Parts {
        cloud: sheets(distance),
        section: Box::new(IsotropicSection::new(material, THICKNESS).expect("a sound section")),
        strain: &StretchCorrected,
        material_axis: None,
        density: 1.0,
        formulation: Formulation::StressPoint(Reach::Cell),
        supports: Vec::new(),
        loads: Vec::new(),
        threads: 1,
    };
    let mut shell = Shell::builder(parts).touching_itself(own).build().expect("a sound shell");
    for a in 0..shell.len() {
        let x = shell.position(a) / f64::from(SIDE);
        shell.set_rate(a, Vec3::new(x.y, -x.x, x.x * x.y), Vec3::zeros());
    }
    shell
}

/// A shell that is marched from the same state again and again.
struct Course {
    shell: Shell,
    clock: Clock,
    start: [Vec<[f64; 6]>; 2],
}

impl Course {
    fn new(mut shell: Shell) -> Self {
        let start = shell.motion().map(<[_]>::to_vec);
        let clock = Clock::start(&mut shell, 1.0, 0.5, 0.0).expect("a stable step");
        Self { shell, clock, start }
    }

    /// Seconds that some steps take.
    fn burst(&mut self, steps: usize) -> f64 {
        let Self { shell, clock, start } = self;
        shell.take_up([&start[0], &start[1]]);
        let begin = Instant::now();
        for _ in 0..steps {
            clock.step(shell, f64::INFINITY, |_| 1.0).expect("a sound step");
        }
        begin.elapsed().as_secs_f64()
    }
}

fn main() {
    let law = Law::new(0.05).expect("a law");
    for (name, distance, steps) in [("far", 3.0, 34), ("near", 0.4, 34), ("touching", 0.18, 4)] {
        for edges in [false, true] {
            let stiffness = 0.5 * stiffness(YOUNG, THICKNESS, 1.0);
            let own = OwnContact { law, stiffness, edges, friction: 0.0 };
            let [mut alone, mut with] = [None, Some(own)].map(|own| Course::new(shell(distance, own)));
            let mut turns: Vec<[f64; 2]> =
                (0..TURNS).map(|_| [alone.burst(steps), with.burst(steps)]).collect();
            turns.sort_unstable_by(|a, b| (a[1] / a[0]).total_cmp(&(b[1] / b[0])));
            let [alone, with] =
                turns[TURNS / 2].map(|time| 1e9 * time / (steps as f64 * f64::from(2 * SIDE * SIDE)));
            println!(
                "{name}, edges {edges}: {:.3} times the {alone:.0} ns a particle-step without, +{:.1} ns",
                with / alone,
                with - alone
            );
        }
    }
}
