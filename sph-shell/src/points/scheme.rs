//! The sampling points of a formulation: their layout, what corrects their strains, what holds their zero-energy modes.

use shell_kinematics::SectionPack;

use crate::control::arcs::{ArcPack, ChordLoss};
use crate::control::cells::CellPack;
use crate::control::pairs::PairControl;
use crate::control::shear::ShearPack;
use crate::error::ShellError;
use crate::formulation::{Formulation, Reach};
use crate::packs::{Packs, Row};
use crate::points::point::Point;
use crate::points::strong_form::StrongForm;
use crate::reference::Reference;
use crate::regions::Scales;

/// All sampling points.
#[derive(Clone, Debug)]
pub(crate) struct Points {
    pub packs: Packs,
    /// Shear on uneven stencils; empty on lattices of developable surfaces.
    pub shear: Vec<ShearPack>,
    pub scheme: Scheme,
    /// Sections of each pack; empty if all points have the same.
    pub sections: Vec<SectionPack>,
}

/// What a formulation does beside the strains of its points.
#[derive(Clone, Debug)]
pub(crate) enum Scheme {
    /// Points at the cells, each with the control of its hourglass.
    Cells {
        control: Vec<CellPack>,
        /// Membrane strain that chords of uneven cells lose; empty on lattices of developable surfaces.
        arcs: Vec<ArcPack>,
    },
    /// Wide stencils, at cells or particles, with the control of pairs and its forces on the particles.
    Wide { control: PairControl, forces: Vec<Row> },
    /// The paper's equations, and their forces on the particles.
    StrongForm { equations: StrongForm, forces: Vec<Row> },
}

impl Points {
    /// Lays out the points and takes their measures at rest as the reference; returns also what chords lose.
    ///
    /// # Errors
    /// [`ShellError::Space`] for pairs whose gradients cannot be found.
    pub fn new(
        reference: &Reference,
        formulation: &Formulation,
        section: &Scales,
        density: f64,
    ) -> Result<(Self, ChordLoss), ShellError> {
        let (operator, positions) = (&reference.operator, &reference.cloud.positions);
        let mut packs = Packs::new(operator);
        let second = operator.second_moments(positions);
        // Wide rows and rows at particles are uneven at every edge by design; relaxed there, they lose what holds them.
        let third = match formulation {
            Formulation::StressPoint(Reach::Cell) => operator.uneven_third_moments(positions),
            _ => Vec::new(),
        };
        let shear = ShearPack::all(operator, &packs.order, &second, &third, section);
        let forces = || vec![[0.0; 6]; positions.len()];
        let mut scheme = match *formulation {
            Formulation::StressPoint(Reach::Cell) => {
                let cell = |(points, weight)| CellPack::new(operator, points, weight, positions, section);
                let weights = packs.points.iter().map(|pack| pack.weight);
                Scheme::Cells {
                    control: packs.order.iter().zip(weights).map(cell).collect(),
                    arcs: Vec::new(),
                }
            }
            Formulation::StressPoint(Reach::Kernel(..)) | Formulation::Nodal { .. } => {
                Scheme::Wide { control: PairControl::new(reference, &section.uniform)?, forces: forces() }
            }
            Formulation::StrongForm { viscosity, .. } => {
                let equations = StrongForm::new(reference, viscosity, section.uniform.thickness * density);
                Scheme::StrongForm { equations, forces: forces() }
            }
        };
        let rest = reference.rest();
        for index in 0..packs.points.len() {
            let (p, raw) = Point::new(&packs, index).interpolate::<true>(&rest);
            let mut measures = p.measures();
            if let Scheme::Cells { control, .. } = &mut scheme {
                measures.curvature = control[index].rest(&p, &measures.curvature, raw);
            }
            packs.points[index].reference = measures;
        }
        let mut loss = ChordLoss::default();
        if let Scheme::Cells { arcs, .. } = &mut scheme {
            (*arcs, loss) = ArcPack::all(operator, &packs, &second, &third, section);
        }
        Ok((Self { packs, shear, scheme, sections: Vec::new() }, loss))
    }

    /// The points of a pack, with what corrects their strains.
    #[inline(always)]
    pub fn point(&self, index: usize) -> Point<'_> {
        let (cell, arcs) = match &self.scheme {
            Scheme::Cells { control, arcs } => (control.get(index), arcs.get(index)),
            _ => (None, None),
        };
        Point {
            shear: self.shear.get(index),
            arcs,
            cell,
            section: self.sections.get(index),
            ..Point::new(&self.packs, index)
        }
    }

    /// Number of slots that the sweep fills, one a (point, particle) pair; the strong form has none.
    pub fn slot_count(&self) -> usize {
        if let Scheme::StrongForm { .. } = self.scheme { 0 } else { self.packs.slot_count() }
    }

    /// Internal forces that are summed particle by particle; cells have none.
    pub fn direct(&self) -> &[Row] {
        match &self.scheme {
            Scheme::Cells { .. } => &[],
            Scheme::Wide { forces, .. } | Scheme::StrongForm { forces, .. } => forces,
        }
    }

    /// Bytes of all that a step touches.
    pub fn bytes(&self) -> usize {
        let Packs { points, entries, slots, offsets, .. } = &self.packs;
        let layout = size_of_val(&points[..])
            + size_of_val(&entries[..])
            + size_of_val(&slots[..])
            + size_of_val(&offsets[..])
            + size_of_val(&self.shear[..])
            + size_of_val(&self.sections[..]);
        let scheme = match &self.scheme {
            Scheme::Cells { control, arcs } => size_of_val(&control[..]) + size_of_val(&arcs[..]),
            Scheme::Wide { control, .. } => control.bytes(),
            Scheme::StrongForm { .. } => 0,
        };
        layout + scheme + size_of_val(self.direct())
    }
}
