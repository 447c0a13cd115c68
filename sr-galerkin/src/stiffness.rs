//! The stiffness of a background cell, `K_iIkL = Σ_g V_g ∂_Jφ_I A_iJkL ∂_Lφ_K`.
//!
//! Nine rows of the result stay in registers while all points pass, by slices that see less than the whole cell. The sums go over the
//! points in their order, so that the widest vectors give the same bits as the narrowest.

use pulp::{Simd, WithSimd};
use solid_kinematics::PointTangent;

use crate::discretisation::{Cell, MOST_POINTS};

/// Entries of a row of moduli, three times nine, up to a multiple of the lanes.
const ROW: usize = 28;

/// Writes the matrix of a cell: for each node I nine rows `3i + k` over the nodes K ≥ I, as wide as the cell.
pub(crate) fn cell_stiffness(cell: &Cell, slice: usize, scratch: &mut Scratch) {
    let Scratch { moduli, arranged, matrix } = scratch;
    pulp::Arch::new().dispatch(Work { cell, moduli, slice, arranged, out: matrix });
}

struct Work<'a> {
    cell: &'a Cell,
    moduli: &'a [PointTangent],
    slice: usize,
    arranged: &'a mut [[[f64; ROW]; 3]],
    out: &'a mut [f64],
}

impl WithSimd for Work<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        let Self { cell, moduli, slice, arranged, out } = self;
        for (p, arranged) in arranged.iter_mut().enumerate() {
            arrange(&moduli[p], cell.volumes[p], arranged);
        }
        let lanes = size_of::<S::f64s>() / size_of::<f64>();
        let (gradients, _) = S::as_simd_f64s(&cell.gradients);
        let (out, _) = S::as_mut_simd_f64s(out);
        let width = cell.width / lanes;
        let mut left = [[0.0; ROW]; MOST_POINTS];
        for node in 0..cell.nodes.len() {
            let sees = |&(first, end): &(u32, u32)| (first as usize..end as usize).contains(&node);
            let first = cell.slices.iter().position(sees).unwrap_or(0);
            let count = cell.slices[first..].iter().take_while(|range| sees(range)).count();
            for p in first * slice..(first + count) * slice {
                let g = [0, 1, 2].map(|j| cell.gradient(p, j)[node]);
                contract(simd, g, &arranged[p], &mut left[p]);
            }
            let rows = &mut out[9 * node * width..][..9 * width];
            for at in node / lanes..width {
                let mut sums = [simd.splat_f64s(0.0); 9];
                for number in first..first + count {
                    let (low, high) = cell.slices[number];
                    if (low as usize..high as usize).contains(&(at * lanes)) {
                        let seen = &gradients[3 * number * slice * width..][..3 * slice * width];
                        multiply(simd, &left[number * slice..][..slice], (seen, width, at), &mut sums);
                    }
                }
                for (component, sum) in sums.iter().enumerate() {
                    rows[component * width + at] = *sum;
                }
            }
        }
    }
}

/// Moduli times volume as rows j over `9l + 3i + k`.
#[inline(always)]
fn arrange(moduli: &PointTangent, volume: f64, out: &mut [[f64; ROW]; 3]) {
    for j in 0..3 {
        for l in 0..3 {
            for i in 0..3 {
                for k in 0..3 {
                    out[j][9 * l + 3 * i + k] = volume * moduli[3 * i + j][3 * k + l];
                }
            }
        }
    }
}

/// `out = Σ_j g_j rows_j`.
#[inline(always)]
fn contract<S: Simd>(simd: S, g: [f64; 3], rows: &[[f64; ROW]; 3], out: &mut [f64; ROW]) {
    let [a, b, c] = g.map(|g| simd.splat_f64s(g));
    let [(p, _), (q, _), (r, _)] = [0, 1, 2].map(|j| S::as_simd_f64s(&rows[j]));
    let (out, _) = S::as_mut_simd_f64s(out);
    for (((out, p), q), r) in out.iter_mut().zip(p).zip(q).zip(r) {
        let two = simd.add_f64s(simd.mul_f64s(a, *p), simd.mul_f64s(b, *q));
        *out = simd.add_f64s(two, simd.mul_f64s(c, *r));
    }
}

/// Adds the products of one node with as many others as there are lanes, over the points of a slice.
#[inline(always)]
fn multiply<S: Simd>(
    simd: S,
    left: &[[f64; ROW]],
    (gradients, width, at): (&[S::f64s], usize, usize),
    sums: &mut [S::f64s; 9],
) {
    for (left, gradients) in left.iter().zip(gradients.chunks_exact(3 * width)) {
        for l in 0..3 {
            let g = gradients[l * width + at];
            for component in 0..9 {
                let product = simd.mul_f64s(simd.splat_f64s(left[9 * l + component]), g);
                sums[component] = simd.add_f64s(sums[component], product);
            }
        }
    }
}

/// Space for the matrix of one cell.
pub(crate) struct Scratch {
    /// Moduli of its points.
    pub moduli: Vec<PointTangent>,
    /// The same times volumes, arranged for the sums.
    arranged: Vec<[[f64; ROW]; 3]>,
    /// Its matrix.
    pub matrix: Vec<f64>,
}

impl Scratch {
    /// Space for a cell of so many points and a matrix of so many numbers.
    pub fn new(points: usize, size: usize) -> Self {
        let (moduli, arranged) = (vec![[[0.0; 9]; 9]; points], vec![[[0.0; ROW]; 3]; points]);
        Self { moduli, arranged, matrix: vec![0.0; size] }
    }
}
