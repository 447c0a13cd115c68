//! Two peers, threads that share a plate, against two threads that march it as one process: how long a step takes, in turns.
//!
//! ```text
//! cargo run --release -p sph-shell --example peers
//! ```

use std::error::Error;
use std::sync::Barrier;
use std::time::Instant;

use explicit_dynamics::Clock;
use peers::together;
use shell_kinematics::{Isotropic, IsotropicSection, StretchCorrected};
use sph_core::{EndWeights, Plate, Vec3, lattice};
use sph_shell::{AppliedLoad, Formulation, Gravity, Parts, Pressure, Reach, Shell};

/// Turns, of which medians are taken.
const TURNS: usize = 41;

/// Particles moved in a turn.
const PARTICLE_STEPS: usize = 1_000_000;

/// A free square plate in slow motion, under its weight and a pressure.
fn plate(side: usize, threads: usize) -> Result<Shell, Box<dyn Error>> {
    let applied = |load| AppliedLoad { load, amplitude: explicit_dynamics::Amplitude::Constant };
    let mut shell = Shell::builder(Parts {
        cloud: lattice(&Plate { lengths: [1.0, 1.0] }, [side, side], EndWeights::Trapezoid)?,
        section: Box::new(IsotropicSection::new(Isotropic::new(1e6, 0.3)?, 0.01)?),
        strain: &StretchCorrected,
        material_axis: None,
        density: 1.0,
        formulation: Formulation::StressPoint(Reach::Cell),
        supports: Vec::new(),
        loads: vec![
            applied(Box::new(Gravity { acceleration: Vec3::z() * -0.1 })),
            applied(Box::new(Pressure { value: 1e-3, follower: true })),
        ],
        threads,
    })
    .build()?;
    for a in 0..shell.len() {
        let x = shell.position(a);
        shell.set_rate(a, Vec3::new(x.y, -x.x, x.x * x.y), Vec3::zeros());
    }
    Ok(shell)
}

/// A march under way.
struct March {
    shell: Shell,
    clock: Clock,
}

impl March {
    fn start(mut shell: Shell) -> Result<Self, Box<dyn Error>> {
        let clock = Clock::start(&mut shell, 1.0, 0.5, 0.0)?;
        Ok(Self { shell, clock })
    }

    /// Time of a step, of several [ns].
    fn step(&mut self, steps: usize) -> Result<f64, Box<dyn Error>> {
        let start = Instant::now();
        for _ in 0..steps {
            self.clock.step(&mut self.shell, f64::INFINITY, |_| 1.0)?;
        }
        Ok(start.elapsed().as_secs_f64() * 1e9 / steps as f64)
    }
}

fn median(mut times: Vec<f64>) -> f64 {
    times.sort_by(f64::total_cmp);
    times[times.len() / 2]
}

fn main() -> Result<(), Box<dyn Error>> {
    println!("particles  one thread  two threads  two peers, ns a particle-step  two peers over two threads");
    for side in [100, 317] {
        let steps = PARTICLE_STEPS / (side * side);
        let pool = rayon::ThreadPoolBuilder::new().num_threads(2).build()?;
        let turn = Barrier::new(2);
        let times = together(2, |peers| {
            let first = peers.rank() == 0;
            let measured = || -> Result<[f64; 4], Box<dyn Error>> {
                let mut others = if first {
                    vec![March::start(plate(side, 1)?)?, March::start(plate(side, 2)?)?]
                } else {
                    Vec::new()
                };
                let mut plate = plate(side, 1)?;
                plate.share(peers)?;
                let mut shared = March::start(plate)?;
                let (mut times, mut ratios) = ([const { Vec::new() }; 3], Vec::new());
                for _ in 0..TURNS {
                    for (march, times) in others.iter_mut().zip(&mut times) {
                        times.push(pool.install(|| march.step(steps).map_err(|e| e.to_string()))?);
                    }
                    turn.wait();
                    times[2].push(shared.step(steps)?);
                    turn.wait();
                    if first {
                        ratios.push(times[2][times[2].len() - 1] / times[1][times[1].len() - 1]);
                    }
                }
                if !first {
                    return Ok([0.0; 4]);
                }
                let [one, two, peers] = times;
                Ok([median(one), median(two), median(peers), median(ratios)])
            };
            measured().map_err(|error| error.to_string())
        })?;
        let [one, two, peers, ratio] = times[0].clone()?;
        let particles = (side * side) as f64;
        println!(
            "{particles:9}  {:10.1}  {:11.1}  {:9.1}  {ratio:48.3}",
            one / particles,
            two / particles,
            peers / particles
        );
    }
    Ok(())
}
