//! The steps of structures within one of the fluid.

use crate::step::{Instant, Step};

/// Part of a step by which steps may be longer than the stable one, so that none is wasted on rounding.
pub(super) const SLIVER: f64 = 1e-6;
/// The least step over the stable one: what asks for less is pressed through something, and its bounds say so.
const LEAST: f64 = 0.01;

/// Equal steps up to the end of a step of the fluid; those that are left are divided anew where one of them has to be shorter.
#[derive(Clone, Copy, Debug)]
pub(super) struct Course {
    /// From where the steps are equal to where the fluid's ends.
    whole: Step,
    count: u64,
    number: u64,
    /// Steps done before the present division.
    before: u64,
    /// When the step of the fluid began \[T\], and how many steps there were to be.
    began: f64,
    planned: u64,
}

impl Course {
    /// So many steps to one of the fluid.
    pub fn new(whole: &Step, count: u64) -> Self {
        Self { whole: *whole, count, number: 0, before: 0, began: whole.from.time, planned: count }
    }

    /// The step to take next, behind one of this span; the last one ends where that of the fluid ends.
    pub fn step(&self, last: f64) -> Step {
        let (from, to) = (self.at(self.number), self.at(self.number + 1));
        let step = Step { from, to, kick: 0.0, damping: self.whole.damping };
        Step { kick: 0.5 * (last + step.drift()), ..step }
    }

    /// Divides what is left into equal steps of at most this span, where those at hand are longer; `stable` is the stable step.
    pub fn shorten(&mut self, most: f64, stable: f64) {
        let here = self.at(self.number);
        let left = self.whole.to.time - here.time;
        let needed = (left / most.max(LEAST * stable) - SLIVER).ceil() as u64;
        if needed > self.count - self.number {
            (self.whole.from, self.before) = (here, self.before + self.number);
            (self.number, self.count) = (0, needed);
        }
    }

    /// Takes note of a step; whether any is left.
    pub fn next(&mut self) -> bool {
        self.number += 1;
        self.number < self.count
    }

    /// Steps done.
    pub fn done(&self) -> u64 {
        self.before + self.number
    }

    /// How many steps there were to be.
    pub fn planned(&self) -> u64 {
        self.planned
    }

    /// The span of them all, the last of which had this one \[T\].
    pub fn span(&self, last: f64) -> f64 {
        if self.before == 0 { last * self.count as f64 } else { self.whole.to.time - self.began }
    }

    fn at(&self, number: u64) -> Instant {
        let Step { from, to, .. } = self.whole;
        if number == 0 {
            return from;
        }
        if number == self.count {
            return to;
        }
        let part = number as f64 / self.count as f64;
        let between = |a: f64, b: f64| a + part * (b - a);
        Instant { time: between(from.time, to.time), level: between(from.level, to.level) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn whole() -> Step {
        let at = |time, level| Instant { time, level };
        Step { from: at(1.0, 0.2), to: at(2.0, 0.6), kick: 1.0, damping: 0.0 }
    }

    #[test]
    fn steps_end_where_that_of_the_fluid_ends_whatever_is_divided_anew() {
        let mut course = Course::new(&whole(), 4);
        let (mut spans, mut last) = (Vec::new(), 0.25);
        loop {
            // The third step and those behind it have to be a tenth at most.
            course.shorten(if course.done() < 2 { 0.25 } else { 0.1 }, 0.25);
            let step = course.step(last);
            assert_eq!(step.kick, 0.5 * (last + step.drift()));
            last = step.drift();
            spans.push(last);
            if !course.next() {
                assert_eq!(step.to, whole().to);
                break;
            }
        }
        assert_eq!((spans.len(), course.done(), course.span(last)), (7, 7, 1.0));
        let expected = [0.25, 0.25, 0.1, 0.1, 0.1, 0.1, 0.1];
        assert!(spans.iter().zip(expected).all(|(span, expected)| (span - expected).abs() < 1e-12));
    }

    #[test]
    fn a_step_that_need_not_be_shorter_keeps_its_bits() {
        let mut course = Course::new(&whole(), 3);
        course.next();
        let before = course.step(0.3);
        course.shorten(before.drift(), 1.0 / 3.0);
        assert_eq!((course.step(0.3).to, course.span(0.5)), (before.to, 1.5));
    }

    #[test]
    fn steps_are_a_hundredth_of_the_stable_one_at_least() {
        let mut course = Course::new(&whole(), 1);
        course.shorten(0.0, 1.0);
        assert_eq!((0..100).take_while(|_| course.next()).count(), 99);
    }
}
