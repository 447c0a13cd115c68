//! Equilibria of discrete systems: Newton, arc length, dynamic relaxation, inertia, modes.
//!
//! This crate knows no shell. A system tells by [`Equilibrium`] its forces, its tangent and how it moves; everything
//! else is here. The sparse solver stands behind one type, [`SymmetricSolver`].
//!
//! | to | use |
//! |---|---|
//! | solve a linear problem | [`linear_response`] |
//! | find equilibrium at a load | [`Newton::at_level`] |
//! | follow a path past limit and turning points | [`follow`] with a [`Control`] |
//! | lead it by one linear answer a step, out of balance | [`OneSolve`] |
//! | locate critical points on the way | [`CriticalOptions`] in [`PathOptions`] |
//! | hold a system of one's own against differences | [`force_error`], [`stiffness_error`], [`tangent_error`], [`load_rate_error`] |
//! | take the branch that leaves a bifurcation | [`Branches`] in [`CriticalOptions`]; from a point of a path that is done, [`switch_branch`] |
//! | find equilibrium without a factor of the tangent, at a level or at many | [`relax`], [`Relaxation`] |
//! | solve several systems together, with what they do to each other | [`Several`], over [`Joinable`] and [`Interaction`] |
//! | know frequencies; with the mass that a medium adds | [`natural_modes`]; [`natural_modes_with`] an [`AddedMass`] |
//! | combine greatest answers of modes by a response spectrum | [`ResponseSpectrum`], [`ModesTogether`] |
//! | integrate answers to noise over frequency | [`PowerDensity`], [`noise_frequencies`] |
//! | estimate buckling loads | [`linear_buckling`] |
//!
//! A spring that softens, `q − q³ = λ`, has its limit point at q = 1/√3:
//!
//! ```
//! use implicit_statics::{
//!     Control, CriticalKind, CriticalOptions, Equilibrium, PathOptions, Start, follow,
//! };
//! use std::ops::ControlFlow;
//!
//! struct Softening(f64);
//! impl Equilibrium for Softening {
//!     fn unknowns(&self) -> usize { 1 }
//!     fn pattern(&self) -> Vec<(usize, usize)> { vec![(0, 0)] }
//!     fn internal(&mut self, _: f64, out: &mut [f64]) { out[0] = self.0 - self.0.powi(3); }
//!     fn external(&mut self, level: f64, out: &mut [f64]) { out[0] = level; }
//!     fn load_rate(&mut self, _: f64, out: &mut [f64]) { out[0] = 1.0; }
//!     fn tangent(&mut self, _: f64, values: &mut [f64]) { values[0] = 1.0 - 3.0 * self.0.powi(2); }
//!     fn update(&mut self, increment: &[f64]) { self.0 += increment[0]; }
//!     fn save(&self) -> Vec<f64> { vec![self.0] }
//!     fn restore(&mut self, saved: &[f64]) { self.0 = saved[0]; }
//!     fn energy(&mut self) -> f64 { 0.5 * self.0.powi(2) - 0.25 * self.0.powi(4) }
//!     fn masses(&self) -> Vec<f64> { vec![1.0] }
//!     fn name_unknown(&self, _: usize) -> String { "the spring".into() }
//! }
//!
//! let mut options = PathOptions::new(Control::ArcLength { first: 0.05, range: (-0.1, 1.0) });
//! options.critical = Some(CriticalOptions::default());
//! let path = follow(&mut Softening(0.0), &Start::default(), &options, |_, _| ControlFlow::Continue(()));
//! assert!(path.end.is_ok());
//! let [limit] = &path.critical[..] else { panic!("one limit point") };
//! assert_eq!(limit.kind, CriticalKind::Limit);
//! assert!((limit.level - 2.0 / 27.0_f64.sqrt()).abs() < 1e-6);
//! ```
//!
//! # The problem
//!
//! `internal(q, λ) = external(q, λ)`, one load level λ, unknowns q without held degrees of freedom: these stand where the
//! level puts them. With the residual `r = external − internal`, `p = ∂r/∂λ` and the symmetric tangent `K = −∂r/∂q`, one
//! iteration of [`Newton`] under a further equation c(q, λ) = 0 is the bordered solve \[batoz1979\] by two solves with
//! one factor:
//!
//! ```text
//! K δ_r = r     K δ_p = p     δ = δ_r + δλ δ_p      δλ from the linearised further equation
//! ```
//!
//! | [`Control`] | further equation | source |
//! |---|---|---|
//! | `Load` | `λ` given; steps that overshoot are shortened by a line search on `δ·r`; predicted by `K⁻¹p δλ` where held values move or the bend is known | \[matthies1979\], \[crisfield1991\] |
//! | `Displacement` | `c·Δq = target` | \[batoz1979\] |
//! | `ArcLength` | `Σ w_i Δq_i² + ψ² Δλ² = R²`, linearised consistently | \[crisfield1981\], \[schweizerhof1986\] |
//!
//! Increments live in the tangent space of the present state and [`Equilibrium::update`] moves along it, so that
//! directors may turn on their spheres. Weights w_i of the arc are the masses over their sum, R is the
//! arc length of a step, `ψ²` is `load_share` times the square of the linear answer to a unit of level at the start. An
//! arc-length step starts along the last step \[feng1996\].
//!
//! Where the system tells the motion to a saved state ([`Equilibrium::motion_to`]), steps of load and displacement start on the
//! parabola through the last two points that has the tangent at the second: with a step t along it, the last step l and the
//! ratio c of their sizes, at `t + c t − c² l`, as long as the bend is no more than half of t. Where it keeps factors
//! ([`Equilibrium::keeps_factor`]), such a step and every iterate whose residual has fallen below [`NewtonOptions::keep`] of the one
//! before go on with the factor at hand; what makes the residual grow is taken back; what balances by another factor must meet
//! a tenth of the bound. Arcs have a factor for every iterate: their points depend on how fast steps converge. Paths in parts go on from one solver
//! ([`Newton::follow`]): a state that balances is not corrected again, and its factor serves on. A [`Start`] holds all that
//! this takes, so that a path begun anew there has the same bits.
//!
//! Converged means `|r| ≤ 1e-9` of the largest of `|external|`, `|p Δλ|` and the internal forces so far; where rounding
//! of forces exceeds that, a residual that no longer falls while corrections are below 1e-8 of the way. Steps grow and
//! shrink by `√(target/iterations)`; one that fails is repeated with half its size from the last converged state
//! ([`PathOptions`]).
//!
//! A state that is kept is announced ([`Equilibrium::commit`]); what is tried on the way is not, and [`Equilibrium::restore`] brings
//! histories back with the state.
//!
//! # What is enclosed
//!
//! Where one number depends on all that encloses something, as the pressure of a gas on its volume, the tangent is `K + Σ c g gᵀ` with
//! vectors g that fill it ([`Equilibrium::beside_pattern`]). K alone is assembled and factorised; each solve is corrected, and the signs of the
//! pivots are put right ([`RankOne`]), so that inertia, critical points and modes are those of the whole. Linearised buckling and conjugate
//! gradients refuse such systems.
//!
//! # What breaks
//!
//! A system may have parts that break at a limit ([`Equilibrium::utilisation`]). A step that takes any beyond is made shorter, by a
//! secant, to where the first limit is met; the critical set breaks ([`Equilibrium::break_critical`]), the level (the controlled displacement) is balanced
//! without it, and so on until all is within its limits; then the path goes on. Each [`Breach`] tells the energy that the set
//! held and what else was set free at a constant level; both and what is stored are the work of the loads. Where a level has no
//! balance without what broke, the path ends by [`EquilibriumError::GaveWay`]: it is the greatest load borne.
//!
//! # Dynamic relaxation
//!
//! [`Relaxation`] lets the unknowns move as masses under the residual, with a fictitious step of one and M from row sums:
//!
//! ```text
//! v ← v + M̃⁻¹ r     q ← q + v     M_i = Λ/4 Σⱼ|K_ij|                                  \[underwood1983\]
//! Kinetic     from rest with half a kick, v = ½ M̃⁻¹ r, wherever v·r < 0
//! Rayleigh    v ← [(1 − ½c) v + M̃⁻¹ r]/(1 + ½c),  c = 2 √(v·Kv / v·M̃v),  v·Kv by the change of r
//! M̃⁻¹         M⁻¹ + Z diag(ω_c²/ω² − 1) Zᵀ,  ZᵀMZ = 1,  ZᵀKZ = diag(ω²),  ω_c² the greatest ω²  \[nicolaides1987\]
//! ```
//!
//! Where the stiffness along the last move exceeds `4 v·M̃v` and the residual grows, masses are taken anew. Converged means
//! `|r|` below the tolerance times the larger of `|external|` and of the forces that bring prescribed values about.
//!
//! A motion that is damped as its slowest mode wants it takes of the order of `ω_max/ω_min` evaluations for a digit or two. Z, at most
//! twelve slow modes, makes that `ω_max/ω₁₃`. They come of the motion itself: every 100 iterations the present Z and a move of each 25 go through
//! Rayleigh's and Ritz's method, which takes a difference of forces for each, and the motion begins again from rest. With ω² of
//! the present state nothing can be lost: `M̃⁻¹K` has no eigenvalue above that of `M⁻¹K` and ω_c², at most ¼, together, however far Z is from modes. So
//! Z serves the levels that follow as well.
//!
//! A level starts on a polynomial through the last equilibria, of the order, three at most, that would have come nearest to the last one; none if all
//! would have led away from it, as after a snap. It needs [`Equilibrium::motion_to`]. A start that leads out of the bounds of the
//! model is given up for the state before.
//!
//! A motion goes along with a snap, and what it ends at balances like any other state. The energy tells it: what loads and
//! prescribed motions do between two levels by the trapezoidal rule exceeds what the body gains by no more than
//! `½ |Δλ| |ΔE′|` on any path of stable equilibria under loads, E′ the rate of the potential ([`SnapEnergy`]). Under prescribed motions,
//! whose force may fall on the way, it is `¼ k Δλ²` with a slope k four times the steepest so far.
//!
//! A strip of 50×5 particles rolled up to a ring in 8 levels takes 3250 evaluations to 1e-6; 24 900 without Z and
//! polynomials; ramp and hold, with its period known, 72 300 steps. Without going back to the peak, a shallow shell of 21×21 particles did
//! not converge in 15 000 evaluations at its first level; with it in 3100, with Z in 1090.
//!
//! # Inertia, critical points, branches
//!
//! `K = L D Lᵀ` after scaling to a unit diagonal by powers of two; where that has negative pivots and the diagonal of `|L||D||L|ᵀ` exceeds a hundred
//! times that of K, `K = L B Lᵀ` with 1×1 and 2×2 pivots \[bunch1977\]. By Sylvester's
//! law the signs of the pivots are those of the eigenvalues, [`Inertia`]: where the number of negative ones changes
//! along a path, the tangent was singular. That place is bracketed by trial steps, beside the zero of the line through the weakest
//! eigenvalues of the last two, else in the middle; the mode φ is the weakest
//! direction of K at the near end, and
//!
//! ```text
//! |p·φ| / (|p| |φ|)  > 1e-4   limit point          CriticalKind::Limit
//!                    else     bifurcation          CriticalKind::Bifurcation
//! ```
//!
//! with norms scaled by the diagonal stiffness \[wriggers1990\] ([`CriticalPoint`]). What was bracketed but not located is a
//! [`Passage`].
//!
//! An arc may take the branch that leaves ([`Branches`]) where the number of negative pivots goes from none to one at a bifurcation:
//! in place of the step that passed it, one along ±φ from the near end of the bracket, to the equilibrium and level with an amplitude a of
//! φ in the motion \[wagner1988\],
//!
//! ```text
//! φ·M Δq = a φ·Mφ     |λ − λ_c| ≥ Δλ₀²/λ_c
//! ```
//!
//! with Δλ₀ the first change of level of the path: a is doubled from the arc that passed the bifurcation on. Where λ goes by the square of
//! a, this is the same part of the amplitude that doubles the level as Δλ₀ is of the level; later steps are counted in it. M are the masses,
//! so that the first of the greatest entries `√m φ`, which a makes positive, is the same in any unit. The path stays where two modes are critical at
//! once, and where it is unstable already.
//!
//! # Steps that leave their branch
//!
//! Newton may end on another branch of equilibria, where inertia tells nothing: beyond a snap both ends are stable. With
//! [`CriticalOptions`] given, every step Δq is compared with the tangents q′ at its two ends, each over the whole step:
//!
//! ```text
//! |Δq − ½ (q′₀ + q′₁) Δs| / |Δq|  > ½    the step strays;  > ¼ where an iterate had more negative pivots than both ends
//! ```
//!
//! Along a branch this is the error of the trapezoidal rule, of third order in Δs. It costs one solve a step with a factor
//! at hand. An arc that strays is halved. A step of load or displacement that strays is kept, and its branch followed by
//! arc length from where it began: if it leads to the state found, nothing is said; if it turns back, its limit point is
//! located and [`Passed::Turn`] says that the state lies on another branch. A step to the falling side of a limit point is
//! refused by the sign of the response ([`EquilibriumError::Fold`]). What ends alone cannot tell: a leap that is by chance as
//! long, in every unknown, as the mean of its tangents.
//!
//! # Modes
//!
//! ```text
//! K φ = ω² M φ                      natural_modes: (K − σM)⁻¹M is iterated, σ the shift
//! K φ = ω² (M + BᵀL⁻¹B) φ           natural_modes_with: the same, pressures of a medium as unknowns in the factor (AddedMass)
//! (K + μ K_g) φ = 0                 linear_buckling: critical level λ + μ; (K + σK_g)⁻¹K is iterated, with eigenvalues μ/(μ − σ)
//! ```
//!
//! both by block Lanczos with thick restarts \[wu2000\], in the inner product of M (diagonal) and of K. The shift σ of buckling
//! \[grimes1994\] lies a little above the last level wanted: exactly the levels in (0, σ) have negative eigenvalues, and dense
//! spectra come apart. In both problems the inertia of a factor counts the eigenvalues of the interval ([`Counted`]): what
//! comes back is proved complete, or an error. One solve each bounds the distance to an exact eigenvalue (`residual`).
//! faer's partial eigen-solver has no inner product, no blocks for multiple eigenvalues, and cannot be stopped; it is not used.
//!
//! K_g = dK/dλ is a central difference of exact tangents, [`Prebuckling`] says of which. `Rotations` differentiates along the whole
//! linear response u, in unknowns that turn with the structure ([`Equilibrium::turned_tangent`]): the change of shape before
//! buckling counts as well as the stresses. In fixed directions a rotation θ shows the bending of a thin structure its membrane,
//! and to the first order in θ the level of a deep beam that buckles aside comes out at a quarter. `Stress` holds the shape and
//! differentiates along the stresses of u alone, which is what most finite-element programs call linear buckling. Both
//! hold the stiffness of loads that follow the structure. They agree where the response does not turn the structure (plates
//! and columns in their plane) and differ where edges bend before buckling; neither is the limit of the nonlinear path.
//!
//! # Steady vibration
//!
//! ```text
//! (κK + (iωα − ω²) M) u = p           u(t) = Re[u exp(iωt)]
//! κ = 1 + iη or 1 + iωβ               DirectResponse: a factor of twice the unknowns at each frequency \[day2001\]
//! u = Σ φ f/(ω_n² κ_n − ω²) + c …     ReducedResponse: modes, and c = K⁻¹(p − MΦΦᵀp) as one shape more \[dickens1997\]
//! ```
//!
//! The vector c is orthogonal to the modes in K and in M. The answer at ω = 0 is therefore the static one whatever the number of modes, and c has inertia and
//! damping of its own. Without damping the direct answer needs the unknowns once, and the negative pivots count the natural frequencies below.
//!
//! # What holds, and the test that says so
//!
//! | invariant | test |
//! |---|---|
//! | residuals fall quadratically, bordered steps too | `residuals_fall_quadratically`, `bordered_steps_converge_quadratically_too` (tests/newton.rs) |
//! | a failure says where, and leaves the state as it was | `failures_say_where_and_leave_the_state`, `a_mechanism_is_named` |
//! | rounding of the forces ends the iteration | `rounding_of_the_forces_ends_the_iteration` |
//! | load control stops before the falling side of a limit point | `load_control_follows_the_arch_up_to_its_limit`, `a_load_step_that_leaps_over_a_limit_point_is_refused` (tests/paths.rs) |
//! | a step to another branch names where its own turns back, over one limit point or many, with line search or without; a long step on its branch says nothing | `a_load_step_to_the_far_side_of_the_arch_names_the_limit_it_leapt_over`, `a_leap_over_many_limit_points_names_the_first`, `a_displacement_step_over_a_turning_point_says_so`, `steps_that_stay_on_their_branch_are_proved_to` |
//! | a balance beyond the bounds of the model is refused | `a_balance_beyond_the_bounds_of_the_model_is_refused` |
//! | one solve a step is of the second order, tells how far off it is, and goes with held values that move | `errors_are_of_the_second_order_and_reported`, `held_values_go_with_the_level`, `what_is_no_number_is_named` (tests/one_solve.rs) |
//! | a change of inertia that cannot be located is bracketed | `what_cannot_be_located_is_bracketed` (tests/critical.rs) |
//! | what holds a system against differences finds its faults, and no number is no agreement | `a_sound_system_shows_rounding_and_a_spoilt_one_its_fault`, `what_is_no_number_is_no_agreement` (tests/derivatives.rs) |
//! | the rest goes along with held values that move, and kept states are announced once | `held_values_go_with_the_level_and_kept_states_are_announced` (tests/newton.rs) |
//! | relaxation finds what Newton finds, on flat and curved spaces, with loads and moved ends | `relaxation_finds_what_newton_finds` (tests/relaxation.rs) |
//! | masses follow a stiffness that grows | `masses_follow_a_stiffness_that_grows`, `row_sums_are_those_of_the_tangent` |
//! | no state is said to be found that does not balance; the state stays | `what_is_not_found_is_said_and_the_state_stays` |
//! | relaxation crosses a snap, and the energy set free is the closed form's, under loads and prescribed motions; paths set none free | `a_snap_through_lands_beyond`, `the_energy_of_a_snap_is_that_of_its_closed_form`, `what_is_joined_by_stable_states_sets_no_energy_free` (tests/snap_energy.rs) |
//! | a chain settles at its closed form in a fraction of ω_max/ω_min; straight paths take one evaluation a level | `a_chain_settles_at_its_closed_form_in_few_evaluations`, `a_straight_path_is_followed_without_a_move` |
//! | a start that leads out of the model is given up, and what lies outside is refused | `a_start_that_leads_astray_is_given_up` |
//! | slow modes in the span of the moves are found exactly and swing alike | `modes_in_the_span_are_found_and_swing_alike` (src/relaxation/deflation.rs) |
//! | arc length passes limit and turning points, ends exactly at its bound | `arc_length_goes_through_both_limit_points_and_ends_at_the_bound`, `arc_length_passes_both_turning_points_of_the_displacement` |
//! | limit points and bifurcations are distinguished and located | `limit_points_of_the_arch`, `a_steep_arch_leans_aside`, `the_rigid_column_buckles_and_its_branch_rises` (tests/critical.rs) |
//! | branches that rise or fall are taken to either side, mirror images to the last bit; limit points, loads and double points are left alone | `the_rigid_column_buckles_to_the_side_asked_for`, `a_branch_that_falls_is_followed_down`, `a_chain_bends_in_its_first_mode_and_its_mirror`, `a_double_bifurcation_is_not_left` (tests/branches.rs) |
//! | inertia is the count of dense eigenvalues, whatever the units | `inertia_equals_the_dense_count_and_solutions_satisfy_their_equations`, `units_of_the_unknowns_do_not_change_the_count` (tests/solver.rs) |
//! | terms beside the pattern: solutions, counts, modes are those of the dense matrix | `terms_beside_the_pattern_are_those_of_the_dense_matrix` (tests/rank_one.rs) |
//! | singular matrices are counted and never solved | `a_free_chain_is_singular_and_never_solved` |
//! | factors repeat to the last bit | `factors_repeat_to_the_last_bit` |
//! | modes of chains and membranes in closed form, double values kept | `modes_of_a_chain_of_springs_and_masses`, `double_frequencies_of_a_membrane` (tests/modes.rs) |
//! | buckling loads in closed form | `buckling_of_a_column_by_its_links`, `buckling_through_the_prestress_of_the_state` |
//! | no level of a dense spectrum is missing, in two factorisations | `no_level_of_a_dense_spectrum_is_missing` |
//! | levels of either sign; a load that stretches is refused | `levels_of_either_sign`, `a_load_that_stretches_is_reported_so` |
//! | joined systems: the tangent is the derivative of all forces; unjoined each answers as alone | `the_tangent_is_the_derivative_of_all_forces`, `unjoined_systems_answer_as_each_alone` (tests/several.rs) |
//! | steady vibration of one unknown is the closed form's, whatever damps it | `one_unknown_swings_as_its_closed_form_says` (tests/harmonic.rs) |
//! | directly and in all modes the same; few modes and the vector c are right far below the last mode | `all_modes_and_the_direct_answer_agree`, `few_modes_are_exact_at_rest_and_near_it` |
//! | what the loads bring in damping takes; force here and way there can be exchanged | `what_comes_in_is_taken`, `force_and_way_can_be_exchanged` |
//! | without damping pivots count what lies below, and resonance is refused | `without_damping_pivots_count_and_resonance_is_refused` |
//! | modes go together as the closed form has it; an oscillator overshoots a step, as it has | `modes_go_together_as_noise_lets_them`, `an_oscillator_overshoots_a_step_as_its_closed_form_says` (response_spectrum) |
//! | one degree of freedom under white noise is its closed form | `one_degree_under_white_noise_is_its_closed_form` (noise) |
//! | terms beside the pattern are damped as the pattern is | `terms_beside_the_pattern_are_damped_alike` |
//! | a medium beside a system counts as the mass that it is, about shifts of either sign | `a_medium_counts_as_the_mass_that_it_is` (tests/added_mass.rs) |
//! | a search for modes ends when asked | `a_search_is_ended_from_outside` |

#![deny(clippy::print_stdout, clippy::print_stderr)]

mod added_mass;
mod apart;
mod block_pattern;
mod bounds;
mod branch;
mod breaking;
mod buckling;
mod critical;
mod dense;
mod derivatives;
mod effort;
mod eigen;
mod equilibrium;
mod error;
mod factor;
mod follow;
mod geometric;
mod harmonic;
mod inertia;
mod iterative;
mod modal;
mod newton;
mod noise;
mod one_solve;
mod options;
mod ordering;
mod path;
mod pattern;
mod places;
mod postorder;
mod rank_one;
mod relaxation;
mod response_spectrum;
mod several;
mod solver;
mod stepper;
mod symbolic;
mod vectors;
mod woodbury;

pub use added_mass::AddedMass;
pub use block_pattern::BlockPattern;
pub use bounds::OutOfBounds;
pub use branch::switch_branch;
pub use breaking::Breach;
pub use buckling::{BucklingMode, BucklingOptions, Sign, linear_buckling};
pub use derivatives::{force_error, load_rate_error, stiffness_error, tangent_error};
pub use effort::{Counted, Effort, Spectrum, Watch, unwatched};
pub use equilibrium::{Equilibrium, Front, row_sums};
pub use error::EquilibriumError;
pub use follow::follow;
pub use geometric::Prebuckling;
pub use harmonic::{
    Complex, CycleEnergies, DirectResponse, EnergyForms, HarmonicDamping, HarmonicMotion, ReducedResponse,
};
pub use inertia::Inertia;
pub use iterative::{ConjugateOptions, Iterated, conjugate_response};
pub use modal::{Mode, lowest_modes, natural_modes, natural_modes_with};
pub use newton::{Converged, Increment, Newton, linear_response};
pub use noise::{PowerDensity, noise_frequencies};
pub use one_solve::OneSolve;
pub use options::{
    Branches, Control, CriticalOptions, Damping, NewtonOptions, PathOptions, RelaxationOptions,
};
pub use path::{CriticalKind, CriticalPoint, End, Passage, Passed, Path, Point, Start};
pub use rank_one::RankOne;
pub use relaxation::{Relaxation, RelaxationMemory, Relaxed, Relaxing, SnapEnergy, relax};
pub use response_spectrum::{
    Combination, DirectionRule, ModesTogether, ResponseSpectrum, SpectralValue, SpectrumBy, correlation,
    pseudo_acceleration,
};
pub use several::{Interaction, Joinable, Several};
pub use solver::SymmetricSolver;
pub use vectors::sign_of_greatest;
