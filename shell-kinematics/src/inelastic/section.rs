//! A section of plies some of which yield: equal slices, with the plastic strain of each, the thickness and the stretch as memory.

use super::layer::Layer;
use super::met::{Committing, Flowing, Held, Met};
use super::ply::{Plastic, PlasticPly, PlyMaterial};
use super::return_map::PointLaw;
use super::thickness::{self, Lever};
use crate::layered_section::{LayeredSection, Ply};
use crate::memory::Memory;
use crate::pack::{Number, Pack};
use crate::section::{MaterialError, Section, SectionScales};
use crate::strains::{Resultants, Strains};
use crate::tangent::Matrix8;

/// Numbers of a history behind those of the slices: λ₃ − 1, U⁻¹ − 1, g and 1 − χ.
pub(super) const OF_SECTION: usize = thickness::NUMBERS + 1;
/// The least share χ that a step keeps: what a control of zero-energy modes needs to leave no mode without stiffness.
const LEAST_KEPT: f64 = 0.02;

/// Plane-stress plasticity at points through the thickness, on logarithmic strains: the membrane strain of a point is the logarithmic
/// strain h of its mid-surface, its curvature the change K of curvature freed of stretch.
///
/// Transverse shear is elastic, that of a [`LayeredSection`], and no part of the yield criterion. The history has, a slice of what yields, three plastic strains and α,
/// then λ₃ − 1, U⁻¹ − 1, g and 1 − χ ([`PlasticSection::tallies`] reads it), and with them what back stresses and rates need (inelastic/layer.rs); the strain at a height is h + z (F K + g). λ₃ and U⁻¹ are those of the last
/// commit, which makes a step's resultants the derivative of its work; a commit moves them, and leaves the strain of each point what it is.
#[derive(Clone, Debug)]
pub struct PlasticSection {
    pub(super) layers: Vec<Layer>,
    /// The place of λ₃ − 1 in a history.
    pub(super) of_section: usize,
    /// Whether a ply dissipates more than `K(0) α`, whose sum is the last number of a history.
    pub(super) loses_more: bool,
    /// Transverse shear stiffness \[F/L\].
    pub(super) shear: [[f64; 2]; 2],
    pub(super) scales: SectionScales,
}

impl PlasticSection {
    /// One material through the thickness t \[L\].
    ///
    /// # Errors
    /// Those of [`PlasticSection::layered`].
    pub fn new(material: Plastic, thickness: f64, slices: usize) -> Result<Self, MaterialError> {
        let material = PlyMaterial::Plastic(material, slices);
        Self::layered(&[PlasticPly { material, thickness, angle: 0.0 }])
    }

    /// Plies from the lowest (against the normal) to the highest; their middle is the mid-surface.
    ///
    /// # Errors
    /// [`MaterialError`] for no ply at all, a thickness that is not positive, an angle that is not finite, fewer than 2 slices of a ply that yields.
    pub fn layered(plies: &[PlasticPly]) -> Result<Self, MaterialError> {
        let elastic: Vec<Ply> = plies.iter().map(PlasticPly::elastic).collect();
        let elastic = LayeredSection::new(&elastic)?;
        let scales = elastic.scales();
        let (mut bottom, mut first) = (-0.5 * scales.thickness, 0);
        let mut layers = Vec::with_capacity(plies.len());
        for ply in plies {
            let layer = ply.layer(bottom + 0.5 * ply.thickness, first)?;
            bottom += ply.thickness;
            first += layer.numbers();
            layers.push(layer);
        }
        let loses_more = layers.iter().any(|layer| layer.law.as_ref().is_some_and(PointLaw::loses_more));
        Ok(Self { layers, of_section: first, loses_more, shear: *elastic.transverse_shear(), scales })
    }

    /// Whether the yield stress of a ply grows with the rate of plastic strain.
    pub fn is_rated(&self) -> bool {
        self.laws().any(PointLaw::is_rated)
    }

    /// The laws of the plies that yield.
    fn laws(&self) -> impl Iterator<Item = &PointLaw> {
        self.layers.iter().filter_map(|layer| layer.law.as_ref())
    }

    /// The fewest slices of a ply that yields.
    pub fn fewest_slices(&self) -> usize {
        let yielding = self.layers.iter().filter(|layer| layer.law.is_some());
        yielding.map(|layer| layer.slices.len()).min().unwrap_or(0)
    }

    /// Yield stress K \[F/L²\] and its slope K' at an equivalent plastic strain, of the ply with the least.
    pub fn yield_at(&self, alpha: f64) -> [f64; 2] {
        let all = self.laws().map(|law| law.hardening().at(alpha));
        all.fold([f64::INFINITY; 2], |[stress, slope], of| [stress.min(of.stress), slope.min(of.slope)])
    }

    /// The least plastic strain beyond which a table of hardening says nothing \[–\]; none without tables.
    pub fn data_until(&self) -> Option<f64> {
        self.laws().filter_map(|law| law.hardening().until()).reduce(f64::min)
    }

    /// λ₃ and U⁻¹ of a history.
    #[inline(always)]
    pub(super) fn lever<P: Number>(&self, read: impl Fn(usize) -> P) -> Lever<P> {
        let first = self.of_section;
        Lever::read([
            read(first),
            read(first + 1),
            read(first + 2),
            read(first + 3),
            read(first + 4),
            read(first + 5),
            read(first + 6),
        ])
    }

    /// Forces of transverse shear strains.
    #[inline(always)]
    fn sheared<P: Number>(&self, [g1, g2]: &[P; 2]) -> [P; 2] {
        let [[s11, s12], [s21, s22]] = self.shear;
        if s12 == 0.0 && s21 == 0.0 {
            return [*g1 * s11, *g2 * s22];
        }
        [*g1 * s11 + *g2 * s12, *g1 * s21 + *g2 * s22]
    }

    /// Resultants of the stresses that are met at the points, moments of z σ not yet brought to the mid-surface by the lever.
    #[inline(always)]
    fn summed<P: Number>(
        &self,
        strains: &Strains<P>,
        lever: &Lever<P>,
        met: &mut impl Met<P>,
    ) -> Resultants<P> {
        let zero = [strains.shear[0].all(0.0); 3];
        let [mut membrane, mut moment] = [zero; 2];
        for layer in &self.layers {
            let across = layer.across(strains, lever);
            let [mut force, mut turn] = [zero; 2];
            for (slice, place) in layer.points() {
                let x = met.stress(layer, slice, place, &across.at(slice));
                for i in 0..3 {
                    force[i] += x[i] * slice.weight;
                    turn[i] += x[i] * (slice.weight * slice.height);
                }
            }
            let (force, turn) = (layer.modes.stresses(&force), layer.modes.stresses(&turn));
            for i in 0..3 {
                membrane[i] += force[i];
                moment[i] += turn[i];
            }
        }
        Resultants { membrane, moment, shear: self.sheared(&strains.shear) }
    }

    /// [`Memory::resultants_from`] in any registers; `read` gives the numbers of the committed history.
    #[inline(always)]
    pub fn resultants_in<P: Number>(&self, strains: &Strains<P>, read: impl Fn(usize) -> P) -> Resultants<P> {
        let lever = self.lever(&read);
        brought(self.summed(strains, &lever, &mut Flowing { read }), &lever)
    }

    /// [`Memory::energy_from`] in any registers.
    #[inline(always)]
    pub fn energy_in<P: Number>(&self, strains: &Strains<P>, read: impl Fn(usize) -> P) -> P {
        let lever = self.lever(&read);
        let ([g1, g2], [q1, q2]) = (strains.shear, self.sheared(&strains.shear));
        let mut work = (g1 * q1 + g2 * q2) * 0.5;
        if self.loses_more {
            work += read(self.of_section + OF_SECTION);
        }
        for layer in &self.layers {
            let across = layer.across(strains, &lever);
            for (slice, place) in layer.points() {
                let strain = across.at(slice);
                work += match &layer.law {
                    Some(law) => {
                        let before = layer.committed(law, &read, place);
                        let point = law.step(&strain, &before, layer.pace(law, &read, place));
                        let after = law.after(&point, &before);
                        let [stored, hardened, dissipated] = law.work(&point.stress, &after);
                        let mut all = stored + hardened + dissipated;
                        if law.loses_more() {
                            all += law.lost(point.overstress, &before, &after);
                        }
                        all * slice.weight
                    }
                    None => {
                        let [a, b, c] = strain;
                        (a * a + b * b + c * c) * (0.5 * slice.weight)
                    }
                };
            }
        }
        work
    }

    /// [`Memory::history_from`] in any registers; `write` takes every number of the new history with its place.
    ///
    /// ln λ₃ is the mean over the thickness of `−ν/E (σ11 + σ22) − (εp11 + εp22)`. χ = 1/(1 + pγ) is the share that the flow of a step leaves of a
    /// stress beside the yield surface (inelastic/return_map.rs), with the mean of p; that of the section is the mean over its points, each with the square
    /// of its height, at least 0.02.
    #[inline(always)]
    pub fn commit_in<P: Number>(
        &self,
        strains: &Strains<P>,
        duration: f64,
        read: impl Fn(usize) -> P,
        mut write: impl FnMut(usize, P),
    ) -> Resultants<P> {
        let zero = strains.shear[0].all(0.0);
        let lever = self.lever(&read);
        let mut sums = Committing {
            duration,
            read,
            write: &mut write,
            log_thickness: zero,
            eased: zero,
            whole: 0.0,
            lost: zero,
        };
        let resultants = self.summed(strains, &lever, &mut sums);
        let Committing { log_thickness, eased, whole, lost, read, .. } = sums;
        let log_thickness = log_thickness * (1.0 / self.scales.thickness);
        let first = self.of_section;
        let numbers = lever.next(log_thickness, &strains.membrane, &strains.curvature);
        for i in 0..thickness::NUMBERS {
            write(first + i, numbers[i]);
        }
        write(first + thickness::NUMBERS, (eased * (1.0 / whole)).min(zero.all(1.0 - LEAST_KEPT)));
        if self.loses_more {
            write(first + OF_SECTION, read(first + OF_SECTION) + lost);
        }
        brought(resultants, &Lever::read(numbers))
    }
}

/// Moments of z σ as moments on the curvature.
#[inline(always)]
fn brought<P: Number>(found: Resultants<P>, lever: &Lever<P>) -> Resultants<P> {
    Resultants { moment: lever.moments(&found.moment), ..found }
}

impl Memory for PlasticSection {
    fn history_len(&self) -> usize {
        self.of_section + OF_SECTION + usize::from(self.loses_more)
    }

    fn history_from(
        &self,
        strains: &Strains,
        duration: f64,
        committed: &[Pack],
        trial: &mut [Pack],
    ) -> Resultants {
        self.commit_in(strains, duration, |i| committed[i], |i, number| trial[i] = number)
    }

    fn resultants_from(&self, strains: &Strains, committed: &[Pack]) -> Resultants {
        self.resultants_in(strains, |i| committed[i])
    }

    fn held_resultants(&self, strains: &Strains, committed: &[Pack]) -> Resultants {
        let lever = self.lever(|i| committed[i]);
        brought(self.summed(strains, &lever, &mut Held(committed)), &lever)
    }

    fn tangent_from(&self, strains: &Strains, committed: &[Pack]) -> Matrix8 {
        self.tangent_in(strains, |i| committed[i])
    }

    fn energy_from(&self, strains: &Strains, committed: &[Pack]) -> Pack {
        self.energy_in(strains, |i| committed[i])
    }

    fn kept_share(&self, committed: &[Pack]) -> Pack {
        self.tallies(committed).kept_share()
    }
}

impl Section for PlasticSection {
    fn resultants(&self, strains: &Strains) -> Resultants {
        self.resultants_in(strains, |_| Pack::ZERO)
    }

    fn tangent(&self, strains: &Strains) -> Matrix8 {
        self.tangent_in(strains, |_| Pack::ZERO)
    }

    fn energy(&self, strains: &Strains) -> Pack {
        self.energy_in(strains, |_| Pack::ZERO)
    }

    fn scales(&self) -> SectionScales {
        self.scales
    }

    fn memory(&self) -> Option<&dyn Memory> {
        Some(self)
    }
}
