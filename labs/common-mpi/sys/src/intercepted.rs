//! MPI calls that are reported to a watch before they are made.
//!
//! The package `mpi` finds these functions under the library's names, and each function calls the
//! library's function. MPI's own *profiling interface*, `PMPI`, works in the same way with a second set
//! of names, where this file uses Rust's modules.

use std::ffi::{c_int, c_void};
use std::sync::OnceLock;

use crate::library::{self, *};

/// The properties of a call that must agree with the calls of other ranks.
#[derive(Clone, Debug)]
pub struct Call {
    /// Name in the standard, such as `MPI_Gather`.
    pub name: &'static str,
    /// Whether all ranks make the call together.
    pub is_collective: bool,
    /// The root; -1 if the call has none.
    pub root: c_int,
    /// Operation of a reduction, such as `sum`. `None` for an operation that the program defines.
    pub operation: Option<&'static str>,
    /// The rank that this rank sends to or receives from, and the message's tag.
    pub other: Option<[c_int; 2]>,
    /// Number of items that this rank sends or has room for, and the bytes of an item.
    pub items: [i64; 2],
    /// Whether `items` must be the same on all ranks.
    pub is_uniform: bool,
    /// `items` for each rank, on a root that scatters or gathers.
    pub of_each: Vec<[i64; 2]>,
}

/// A function that is called with a call before it is made, and with `None` when the call is over.
type Watch = fn(Option<&Call>);

static WATCH: OnceLock<Watch> = OnceLock::new();

/// A second communicator of all ranks, for messages between watches.
static WATCHES: OnceLock<Ranks> = OnceLock::new();

struct Ranks(MPI_Comm);

// SAFETY: a handle is a number, or an address that only the library uses, and all calls of a rank come
// from one thread.
unsafe impl Send for Ranks {}
// SAFETY: as for `Send`.
unsafe impl Sync for Ranks {}

/// Reports all calls of this rank to `watch` from now on. All ranks call it together, while MPI runs.
pub fn watch(watch: Watch) {
    let mut watches = unsafe { RSMPI_COMM_NULL };
    unsafe { library::MPI_Comm_dup(RSMPI_COMM_WORLD, &raw mut watches) };
    let _ = WATCHES.set(Ranks(watches));
    let _ = WATCH.set(watch);
}

/// Returns the `own` numbers of all ranks, in the order of ranks. All ranks call it together, after
/// [`watch`].
pub fn share<const N: usize>(own: [i64; N]) -> Vec<[i64; N]> {
    let Some(Ranks(watches)) = WATCHES.get() else { return vec![own] };
    let mut all = vec![[0; N]; size_of_comm(*watches)];
    let (from, to) = (own.as_ptr().cast::<c_void>(), all.as_mut_ptr().cast::<c_void>());
    let count = N as c_int;
    // SAFETY: `all` has room for N numbers from each rank.
    unsafe {
        library::MPI_Allgather(from, count, RSMPI_INT64_T, to, count, RSMPI_INT64_T, *watches);
    }
    all
}

fn size_of_comm(comm: MPI_Comm) -> usize {
    let mut size = 0;
    // SAFETY: the function writes one number.
    unsafe { library::MPI_Comm_size(comm, &raw mut size) };
    size as usize
}

/// Returns a call that some ranks make.
fn between(name: &'static str) -> Call {
    Call {
        name,
        is_collective: false,
        root: -1,
        operation: None,
        other: None,
        items: [0, 1],
        is_uniform: false,
        of_each: Vec::new(),
    }
}

/// Returns a call of all ranks of `comm`. Calls that do not involve all ranks are not compared.
fn all(name: &'static str, comm: MPI_Comm) -> Call {
    Call { is_collective: comm == unsafe { RSMPI_COMM_WORLD }, ..between(name) }
}

impl Call {
    fn other(self, rank: c_int, tag: c_int) -> Self {
        Self { other: Some([rank, tag]), ..self }
    }

    fn root(self, root: c_int) -> Self {
        Self { root, ..self }
    }

    fn by(self, operation: MPI_Op) -> Self {
        // SAFETY: the library's constants do not change.
        let known = unsafe { [(RSMPI_SUM, "sum"), (RSMPI_MAX, "maximum"), (RSMPI_MIN, "minimum")] };
        let operation = known.iter().find(|(known, _)| *known == operation).map(|(_, name)| *name);
        Self { operation, ..self }
    }

    fn items(self, count: c_int, of: MPI_Datatype) -> Self {
        Self { items: items(count, of), ..self }
    }

    fn uniform(self, count: c_int, of: MPI_Datatype) -> Self {
        Self { is_uniform: true, ..self.items(count, of) }
    }

    /// On the root: `count` items for each rank.
    fn each(self, comm: MPI_Comm, count: c_int, of: MPI_Datatype) -> Self {
        let ranks = if self.is_root(comm) { size_of_comm(comm) } else { 0 };
        Self { of_each: vec![items(count, of); ranks], ..self }
    }

    /// On the root: a separate number of items for each rank.
    unsafe fn each_of(self, comm: MPI_Comm, counts: *const c_int, of: MPI_Datatype) -> Self {
        if !self.is_root(comm) {
            return self;
        }
        // SAFETY: by the standard, the root passes a count for each rank.
        let counts = unsafe { std::slice::from_raw_parts(counts, size_of_comm(comm)) };
        Self { of_each: counts.iter().map(|count| items(*count, of)).collect(), ..self }
    }

    fn is_root(&self, comm: MPI_Comm) -> bool {
        let mut rank = 0;
        // SAFETY: the function writes one number.
        unsafe { library::MPI_Comm_rank(comm, &raw mut rank) };
        rank == self.root
    }
}

fn items(count: c_int, of: MPI_Datatype) -> [i64; 2] {
    let mut size = 0;
    // SAFETY: the function writes one number.
    unsafe { library::MPI_Type_size(of, &raw mut size) };
    [count.into(), size.into()]
}

macro_rules! intercepted {
    ($($name:ident($($argument:ident: $of:ty),*) = $call:expr;)*) => { $(
        pub unsafe fn $name($($argument: $of),*) -> c_int {
            let Some(watch) = WATCH.get() else { return unsafe { library::$name($($argument),*) } };
            watch(Some(&$call));
            let code = unsafe { library::$name($($argument),*) };
            watch(None);
            code
        }
    )* };
}

type Int = c_int;
type In = *const c_void;
type Out = *mut c_void;
type Ints = *const c_int;
type Type = MPI_Datatype;
type Comm = MPI_Comm;

intercepted! {
    MPI_Barrier(comm: Comm) = all("MPI_Barrier", comm);
    MPI_Bcast(buffer: Out, count: Int, of: Type, root: Int, comm: Comm)
        = all("MPI_Bcast", comm).root(root).uniform(count, of);
    MPI_Gather(from: In, sent: Int, of: Type, to: Out, room: Int, as_of: Type, root: Int, comm: Comm)
        = all("MPI_Gather", comm).root(root).items(sent, of).each(comm, room, as_of);
    MPI_Gatherv(from: In, sent: Int, of: Type, to: Out, room: Ints, starts: Ints, as_of: Type, root: Int, comm: Comm)
        = unsafe { all("MPI_Gatherv", comm).root(root).items(sent, of).each_of(comm, room, as_of) };
    MPI_Scatter(from: In, sent: Int, of: Type, to: Out, room: Int, as_of: Type, root: Int, comm: Comm)
        = all("MPI_Scatter", comm).root(root).items(room, as_of).each(comm, sent, of);
    MPI_Scatterv(from: In, sent: Ints, starts: Ints, of: Type, to: Out, room: Int, as_of: Type, root: Int, comm: Comm)
        = unsafe { all("MPI_Scatterv", comm).root(root).items(room, as_of).each_of(comm, sent, of) };
    MPI_Allgather(from: In, sent: Int, of: Type, to: Out, room: Int, as_of: Type, comm: Comm)
        = all("MPI_Allgather", comm).uniform(sent, of);
    MPI_Allgatherv(from: In, sent: Int, of: Type, to: Out, room: Ints, starts: Ints, as_of: Type, comm: Comm)
        = all("MPI_Allgatherv", comm);
    MPI_Alltoall(from: In, sent: Int, of: Type, to: Out, room: Int, as_of: Type, comm: Comm)
        = all("MPI_Alltoall", comm).uniform(sent, of);
    MPI_Alltoallv(from: In, sent: Ints, sent_from: Ints, of: Type, to: Out, room: Ints, starts: Ints, as_of: Type, comm: Comm)
        = all("MPI_Alltoallv", comm);
    MPI_Reduce(from: In, to: Out, count: Int, of: Type, by: MPI_Op, root: Int, comm: Comm)
        = all("MPI_Reduce", comm).by(by).root(root).uniform(count, of);
    MPI_Allreduce(from: In, to: Out, count: Int, of: Type, by: MPI_Op, comm: Comm)
        = all("MPI_Allreduce", comm).by(by).uniform(count, of);
    MPI_Scan(from: In, to: Out, count: Int, of: Type, by: MPI_Op, comm: Comm)
        = all("MPI_Scan", comm).by(by).uniform(count, of);
    MPI_Finalize() = all("MPI_Finalize", unsafe { RSMPI_COMM_WORLD });
    MPI_Send(from: In, count: Int, of: Type, to: Int, tag: Int, comm: Comm) = between("MPI_Send").other(to, tag);
    MPI_Ssend(from: In, count: Int, of: Type, to: Int, tag: Int, comm: Comm) = between("MPI_Ssend").other(to, tag);
    MPI_Recv(into: Out, count: Int, of: Type, from: Int, tag: Int, comm: Comm, status: *mut MPI_Status)
        = between("MPI_Recv").other(from, tag);
    MPI_Sendrecv(
        from: In, sent: Int, of: Type, dest: Int, tag: Int,
        into: Out, room: Int, as_of: Type, source: Int, their_tag: Int, comm: Comm, status: *mut MPI_Status
    ) = between("MPI_Sendrecv").other(dest, tag);
    MPI_Probe(from: Int, tag: Int, comm: Comm, status: *mut MPI_Status) = between("MPI_Probe").other(from, tag);
    MPI_Mprobe(from: Int, tag: Int, comm: Comm, message: *mut MPI_Message, status: *mut MPI_Status)
        = between("MPI_Mprobe").other(from, tag);
    MPI_Isend(from: In, count: Int, of: Type, to: Int, tag: Int, comm: Comm, request: *mut MPI_Request)
        = between("MPI_Isend").other(to, tag);
    MPI_Issend(from: In, count: Int, of: Type, to: Int, tag: Int, comm: Comm, request: *mut MPI_Request)
        = between("MPI_Issend").other(to, tag);
    MPI_Irecv(into: Out, count: Int, of: Type, from: Int, tag: Int, comm: Comm, request: *mut MPI_Request)
        = between("MPI_Irecv").other(from, tag);
    MPI_Wait(request: *mut MPI_Request, status: *mut MPI_Status) = between("MPI_Wait");
    MPI_Waitall(count: Int, requests: *mut MPI_Request, status: *mut MPI_Status)
        = between("MPI_Waitall");
    MPI_Waitany(count: Int, requests: *mut MPI_Request, index: *mut Int, status: *mut MPI_Status)
        = between("MPI_Waitany");
    MPI_Waitsome(count: Int, requests: *mut MPI_Request, over: *mut Int, indices: *mut Int, status: *mut MPI_Status)
        = between("MPI_Waitsome");
    MPI_Test(request: *mut MPI_Request, is_over: *mut Int, status: *mut MPI_Status) = between("MPI_Test");
    MPI_Testall(count: Int, requests: *mut MPI_Request, are_over: *mut Int, status: *mut MPI_Status)
        = between("MPI_Testall");
    MPI_Testany(
        count: Int, requests: *mut MPI_Request, index: *mut Int, is_over: *mut Int, status: *mut MPI_Status
    ) = between("MPI_Testany");
    MPI_Testsome(count: Int, requests: *mut MPI_Request, over: *mut Int, indices: *mut Int, status: *mut MPI_Status)
        = between("MPI_Testsome");
}
