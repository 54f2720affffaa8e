//! The groups of particles, by union-find.
//!
//! Particles are numbered from 0. Each number has a parent, which is in the same group and is never a
//! greater number. The least number of a group is its root, and the root is its own parent. At first,
//! each particle is a group of its own.

/// Returns the root of the group of number `k`: follow the parents until a number is its own parent.
///
/// On the way, make the grandparent of each number that you visit its new parent, and visit this
/// grandparent next. The number stays in its group, and the path is half as long for the next
/// search.
///
/// Book: chapter 11, *Groups*.
#[inline]
pub fn root(parent: &mut [u32], k: u32) -> u32 {
    // task 11.3: the root of a group
    let mut k = k;
    while parent[k as usize] != k {
        parent[k as usize] = parent[parent[k as usize] as usize];
        k = parent[k as usize];
    }
    k
    // end 11.3
}

/// Joins the groups of `a` and `b`, two particles that may touch.
///
/// The two may be in the same group already. The lesser root becomes the root of the joined group, so that
/// no parent is ever greater than its child.
///
/// Book: chapter 11, *Groups*.
#[inline]
pub fn join(parent: &mut [u32], a: u32, b: u32) {
    // task 11.3b: two groups become one
    let (a, b) = (root(parent, a), root(parent, b));
    parent[a.max(b) as usize] = a.min(b);
    // end 11.3b
}
