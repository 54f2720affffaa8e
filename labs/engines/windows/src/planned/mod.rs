//! The engine that makes a plan for the scene before it takes steps.

mod plan;

use std::cell::RefCell;
use std::fmt::Write;
use std::marker::PhantomData;

use common::soft::{DT, Observer, Particle, Scene, Simulation, Statistics};
use neighbour_list::{Bodies, Crew, NeighbourList, Workers};

pub use plan::{Plan, Strategy, plan};

use crate::rules::Rules;
use crate::search::Layout;
use crate::span::Span;
use crate::window::{Window, WindowCounts};

/// Number of windows after which the engine makes a new plan.
const WINDOWS: u64 = 16;
/// Number of steps with a list after which the engine makes a new plan.
const STEPS: u64 = 256;

/// The engine: it surveys the scene, plans, and advances the scene with windows or with a list.
///
/// `R` are the rules of its windows, and `O` observes each step. Observations that `O` ignores cost
/// nothing.
pub struct Planned<R, O> {
    crew: Crew,
    /// Number of steps in a window that the user chose, or 0 for the planner's choice.
    fixed_steps: u32,
    /// Number of small steps in an official step.
    divide: u32,
    size: f64,
    window: Window,
    plain: NeighbourList<O>,
    plan: Plan,
    counts: WindowCounts,
    /// Number of steps that have been taken in the open window.
    into: u32,
    span: Span,
    observers: Vec<O>,
    statistics: Option<Statistics>,
    seen: RefCell<Option<Bodies>>,
    steps: u64,
    plain_steps: u64,
    log: Vec<(u64, Plan)>,
    rules: PhantomData<R>,
}

impl<R: Rules, O: Observer> Planned<R, O> {
    /// Makes an engine that runs on `crew`, with windows of `steps` official steps.
    ///
    /// If `steps` is 0, the planner chooses the length of windows. Each official step is divided
    /// into `divide` small steps.
    pub fn new(crew: impl Into<Crew>, steps: u32, divide: u32) -> Self {
        let crew = crew.into();
        Self {
            crew: crew.clone(),
            fixed_steps: steps,
            divide,
            size: 0.0,
            window: Window::default(),
            plain: NeighbourList::new(crew, 0.0, divide),
            plan: Plan::default(),
            counts: WindowCounts::default(),
            into: 0,
            span: Span { steps: 0, dt: 0.0, size: 0.0 },
            observers: Vec::new(),
            statistics: None,
            seen: RefCell::new(None),
            steps: 0,
            plain_steps: 0,
            log: Vec::new(),
            rules: PhantomData,
        }
    }

    /// Makes a plan for the particles at the end of the last window.
    fn replan(&mut self) {
        self.adopt(plan::<R>(&self.window.bodies, self.fixed_steps, self.divide));
        if self.plan.strategy == Strategy::List {
            self.plain.start(self.window.bodies.clone(), self.size);
            self.plain_steps = 0;
        }
    }

    /// Makes a plan for the particles of the neighbour list. If the new plan also uses a list, the
    /// current list continues.
    fn reconsider(&mut self) {
        self.adopt(plan::<R>(self.plain.bodies(), self.fixed_steps, self.divide));
        if self.plan.strategy != Strategy::List {
            self.window = Window::of(self.plain.bodies().clone());
            self.span.steps = 0;
            self.into = 0;
        }
    }

    fn adopt(&mut self, plan: Plan) {
        if self.log.last().is_none_or(|(_, last)| last.strategy != plan.strategy) {
            self.log.push((self.steps, plan));
        }
        self.plan = plan;
    }

    /// Opens the next window, if the plan is to use windows.
    fn open(&mut self, workers: &Workers) {
        self.window.close::<R>(&self.span, workers);
        self.span.steps = 0;
        if self.counts.windows.is_multiple_of(WINDOWS) {
            self.replan();
        }
        match self.plan.strategy {
            Strategy::List => return,
            Strategy::Windows { steps } => self.search(steps, workers),
        }
        self.into = 0;
        if O::default().statistics().is_some() && self.plan.strategy != Strategy::List {
            self.observers = self.window.observe::<R, O>(&self.span);
        }
    }

    /// Opens a window of `steps` official steps, or of fewer steps if forces bend too many paths in
    /// the window.
    fn search(&mut self, mut steps: u32, workers: &Workers) {
        let fastest = self.window.bodies.fastest();
        let dt = DT / f64::from(self.divide);
        loop {
            let layout = Layout {
                span: Span { steps: steps * self.divide, dt, size: self.size },
                margin: self.plan.margin,
                reach: fastest * f64::from(steps) * DT,
            };
            if self.window.open::<R>(&layout, self.plan.density, workers, &mut self.counts) {
                self.span = layout.span;
                return;
            }
            if steps == 1 {
                // Forces bend too many paths even in a window of a single step, so windows are not
                // worth their cost.
                self.plan.strategy = Strategy::List;
                self.plain.start(self.window.bodies.clone(), self.size);
                return;
            }
            steps /= 2;
            self.plan.strategy = Strategy::Windows { steps };
        }
    }

    /// Whether the open window contains the next step.
    fn is_computed(&self) -> bool {
        self.plan.strategy != Strategy::List && self.into < self.span.steps
    }

    fn official_step(&mut self, workers: &Workers) {
        self.steps += 1;
        if self.plan.strategy != Strategy::List && !self.is_computed() {
            self.open(workers);
        }
        if self.plan.strategy != Strategy::List {
            self.statistics = self.observers.get(self.into as usize).and_then(Observer::statistics);
            self.into += self.divide;
            return;
        }
        self.plain.step();
        self.statistics = self.plain.statistics();
        self.plain_steps += 1;
        if self.plain_steps.is_multiple_of(STEPS) {
            self.reconsider();
        }
    }
}

impl<R: Rules, O: Observer> Simulation for Planned<R, O> {
    fn load(&mut self, scene: &Scene) {
        self.size = scene.size();
        self.window = Window::of(Bodies::of(scene));
        self.crew.engage(scene.len());
        self.plain = NeighbourList::new(self.crew.clone(), 0.0, self.divide);
        self.counts = WindowCounts::default();
        self.into = 0;
        self.steps = 0;
        self.span = Span { steps: 0, dt: 0.0, size: self.size };
        self.statistics = None;
        self.log.clear();
        self.seen.replace(None);
        self.replan();
    }

    fn step(&mut self) {
        self.run(1);
    }

    fn run(&mut self, steps: u64) {
        self.seen.replace(None);
        let workers = self.crew.workers().clone();
        (0..steps).for_each(|_| self.official_step(&workers));
    }

    fn read(&self, first: usize, out: &mut [Particle]) {
        if self.plan.strategy == Strategy::List {
            self.plain.read(first, out);
            return;
        }
        let mut seen = self.seen.borrow_mut();
        seen.get_or_insert_with(|| self.window.after::<R>(&self.span, self.into)).read(first, out);
    }

    fn statistics(&self) -> Option<Statistics> {
        self.statistics
    }

    fn counters(&self) -> Vec<(&'static str, f64)> {
        self.counts.shown(self.window.bodies.len(), self.steps, &self.plain.counts())
    }

    fn plan(&self) -> Option<String> {
        let threads = self.crew.workers().count();
        let most = self.crew.most();
        let mut text = format!("threads: {threads} of {most}\n");
        for (step, plan) in &self.log {
            let _ = writeln!(text, "from step {step}: {plan}");
        }
        if O::default().statistics().is_none() {
            text += "statistics: skipped, because none were requested\n";
        }
        Some(text)
    }
}
