//! energy-drift: a bent strip is let go and swings without damping for 10⁶ steps; the energy has to stay.

use std::ops::ControlFlow;
use std::time::Instant;

use explicit_dynamics::{Observer, Record, Transient, largest_eigenvalue, stable_step};
use implicit_statics::{Newton, NewtonOptions};
use sph_shell::{Shell, StaticShell};

use super::bare::{ENERGY, SHOWN, figure, in_time, model, outcome};
use crate::case::{Case, Headline, Published, Run, Variant};
use crate::cases::dial::{self, CELL};
use crate::outcome::Outcome;
use crate::{JudgeError, Metric};

const SCENE: &str = include_str!("../../../../scenes/ring.toml");
/// Part of the moment that rolls the strip into a ring; the tip starts at about .7 of the length above the clamp.
const LEVEL: f64 = 0.25;
const SAFETY: f64 = 0.8;
fn safety() -> f64 {
    std::env::var("SAF").ok().and_then(|s| s.parse().ok()).unwrap_or(SAFETY)
}

const RECORDS: u64 = 1000;
const DRIFT: &str = "drift";
const SWING: &str = "largest error";

pub fn case() -> Case {
    Case {
        name: "energy-drift",
        title: "A strip let go from a quarter of a circle, swinging for 10⁶ steps",
        about: "The ring's strip is bent by ¼ of the moment without time, let go, and marched at .8 of the limit. The drift is \
                the mean energy of the last tenth of the run less that of the first tenth, in parts of the energy given. Wide \
                stencils and nodal sampling, seven times as dear, run for 10⁵ steps.",
        citation: "reference: the energy given at the start",
        variants: ENERGY
            .into_iter()
            .filter(|m| std::env::var("ONLY").is_ok_and(|o| &o == m))
            .map(|method| {
                variant(
                    method,
                    if method == CELL {
                        1_000_000
                    } else {
                        std::env::var("STEPS").ok().and_then(|s| s.parse().ok()).unwrap_or(100_000)
                    },
                )
            })
            .collect(),
        each,
        together: |_| Ok(Vec::new()),
        headline: Some(Headline { metric: DRIFT, floor: 1e-6, published: || Ok(Vec::<Published>::new()) }),
        figures: |_| Ok(Vec::new()),
    }
}

fn variant(method: &str, steps: u64) -> Variant {
    let strip = || dial::variant(method, SCENE, "plate", [25, 3]);
    let bent = strip().set("analysis.static.levels", 1);
    let free = in_time(strip().set("loads", "[]"), 1.0, 1.0);
    Variant::study(method, "25×3 released", move || {
        let shell = let_go(model(&bent, 1)?.shell, model(&free, 1)?.shell)?;
        swing(shell, steps)
    })
}

/// Brings the unloaded shell into the balance of the loaded one.
fn let_go(loaded: Shell, mut free: Shell) -> Result<Shell, String> {
    let mut system = StaticShell::new(loaded);
    let mut newton = Newton::new(&system, &NewtonOptions::default()).map_err(|e| e.to_string())?;
    for part in 1..=5 {
        newton.at_level(&mut system, LEVEL * f64::from(part) / 5.0).map_err(|e| e.to_string())?;
    }
    for a in 0..free.len() {
        free.set_state(a, system.shell().position(a), system.shell().director(a));
    }
    Ok(free)
}

/// Keeps total energies.
struct Totals(Vec<f64>);

impl Observer<Shell> for Totals {
    fn record(&mut self, shell: &mut Shell, record: &Record) -> ControlFlow<()> {
        if std::env::var("DEBUG_SWING").is_ok()
            && (self.0.len() % 25 == 0 || (self.0.len() > 850 && self.0.len() < 900))
        {
            let s = largest_eigenvalue(shell, 60);
            let dt = stable_step(&s, 1.0).unwrap_or(0.0);
            let hot = (0..shell.len())
                .map(|a| {
                    (
                        shell.velocity(a).norm_squared() * shell.reference().masses[a]
                            / record.energy.kinetic,
                        a,
                    )
                })
                .fold((0.0, 0), |b, x| if x.0 > b.0 { x } else { b });
            let rot: f64 = (0..shell.len())
                .map(|a| shell.director_rate(a).norm_squared() * shell.reference().inertias[a])
                .sum::<f64>()
                * 0.5;
            eprintln!(
                "L {} dt_lim {:.6} E {:.4e} K {:.4e} rot {:.3} hot {:.3} {}",
                self.0.len(),
                dt,
                record.energy.kinetic + record.energy.internal,
                record.energy.kinetic,
                rot / record.energy.kinetic,
                hot.0,
                hot.1
            );
        }
        self.0.push(record.energy.kinetic + record.energy.internal);
        ControlFlow::Continue(())
    }
}

fn swing(mut shell: Shell, steps: u64) -> Result<Outcome, String> {
    let started = Instant::now();
    let dt = stable_step(&largest_eigenvalue(&mut shell, 30), safety()).map_err(|e| e.to_string())?;
    let duration = dt * steps as f64;
    let mut totals = Totals(Vec::new());
    let run = Transient { duration, record_every: duration / RECORDS as f64, damping: 0.0, safety: safety() };
    let ended = run.march(&mut shell, &mut totals);
    let (steps, failure) = match ended {
        Ok(clock) => (clock.steps, None),
        Err(error) => (0, Some(error.to_string())),
    };
    if std::env::var("DEBUG_SWING").is_ok() {
        for (i, e) in totals.0.iter().enumerate().filter(|(i, _)| i % 20 == 0) {
            eprintln!("{i} {:.4}", e / totals.0[0]);
        }
    }
    let tenth = (totals.0.len() / 10).max(1);
    let mean = |part: &[f64]| part.iter().sum::<f64>() / part.len() as f64;
    let given = totals.0[0];
    let drift = (mean(&totals.0[totals.0.len() - tenth..]) - mean(&totals.0[..tenth])) / given;
    let worst = totals.0.iter().fold(0.0_f64, |worst, e| worst.max((e / given - 1.0).abs()));
    let figures = [(DRIFT, "%", 100.0 * drift), (SWING, "%", 100.0 * worst)];
    Ok(outcome(&shell, steps, started, &figures, failure))
}

fn each(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    Ok(vec![figure(run, DRIFT, "%")?.because("TODO"), figure(run, SWING, "%")?.because(SHOWN)])
}
