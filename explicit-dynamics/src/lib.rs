//! Marching `M q̈ = f` by central differences: amplitudes, damping, stable step, energy balance.
//!
//! This crate knows no shell and no particle method. A system tells by [`Dynamics`] how to evaluate forces, how to kick
//! its velocities, how to drift its configuration (which is where a rotation advances on its sphere), how long a step is
//! stable and which bounds it keeps; everything else is here. Marches take `dyn Dynamics` as well.
//!
//! | to | use |
//! |---|---|
//! | march freely in time | [`March`] of a [`Transient`] |
//! | find equilibria along a load path | [`March`] of a [`QuasiStatic`] |
//! | know the stable step | [`Dynamics::stable_step`], [`lanczos_step`], [`largest_eigenvalue`] |
//! | watch, stop | a loop over [`March::advance`] or [`March::next_record`]; [`Event`], [`Record`] |
//! | march several systems together, with what they do to each other | [`Several`], over [`Joinable`] and [`Interaction`] |
//! | march a fluid with the structures in it | [`TwoClocks`], over [`BoundaryDriven`] and [`Wetted`] |
//! | let a function exert forces on the particles of a system | [`Push`] |
//! | keep a march and go on later, to the same bits | [`March::state`], [`MarchState`], [`March::resume`] |
//!
//! # The step
//!
//! Velocities live at the half steps: the leapfrog form of velocity Verlet, the same trajectory of configurations with
//! one kick a step. From time tₙ to tₙ₊₁ = tₙ + Δt
//!
//! ```text
//! f = external(qₙ, tₙ, λ) − internal(qₙ)                        Dynamics::evaluate
//! v ← [v(1 − ½cκ) + κ f/m] / (1 + ½cκ)                          Dynamics::kick
//! q ← q + Δt v            directors: along their great circles  Dynamics::drift
//! ```
//!
//! κ is the span of the kick, from the middle of the last step to the middle of this one ([`Step::kick`]; half a step
//! at the start), c the mass-proportional damping \[1/T\]. Without damping, at constant Δt and for conservative forces,
//! the trajectory is that of velocity Verlet: reversible, second order, its energy error bounded. Steps are therefore
//! kept equal between any two records: [`Clock`] divides the way to the next record into whole steps.
//!
//! # The stable step
//!
//! Central differences are stable for `Δt ω_max ≤ 2`, ω_max² the largest eigenvalue of `M⁻½ K M⁻½`.
//! [`lanczos_step`] finds it by 30 Lanczos steps \[lanczos1950\] on the present tangent
//! ([`LinearisedDynamics::apply`]); an eigenvalue lies within the residual r of the Ritz value θ, and the step is taken
//! from their sum:
//!
//! ```text
//! Δt = safety · 2/√(θ + |r|)
//! ```
//!
//! A system says by [`StableStep::holds`] how long its step is good for: this estimate for 5000 steps, a Courant number for one.
//! Quasi-static marches renew it at every load level, transients at the first record after it has lapsed, and one that holds for
//! a single step is found before every step. Damping does not enter: the scheme
//! takes half of cκ before and half after the kick, which leaves the limit where it is.
//!
//! ```
//! use explicit_dynamics::{LinearisedDynamics, lanczos_step};
//!
//! /// A chain of equal masses m and springs k, held at both ends: ω_j² = 4 (k/m) sin²(jπ/(2n + 2)).
//! struct Chain(f64);
//! impl LinearisedDynamics for Chain {
//!     fn unknowns(&self) -> usize {
//!         8
//!     }
//!     fn apply(&mut self, v: &[f64], out: &mut [f64]) {
//!         let at = |i: Option<usize>| i.and_then(|i| v.get(i)).copied().unwrap_or(0.0);
//!         for i in 0..8 {
//!             out[i] = self.0 * (2.0 * v[i] - at(i.checked_sub(1)) - at(Some(i + 1)));
//!         }
//!     }
//! }
//! let fastest = 2.0 * 100.0_f64.sqrt() * libm::sin(8.0 * std::f64::consts::PI / 18.0);
//! let step = lanczos_step(&mut Chain(100.0), 0.9)?;
//! assert!((step.dt * fastest / 2.0 - 0.9).abs() < 1e-9);
//! # Ok::<(), explicit_dynamics::MarchError>(())
//! ```
//!
//! # Energy
//!
//! At each instant, with the mean v̄ of the velocities before and after the kick ([`Work`], [`Balance`])
//!
//! ```text
//! kinetic     T = ½ Σ m v̄²
//! external    W ← W + κ Σ f_ext·v̄         and the work of supports on prescribed motions
//! dissipated  D ← D + κ c Σ m v̄²           and what a stop of all particles takes away
//! error         = T + U + D − W − (T + U − W at the first record)
//! ```
//!
//! [`Dynamics::within_bounds`] is the watch. A particle beyond [`Bounds::Motion`] ends the run as [`MarchError::Diverged`], which
//! names the particle, its speed and the last record in good order; this is checked every 64 steps, and at once when the
//! kinetic energy has grown fourfold. [`Bounds::Configuration`], the range of the model, is checked every 64 steps and before
//! every record ([`MarchError::OutOfBounds`]).
//!
//! # Finding equilibria by marching
//!
//! [`QuasiStatic`] goes from load level to load level by the quintic `s³(10 − 15s + 6s²)`, which starts and ends
//! without velocity or acceleration, and then holds there until the motion has died and nothing is missing: at two
//! checks in a row, twenty checks a period, kinetic over internal energy is below a tolerance, and the force out of balance
//! over the load and the remaining displacement over the displacement ([`Missing`]) are below an accuracy. The latter two cost four
//! evaluations of the forces at checks that find the motion dead, and nothing else. This is dynamic relaxation
//! \[underwood1983\] with
//!
//! ```text
//! Damping::Ratio     c = 4πζ/T₁       a share ζ of critical damping of the mode of period T₁
//! Damping::Kinetic   v ← 0            whenever the kinetic energy has passed a peak
//! ```
//!
//! T₁ may be given. If not it is that of Rayleigh's quotient of the motion: on the first ramp, begun with a guess of a hundred steps, by the
//! tangent, `v·K̂v/v·v`; at checks of a hold by what one step changes of the force out of balance, `−v·Δa/(Δt v·v)`, with loads that
//! follow and directors under stress in it. It changes by a factor of two at most from check to check, and no longer once the motion is too faint to tell
//! it from rounding. Later ramps go by the period of the hold before them.
//!
//! Loads are read after the hold: damping drags the reaction while a ramp runs. [`LevelReached`] tells whether the
//! motion had died, and what was missing. Real loads follow an [`Amplitude`]: constant, ramp, smooth step, table, sine.
//!
//! # Two clocks
//!
//! [`TwoClocks`] is a fluid and the structures in it as one system. A step Δt of the fluid is M = ⌈Δt/Δt_s⌉ equal steps of each
//! structure, Δt_s its own stable one. In the step from tₙ to tₙ₊₁
//!
//! ```text
//! fluid        Fⁿ at (rⁿ, vⁿ⁻½, v̄ⁿ⁻½)                            evaluate
//! structures   F = Fⁿ + [½(Δt − Δt_s) Fⁿ − J]/Δt − ρ₀c₀A [(v − v̄ⁿ⁻½)·n] n
//! fluid        vⁿ⁺½                                              kick
//! structures   M steps under F, v̄ⁿ⁺½ = (x_sⁿ⁺¹ − x_sⁿ)/Δt        drift: the structures first …
//! fluid        takes back Σ Δt_s ρ₀c₀A [(v − v̄ⁿ⁻½)·n] n
//! fluid        ρⁿ⁺¹, rⁿ⁺¹ with v̄ⁿ⁺½                              … then the fluid ([`Order`])
//! ```
//!
//! With the velocity of the step before, as published couplings have it, the pressure answers late: it feeds back
//! `−ρ₀c₀ v_s(t − τ)` with τ of a step and more. The two other terms of the load do for substeps what that order does for the
//! fluid. A load frozen at tₙ is taken from there to tₙ₊₁, in the mean ½(Δt − Δt_s) too late. As velocities of a structure stand
//! half a step of its own behind its place, and those of the fluid half of its own, the structure has to be ahead by an impulse
//! `½(Δt − Δt_s) F`; J is that by which it is. With equal steps this is `½(1 − 1/M)(Fⁿ − Fⁿ⁻¹)`, the load carried on from the last
//! two ([`TwoClocks::centred`]). Modes faster than the fluid outrun that as well; they feel ρ₀c₀, the pressure of a plane wave
//! ([`TwoClocks::impedance`]). Its impulse goes to the fluid beside the points within the same step: kept from it, it would act
//! as a mass `ρ₀c₀AΔt(1 − 1/M)` that nobody carries; taken off the next load instead, `Δt` later, it would feed slow modes by
//! `Δt ω²` times that mass. With both, no spring in a column of gas gained energy, however many substeps, at any ratio of its
//! period to the step; without either one some do. Momenta less J are kept ([`TwoClocks::impulse_ahead`]).
//!
//! Damping of the march acts on structures, never on the fluid. A kick counts what structures did since the last one; a load
//! is work of the fluid and of the structure with opposite signs, and cancels up to the error of the coupling.
//! The velocity-dependent part of the load enters explicitly: keep `ρ₀c₀Δt_s/(ρ_s t)` well below one.
//!
//! # What holds, and the test that says so
//!
//! | invariant | test |
//! |---|---|
//! | second order: an oscillator is the cosine, the error falls with Δt² | `free_vibration_is_the_cosine_to_second_order` (tests/oscillator.rs) |
//! | kinetic, internal, external and dissipated energy balance | `energy_is_counted_to_the_last` |
//! | both dampings end at the static answer | `ramp_and_hold_ends_at_the_static_answer` |
//! | a hold without rest says so | `a_hold_that_never_rests_says_so` |
//! | a level settles at its equilibrium or says that it did not, for any damping and any period | `what_settles_is_near_its_equilibrium` |
//! | a period that is not given is found | `a_period_that_is_not_given_is_found` |
//! | the remaining displacement is the error, at every phase of a swing | `the_remaining_displacement_is_the_error` |
//! | beyond the stable step a run diverges and hands back its last good record | `beyond_the_limit_it_diverges_with_the_last_good_record` |
//! | steps between records are equal, records fall on their times | `steps_between_records_are_equal` |
//! | the eigenvalue is bounded from both sides | `chain_spectrum_is_bounded_from_both_sides` (src/stable_step.rs) |
//! | a march kept anywhere goes on to the same bits | `quasi_static_marches_go_on_to_the_same_bits`, `transient_marches_go_on_to_the_same_bits` (tests/march_state.rs) |
//! | a march is a value: any number of them may be led in turns, each to the bits that it has alone | `marches_led_in_turns_do_not_know_of_each_other` |
//! | a system behind `dyn Dynamics` marches to the same bits; one without a measure of rest is refused | `a_system_without_a_type_marches_to_the_same_bits`, `a_system_that_does_not_say_when_it_rests_is_refused` (tests/any_system.rs) |
//! | two masses on a spring between them swing as the closed form to second order, momentum to rounding; beside another a system keeps its bits | `two_masses_on_a_spring_swing_as_they_should`, `a_system_beside_another_marches_to_its_own_bits` (tests/several.rs) |
//! | structure first, a spring in a gas never gains energy; fluid first, or without one part of its load, it does | `structure_first_never_gains_energy`, `fluid_first_pumps_energy_into_the_structure`, `loads_that_lag_or_do_not_yield_let_the_energy_grow` (tests/two_clocks) |
//! | momentum of gas and structure is kept but for the impulse under way | `momentum_is_kept_but_for_what_is_under_way` |
//! | a mode of gas and spring is that of the closed form, to second order | `a_mode_of_gas_and_spring_is_found_to_second_order` |
//! | two clocks meet exactly, close the balance, go on to the same bits | `clocks_meet_exactly`, `the_ledger_closes_with_the_step`, `a_run_goes_on_to_the_same_bits` |
//! | ramps start and end at rest | `smooth_starts_and_ends_without_velocity_or_acceleration` (src/amplitude.rs) |

#![deny(clippy::print_stdout, clippy::print_stderr)]

mod amplitude;
mod clock;
mod damping;
mod dynamics;
mod error;
mod interface;
mod linearised;
mod march;
mod march_state;
mod push;
mod quasi_static;
mod record;
mod recorded;
mod rest;
mod several;
mod stable_step;
mod step;
mod transient;
mod two_clocks;

pub use amplitude::Amplitude;
pub use clock::{Clock, Shortened};
pub use damping::{Damping, KineticDamping};
pub use dynamics::{Bounds, Dynamics};
pub use error::{MarchError, OutOfBounds, OutOfRange};
pub use interface::{BoundaryDriven, BoundaryLayout, BoundaryLoad, BoundaryState, Face, ThinLayout, Wetted};
pub use linearised::{LinearisedDynamics, MassScaled};
pub use march::{Event, March, Plan};
pub use march_state::{Hold, LevelUnderWay, MarchState, Stage};
pub use push::{Exert, Push};
pub use quasi_static::QuasiStatic;
pub use record::{Balance, Record};
pub use rest::{LevelReached, Missing, Sizes};
pub use several::{Interaction, Interactions, Joinable, Places, Several};
pub use stable_step::{LANCZOS_STEPS, Spectrum, StableStep, lanczos_step, largest_eigenvalue};
pub use step::{Decay, Instant, Step, Work};
pub use transient::Transient;
pub use two_clocks::{Bracing, Counts, Order, TwoClocks};
