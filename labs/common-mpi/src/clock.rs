//! The times in which a rank computes, communicates and waits.

use std::cell::{Cell, RefCell};
use std::panic::Location;

use common::{Activity, Event};
use mpi::Rank;
use mpi::collective::SystemOperation;
use mpi::topology::SimpleCommunicator;
use mpi::traits::*;

use crate::epoch::Epoch;
use crate::watch::here;

/// Greatest error when times on two machines are compared, in seconds.
const ALIKE: f64 = 2e-5;

/// A recorder of this rank's activities in each step. Without `--events` it records nothing and costs
/// nothing.
///
/// All ranks make the same calls in the same order. Between two calls a rank computes. In a call it
/// *waits* until the last of its partners has entered the same call, and *communicates* for the rest
/// of the call. A partner that enters the call after this rank has left it did not make this rank
/// wait.
#[derive(Debug, Default)]
pub struct Clock {
    log: Option<RefCell<Log>>,
    at: Cell<At>,
}

/// The position of a rank: the step, from 1, and the numbers of its calls in this step and in all
/// steps.
#[derive(Clone, Copy, Debug, Default)]
struct At {
    step: u32,
    number: u32,
    total: u64,
}

impl At {
    fn next_call(self) -> Self {
        Self { number: self.number + 1, total: self.total + 1, ..self }
    }

    fn next_step(self) -> Self {
        Self { step: self.step + 1, number: 0, ..self }
    }

    /// Describes the position in or past a call.
    fn describe(self, how: &str, location: &Location<'_>) -> String {
        let Self { step, number, total } = self;
        let file = location.file();
        let line = location.line();
        format!("{how} call {total}: call {number} of step {step}, {file}:{line}")
    }
}

/// The ranks that take part in a call.
#[derive(Clone, Debug, PartialEq)]
pub enum Partners {
    /// All ranks, each with every other.
    All,
    /// All ranks, through this one.
    Through(Rank),
    /// These ranks.
    These(Vec<Rank>),
}

#[derive(Debug)]
struct Log {
    epoch: Epoch,
    step: u32,
    /// Start of the current stretch. `None` outside steps.
    since: Option<f64>,
    /// Time at which this rank entered the current call, and its partners. `None` outside calls.
    call: Option<(f64, Partners)>,
    stretches: Vec<Stretch>,
}

/// A stretch of a step: computing, or in a call.
#[derive(Debug)]
struct Stretch {
    step: u32,
    begin: f64,
    end: f64,
    call: Option<(f64, Partners)>,
}

/// An event in a message.
#[derive(Clone, Copy, Debug, Equivalence)]
#[repr(C)]
struct EventWire {
    begin: f64,
    end: f64,
    step: u32,
    activity: u32,
}

impl Clock {
    /// Returns a clock that records if `on` is true.
    pub fn new(on: bool) -> Self {
        Self { log: on.then(|| RefCell::new(Log::new(Epoch::now()))), at: Cell::default() }
    }

    /// Starts from the beginning. All ranks call it together.
    pub fn start(&mut self, world: &SimpleCommunicator) {
        self.at.take();
        if self.log.is_some() {
            self.log = Some(RefCell::new(Log::new(Epoch::of_root(world))));
        }
    }

    /// Begins a step.
    pub fn begin_step(&self) {
        self.at.set(self.at.get().next_step());
        here(|| format!("in step {}, before its first call", self.at.get().step));
        self.note(|log, now| log.since = Some(now));
    }

    /// Ends the step.
    pub fn end_step(&self) {
        here(|| format!("after step {}", self.at.get().step));
        self.note(|log, now| {
            log.stretch_ends(now);
            log.since = None;
            log.step += 1;
        });
    }

    /// Makes `call` with these partners. All ranks make it together.
    #[track_caller]
    pub fn call<R>(&self, partners: Partners, call: impl FnOnce() -> R) -> R {
        let at = self.at.get().next_call();
        let location = Location::caller();
        self.at.set(at);
        here(|| at.describe("in", location));
        self.note(|log, now| {
            log.stretch_ends(now);
            log.call = Some((now, partners));
        });
        let result = call();
        here(|| at.describe("past", location));
        self.note(|log, now| {
            log.stretch_ends(now);
            log.call = None;
        });
        result
    }

    /// Does `work` within a call, while messages are under way.
    pub fn work<R>(&self, work: impl FnOnce() -> R) -> R {
        let mut outer = None;
        self.note(|log, now| {
            log.stretch_ends(now);
            outer = log.call.take().map(|(_, partners)| (now, partners));
        });
        let result = work();
        self.note(|log, now| {
            log.stretch_ends(now);
            log.call = outer;
        });
        result
    }

    fn note(&self, change: impl FnOnce(&mut Log, f64)) {
        if let Some(log) = &self.log {
            let mut log = log.borrow_mut();
            let now = log.epoch.seconds();
            change(&mut log, now);
        }
    }

    /// Returns the activities of all ranks, in the order of ranks and times. The list is empty on all
    /// ranks but the root. `None` if the clock does not record. All ranks call it together.
    pub fn events(&self, world: &SimpleCommunicator) -> Option<Vec<Event>> {
        let own = self.own(world)?;
        if world.rank() != 0 {
            world.process_at_rank(0).send(&own[..]);
            return Some(Vec::new());
        }
        let mut events = Vec::new();
        for rank in 0..world.size() {
            let list = match rank {
                0 => own.clone(),
                _ => world.process_at_rank(rank).receive_vec::<EventWire>().0,
            };
            events.extend(list.iter().map(|wire| wire.of(rank as u32)));
        }
        Some(events)
    }

    /// Returns the seconds that all ranks together have computed, communicated and waited. The list is
    /// empty if the clock does not record. All ranks call it together.
    pub fn report(&self, world: &SimpleCommunicator) -> Vec<(&'static str, f64)> {
        let Some(own) = self.own(world) else { return Vec::new() };
        let (mut seconds, mut all) = ([0.0; 3], [0.0; 3]);
        own.iter().for_each(|wire| seconds[wire.activity as usize] += wire.end - wire.begin);
        world.all_reduce_into(&seconds[..], &mut all[..], SystemOperation::sum());
        let names = ["compute [s], all ranks", "communicate [s], all ranks", "wait [s], all ranks"];
        names.into_iter().zip(all).collect()
    }

    /// Returns this rank's activities, after all ranks have exchanged the times at which they entered
    /// each call.
    fn own(&self, world: &SimpleCommunicator) -> Option<Vec<EventWire>> {
        let log = self.log.as_ref()?.borrow();
        let calls = log.stretches.iter().filter_map(|stretch| stretch.call.as_ref());
        let mut came: Vec<f64> = calls.map(|(came, _)| *came).collect();
        let mut most = 0;
        world.all_reduce_into(&came.len(), &mut most, SystemOperation::max());
        came.resize(most, f64::INFINITY);
        let mut all = vec![0.0; most * world.size() as usize];
        world.all_gather_into(&came[..], &mut all[..]);
        let mut number = 0;
        let mut events = Vec::new();
        for stretch in &log.stretches {
            let Stretch { begin, end, call, .. } = stretch;
            let Some((_, partners)) = call else {
                events.push(stretch.part(Activity::Compute, *begin, *end));
                continue;
            };
            let came =
                partners.of(world).into_iter().map(|rank| all[rank as usize * most + number]);
            let last = came.filter(|came| *came < end + ALIKE).fold(*begin, f64::max).min(*end);
            events.push(stretch.part(Activity::Wait, *begin, last));
            events.push(stretch.part(Activity::Communicate, last, *end));
            number += 1;
        }
        events.retain(|event| event.begin < event.end);
        Some(events)
    }
}

impl Log {
    fn new(epoch: Epoch) -> Self {
        Self { epoch, step: 0, since: None, call: None, stretches: Vec::new() }
    }

    /// Ends the stretch that began when the last stretch ended.
    fn stretch_ends(&mut self, now: f64) {
        let Some(begin) = self.since else { return };
        let call = self.call.clone();
        self.stretches.push(Stretch { step: self.step, begin, end: now, call });
        self.since = Some(now);
    }
}

impl Stretch {
    /// Returns a part of the stretch as an event.
    fn part(&self, activity: Activity, begin: f64, end: f64) -> EventWire {
        EventWire { begin, end, step: self.step, activity: activity as u32 }
    }
}

impl Partners {
    /// Returns the ranks that receive these lists.
    pub fn receivers<T>(lists: &[(Rank, Vec<T>)]) -> Self {
        Self::These(lists.iter().map(|(rank, _)| *rank).collect())
    }

    /// Returns the partners of this rank.
    fn of(&self, world: &SimpleCommunicator) -> Vec<Rank> {
        match self {
            Self::Through(middle) if world.rank() != *middle => vec![*middle],
            Self::All | Self::Through(_) => (0..world.size()).collect(),
            Self::These(partners) => partners.clone(),
        }
    }
}

impl EventWire {
    fn of(&self, rank: u32) -> Event {
        let Self { begin, end, step, activity } = *self;
        Event { rank, step, activity: Activity::ALL[activity as usize], begin, end }
    }
}
