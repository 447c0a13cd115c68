//! What the particles of a shell that yields have gone through, from its cells.

use sph_shell::{Shell, Yielded};

use crate::bodies::Yielding;
use crate::bodies::yielding::beyond_data;
use crate::{Warning, WarningKind};

/// Share of the work above which the control of zero-energy modes holds too much \[–\]: roof, hemisphere, plate and pinched cylinder have .1 to .4 % with
/// 16 cells a side, .7 to 2.3 % with 4.
const MUCH: f64 = 0.01;

/// Share of the dissipation from which cells at clamped edges are a hinge \[–\].
const HINGE: f64 = 0.2;
/// Size of its cells over the span beside them above which it stands too far inside: a clamped disc of 12, 24, 48 cells bears 6.8, 3.3, 1.6 % too much.
const WIDE: f64 = 0.03;

/// Thinning from which a neck is looked for \[–\]: bending and point loads thin by less, and sheets that harden thin evenly.
const THIN: f64 = 0.1;
/// By particle: the greatest plastic strain and the least thickness of the cells round it, and its share of what they dissipated.
pub(super) fn yielding(shell: &Shell) -> Vec<Yielding> {
    let of_cells = shell.yielded();
    if of_cells.is_empty() {
        return Vec::new();
    }
    let mut out =
        vec![Yielding { plastic_strain: 0.0, thickness: f64::INFINITY, dissipated: 0.0 }; shell.len()];
    for (number, (cell, own)) in shell.reference().cloud.cells.iter().zip(&of_cells).enumerate() {
        let thickness = shell.section_at(number).thickness;
        for &a in cell.particles() {
            let of = &mut out[a as usize];
            of.plastic_strain = of.plastic_strain.max(own.plastic_strain);
            of.thickness = of.thickness.min(thickness * own.thickness);
            of.dissipated += own.dissipated * own.area / cell.count as f64;
        }
    }
    out
}

/// What may be wrong with the states of a shell that yields.
pub(super) fn warnings(shell: &Shell) -> Vec<Warning> {
    let of_cells = shell.yielded();
    let mut out = Vec::new();
    out.extend(beyond_data(of_cells.iter().enumerate().filter_map(|(cell, own)| {
        Some((own.plastic_strain, shell.plastic_section_at(cell)?.data_until()?))
    })));
    out.extend(necking(shell, &of_cells));
    out.extend(hinge(shell, &of_cells));
    let control: f64 = of_cells.iter().map(|own| own.control).sum();
    let work = shell.internal_work();
    let share = control / work;
    if work > 0.0 && share > MUCH {
        let message = format!(
            "{:.1} % of the work went into the control of zero-energy modes (over {:.0} %): hinges are narrower than the cells; use more particles \
             where it yields",
            100.0 * share,
            100.0 * MUCH
        );
        out.push(Warning { kind: WarningKind::StiffControl, message });
    }
    out
}

/// A hinge in the cells along clamped edges, which flow in their middles: the span that it leaves is half a cell too short at each end.
fn hinge(shell: &Shell, of_cells: &[Yielded]) -> Option<Warning> {
    let cells = &shell.reference().cloud.cells;
    let places = &shell.reference().cloud.positions;
    let (clamped, free): (Vec<u32>, Vec<u32>) =
        (0..shell.len() as u32).partition(|&a| shell.is_clamped(a as usize));
    let nearest = |a: u32, of: &[u32]| {
        let apart = of.iter().map(|&b| (places[a as usize] - places[b as usize]).norm_squared());
        apart.fold(f64::INFINITY, f64::min).sqrt()
    };
    let [mut all, mut beside, mut size] = [0.0; 3];
    for (cell, own) in cells.iter().zip(of_cells) {
        let work = own.dissipated * own.area;
        all += work;
        let (held, inside): (Vec<u32>, Vec<u32>) =
            cell.particles().iter().partition(|&&a| shell.is_clamped(a as usize));
        if work > 0.0 && !held.is_empty() && !inside.is_empty() {
            beside += work;
            size += work * inside.iter().map(|&a| nearest(a, &held)).fold(f64::INFINITY, f64::min);
        }
    }
    if beside <= HINGE * all {
        return None;
    }
    let span = free.iter().map(|&a| nearest(a, &clamped)).fold(0.0, f64::max);
    let wide = size / beside / span;
    (wide > WIDE).then(|| {
        let message = format!(
            "{:.0} % of what is dissipated flows in the cells along clamped edges, which are {:.1} % of the span beside them (over {:.0} %): the hinge stands \
             half a cell inside, and the load it bears is up to so much too high; make the cells along the edge smaller",
            100.0 * beside / all,
            100.0 * wide,
            100.0 * WIDE
        );
        Warning { kind: WarningKind::CoarseHinge, message }
    })
}

/// Cells that are drawn thin and harden by less than they lose in thickness (Considère's criterion, K' < K): from there a strip gives way in one place.
fn necking(shell: &Shell, of_cells: &[Yielded]) -> Option<Warning> {
    let gives_way = |(cell, own): &(usize, &Yielded)| {
        own.thickness < 1.0 - THIN
            && shell.plastic_section_at(*cell).is_some_and(|section| {
                let [stress, slope] = section.yield_at(own.plastic_strain);
                slope < stress
            })
    };
    let (mut count, mut least) = (0, 1.0_f64);
    for (_, own) in of_cells.iter().enumerate().filter(gives_way) {
        (count, least) = (count + 1, least.min(own.thickness));
    }
    let message = format!(
        "{count} cells are drawn to {:.0} % of their thickness and harden by less than they get thinner (K' < K): a neck may form there, as wide as a \
         cell, and what comes behind it depends on the mesh; read nothing beyond the greatest force, or compare lattices",
        100.0 * least
    );
    (count > 0).then_some(Warning { kind: WarningKind::Necking, message })
}
