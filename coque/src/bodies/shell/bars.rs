//! The bar of a stiffener of a scene: what it bears, and how it lies.

use shell_kinematics::BarSection;
use sph_shell::{InSurface, Stiffener};

use crate::scene::{ShellScene, StiffenerScene, StiffenerSection, StiffenerSide};

/// Area and height of the centroid over the particles of a stiffener.
fn area_and_height(stiffener: &StiffenerScene, shell: &ShellScene) -> [f64; 2] {
    let (area, height) = match stiffener.section {
        StiffenerSection::Rectangle(own) => (own.width.get() * own.height.get(), own.height.get()),
        StiffenerSection::Profile(own) => (own.area.get(), 0.0),
    };
    let beside = 0.5 * (shell.section.thickness().unwrap_or_default() + height);
    let height = match stiffener.side {
        Some(StiffenerSide::Top) => beside,
        Some(StiffenerSide::Bottom) => -beside,
        None => stiffener.eccentricity.unwrap_or_default(),
    };
    [area, height]
}

/// A line of what is modelled.
pub(super) fn described_stiffener(stiffener: &StiffenerScene, shell: &ShellScene) -> String {
    let [_, height] = area_and_height(stiffener, shell);
    let size = match stiffener.section {
        StiffenerSection::Rectangle(own) => format!("{} wide, {} high", own.width, own.height),
        StiffenerSection::Profile(own) => format!("of the area {}", own.area),
    };
    let half =
        if stiffener.share.get() < 1.0 { format!(", {} of it", stiffener.share) } else { String::new() };
    let bends = if stiffener.in_surface.is_some() { ", bending in the surface too" } else { "" };
    format!("a stiffener on {}, {size}, its centroid {height} over the particles{half}{bends}", stiffener.on)
}

/// The bar of a stiffener of a shell, its particles left out; none without an elastic material, which the checks refuse.
pub(super) fn bar_of(stiffener: &StiffenerScene, shell: &ShellScene) -> Option<Stiffener> {
    let elastic = stiffener.elastic(&shell.material)?;
    let young = elastic.young.get();
    let moduli = [young, 0.5 * young / (1.0 + elastic.poisson)];
    let whole = match stiffener.section {
        StiffenerSection::Rectangle(own) => BarSection::rectangle(moduli, own.width.get(), own.height.get()),
        StiffenerSection::Profile(own) => {
            let (area, inertia) = (own.area.get(), own.inertia.get());
            BarSection {
                axial: young * area,
                bending: young * inertia,
                shear: moduli[1] * own.shear_area.map_or(5.0 / 6.0 * area, |area| area.get()),
                torsion: moduli[1] * own.torsion.get(),
                gyration: (inertia + own.lateral.get()) / area,
            }
        }
    };
    let share = stiffener.share.get();
    let [area, height] = area_and_height(stiffener, shell);
    let mass = elastic.density.get() * area * share;
    let lateral = match stiffener.section {
        StiffenerSection::Rectangle(own) => own.height.get() * own.width.get().powi(3) / 12.0,
        StiffenerSection::Profile(own) => own.lateral.get(),
    };
    let bending = young * lateral * share;
    let in_surface = stiffener.in_surface.as_ref().map(|_| InSurface { bending, held: Vec::new() });
    Some(Stiffener { particles: Vec::new(), section: whole.part(share), height, mass, in_surface })
}
