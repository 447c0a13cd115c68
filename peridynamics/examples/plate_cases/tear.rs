//! A brittle plate that buckles, leaps to three half-waves and tears: found at rest until near the leap, then marched.

use explicit_dynamics::{Dynamics, Instant, Step};
use implicit_statics::EquilibriumError;
use peridynamics::{Criterion, Fracture, Parts, Solid};

use crate::linear::buckling;
use crate::path::{IMPERFECTION, shorten};
use crate::plate::{Edges, LENGTHS, WAY, block, end_force, half_waves, nearest, parts, plate, supports};

/// What a unit area of crack takes \[kN/mm\]: of a brittle plastic rather than of aluminium, so that it tears at all.
const ENERGY: f64 = 2e-3;
/// The way made at rest, of the whole.
const AT_REST: f64 = 0.29;
/// The time in which the rest of the way is made \[ms\]; the plate vibrates once in 5.
const TIME: f64 = 20.0;
/// Lines of the table.
const RECORDS: usize = 40;

/// Marches the plate and prints what it does, with the energy that is unaccounted for.
pub fn run(spacing: f64) -> Result<(), EquilibriumError> {
    let critical = buckling(spacing, Edges::Held)?;
    let mut bent = block(spacing);
    let supports = supports(&bent, Edges::Held, -WAY);
    for (x, w) in bent.positions.iter_mut().zip(&critical.shape) {
        x.z = IMPERFECTION * w;
    }
    let unbreakable = bent.faces[..4].iter().flatten().map(|&(node, _)| node).collect();
    let fracture = Fracture { criterion: Criterion::EnergyByStretch(ENERGY), unbreakable };
    let mut plate = plate(Parts { fracture: Some(fracture), ..parts(bent, supports) });
    shorten(&mut plate, AT_REST)?;
    march(plate.solid_mut());
    Ok(())
}

fn march(solid: &mut Solid) {
    let dt = solid.stable_step(0.9).expect("a stable plate").dt;
    let steps = (TIME / dt).ceil() as usize;
    let at = |step: usize| Instant {
        time: step as f64 * dt,
        level: AT_REST + (1.0 - AT_REST) * step as f64 / steps as f64,
    };
    let centre = nearest(solid.block(), 0.5 * LENGTHS[0], 0.5 * LENGTHS[1]);
    let stored = solid.evaluate(at(0));
    let (mut external, mut dissipated) = (0.0, 0.0);
    println!("tear: {steps} steps of {dt:.2e} ms");
    println!(
        " way/mm load/kN centre/mm half-waves kinetic internal broken/kN mm unaccounted broken bonds upper lower fragments"
    );
    for number in 0..steps {
        let kick = if number == 0 { 0.5 * dt } else { dt };
        let step = Step { from: at(number), to: at(number + 1), kick, damping: 0.0 };
        let recorded = number % (steps / RECORDS) == 0;
        let work = if recorded {
            let internal = solid.evaluate(step.from);
            let (load, waves) =
                (end_force(solid, 1), half_waves(solid.block(), |node| solid.position(node).z));
            let broken = solid.broken();
            let work = solid.kick(&step);
            // The kick's work reaches to the middle of the next step: half of it belongs to this state.
            let until = external + 0.5 * work.external;
            let amiss = stored + until - dissipated - work.kinetic - internal;
            let held: f64 = (0..solid.len()).map(|node| solid.fracture_energy(node)).sum();
            let hurt = |sheet: usize| {
                let of = |node: &usize| solid.damage_of_sheets(*node).is_some_and(|of| of[sheet] > 0.0);
                (0..solid.len()).filter(of).count()
            };
            println!(
                "{:6.3} {load:8.3} {:7.3} {waves} {:9.3e} {internal:9.4} {held:9.3e} {amiss:9.1e} {} {} {} {}",
                WAY * step.from.level,
                solid.position(centre).z,
                work.kinetic,
                broken[0].len() / 2,
                hurt(0),
                hurt(1),
                solid.fragments().len(),
            );
            solid.drift(&step);
            work
        } else {
            solid.advance(&step)
        };
        external += work.external;
        dissipated += work.dissipated;
    }
}
