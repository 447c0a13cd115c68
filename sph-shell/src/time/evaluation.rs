//! What evaluations of a shell leave: forces of its points, energies, work; and the plan of a step in one sweep.

use explicit_dynamics::Work;

use crate::gather::Places;
use crate::packs::Row;
use crate::points::scheme::{Points, Scheme};
use crate::reference::Reference;
use crate::time::fused::Fused;

/// The last evaluation, and how the next is divided.
pub(crate) struct Evaluation {
    /// The plan of a step in one sweep; cells only.
    pub plan: Option<Fused>,
    /// Internal forces of the sampling points, one row a (point, particle) pair.
    pub slots: Vec<Row>,
    /// Energy of each pack, filled on request.
    pub pack_energies: Vec<f64>,
    /// Internal energy found by the last evaluation that was asked for it \[F L\].
    pub internal_energy: f64,
    /// Work of each chunk of particles in the last kick.
    pub chunk_work: Vec<Work>,
    pub threads: usize,
}

impl Evaluation {
    /// Nothing evaluated yet.
    pub fn new(points: &Points, reference: &Reference, threads: usize) -> Self {
        let (count, threads) = (reference.cloud.len(), threads.max(1));
        let plan = match points.scheme {
            Scheme::Cells { .. } => {
                let places = Places::new(&points.packs, &reference.operator);
                Some(Fused::plan(&points.packs, &places, [0..count, 0..count], threads))
            }
            Scheme::Wide { .. } | Scheme::StrongForm { .. } => None,
        };
        Self {
            slots: points.slots(),
            pack_energies: vec![0.0; if plan.is_some() { 0 } else { points.packs.points.len() }],
            internal_energy: 0.0,
            chunk_work: vec![Work::default(); count.div_ceil(parallel::CHUNK)],
            plan,
            threads,
        }
    }

    /// `[∂U/∂x, ∂U/∂d]` of a particle for the last forces evaluated \[F, F L\].
    pub fn internal_force(&self, points: &Points, particle: usize) -> Row {
        let mut sum = points.direct()[particle];
        for slot in points.lists().into_iter().flat_map(|lists| lists.of(particle)) {
            let row = &self.slots[slot as usize];
            for i in 0..6 {
                sum[i] += row[i];
            }
        }
        sum
    }

    /// Bytes of all lists.
    pub fn bytes(&self) -> usize {
        self.plan.as_ref().map_or(0, Fused::bytes)
            + size_of_val(&self.slots[..])
            + size_of_val(&self.pack_energies[..])
    }
}
