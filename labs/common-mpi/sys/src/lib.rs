//! MPI's functions, types and constants, under the names by which the package `mpi` calls them.
//!
//! It takes the place of the registry's `mpi-sys` (`[patch.crates-io]` in the top manifest), which does not
//! compile without an MPI library. This one does: labs with ranks can be written, and checked by an editor or
//! `cargo check`, on a machine that has only Rust. A program that comes to a call of MPI there says what is
//! missing, and ends.
//!
//! Its version is that of the package whose place it takes. When `mpi` wants a newer one, cargo says that the patch is
//! not used, and the version here goes up with it.

#![allow(non_camel_case_types, non_snake_case, non_upper_case_globals)]

#[cfg(no_mpi)]
mod absent;
#[cfg(no_mpi)]
pub use absent::*;

#[cfg(not(no_mpi))]
#[allow(clippy::all)]
mod library {
    include!(concat!(env!("OUT_DIR"), "/library.rs"));
}
#[cfg(not(no_mpi))]
pub use library::*;
