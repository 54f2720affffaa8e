//! What threads do and have, moment by moment: the runs that chapters 3 and 4 step through.
//!
//! Each runs functions of the solutions on threads of their own, and is a snapshot that the book
//! includes. Where a thread could be quick or slow, a recording lets one of them wait, so that it is
//! the same in every run. (The runs of chapters 5 and 6 are with the graders, in tests/lab5.rs and
//! tests/lab6.rs.)

mod barriers;
mod buffers;
mod eight;
mod locks;
mod race;
