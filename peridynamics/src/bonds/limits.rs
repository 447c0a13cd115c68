//! Limits of bonds: the stretch, or the work done on them, that spends the energy G₀ on a unit area of crack.
//!
//! All bonds across a straight crack, stretched by s while the rest of the body is at rest, hold per unit area
//!
//! ```text
//! G(s) = s² [ ½ Σ_ξ |ξ·n| ½ c r²/V  +  Δz Σ_rows (λ − μ) Θ(z)² ]        Θ(z) = Σ_{ξ·n > z} D r
//! ```
//!
//! c the stiffness of a bond; ξ runs over a family, rows over those of one side, z their distance from the crack; the
//! dilatation of a row comes from the bonds that cross. In a continuum with `w = 1/r` and λ = μ this is `3μδ s²` in space
//! and `(6/π) μδ s²` in a plane, the stretches of PMB (\[silling2005\]). The sums here go over the lattice itself, with its
//! corrected weights, for a crack between two rows, so that such a crack takes G₀.
//!
//! Of the work each bond may take its share `½ c r²` of the first sum, so that the shares of all bonds across a unit area
//! are G₀; where λ = μ that is its stretch. One work for all bonds, `4G₀/(πδ⁴)` per both volumes (\[foster2011\]), sums
//! to G₀ as well, but stretches the shortest bonds √(δ/r) times as far as the longest: they alone hold the tip, until the
//! others, of which each rests on them, are far beyond their share. A double cantilever then grows at 1.7 G₀, and spends
//! 1.3 G₀ on its bonds.

use sph_core::Vec3;

use super::correction::weights;
use super::families::{Families, Nodes, Seen};
use crate::error::SolidError;
use crate::formulation::{Correction, Formulation};
use crate::fracture::Criterion;
use crate::material::Moduli;

/// What breaks a bond.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Limit {
    /// Stretches beyond these \[–\]; −∞ where none breaks under compression.
    Stretch { tension: f64, compression: f64 },
    /// Work in tension beyond this, over `½ c r²` of the bond \[–\]: the square of a stretch.
    Work(f64),
}

/// The lattice that a limit is worked out for.
pub(crate) struct Lattice<'a> {
    pub formulation: &'a Formulation,
    pub moduli: &'a Moduli,
    /// Spacing of nodes along each axis \[L\]; in a plane the last is the thickness.
    pub spacing: [f64; 3],
}

impl Lattice<'_> {
    /// The limit that a criterion asks for.
    ///
    /// # Errors
    /// [`SolidError::Limit`] for values out of bounds.
    pub fn limit(&self, criterion: &Criterion) -> Result<Limit, SolidError> {
        let positive = |energy: f64| {
            let bound = "it must be positive and finite";
            let refused = SolidError::Limit { what: "the fracture energy", value: energy, bound };
            if energy > 0.0 && energy.is_finite() { Ok(energy) } else { Err(refused) }
        };
        match *criterion {
            Criterion::Stretch { tension, compression } => stretches(tension, compression),
            Criterion::EnergyByStretch(energy) => {
                let tension = (positive(energy)? / self.sums()?.energy).sqrt();
                Ok(Limit::Stretch { tension, compression: f64::NEG_INFINITY })
            }
            Criterion::EnergyByWork(energy) => Ok(Limit::Work(positive(energy)? / self.sums()?.bonds)),
        }
    }

    /// Sums over the bonds across a crack, the mean of cracks normal to each axis.
    fn sums(&self) -> Result<Sums, SolidError> {
        let d = self.moduli.dimensions;
        let spacing = self.spacing;
        let greatest = spacing[..d].iter().fold(0.0_f64, |most, &dx| most.max(dx));
        // The factors of energy look at the families of neighbours too: those must be whole as well.
        let depth = if self.formulation.correction == Correction::EnergyFactor { 2.0 } else { 1.0 };
        let reach = depth * (self.formulation.horizon + 0.5) * greatest;
        let half: [i32; 3] =
            std::array::from_fn(|a| if a < d { (reach / spacing[a]).ceil() as i32 } else { 0 });
        let mut positions = vec![Vec3::zeros()];
        for i in -half[0]..=half[0] {
            for j in -half[1]..=half[1] {
                for k in -half[2]..=half[2] {
                    if [i, j, k] != [0; 3] {
                        let at = |a: usize, n: i32| f64::from(n) * spacing[a];
                        positions.push(Vec3::new(at(0, i), at(1, j), at(2, k)));
                    }
                }
            }
        }
        let volume: f64 = spacing.iter().product();
        let volumes = vec![volume; positions.len()];
        let nodes = Nodes { positions: &positions, volumes: &volumes, spacing: greatest, mirrors: &[] };
        let families = Families::new(&nodes, self.formulation.horizon, self.formulation.volumes)?;
        let thickness = if d == 2 { spacing[2] } else { 1.0 };
        let weights = weights(&families, self.formulation, self.moduli, thickness);
        let mut out = Sums { energy: 0.0, bonds: 0.0 };
        for axis in 0..d {
            for bond in families.bonds(0) {
                let across = positions[bond.other][axis].abs();
                // A bond of an infinite lattice has the stiffness 2VC.
                let held = 0.5 * across * weights.of(&bond).deviatoric * bond.length.powi(2);
                out.energy += held;
                out.bonds += held;
            }
            let dz = spacing[axis];
            let rows = if weights.has_dilatation() { half[axis] } else { 0 };
            for row in 0..rows {
                let z = (f64::from(row) + 0.5) * dz;
                let crossing = |bond: &Seen| positions[bond.other][axis] > z;
                let part = |bond: Seen| weights.of(&bond).dilatation * bond.length;
                let theta: f64 = families.bonds(0).filter(crossing).map(part).sum();
                out.energy += dz * (self.moduli.lambda - self.moduli.mu) * theta * theta;
            }
        }
        let axes = d as f64;
        Ok(Sums { energy: out.energy / axes, bonds: out.bonds / axes })
    }
}

/// Sums over all bonds across a unit area of crack.
struct Sums {
    /// Energy at the stretch one \[F/L\].
    energy: f64,
    /// The part of it that the bonds hold apart from the dilatation \[F/L\].
    bonds: f64,
}

fn stretches(tension: f64, compression: Option<f64>) -> Result<Limit, SolidError> {
    if !(tension > 0.0 && tension.is_finite()) {
        let bound = "it must be positive and finite";
        return Err(SolidError::Limit { what: "the greatest stretch", value: tension, bound });
    }
    match compression {
        Some(value) if !(-1.0 < value && value < 0.0) => {
            let bound = "it must lie between -1 and 0; leave it out where no bond breaks under compression";
            Err(SolidError::Limit { what: "the least stretch", value, bound })
        }
        _ => Ok(Limit::Stretch { tension, compression: compression.unwrap_or(f64::NEG_INFINITY) }),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bonds::breaking::Breaking;
    use crate::bonds::network::Network;
    use crate::formulation::{Influence, Law, Volumes};
    use crate::fracture::Crack;
    use crate::material::{Elastic, Space};

    const SPACING: f64 = 1e-3;

    /// Energy per area of a crack along `along`, of the bonds that it cuts in a body, each at the limit that spends the
    /// energy one.
    fn spent(formulation: &Formulation, along: [f64; 2], by_work: bool) -> f64 {
        let poisson = formulation.law.poisson(formulation.space, 0.22);
        let moduli = Elastic { young: 72e9, poisson, density: 1.0 }.moduli(formulation.space).unwrap();
        let (n, layers) = (26, if moduli.dimensions == 3 { 11 } else { 1 });
        let mut positions = Vec::new();
        for i in 0..n {
            for j in 0..n {
                for k in 0..layers {
                    positions.push(Vec3::new(f64::from(i), f64::from(j), f64::from(k)) * SPACING);
                }
            }
        }
        let volumes = vec![SPACING.powi(3); positions.len()];
        let nodes = Nodes { positions: &positions, volumes: &volumes, spacing: SPACING, mirrors: &[] };
        let families = Families::new(&nodes, formulation.horizon, formulation.volumes).unwrap();
        let thickness = if moduli.dimensions == 2 { SPACING } else { 1.0 };
        let weights = weights(&families, formulation, &moduli, thickness);
        let mut network = Network::new(&families, &weights, None, &moduli);
        let whole = network.clone();
        let mut breaking = Breaking::new(&network, &families);
        let lattice = Lattice { formulation, moduli: &moduli, spacing: [SPACING; 3] };
        let criterion = if by_work { Criterion::EnergyByWork(1.0) } else { Criterion::EnergyByStretch(1.0) };
        let limit = lattice.limit(&criterion).unwrap();
        // Through the middle, between rows; of nodes near it within a window of whole periods.
        let direction = Vec3::new(along[0], along[1], 0.0).normalize();
        let normal = Vec3::new(-direction.y, direction.x, 0.0);
        let far = direction * 0.1;
        let centre = Vec3::new(12.5, 12.5, f64::from(layers / 2)) * SPACING;
        let diagonal = along[0] * along[1] != 0.0;
        let middle = centre + normal * if diagonal { SPACING * 0.125_f64.sqrt() } else { 0.0 };
        let crack = if moduli.dimensions == 3 {
            let up = Vec3::z() * 0.1;
            Crack::Polygon(vec![middle - far - up, middle + far - up, middle + far + up, middle - far + up])
        } else {
            Crack::Segment([middle - far, middle + far])
        };
        breaking.cut(&mut network, &positions, &crack.cut(0, moduli.dimensions).unwrap());
        let period = SPACING * if diagonal { 32.0_f64.sqrt() } else { 4.0 };
        let mut sum = 0.0;
        for (node, x) in positions.iter().enumerate() {
            let from = x - middle;
            let place = from.dot(&direction) + 1e-3 * SPACING;
            if !(-0.5 * period..0.5 * period).contains(&place) || from.z.abs() > 0.5 * SPACING {
                continue;
            }
            let mut theta = 0.0;
            for lane in breaking.bonds.broken(network.packs_of(node)) {
                let bond = whole.bond(node, lane);
                match limit {
                    Limit::Stretch { tension, .. } => {
                        let e = tension * bond.length;
                        sum += 0.25 * bond.stiffness * e * e;
                        theta += bond.shares[0] * e;
                    }
                    Limit::Work(share) => sum += 0.25 * share * bond.stiffness * bond.length * bond.length,
                }
            }
            sum += 0.5 * (moduli.lambda - moduli.mu) * volumes[node] * theta * theta;
        }
        sum / (period * SPACING)
    }

    /// Along a lattice and across it to rounding; along a diagonal, for which nothing was set, more by these parts. The
    /// stretch that the lattice asks for lies this close to that of a continuum with λ = μ.
    #[test]
    fn a_crack_takes_its_energy() {
        use Influence::{Inverse, Linear};
        for (space, influence, horizon) in [
            (Space::Solid, Inverse, 2.015),
            (Space::PlaneStress, Inverse, 2.015),
            (Space::PlaneStress, Inverse, 3.015),
            (Space::PlaneStress, Inverse, 4.015),
            (Space::PlaneStress, Linear, 3.015),
        ] {
            for law in [Law::BondBased, Law::StateBased] {
                let volumes = Volumes::Partial;
                let shape =
                    Formulation { space, law, horizon, volumes, influence, correction: Correction::Even };
                for by_work in [false, true] {
                    let [along, across, diagonal] =
                        [[1.0, 0.0], [0.0, 1.0], [1.0, 1.0]].map(|along| spent(&shape, along, by_work));
                    assert!((along - 1.0).abs() < 1e-9 && (across - 1.0).abs() < 1e-9);
                    // Measured: 0.2 to 1.8 % more at 3.015 and beyond, up to 4.7 % at 2.015, most by work.
                    assert!((1.0..1.06).contains(&diagonal), "{shape:?}: {diagonal}");
                }
            }
            let moduli = Elastic { young: 2.5, poisson: space.pairwise_poisson(), density: 1.0 }
                .moduli(space)
                .unwrap();
            let shape = Formulation {
                space,
                law: Law::BondBased,
                horizon,
                volumes: Volumes::Partial,
                influence,
                correction: Correction::Even,
            };
            let lattice = Lattice { formulation: &shape, moduli: &moduli, spacing: [SPACING; 3] };
            let Ok(Limit::Stretch { tension, .. }) = lattice.limit(&Criterion::EnergyByStretch(1.0)) else {
                unreachable!()
            };
            let Ok(Limit::Work(share)) = lattice.limit(&Criterion::EnergyByWork(1.0)) else { unreachable!() };
            // Pairwise bonds have no other energy than that of their stretch.
            assert!((share / (tension * tension) - 1.0).abs() < 1e-14);
            let (pi, delta) = (std::f64::consts::PI, horizon * SPACING);
            let across = if moduli.dimensions == 3 { 3.0 } else { 6.0 / pi };
            let stretch = (1.0 / (across * moduli.mu * delta)).sqrt();
            // Measured at 3.015: 0.991 in a plane, 0.994 in space; at 2.015 0.963.
            if influence == Inverse {
                assert!((0.95..1.03).contains(&(tension / stretch)), "{shape:?} {}", tension / stretch);
            }
        }
    }
}
