//! Measuring programs, judging the measurements, and showing them.
//!
//! A command names [programs](subject), a [scene] of discs by its [options](scene_options), and a quantity that [varies](over). These make
//! [jobs](job), which a [runner] runs. How many steps each gets is [fitted](fit) to the time, and they take turns
//! in an [experiment]: its [timings](experiment::Timing) hold the [times](clock) and counters. They are
//! shown as a table of [columns], a [chart] and [numbers] in a file, with the grade of the [autograder], the streaming
//! bound of the [yardstick](lab_machine::streaming) and the numbers that the course reports [published] beside them. Grading
//! judges its own times by the same rules. Events that no clock shows are counted by [cachegrind];
//! the least times by these counts are a program's [bounds].

pub mod autograder;
pub mod bounds;
pub mod cachegrind;
pub mod chart;
pub mod clock;
pub mod columns;
pub mod commands;
pub mod cs3210;
pub mod experiment;
pub mod fit;
pub mod job;
pub mod numbers;
pub mod over;
pub mod published;
pub mod runner;
pub mod scene;
pub mod scene_options;
pub mod subject;
