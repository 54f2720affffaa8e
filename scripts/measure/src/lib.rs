//! Measures programs, judges the measurements, and shows them.
//!
//! A measurement goes through these modules:
//!
//! 1. A command names programs (`subject`), a [scene] of discs by its options (`scene_options`),
//!    and a quantity that varies (`over`). These make [jobs](job).
//! 2. The number of steps of each job is fitted to the time (`fit`).
//! 3. The jobs take turns in an [experiment], which uses a [runner]. The results are [times](clock)
//!    and counters (`Timing`).
//! 4. The results are printed as a table of [columns], drawn as a [chart], and written as [numbers]
//!    to a file. They include the grade of the [autograder], the [streaming
//!    bound](lab_machine::streaming), and the numbers that the course reports [published].
//!
//! The grader judges its times by the same rules. `cachegrind` counts events that do not show in
//! times; these counts give the least times of a program, its `bounds`.

pub mod autograder;
mod bounds;
mod cachegrind;
pub mod chart;
pub mod clock;
pub mod columns;
pub mod commands;
mod cs3210;
pub mod experiment;
mod fit;
pub mod job;
pub mod numbers;
mod over;
pub mod published;
pub mod runner;
pub mod scene;
mod scene_options;
mod subject;
