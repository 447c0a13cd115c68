//! Families so flat that no weights above zero make them isotropic.
//!
//! In a uniform strain a bond of stiffness c, with parts x and z of its length r, adds `c x⁴/r²` to the energy of the unit
//! extension along x and `c x²z²/r²` to that of the unit shear of x and z: `x²/z²` times as much. An isotropic solid of such
//! bonds has three times as much in all, since `Σ c n_x⁴ r²` over `Σ c n_x² n_z² r²` is 3 in a plane as in space. Where
//! `x² > 3 z²` for every bond that the shear strains, weights above zero that hold the shear give too much to the extension, and
//! weights that hold both take some below zero: bonds that push back, and a body that leaves its place at rest.

use sph_core::Vec3;

use super::families::{Families, Seen};
use crate::error::SolidError;
use crate::formulation::{Correction, Formulation};

/// Energy of extension over that of shear of an isotropic solid of bonds.
const ISOTROPIC: f64 = 3.0;
/// Parts of a bond below this part of its length are rounding: it lies along an axis.
const ALONG: f64 = 1e-9;

/// Refuses weights that are to be exact where no families allow it.
///
/// One family that does is enough to let a body pass: a hole leaves odd families on lattices that are sound.
///
/// # Errors
/// [`SolidError::Flat`].
pub(crate) fn refuse_flat(
    families: &Families,
    places: &[Vec3],
    formulation: &Formulation,
    dimensions: usize,
) -> Result<(), SolidError> {
    if !matches!(formulation.correction, Correction::Even | Correction::Balanced) {
        return Ok(());
    }
    let pairs = (0..dimensions).flat_map(|a| (0..dimensions).filter(move |&b| b != a).map(move |b| [a, b]));
    for [wide, narrow] in pairs {
        let least = |node: usize| {
            let ratio = |bond: Seen| {
                let (x, r) = (places[bond.other] - places[node], bond.length);
                let strained = x[wide].abs() > ALONG * r && x[narrow].abs() > ALONG * r;
                if strained { (x[wide] / x[narrow]).powi(2) } else { f64::INFINITY }
            };
            families.bonds(node).map(ratio).fold(f64::INFINITY, f64::min)
        };
        let mut of_all = f64::INFINITY;
        for node in 0..families.len() {
            of_all = of_all.min(least(node));
            if of_all <= ISOTROPIC {
                break;
            }
        }
        if of_all > ISOTROPIC && of_all.is_finite() {
            return Err(SolidError::Flat { wide, narrow, ratio: of_all.sqrt() });
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)] // a test may stop where it stands

    use super::*;
    use crate::bonds::correction::weights;
    use crate::bonds::families::Nodes;
    use crate::formulation::{Influence, Law, Volumes};
    use crate::material::{Elastic, Space};

    /// Two layers of six by five nodes: the least weight of a bond over the greatest, and whether they are refused.
    fn two_layers(height: f64, horizon: f64) -> (f64, bool) {
        let place = |i: usize, j: usize, k: usize| Vec3::new(i as f64, j as f64, height * k as f64);
        let positions: Vec<Vec3> =
            (0..6).flat_map(|i| (0..5).flat_map(move |j| (0..2).map(move |k| place(i, j, k)))).collect();
        let volumes = vec![height; positions.len()];
        let nodes = Nodes { positions: &positions, volumes: &volumes, spacing: 1.0, mirrors: &[] };
        let families = Families::new(&nodes, horizon, Volumes::Partial).unwrap();
        let formulation = Formulation {
            space: Space::Solid,
            law: Law::StateBased,
            horizon,
            volumes: Volumes::Partial,
            influence: Influence::Inverse,
            correction: Correction::Even,
        };
        let moduli = formulation.moduli(&Elastic { young: 1.0, poisson: 0.33, density: 1.0 }).unwrap();
        let all = weights(&families, &formulation, &moduli, 1.0).all().deviatoric;
        let least = all.iter().fold(f64::INFINITY, |a, &b| a.min(b));
        let most = all.iter().fold(0.0, |a: f64, &b| a.max(b));
        (least / most, refuse_flat(&families, &positions, &formulation, 3).is_err())
    }

    #[test]
    fn what_is_refused_has_bonds_that_push_back() {
        for (height, horizon, flat) in
            [(0.1, 1.42, true), (0.5, 1.42, true), (0.6, 1.42, false), (1.0, 1.42, false)]
        {
            let (least, refused) = two_layers(height, horizon);
            assert_eq!(refused, flat, "{height}");
            assert!(!flat || least < -0.01, "{height}: {least:.2e}");
        }
    }
}
