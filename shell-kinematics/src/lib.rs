//! One point of a shell: frames, finite rotations, strains with their transposes, sections.
//!
//! This crate knows neither neighbours nor time. A point is given by five vectors, its [`Placement`]: the tangents x,₁
//! x,₂ of the mid-surface along two orthonormal directions of the *reference* surface, the director d, and its
//! derivatives d,₁ d,₂. From them follow, in this order,
//!
//! | step | type | function |
//! |---|---|---|
//! | products of the vectors | [`Measures`] | [`Placement::measures`] |
//! | strains | [`Strains`] | [`StrainMeasure::strains`] |
//! | stress resultants | [`Resultants`] | [`Section::resultants`] |
//! | back to the products | [`MeasureForces`] | [`StrainMeasure::transpose`] |
//! | back to the vectors | [`PlacementForces`] | [`Placement::transpose`] |
//!
//! Every step stands beside its transpose, so that forces are the exact derivative of the energy. Four points are
//! treated at a time in a [`Pack`]; formulas read as if it were one number, and those that a march needs run on any
//! [`Number`]. No fused multiply-add is asked for: the same bits on every processor.
//!
//! ```
//! use shell_kinematics::{
//!     Isotropic, IsotropicSection, Pack3, Placement, Section, StrainMeasure, StretchCorrected,
//! };
//! let flat = Placement {
//!     x1: Pack3::splat([1.0, 0.0, 0.0]),
//!     x2: Pack3::splat([0.0, 1.0, 0.0]),
//!     d: Pack3::splat([0.0, 0.0, 1.0]),
//!     ..Placement::default()
//! };
//! let stretched = Placement { x1: Pack3::splat([1.1, 0.0, 0.0]), ..flat };
//! let (now, before) = (stretched.measures(), flat.measures());
//!
//! let strains = StretchCorrected.strains(&now, &before);
//! assert!((strains.membrane[0].lanes()[0] - 0.5 * (1.1 * 1.1 - 1.0)).abs() < 1e-15);
//!
//! // N11 = Et/(1−ν²) e11, and n¹ = N11 x,1 on the way back.
//! let section = IsotropicSection::new(Isotropic::new(200.0, 0.0)?, 0.5)?;
//! let stress = section.resultants(&strains);
//! let forces = stretched.transpose(&StretchCorrected.transpose(&now, &before, &stress));
//! assert!((stress.membrane[0].lanes()[0] - 100.0 * 0.105).abs() < 1e-12);
//! assert!((forces.n1.lane(0)[0] - 100.0 * 0.105 * 1.1).abs() < 1e-12);
//! # Ok::<(), shell_kinematics::MaterialError>(())
//! ```
//!
//! # From the body to eight strains
//!
//! The shell of \[lin2013\] is the body `x + ζ d`, `−t/2 ≤ ζ ≤ t/2`, with a straight director of constant length (eqs.
//! 5–6; the geometrically exact shell of \[simo1989\]). Its natural basis 𝔽 has the columns `x,₁ + ζd,₁`, `x,₂ + ζd,₂`,
//! `d` (eq. 7), its Green–Lagrange tensor the covariant components `½(a_i·a_j − A_i·A_j)`. The solver uses what is left of that to
//! first order in ζ, `𝔼 = E_m + ζE_f` and the shear, on the products
//!
//! ```text
//! membrane    ½ x,₁·x,₁     ½ x,₂·x,₂     x,₁·x,₂
//! curvature   k11 = x,₁·d,₁   k22 = x,₂·d,₂   k12 = x,₁·d,₂ + x,₂·d,₁
//! shear       x,₁·d     x,₂·d
//! ```
//!
//! [`Measures`]. Membrane strains e₁₁, e₂₂, g = 2e₁₂ and shears γ₁, γ₂ are their changes from the reference. For the
//! curvature there are three choices, [`strain_measures`]:
//!
//! ```text
//! GreenLagrange       κ_αβ = k_αβ − k_αβ⁰                                          the paper's split, §3 of it
//! StretchCorrected    κ11  = k11 − k11⁰ − (e11 k11 + ¼ g k12)          κ22 likewise
//!                     2κ12 = k12 − k12⁰ − ½[(e11 + e22) k12 + g (k11 + k22)]
//! Logarithmic         h = ½ ln C in place of e,   K = sym(U⁻¹k) − k⁰,   Γ = U⁻¹γ        C = 1 + 2e = U²
//! ```
//!
//! k without a zero is the current total, k12 the sum of both mixed products, as is 2κ12 ([`Strains::curvature`]).
//! [`GreenLagrange`] mixes stretch into curvature: a strip of thickness t rolled to the curvature k carries
//! `EIk(1 − (kt)²/6)` and shrinks to `λ² = 1 − (kt)²/6`, which moves the tip of the closed ring of t/L = 0.1 by 7.34 %
//! of L whatever the particles do. [`StretchCorrected`] divides `x,α·d,β` by the stretch, to first order: the exact
//! circle under an end couple is an exact solution. It assumes small membrane strain. [`Logarithmic`] divides by the stretch whatever its size;
//! the closed forms and their transposes are in its file.
//!
//! # Sections
//!
//! A [`Section`] gives resultants as the derivative of an energy per reference area ψ, `N = ∂ψ/∂e`, `M = ∂ψ/∂κ`,
//! `Q = ∂ψ/∂γ`, its tangent `C = ∂σ/∂ε`, and the scales by which control and stable step are sized ([`SectionScales`]).
//!
//! ```text
//! IsotropicSection    N = t C e    M = t³/12 C κ    Q = (5/6) G t γ      C = E/(1−ν²) [[1,ν,0],[ν,1,0],[0,0,(1−ν)/2]]
//! IntegratedSection   N = Σ w C (e + ζκ)    M = Σ w ζ C (e + ζκ)          Gauss points ζ with weights w
//! LayeredSection      N = A e + B κ    M = B e + D κ    A, B, D = Σ_k ∫ Q̄_k (1, ζ, ζ²) dζ    Q = k Σ_k t_k Ḡ_k γ
//! ```
//!
//! A [`GivenSection`] has A, B, D and a stiffness S of transverse shear as they are given: of sandwich, corrugated and stiffened sheets.
//! Here ζ runs through the thickness, 5/6 is Reissner's factor of the homogeneous section. Plies are orthotropic in
//! plane stress ([`Orthotropic`]: `Q11 = E_L/(1−ν²E_T/E_L)`, `Q22 = Q11 E_T/E_L`, `Q12 = ν Q22`, `Q66 = G_LT`, ν =
//! ν_LT) and rotated by the invariants of \[tsai1968\]. Bending in the scales of a laminate is `D − BA⁻¹B`, the
//! stiffness where the membrane follows free of force, as a mean over directions; the membrane scale is that of the
//! stiffest ply in its stiffest direction, so that no wave is faster.
//!
//! Four sections lie side by side in a [`SectionPack`], each at its height; under resultants `N₀, M₀` where nothing is strained in a
//! [`StressedPack`], which heat makes as well ([`Expansion`]). Four strain measures do in a [`StrainPack`].
//!
//! What the plies of a [`LayeredSection`] bear follows from its strains, and from its resultants where it is heated ([`Through`],
//! [`LayeredSection::ply_stress`]); how near that is to failure, from a [`Strength`] and a [`Criterion`] ([`Margin`]).
//!
//! A section whose resultants depend on what its points went through has a [`Memory`], and its points a [`HistoryPack`] each four. Of
//! sections that are not linear, or have a memory, four lie side by side in a [`MixedSection`].
//!
//! # Sections that yield, and rubber
//!
//! A [`PlasticSection`] has plane-stress plasticity at n equal slices of each ply, `z_i = (t/2)(2i − 1 − n)/√(n² − 1)` with weights t/n: elastic
//! bending is exact, six leave 1.4 % of the plastic moment (root mean square), ten 0.5 %, forty 0.02 %. Its strains are logarithmic: h of the mid-surface,
//! and the change K of curvature freed of stretch. With λ₃ = present thickness over thickness at rest and U⁻¹ = exp(−h) of the last commit,
//!
//! ```text
//! ε(z) = h + z (F K + g)    F K = λ₃ sym(U⁻¹K)    N = Σ w σ    M = Fᵀ Σ w z σ    Q = (5/6) Σ G t γ
//! λ₃ = exp mean( −ν/E (σ11 + σ22) − (εp11 + εp22) )
//! ```
//!
//! σ is Kirchhoff stress. A point flows where `√(ξᵀPξ) > √⅔ K(α)`, P von Mises' matrix or Hill's ([`RValues`]), ξ the stress less a back stress that grows
//! linearly, K one of four curves ([`Hardening`]). Step and tangent are those of \[simo1998\], §3.4, in coordinates `σ = V x`, `VᵀC⁻¹V = 1`,
//! `VᵀPV = diag p`, in which a step of backward Euler is one equation for γ:
//!
//! ```text
//! ξ_i = ξ_i⁰/(1 + (p_i + ⅔H_k) γ)     α' = α + √⅔ γ f     f = √(Σ p_i ξ_i²) = √⅔ K(α')
//! ```
//!
//! Newton's method on `√⅔ K/f − 1` takes one step and three more, always: no lane branches, and packs, plain loops and AVX2 give the same bits. The work
//! `Σ w (½|x|² + ½β:εp + ∫K dα)` is a potential of the step; `Σ w K(0) α` of it is dissipated, the rest stored. A commit moves F and leaves the strains of
//! all points what they are. What a history says is in [`Tallies`].
//!
//! A [`BackStress`] recovers as it grows, by Armstrong and Frederick's law; several of them are Chaboche's. The unknown of a step is then Δα, its tangent the symmetric half.
//!
//! With a [`Rate`] the yield stress of a step that takes the time Δt is `(1 + s) K`, s the overstress at the rate Δα/Δt, by Cowper and Symonds or Johnson and Cook. The
//! equation is solved for s, in six more steps: a step of backward Euler, for any Δt. At rest Δt is infinite and s zero. The work against s is
//! dissipated.
//!
//! ```
//! use std::sync::Arc;
//!
//! use shell_kinematics::{
//!     Hardening, HistoryPack, Isotropic, Pack, Plastic, PlasticSection, Section, Strains,
//! };
//! let steel = Plastic::new(Isotropic::new(200e3, 0.3)?, Hardening::linear(250.0, 1000.0)?);
//! let mut sheet = HistoryPack::new(Arc::new(PlasticSection::new(steel, 0.8, 6)?));
//! let sheared = Strains { membrane: [Pack::ZERO, Pack::ZERO, Pack::splat(0.02)], ..Strains::default() };
//! let force = sheet.resultants(&sheared).membrane[2].lanes()[0];
//! sheet.commit(&sheared);
//! // Shear of σ/√3 where the strain is α√3 and the elastic one; what is not elastic stays.
//! let alpha = (0.02 - force / 0.8 * 2.6 / 200e3) / 3.0_f64.sqrt();
//! assert!((force / 0.8 * 3.0_f64.sqrt() - (250.0 + 1000.0 * alpha)).abs() < 1e-9);
//! # Ok::<(), shell_kinematics::MaterialError>(())
//! ```
//!
//! A [`RubberSection`] is incompressible at each of three Gauss points: `C(z) = C + 2zλ₃κ`, λ₃ = 1/√det C, and `ψ = Σ w W(tr C, det C)` with C33 = 1/det C
//! ([`Rubber`]: neo-Hooke, Mooney–Rivlin, Ogden). It takes [`GreenLagrange`] strains: C and the change of curvature are linear in them, so that the
//! potential needs neither a logarithm nor what U does to the curvature. Sheared transversely it is linear.
//!
//! # Back: placement forces
//!
//! With s the forces on the products (membrane, curvature b, shear q),
//!
//! ```text
//! n¹ = s11 x,₁ + s12 x,₂ + q1 d + b11 d,₁ + b12 d,₂        m¹ = b11 x,₁ + b12 x,₂
//! n² = s22 x,₂ + s12 x,₁ + q2 d + b22 d,₂ + b12 d,₁        m² = b22 x,₂ + b12 x,₁        q = q1 x,₁ + q2 x,₂
//! ```
//!
//! [`Placement::transpose`]: n^α, m^α and q do work on the rates of x,α, d,α and d, and are the resultants of the first
//! Piola–Kirchhoff stress. Second derivatives, which Newton's method needs, are in [`Placement::tangent`] and
//! [`StrainMeasure::second_gradient`]:
//!
//! ```text
//! ∂²ψ/∂v² = Aᵀ (Jᵀ C J + Σ σ ∂²ε/∂m²) A + Σ s ∂²m/∂v²      A = ∂m/∂v,  J = ∂ε/∂m,  s = Jᵀσ
//! ```
//!
//! v the five vectors, m the eight measures, ε and σ the eight strains and resultants.
//!
//! # Finite rotations
//!
//! The march needs [`parallel_transport`] alone: a director without drilling moves along the great circle of its rate and
//! carries the rate with it, `d ← d cos θ + ḋ Δt sin θ/θ`, `ḋ ← ḋ cos θ − d |ḋ| sin θ`, `θ = |ḋ|Δt`. The tests hold it against
//! eqs. 10 and 11 of \[lin2013\], after \[simo1989\] (the paper prints θ × θ where the dyadic product is meant): with Ξ the matrix
//! of θ×,
//!
//! ```text
//! R(θ) = I + sinθ/θ Ξ + (1−cosθ)/θ² Ξ²                     eq. 11
//! 𝕎(θ) = sinθ/θ I + (1−cosθ)/θ² Ξ + (θ−sinθ)/θ³ θ⊗θ        eq. 10;  ω = 𝕎(θ) θ̇
//! ```
//!
//! # What holds, and the test that says so
//!
//! | invariant | test |
//! |---|---|
//! | `transpose` is the transpose of the derivative of `strains` | `transposes_are_those_of_the_strains` (tests/point.rs) |
//! | tangents are the derivatives of the forces | `tangents_are_the_derivatives_of_the_forces` |
//! | rigid rotations leave no strain | `rotations_do_not_strain` |
//! | resultants are the derivative of the energy | `resultants_are_the_derivative_of_the_energy` |
//! | the split is the paper's tensor to first order in ζ | `the_split_is_the_papers_tensor_to_first_order_in_the_thickness` |
//! | logarithmic strains are those of the eigenvectors; their transposes and gradients | tests/log_strain.rs |
//! | a circle is free of membrane force, for the corrected curvature only | `a_circle_is_free_of_membrane_force_for_the_corrected_curvature_only` |
//! | R is the exponential, 𝕎 gives the angular velocity | `rodrigues_is_the_exponential`, `tangent_map_gives_the_angular_velocity` |
//! | transport is the paper's update, the rate is carried | `parallel_transport_is_the_papers_update` |
//! | isotropic, integrated and layered sections of one material agree | `sections_of_one_isotropic_material_agree`, `isotropic_plies_are_the_isotropic_section` (tests/layered.rs) |
//! | laminates: positive definite, rotated plies have a rotated stiffness, no wave faster than the scale | `stiffness_is_positive_definite`, `rotated_plies_have_a_rotated_stiffness`, `no_wave_is_faster_than_the_membrane_scale` |
//! | sections side by side are those alone, at any height | `sections_side_by_side_are_those_alone` (tests/layered.rs) |
//! | initial resultants add to those of the section, with their work | `resultants_under_stress_are_the_derivative_of_the_energy` (tests/packs.rs) |
//! | a history is left alone by evaluations and by a second commit; resultants are the derivative of the work | sph-shell/tests/in_time/history.rs |
//! | three steps leave random points on the yield surface, of von Mises and of Hill | `three_steps_reach_the_yield_surface` (tests/plastic/points.rs), `three_steps_reach_the_surface_of_sheets` (sheets.rs) |
//! | a history taken up goes on to the same bits | `a_history_taken_up_goes_on_to_the_same_bits` (tests/plastic/paths.rs) |
//! | packs, plain loops and the widest registers give the same bits | `registers_change_no_bit` (tests/plastic/points.rs) |
//! | a bar follows its curve and thins, a tube under pressure too | `a_bar_follows_its_curve_and_thins`, `a_tube_under_pressure_follows_its_curve` |
//! | turned frames, mirrors and other units change nothing | `a_turned_frame_turns_the_forces`, `other_units_and_a_mirror_change_nothing` (tests/plastic/points.rs), `plies_of_sheets_are_a_laminate` (sheets.rs) |
//! | bars of a rolled sheet have its r-values | `bars_have_the_r_values` (tests/plastic/sheets.rs) |
//! | moments and springback of a bent strip; cycles close | tests/plastic/bending.rs, `a_cycle_of_kinematic_hardening_closes` (paths.rs) |
//! | forces and tangents of sections that yield are derivatives at a fixed history | tests/plastic/derivatives.rs |
//! | bars with back stresses that recover follow their exponentials, close their loops and ratchet | tests/plastic/recovery.rs |
//! | steps in time meet the overstress of their rate; long ones those of slow flow, short ones elasticity | tests/plastic/rates.rs |
//! | dissipation never falls; work is stored or dissipated | `dissipation_never_falls`, `the_work_is_stored_or_dissipated` (tests/plastic/paths.rs) |
//! | the lever arm and the curvature are those of the present thickness and stretch | `a_stretched_sheet_bends_about_its_present_thickness` |
//! | rubber follows its closed forms, Rivlin's flexure too | tests/rubber.rs |
//! | measures side by side are those alone | `measures_side_by_side_are_those_alone` (tests/packs.rs) |
//! | sections that yield, of rubber and elastic ones side by side are those alone; a raised one is a ply | tests/mixed.rs |
//! | strengths are met, reserve factors bring the index to one, a published example and off-axis strengths | tests/strength.rs |
//! | stresses of plies add up to the resultants, heated ones too; turned and mirrored plies bear the same | tests/ply_stress.rs |
//! | two plies by hand, the released bending stiffness | `two_plies_by_hand`, `scales_of_a_coupled_stack_are_released` |

#![deny(clippy::print_stdout, clippy::print_stderr)]

mod bar;
mod expansion;
mod given_section;
mod history_pack;
mod inelastic;
mod integrated_section;
mod jet;
mod layered_section;
mod line_bend;
mod log_strain;
mod memory;
mod mixed_section;
mod pack;
mod placement;
mod ply_stress;
mod rotation;
mod section;
mod section_pack;
mod slope;
mod stiffness;
mod strain;
mod strain_measures;
mod strain_pack;
mod strains;
mod strength;
mod stressed_pack;
mod tangent;
mod transverse_shear;

pub use bar::{Bar, BarForces, BarPlacement, BarSection, BarStrains, BarTangent};
pub use expansion::{Blocked, Expansion};
pub use given_section::GivenSection;
pub use history_pack::{Commit, Flowed, HistoryPack, YieldingPack};
pub use inelastic::{
    BackStress, Hardening, MOST_BACK_STRESSES, Plastic, PlasticPly, PlasticSection, PlyMaterial, RValues,
    Rate, Rubber, RubberSection, Tallies,
};
pub use integrated_section::IntegratedSection;
pub use layered_section::{LayeredSection, Orthotropic, Ply};
pub use line_bend::{LineBend, LinePlacement};
pub use log_strain::Logarithmic;
pub use memory::Memory;
pub use mixed_section::MixedSection;
pub use pack::{Arithmetic, LANES, Number, Pack, Pack3};
pub use placement::{MeasureForces, Measures, Placement, PlacementForces};
pub use ply_stress::{Through, laminate_of};
pub use rotation::parallel_transport;
pub use section::{
    Isotropic, IsotropicSection, MaterialError, Section, SectionOf, SectionScales, linear_tangent,
};
pub use section_pack::SectionPack;
pub use stiffness::Stiffness;
pub use strain::{GreenLagrange, StrainMeasure, StrainsOf, StretchCorrected};
pub use strain_measures::{strain_measure, strain_measures};
pub use strain_pack::StrainPack;
pub use strains::{Resultants, Strains};
pub use strength::{Criterion, FibreStrength, Margin, Strength};
pub use stressed_pack::StressedPack;
pub use tangent::{Matrix8, Matrix15, ZERO8, congruence};
