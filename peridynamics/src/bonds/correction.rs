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

use super::families::{Families, Seen};
use crate::formulation::{Correction, Formulation};
use crate::material::Moduli;

/// Singular values below this part of the largest belong to families that do not span a strain.
const SPANNED: f64 = 1e-9;

/// Shares of each directed bond, worked out when they are asked for from some numbers of its nodes.
pub(crate) struct Weights<'a> {
    families: &'a Families,
    formulation: &'a Formulation,
    /// Factors of `w r V̄` in D and of `w V̄` in C, of each node.
    factors: Vec<[f64; 2]>,
    corrected: Corrected,
}

/// What corrects plain weights.
enum Corrected {
    Not,
    /// Coefficients of the even products, for C and for D, of each node of a plane.
    EvenInPlane(Vec<[SVector<f64, 3>; 2]>),
    /// The same in space.
    EvenInSpace(Vec<[SVector<f64, 6>; 2]>),
    /// Ratios of energies and of dilatations of unit strains along the axes, of each node.
    Ratios(Vec<[[f64; 3]; 2]>),
    /// All shares bond by bond.
    Listed(Shares),
}

/// Shares of all directed bonds.
pub(crate) struct Shares {
    /// D, dilatation per extension \[1/L\]; empty where the law has none.
    pub dilatation: Vec<f64>,
    /// C, so that `½ C e²` is an energy density \[F/L⁴\].
    pub deviatoric: Vec<f64>,
}

/// Those of one.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Share {
    /// D \[1/L\]; zero where the law has none.
    pub dilatation: f64,
    /// C \[F/L⁴\].
    pub deviatoric: f64,
}

/// The shares of all bonds; balanced ones before they are brought into balance (`balance`).
pub(crate) fn weights<'a>(
    families: &'a Families,
    formulation: &'a Formulation,
    moduli: &Moduli,
    thickness: f64,
) -> Weights<'a> {
    let of = Plain { families, formulation, moduli, thickness };
    let nodes = 0..families.len();
    let factors = nodes.clone().map(|node| of.factors(node)).collect();
    let mut out = Weights { families, formulation, factors, corrected: Corrected::Not };
    out.corrected = match formulation.correction {
        Correction::None => Corrected::Not,
        Correction::Even | Correction::Balanced if moduli.dimensions == 3 => {
            Corrected::EvenInSpace(nodes.map(|node| of.even(node, least_of_six)).collect())
        }
        Correction::Even | Correction::Balanced => {
            Corrected::EvenInPlane(nodes.map(|node| of.even(node, least_of_three)).collect())
        }
        Correction::EnergyFactor => Corrected::Ratios(nodes.map(|node| of.ratios(node, &out)).collect()),
    };
    out
}

impl Weights<'_> {
    /// Whether bonds have a share in a dilatation.
    pub fn has_dilatation(&self) -> bool {
        self.formulation.law.has_dilatation()
    }

    /// The shares of a bond.
    pub fn of(&self, bond: &Seen) -> Share {
        if let Corrected::Listed(all) = &self.corrected {
            let number = self.families.number(bond);
            let dilatation = all.dilatation.get(number).copied().unwrap_or_default();
            return Share { dilatation, deviatoric: all.deviatoric[number] };
        }
        self.share([bond.node, bond.other], bond.length, &self.direction(bond))
    }

    /// Those of a bond and of the same as its other end sees it.
    pub fn of_both(&self, bond: &Seen) -> [Share; 2] {
        if self.families.images.is_some() || matches!(self.corrected, Corrected::Listed(_)) {
            return [*bond, self.families.back(bond)].map(|bond| self.of(&bond));
        }
        // What follows from a direction is the same to the bit for the opposite one.
        let (Seen { node, other, length, .. }, n) = (*bond, self.direction(bond));
        [self.share([node, other], length, &n), self.share([other, node], length, &n)]
    }

    /// The direction of a bond where its shares depend on it.
    fn direction(&self, bond: &Seen) -> Vec3 {
        if matches!(self.corrected, Corrected::Not) { Vec3::zeros() } else { bond.direction() }
    }

    /// The shares that a node gives its bond of this length and direction with another or with an image.
    fn share(&self, [node, other]: [usize; 2], length: f64, n: &Vec3) -> Share {
        let ([to_d, to_c], families) = (self.factors[node], self.families);
        let weight = self.formulation.influence.weight(length, families.reach);
        let share = weight * families.volume_at(other, length);
        let mut out = Share { dilatation: 0.0, deviatoric: to_c * share };
        if self.has_dilatation() {
            out.dilatation = to_d * share * length;
        }
        match &self.corrected {
            Corrected::Not | Corrected::Listed(_) => {}
            Corrected::EvenInPlane(nodes) => out.even(&nodes[node], n),
            Corrected::EvenInSpace(nodes) => out.even(&nodes[node], n),
            Corrected::Ratios(nodes) => {
                let (here, there) = (&nodes[node], &nodes[families.source(other)]);
                out.deviatoric *= energy_factor([here[0], there[0]], n);
                if self.has_dilatation() {
                    out.dilatation *= energy_factor([here[1], there[1]], n);
                }
            }
        }
        out
    }

    /// The shares of all bonds.
    pub fn all(&self) -> Shares {
        let families = self.families;
        let bonds = || (0..families.len()).flat_map(|node| families.bonds(node));
        let dilatation = if self.has_dilatation() {
            bonds().map(|bond| self.of(&bond).dilatation).collect()
        } else {
            Vec::new()
        };
        Shares { dilatation, deviatoric: bonds().map(|bond| self.of(&bond).deviatoric).collect() }
    }

    /// Takes these shares in place of its own.
    pub fn take(&mut self, shares: Shares) {
        self.corrected = Corrected::Listed(shares);
    }
}

impl Share {
    /// Corrects both by the even products of a bond's direction.
    fn even<const T: usize>(&mut self, [of_energy, of_dilatation]: &[SVector<f64, T>; 2], n: &Vec3) {
        self.deviatoric *= of_energy.dot(&even_products::<T>(n));
        if self.dilatation != 0.0 {
            self.dilatation *= of_dilatation.dot(&products::<T>(n));
        }
    }
}

/// One factor a bond, `[Σ_a (n_a/ḡ_a)²]^{−½}`, ḡ the mean of both ends' ratios of the energy of a unit strain along
/// axis a in a whole solid to that of the node (\[madenci2014\]); the dilatation has ratios of its own.
fn energy_factor([here, there]: [[f64; 3]; 2], n: &Vec3) -> f64 {
    let term = |a: usize| (n[a] / (0.5 * (here[a] + there[a]))).powi(2);
    let sum: f64 = (0..3).map(term).filter(|term| term.is_finite()).sum();
    1.0 / sum.sqrt()
}

/// What nodes make of their families.
struct Plain<'a> {
    families: &'a Families,
    formulation: &'a Formulation,
    moduli: &'a Moduli,
    /// Extent across a plane \[L\]; one in space.
    thickness: f64,
}

impl Plain<'_> {
    fn influence(&self, bond: &Seen) -> f64 {
        self.formulation.influence.weight(bond.length, self.families.reach)
    }

    /// `m = Σ w r² V̄`; of pairwise bonds that of a whole family, `∫ w r² dV`.
    fn weighted_volume(&self, node: usize) -> f64 {
        if !self.formulation.law.has_dilatation() {
            let f = self.families;
            return self.thickness
                * self.formulation.influence.second_moment(self.moduli.dimensions, f.horizon, f.reach);
        }
        let moment = |bond: Seen| self.influence(&bond) * bond.length.powi(2) * self.families.volume(&bond);
        self.families.bonds(node).map(moment).sum()
    }

    /// Factors of `w r V̄` in D and of `w V̄` in C.
    fn factors(&self, node: usize) -> [f64; 2] {
        let (d, m) = (self.moduli.dimensions as f64, self.weighted_volume(node));
        [d / m, d * (d + 2.0) * self.moduli.mu / m]
    }

    /// The correction by the unit strains, six in space and three in a plane: as many products of a direction.
    fn even<const T: usize>(&self, node: usize, solve: Solve<T>) -> [SVector<f64, T>; 2] {
        let (d, state_based) = (self.moduli.dimensions, self.formulation.law.has_dilatation());
        let unit = 1.0 / (d * (d + 2)) as f64;
        let mut moments = SMatrix::<f64, T, T>::zeros();
        let mut squares = moments;
        for bond in self.families.bonds(node) {
            let share = self.influence(&bond) * bond.length.powi(2) * self.families.volume(&bond);
            let n = bond.direction();
            let phi = even_products::<T>(&n);
            moments += phi * (phi * share).transpose();
            if state_based {
                let products = products::<T>(&n);
                squares += products * (products * share).transpose();
            }
        }
        let m = self.weighted_volume(node);
        let energies = SVector::from_fn(|p, _| m * unit * if p < d { 3.0 } else { 1.0 });
        let traces = SVector::from_fn(|p, _| if p < d { m / d as f64 } else { 0.0 });
        let of_dilatation = if state_based { solve(squares, &traces) } else { SVector::zeros() };
        [solve(moments, &energies), of_dilatation]
    }

    /// Ratios for [`energy_factor`], of energies and of dilatations; infinite along an axis that a plane has not, which so adds nothing.
    fn ratios(&self, node: usize, plain: &Weights<'_>) -> [[f64; 3]; 2] {
        let mut out = [[f64::INFINITY; 3]; 2];
        for a in 0..self.moduli.dimensions {
            let (mut energy, mut dilatation) = (0.0, 0.0);
            for bond in self.families.bonds(node) {
                let e = bond.length * bond.direction()[a].powi(2);
                let share = plain.of(&bond);
                energy += share.deviatoric * e * e;
                dilatation += share.dilatation * e;
            }
            out[0][a] = 3.0 * self.moduli.mu / energy;
            out[1][a] = 1.0 / dilatation;
        }
        out
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
