//! The box remainder as generators.

use crate::Zonotope;

impl Zonotope {
    /// Turns the box remainder into generators: `<c, G, r>` becomes `<c, [G diag(r)], 0>`, zero columns left out.
    ///
    /// **Guarantee:** exact (the same set).
    ///
    /// ```
    /// # use setrep::Zonotope;
    /// let mut x = Zonotope::from_box(&[0.0, 0.0], &[1.0, 0.0])?;
    /// x.materialize();
    /// assert_eq!((x.num_generators(), x.remainder()), (1, &[0.0, 0.0][..]));
    /// # Ok::<(), setrep::SetError>(())
    /// ```
    pub fn materialize(&mut self) {
        for (i, r) in self.remainder.iter_mut().enumerate() {
            if *r > 0.0 {
                self.generators.push_axis(i, *r);
                *r = 0.0;
            }
        }
    }
}
