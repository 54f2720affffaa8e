//! The actions and data of threads, moment by moment: the runs of chapters 3 and 4.
//!
//! Each run executes functions of the solutions on separate threads, and is a snapshot that the
//! book includes. Where a thread could be fast or slow, a recording delays one thread, so that
//! every run is the same. (The runs of chapters 5 and 6 are in tests/lab5.rs and tests/lab6.rs.)

mod barriers;
mod buffers;
mod eight;
mod locks;
mod race;
