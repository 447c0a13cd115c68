//! All ties of a shell: how they are found, where they put their particles, and what goes back to the hosts.

use sph_core::Cloud;

use crate::Shell;
use crate::conditions::loads::Body;
use crate::conditions::spread::check_cells;
use crate::conditions::supports::Constraint;
use crate::error::ShellError;
use crate::formulation::{Formulation, Reach};
use crate::junction::group::Junctions;
use crate::packs::Row;
use crate::ties::hanging::Hanging;
use crate::ties::host::{Place, hang, nearest};
use crate::ties::lines::lines;

/// Distance from an edge to its host, in units of the size of the cell, that chords of a curved surface explain: a cell that turns by
/// 45° has a sagitta of a tenth.
const SAGITTA: f64 = 0.1;

/// Particles of one edge that may hang on one cell: beyond, the sheet is held to the shape of a single cell.
const MOST_ON_A_CELL: usize = 8;

/// Part of a corner below which a particle does not hang on it.
const NO_PART: f64 = 1e-6;

/// An edge and the cells that it is tied to.
#[derive(Clone, Debug)]
pub struct Tie {
    /// Particles of the edge; those that belong to the host already are left out.
    pub edge: Vec<u32>,
    /// Cells of the host.
    pub host: Vec<u32>,
}

/// The particles that hang, none before those that hang on it.
#[derive(Clone, Debug, Default)]
pub(crate) struct Ties {
    pub hanging: Vec<Hanging>,
    /// Place in `hanging` of each particle, one up; zero for others. Empty without ties.
    number: Vec<u32>,
    /// What moves with each particle: masses \[M\], rotary inertias of marching \[M L²\], and what modes have beyond the particle's
    /// own \[M L²\]. Empty without ties.
    pub masses: Vec<f64>,
    pub inertias: Vec<f64>,
    pub turning: Vec<f64>,
    /// The masses without those of what hangs \[M\].
    pub weighing: Vec<f64>,
    /// Internal forces and loads on what hangs, before they went to the hosts.
    pub internal: Vec<Row>,
    pub external: Vec<Row>,
}

impl Ties {
    pub fn is_empty(&self) -> bool {
        self.hanging.is_empty()
    }

    /// What a particle hangs by, if it does.
    pub fn of(&self, particle: usize) -> Option<&Hanging> {
        let number = *self.number.get(particle)? as usize;
        number.checked_sub(1).map(|i| &self.hanging[i])
    }

    fn new(shell: &Shell, ties: &[Tie]) -> Result<Self, ShellError> {
        let cloud = &shell.reference.cloud;
        let mates =
            |a: u32| cloud.joined.iter().find(|group| group.contains(&a)).map_or(&[][..], |group| group);
        let mut number = vec![0_u32; cloud.len()];
        let mut found = Vec::new();
        for (tie, Tie { edge, host }) in ties.iter().enumerate() {
            check_cells("a tie", host, cloud)?;
            let mut of_host = vec![false; cloud.len()];
            host.iter()
                .flat_map(|&c| cloud.cells[c as usize].particles())
                .for_each(|&b| of_host[b as usize] = true);
            let belongs = |a: u32| of_host[a as usize] || mates(a).iter().any(|&b| of_host[b as usize]);
            let lines = lines(cloud, edge);
            let mut on_cell = vec![0.0; cloud.cells.len()];
            let mut any = false;
            for &a in edge {
                let count = cloud.len();
                if a as usize >= count {
                    return Err(ShellError::NoSuchParticle { what: "a tie", particle: a, count });
                }
                if belongs(a) {
                    continue;
                }
                any = true;
                if number[a as usize] > 0 {
                    continue; // it hangs on the host of an earlier tie
                }
                let places = places(shell, tie, host, a)?;
                for place in &places {
                    let on = &mut on_cell[place.cell as usize];
                    // The next cell along the line bears the other half.
                    *on += if place.at_a_corner() { 0.5 } else { 1.0 };
                    if *on > MOST_ON_A_CELL as f64 {
                        return Err(ShellError::TieTooCoarse {
                            tie,
                            cell: place.cell,
                            bound: MOST_ON_A_CELL,
                        });
                    }
                }
                // Those of a junction hang together.
                let alone = [a];
                let together = if mates(a).is_empty() { &alone[..] } else { mates(a) };
                for hanging in hang(&shell.reference, &places, together, &lines[a as usize]) {
                    let b = hanging.particle;
                    found.push(hanging);
                    number[b as usize] = found.len() as u32;
                }
            }
            if !any {
                return Err(ShellError::TieWithoutEdge { tie });
            }
        }
        let hanging = ordered(found, cloud)?;
        (1..).zip(&hanging).for_each(|(i, own)| number[own.particle as usize] = i);
        let rows = vec![[0.0; 6]; hanging.len()];
        let none = Vec::new;
        let mut ties = Self {
            internal: rows.clone(),
            external: rows,
            hanging,
            number,
            masses: none(),
            inertias: none(),
            turning: none(),
            weighing: none(),
        };
        ties.weigh(shell);
        Ok(ties)
    }

    /// Lumps what hangs at the corners it hangs on.
    fn weigh(&mut self, shell: &Shell) {
        let reference = &shell.reference;
        let section = shell.thickness().powi(2) / 12.0;
        let own = |a: usize| reference.rotary.get(a).copied().unwrap_or(reference.masses[a] * section);
        self.masses.clone_from(&reference.masses);
        self.inertias.clone_from(&reference.inertias);
        self.turning = vec![0.0; reference.masses.len()];
        let rest = reference.rest();
        for hanging in &self.hanging {
            let t = hanging.particle as usize;
            let lever = reference.cloud.positions[t] - hanging.foot(&rest);
            let arm = self.masses[t] * lever.norm_squared();
            let of = [self.masses[t], self.inertias[t] + arm, own(t) + self.turning[t] + arm];
            for (&b, share) in hanging.corners.iter().zip(&hanging.shares) {
                let lists = [&mut self.masses, &mut self.inertias, &mut self.turning];
                lists.into_iter().zip(of).for_each(|(list, of)| list[b as usize] += share.x[0] * of);
            }
        }
        self.weighing.clone_from(&self.masses);
        self.hanging.iter().for_each(|hanging| self.weighing[hanging.particle as usize] = 0.0);
    }

    /// Takes numbers of what hangs to the corners it hangs on, in shares of the place.
    pub fn hang(&self, numbers: &mut [f64]) {
        for hanging in &self.hanging {
            let own = numbers[hanging.particle as usize];
            for (&b, share) in hanging.corners.iter().zip(&hanging.shares) {
                numbers[b as usize] += share.x[0] * own;
            }
        }
    }

    /// Puts what hangs where its hosts are.
    pub fn put(&self, state: &mut [Row]) {
        for hanging in self.hanging.iter().rev() {
            state[hanging.particle as usize] = hanging.row(&hanging.vectors(state));
        }
    }

    /// Takes rows `[f, n]` of what hangs to the corners it hangs on, and keeps them.
    pub fn condense(&self, state: &[Row], rows: &mut [Row], mut keep: impl FnMut(usize, Row)) {
        for (i, hanging) in self.hanging.iter().enumerate() {
            let row = std::mem::take(&mut rows[hanging.particle as usize]);
            keep(i, row);
            if row != [0.0; 6] {
                hanging.spread(&hanging.transpose(&hanging.vectors(state), &row), rows);
            }
        }
    }

    /// Gives what hangs the rates of its hosts.
    pub fn follow(&self, state: &[Row], rates: &mut [Row]) {
        for hanging in self.hanging.iter().rev() {
            rates[hanging.particle as usize] = hanging.rate(&hanging.vectors(state), rates);
        }
    }
}

/// Where a particle stands over the host, no farther away than the sheets are thick or the host is bent.
fn places(shell: &Shell, tie: usize, host: &[u32], particle: u32) -> Result<Vec<Place>, ShellError> {
    let reference = &shell.reference;
    let cells = &reference.cloud.cells;
    let own = cells.iter().position(|cell| cell.particles().contains(&particle));
    let thickness = |cell: usize| shell.section_at(cell).thickness;
    let places = nearest(reference, host, particle as usize);
    let distance = places.iter().map(|place| place.distance).fold(f64::INFINITY, f64::min);
    let allowed = |place: &Place| {
        let size = cells[place.cell as usize].geometry(&reference.cloud.positions).area.sqrt();
        let touching = 0.5 * (thickness(place.cell as usize) + own.map_or(0.0, thickness));
        touching.max(SAGITTA * size)
    };
    let bound = places.iter().map(allowed).fold(0.0, f64::max);
    if distance <= bound { Ok(places) } else { Err(ShellError::TieTooFar { tie, particle, distance, bound }) }
}

/// The same particles, none before those that hang on it.
fn ordered(mut found: Vec<Hanging>, cloud: &Cloud) -> Result<Vec<Hanging>, ShellError> {
    let mut burdens = vec![0_usize; cloud.len()];
    let corners = |hanging: &Hanging| hanging.corners.clone();
    found.iter().flat_map(corners).for_each(|b| burdens[b as usize] += 1);
    let mut ordered = Vec::with_capacity(found.len());
    while !found.is_empty() {
        let (free, rest): (Vec<_>, Vec<_>) =
            found.into_iter().partition(|hanging| burdens[hanging.particle as usize] == 0);
        if free.is_empty() {
            return Err(ShellError::TieInACircle { particle: rest[0].particle });
        }
        free.iter().flat_map(corners).for_each(|b| burdens[b as usize] -= 1);
        ordered.extend(free);
        found = rest;
    }
    Ok(ordered)
}

impl Shell {
    /// Ties edges to cells of other sheets, whose particles may stand elsewhere.
    ///
    /// What hangs has no unknowns of its own; supports on it must be those of its host. Before masses are lumped;
    /// not together with a fluid, which would not see what hangs move.
    ///
    /// # Errors
    /// [`ShellError`] for an edge too far from its host or on too few of its cells, one without particles of its own, supports that
    /// the host does not have, ties in a circle, and strains that are not sampled in cells.
    pub fn tie(&mut self, ties: &[Tie]) -> Result<(), ShellError> {
        if ties.is_empty() {
            return Ok(());
        }
        if !matches!(self.formulation, Formulation::StressPoint(Reach::Cell)) {
            return Err(ShellError::TieOfWideStencils);
        }
        self.ties = Ties::new(self, ties)?;
        for i in 0..self.ties.hanging.len() {
            let particle = self.ties.hanging[i].particle;
            self.check_supports(&self.ties.hanging[i])?;
            let x = self.reference.cloud.positions[particle as usize];
            let rest = (x, self.reference.cloud.frames[particle as usize].n);
            self.constraints.push(Constraint::still(rest));
            self.constraint_of[particle as usize] = self.constraints.len() as u32;
        }
        self.weigh_ties()
    }

    /// Finds masses anew after those of particles changed.
    pub(crate) fn weigh_ties(&mut self) -> Result<(), ShellError> {
        let mut ties = std::mem::take(&mut self.ties);
        if !ties.is_empty() {
            ties.weigh(self);
        }
        self.ties = ties;
        self.junctions =
            Junctions::new(&self.reference, self.moving_masses(), |a| self.ties.of(a).is_none())?;
        Ok(())
    }

    /// Masses and rotary inertias of marching that move with each particle \[M, M L²\]: with what hangs on it by ties, whose own stand
    /// still.
    pub fn moving_masses(&self) -> [&[f64]; 2] {
        if self.ties.is_empty() {
            [&self.reference.masses, &self.reference.inertias]
        } else {
            [&self.ties.masses, &self.ties.inertias]
        }
    }

    /// Masses on which gravity acts: those of [`Shell::moving_masses`] without what hangs \[M\].
    pub(crate) fn weighing_masses(&self) -> &[f64] {
        if self.ties.is_empty() { &self.reference.masses } else { &self.ties.weighing }
    }

    /// What loads see of it.
    pub(crate) fn as_loaded(&self) -> Body<'_> {
        Body { reference: &self.reference, state: &self.state, masses: self.weighing_masses() }
    }

    /// Refuses supports of what hangs that its corners do not have: it goes where they go.
    fn check_supports(&self, hanging: &Hanging) -> Result<(), ShellError> {
        let particle = hanging.particle;
        let Some(asked) = self.constraint(particle as usize) else { return Ok(()) };
        let parts = hanging.corners.iter().zip(&hanging.shares);
        let mut bearing = parts.filter(|(_, share)| share.x[0].abs() > NO_PART).map(|(&b, _)| b);
        let borne = bearing.all(|b| self.constraint(b as usize).is_some_and(|held| held.implies(asked)));
        if borne || !asked.holds() { Ok(()) } else { Err(ShellError::TieHeld { particle }) }
    }
}
