//! Published test vectors.

mod itf1788;
mod itl;
