//! One point of a solid: elastic moduli, strain and rotation of an increment, stress updates and their derivatives.
//!
//! The crate knows neither neighbours nor time. A point has the deformation gradient F, material axes Q that turn with it, and
//! a stress s in those axes ([`PointState`]); a [`Material`] leads it over a step ([`Material::trial`]).
//!
//! ```
//! use solid_kinematics::*;
//! let material = Material {
//!     moduli: Moduli::isotropic(200.0, 0.3)?,
//!     formulation: Formulation::StrainRotation { update: Update::Midpoint, measure: StressMeasure::Kirchhoff },
//!     plastic: None,
//! };
//! let rest = PointState::rest(Tensor::identity());
//! let quarter = Tensor::new(0.0, -1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0);
//! let turned = material.trial(&rest, &quarter)?;
//! assert!(turned.piola.norm() < 1e-12); // a rotation makes no stress
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Strain and rotation
//!
//! Every deformation gradient `F = I + G` whose spin `w = skew G` has `|w| = √(w₁₂² + w₂₃² + w₁₃²) = sin θ ≤ 1` is the sum of a
//! symmetric strain and a rotation \[song2018\], with `a = 1/(1 + cos θ)` ([`decompose`]):
//!
//! ```text
//! F = S + R        S = sym G − a w²        R = I + w + a w²
//! ```
//!
//! S vanishes for every rotation, but it is not frame-indifferent at finite strain: for a stretch of 2 % that is turned, its
//! greatest eigenvalue is 2.0, 2.2, 3.0 and 8.2 % at 0, 30, 60 and 80°. The decomposition is therefore applied to increments.
//!
//! # Stress updates
//!
//! From the state n at the start of the step, over the whole step, never from the iterate before:
//!
//! ```text
//! Midpoint    G = (F − F_n)[½(F + F_n)]⁻¹     S = sym G     w = skew G
//!             R = (I − ½w)⁻¹(I + ½w)          A = R½ Q_n    R½ of w/(1 + √(1 + |w|²/4))
//! StepStart   G = (F − F_n) F_n⁻¹             (S, R) by the decomposition           A = Q_n
//! both        s = s_n + C : AᵀSA              Q = R Q_n     τ = Q s Qᵀ              P = τ F⁻ᵀ
//! ```
//!
//! Components along axes that turn do not change as they turn, which is the source's way to say that τ has Zaremba's and Jaumann's
//! rate; it covers orthotropy too. Written for rates the equation is that of McMeeking and Rice \[mcmeeking1975\].
//! [`StressMeasure`] says whether the moduli give Kirchhoff's stress (`τ^∇J = C:D`) or Cauchy's less the change of volume
//! (`τ^∇J = J C:D`), the source to the letter: then the change of s is multiplied by ½(J + J_n).
//!
//! The law is hypoelastic: a closed cycle of strain leaves stress, of stretch and shear by 2, 5, 10 and 20 % parts 1.5e-6, 2.3e-5, 1.8e-4
//! and 1.4e-3 of Young's modulus; simple shear γ gives τ₁₂ = G sin γ. It is meant for strains below .2 with any rotation.
//! [`Formulation::StVenant`], `S = C:E`, is the check without history.
//!
//! # Flow
//!
//! A material with a [`Plastic`] yields by von Mises' criterion: the stress `s_n + C : AᵀSA` is led back to the surface by the radial return
//! ([`Plastic`]; equations in `plastic.rs`), in the axes that turn with the point. Increments of strain are taken as the sum of an elastic and a
//! plastic part and the moduli stay those of rest, which bounds it as the law itself: elastic strains are small in metals, and
//! [`StressMeasure::Kirchhoff`] follows logarithmic strains where axes do not turn in the material; large shears turn the axes away from
//! it. The memory of a point is its [`Flow`]. Only increments have it: St Venant's law takes no notice of it.
//!
//! # Derivatives
//!
//! [`Tangent::Continuum`] is that of the rate equation, symmetric and exact where a step begins; [`Tangent::Consistent`] differentiates the
//! update over the step, nine directions each by the chain rule.
//!
//! # What holds, and the test that says so
//!
//! | invariant | test |
//! |---|---|
//! | `F = S + R`, R a rotation; rotations have no strain up to a right angle, beyond it the decomposition is refused | `deformations_are_strain_and_rotation`, `rotations_have_no_strain`, `beyond_a_right_angle_is_refused` (tests/decomposition.rs) |
//! | a turned stretch keeps its co-rotated stress | `a_turned_stretch_keeps_its_stress` (tests/updates.rs) |
//! | simple shear gives G sin γ, second order | `simple_shear_oscillates` |
//! | orders: midpoint 2, step-start 1 | `midpoint_is_of_second_order_and_step_start_of_first` |
//! | principal axes fixed in the material: Hencky's law | `fixed_axes_give_henckys_law` |
//! | a closed cycle leaves a stress of the stated size; St Venant's none | `a_closed_cycle_leaves_a_stress` |
//! | a turned frame turns the stress, both laws | `the_observer_does_not_matter` |
//! | turned out of their sides: refused | `what_is_turned_inside_out_is_refused` |
//! | the tangent is the derivative: where a step begins, over a step, St Venant's everywhere | `tangents_are_derivatives` (tests/tangents.rs) |
//! | the compact form is the source's with four terms, all signs plus | `four_terms_make_the_compact_form` |
//! | stress is the derivative of St Venant's energy | `st_venants_stress_is_the_derivative_of_its_energy` |
//! | a step that flows ends on the surface, one that does not has the bits of elasticity | `what_flows_stands_on_the_surface` (tests/plastic.rs) |
//! | the derivative of a step that flows; both where a step begins on the surface | `tangents_are_derivatives`, `a_step_begins_on_the_plastic_side` |
//! | a bar there and back with both kinds of hardening, in closed form | `a_bar_is_pulled_and_pushed` |
//! | no step wins energy; what is dissipated never falls | `work_is_stored_or_dissipated` |
//! | no flow of moduli with preferred directions, no negative modulus | `what_is_no_plastic_material_is_refused` |
//! | orthotropic moduli turned; isotropic ones as a case of them; bad constants | `moduli_turn_with_their_axes`, `equal_constants_are_isotropic`, `constants_that_are_no_material_are_refused` (tests/moduli.rs) |

#![deny(clippy::print_stdout, clippy::print_stderr)]

mod elastic;
mod error;
mod plastic;
mod strain_rotation;
mod tangent;
mod update;
mod voigt;

pub use elastic::{Moduli, Orthotropic};
pub use error::{ElasticError, PointError};
pub use plastic::{Flow, Plastic, YieldCurve};
pub use strain_rotation::{StrainRotation, angle, cayley, decompose, half_turn};
pub use tangent::{PointTangent, Tangent};
pub use update::{Formulation, Material, PointState, StressMeasure, Trial, Update};
pub use voigt::{PAIRS, PLACES, strains, stress_tensor};

/// A tensor of second order in space.
pub type Tensor = nalgebra::Matrix3<f64>;
