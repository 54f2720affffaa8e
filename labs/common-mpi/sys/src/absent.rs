//! The types, constants and functions of MPI that the package `mpi` uses, for machines without an MPI
//! library. They are for the compiler only. The signatures follow the standard; the values have no
//! meaning, because no call returns.

use std::ffi::{c_char, c_int, c_void};
use std::io::{self, Write};
use std::process;

type Int = c_int;
type Ints = *const c_int;
type OutInts = *mut c_int;
type In = *const c_void;
type Out = *mut c_void;

/// Ends the program. The line reaches the terminal in a test, too.
fn missing() -> ! {
    let line = "error: no MPI library was found when this program was compiled. scripts/setup.sh installs one";
    let _ = writeln!(io::stderr(), "{line}");
    process::exit(1)
}

macro_rules! handles {
    ($($name:ident)*) => { $(
        #[repr(transparent)]
        #[derive(Debug, Copy, Clone, PartialEq)]
        pub struct $name(pub c_int);
    )* };
}

handles! { MPI_Comm MPI_Datatype MPI_Group MPI_Info MPI_Message MPI_Op MPI_Request }

#[repr(C)]
#[derive(Debug, Copy, Clone, PartialEq)]
pub struct MPI_Status {
    pub MPI_SOURCE: c_int,
    pub MPI_TAG: c_int,
    pub MPI_ERROR: c_int,
}

pub type MPI_Aint = isize;
pub type MPI_User_function = Option<unsafe extern "C" fn(Out, Out, OutInts, *mut MPI_Datatype)>;
pub type MPI_Comm_copy_attr_function =
    Option<unsafe extern "C" fn(MPI_Comm, Int, Out, Out, Out, OutInts) -> Int>;
pub type MPI_Comm_delete_attr_function =
    Option<unsafe extern "C" fn(MPI_Comm, Int, Out, Out) -> Int>;

macro_rules! constants {
    ($($of:ident: $($name:ident)*;)*) => { $($(pub static $name: $of = $of(0);)*)* };
}
macro_rules! numbers {
    ($($name:ident)*) => { $(pub static $name: c_int = 0;)* };
}

constants! {
    MPI_Datatype: RSMPI_DATATYPE_NULL RSMPI_C_BOOL RSMPI_FLOAT RSMPI_DOUBLE RSMPI_INT8_T
        RSMPI_INT16_T RSMPI_INT32_T RSMPI_INT64_T RSMPI_UINT8_T RSMPI_UINT16_T RSMPI_UINT32_T
        RSMPI_UINT64_T;
    MPI_Comm: RSMPI_COMM_NULL RSMPI_COMM_SELF RSMPI_COMM_WORLD;
    MPI_Group: RSMPI_GROUP_NULL RSMPI_GROUP_EMPTY;
    MPI_Info: RSMPI_INFO_NULL;
    MPI_Message: RSMPI_MESSAGE_NULL RSMPI_MESSAGE_NO_PROC;
    MPI_Request: RSMPI_REQUEST_NULL;
    MPI_Op: RSMPI_MAX RSMPI_MIN RSMPI_SUM RSMPI_PROD RSMPI_LAND RSMPI_BAND RSMPI_LOR RSMPI_BOR
        RSMPI_LXOR RSMPI_BXOR;
}

numbers! {
    RSMPI_UNDEFINED RSMPI_PROC_NULL RSMPI_ANY_SOURCE RSMPI_ANY_TAG RSMPI_IDENT RSMPI_CONGRUENT
    RSMPI_SIMILAR RSMPI_UNEQUAL RSMPI_GRAPH RSMPI_CART RSMPI_DIST_GRAPH RSMPI_COMM_TYPE_SHARED
    RSMPI_THREAD_SINGLE RSMPI_THREAD_FUNNELED RSMPI_THREAD_SERIALIZED RSMPI_THREAD_MULTIPLE
    RSMPI_MAX_LIBRARY_VERSION_STRING RSMPI_MAX_PROCESSOR_NAME
}

// These are constants in every MPI library too.
pub const MPI_SUCCESS: c_int = 0;
pub const MPI_UNDEFINED: c_int = -1;
pub const MPI_UNIVERSE_SIZE: c_int = 0;
pub const MPI_APPNUM: c_int = 0;
pub const MPI_MAX_OBJECT_NAME: c_int = 64;
pub const RSMPI_STATUS_IGNORE: *mut MPI_Status = std::ptr::null_mut();

pub fn RSMPI_Wtime() -> f64 {
    missing()
}

pub fn RSMPI_Wtick() -> f64 {
    missing()
}

macro_rules! functions {
    ($($name:ident($($of:ty),*);)*) => { $(
        pub unsafe fn $name($(_: $of),*) -> c_int {
            missing()
        }
    )* };
}

functions! {
    MPI_Abort(MPI_Comm, Int);
    MPI_Allgather(In, Int, MPI_Datatype, Out, Int, MPI_Datatype, MPI_Comm);
    MPI_Allgatherv(In, Int, MPI_Datatype, Out, Ints, Ints, MPI_Datatype, MPI_Comm);
    MPI_Allreduce(In, Out, Int, MPI_Datatype, MPI_Op, MPI_Comm);
    MPI_Alltoall(In, Int, MPI_Datatype, Out, Int, MPI_Datatype, MPI_Comm);
    MPI_Alltoallv(In, Ints, Ints, MPI_Datatype, Out, Ints, Ints, MPI_Datatype, MPI_Comm);
    MPI_Barrier(MPI_Comm);
    MPI_Bcast(Out, Int, MPI_Datatype, Int, MPI_Comm);
    MPI_Bsend(In, Int, MPI_Datatype, Int, Int, MPI_Comm);
    MPI_Buffer_attach(Out, Int);
    MPI_Buffer_detach(Out, OutInts);
    MPI_Cancel(*mut MPI_Request);
    MPI_Cart_coords(MPI_Comm, Int, Int, OutInts);
    MPI_Cart_create(MPI_Comm, Int, Ints, Ints, Int, *mut MPI_Comm);
    MPI_Cart_get(MPI_Comm, Int, OutInts, OutInts, OutInts);
    MPI_Cart_map(MPI_Comm, Int, Ints, Ints, OutInts);
    MPI_Cart_rank(MPI_Comm, Ints, OutInts);
    MPI_Cart_shift(MPI_Comm, Int, Int, OutInts, OutInts);
    MPI_Cart_sub(MPI_Comm, Ints, *mut MPI_Comm);
    MPI_Cartdim_get(MPI_Comm, OutInts);
    MPI_Comm_compare(MPI_Comm, MPI_Comm, OutInts);
    MPI_Comm_create(MPI_Comm, MPI_Group, *mut MPI_Comm);
    MPI_Comm_create_group(MPI_Comm, MPI_Group, Int, *mut MPI_Comm);
    MPI_Comm_create_keyval(MPI_Comm_copy_attr_function, MPI_Comm_delete_attr_function, OutInts, Out);
    MPI_Comm_disconnect(*mut MPI_Comm);
    MPI_Comm_dup(MPI_Comm, *mut MPI_Comm);
    MPI_Comm_free(*mut MPI_Comm);
    MPI_Comm_free_keyval(OutInts);
    MPI_Comm_get_attr(MPI_Comm, Int, Out, OutInts);
    MPI_Comm_get_name(MPI_Comm, *mut c_char, OutInts);
    MPI_Comm_get_parent(*mut MPI_Comm);
    MPI_Comm_group(MPI_Comm, *mut MPI_Group);
    MPI_Comm_rank(MPI_Comm, OutInts);
    MPI_Comm_remote_group(MPI_Comm, *mut MPI_Group);
    MPI_Comm_remote_size(MPI_Comm, OutInts);
    MPI_Comm_set_attr(MPI_Comm, Int, Out);
    MPI_Comm_set_name(MPI_Comm, *const c_char);
    MPI_Comm_size(MPI_Comm, OutInts);
    MPI_Comm_spawn(*const c_char, *mut *mut c_char, Int, MPI_Info, Int, MPI_Comm, *mut MPI_Comm, OutInts);
    MPI_Comm_spawn_multiple(Int, *mut *mut c_char, *mut *mut *mut c_char, Ints, *const MPI_Info, Int, MPI_Comm, *mut MPI_Comm, OutInts);
    MPI_Comm_split(MPI_Comm, Int, Int, *mut MPI_Comm);
    MPI_Comm_split_type(MPI_Comm, Int, Int, MPI_Info, *mut MPI_Comm);
    MPI_Comm_test_inter(MPI_Comm, OutInts);
    MPI_Exscan(In, Out, Int, MPI_Datatype, MPI_Op, MPI_Comm);
    MPI_Finalize();
    MPI_Finalized(OutInts);
    MPI_Gather(In, Int, MPI_Datatype, Out, Int, MPI_Datatype, Int, MPI_Comm);
    MPI_Gatherv(In, Int, MPI_Datatype, Out, Ints, Ints, MPI_Datatype, Int, MPI_Comm);
    MPI_Get_address(In, *mut MPI_Aint);
    MPI_Get_count(*const MPI_Status, MPI_Datatype, OutInts);
    MPI_Get_library_version(*mut c_char, OutInts);
    MPI_Get_processor_name(*mut c_char, OutInts);
    MPI_Get_version(OutInts, OutInts);
    MPI_Group_compare(MPI_Group, MPI_Group, OutInts);
    MPI_Group_difference(MPI_Group, MPI_Group, *mut MPI_Group);
    MPI_Group_excl(MPI_Group, Int, Ints, *mut MPI_Group);
    MPI_Group_free(*mut MPI_Group);
    MPI_Group_incl(MPI_Group, Int, Ints, *mut MPI_Group);
    MPI_Group_intersection(MPI_Group, MPI_Group, *mut MPI_Group);
    MPI_Group_rank(MPI_Group, OutInts);
    MPI_Group_size(MPI_Group, OutInts);
    MPI_Group_translate_ranks(MPI_Group, Int, Ints, MPI_Group, OutInts);
    MPI_Group_union(MPI_Group, MPI_Group, *mut MPI_Group);
    MPI_Iallgather(In, Int, MPI_Datatype, Out, Int, MPI_Datatype, MPI_Comm, *mut MPI_Request);
    MPI_Iallgatherv(In, Int, MPI_Datatype, Out, Ints, Ints, MPI_Datatype, MPI_Comm, *mut MPI_Request);
    MPI_Iallreduce(In, Out, Int, MPI_Datatype, MPI_Op, MPI_Comm, *mut MPI_Request);
    MPI_Ialltoall(In, Int, MPI_Datatype, Out, Int, MPI_Datatype, MPI_Comm, *mut MPI_Request);
    MPI_Ialltoallv(In, Ints, Ints, MPI_Datatype, Out, Ints, Ints, MPI_Datatype, MPI_Comm, *mut MPI_Request);
    MPI_Ibarrier(MPI_Comm, *mut MPI_Request);
    MPI_Ibcast(Out, Int, MPI_Datatype, Int, MPI_Comm, *mut MPI_Request);
    MPI_Ibsend(In, Int, MPI_Datatype, Int, Int, MPI_Comm, *mut MPI_Request);
    MPI_Iexscan(In, Out, Int, MPI_Datatype, MPI_Op, MPI_Comm, *mut MPI_Request);
    MPI_Igather(In, Int, MPI_Datatype, Out, Int, MPI_Datatype, Int, MPI_Comm, *mut MPI_Request);
    MPI_Igatherv(In, Int, MPI_Datatype, Out, Ints, Ints, MPI_Datatype, Int, MPI_Comm, *mut MPI_Request);
    MPI_Improbe(Int, Int, MPI_Comm, OutInts, *mut MPI_Message, *mut MPI_Status);
    MPI_Imrecv(Out, Int, MPI_Datatype, *mut MPI_Message, *mut MPI_Request);
    MPI_Init(OutInts, *mut *mut *mut c_char);
    MPI_Init_thread(OutInts, *mut *mut *mut c_char, Int, OutInts);
    MPI_Initialized(OutInts);
    MPI_Intercomm_merge(MPI_Comm, Int, *mut MPI_Comm);
    MPI_Iprobe(Int, Int, MPI_Comm, OutInts, *mut MPI_Status);
    MPI_Irecv(Out, Int, MPI_Datatype, Int, Int, MPI_Comm, *mut MPI_Request);
    MPI_Ireduce(In, Out, Int, MPI_Datatype, MPI_Op, Int, MPI_Comm, *mut MPI_Request);
    MPI_Ireduce_scatter_block(In, Out, Int, MPI_Datatype, MPI_Op, MPI_Comm, *mut MPI_Request);
    MPI_Irsend(In, Int, MPI_Datatype, Int, Int, MPI_Comm, *mut MPI_Request);
    MPI_Iscan(In, Out, Int, MPI_Datatype, MPI_Op, MPI_Comm, *mut MPI_Request);
    MPI_Iscatter(In, Int, MPI_Datatype, Out, Int, MPI_Datatype, Int, MPI_Comm, *mut MPI_Request);
    MPI_Iscatterv(In, Ints, Ints, MPI_Datatype, Out, Int, MPI_Datatype, Int, MPI_Comm, *mut MPI_Request);
    MPI_Isend(In, Int, MPI_Datatype, Int, Int, MPI_Comm, *mut MPI_Request);
    MPI_Issend(In, Int, MPI_Datatype, Int, Int, MPI_Comm, *mut MPI_Request);
    MPI_Mprobe(Int, Int, MPI_Comm, *mut MPI_Message, *mut MPI_Status);
    MPI_Mrecv(Out, Int, MPI_Datatype, *mut MPI_Message, *mut MPI_Status);
    MPI_Op_commutative(MPI_Op, OutInts);
    MPI_Op_create(MPI_User_function, Int, *mut MPI_Op);
    MPI_Op_free(*mut MPI_Op);
    MPI_Pack(In, Int, MPI_Datatype, Out, Int, OutInts, MPI_Comm);
    MPI_Pack_size(Int, MPI_Datatype, MPI_Comm, OutInts);
    MPI_Probe(Int, Int, MPI_Comm, *mut MPI_Status);
    MPI_Query_thread(OutInts);
    MPI_Recv(Out, Int, MPI_Datatype, Int, Int, MPI_Comm, *mut MPI_Status);
    MPI_Reduce(In, Out, Int, MPI_Datatype, MPI_Op, Int, MPI_Comm);
    MPI_Reduce_local(In, Out, Int, MPI_Datatype, MPI_Op);
    MPI_Reduce_scatter_block(In, Out, Int, MPI_Datatype, MPI_Op, MPI_Comm);
    MPI_Rsend(In, Int, MPI_Datatype, Int, Int, MPI_Comm);
    MPI_Scan(In, Out, Int, MPI_Datatype, MPI_Op, MPI_Comm);
    MPI_Scatter(In, Int, MPI_Datatype, Out, Int, MPI_Datatype, Int, MPI_Comm);
    MPI_Scatterv(In, Ints, Ints, MPI_Datatype, Out, Int, MPI_Datatype, Int, MPI_Comm);
    MPI_Send(In, Int, MPI_Datatype, Int, Int, MPI_Comm);
    MPI_Sendrecv(In, Int, MPI_Datatype, Int, Int, Out, Int, MPI_Datatype, Int, Int, MPI_Comm, *mut MPI_Status);
    MPI_Sendrecv_replace(Out, Int, MPI_Datatype, Int, Int, Int, Int, MPI_Comm, *mut MPI_Status);
    MPI_Ssend(In, Int, MPI_Datatype, Int, Int, MPI_Comm);
    MPI_Test(*mut MPI_Request, OutInts, *mut MPI_Status);
    MPI_Testall(Int, *mut MPI_Request, OutInts, *mut MPI_Status);
    MPI_Testany(Int, *mut MPI_Request, OutInts, OutInts, *mut MPI_Status);
    MPI_Testsome(Int, *mut MPI_Request, OutInts, OutInts, *mut MPI_Status);
    MPI_Topo_test(MPI_Comm, OutInts);
    MPI_Type_commit(*mut MPI_Datatype);
    MPI_Type_contiguous(Int, MPI_Datatype, *mut MPI_Datatype);
    MPI_Type_create_hindexed(Int, Ints, *const MPI_Aint, MPI_Datatype, *mut MPI_Datatype);
    MPI_Type_create_hindexed_block(Int, Int, *const MPI_Aint, MPI_Datatype, *mut MPI_Datatype);
    MPI_Type_create_hvector(Int, Int, MPI_Aint, MPI_Datatype, *mut MPI_Datatype);
    MPI_Type_create_indexed_block(Int, Int, Ints, MPI_Datatype, *mut MPI_Datatype);
    MPI_Type_create_struct(Int, Ints, *const MPI_Aint, *const MPI_Datatype, *mut MPI_Datatype);
    MPI_Type_dup(MPI_Datatype, *mut MPI_Datatype);
    MPI_Type_free(*mut MPI_Datatype);
    MPI_Type_indexed(Int, Ints, Ints, MPI_Datatype, *mut MPI_Datatype);
    MPI_Type_size(MPI_Datatype, OutInts);
    MPI_Type_vector(Int, Int, Int, MPI_Datatype, *mut MPI_Datatype);
    MPI_Unpack(In, Int, OutInts, Out, Int, MPI_Datatype, MPI_Comm);
    MPI_Wait(*mut MPI_Request, *mut MPI_Status);
    MPI_Waitall(Int, *mut MPI_Request, *mut MPI_Status);
    MPI_Waitany(Int, *mut MPI_Request, OutInts, *mut MPI_Status);
    MPI_Waitsome(Int, *mut MPI_Request, OutInts, OutInts, *mut MPI_Status);
}
