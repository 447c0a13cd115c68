//! Own body: a model that is not in the library, taken through its analyses. The mechanics of a body are two traits
//! of the layers below, [`Dynamics`](explicit_dynamics::Dynamics) and [`Equilibrium`](implicit_statics::Equilibrium); what
//! coque asks beside them is a [`Body`](coque::Body): where its particles are, what can be read on them, what its fields
//! show, what it keeps. Curves, checkpoints, frames and every analysis then come from coque.
//!
//! The body, in `coque/tests/common/chain.rs`: n beads of mass m on springs of stiffness k, the first tied to a wall, the
//! last pulled by the force λ.
//!
//! ```text
//! wall ─/\/\─ ● ─/\/\─ ● ─/\/\─ ● → λ        m = k = 1
//!
//! at rest    u_n = nλ/k
//! mode j     ω_j = 2 √(k/m) sin( (2j − 1)π / 2(2n + 1) )
//! ```
//!
//! `cargo run --release -p coque --example 7_own_body`; before: `6_own_kernel`, next: `8_steps`. The table
//! "To add …" of ARCHITECTURE.md tells where each kind of extension goes once it is to stay.

#[path = "../tests/common/chain.rs"]
mod chain;

use std::error::Error;
use std::f64::consts::PI;

use chain::Chain;
use coque::scene::bounded::{
    Modes, NotNegative, Positive, RelaxationIterations, RelaxedResidual, Residual, Safety,
};
use coque::scene::{
    Analysis, Explicit, Levels, Measured, Modal, Output, Relaxation, RelaxationDamping, Static, Transient,
};
use coque::{Curve, Description, Force, Length, Model, Probe, Ready, Silent, Task, Time, Units};
use sph_core::Vec3;

const BEADS: usize = 8;

/// The chain under an analysis, with the displacement of its end as the one column of its own.
fn curve(analysis: Analysis) -> Curve {
    let chain = Box::new(Chain::new(BEADS));
    let body =
        if let Analysis::Explicit(_) = analysis { Ready::Dynamic(chain) } else { Ready::Static(chain) };
    let units = Units { length: Length::Metre, force: Force::Newton, time: Time::Second, by_depth: false };
    let task = Task { title: "Beads on springs".into(), units, analysis, output: Output::default() };
    let description = Description { kind: "chain", particles: BEADS, dof: BEADS, ..Description::default() };
    let end = Probe::new("u_end", Measured::Displacement, vec![BEADS as u32 - 1], Vec3::x());
    Model::new(task, body, description, vec![end]).run(&mut Silent).curve
}

fn main() -> Result<(), Box<dyn Error>> {
    let levels = || Levels::Equal(1);
    let march = Transient {
        duration: Positive::new(500.0)?,
        record_every: Positive::new(100.0)?,
        damping: NotNegative::new(0.2)?,
        base: None,
    };
    let damping = RelaxationDamping::Kinetic;
    let exact = BEADS as f64;
    let omega = 2.0 * libm::sin(PI / (2.0 * (2 * BEADS + 1) as f64));
    let rows = [
        (
            "static",
            "u_end",
            Analysis::Static(Static { tolerance: Residual::new(1e-9)?, ..Static::at(levels()) }),
        ),
        (
            "relaxed",
            "u_end",
            Analysis::Relaxation(Relaxation {
                force: NotNegative::default(),
                levels: levels(),
                tolerance: RelaxedResidual::new(1e-9)?,
                damping,
                iterations: RelaxationIterations::new(10_000)?,
            }),
        ),
        (
            "marched, damped",
            "u_end",
            Analysis::Explicit(Explicit {
                safety: Safety::new(0.8)?,
                quasi_static: None,
                transient: Some(march),
            }),
        ),
        ("first mode", "circular_frequency", Analysis::Modal(Modal { modes: Modes::new(1)? })),
    ];
    println!("{:18}{:>14}{:>14}{:>10}", "analysis", "found", "exact", "off");
    let mut worst = 0.0_f64;
    for (name, column, analysis) in rows {
        let exact = if column == "u_end" { exact } else { omega };
        let curve = curve(analysis);
        let found = curve.column(column).and_then(|values| values.last().copied()).ok_or("no such column")?;
        let off = (found / exact - 1.0).abs();
        println!("{name:18}{found:14.9}{exact:14.9}{off:10.1e}");
        worst = worst.max(off);
    }
    if worst > 1e-6 { Err(format!("off by {worst:e}").into()) } else { Ok(()) }
}
