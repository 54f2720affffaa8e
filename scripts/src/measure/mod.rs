//! Timing programs, judging the times, and showing them.
//!
//! A command names [programs](program), may ask which [variants](variants) they have, and names a
//! scene of [discs](discs). It makes [jobs](job) of them with a certain [effort](effort), has these
//! [take turns](rounds), and shows what the [clock](clock) says as a [table](table), a
//! [chart](chart) and a [record](record), with the grade of the [rubric](rubric), the streaming
//! bound of the [yardstick](oracle::yardstick) and what the course reports [published](published) beside it.

pub(crate) mod chart;
pub(crate) mod clock;
pub(crate) mod discs;
pub(crate) mod effort;
pub(crate) mod job;
pub(crate) mod program;
pub(crate) mod published;
pub(crate) mod record;
pub(crate) mod rounds;
pub(crate) mod rubric;
pub(crate) mod scene_file;
pub(crate) mod steps;
pub(crate) mod subject;
pub(crate) mod table;
pub(crate) mod variants;
