//! The sweeps of a fluid over its particles: sorted, filled, forces, rates.

use lanes::widest;
use parallel::{chunks, reduced};

use crate::boundary::points::Boundary;
use crate::cells::{Extent, Grid};
use crate::continuity::Rates;
use crate::fluid::{CELL, Fluid};
use crate::formulation::WallRule;
use crate::momentum::{ForceSum, Forces};
use crate::pair::Row;
use crate::sorted::Sorted;
use crate::transport::Transport;
use crate::walls::extrapolated::{Means, WallMean};

impl Fluid {
    /// Sorts the particles, moved on by a time, and the boundaries, so long before the end of the step \[T\].
    pub(crate) fn sort(&mut self, ahead: f64, before: f64) {
        let width = CELL * 2.0 * self.momentum.kernel.h;
        let Self {
            threads,
            dimensions,
            present,
            drags,
            grid,
            sorted,
            boundary,
            share,
            periodic,
            copies,
            openings,
            ..
        } = self;
        let (here, points) =
            openings.as_deref().map_or((&[][..], &[][..]), |own| (&own.here[..], &own.near[..]));
        let is_here = |i: usize| here.get(i).is_none_or(|here| *here);
        let count = present.positions.len();
        let place = |i: usize, slots: &[u32]| {
            present.place(i, drags, slots.get(i).map_or(0, |slot| *slot as usize), ahead)
        };
        let periods = periodic.as_ref().map(|periodic| &periodic.periods);
        if let Some(periods) = periods {
            copies.find(periods, count, width, |i| place(i, &sorted.slots));
        }
        let (copies, all) = (&*copies, copies.all(count));
        let standing = |number: usize, slots: &[u32]| copies.place(number, |i| place(i, slots));
        let present = (0..all).filter(|&number| is_here(copies.source(number)));
        let extent = Extent::of(*dimensions, present.map(|number| standing(number, &sorted.slots)));
        *grid = Grid::over(*dimensions, share.all(all), share.widened(extent), width);
        sorted.sort(*threads, grid, all, |number, before| {
            is_here(copies.source(number)).then(|| standing(number, before).into())
        });
        boundary.sort(grid, before, share.near(), periods.map(|periods| (periods, width)), points);
        self.leave_copies(count);
        self.leave_to_others();
    }

    /// Leaves copies out of the sweeps, and makes room for what these find of all that stand in cells.
    fn leave_copies(&mut self, count: usize) {
        if self.copies.is_empty() && self.openings.is_none() {
            return;
        }
        let Sorted { order, left, .. } = &mut self.sorted;
        if !self.copies.is_empty() {
            left.clear();
            left.extend(order.iter().map(|&number| number as usize >= count));
        }
        let all = order.len();
        self.accelerations.resize(all, [0.0; 3]);
        self.powers.resize(all, 0.0);
        self.rates.resize(all, [0.0; 2]);
    }

    /// Finds which slots others sweep who march the fluid too.
    fn leave_to_others(&mut self) {
        let Self { grid, sorted, boundary, share, .. } = self;
        let Some(shared) = share.shared() else { return };
        let Sorted { starts, order, left, .. } = sorted;
        left.clear();
        for cell in 0..grid.len() {
            let particles = &order[starts[cell] as usize..starts[cell + 1] as usize];
            if !particles.is_empty() {
                let adds = shared.deal.adds(grid, cell);
                left.extend(particles.iter().map(|&known| !adds && !shared.deal.moves[known as usize]));
            }
        }
        let Sorted { order, left, .. } = &mut boundary.sorted;
        left.clear();
        left.extend(order.iter().map(|&point| !shared.deal.owns[point as usize]));
    }

    /// Fills the rows of the fluid, moved on by a time, and of the boundaries, so long before the end of the step \[T\];
    /// `sorted_anew` since drags were found.
    pub(crate) fn fill(&mut self, ahead: f64, before_end: f64, sorted_anew: bool) {
        let far = self.far();
        let Self { threads, dimensions, liquid, present, drags, grid, sorted, boundary, copies, .. } = self;
        sorted.fill(*threads, *dimensions, grid, far, |number, slot, before, _| {
            let i = copies.source(number);
            let slot = if sorted_anew { before[i] as usize } else { slot };
            let (v, density) = (present.velocities[i], present.densities[i]);
            let place = copies.place(number, |i| present.place(i, drags, slot, ahead));
            Row::new(place, density, v, liquid.p_over_rho2(density))
        });
        boundary.fill(*dimensions, grid, far, before_end);
    }

    /// Moves the rows of the fluid on by a time with their velocities and drags, and fills those of the boundaries, so long before the end
    /// of the step \[T\].
    pub(crate) fn carry_on(&mut self, ahead: f64, before_end: f64) {
        let far = self.far();
        let Self { threads, dimensions, drags, grid, sorted, boundary, .. } = self;
        sorted.fill(*threads, *dimensions, grid, far, |_, slot, _, row| {
            row.gone_on(drags.get(slot).copied().unwrap_or_default(), ahead)
        });
        boundary.fill(*dimensions, grid, far, before_end);
    }

    /// Finds for the sorted particles which faces of thin structures they see.
    pub(crate) fn find_sides(&mut self) {
        let Self { threads, sorted, boundary, .. } = self;
        if boundary.thin.is_empty() {
            return;
        }
        let count = sorted.len();
        sorted.faces.resize(count, 0);
        sorted.sides.resize(count, 0);
        let rows = &sorted.rows;
        let lists = (&mut sorted.faces[..], &mut sorted.sides[..]);
        chunks(*threads, lists, |first, (faces, sides): (&mut [u32], &mut [u32])| {
            for (s, (face, side)) in faces.iter_mut().zip(sides).enumerate() {
                (*face, *side) = (0, 0);
                for thin in &boundary.thin {
                    let [sees, only] = thin.sees(rows[first + s].at());
                    *face |= sees;
                    *side |= only;
                }
            }
        });
    }

    /// Gives the boundaries their pressures; with laminar friction also the velocities that hold the fluid at their face.
    pub(crate) fn press_boundaries(&mut self) {
        match self.formulation.walls {
            WallRule::Extrapolated => self.extrapolate(),
            WallRule::Dynamic => {
                let Boundary { sorted, densities, .. } = &mut self.boundary;
                for (row, &point) in sorted.rows.iter_mut().zip(&sorted.order) {
                    let density = densities[point as usize];
                    row.press(density, self.liquid.p_over_rho2(density));
                }
            }
        }
    }

    fn extrapolate(&mut self) {
        let Self {
            threads,
            dimensions,
            liquid,
            formulation,
            gravity,
            grid,
            momentum,
            sorted,
            boundary,
            openings,
            ..
        } = self;
        let weight = liquid.density * gravity.norm();
        let boundary_rows = &boundary.sorted;
        let (kernel, gravity) = (&momentum.kernel, (*gravity).into());
        chunks(*threads, &mut boundary.means[..], |first, out: &mut [WallMean]| {
            if *dimensions == 2 {
                widest(Means::<2> { kernel, gravity, grid, of: boundary_rows, first, fluid: sorted, out });
            } else {
                widest(Means::<3> { kernel, gravity, grid, of: boundary_rows, first, fluid: sorted, out });
            }
        });
        let count = boundary.means.len();
        let lists = (&mut boundary.sorted.rows[..count], &mut boundary.means[..]);
        chunks(*threads, lists, |_, (rows, means): (&mut [Row], &mut [WallMean])| {
            for (row, mean) in rows.iter_mut().zip(means) {
                let wet = mean.weight > 0.0;
                let pressure = if wet { mean.pressure / mean.weight } else { 0.0 };
                let pressure = if formulation.confined { pressure } else { pressure.max(0.0) };
                let density = if pressure == 0.0 { liquid.density } else { liquid.density_at(pressure) };
                row.press(density, pressure / (density * density));
                if wet && formulation.kinematic_viscosity > 0.0 && !formulation.slip {
                    let mut velocity = row.velocity();
                    for (v, sum) in velocity.iter_mut().zip(mean.velocity) {
                        *v = 2.0 * *v - sum / mean.weight;
                    }
                    row.set_velocity(velocity);
                }
            }
        });
        if let Some(openings) = openings {
            openings.press(boundary, liquid, weight, formulation.confined);
        }
        boundary.press_copies();
    }

    /// Accelerations of the fluid and forces on the boundaries, from the rows as they are.
    pub(crate) fn sweep_forces(&mut self) {
        let Self {
            threads,
            dimensions,
            gravity,
            grid,
            momentum,
            sorted,
            boundary,
            accelerations,
            powers,
            force_sums,
            ..
        } = self;
        let Boundary { sorted: points, velocities, accelerations: own, powers: rubbed, .. } = boundary;
        let (fluid, points, momentum, grid) = (&*sorted, &*points, &*momentum, &*grid);
        let plane = *dimensions == 2;
        type Chunk<'a> = (&'a mut [[f64; 3]], &'a mut [f64]);
        let forces = |first, of, sets, gravity, velocities, (out, powers): Chunk<'_>| {
            if plane {
                widest(Forces::<2> { momentum, grid, of, first, sets, gravity, velocities, out, powers })
            } else {
                widest(Forces::<3> { momentum, grid, of, first, sets, gravity, velocities, out, powers })
            }
        };
        let gravity = (*gravity).into();
        let lists = (&mut accelerations[..], &mut powers[..]);
        reduced(*threads, lists, force_sums, |first, lists| {
            forces(first, fluid, [Some(fluid), Some(points)], gravity, &[], lists)
        });
        // Boundaries have no signal and no acceleration of their own; what their motion does to friction counts.
        chunks(*threads, (&mut own[..], &mut rubbed[..]), |first, lists| {
            forces(first, points, [None, Some(fluid)], [0.0; 3], velocities, lists);
        });
        let found = force_sums.iter().fold(ForceSum::default(), ForceSum::and);
        let [signal, square] = self.share.greatest([found.signal, found.square]);
        self.force_sum = ForceSum { signal, square };
        boundary.keep_forces(self.mass, self.share.owns());
        let wet = boundary.wet();
        self.share.bring_forces(&mut boundary.forces[wet]);
    }

    /// Rates of density of the fluid and of boundaries, from the rows as they are.
    pub(crate) fn sweep_rates(&mut self) {
        let Self { threads, dimensions, grid, continuity, sorted, boundary, rates, .. } = self;
        let (fluid, points, continuity, grid) = (&*sorted, &boundary.sorted, &*continuity, &*grid);
        let plane = *dimensions == 2;
        let sweep = |first, of, sets, out: &mut [[f64; 2]]| {
            if plane {
                widest(Rates::<2> { continuity, grid, of, first, sets, out });
            } else {
                widest(Rates::<3> { continuity, grid, of, first, sets, out });
            }
        };
        chunks(*threads, &mut rates[..], |first, out| sweep(first, fluid, [Some(fluid), Some(points)], out));
        let out = &mut boundary.rates[..];
        chunks(*threads, out, |first, out| sweep(first, points, [None, Some(fluid)], out));
    }

    /// With XSPH: what it adds to the velocities with which particles move, from the rows as they are.
    pub(crate) fn sweep_drags(&mut self) {
        let share = 2.0 * self.formulation.xsph * self.mass;
        if share == 0.0 {
            return;
        }
        let Self { threads, dimensions, grid, momentum, sorted, drags, .. } = self;
        drags.resize(sorted.len(), [0.0; 3]);
        let (fluid, kernel, grid) = (&*sorted, &momentum.kernel, &*grid);
        let plane = *dimensions == 2;
        chunks(*threads, &mut drags[..], |first, out: &mut [[f64; 3]]| {
            if plane {
                widest(Transport::<2> { kernel, share, grid, fluid, first, out });
            } else {
                widest(Transport::<3> { kernel, share, grid, fluid, first, out });
            }
        });
        let (drags, slots) = (&mut self.drags, &self.sorted.slots);
        self.copies.each(self.present.velocities.len(), slots, |copy, own| drags[copy] = drags[own]);
        self.share.bring_vectors(drags, |known| slots[known] as usize);
    }
}
