//! `cargo lab timeline`: the activities of each rank in a step.

use anyhow::{Context, Result, ensure};
use clap::Args;
use common::{Activity, Event};
use serde::{Deserialize, Serialize};

use crate::chart::{Axis, Chart, Sheet};
use crate::clock::Times;
use crate::job::Job;
use crate::numbers::Files;
use crate::scene_options::OneScene;
use crate::subject::Subject;
use lab_kit::Kit;
use lab_kit::program::Program;
use lab_kit::table::{Table, three_digits};

/// Show when each rank computes, communicates and waits in a step
///
/// In a call of other ranks, a rank waits until the last of its partners has entered the same call,
/// and communicates for the rest of the call. The drawing shows the most typical step of one run:
/// the step that is nearest to the medians of all ranks' activities. The table shows means over all
/// steps.
#[derive(Args)]
pub struct Options {
    #[command(flatten)]
    subject: Subject,
    #[command(flatten)]
    scene: OneScene,
    /// Number of ranks
    #[arg(long, default_value_t = 2, value_name = "RANKS", value_parser = clap::value_parser!(u16).range(1..))]
    ranks: u16,
    /// Number of time steps
    #[arg(long, default_value_t = 20, value_name = "STEPS", value_parser = clap::value_parser!(u64).range(1..))]
    steps: u64,
    #[command(flatten)]
    pub(super) files: Files,
}

/// A run, and the step that is drawn.
#[derive(Deserialize, Serialize)]
pub(super) struct Timeline {
    program: Program,
    n: usize,
    steps: u64,
    /// Milliseconds of a step in which each rank computes, communicates and waits.
    ms_per_step: Vec<[f64; 3]>,
    /// Number of the step that is drawn.
    step: u32,
    /// Activities in this step.
    stretches: Vec<Stretch>,
}

/// A period with one activity of a rank.
#[derive(Deserialize, Serialize)]
struct Stretch {
    rank: usize,
    activity: String,
    /// Milliseconds from the start of the step.
    begin: f64,
    end: f64,
}

impl Options {
    pub(super) fn draw(&self, timelines: Vec<Timeline>) -> Result<Sheet> {
        Ok(timelines.iter().map(|timeline| vec![timeline.chart()]).collect())
    }
}

pub(super) fn run(kit: &Kit, options: Options) -> Result<()> {
    let package = options.subject.package()?;
    ensure!(package.has_ranks(), "lab {} has no ranks", package.lab);
    let (runner, programs) = options.subject.build(kit, &[], false)?;
    let mut timelines = Vec::new();
    for program in programs {
        let scene = options.scene.scene(program.is_hard())?;
        let job = Job {
            steps: options.steps,
            workers: options.ranks.into(),
            events: true,
            ..Job::new(program.clone(), scene)
        };
        let events = runner.run(&job)?.events;
        let timeline =
            Timeline::of(&job, &events).with_context(|| format!("{program} recorded no step"))?;
        println!("{timeline}");
        timelines.push(timeline);
    }
    options.files.write(&timelines, |shown| options.draw(shown))
}

impl Timeline {
    fn of(job: &Job, events: &[Event]) -> Option<Self> {
        let ranks = events.iter().map(|event| event.rank as usize + 1).max()?;
        let mut ms = vec![vec![[0.0; 3]; ranks]; job.steps as usize];
        let mut ms_per_step = vec![[0.0; 3]; ranks];
        for Event { rank, step, activity, begin, end } in events {
            let [rank, activity] = [*rank as usize, *activity as usize];
            let took = 1e3 * (end - begin);
            ms.get_mut(*step as usize)?[rank][activity] += took;
            ms_per_step[rank][activity] += took / job.steps as f64;
        }
        let step = typical(&ms)?;
        let mut drawn: Vec<&Event> = events.iter().collect();
        drawn.retain(|event| event.step == step);
        let start = drawn.iter().map(|event| event.begin).fold(f64::INFINITY, f64::min);
        let stretches = drawn.into_iter().map(|event| Stretch {
            rank: event.rank as usize,
            activity: event.activity.name().into(),
            begin: 1e3 * (event.begin - start),
            end: 1e3 * (event.end - start),
        });
        Some(Self {
            program: job.program.clone(),
            n: job.scene.n(),
            steps: job.steps,
            ms_per_step,
            step,
            stretches: stretches.collect(),
        })
    }

    fn chart(&self) -> Chart {
        let parts = Activity::ALL.map(Activity::name).map(|name| {
            let of_it = self.stretches.iter().filter(|stretch| stretch.activity == name);
            (name, of_it.map(|s| (s.rank, s.begin, s.end)).collect())
        });
        let names = (0..self.ms_per_step.len()).map(|rank| format!("rank {rank}")).collect();
        let title = format!("{}, n = {}, step {}", self.program, self.n, self.step);
        let x = Axis::linear("ms from the start of the step").starting_at(0.0);
        Chart::lanes(title, x, names, parts)
    }

    /// Returns the milliseconds of the step that is drawn.
    fn length(&self) -> f64 {
        self.stretches.iter().map(|stretch| stretch.end).fold(0.0, f64::max)
    }

    /// Writes the activities of a rank as characters of equal times: `#` computes, `=`
    /// communicates, `.` waits.
    fn lane(&self, rank: usize) -> String {
        const WIDTH: usize = 64;
        let mut lane = String::new();
        for at in 0..WIDTH {
            let time = self.length() * (at as f64 + 0.5) / WIDTH as f64;
            let mut own = self.stretches.iter().filter(|stretch| stretch.rank == rank);
            let then = own.find(|stretch| (stretch.begin..stretch.end).contains(&time));
            lane.push(match then.map(|stretch| &*stretch.activity) {
                Some("compute") => '#',
                Some("communicate") => '=',
                Some(_) => '.',
                None => ' ',
            });
        }
        lane
    }
}

/// Finds the step whose times are nearest to the medians over all steps. All ranks and activities
/// count.
fn typical(ms: &[Vec<[f64; 3]>]) -> Option<u32> {
    let numbers = ms.first()?.as_flattened().len();
    let mut away = vec![0.0; ms.len()];
    for at in 0..numbers {
        let all: Vec<f64> = ms.iter().map(|step| step.as_flattened()[at]).collect();
        let median = Times::of(all.clone())?.median;
        for (away, of_step) in away.iter_mut().zip(all) {
            *away += (of_step - median).abs();
        }
    }
    (0..ms.len()).min_by(|&a, &b| away[a].total_cmp(&away[b])).map(|step| step as u32)
}

/// Writes the means of all steps as a table, then the drawing.
impl std::fmt::Display for Timeline {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Self { program, n, steps, ms_per_step, step, .. } = self;
        writeln!(f, "{program}, n = {n}: ms a step, mean of {steps}\n")?;
        let mut table = Table::new(["rank"].into_iter().chain(Activity::ALL.map(Activity::name)));
        for (rank, ms) in ms_per_step.iter().enumerate() {
            table.row([rank.to_string()].into_iter().chain(ms.map(three_digits)));
        }
        let length = three_digits(self.length());
        writeln!(f, "{table}\nStep {step}, {length} ms: # compute, = communicate, . wait\n")?;
        (0..ms_per_step.len()).try_for_each(|rank| writeln!(f, "rank {rank}  {}", self.lane(rank)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::chart::{Form, svg};
    use crate::scene::Scene;

    #[test]
    fn the_typical_step_is_drawn() {
        let mut events = Vec::new();
        for (step, start, length) in [(0, 0.0, 0.008), (1, 0.008, 0.004), (2, 0.012, 0.002)] {
            for (rank, part) in [(0, 1.0), (1, 0.25)] {
                let middle = start + part * length;
                let event = |activity, begin, end| Event { rank, step, activity, begin, end };
                events.push(event(Activity::Compute, start, middle));
                events.push(event(Activity::Wait, middle, start + length));
            }
        }
        let job = Job { steps: 3, ..Job::new("solution5".parse().unwrap(), Scene::Soft { n: 7 }) };
        let timeline = Timeline::of(&job, &events).unwrap();
        assert_eq!(timeline.step, 1);
        assert_eq!(timeline.lane(0), "#".repeat(64));
        assert_eq!(timeline.lane(1), "#".repeat(16) + &".".repeat(48));
        let [compute, _, wait] = timeline.ms_per_step[1];
        assert!((compute - 3.5 / 3.0).abs() < 1e-9 && (wait - 10.5 / 3.0).abs() < 1e-9);
        let svg = svg(&[vec![timeline.chart()]], Form::Page);
        assert!(["rank 1", "compute", "wait"].iter().all(|text| svg.contains(text)), "{svg}");
        assert!(Timeline::of(&job, &[]).is_none());
    }
}
