//! What every part of the `cargo lab` command needs.
//!
//! [`Kit`] knows where things are, [`Facts`] what a [`Lab`] says about itself. [`answers`] reads the tasks
//! in a solution and [`starter`] makes a starter of it; [`hints`], [`wrong`], [`quiz`] and [`rubric`]
//! read what is written beside it. [`given`] says what of a submission is built. [`harness`] runs a lab's tests,
//! [`binaries`] are its programs, both in a [`process`] of their own; [`cargo`] shows what it builds, and [`fresh`] builds
//! of the sources as they are now. A [`command`] of the kit begins and ends alike, wherever it is.

pub mod answers;
pub mod binaries;
pub mod cargo;
pub mod command;
pub mod excerpt;
pub mod facts;
pub mod files;
pub mod fresh;
pub mod given;
pub mod harness;
pub mod hints;
pub mod kit;
pub mod lab;
pub mod machine;
pub mod page;
pub mod process;
pub mod program;
pub mod progress;
pub mod quiz;
pub mod rubric;
pub mod starter;
pub mod submission;
pub mod system;
pub mod table;
pub mod wrong;

pub use facts::{Discs, Facts, Workers};
pub use files::{files_below, sources_below};
pub use given::Given;
pub use kit::Kit;
pub use lab::Lab;
