//! Temperatures of a surface in time.

use heat_conduction::Capacity;

use super::{Conduction, ConductionError, HeatBalance, Temperatures};

/// The course of temperatures of a surface in time: heat is stored at the particles, which warms them by less than what is around them. Frequencies
/// of the lattice come out low by the square of the cells, by as much as those of a capacity spread along cells come out high.
pub struct HeatCourse {
    course: heat_conduction::HeatCourse,
    found: Temperatures,
}

impl HeatCourse {
    /// Of a surface at rest at temperatures of its particles \[Θ\], of which areas store heat by degree \[F L/Θ\]; what is held from the start is there at once.
    ///
    /// # Errors
    /// [`ConductionError::Capacity`] for particles of cells that store nothing, [`ConductionError`] for a matrix that cannot be analysed; none is known.
    pub fn new(
        of: &Conduction,
        capacities: &[(u32, f64)],
        temperatures: &[f64],
    ) -> Result<Self, ConductionError> {
        let mut own = vec![0.0; of.node.len()];
        capacities.iter().for_each(|&(a, capacity)| own[of.node[a as usize] as usize] += capacity);
        let start: Vec<f64> = of.node.iter().map(|&a| temperatures[a as usize]).collect();
        let capacity = Capacity { own, pairs: Vec::new() };
        let course = heat_conduction::HeatCourse::new(&of.heat, capacity, &start)?;
        Ok(Self { found: of.seen(course.temperatures()), course })
    }

    /// Goes on to a time \[T\], in halves of the way so small that the estimate of each step is within a tolerance \[Θ\]. A step ends
    /// wherever a course of what is given has a corner: between them the rule sees all of it.
    ///
    /// # Errors
    /// [`ConductionError`] where no step is short enough, a stage is not solved, or what radiates would be colder than absolute zero.
    pub fn advance(&mut self, of: &Conduction, until: f64, tolerance: f64) -> Result<(), ConductionError> {
        self.course.advance(&of.heat, until, tolerance)?;
        self.found = of.seen(self.course.temperatures());
        Ok(())
    }

    /// Puts particles that are not held at other temperatures \[Θ\], without a heat that counts.
    pub fn put(&mut self, of: &Conduction, temperatures: &[f64]) {
        self.course.put(&of.heat, temperatures);
        self.found = of.seen(self.course.temperatures());
    }

    /// How far it has come.
    pub fn course(&self) -> &heat_conduction::HeatCourse {
        &self.course
    }

    /// Time \[T\].
    pub fn time(&self) -> f64 {
        self.course.time()
    }

    /// Temperatures now, and the heat that enters now: its sum is stored.
    pub fn temperatures(&self) -> &Temperatures {
        &self.found
    }

    /// Heat that has entered since the start, by each way \[F L\].
    pub fn came(&self) -> &HeatBalance {
        self.course.came()
    }

    /// Heat that is stored since the start \[F L\].
    pub fn stored(&self) -> f64 {
        self.course.stored()
    }

    /// Sum of the estimates of all steps, the greatest of the surface each \[Θ\].
    pub fn error(&self) -> f64 {
        self.course.error()
    }

    /// Steps taken.
    pub fn steps(&self) -> u64 {
        self.course.steps()
    }
}
