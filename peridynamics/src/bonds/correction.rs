//! Weights of bonds: dilatation and deviatoric shares, corrected for lattices and surfaces.
//!
//! A directed bond has `D = (d/m) w_θ r V̄` and `C = d(d+2) (μ/m) w_e V̄`, so that `θᵢ = Σⱼ D e` and
//! `Uᵢ = Vᵢ [½(λ − μ) θᵢ² + ½ Σⱼ C e²]`. Without correction both weights are the influence w.
//!
//! **Even** corrects each node: `w_e = w Σ_q c_q φ_q(n)` over the even products φ of the bond's direction n that the
//! energy of the unit strains is made of, `n_a⁴` and `n_a² n_b²`, with
//!
//! ```text
//! Σ_q [ Σⱼ w r² φ_p φ_q V̄ ] c_q = m T_p          T(n_a⁴) = 3/(d(d+2)),  T(n_a² n_b²) = 1/(d(d+2))
//! w_θ = w Σ_{a≤b} c_ab n_a n_b,    Σⱼ w_θ r² n_a n_b V̄ = δ_ab m/d
//! ```
//!
//! The energy of each of the six unit strains along the axes is then that of the solid at every node whose family spans them;
//! without the products n_a n_b families at edges would take a shear for a dilatation.

use nalgebra::{SMatrix, SVector, SymmetricEigen};
use sph_core::Vec3;

use super::families::Families;
use crate::formulation::{Correction, Formulation};
use crate::material::Moduli;

/// Singular values below this part of the largest belong to families that do not span a strain.
const SPANNED: f64 = 1e-9;

/// Shares of each directed bond.
#[derive(Clone, Debug)]
pub(crate) struct Weights {
    /// D, dilatation per extension \[1/L\]; empty where the law has none.
    pub dilatation: Vec<f64>,
    /// C, so that `½ C e²` is an energy density \[F/L⁴\].
    pub deviatoric: Vec<f64>,
}

/// The shares of all bonds; balanced ones before they are brought into balance (`balance`).
pub(crate) fn weights(
    families: &Families,
    positions: &[Vec3],
    formulation: &Formulation,
    moduli: &Moduli,
    thickness: f64,
) -> Weights {
    let positions = &*families.extended(positions);
    let plain = Plain { families, positions, formulation, moduli, thickness };
    let mut out = plain.weights();
    match formulation.correction {
        Correction::None => {}
        Correction::Even | Correction::Balanced if moduli.dimensions == 3 => {
            plain.even(&mut out, least_of_six)
        }
        Correction::Even | Correction::Balanced => plain.even(&mut out, least_of_three),
        Correction::EnergyFactor => plain.energy_factor(&mut out),
    }
    out
}

/// Bonds before their correction.
struct Plain<'a> {
    families: &'a Families,
    positions: &'a [Vec3],
    formulation: &'a Formulation,
    moduli: &'a Moduli,
    /// Extent across a plane \[L\]; one in space.
    thickness: f64,
}

impl Plain<'_> {
    fn influence(&self, bond: usize) -> f64 {
        self.formulation.influence.weight(self.families.lengths[bond], self.families.reach)
    }

    /// Direction of a bond.
    fn direction(&self, node: usize, bond: usize) -> Vec3 {
        let other = self.families.others[bond] as usize;
        (self.positions[other] - self.positions[node]) / self.families.lengths[bond]
    }

    /// `m = Σ w r² V̄`; of pairwise bonds that of a whole family, `∫ w r² dV`.
    fn weighted_volume(&self, node: usize) -> f64 {
        if !self.formulation.law.has_dilatation() {
            let f = self.families;
            return self.thickness
                * self.formulation.influence.second_moment(self.moduli.dimensions, f.horizon, f.reach);
        }
        let moment = |bond: usize| {
            self.influence(bond) * self.families.lengths[bond].powi(2) * self.families.volumes[bond]
        };
        self.families.of(node).map(moment).sum()
    }

    /// Factors of `w r V̄` in D and of `w V̄` in C.
    fn factors(&self, node: usize) -> (f64, f64) {
        let (d, m) = (self.moduli.dimensions as f64, self.weighted_volume(node));
        (d / m, d * (d + 2.0) * self.moduli.mu / m)
    }

    fn weights(&self) -> Weights {
        let f = self.families;
        let (mut dilatation, mut deviatoric) = (Vec::new(), Vec::with_capacity(f.others.len()));
        for node in 0..f.len() {
            let (to_d, to_c) = self.factors(node);
            for bond in f.of(node) {
                let share = self.influence(bond) * f.volumes[bond];
                deviatoric.push(to_c * share);
                if self.formulation.law.has_dilatation() {
                    dilatation.push(to_d * share * f.lengths[bond]);
                }
            }
        }
        Weights { dilatation, deviatoric }
    }

    /// The correction by the unit strains, six in space and three in a plane: as many products of a direction.
    fn even<const T: usize>(&self, out: &mut Weights, solve: Solve<T>) {
        let (f, d) = (self.families, self.moduli.dimensions);
        let unit = 1.0 / (d * (d + 2)) as f64;
        let mut of_bonds = Vec::new();
        for node in 0..f.len() {
            let mut moments = SMatrix::<f64, T, T>::zeros();
            let mut squares = moments;
            of_bonds.clear();
            for bond in f.of(node) {
                let share = self.influence(bond) * f.lengths[bond].powi(2) * f.volumes[bond];
                let n = self.direction(node, bond);
                let (phi, products) = (even_products::<T>(&n), products::<T>(&n));
                moments += phi * (phi * share).transpose();
                squares += products * (products * share).transpose();
                of_bonds.push([phi, products]);
            }
            let m = self.weighted_volume(node);
            let energies = SVector::from_fn(|p, _| m * unit * if p < d { 3.0 } else { 1.0 });
            let traces = SVector::from_fn(|p, _| if p < d { m / d as f64 } else { 0.0 });
            let [of_energy, of_dilatation] = [solve(moments, &energies), solve(squares, &traces)];
            for (bond, [phi, products]) in f.of(node).zip(&of_bonds) {
                out.deviatoric[bond] *= of_energy.dot(phi);
                if let Some(own) = out.dilatation.get_mut(bond) {
                    *own *= of_dilatation.dot(products);
                }
            }
        }
    }

    /// One factor a bond, `[Σ_a (n_a/ḡ_a)²]^{−½}`, ḡ the mean of both ends' ratios of the energy of a unit strain along
    /// axis a in a whole solid to that of the node (\[madenci2014\]); the dilatation has ratios of its own.
    fn energy_factor(&self, out: &mut Weights) {
        let (f, d, mu) = (self.families, self.moduli.dimensions, self.moduli.mu);
        let mut of_energy = vec![[1.0; 3]; f.len()];
        let mut of_dilatation = vec![[1.0; 3]; f.len()];
        for node in 0..f.len() {
            for a in 0..d {
                let (mut energy, mut dilatation) = (0.0, 0.0);
                for bond in f.of(node) {
                    let e = f.lengths[bond] * self.direction(node, bond)[a].powi(2);
                    energy += out.deviatoric[bond] * e * e;
                    dilatation += out.dilatation.get(bond).map_or(0.0, |own| own * e);
                }
                of_energy[node][a] = 3.0 * mu / energy;
                of_dilatation[node][a] = 1.0 / dilatation;
            }
        }
        let factor = |ratios: &[[f64; 3]], node: usize, bond: usize| {
            let (n, other) = (self.direction(node, bond), f.source(f.others[bond] as usize));
            let term = |a: usize| (n[a] / (0.5 * (ratios[node][a] + ratios[other][a]))).powi(2);
            let sum: f64 = (0..d).map(term).filter(|term| term.is_finite()).sum();
            1.0 / sum.sqrt()
        };
        for node in 0..f.len() {
            for bond in f.of(node) {
                out.deviatoric[bond] *= factor(&of_energy, node, bond);
                if let Some(own) = out.dilatation.get_mut(bond) {
                    *own *= factor(&of_dilatation, node, bond);
                }
            }
        }
    }
}

/// `n_a²`, then `n_a n_b` for a < b: in space six, in a plane three.
pub(super) fn products<const T: usize>(n: &Vec3) -> SVector<f64, T> {
    let all = if T == 3 {
        [n.x * n.x, n.y * n.y, n.x * n.y, 0.0, 0.0, 0.0]
    } else {
        [n.x * n.x, n.y * n.y, n.z * n.z, n.x * n.y, n.x * n.z, n.y * n.z]
    };
    SVector::from_fn(|p, _| all[p])
}

/// `n_a⁴`, then `n_a² n_b²` for a < b: the products of the squares.
fn even_products<const T: usize>(n: &Vec3) -> SVector<f64, T> {
    products(&n.component_mul(n))
}

/// The least solution of a symmetric system, without what its matrix does not span.
type Solve<const T: usize> = fn(SMatrix<f64, T, T>, &SVector<f64, T>) -> SVector<f64, T>;

/// [`Solve`] for so many unknowns: eigenvalues are found for sizes that are known by name.
macro_rules! least {
    ($name:ident, $size:literal) => {
        pub(super) fn $name(
            matrix: SMatrix<f64, $size, $size>,
            wanted: &SVector<f64, $size>,
        ) -> SVector<f64, $size> {
            let eigen = SymmetricEigen::new(matrix);
            let top = eigen.eigenvalues.iter().fold(0.0_f64, |top, value| top.max(value.abs()));
            let mut out = SVector::zeros();
            for (value, vector) in eigen.eigenvalues.iter().zip(eigen.eigenvectors.column_iter()) {
                if *value > SPANNED * top {
                    out += vector * (vector.dot(wanted) / value);
                }
            }
            out
        }
    };
}

least!(least_of_three, 3);
least!(least_of_six, 6);
