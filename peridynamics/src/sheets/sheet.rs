//! One sheet: its bonds, its points at the present, and what breaks them.

use sph_core::Vec3;

use crate::bonds::breaking::Breaking;
use crate::bonds::correction::Weights;
use crate::bonds::families::Families;
use crate::bonds::forces::{Scratch, Wanted};
use crate::bonds::limits::Limit;
use crate::bonds::mechanics::Evaluation;
use crate::bonds::network::{Network, Row};
use crate::error::SolidError;
use crate::fracture::{Breakage, Crack};
use crate::material::Moduli;
use crate::share::Share;

/// A sheet with its points at the present.
pub(crate) struct Sheet {
    pub network: Network,
    /// Which bonds are whole; none where nothing breaks.
    pub breaking: Option<Breaking>,
    /// Points of the last evaluation, with their dilatations.
    pub points: Vec<Row>,
    /// Forces `∂U/∂y` on them.
    pub forces: Vec<Row>,
    scratch: Scratch,
}

/// What both sheets are made from.
pub(crate) struct Cloth<'a> {
    /// Families in the plan.
    pub families: &'a Families,
    pub weights: &'a Weights<'a>,
    pub moduli: &'a Moduli,
    pub breakage: &'a Breakage,
    /// What breaks a bond, if anything does.
    pub limit: Option<Limit>,
}

impl Cloth<'_> {
    /// A sheet whose points at rest are these, images behind. Bonds keep the weights of the plan; their lengths are those between the points.
    /// Tells for each crack whether it cuts the sheet.
    ///
    /// # Errors
    /// [`SolidError`] for what breaks it.
    pub fn sheet(&self, at_rest: &[Vec3]) -> Result<(Sheet, Vec<bool>), SolidError> {
        let mut network = Network::new(self.families, self.weights, Some(at_rest), self.moduli);
        let breaks = self.breakage.breaks();
        let mut breaking = breaks.then(|| Breaking::new(&network, self.families));
        let mut cuts = Vec::new();
        if let Some(breaking) = &mut breaking {
            for (number, crack) in self.breakage.cracks.iter().enumerate() {
                let dimensions = if matches!(crack, Crack::Segment(_)) { 2 } else { 3 };
                let cut = crack.cut(number, dimensions)?;
                cuts.push(breaking.cut(&mut network, at_rest, &cut) > 0);
            }
            if let (Some(limit), Some(fracture)) = (self.limit, &self.breakage.fracture) {
                breaking.limit(&network, limit, &fracture.unbreakable)?;
            }
        }
        let points: Vec<Row> = at_rest.iter().map(|y| [y.x, y.y, y.z, 0.0]).collect();
        let forces = vec![[0.0; 4]; network.len()];
        let scratch = Scratch::new(&network);
        Ok((Sheet { network, breaking, points, forces, scratch }, cuts))
    }
}

impl Sheet {
    /// Puts its points at `x + z d` and finds the forces on them; returns the stored energy \[F L\], zero unless wanted.
    pub fn evaluate(&mut self, rows: &[Row], z: f64, wanted: Evaluation<'_>) -> f64 {
        let Evaluation { energy, watch, share } = wanted;
        put(&mut self.points, rows, z);
        let limit = self.breaking.as_ref().and_then(|breaking| breaking.watch.as_ref()).filter(|_| watch);
        let wanted = Wanted { energy, watch: limit, share };
        let stored = self.network.evaluate(&mut self.points, &mut self.forces, &mut self.scratch, wanted);
        if let Some(works) =
            self.breaking.as_mut().and_then(|breaking| breaking.works.as_mut()).filter(|_| watch)
        {
            works.add(&self.network, &self.points, share);
        }
        stored
    }

    /// Second derivatives at the points of `rows` times the motions of `along`, into the forces.
    pub fn tangent(&mut self, rows: &[Row], along: &[Row], z: f64, share: &Share) {
        put(&mut self.points, rows, z);
        let mut motions = vec![[0.0; 4]; self.points.len()];
        put(&mut motions, along, z);
        self.network.tangent(&mut self.points, &mut motions, &mut self.forces, &mut self.scratch, share);
    }

    /// Whether bonds may break.
    pub fn breaks(&self) -> bool {
        self.breaking.as_ref().is_some_and(Breaking::is_watched)
    }

    /// Whether bonds were beyond their limit in the last evaluation.
    pub fn noted(&self, share: &Share) -> bool {
        self.breaking.as_ref().is_some_and(|breaking| breaking.noted(&self.scratch, share).next().is_some())
    }

    /// Breaks the bonds noted in the last evaluation; returns the energy that the sheet loses at these rows \[F L\].
    pub fn break_noted(&mut self, rows: &[Row], z: f64, share: &Share) -> f64 {
        let Some(breaking) = &mut self.breaking else { return 0.0 };
        let mut points = self.points[..self.network.len()].to_vec();
        put(&mut points, rows, z);
        breaking.break_noted(&mut self.network, &self.scratch, &points, None, share)
    }

    /// How far the bond nearest to its limit is taken in the last evaluation.
    pub fn utilisation(&self) -> f64 {
        self.breaking.as_ref().map_or(0.0, |breaking| breaking.utilisation(&self.network, &self.points))
    }

    /// Breaks the bonds taken so far or further in the last evaluation; counts a part of the energy that the sheet loses, and
    /// returns it \[F L\].
    pub fn break_from(&mut self, least: f64, counted: f64, share: &Share) -> f64 {
        let Some(breaking) = &mut self.breaking else { return 0.0 };
        breaking.break_from(&mut self.network, (least, counted), &self.points, None, share)
    }

    /// Whether the bond on a lane is whole.
    pub fn is_whole(&self, lane: usize) -> bool {
        self.breaking.as_ref().is_none_or(|breaking| breaking.bonds.is_whole(lane))
    }

    /// The broken part of a node's family.
    pub fn damage(&self, node: usize) -> f64 {
        self.breaking.as_ref().map_or(0.0, |breaking| breaking.damage(&self.network, node))
    }

    /// Memory of bonds and points \[bytes\].
    pub fn bytes(&self) -> usize {
        let points = 2 * size_of::<Row>() * self.points.len();
        self.network.bytes() + points + self.breaking.as_ref().map_or(0, Breaking::bytes)
    }
}

/// Puts the points of a sheet at `x + z d`, not those of images.
fn put(points: &mut [Row], rows: &[Row], z: f64) {
    let (places, directors) = rows.split_at(rows.len() / 2);
    for (point, (x, d)) in points.iter_mut().zip(places.iter().zip(directors)) {
        (0..3).for_each(|k| point[k] = x[k] + z * d[k]);
    }
}
