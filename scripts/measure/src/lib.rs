//! Timing programs, judging the times, and showing them.
//!
//! A command names [programs](program), may ask which [variants](variants) they have, and names a
//! scene of [discs](discs). It makes [jobs](job) of them with a certain [effort](effort), has these
//! [take turns](rounds), and shows what the [clock](clock) says as a [table](table), a
//! [chart](chart) and a [record](record), with the grade of the [rubric](rubric), the streaming
//! bound of the [yardstick](oracle::yardstick) and what the course reports [published](published) beside it.

pub mod chart;
pub mod clock;
pub mod commands;
pub mod discs;
pub mod effort;
pub mod job;
pub mod published;
pub mod record;
pub mod rounds;
pub mod rubric;
pub mod scene_file;
pub mod steps;
pub mod subject;
pub mod variants;
