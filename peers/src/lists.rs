//! What a peer exchanges in each step: with whom, which particles' rows go out and which come in.

/// What a peer sends to another and takes from it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Partner {
    /// Its rank.
    pub rank: usize,
    /// Particles whose rows go there, in the order in which the other takes them.
    pub send: Vec<u32>,
    /// Particles whose rows come from there, in the order in which the other sends them.
    pub take: Vec<u32>,
}

/// What a peer exchanges with all others. A particle's number is whatever its owner and its taker index their rows by: with whole arrays the
/// global one on both sides.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Lists {
    partners: Vec<Partner>,
}

impl Lists {
    /// With these partners, by rank; those with nothing to exchange are left out.
    ///
    /// # Panics
    /// If a rank occurs twice.
    pub fn new(mut partners: Vec<Partner>) -> Self {
        partners.retain(|partner| !(partner.send.is_empty() && partner.take.is_empty()));
        partners.sort_by_key(|partner| partner.rank);
        let twice = partners.windows(2).find(|pair| pair[0].rank == pair[1].rank);
        assert!(twice.is_none(), "a partner twice: {:?}", twice.map(|pair| pair[0].rank));
        Self { partners }
    }

    /// Those with whom anything is exchanged, by rank.
    pub fn partners(&self) -> &[Partner] {
        &self.partners
    }

    /// Rows that come in: particles of others that this peer needs.
    pub fn ghosts(&self) -> usize {
        self.partners.iter().map(|partner| partner.take.len()).sum()
    }

    /// Rows that go out; a particle that two partners need counts twice.
    pub fn sent(&self) -> usize {
        self.partners.iter().map(|partner| partner.send.len()).sum()
    }

    /// Bytes that go out in a step, with so many numbers a row.
    pub fn bytes_sent(&self, width: usize) -> usize {
        self.sent() * width * size_of::<f64>()
    }
}
