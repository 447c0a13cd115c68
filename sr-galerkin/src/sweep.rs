//! From parameters to the stresses of all points, and to the forces of these stresses.

use rayon::prelude::*;
use solid_kinematics::{Material, PointError, PointState, Tensor, Trial};
use sph_core::Vec3;

use crate::body::Galerkin;
use crate::discretisation::{Cell, LANES, MOST_POINTS};
use crate::heat::warm_volumes;
use crate::images::Images;
use crate::volumes::{Shared, Sharing, mean_pressure, share, shared_piola};

impl Galerkin {
    /// Internal less external forces on images, at the state and the level last evaluated \[F\].
    pub(crate) fn forces_on_images(&self, level: f64) -> Vec<Vec3> {
        let (stride, images) = (self.space.force_stride(), &self.space.images);
        let mut out = vec![Vec3::zeros(); images.places.len()];
        let place = |number: u32| number as usize - self.space.nodes.len();
        for (cell, forces) in self.space.cells.iter().zip(self.cell_forces.chunks(stride)) {
            for (at, &number) in cell.nodes.iter().enumerate().filter(|(_, number)| images.is_image(**number))
            {
                out[place(number)] += Vec3::from_fn(|k, _| forces[k * cell.width + at]);
            }
        }
        self.loads.visit(level, (images, &self.parameters), |number, force| {
            if images.is_image(number) {
                out[place(number)] -= force;
            }
        });
        out
    }

    /// All points from the history to the present parameters, and the forces of their stresses.
    pub(crate) fn sweep(&mut self) {
        let stride = self.space.force_stride();
        let (points, material) = (self.space.points, &self.material);
        let (history, cells) = (&self.history, &self.space.cells);
        let parameters = (&self.space.images, self.parameters.as_slice());
        let sharing = self.sharing;
        let heat = self.heat.as_ref().map(|heat| heat.stretch.as_slice());
        let work = |number: usize, shared: &mut [Shared], (trials, forces): (&mut [Trial], &mut [f64])| {
            let from = &history[number * points..][..points];
            let of_cell = (&cells[number], heat.map(|heat| &heat[number * points..][..points]));
            sweep_cell(of_cell, (material, sharing), parameters, from, (shared, trials), forces).err()
        };
        if self.threads > 1 {
            let both = self.trials.par_chunks_mut(points).zip(self.cell_forces.par_chunks_mut(stride));
            let shared = self.shared.par_chunks_mut(points);
            let all = both.zip(shared).zip(self.troubles.par_iter_mut()).enumerate();
            all.for_each(|(number, ((both, shared), trouble))| *trouble = work(number, shared, both));
        } else {
            let both = self.trials.chunks_mut(points).zip(self.cell_forces.chunks_mut(stride));
            let shared = self.shared.chunks_mut(points);
            let all = both.zip(shared).zip(self.troubles.iter_mut()).enumerate();
            all.for_each(|(number, ((both, shared), trouble))| *trouble = work(number, shared, both));
        }
        self.internal.fill(0.0);
        let images = &self.space.images;
        for (cell, forces) in self.space.cells.iter().zip(self.cell_forces.chunks(stride)) {
            for (at, node) in cell.nodes.iter().enumerate() {
                let force = Vec3::from_fn(|k, _| forces[k * cell.width + at]);
                images.add(&mut self.internal, *node, &force);
            }
        }
    }
}

/// Leads the points of a cell, and of one that is warm their stretches, from the history to the parameters; forces on its nodes, a row for each axis.
///
/// # Errors
/// The first point that cannot follow; forces are then no numbers.
fn sweep_cell(
    (cell, stretches): (&Cell, Option<&[f64]>),
    (material, sharing): (&Material, Option<Sharing>),
    (images, parameters): (&Images, &[f64]),
    history: &[PointState],
    (shared, trials): (&mut [Shared], &mut [Trial]),
    forces: &mut [f64],
) -> Result<(), (u32, PointError)> {
    const WIDEST: usize = 512;
    let width = cell.width;
    let mut room = [0.0; 3 * WIDEST];
    let mut large = Vec::new();
    let local: &mut [f64] = if width <= WIDEST {
        &mut room[..3 * width]
    } else {
        large.resize(3 * width, 0.0);
        &mut large
    };
    for (at, node) in cell.nodes.iter().enumerate() {
        let own = images.parameter(parameters, *node);
        (0..3).for_each(|k| local[k * width + at] = own[k]);
    }
    forces.fill(0.0);
    let mut gradients = [Tensor::zeros(); MOST_POINTS];
    let gradients = &mut gradients[..history.len()];
    for (point, gradient) in gradients.iter_mut().enumerate() {
        *gradient = Tensor::from_fn(|i, j| {
            let one = if i == j { 1.0 } else { 0.0 };
            one + dot(&local[i * width..][..width], cell.gradient(point, j))
        });
    }
    let warm = warm_volumes(cell, stretches);
    let volumes = warm.as_deref().unwrap_or(&cell.volumes);
    for (gradient, s) in gradients.iter_mut().zip(stretches.unwrap_or_default()) {
        *gradient /= *s;
    }
    let mut refuse = |trouble: (u32, PointError)| {
        forces.fill(f64::NAN);
        Err(trouble)
    };
    if let Some(sharing) = sharing
        && let Err(trouble) = share(sharing, gradients, volumes, shared)
    {
        return refuse(trouble);
    }
    for (point, from) in history.iter().enumerate() {
        match material.trial(from, &gradients[point]) {
            Ok(trial) => trials[point] = trial,
            Err(error) => return refuse((point as u32, error)),
        }
    }
    let sharing = sharing.map(|sharing| (sharing, mean_pressure(trials, volumes)));
    for (point, trial) in trials.iter().enumerate() {
        let piola = match sharing {
            None => trial.piola,
            Some((sharing, mean)) => shared_piola(sharing, trial, shared[point], mean),
        };
        let mut piola = piola * volumes[point];
        if let Some(stretches) = stretches {
            piola /= stretches[point];
        }
        let [a, b, c] = [0, 1, 2].map(|j| cell.gradient(point, j));
        for i in 0..3 {
            let [p, q, r] = [0, 1, 2].map(|j| piola[(i, j)]);
            let row = &mut forces[i * width..][..width];
            for at in 0..width {
                row[at] += p * a[at] + q * b[at] + r * c[at];
            }
        }
    }
    Ok(())
}

/// Sum of products by lanes: the same order whatever the machine's vectors.
fn dot(a: &[f64], b: &[f64]) -> f64 {
    let mut sums = [0.0; LANES];
    for (a, b) in a.chunks_exact(LANES).zip(b.chunks_exact(LANES)) {
        (0..LANES).for_each(|lane| sums[lane] += a[lane] * b[lane]);
    }
    (sums[0] + sums[1]) + (sums[2] + sums[3])
}
