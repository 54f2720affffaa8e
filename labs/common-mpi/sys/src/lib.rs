//! MPI's functions, types and constants, under the names by which the package `mpi` calls them.
//!
//! It replaces the registry's `mpi-sys` (`[patch.crates-io]` in the top manifest), which does not
//! compile without an MPI library. This one does: labs with ranks can be written, and checked by an editor or
//! `cargo check`, on a machine that has only Rust. A program that comes to a call of MPI there says what is
//! missing, and ends.
//!
//! Its version is that of the package that it replaces. When `mpi` wants a newer one, cargo says that the patch is
//! not used, and the version here goes up with it.

#![allow(non_camel_case_types, non_snake_case, non_upper_case_globals)]

#[cfg(no_mpi)]
#[path = "absent.rs"]
mod library;
#[cfg(not(no_mpi))]
#[allow(clippy::all)]
mod library {
    include!(concat!(env!("OUT_DIR"), "/library.rs"));
}
#[allow(clippy::missing_safety_doc, clippy::too_many_arguments, unused_unsafe)]
mod told;

pub use library::*;
// These stand before the library's of the same names.
pub use told::{
    Call, MPI_Allgather, MPI_Allgatherv, MPI_Allreduce, MPI_Alltoall, MPI_Alltoallv, MPI_Barrier,
    MPI_Bcast, MPI_Finalize, MPI_Gather, MPI_Gatherv, MPI_Irecv, MPI_Isend, MPI_Issend, MPI_Mprobe,
    MPI_Probe, MPI_Recv, MPI_Reduce, MPI_Scan, MPI_Scatter, MPI_Scatterv, MPI_Send, MPI_Sendrecv,
    MPI_Ssend, MPI_Wait, MPI_Waitall, MPI_Waitany, MPI_Waitsome, share, watch,
};
