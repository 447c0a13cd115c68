//! Background hexahedra: where the integrals over a solid and over its faces are taken.
//!
//! Eight corners and the trilinear map `x(ξ) = Σ_c N_c(ξ) x_c`, ξ in \[−1, 1\]³, with Gauss points in the three directions.
//! Nodes and corners need not coincide.

use crate::Vec3;

/// Signs of the corners of a hexahedron: the first four run round ζ = −1, the others above them.
const CORNERS: [[f64; 3]; 8] = [
    [-1.0, -1.0, -1.0],
    [1.0, -1.0, -1.0],
    [1.0, 1.0, -1.0],
    [-1.0, 1.0, -1.0],
    [-1.0, -1.0, 1.0],
    [1.0, -1.0, 1.0],
    [1.0, 1.0, 1.0],
    [-1.0, 1.0, 1.0],
];

/// A point of a quadrature with its weight.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct VolumePoint {
    /// Place \[L\].
    pub place: Vec3,
    /// Volume that it stands for \[L³\].
    pub volume: f64,
}

/// A point of a quadrature on a face.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FacePoint {
    /// Place \[L\].
    pub place: Vec3,
    /// Tangents whose product `e₁ × e₂` is the outward normal times the area of the point \[L\].
    pub tangents: [Vec3; 2],
}

impl FacePoint {
    /// Outward normal times the area that the point stands for \[L²\].
    pub fn area(&self) -> Vec3 {
        self.tangents[0].cross(&self.tangents[1])
    }
}

/// Why there are no cells.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum HexahedraError {
    /// Not a rule of 1 to 4 points.
    #[error("{0} Gauss points along an edge; 1 to 4 are offered, 3 is usual")]
    Rule(usize),
    /// Planes that do not divide a length.
    #[error(
        "plane {number} along axis {axis} is at {value}; planes rise strictly and there are two at least"
    )]
    Planes {
        /// Axis.
        axis: usize,
        /// Number of the plane, from 0.
        number: usize,
        /// Where it is \[L\].
        value: f64,
    },
    /// A cell without volume, or turned inside out.
    #[error(
        "background cell {cell}: the volume of a Gauss point is {volume:.3e}; it must be positive: move its corners apart"
    )]
    Folded {
        /// The cell.
        cell: usize,
        /// Volume of the point \[L³\].
        volume: f64,
    },
}

/// Hexahedra over a solid.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Hexahedra {
    /// Corners \[L\].
    pub corners: Vec<Vec3>,
    /// Corners of each cell: four round its lower face, four above them.
    pub cells: Vec<[u32; 8]>,
    /// Outer faces of the box that they were made from: x0, x1, y0, y1, z0, z1; a face is four corners, its normal outward.
    pub faces: [Vec<[u32; 4]>; 6],
}

impl Hexahedra {
    /// The cells between planes across the axes, those of the last axis running fastest.
    ///
    /// # Errors
    /// [`HexahedraError::Planes`].
    pub fn between(planes: &[Vec<f64>; 3]) -> Result<Self, HexahedraError> {
        for (axis, row) in planes.iter().enumerate() {
            let rises = |i: usize| i == 0 || row[i] > row[i - 1];
            if let Some(number) = (0..row.len().max(2)).find(|&i| i >= row.len() || !rises(i)) {
                let value = row.get(number).copied().unwrap_or(f64::NAN);
                return Err(HexahedraError::Planes { axis, number, value });
            }
        }
        let [nx, ny, nz] = [0, 1, 2].map(|axis| planes[axis].len());
        let corner = |i: usize, j: usize, k: usize| ((i * ny + j) * nz + k) as u32;
        let mut out = Self::default();
        for x in &planes[0] {
            for y in &planes[1] {
                out.corners.extend(planes[2].iter().map(|z| Vec3::new(*x, *y, *z)));
            }
        }
        for i in 1..nx {
            for j in 1..ny {
                for k in 1..nz {
                    let at = |a: usize, b: usize, c: usize| corner(i - 1 + a, j - 1 + b, k - 1 + c);
                    let ring = |c| [at(0, 0, c), at(1, 0, c), at(1, 1, c), at(0, 1, c)];
                    let ([a, b, c, d], [e, f, g, h]) = (ring(0), ring(1));
                    out.cells.push([a, b, c, d, e, f, g, h]);
                    let sides =
                        [[a, e, h, d], [b, c, g, f], [a, b, f, e], [d, h, g, c], [a, d, c, b], [e, f, g, h]];
                    let outer = [i == 1, i + 1 == nx, j == 1, j + 1 == ny, k == 1, k + 1 == nz];
                    for (number, side) in sides.into_iter().enumerate().filter(|(number, _)| outer[*number]) {
                        out.faces[number].push(side);
                    }
                }
            }
        }
        Ok(out)
    }

    /// Gauss points of every cell, `rule³` each.
    ///
    /// # Errors
    /// [`HexahedraError::Rule`], [`HexahedraError::Folded`].
    pub fn volume_points(&self, rule: usize) -> Result<Vec<Vec<VolumePoint>>, HexahedraError> {
        let gauss = gauss(rule)?;
        let mut out = Vec::with_capacity(self.cells.len());
        for (cell, corners) in self.cells.iter().enumerate() {
            let mut points = Vec::with_capacity(gauss.len().pow(3));
            for &(x, wx) in gauss {
                for &(y, wy) in gauss {
                    for &(z, wz) in gauss {
                        let (place, [a, b, c]) = self.map(corners, [x, y, z]);
                        let volume = a.cross(&b).dot(&c) * wx * wy * wz;
                        if volume <= 0.0 || volume.is_nan() {
                            return Err(HexahedraError::Folded { cell, volume });
                        }
                        points.push(VolumePoint { place, volume });
                    }
                }
            }
            out.push(points);
        }
        Ok(out)
    }

    /// Gauss points of faces, `rule²` each.
    ///
    /// # Errors
    /// [`HexahedraError::Rule`].
    pub fn face_points(&self, faces: &[[u32; 4]], rule: usize) -> Result<Vec<FacePoint>, HexahedraError> {
        let gauss = gauss(rule)?;
        let mut out = Vec::with_capacity(faces.len() * gauss.len() * gauss.len());
        for face in faces {
            let x = face.map(|corner| self.corners[corner as usize]);
            for &(u, wu) in gauss {
                for &(v, wv) in gauss {
                    let place = ((x[0] * (1.0 - u) + x[1] * (1.0 + u)) * (1.0 - v)
                        + (x[3] * (1.0 - u) + x[2] * (1.0 + u)) * (1.0 + v))
                        / 4.0;
                    let first = ((x[1] - x[0]) * (1.0 - v) + (x[2] - x[3]) * (1.0 + v)) / 4.0;
                    let second = ((x[3] - x[0]) * (1.0 - u) + (x[2] - x[1]) * (1.0 + u)) / 4.0;
                    out.push(FacePoint { place, tangents: [first * wu, second * wv] });
                }
            }
        }
        Ok(out)
    }

    /// Place and derivatives of the map of a cell at ξ.
    fn map(&self, corners: &[u32; 8], xi: [f64; 3]) -> (Vec3, [Vec3; 3]) {
        let (mut place, mut slopes) = (Vec3::zeros(), [Vec3::zeros(); 3]);
        for (corner, sign) in corners.iter().zip(CORNERS) {
            let x = self.corners[*corner as usize];
            let [a, b, c] = [0, 1, 2].map(|k| 1.0 + sign[k] * xi[k]);
            place += x * (a * b * c / 8.0);
            slopes[0] += x * (sign[0] * b * c / 8.0);
            slopes[1] += x * (sign[1] * a * c / 8.0);
            slopes[2] += x * (sign[2] * a * b / 8.0);
        }
        (place, slopes)
    }
}

/// Gauss's points and weights on \[−1, 1\].
fn gauss(rule: usize) -> Result<&'static [(f64, f64)], HexahedraError> {
    const TWO: f64 = 0.577_350_269_189_625_8;
    const THREE: f64 = 0.774_596_669_241_483_4;
    const FOUR: [(f64, f64); 2] = [
        (0.861_136_311_594_052_6, 0.347_854_845_137_453_85),
        (0.339_981_043_584_856_26, 0.652_145_154_862_546_1),
    ];
    match rule {
        1 => Ok(&[(0.0, 2.0)]),
        2 => Ok(&[(-TWO, 1.0), (TWO, 1.0)]),
        3 => Ok(&[(-THREE, 5.0 / 9.0), (0.0, 8.0 / 9.0), (THREE, 5.0 / 9.0)]),
        4 => Ok(&[
            (-FOUR[0].0, FOUR[0].1),
            (-FOUR[1].0, FOUR[1].1),
            (FOUR[1].0, FOUR[1].1),
            (FOUR[0].0, FOUR[0].1),
        ]),
        _ => Err(HexahedraError::Rule(rule)),
    }
}
