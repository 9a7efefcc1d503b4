//! Set-membership filters on vector spaces and Lie groups.
