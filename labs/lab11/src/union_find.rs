//! Which group a particle belongs to: union-find.
//!
//! Particles are numbered from 0. Each number has a parent in its group, which is never a greater
//! number; the least number of a group, its root, is its own parent. At first each particle is alone.

/// The root of the group of number `k`: follow the parents until a number is its own.
///
/// Give each number that you pass its grandparent as its parent. It stays in its group, and the path
/// is half as long for the next search.
///
/// Book: chapter 11, *Groups*.
#[inline]
pub fn root(parent: &mut [u32], k: u32) -> u32 {
    todo!("task 11.3: the root of a group")
}

/// Makes one group of the groups of `a` and `b`, two particles that may touch; they may be in one
/// already. The lesser root stays the root: so no parent is ever greater than its child.
///
/// Book: chapter 11, *Groups*.
#[inline]
pub fn join(parent: &mut [u32], a: u32, b: u32) {
    todo!("task 11.3b: two groups become one")
}
