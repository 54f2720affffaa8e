//! MPI's functions, types and constants, under the names by which the package `mpi` calls them.
//!
//! This package replaces the registry's `mpi-sys` (`[patch.crates-io]` in the top manifest), which does
//! not compile without an MPI library. This package does compile, so labs with ranks can be written, and
//! checked by an editor or `cargo check`, on a machine that has only Rust. A program that calls MPI
//! there prints what is missing, and ends.
//!
//! Its version equals the version of the package that it replaces. If `mpi` needs a newer version,
//! cargo reports that the patch is not used. Then raise the version here.

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
mod intercepted;

pub use library::*;
// These take precedence over the library's functions of the same names.
pub use intercepted::{
    Call, MPI_Allgather, MPI_Allgatherv, MPI_Allreduce, MPI_Alltoall, MPI_Alltoallv, MPI_Barrier,
    MPI_Bcast, MPI_Finalize, MPI_Gather, MPI_Gatherv, MPI_Irecv, MPI_Isend, MPI_Issend, MPI_Mprobe,
    MPI_Probe, MPI_Recv, MPI_Reduce, MPI_Scan, MPI_Scatter, MPI_Scatterv, MPI_Send, MPI_Sendrecv,
    MPI_Ssend, MPI_Test, MPI_Testall, MPI_Testany, MPI_Testsome, MPI_Wait, MPI_Waitall,
    MPI_Waitany, MPI_Waitsome, share, watch,
};
