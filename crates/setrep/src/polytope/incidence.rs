//! Sets of small integers as rows of bits that grow together.

/// A list of bit sets over a common, growing universe.
#[derive(Debug, Clone, Default)]
pub(super) struct BitSets {
    words: usize,
    bits: Vec<u64>,
}

impl BitSets {
    /// `count` empty sets over `0..universe`.
    pub(super) fn new(count: usize, universe: usize) -> Self {
        let words = universe.div_ceil(64).max(1);
        Self { words, bits: vec![0; count * words] }
    }

    /// Number of sets.
    pub(super) fn len(&self) -> usize {
        self.bits.len() / self.words.max(1)
    }

    /// Set `i` as words.
    #[inline]
    pub(super) fn get(&self, i: usize) -> &[u64] {
        &self.bits[i * self.words..(i + 1) * self.words]
    }

    /// Set `i` as words, mutable.
    #[inline]
    pub(super) fn get_mut(&mut self, i: usize) -> &mut [u64] {
        &mut self.bits[i * self.words..(i + 1) * self.words]
    }

    /// Appends an empty set and returns its index.
    pub(super) fn push_empty(&mut self) -> usize {
        self.bits.resize(self.bits.len() + self.words, 0);
        self.len() - 1
    }

    /// Makes room for members `0..universe`.
    pub(super) fn grow_universe(&mut self, universe: usize) {
        let words = universe.div_ceil(64);
        if words <= self.words {
            return;
        }
        let words = words.max(2 * self.words);
        let mut bits = vec![0; self.len() * words];
        for (new, old) in bits.chunks_exact_mut(words).zip(self.bits.chunks_exact(self.words)) {
            new[..self.words].copy_from_slice(old);
        }
        (self.words, self.bits) = (words, bits);
    }

    /// Adds `member` to set `i`.
    #[inline]
    pub(super) fn insert(&mut self, i: usize, member: usize) {
        self.bits[i * self.words + member / 64] |= 1 << (member % 64);
    }

    /// Whether set `i` has `member`.
    #[inline]
    pub(super) fn contains(&self, i: usize, member: usize) -> bool {
        contains(self.get(i), member)
    }

    /// For each member of `0..members` the sets that hold it.
    pub(super) fn transpose(&self, members: usize) -> Self {
        let mut transpose = Self::new(members, self.len());
        for i in 0..self.len() {
            for member in iter(self.get(i)).take_while(|&member| member < members) {
                transpose.insert(member, i);
            }
        }
        transpose
    }
}

/// Whether the set has `member`.
#[inline]
pub(super) fn contains(set: &[u64], member: usize) -> bool {
    set[member / 64] >> (member % 64) & 1 == 1
}

/// Number of members common to both sets.
#[inline]
pub(super) fn common(a: &[u64], b: &[u64]) -> u32 {
    a.iter().zip(b).map(|(a, b)| (a & b).count_ones()).sum()
}

/// Number of members.
#[inline]
pub(super) fn count(set: &[u64]) -> u32 {
    set.iter().map(|word| word.count_ones()).sum()
}

/// Whether `a` is a subset of `b`.
#[inline]
pub(super) fn is_subset(a: &[u64], b: &[u64]) -> bool {
    a.iter().zip(b).all(|(a, b)| a & !b == 0)
}

/// The members in increasing order.
pub(super) fn iter(set: &[u64]) -> impl Iterator<Item = usize> + '_ {
    set.iter().enumerate().flat_map(|(k, &word)| {
        core::iter::successors((word != 0).then_some(word), |&word| Some(word & (word - 1)).filter(|&word| word != 0))
            .map(move |word| 64 * k + word.trailing_zeros() as usize)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sets_keep_their_members_when_the_universe_grows() {
        let mut sets = BitSets::new(2, 10);
        sets.insert(0, 3);
        sets.insert(1, 9);
        sets.grow_universe(200);
        sets.insert(1, 180);
        assert_eq!(iter(sets.get(1)).collect::<Vec<_>>(), [9, 180]);
        assert_eq!((count(sets.get(0)), common(sets.get(0), sets.get(1))), (1, 0));
        assert_eq!(iter(sets.transpose(181).get(180)).collect::<Vec<_>>(), [1]);
    }
}
