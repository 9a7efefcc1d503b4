//! Sets of constraints as keys of a hash table: which ray shares a ridge with which.

/// No ray, no row.
pub(super) const NONE: u32 = u32::MAX;

/// A random word for each constraint; the XOR over a set is its key.
#[inline]
pub(super) fn slot_key(slot: usize) -> u64 {
    // splitmix64
    let mut z = (slot as u64 + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

/// A multimap from keys to rays by open addressing.
#[derive(Default)]
pub(super) struct Table {
    keys: Vec<u64>,
    rays: Vec<u32>,
    mask: usize,
}

impl Table {
    /// Empties the table and makes room for `entries`.
    pub(super) fn reset(&mut self, entries: usize) {
        let size = (2 * entries + 1).next_power_of_two();
        self.mask = size - 1;
        self.rays.clear();
        self.rays.resize(size, NONE);
        self.keys.resize(size, 0);
    }

    /// Adds a ray under a key; several rays may have the same.
    #[inline]
    pub(super) fn insert(&mut self, key: u64, ray: u32) {
        let mut at = key as usize & self.mask;
        while self.rays[at] != NONE {
            at = (at + 1) & self.mask;
        }
        (self.keys[at], self.rays[at]) = (key, ray);
    }

    /// Visits the rays of a key.
    #[inline]
    pub(super) fn find(&self, key: u64, mut visit: impl FnMut(u32)) {
        let mut at = key as usize & self.mask;
        while self.rays[at] != NONE {
            if self.keys[at] == key {
                visit(self.rays[at]);
            }
            at = (at + 1) & self.mask;
        }
    }
}
