//! The reference configuration: cloud, sampling operator, masses. Immutable once built.

use shell_kinematics::SectionScales;
use sph_core::{
    Cloud, CubicSpline, SamplingOperator, Vec3, cell_operator, kernel_operator, make_divergence_consistent,
    nodal_operator,
};

use crate::error::ShellError;
use crate::formulation::{Divergence, Formulation, Reach};

/// What never changes during a run.
#[derive(Clone, Debug)]
pub struct Reference {
    /// Particles, frames, areas, cells; positions from the origin.
    pub cloud: Cloud,
    /// From where places are kept \[L\]: zero unless the shell was built about one.
    pub origin: Vec3,
    /// Positions from zero as they were given; empty where the origin is zero.
    pub(crate) given: Vec<Vec3>,
    /// Sampling points with their stencils.
    pub operator: SamplingOperator,
    /// Masses `ρ t A_a` \[M\].
    pub masses: Vec<f64>,
    /// Rotary inertias of the directors in marching \[M L²\], see [`Reference::new`].
    pub inertias: Vec<f64>,
    /// Rotary inertias of the shell itself \[M L²\] where it has several sections or bears masses; empty for one, whose
    /// radius of gyration is that of its thickness.
    pub rotary: Vec<f64>,
    /// Density where no region has its own \[M/L³\].
    pub density: f64,
    /// Speed of sound in the mid-surface, `√(E/(ρ(1−ν²)))`, of the stiffest direction \[L/T\].
    pub sound_speed: f64,
}

impl Reference {
    /// Builds stencils and masses.
    ///
    /// Rotary inertia is `ρ t A_a max(t²/12, Ā_a/12)` with Ā_a the mean area of the cells at the particle: for
    /// thin shells it is scaled up so that the stable step does not collapse with the thickness (statics are
    /// untouched, bending waves shorter than a few spacings are slowed). Modes of vibration take `ρ t A_a t²/12`,
    /// see [`crate::StaticShell`], and cells of rigid sets their own thickness in marches too.
    ///
    /// With a material axis the first direction of every sampling point is its projection on the surface; without, it is
    /// whatever the stencils chose.
    ///
    /// # Errors
    /// [`ShellError`] for invalid clouds, stencils that cannot be corrected, density out of bounds, and a material axis
    /// that stands on the surface somewhere.
    pub fn new(
        cloud: Cloud,
        formulation: &Formulation,
        section: &SectionScales,
        density: f64,
        material_axis: Option<&Vec3>,
    ) -> Result<Self, ShellError> {
        if !(density > 0.0 && density.is_finite()) {
            return Err(ShellError::Density(density));
        }
        cloud.check()?;
        if let Some((particle, &area)) = cloud.areas.iter().enumerate().find(|(_, a)| **a <= 0.0) {
            return Err(ShellError::Area { particle, area });
        }
        let mut operator = operator(&cloud, formulation)?;
        if let Some(axis) = material_axis {
            operator.align(axis)?;
        }
        let t = section.thickness;
        let masses: Vec<f64> = cloud.areas.iter().map(|area| density * t * area).collect();
        let cell_areas = mean_cell_areas(&cloud);
        let inertias =
            masses.iter().zip(&cell_areas).map(|(m, cell)| m * (t * t).max(*cell) / 12.0).collect();
        let sound_speed = (section.membrane / (density * t)).sqrt();
        Ok(Self {
            cloud,
            origin: Vec3::zeros(),
            given: Vec::new(),
            operator,
            masses,
            inertias,
            rotary: Vec::new(),
            density,
            sound_speed,
        })
    }

    /// Adds masses \[M\] to particles of a shell of some thickness \[L\]; what turns with a director is the shell alone.
    ///
    /// # Errors
    /// [`ShellError`] for a particle beyond the cloud, and for a mass that is not positive and finite.
    pub(crate) fn lump(&mut self, masses: &[(u32, f64)], thickness: f64) -> Result<(), ShellError> {
        let count = self.cloud.len();
        for &(particle, mass) in masses {
            if particle as usize >= count {
                return Err(ShellError::NoSuchParticle { what: "a mass", particle, count });
            }
            if !(mass > 0.0 && mass.is_finite()) {
                return Err(ShellError::Mass { particle, mass });
            }
        }
        if self.rotary.is_empty() && !masses.is_empty() {
            let turning = thickness.powi(2) / 12.0;
            self.rotary = self.masses.iter().map(|mass| mass * turning).collect();
        }
        for &(particle, mass) in masses {
            self.masses[particle as usize] += mass;
        }
        Ok(())
    }

    /// A place from zero, of one from the origin \[L\].
    pub fn from_zero(&self, place: Vec3) -> Vec3 {
        // Adding zero would turn −0 into 0.
        if self.origin == Vec3::zeros() { place } else { place + self.origin }
    }

    /// Rows `[x, d]` of all particles at rest, from the origin.
    pub(crate) fn rest(&self) -> Vec<[f64; 6]> {
        let rows = self.cloud.positions.iter().zip(&self.cloud.frames);
        rows.map(|(x, f)| [x.x, x.y, x.z, f.n.x, f.n.y, f.n.z]).collect()
    }
}

fn operator(cloud: &Cloud, formulation: &Formulation) -> Result<SamplingOperator, ShellError> {
    Ok(match *formulation {
        Formulation::StressPoint(Reach::Cell) => cell_operator(cloud)?,
        Formulation::StressPoint(Reach::Kernel(kernel, reach)) => {
            let mut operator = kernel_operator(cloud, kernel, reach)?;
            make_divergence_consistent(&mut operator, cloud, &[1])?;
            operator
        }
        Formulation::Nodal { order, smoothing, consistent, kernel } => {
            let operator = nodal_operator(cloud, kernel, order, smoothing)?;
            if consistent { consistent_nodal(operator, cloud)? } else { operator }
        }
        Formulation::StrongForm { smoothing, kernel, divergence: Divergence::Sum, .. } => {
            nodal_operator(cloud, kernel, 1, smoothing)?
        }
        Formulation::StrongForm { smoothing, kernel, .. } => {
            // Half cells at edges would make the gradients of the row beside them one-sided.
            let whole = Cloud { areas: mean_cell_areas(cloud), ..cloud.clone() };
            let mut operator = nodal_operator(&whole, kernel, 1, smoothing)?;
            operator.points.iter_mut().zip(&cloud.areas).for_each(|(point, area)| point.weight = *area);
            operator
        }
    })
}

/// Divergence-consistent nodal gradients that keep as much of their order as the areas of the particles allow.
///
/// Keeping cubics costs stencils of Σ|G|Δ ≈ 23 beside the corners (a quarter of the stable step) and no
/// accuracy: ring 50×5 .12 % at full moment with order 2 kept, .18 % with order 3. Off the lattice the areas
/// do not integrate linear functions: rows of order 2 then contradict the condition, and order 1 is kept.
fn consistent_nodal(operator: SamplingOperator, cloud: &Cloud) -> Result<SamplingOperator, ShellError> {
    let keep = |most: u8| {
        let mut changed = operator.clone();
        let orders: Vec<u8> = operator.orders.iter().map(|&order| order.min(most)).collect();
        make_divergence_consistent(&mut changed, cloud, &orders)
            .map(|report| (changed, report.residual_after))
    };
    let (second, contradiction) = keep(2)?;
    // Conditions that agree are met to 1e-9 of the spacing and better.
    if contradiction < 1e-8 {
        return Ok(second);
    }
    let (first, remainder) = keep(1)?;
    Ok(if remainder < 0.1 * contradiction { first } else { second })
}

/// The nodal gradients of order 2 on which the pair residual of wide stencils is built.
pub(crate) fn pair_gradients(cloud: &Cloud) -> Result<SamplingOperator, ShellError> {
    // Smoothing length 1.3 spacings: the smallest that holds the five neighbours of order 2 with room to spare.
    Ok(nodal_operator(cloud, &CubicSpline, 2, 1.3)?)
}

/// From where the places of a cloud are best kept: zero unless it stands farther from there than it is long, else near its middle, a whole number of
/// powers of two, so that differences of places lose nothing.
pub fn origin_of(cloud: &Cloud) -> Vec3 {
    let ends = |pick: fn(f64, f64) -> f64| cloud.positions.iter().copied().reduce(|a, b| a.zip_map(&b, pick));
    let Some((low, high)) = ends(f64::min).zip(ends(f64::max)) else { return Vec3::zeros() };
    let (middle, size) = ((low + high) * 0.5, (high - low).norm());
    if !(middle.norm() > size && size > 0.0) {
        return Vec3::zeros();
    }
    let unit = libm::ldexp(1.0, libm::frexp(size).1);
    middle.map(|place| libm::round(place / unit) * unit)
}

/// Mean area of the cells at each particle \[L²\]; without cells its own area.
pub(crate) fn mean_cell_areas(cloud: &Cloud) -> Vec<f64> {
    let mut sum = vec![(0.0, 0.0); cloud.len()];
    for cell in &cloud.cells {
        let area = cell.geometry(&cloud.positions).area;
        for &corner in cell.particles() {
            let entry = &mut sum[corner as usize];
            *entry = (entry.0 + area, entry.1 + 1.0);
        }
    }
    let mean = |((area, count), own): ((f64, f64), &f64)| if count > 0.0 { area / count } else { *own };
    sum.into_iter().zip(&cloud.areas).map(mean).collect()
}
