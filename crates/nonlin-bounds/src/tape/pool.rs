//! Buffers for evaluations that are handed none: one pool a thread, for scalars of any type.

use std::any::Any;
use std::cell::RefCell;

thread_local! {
    static POOL: RefCell<Vec<Box<dyn Any>>> = const { RefCell::new(Vec::new()) };
}

/// Runs `work` with an empty buffer of `S`. The buffer is kept for the next call on this thread, which allocates nothing; a call inside
/// `work` gets another one.
pub(super) fn with_buffer<S: 'static, R>(work: impl FnOnce(&mut Vec<S>) -> R) -> R {
    let kept = POOL.with_borrow_mut(|pool| {
        let index = pool.iter().position(|buffer| buffer.is::<Vec<S>>())?;
        pool.swap_remove(index).downcast::<Vec<S>>().ok()
    });
    let mut buffer = kept.unwrap_or_default();
    let result = work(&mut buffer);
    buffer.clear();
    POOL.with_borrow_mut(|pool| pool.push(buffer));
    result
}
