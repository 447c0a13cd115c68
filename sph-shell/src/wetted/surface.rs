//! The wet surface: columns of points through the thickness, and the load that they bear.
//!
//! A column stands at a place of the middle surface with the director there, both weighted means over particles, and
//! its points at heights z along that director. The load goes back by the transpose, so that its work is that of the
//! forces on the points for any motion of the particles:
//!
//! ```text
//! x_p = Σ N_a x_a + z Σ N_a d_a      f_a += N_a Σ f_p      τ_a += N_a Σ z f_p       the part of τ across d_a is a
//! couple
//! ```
//!
//! While a step of the fluid lasts, a column that bears a load resists what it moves, at its middle and along its
//! director n, beyond what the fluid saw: `f = −ρ₀c₀A [(v − v_seen)·n] n`, A its area on the faces that bear the
//! load.

use explicit_dynamics::{BoundaryLayout, BoundaryLoad, BoundaryState, Face, ThinLayout};
use sph_core::Cloud;

use crate::error::ShellError;
use crate::packs::Row;
use crate::wetted::places::Places;
use crate::wetted::sheet::over_sheet;
use crate::wetted::strip::along_strip;
use crate::wetted::wetting::Wetting;

/// The wet surface of a shell.
#[derive(Clone, Debug)]
pub(crate) struct Surface {
    /// Columns, then places of free edges.
    middle: Places,
    /// Face and height of each row of points \[L\]; point number `row · columns + column`.
    heights: Vec<(Face, f64)>,
    pub layout: BoundaryLayout,
    /// Width of the strip in a plane problem \[L\].
    width: Option<f64>,
    /// Area of each column \[L²\].
    areas: Vec<f64>,
    /// By column: ρ₀c₀A of the faces that bear a load \[F T/L\], and the velocity with which the fluid saw its middle
    /// \[L/T\]; empty where nothing resists.
    resisting: Vec<(f64, [f64; 3])>,
    /// Load on each particle \[F, F L\].
    loads: Vec<Row>,
}

impl Surface {
    /// Lays out the points.
    ///
    /// # Errors
    /// [`ShellError`] for a wetting that makes no sense on this shell.
    pub fn new(cloud: &Cloud, thickness: f64, wetting: &Wetting) -> Result<Self, ShellError> {
        wetting.check(cloud.len())?;
        let (middle, areas, width) = if wetting.plane {
            let strip = along_strip(cloud, wetting)?;
            (strip.middle, strip.areas, Some(strip.width))
        } else {
            let (middle, areas) = over_sheet(cloud, wetting);
            (middle, areas, None)
        };
        let heights = wetting.heights(thickness);
        let columns = areas.len();
        let thin = ThinLayout {
            thickness,
            faces: heights.iter().flat_map(|&(face, _)| std::iter::repeat_n(face, columns)).collect(),
            edges: (0..middle.len()).map(|place| place >= columns).collect(),
        };
        let layout = BoundaryLayout {
            points: heights.len() * columns,
            areas: heights.iter().flat_map(|_| areas.iter().copied()).collect(),
            thin: Some(thin),
        };
        Ok(Self {
            middle,
            heights,
            layout,
            width,
            areas: areas.iter().map(|area| area * width.unwrap_or(1.0)).collect(),
            resisting: Vec::new(),
            loads: vec![[0.0; 6]; cloud.len()],
        })
    }

    /// Where points, middle and normals are.
    pub fn places(&self, state: &[Row], out: &mut BoundaryState) {
        let columns = self.areas.len();
        out.points.resize(self.layout.points, [0.0; 3]);
        out.middle.resize(self.middle.len(), [0.0; 3]);
        out.normals.resize(self.middle.len(), [0.0; 3]);
        for place in 0..self.middle.len() {
            let row = self.flat(self.middle.mean(place, state));
            let [x, d] = halves(&row);
            out.middle[place] = x;
            let length = (d[0] * d[0] + d[1] * d[1] + d[2] * d[2]).sqrt();
            out.normals[place] = d.map(|component| component / length);
            if place < columns {
                for (number, &(_, z)) in self.heights.iter().enumerate() {
                    out.points[number * columns + place] = std::array::from_fn(|k| x[k] + z * d[k]);
                }
            }
        }
    }

    /// Velocities of the points.
    pub fn velocities(&self, rates: &[Row], out: &mut Vec<[f64; 3]>) {
        let columns = self.areas.len();
        out.resize(self.layout.points, [0.0; 3]);
        for column in 0..columns {
            let [v, w] = halves(&self.flat(self.middle.mean(column, rates)));
            for (number, &(_, z)) in self.heights.iter().enumerate() {
                out[number * columns + column] = std::array::from_fn(|k| v[k] + z * w[k]);
            }
        }
    }

    /// Takes up a load.
    pub fn take(&mut self, load: &BoundaryLoad<'_>) {
        let Self { middle, heights, areas, resisting, loads, .. } = self;
        let columns = areas.len();
        loads.fill([0.0; 6]);
        resisting.clear();
        for column in 0..columns {
            let mut force = [0.0; 6];
            let mut seen = [0.0; 3];
            let (mut bears, mut rows) = ([false; 2], [0.0; 2]);
            for (number, &(face, z)) in heights.iter().enumerate() {
                let mut f = load.forces[number * columns + column];
                if let Some(width) = self.width {
                    f = [width * f[0], width * f[1], 0.0];
                }
                for k in 0..3 {
                    force[k] += f[k];
                    force[3 + k] += z * f[k];
                }
                bears[face as usize] |= f != [0.0; 3];
                rows[face as usize] += 1.0;
            }
            middle.share(column, &force, loads);
            if load.impedance > 0.0 {
                let part = |face: Face| if bears[face as usize] { 1.0 / rows[face as usize] } else { 0.0 };
                let faces = f64::from(u8::from(bears[0]) + u8::from(bears[1]));
                for (number, &(face, _)) in heights.iter().enumerate() {
                    let v = load.seen[number * columns + column];
                    (0..3).for_each(|k| seen[k] += part(face) * v[k] / faces.max(1.0));
                }
                resisting.push((load.impedance * areas[column] * faces, seen));
            }
        }
    }

    /// Adds the load to the rows `[f, τ]` of the particles.
    pub fn add(&self, state: &[Row], rates: &[Row], forces: &mut [Row]) {
        for (force, load) in forces.iter_mut().zip(&self.loads) {
            (0..6).for_each(|k| force[k] += load[k]);
        }
        for (column, (resistance, seen)) in self.resisting.iter().enumerate() {
            if *resistance == 0.0 {
                continue;
            }
            let [_, d] = halves(&self.flat(self.middle.mean(column, state)));
            let [v, _] = halves(&self.flat(self.middle.mean(column, rates)));
            let square = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
            let along = (0..3).map(|k| (v[k] - seen[k]) * d[k]).sum::<f64>() / square;
            let [x, y, z] = d.map(|component| -resistance * along * component);
            self.middle.share(column, &[x, y, z, 0.0, 0.0, 0.0], forces);
        }
    }

    /// Bytes of all lists.
    pub fn bytes(&self) -> usize {
        self.middle.bytes()
            + size_of_val(&self.areas[..])
            + size_of_val(&self.resisting[..])
            + size_of_val(&self.loads[..])
    }

    /// A row of a place; in a plane problem without what leaves the plane.
    fn flat(&self, row: Row) -> Row {
        if self.width.is_some() { [row[0], row[1], 0.0, row[3], row[4], 0.0] } else { row }
    }
}

fn halves(row: &Row) -> [[f64; 3]; 2] {
    [[row[0], row[1], row[2]], [row[3], row[4], row[5]]]
}
