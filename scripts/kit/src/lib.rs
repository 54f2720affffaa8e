//! Shared parts of the `cargo lab` commands.
//!
//! [`Kit`] has the paths of the kit, and [`Facts`] describes a [`Lab`]. [`answers`] reads the tasks
//! in a solution, and [`starter`] makes a starter from a solution. [`task_list`], [`wrong`], [`quiz`]
//! and [`rubric`] read the files beside the solution. [`given`] selects the files of a submission
//! that are built. [`harness`] runs a lab's tests and [`binaries`] its programs, each in a separate
//! [`process`]. [`cargo`] shows the progress of builds, and [`fresh`] ensures that builds are made
//! from the current sources. [`command`] starts and ends every command of the kit in the same way.

pub mod answers;
pub mod binaries;
pub mod cargo;
pub mod command;
pub mod escape;
pub mod excerpt;
pub mod facts;
pub mod files;
pub mod fresh;
pub mod given;
pub mod harness;
pub mod kit;
pub mod lab;
pub mod machine;
pub mod process;
pub mod program;
pub mod progress;
pub mod quiz;
pub mod rubric;
pub mod sources;
pub mod starter;
pub mod system;
pub mod table;
pub mod task_list;
pub mod terminal;
pub mod wrong;

pub use facts::{Discs, Facts, Workers};
pub use files::{files_below, sources_below};
pub use given::Given;
pub use kit::Kit;
pub use lab::Lab;
