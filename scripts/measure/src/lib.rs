//! Timing programs, judging the times, and showing them.
//!
//! A command names [programs](subject), a [scene] of discs, and what varies along an [axis]. These make
//! [jobs](job), which a [runner] runs. How many steps each gets is [fitted](fit) to the time, and they take turns
//! in an [experiment]: its [records](experiment::Record) hold the [times](clock) and what was counted. They are
//! shown as a table, told by its columns, a [chart] and [files], with the grade of the [rubric], the streaming
//! bound of the [yardstick](lab_machine::streaming) and what the course reports [published] beside them. Grading
//! judges its own times with the same rubric. What no clock says is counted by [cachegrind];
//! what the machine allows at best by these counts are its [limits].

pub mod axis;
pub mod cachegrind;
pub mod chart;
pub mod clock;
pub mod columns;
pub mod commands;
pub mod experiment;
pub mod files;
pub mod fit;
pub mod job;
pub mod limits;
pub mod published;
pub mod rubric;
pub mod runner;
pub mod scene;
pub mod subject;
