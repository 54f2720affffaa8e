//! Shared data of threads that tests can observe, for the labs with threads (3 and 4).
//!
//! An error between threads needs a second thread at the wrong moment, which may not happen in a
//! thousand runs. So a test does not wait for the moment. It creates the moment, or shows that such
//! a moment exists:
//!
//! - [`Word`]: an atomic number. A test can insert [another thread's operation](Word::interrupted)
//!   between a load and the exchange that relies on it.
//! - [`Atomic`]: an atomic number whose operations have an ordering; [`fence`]; and [`Memory`], in
//!   which a test sees every reading that the orderings allow.
//! - [`Lock`]: a mutex with a number, whose uses are reported to a [`Watch`].
//! - [`LockOrder`]: a watch that finds a deadlock before it happens, from the order in which locks
//!   are taken.
//! - [`Stopwatch`]: a clock that counts its starts.
//!
//! # Example
//!
//! An update is lost if another update comes between its load and its exchange. The word reports
//! the loss:
//!
//! ```
//! use std::sync::atomic::Ordering;
//!
//! use common_threads::Word;
//!
//! let word = Word::new(1).interrupted(|word| word.store(5, Ordering::Relaxed));
//! let before = word.load();
//! assert_eq!(word.compare_exchange(before, before + 1), Err(5));
//! ```
//!
//! # Errors
//!
//! A [`LockOrder`] panics on the thread that takes locks in an order that can end in a deadlock. A
//! [`Memory`] panics on a reading thread that waits or writes. Nothing else here fails.

mod atomic;
mod fence;
mod lock;
mod lock_order;
mod memory;
mod stopwatch;
mod word;

pub use atomic::Atomic;
pub use fence::fence;
pub use lock::{Guard, Lock, Watch};
pub use lock_order::LockOrder;
pub use memory::Memory;
pub use stopwatch::Stopwatch;
pub use word::Word;
