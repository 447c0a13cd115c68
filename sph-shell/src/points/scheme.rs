//! The sampling points of a formulation: their layout, what corrects their strains, what holds their zero-energy modes.

use shell_kinematics::{LANES, Section, SectionPack, StrainPack, StressedPack};

use crate::control::arcs::{ArcPack, ChordLoss};
use crate::control::cells::CellPack;
use crate::control::pairs::PairControl;
use crate::control::shear::ShearPack;
use crate::control::yielding::YieldingControl;
use crate::error::ShellError;
use crate::formulation::{Formulation, Reach};
use crate::gather::{Gather, Place, Places};
use crate::packs::{Constants, Packs, Row};
use crate::points::point::Point;
use crate::points::remembering::RememberingPack;
use crate::points::strong_form::StrongForm;
use crate::reference::Reference;
use crate::regions::Scales;
use crate::shared::Shared;

/// All sampling points.
#[derive(Clone, Debug)]
pub(crate) struct Points {
    pub formulation: Formulation,
    pub packs: Packs,
    /// Shear on uneven stencils; empty on lattices of developable surfaces.
    pub shear: Vec<ShearPack>,
    pub scheme: Scheme,
    pub sections: Sections,
    /// Strain measures of each pack; empty if all points have the same.
    pub strains: Vec<StrainPack>,
    pub chord_loss: ChordLoss,
}

/// Sections of each pack.
#[derive(Clone, Debug)]
pub(crate) enum Sections {
    /// None: all points have that of the shell.
    One,
    /// Those of its points.
    Own(Vec<SectionPack>),
    /// The same, under stress before they are strained.
    Stressed(Vec<StressedPack>),
    /// Those of its points with the history of each: where one has a memory, or is not linear beside others.
    Remembering(Vec<RememberingPack>),
}

impl Sections {
    /// Those of a pack, where it has its own.
    #[inline(always)]
    pub fn get(&self, pack: usize) -> Option<&dyn Section> {
        match self {
            Self::One => None,
            Self::Own(packs) => packs.get(pack).map(|own| own as _),
            Self::Stressed(packs) => packs.get(pack).map(|own| own as _),
            Self::Remembering(packs) => packs.get(pack).map(|own| &own.section as _),
        }
    }

    fn bytes(&self) -> usize {
        match self {
            Self::One => 0,
            Self::Own(packs) => size_of_val(&packs[..]),
            Self::Stressed(packs) => size_of_val(&packs[..]),
            Self::Remembering(packs) => packs.iter().map(RememberingPack::bytes).sum(),
        }
    }

    /// The control of a pack where it follows the section.
    #[inline(always)]
    pub fn yielding(&self, pack: usize) -> Option<&YieldingControl> {
        if let Self::Remembering(packs) = self { packs.get(pack).map(|own| &own.control) } else { None }
    }

    /// Those that have a history; none of sections without memory.
    pub fn histories(&self) -> &[RememberingPack] {
        if let Self::Remembering(packs) = self { packs } else { &[] }
    }

    /// Those that have a history, to be changed.
    pub fn histories_mut(&mut self) -> &mut [RememberingPack] {
        if let Self::Remembering(packs) = self { packs } else { &mut [] }
    }

    /// Takes up what the histories gave as numbers; false, and nothing changed, if there are not as many.
    pub fn take_up(&mut self, mut numbers: &[f64]) -> bool {
        if self.histories().iter().map(RememberingPack::count).sum::<usize>() != numbers.len() {
            return false;
        }
        for pack in self.histories_mut() {
            let (own, rest) = numbers.split_at(pack.count());
            pack.take_up(own);
            numbers = rest;
        }
        true
    }
}

/// What a formulation does beside the strains of its points.
#[derive(Clone, Debug)]
pub(crate) enum Scheme {
    /// Points at the cells, each with the control of its hourglass, and the forces on the particles.
    Cells {
        forces: Vec<Row>,
        control: Shared<CellPack>,
        /// Membrane strain that chords of uneven cells lose; empty on lattices of developable surfaces.
        arcs: Vec<ArcPack>,
    },
    /// Wide stencils, at cells or particles, with the control of pairs and its forces on the particles; the slots of
    /// each particle.
    Wide { control: PairControl, forces: Vec<Row>, lists: Gather },
    /// The paper's equations, and their forces on the particles.
    StrongForm { equations: StrongForm, forces: Vec<Row> },
}

impl Points {
    /// Lays out the points and takes their measures at rest as the reference.
    ///
    /// # Errors
    /// [`ShellError::Space`] for pairs whose gradients cannot be found.
    pub fn new(
        reference: &Reference,
        formulation: &Formulation,
        section: &Scales,
        density: f64,
    ) -> Result<Self, ShellError> {
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
            Formulation::StressPoint(Reach::Cell) => Scheme::Cells {
                forces: forces(),
                control: Shared::new([], CellPack::numbers),
                arcs: Vec::new(),
            },
            Formulation::StressPoint(Reach::Kernel(..)) | Formulation::Nodal { .. } => {
                let (control, places) =
                    (PairControl::new(reference, &section.uniform, 1.0)?, Places::new(&packs, operator));
                let slot = |(pack, entry, lane): Place| {
                    let first = packs.points[pack as usize].first_slot(pack as usize);
                    first + usize::from(entry) * LANES + usize::from(lane)
                };
                let lists = Gather::new(&places, 0..positions.len(), slot, packs.slot_count());
                Scheme::Wide { control, forces: forces(), lists }
            }
            Formulation::StrongForm { viscosity, divergence, .. } => {
                let (section, density) = (&section.uniform, section.uniform.thickness * density);
                let equations = StrongForm::new(reference, divergence, viscosity, section, density)?;
                Scheme::StrongForm { equations, forces: forces() }
            }
        };
        let rest = reference.rest();
        let (mut constants, mut cells) = (Vec::new(), Vec::new());
        for (index, points) in packs.order.iter().enumerate() {
            let point = Point::new(&packs, index);
            let (p, raw) = point.treated().interpolate::<true>(&rest);
            let weight = point.pack.weight;
            let mut measures = p.measures();
            if let Scheme::Cells { .. } = scheme {
                let mut cell = CellPack::new(operator, points, weight, positions, section);
                measures.curvature = cell.rest(&p, &measures.curvature, raw);
                cells.push(cell);
            }
            constants.push(Constants { weight, reference: measures });
        }
        packs.keep(constants);
        if let Scheme::Cells { control, .. } = &mut scheme {
            *control = Shared::new(cells, CellPack::numbers);
        }
        let mut chord_loss = ChordLoss::default();
        if let Scheme::Cells { arcs, .. } = &mut scheme {
            (*arcs, chord_loss) = ArcPack::all(operator, &packs, &second, &third, section);
        }
        let (formulation, sections, strains) = (*formulation, Sections::One, Vec::new());
        Ok(Self { formulation, packs, shear, scheme, sections, strains, chord_loss })
    }

    /// The points of a pack, with what corrects their strains.
    #[inline(always)]
    pub fn point(&self, index: usize) -> Point<'_> {
        let (cell, arcs) = match &self.scheme {
            Scheme::Cells { control, arcs, .. } => (Some(control.get(index)), arcs.get(index)),
            _ => (None, None),
        };
        Point {
            shear: self.shear.get(index),
            arcs,
            cell,
            section: self.sections.get(index),
            strain: self.strains.get(index).map(|own| own as _),
            ..Point::new(&self.packs, index)
        }
    }

    /// The points of packs that follow each other.
    #[inline(always)]
    pub fn several<const P: usize>(&self, first: usize) -> [Point<'_>; P] {
        let mut all = [self.point(first); P];
        for i in 1..P {
            all[i] = self.point(first + i);
        }
        all
    }

    /// Lets all histories stay as they are whatever the strains, or no longer.
    pub fn hold_histories(&mut self, held: bool) {
        if let Sections::Remembering(packs) = &mut self.sections {
            packs.iter_mut().for_each(|pack| pack.section.hold(held));
        }
    }

    /// Leaves a share of the initial stress.
    pub fn set_stress_share(&mut self, share: f64) {
        if let Sections::Stressed(packs) = &mut self.sections {
            packs.iter_mut().for_each(|pack| pack.set_share(share));
        }
    }

    /// Puts the resultants of unstrained points, and what each stores, in the place of what was there of stress.
    pub fn put_stresses(&mut self, of: impl Fn(usize) -> ([f64; 6], f64)) {
        let Sections::Stressed(packs) = &mut self.sections else { return };
        for (pack, points) in packs.iter_mut().zip(&self.packs.order) {
            let all = points.map(|point| of(point as usize));
            pack.put(all.map(|(resultants, _)| resultants), all.map(|(_, stored)| stored));
        }
    }

    /// The slots that a sweep over all of wide stencils fills, one a (point, particle) pair, and a slot of zeros behind.
    pub fn slots(&self) -> Vec<Row> {
        let count = if let Scheme::Wide { .. } = self.scheme { self.packs.slot_count() + 1 } else { 0 };
        vec![[0.0; 6]; count]
    }

    /// Internal forces that are summed particle by particle: all but those in the slots of wide stencils.
    pub fn direct(&self) -> &[Row] {
        let (Scheme::Cells { forces, .. } | Scheme::Wide { forces, .. } | Scheme::StrongForm { forces, .. }) =
            &self.scheme;
        forces
    }

    /// The same, to be found anew.
    pub fn direct_mut(&mut self) -> &mut Vec<Row> {
        let (Scheme::Cells { forces, .. } | Scheme::Wide { forces, .. } | Scheme::StrongForm { forces, .. }) =
            &mut self.scheme;
        forces
    }

    /// Where the other forces on each particle lie.
    pub fn lists(&self) -> Option<&Gather> {
        if let Scheme::Wide { lists, .. } = &self.scheme { Some(lists) } else { None }
    }

    /// Bytes of all that a step touches.
    pub fn bytes(&self) -> usize {
        let layout = self.packs.bytes()
            + size_of_val(&self.shear[..])
            + self.sections.bytes()
            + size_of_val(&self.strains[..]);
        let scheme = match &self.scheme {
            Scheme::Cells { control, arcs, .. } => control.bytes() + size_of_val(&arcs[..]),
            Scheme::Wide { control, lists, .. } => control.bytes() + lists.bytes(),
            Scheme::StrongForm { .. } => 0,
        };
        layout + scheme + size_of_val(self.direct())
    }
}
