//! Four points of sections with a memory or without: the history of the sections, and that of the control that follows it.

use std::sync::Arc;

use shell_kinematics::{HistoryPack, LANES, Pack, Section};

use crate::control::yielding::YieldingControl;

/// Four points with their history.
#[derive(Clone, Debug)]
pub(crate) struct RememberingPack {
    pub section: HistoryPack,
    pub control: YieldingControl,
}

impl RememberingPack {
    /// Four points that nothing has strained.
    pub fn new(section: Arc<dyn Section>) -> Self {
        Self { section: HistoryPack::new(section), control: YieldingControl::default() }
    }

    /// How many numbers [`RememberingPack::numbers`] gives.
    pub fn count(&self) -> usize {
        self.section.count() + LANES * YieldingControl::PACKS
    }

    /// The committed history.
    pub fn numbers(&self) -> impl Iterator<Item = f64> {
        self.section.numbers().chain(self.control.numbers().into_iter().flat_map(Pack::lanes))
    }

    /// Takes up what [`RememberingPack::numbers`] gave, to the same bits.
    pub fn take_up(&mut self, numbers: &[f64]) {
        let (section, control) = numbers.split_at(self.section.count());
        self.section.take_up(section);
        let mut packs = control.as_chunks::<LANES>().0.iter().map(|lanes| Pack::new(*lanes));
        self.control.take_up(std::array::from_fn(|_| packs.next().unwrap_or_default()));
    }

    /// Bytes of its lists.
    pub fn bytes(&self) -> usize {
        self.section.bytes() + size_of::<YieldingControl>()
    }
}
