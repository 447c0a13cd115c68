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
//! While a step of the fluid lasts, a column that bears a load resists what it moves, at its middle and along its director
//! n of the start, beyond what the fluid saw: `f = −ρ₀c₀A [(v − v_seen)·n] n`, A its area on the faces that bear the load.

use explicit_dynamics::{BoundaryLayout, BoundaryLoad, BoundaryState, Face, ThinLayout, Wetted};
use sph_core::Vec3;

use crate::Shell;
use crate::error::ShellError;
use crate::packs::Row;
use crate::reference::Reference;
use crate::wetted::places::Places;
use crate::wetted::sheet::over_sheet;
use crate::wetted::strip::along_strip;
use crate::wetted::wetting::Wetting;

/// A column that bears a load.
#[derive(Clone, Copy, Debug)]
struct Resisting {
    column: u32,
    /// ρ₀c₀A of the faces that bear it \[F T/L\].
    resistance: f64,
    /// Which faces bear it.
    faces: [bool; 2],
    normal: [f64; 3],
    /// Velocity along the normal with which the fluid saw its middle \[L/T\].
    seen: f64,
}

/// A column of a wet shell, for whoever asks what its faces do to a fluid without marching both.
#[derive(Clone, Debug, PartialEq)]
pub struct WetColumn {
    /// Its place on the middle surface \[L\].
    pub place: Vec3,
    /// Unit director there.
    pub normal: Vec3,
    /// The area that it stands for \[L²\].
    pub area: f64,
    /// Whether the face to which the director points is wet, and the other.
    pub wet: [bool; 2],
    /// Particles of whose places its own is the mean, with their weights.
    pub weights: Vec<(u32, f64)>,
}

impl Shell {
    /// The columns of its wet surface; none of a dry shell.
    pub fn wet_columns(&self) -> Vec<WetColumn> {
        let wetted = self.loading.wetted.as_ref();
        wetted.map_or_else(Vec::new, |surface| surface.columns(&self.motion.state))
    }

    /// Width of a strip that is wet in a plane \[L\]; none in space.
    pub fn wet_width(&self) -> Option<f64> {
        self.loading.wetted.as_ref().and_then(|surface| surface.width)
    }
}

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
    /// What resists while a step of the fluid lasts.
    resisting: Vec<Resisting>,
    /// Load on each particle \[F, F L\].
    loads: Vec<Row>,
}

impl Surface {
    /// Lays out the points.
    ///
    /// # Errors
    /// [`ShellError`] for a shell about an origin, a spacing or rows out of bounds, for edges that are none, and in a plane problem for a
    /// shell that is no strip across the plane.
    pub fn new(reference: &Reference, thickness: f64, wetting: &Wetting) -> Result<Self, ShellError> {
        if reference.origin != Vec3::zeros() {
            return Err(ShellError::WetFromAfar);
        }
        let cloud = &reference.cloud;
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
            out.normals[place] = unit(d);
            if place < columns {
                for (number, &(_, z)) in self.heights.iter().enumerate() {
                    out.points[number * columns + place] = std::array::from_fn(|k| x[k] + z * d[k]);
                }
            }
        }
    }

    /// The columns as they stand.
    pub fn columns(&self, state: &[Row]) -> Vec<WetColumn> {
        let wet = [Face::Front, Face::Back].map(|face| self.heights.iter().any(|row| row.0 == face));
        let column = |number: usize| {
            let [place, d] = halves(&self.flat(self.middle.mean(number, state)));
            WetColumn {
                place: place.into(),
                normal: unit(d).into(),
                area: self.areas[number],
                wet,
                weights: self.middle.weights(number).to_vec(),
            }
        };
        (0..self.areas.len()).map(column).collect()
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

    /// Takes up a load on particles in such a state.
    pub fn take(&mut self, state: &[Row], load: &BoundaryLoad<'_>) {
        self.loads.fill([0.0; 6]);
        self.resisting.clear();
        let columns = self.areas.len();
        for column in 0..columns {
            let mut force = [0.0; 6];
            // By face: whether it bears a load, and the sum of the velocities that the fluid saw, by its rows.
            let mut faces = [(false, [0.0; 3], 0.0); 2];
            for (number, &(face, z)) in self.heights.iter().enumerate() {
                let point = number * columns + column;
                let mut f = load.forces[point];
                if let Some(width) = self.width {
                    f = [width * f[0], width * f[1], 0.0];
                }
                let (bears, seen, rows) = &mut faces[face as usize];
                *bears |= load.found[point] != [0.0; 3];
                *rows += 1.0;
                for k in 0..3 {
                    force[k] += f[k];
                    force[3 + k] += z * f[k];
                    seen[k] += load.seen[point][k];
                }
            }
            self.middle.share(column, &force, &mut self.loads);
            let bearing = faces.iter().filter(|(bears, ..)| *bears);
            let count = bearing.clone().count() as f64;
            if load.impedance == 0.0 || count == 0.0 {
                continue;
            }
            let [_, d] = halves(&self.flat(self.middle.mean(column, state)));
            let normal = unit(d);
            let along = |v: &[f64; 3]| v[0] * normal[0] + v[1] * normal[1] + v[2] * normal[2];
            let seen = bearing.map(|(_, seen, rows)| along(seen) / rows).sum::<f64>() / count;
            let resistance = load.impedance * self.areas[column] * count;
            let faces = faces.map(|(bears, ..)| bears);
            self.resisting.push(Resisting { column: column as u32, resistance, faces, normal, seen });
        }
    }

    /// Adds the load to the rows `[f, τ]` of the particles.
    pub fn add(&self, rates: &[Row], forces: &mut [Row]) {
        for (force, load) in forces.iter_mut().zip(&self.loads) {
            (0..6).for_each(|k| force[k] += load[k]);
        }
        for resisting in &self.resisting {
            let (force, n) = (self.resistance(resisting, rates), resisting.normal);
            for &(particle, weight) in self.middle.weights(resisting.column as usize) {
                let row = &mut forces[particle as usize];
                (0..3).for_each(|k| row[k] += weight * force * n[k]);
            }
        }
    }

    /// Adds what each column resists over a span to the impulses of its first points below the faces that bear a load,
    /// the same to each.
    pub fn impedance_impulses(&self, rates: &[Row], span: f64, impulses: &mut [[f64; 3]]) {
        let part = span / self.width.unwrap_or(1.0);
        let first = [Face::Front, Face::Back].map(|face| self.heights.iter().position(|row| row.0 == face));
        for resisting in &self.resisting {
            let (force, n) = (self.resistance(resisting, rates), resisting.normal);
            let bearing =
                || first.iter().zip(resisting.faces).filter_map(|(row, bears)| row.filter(|_| bears));
            let part = part / bearing().count() as f64;
            for row in bearing() {
                let impulse = &mut impulses[row * self.areas.len() + resisting.column as usize];
                (0..3).for_each(|k| impulse[k] += part * force * n[k]);
            }
        }
    }

    /// Force along its normal with which a column resists.
    fn resistance(&self, resisting: &Resisting, rates: &[Row]) -> f64 {
        let Resisting { column, resistance, normal: n, seen, .. } = resisting;
        let weights = self.middle.weights(*column as usize);
        let velocity = weights.iter().fold(0.0, |sum, &(particle, weight)| {
            let v = &rates[particle as usize];
            sum + weight * (v[0] * n[0] + v[1] * n[1] + v[2] * n[2])
        });
        -resistance * (velocity - seen)
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

fn unit(v: [f64; 3]) -> [f64; 3] {
    let length = (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]).sqrt();
    v.map(|component| component / length)
}

/// The boundary of a shell that is dry.
static DRY: BoundaryLayout = BoundaryLayout { points: 0, areas: Vec::new(), thin: None };

impl Wetted for Shell {
    fn boundary_layout(&self) -> &BoundaryLayout {
        self.loading.wetted.as_ref().map_or(&DRY, |surface| &surface.layout)
    }

    fn boundary(&self, out: &mut BoundaryState) {
        match &self.loading.wetted {
            Some(surface) => surface.places(&self.motion.state, out),
            None => *out = BoundaryState::default(),
        }
    }

    fn apply_load(&mut self, load: &BoundaryLoad<'_>) {
        if let Some(surface) = &mut self.loading.wetted {
            surface.take(&self.motion.state, load);
        }
    }

    fn impedance_impulses(&self, span: f64, impulses: &mut [[f64; 3]]) {
        if let Some(surface) = &self.loading.wetted {
            surface.impedance_impulses(&self.motion.rates, span, impulses);
        }
    }

    fn boundary_velocities(&self, out: &mut Vec<[f64; 3]>) {
        match &self.loading.wetted {
            Some(surface) => surface.velocities(&self.motion.rates, out),
            None => out.clear(),
        }
    }
}
