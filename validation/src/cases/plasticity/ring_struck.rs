//! ring-struck: a ring thrown outward by a pressure pulse, whose yield stress grows with the rate.
//!
//! ```text
//!    ↖ ↑ ↗       ρ t R r̈ = p(t) λ₂ r − τ t e⁻ʰ
//!  ←  (p)  →     h = ln r/R    τ = E (h − α)    α̇ = ε̇(τ/σ_y − 1)    λ₂ = exp(−ντ/E − α/2)
//!    ↙ ↓ ↘
//! ```

use libm::{exp, log, pow};

use crate::judge::{Case, Headline, Measured, Run, Variant};
use crate::methods::CELL;
use crate::{JudgeError, Metric};

const SCENE: &str = include_str!("../../../../scenes/ring-struck.toml");
const WAY: &str = "greatest error of the way";
const LOST: &str = "error of the plastic work";
const STEEL: &str = "24 cells, Cowper–Symonds";
const COARSE: &str = "12 cells, Cowper–Symonds";
const JOHNSON: &str = "24 cells, Johnson–Cook";
const SLOW: &str = "24 cells, no rates";

/// Errors \[%\].
const OF_WAY: Measured = Measured(&[(CELL, &[(COARSE, 1.0), (STEEL, 1.0), (JOHNSON, 1.0), (SLOW, 1.0)])]);
const OF_LOST: Measured = Measured(&[(CELL, &[(COARSE, 1.0), (STEEL, 1.0), (JOHNSON, 1.0), (SLOW, 1.0)])]);

/// Radius and thickness \[mm\], a quarter of the volume \[mm³\], density \[t/mm³\], E and σ_y \[N/mm²\], ν.
const RADIUS: f64 = 100.0;
const THICKNESS: f64 = 1.0;
const VOLUME: f64 = 0.5 * std::f64::consts::PI * RADIUS * THICKNESS * 5.0;
const DENSITY: f64 = 7.85e-9;
const YOUNG: f64 = 2e5;
const YIELD: f64 = 250.0;
const POISSON: f64 = 0.3;
/// Half of the pulse \[s\], and its greatest pressure \[N/mm²\].
const HALF: f64 = 1e-5;
const PRESSURE: f64 = 39.25;

/// The scene, the motion of one ring, and how far the two may differ.
pub fn case() -> Case {
    Case {
        name: "ring-struck",
        title: "A ring thrown outward by a pulse",
        about: "A quarter of a narrow ring of mild steel, given some 50 m/s: its way at every record and the work of its flow against the one equation of its radius, elastic \
                and viscoplastic. With Cowper and Symonds' law it goes less than half as far as without rates.",
        citation: "radial motion of a ring of one stress, by Runge and Kutta's method; [cowper1957], [johnson1983]",
        variants: vec![
            ring(13, "").quick_if(true),
            ring(25, ""),
            ring(25, "{ johnson-cook = { reference = 1.0, factor = 0.05 } }"),
            ring(25, "{ cowper-symonds = { reference = 1e60, exponent = 1.0 } }"),
        ],
        each,
        headline: Some(Headline::new(WAY, 1.0)),
        ..Case::default()
    }
}

fn ring(round: usize, rate: &str) -> Variant {
    let grid = match (round, rate) {
        (13, _) => COARSE,
        (_, "") => STEEL,
        (_, rate) if rate.contains("johnson") => JOHNSON,
        _ => SLOW,
    };
    let scene = Variant::scene(CELL, SCENE, grid).set("geometry.cylinder.particles", format!("[{round}, 3]"));
    if rate.is_empty() { scene } else { scene.set("material.plastic.rate", rate) }
}

/// Rate of plastic strain at an overstress above zero \[1/s\].
fn rate(grid: &str, overstress: f64) -> f64 {
    match grid {
        JOHNSON => exp(overstress / 0.05),
        SLOW => 1e60 * overstress,
        _ => 40.0 * pow(overstress, 5.0),
    }
}

/// Radius, its rate, plastic strain and plastic work by volume.
type State = [f64; 4];

/// Stress at a radius and a plastic strain \[N/mm²\].
fn stress(state: &State) -> f64 {
    YOUNG * (log(state[0] / RADIUS) - state[2])
}

fn change(grid: &str, time: f64, state: &State) -> State {
    let [r, v, alpha, _] = *state;
    let (tension, strain) = (stress(state), log(r / RADIUS));
    let narrower = exp(-POISSON * tension / YOUNG - 0.5 * alpha);
    let pressure = PRESSURE * (1.0 - (time / HALF - 1.0).abs()).max(0.0);
    let push = pressure * narrower * r - tension * THICKNESS * exp(-strain);
    let over = tension.abs() / YIELD - 1.0;
    let flow = if over > 0.0 && grid != SLOW { rate(grid, over) } else { 0.0 };
    [v, push / (DENSITY * THICKNESS * RADIUS), flow.copysign(tension), flow * tension.abs()]
}

/// Way and plastic work by volume at times that ascend.
fn motion(grid: &str, times: &[f64]) -> Vec<[f64; 2]> {
    const STEP: f64 = 5e-9;
    let (mut state, mut steps, mut out) = ([RADIUS, 0.0, 0.0, 0.0], 0_u32, Vec::new());
    for &until in times {
        while f64::from(steps + 1) * STEP <= until + 0.5 * STEP {
            let time = f64::from(steps) * STEP;
            state = advanced(grid, time, STEP, &state);
            steps += 1;
        }
        out.push([state[0] - RADIUS, state[3]]);
    }
    out
}

/// A step of Runge and Kutta's method of the fourth order; without rates the stress returns to its bound behind it.
fn advanced(grid: &str, time: f64, step: f64, state: &State) -> State {
    let moved = |change: &State, by: f64| std::array::from_fn(|i| state[i] + by * change[i]);
    let first = change(grid, time, state);
    let second = change(grid, time + 0.5 * step, &moved(&first, 0.5 * step));
    let third = change(grid, time + 0.5 * step, &moved(&second, 0.5 * step));
    let fourth = change(grid, time + step, &moved(&third, step));
    let mut next: State = std::array::from_fn(|i| {
        state[i] + step / 6.0 * (first[i] + 2.0 * (second[i] + third[i]) + fourth[i])
    });
    let beyond = stress(&next).abs() - YIELD;
    if grid == SLOW && beyond > 0.0 {
        next[2] += (beyond / YOUNG).copysign(stress(&next));
        next[3] += beyond / YOUNG * YIELD;
    }
    next
}

fn each(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let (times, way, lost) = (run.column("time")?, run.column("way")?, run.column("lost")?);
    let exact = motion(&run.variant.grid, &times);
    let greatest = exact.iter().fold(0.0, |most: f64, [way, _]| most.max(*way));
    let apart = way.iter().zip(&exact).map(|(way, [exact, _])| (way - exact).abs());
    let off = run.done().then(|| 100.0 * apart.fold(0.0, f64::max) / greatest);
    let work = lost.last().zip(exact.last()).filter(|_| run.done());
    let work = work.map(|(lost, [_, exact])| 100.0 * (lost / (exact * VOLUME) - 1.0));
    let reason = "chords of cells, and steps in time";
    Ok(vec![
        Metric::error(WAY, off, "%").near(OF_WAY.of(run)?, reason),
        Metric::error(LOST, work, "%").near(OF_LOST.of(run)?, reason),
    ])
}
