//! A shell that conducts heat and does not move, as a body: its temperatures, what can be measured of them, what fields show.

use std::io;

use heat_conduction::{ConductionError, HeatBalance};
use mesh_io::{At, FieldWriter, Values, rows};
use sph_core::Vec3;
use sph_shell::{Conduction, HeatCourse, Shell, Temperatures};

use crate::bodies::body::{Body, Configuration, Mismatch, StateArray};
use crate::bodies::ready::ConductingBody;
use crate::bodies::{ContactFields, FieldRequest, FieldSource, Part, State};
use crate::scene::Measured;
use crate::scene::units::Quantity;

use super::fields::fields;

/// A shell at rest with its temperatures.
pub(super) struct ConductingShell {
    shell: Shell,
    conduction: Conduction,
    /// Heat that particles store by degree \[F L/Θ\].
    capacities: Vec<(u32, f64)>,
    found: Temperatures,
    /// How temperatures go in time, once they do.
    course: Option<HeatCourse>,
}

impl ConductingShell {
    /// One whose temperatures are not known yet.
    pub fn new(shell: Shell, conduction: Conduction, capacities: Vec<(u32, f64)>) -> Self {
        let count = shell.len();
        let zero = || vec![0.0; count];
        let found = Temperatures {
            values: zero(),
            held: zero(),
            flux: vec![Vec3::zeros(); shell.reference().cloud.cells.len()],
            balance: Default::default(),
            iterations: 0,
        };
        Self { shell, conduction, capacities, found, course: None }
    }
}

impl ConductingBody for ConductingShell {
    fn settle(&mut self) -> Result<(HeatBalance, usize), ConductionError> {
        self.found = self.conduction.steady()?;
        Ok((self.found.balance, self.found.iterations))
    }

    fn start(&mut self, temperature: Option<f64>) -> Result<&heat_conduction::HeatCourse, ConductionError> {
        let values = match temperature {
            Some(own) => vec![own; self.shell.len()],
            None => self.conduction.steady()?.values,
        };
        let course = HeatCourse::new(&self.conduction, &self.capacities, &values)?;
        self.found = course.temperatures().clone();
        Ok(self.course.insert(course).course())
    }

    fn advance(
        &mut self,
        until: f64,
        tolerance: f64,
    ) -> Result<&heat_conduction::HeatCourse, ConductionError> {
        let mut course = match self.course.take() {
            Some(course) => course,
            None => HeatCourse::new(&self.conduction, &self.capacities, &self.found.values)?,
        };
        course.advance(&self.conduction, until, tolerance)?;
        self.found = course.temperatures().clone();
        Ok(self.course.insert(course).course())
    }
}

impl Body for ConductingShell {
    fn configuration(&self) -> Configuration<'_> {
        self.shell.configuration()
    }

    fn read(&self, of: Measured, a: usize, along: &Vec3) -> f64 {
        match of {
            Measured::Temperature => self.found.values[a],
            Measured::HeldHeat => self.found.held[a],
            _ => Body::read(&self.shell, of, a, along),
        }
    }

    fn fields<'a>(&'a self, shown: &FieldRequest<'a>) -> Box<dyn FieldSource + 'a> {
        // Of the shell its shape alone.
        let shown = FieldRequest { state: State::Mode, ..*shown };
        let shape = fields(&self.shell, &shown, ContactFields::default());
        Box::new(move |part: Part, to: &mut dyn FieldWriter| -> io::Result<()> {
            shape.write(part, to)?;
            let layers = if part == Part::Extruded { 2 } else { 1 };
            let (count, found) = (self.found.values.len(), &self.found);
            let values = rows(layers * count, |i| [found.values[i % count]]);
            let unit = |quantity: Quantity| shown.units.symbol(quantity);
            to.numbers(
                At::Points,
                "temperature",
                &unit(Quantity::Temperature),
                &[],
                Values::Double(&values),
            )?;
            let flux = rows(found.flux.len(), |c| found.flux[c].into());
            to.numbers(At::Cells, "heat_flux", &unit(Quantity::HeatByLength), &[], Values::Double(&flux))
        })
    }

    fn state(&self) -> Vec<StateArray<'_>> {
        vec![StateArray::new("temperatures", &self.found.values)]
    }

    fn set_state(&mut self, state: &[StateArray<'_>]) -> Result<(), Mismatch> {
        match state {
            [own] if own.numbers.len() == self.found.values.len() => {
                self.found.values = own.numbers.to_vec();
                if let Some(course) = &mut self.course {
                    course.put(&self.conduction, &own.numbers);
                    self.found = course.temperatures().clone();
                }
                Ok(())
            }
            _ => Err(Mismatch),
        }
    }
}
