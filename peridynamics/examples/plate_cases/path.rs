//! The plate with a small deflection at rest, shortened far beyond its critical load.

use std::ops::ControlFlow;

use implicit_statics::{
    Control, Damping, Equilibrium, EquilibriumError, Newton, NewtonOptions, PathOptions, RelaxationOptions,
    Start, follow, relax,
};
use peridynamics::{Solid, StaticSolid};
use sph_core::Vec3;

use crate::linear::{self, Critical, buckling};
use crate::plate::{Edges, LENGTHS, WAY, block, end_force, half_waves, nearest, parts, plate, supports};

/// Largest deflection of the mode that the plate has at rest \[mm\].
pub const IMPERFECTION: f64 = 0.2;
/// Levels from nothing to the whole way.
const LEVELS: usize = 60;
/// Residual at which a relaxation ends, over the force that shortens the plate.
const RELAXED: f64 = 1e-6;

/// One state of the path.
#[derive(Clone, Copy, Debug)]
pub struct State {
    /// Part of the way.
    pub level: f64,
    /// Force at the end x = 300 \[kN\].
    pub load: f64,
    /// Deflection at the centre \[mm\].
    pub centre: f64,
    /// Half-waves along the middle.
    pub waves: usize,
    /// Iterations of Newton's method, or of a relaxation.
    pub iterations: usize,
    /// Whether it was reached by relaxation, where Newton's method found no way.
    pub relaxed: bool,
    /// Negative pivots of the tangent.
    pub negative: usize,
}

/// The plate bent at rest by so much of a mode, ready to be shortened.
pub fn bent(spacing: f64, edges: Edges, mode: &Critical, amplitude: f64) -> StaticSolid {
    let mut block = block(spacing);
    let supports = supports(&block, edges, -WAY);
    for (x, w) in block.positions.iter_mut().zip(&mode.shape) {
        x.z = amplitude * w;
    }
    plate(parts(block, supports))
}

/// What is read from a state whose forces are those last evaluated; deflections count from the flat plate.
pub fn read(solid: &Solid, level: f64) -> State {
    let centre = nearest(solid.block(), 0.5 * LENGTHS[0], 0.5 * LENGTHS[1]);
    State {
        level,
        load: end_force(solid, 1).abs(),
        centre: solid.position(centre).z,
        waves: half_waves(solid.block(), |node| solid.position(node).z),
        iterations: 0,
        relaxed: false,
        negative: 0,
    }
}

/// Shortens the plate level by level: by Newton's method predicted along the load rate, by relaxation where that fails.
pub fn shorten(plate: &mut StaticSolid, until: f64) -> Result<Vec<State>, EquilibriumError> {
    let mut out = Vec::new();
    let levels = (until * LEVELS as f64).round() as usize;
    for number in 1..=levels {
        let [from, to] = [number - 1, number].map(|number| number as f64 / LEVELS as f64);
        let step = to - from;
        let mut options = PathOptions::new(Control::Load { step, until: to });
        options.largest = 1.0;
        options.smallest = 0.1;
        let start = Start { level: from, heading: None };
        let path = follow(plate, &start, &options, |_, _| ControlFlow::Continue(()));
        let (iterations, relaxed, negative) = match &path.end {
            Ok(_) => {
                let sum = path.points[1..].iter().map(|point| point.converged.iterations).sum();
                (sum, false, path.points.last().map_or(0, |point| point.inertia().negative))
            }
            Err(error) => {
                println!("   {error}");
                let options = RelaxationOptions { tolerance: RELAXED, ..RelaxationOptions::default() };
                let from = path.points.last().map_or(from, |point| point.level());
                let relaxed = relax(plate, &options, (from, to), |_| ControlFlow::Continue(()))?;
                let found = Newton::new(plate, &NewtonOptions::default())?.at_level(plate, to)?;
                (relaxed.iterations, true, found.inertia.negative)
            }
        };
        plate.evaluate(to);
        out.push(State { iterations, relaxed, negative, ..read(plate.solid(), to) });
    }
    Ok(out)
}

/// Slope of load over shortening between two states, over that of the flat plate.
fn tangent(states: &[State], place: usize, flat: f64) -> f64 {
    let [before, after] = [&states[place - 1], &states[(place + 1).min(states.len() - 1)]];
    (after.load - before.load) / ((after.level - before.level) * flat)
}

/// The path of one spacing, with the figures of plate theory.
pub fn table(spacing: f64) -> Result<(), EquilibriumError> {
    let critical = buckling(spacing, Edges::Held)?;
    let flat = linear::flat(spacing, Edges::Held, -WAY)?[1].abs();
    let mut plate = bent(spacing, Edges::Held, &critical, IMPERFECTION);
    let states = shorten(&mut plate, 1.0)?;
    println!(
        "spacing {spacing}, critical load {:.4} kN; way/mm load/kN load/critical tangent centre/mm half-waves",
        critical.load
    );
    for (place, state) in states.iter().enumerate() {
        let slope = if place > 0 { tangent(&states, place, flat) } else { 1.0 };
        println!(
            "{:5.2} {:8.4} {:6.3} {slope:6.3} {:8.4} {} {:5}{} {}",
            WAY * state.level,
            state.load,
            state.load / critical.load,
            state.centre,
            state.waves,
            state.iterations,
            if state.relaxed { " relaxed" } else { "" },
            state.negative,
        );
    }
    let knee = knee(&states, critical.load);
    let chord = chord(&states, [1.3, 1.9].map(|ratio| ratio * critical.load), flat);
    println!(
        "knee {knee:.4} kN = {:.4} critical loads; slope between 1.3 and 1.9 of them {chord:.3} (theory 1, and .704 at its start)",
        knee / critical.load
    );
    let jump = states.windows(2).find(|pair| pair[1].waves != pair[0].waves && pair[1].waves == 3);
    if let Some([before, after]) = jump {
        println!(
            "jump at {:.3} kN = {:.3} critical loads, to {} half-waves at {:.3} kN, centre {:.3} to {:.3} mm",
            before.load,
            before.load / critical.load,
            after.waves,
            after.load,
            before.centre,
            after.centre
        );
    }
    mirrored(spacing, &critical, &states)
}

/// The critical load that the path tells of: with one half-wave of deflection w, at rest w₀,
///
/// ```text
/// P = P_cr (1 − w₀/w) + c (w² − w₀²),      so that P/(1 − w₀/w) is a straight line over w (w + w₀)
/// ```
///
/// through states between half the critical load and 1.3 of it. Where tangents meet is no measure: one per cent of the slope
/// at 2 P_cr is four of the load.
fn knee(states: &[State], critical: f64) -> f64 {
    let near = states.iter().filter(|state| (0.5..1.3).contains(&(state.load / critical)));
    let points: Vec<[f64; 2]> = near
        .map(|state| {
            [state.centre * (state.centre + IMPERFECTION), state.load / (1.0 - IMPERFECTION / state.centre)]
        })
        .collect();
    let count = points.len() as f64;
    let mean = |of: &dyn Fn(&[f64; 2]) -> f64| points.iter().map(of).sum::<f64>() / count;
    let [x, y] = [mean(&|p| p[0]), mean(&|p| p[1])];
    let slope = mean(&|p| (p[0] - x) * (p[1] - y)) / mean(&|p| (p[0] - x) * (p[0] - x));
    y - slope * x
}

/// Slope of load over shortening between two loads, over that of the flat plate.
fn chord(states: &[State], loads: [f64; 2], flat: f64) -> f64 {
    let level = |load: f64| {
        let pair = states.windows(2).find(|pair| (pair[0].load..pair[1].load).contains(&load));
        let part = |a: &State, b: &State| a.level + (load - a.load) / (b.load - a.load) * (b.level - a.level);
        pair.map_or(f64::NAN, |pair| part(&pair[0], &pair[1]))
    };
    (loads[1] - loads[0]) / ((level(loads[1]) - level(loads[0])) * flat)
}

/// The plate bent to the other side at rest: the same loads, deflections of the other sign.
fn mirrored(spacing: f64, critical: &Critical, states: &[State]) -> Result<(), EquilibriumError> {
    let mut plate = bent(spacing, Edges::Held, critical, -IMPERFECTION);
    let there = shorten(&mut plate, 0.1)?;
    let same =
        there.iter().zip(states).all(|(a, b)| a.load.to_bits() == b.load.to_bits() && a.centre == -b.centre);
    println!("bent to the other side: {}", if same { "the same bits" } else { "NOT the same bits" });
    Ok(())
}

/// Relaxation against Newton's method: flat with viscous damping from places drawn out evenly, buckled with kinetic damping.
pub fn relaxation(spacing: f64) -> Result<(), EquilibriumError> {
    println!("relaxation: iterations; load by Newton's method, relative differences of load and deflection");
    let flat = [
        ("tension, held", Edges::EndsKept, WAY),
        ("flat", Edges::Held, -WAY),
        ("tension, free", Edges::Free, WAY),
    ];
    for (name, edges, way) in flat {
        let block = block(spacing);
        let supports = supports(&block, edges, way);
        compare(name, &mut plate(parts(block, supports)), 1.0, way, Damping::Rayleigh)?;
    }
    let critical = buckling(spacing, Edges::Held)?;
    let mut bent = bent(spacing, Edges::Held, &critical, IMPERFECTION);
    compare("buckled", &mut bent, 0.1, -0.1 * WAY, Damping::Kinetic)
}

/// Finds one state by both.
fn compare(
    name: &str,
    plate: &mut StaticSolid,
    level: f64,
    way: f64,
    damping: Damping,
) -> Result<(), EquilibriumError> {
    let rest = plate.save();
    let exact = shorten(plate, level)?.pop().expect("one level at least");
    plate.restore(&rest);
    let solid = plate.solid_mut();
    for node in 0..solid.len() {
        let x = solid.position(node);
        solid.put(node, x + Vec3::x() * (way * x.x / LENGTHS[0]));
    }
    let options = RelaxationOptions { tolerance: 1e-5, damping, ramp: 1, ..RelaxationOptions::default() };
    let relaxed = relax(plate, &options, (level, level), |_| ControlFlow::Continue(()))?;
    plate.evaluate(level);
    let found = read(plate.solid(), level);
    let (load, centre) = (found.load / exact.load - 1.0, (found.centre - exact.centre).abs());
    println!("{name}: {} {:.4} kN {load:.1e} {centre:.1e} mm", relaxed.iterations, exact.load);
    Ok(())
}
