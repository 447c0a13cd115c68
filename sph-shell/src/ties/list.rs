//! All ties of a shell: how they are found, where they put their particles, and what goes back to the hosts.

use sph_core::Cloud;

use crate::conditions::constraints::Constraints;
use crate::conditions::spread::check_cells;
use crate::conditions::supports::Constraint;
use crate::error::ShellError;
use crate::material::Material;
use crate::packs::Row;
use crate::reference::Reference;
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

    /// Finds what hangs, and where; masses are lumped by [`Ties::weigh`].
    ///
    /// # Errors
    /// [`ShellError`] for an edge too far from its host or on too few of its cells, one without particles of its own, and ties in a circle.
    pub fn new(reference: &Reference, material: &Material, ties: &[Tie]) -> Result<Self, ShellError> {
        if ties.is_empty() {
            return Ok(Self::default());
        }
        let cloud = &reference.cloud;
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
                let places = places(reference, material, tie, host, a)?;
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
                for hanging in hang(reference, &places, together, &lines[a as usize]) {
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
        Ok(Self { internal: rows.clone(), external: rows, hanging, number, ..Self::default() })
    }

    /// Holds what hangs, and refuses supports of it that its corners do not have: it goes where they go.
    ///
    /// # Errors
    /// [`ShellError::TieHeld`] for such a support.
    pub fn hold(&self, reference: &Reference, constraints: &mut Constraints) -> Result<(), ShellError> {
        for hanging in &self.hanging {
            let particle = hanging.particle;
            if let Some(asked) = constraints.of(particle as usize).filter(|asked| asked.holds()) {
                let parts = hanging.corners.iter().zip(&hanging.shares);
                let mut bearing = parts.filter(|(_, share)| share.x[0].abs() > NO_PART).map(|(&b, _)| b);
                let held = |b: u32| constraints.of(b as usize).is_some_and(|held| held.implies(asked));
                if !bearing.all(held) {
                    return Err(ShellError::TieHeld { particle });
                }
            }
            let cloud = &reference.cloud;
            let rest = (cloud.positions[particle as usize], cloud.frames[particle as usize].n);
            constraints.hold(&[particle], Constraint::still(rest));
        }
        Ok(())
    }

    /// Lumps what hangs at the corners it hangs on, on a shell of some thickness \[L\].
    pub fn weigh(&mut self, reference: &Reference, thickness: f64) {
        if self.is_empty() {
            return;
        }
        let section = thickness.powi(2) / 12.0;
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

    /// Masses and rotary inertias of marching that move with each particle \[M, M L²\]: with what hangs on it, whose own stand still.
    pub fn moving_masses<'a>(&'a self, reference: &'a Reference) -> [&'a [f64]; 2] {
        if self.is_empty() {
            [&reference.masses, &reference.inertias]
        } else {
            [&self.masses, &self.inertias]
        }
    }

    /// Masses on which gravity acts: those of [`Ties::moving_masses`] without what hangs \[M\].
    pub fn weighing_masses<'a>(&'a self, reference: &'a Reference) -> &'a [f64] {
        if self.is_empty() { &reference.masses } else { &self.weighing }
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

    /// Takes internal forces on what hangs to its hosts.
    pub fn condense_internal(&mut self, state: &[Row], forces: &mut [Row]) {
        let mut kept = std::mem::take(&mut self.internal);
        self.condense(state, forces, |i, row| kept[i] = row);
        self.internal = kept;
    }

    /// The same of the loads.
    pub fn condense_external(&mut self, state: &[Row], forces: &mut [Row]) {
        let mut kept = std::mem::take(&mut self.external);
        self.condense(state, forces, |i, row| kept[i] = row);
        self.external = kept;
    }

    /// Rates of a particle: of one that hangs those that its hosts give it.
    pub fn rate(&self, state: &[Row], rates: &[Row], particle: usize) -> Row {
        let Some(hanging) = self.of(particle) else { return rates[particle] };
        if hanging.corners.iter().all(|&b| self.of(b as usize).is_none()) {
            return hanging.rate(&hanging.vectors(state), rates);
        }
        let mut rates = rates.to_vec();
        self.follow(state, &mut rates);
        rates[particle]
    }

    /// Gives what hangs the rates of its hosts.
    pub fn follow(&self, state: &[Row], rates: &mut [Row]) {
        for hanging in self.hanging.iter().rev() {
            rates[hanging.particle as usize] = hanging.rate(&hanging.vectors(state), rates);
        }
    }
}

/// Where a particle stands over the host, no farther away than the sheets are thick or the host is bent.
fn places(
    reference: &Reference,
    material: &Material,
    tie: usize,
    host: &[u32],
    particle: u32,
) -> Result<Vec<Place>, ShellError> {
    let cells = &reference.cloud.cells;
    let own = cells.iter().position(|cell| cell.particles().contains(&particle));
    let thickness = |cell: usize| material.at(cell).thickness;
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
