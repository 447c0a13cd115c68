//! A solid that conducts heat and does not move, as a body: its temperatures, what can be measured of them, what fields show.

use std::io;

use heat_conduction::{
    Capacity, Conduction, ConductionError, Conducts, HeatBalance, HeatCourse, Temperatures,
};
use mesh_io::{At, FieldWriter, Values, rows};
use sph_core::Vec3;

use super::body::{Body, Configuration, Mismatch, StateArray};
use super::ready::ConductingBody;
use super::{FieldRequest, FieldSource, Part, State};
use crate::scene::Measured;
use crate::scene::units::Quantity;

/// Heat that runs through a solid.
pub(super) trait HeatOf<S>: Send {
    /// What conducts.
    type Conducts: Conducts;

    /// What holds and feeds it.
    fn heat(&self) -> &Conduction<Self::Conducts>;

    /// Lists of parameters that conduct to each other.
    fn pieces(&self) -> Vec<Vec<u32>>;

    /// Heat that runs through each node, by area across it \[F/(L T)\].
    fn flux(&self, solid: &S, parameters: &[f64]) -> Vec<Vec3>;
}

/// A solid at rest with its temperatures.
pub(super) struct ConductingSolid<S, H> {
    solid: S,
    heat: H,
    /// What parameters store by degree; nothing of a solid whose temperatures are sought in balance.
    capacity: Capacity,
    found: Temperatures,
    /// How temperatures go in time, once they do.
    course: Option<HeatCourse>,
}

impl<S: Body, H: HeatOf<S>> ConductingSolid<S, H> {
    /// One whose temperatures are not known yet.
    pub fn new(solid: S, heat: H, capacity: Capacity) -> Self {
        let zero = || vec![0.0; heat.heat().conductor().parameters()];
        let found =
            Temperatures { parameters: zero(), values: zero(), held: zero(), ..Temperatures::default() };
        Self { solid, heat, capacity, found, course: None }
    }

    fn steady(&self) -> Result<Temperatures, ConductionError> {
        match self.heat.heat().untold(&self.heat.pieces()) {
            Some(particle) => Err(ConductionError::Untold { particle }),
            None => self.heat.heat().steady(),
        }
    }

    fn course(&self, parameters: &[f64]) -> Result<HeatCourse, ConductionError> {
        HeatCourse::new(self.heat.heat(), self.capacity.clone(), parameters)
    }
}

impl<S: Body, H: HeatOf<S>> ConductingBody for ConductingSolid<S, H> {
    fn settle(&mut self) -> Result<(HeatBalance, usize), ConductionError> {
        self.found = self.steady()?;
        Ok((self.found.balance, self.found.iterations))
    }

    fn start(&mut self, temperature: Option<f64>) -> Result<&HeatCourse, ConductionError> {
        let parameters = match temperature {
            Some(own) => vec![own; self.found.parameters.len()],
            None => self.steady()?.parameters,
        };
        let course = self.course(&parameters)?;
        self.found = course.temperatures().clone();
        Ok(self.course.insert(course))
    }

    fn advance(&mut self, until: f64, tolerance: f64) -> Result<&HeatCourse, ConductionError> {
        let mut course = match self.course.take() {
            Some(course) => course,
            None => self.course(&self.found.parameters)?,
        };
        course.advance(self.heat.heat(), until, tolerance)?;
        self.found = course.temperatures().clone();
        Ok(self.course.insert(course))
    }
}

impl<S: Body, H: HeatOf<S>> Body for ConductingSolid<S, H> {
    fn configuration(&self) -> Configuration<'_> {
        self.solid.configuration()
    }

    fn read(&self, of: Measured, a: usize, along: &Vec3) -> f64 {
        match of {
            Measured::Temperature => self.found.values[a],
            Measured::HeldHeat => self.found.held[a],
            _ => self.solid.read(of, a, along),
        }
    }

    fn fields<'a>(&'a self, shown: &FieldRequest<'a>) -> Box<dyn FieldSource + 'a> {
        // Of the solid its shape alone.
        let shown = FieldRequest { state: State::Mode, ..*shown };
        let shape = self.solid.fields(&shown);
        let (found, units) = (&self.found, shown.units);
        let flux = self.heat.flux(&self.solid, &found.parameters);
        Box::new(move |part: Part, to: &mut dyn FieldWriter| -> io::Result<()> {
            shape.write(part, to)?;
            if !matches!(part, Part::Surface | Part::Extruded) {
                return Ok(());
            }
            let unit = |quantity: Quantity| units.symbol(quantity);
            let values = rows(found.values.len(), |a| [found.values[a]]);
            let of_values = Values::Double(&values);
            to.numbers(At::Points, "temperature", &unit(Quantity::Temperature), &[], of_values)?;
            let flux = rows(flux.len(), |a| flux[a].into());
            to.numbers(At::Points, "heat_flux", &unit(Quantity::HeatByArea), &[], Values::Double(&flux))
        })
    }

    fn state(&self) -> Vec<StateArray<'_>> {
        vec![StateArray::new("temperatures", &self.found.parameters)]
    }

    fn set_state(&mut self, state: &[StateArray<'_>]) -> Result<(), Mismatch> {
        match state {
            [own] if own.numbers.len() == self.found.parameters.len() => {
                self.found.parameters = own.numbers.to_vec();
                self.found.values = self.heat.heat().conductor().at_nodes(&own.numbers);
                if let Some(course) = &mut self.course {
                    course.put(self.heat.heat(), &own.numbers);
                    self.found = course.temperatures().clone();
                }
                Ok(())
            }
            _ => Err(Mismatch),
        }
    }
}
