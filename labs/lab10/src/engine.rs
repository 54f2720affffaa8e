//! The engine: a neighbour list, an inner list, forces, and the move, on one thread.

use common::soft::{CUTOFF, DT, Observer, Particle, Scene, Simulation, Statistics};
use neighbour_list_core::kernels::{
    Contacts, EIGHT, Kernel, Pair, ROOM, Signs, dispatch, make_room,
};
use neighbour_list_core::list::lasting;
use neighbour_list_core::{Bodies, Extent, Grid, Sorter, Workers};

use crate::Tasks;
use crate::collect::collect;
use crate::filter::filter;
use crate::skin::{best_skin, expired};

/// Pairs of particles, and how long they may be used.
#[derive(Default)]
pub struct List {
    /// Pairs [i, j], i < j, of indices in the sorted order.
    pub pairs: Vec<Pair>,
    /// The list holds every pair that was within cutoff + skin when it was built, in units of length.
    pub skin: f64,
    /// How far a particle may have gone since then, in units of length; infinite before the first list.
    pub displacement: f64,
}

/// The engine of variant `serial-list`.
#[derive(Default)]
pub struct Engine<O> {
    /// The skin that was asked for, or 0 for the cheapest, in units of length.
    fixed_skin: f64,
    /// Whether there is to be an inner list.
    has_inner: bool,
    size: f64,
    /// The particles, sorted by cell when the outer list was built.
    pub bodies: Bodies,
    sorter: Sorter,
    /// Every pair that may touch until the next rebuild.
    pub outer: List,
    /// The pairs of `outer` that may touch within the next few steps.
    pub inner: List,
    contacts: Contacts<Tasks>,
    /// The accelerations of a step along x.
    pub ax: Vec<f64>,
    /// The accelerations of a step along y.
    pub ay: Vec<f64>,
    observer: O,
    steps: u64,
    rebuilds: u64,
    /// Pairs of both lists that were looked at. Those that `collect` tests to build a list are not counted.
    tests: u64,
}

impl<O: Observer> Engine<O> {
    /// Builds the outer list anew. Afterwards there is no inner list: its displacement is infinite.
    ///
    /// - [`skin`](Self::skin) says the skin. Its argument is how far the fastest particle goes in a step: its
    ///   speed, [`Bodies::fastest`], times [`DT`].
    /// - Particles are sorted into cells that are as wide as the list looks ([`reach`](Self::reach)):
    ///   [`Extent::of`], [`Grid::new`], [`Sorter::sort`] with [`Workers::default`], one thread.
    /// - For each particle i in sorted order, [`Cells::ahead`](neighbour_list_core::Cells::ahead) names the two ranges of particles
    ///   that may be near it; [`collect`] writes its pairs behind those found before. Each call needs a list
    ///   that is long enough: [`make_room`] lengthens it. At the end the list is too long, and may have old
    ///   pairs behind the new ones: truncate it.
    /// - The list then knows its skin, and its displacement is 0.
    ///
    /// Book: chapter 10, *The engine*.
    #[inline(always)]
    pub fn rebuild(&mut self, signs: impl Signs) {
        todo!("task 10.5: a new list");
        self.rebuilds += 1;
    }

    /// Makes the inner list anew, of the pairs of the outer one that are within the
    /// [`reach`](Self::reach) of the inner skin, in their order.
    ///
    /// [`inner_skin`](Self::inner_skin) says the inner skin; its argument is how far the fastest particle goes
    /// in a step. The list then knows its skin, and its displacement is 0. [`filter`] takes at most [`ROOM`] pairs at a time, and the square of
    /// a distance.
    ///
    /// Book: chapter 10, *A list within the list*.
    #[inline(always)]
    pub fn rebuild_inner(&mut self) {
        todo!("task 10.5b: a new inner list");
        self.count(self.outer.pairs.len());
    }

    /// Writes the accelerations of all particles into `ax` and `ay`, which may hold those of another step
    /// and of fewer particles.
    ///
    /// [`Contacts::for_each`] calls a closure with each pair [i, j] of the inner list that is within the
    /// cutoff, the acceleration of i, and the pair's squared distance. The acceleration of j is the opposite.
    /// Call the observer's [`seen`](Observer::seen) with the squared distance twice, once for each of the two.
    /// Do not call [`tested`](Observer::tested): the line below does.
    ///
    /// Book: chapter 10, *The engine*.
    #[inline(always)]
    pub fn accelerate(&mut self) {
        todo!("task 10.6: forces");
        self.count(self.inner.pairs.len());
    }

    /// A step of all particles.
    ///
    /// - A list that has [`expired`] is built anew, the outer one first.
    /// - [`accelerate`](Self::accelerate) computes the forces.
    /// - [`Moving::advance`](neighbour_list_core::Moving::advance) of [`Bodies::moving`] moves all particles by [`DT`] in
    ///   the box of side `size`: `advance::<Tasks>(…)`, which calls your `drift`.
    /// - Both lists are then older by as far as the fastest particle went in this step, and by
    ///   [`rounding`](Self::rounding).
    ///
    /// Book: chapter 10, *The engine*.
    #[inline(always)]
    pub fn advance(&mut self, signs: impl Signs) {
        todo!("task 10.6b: a step");
        self.steps += 1;
    }
}

/// What the loop calls.
impl<O: Observer> Engine<O> {
    /// An engine with a skin of `skin` cutoffs, 0 for the cheapest, and with an inner list or without.
    pub fn new(skin: f64, has_inner: bool) -> Self {
        Self { fixed_skin: skin * CUTOFF, has_inner, ..Self::default() }
    }

    /// Counts pairs of a list that were looked at.
    fn count(&mut self, pairs: usize) {
        self.tests += pairs as u64;
        self.observer.tested(pairs as u64);
    }

    /// The skin of a list for particles that go no further than `displacement` in a step.
    fn skin(&self, displacement: f64) -> f64 {
        if self.fixed_skin > 0.0 {
            return self.fixed_skin;
        }
        let extent = Extent::of(&self.bodies);
        let area = (extent.width + CUTOFF) * (extent.height + CUTOFF);
        best_skin(self.bodies.len() as f64 / area, displacement)
    }

    /// The skin of an inner list that lasts for the cheapest number of steps, and not longer than the
    /// outer list; that of the outer list if an inner one does not pay.
    fn inner_skin(&self, displacement: f64) -> f64 {
        let left = self.outer.skin - 2.0 * self.outer.displacement;
        let steps = lasting(self.outer.skin, displacement).filter(|_| self.has_inner);
        steps.map_or(left, |steps| left.min(2.0 * (steps - 1.0) * displacement))
    }

    /// How far to look for pairs that may touch when they are closer by `skin`: rounding must not hide one.
    fn reach(&self, skin: f64) -> f64 {
        (CUTOFF + skin) * (1.0 + 1e-9) + 1e-15 * self.size
    }

    /// What rounding may add to a displacement in a step.
    fn rounding(&self) -> f64 {
        f64::EPSILON * self.size
    }
}

/// A step, as a vector kernel: [`dispatch`] runs the version of it that was compiled for this processor.
struct Step<'a, O>(&'a mut Engine<O>);

impl<O: Observer> Kernel for Step<'_, O> {
    type Output = ();

    #[inline(always)]
    fn run(self, signs: impl Signs) {
        self.0.advance(signs);
    }
}

impl<O: Observer> Simulation for Engine<O> {
    fn load(&mut self, scene: &Scene) {
        let skin = self.fixed_skin / CUTOFF;
        *self = Self::new(skin, self.has_inner);
        (self.bodies, self.size) = (Bodies::of(scene), scene.size());
        (self.outer.displacement, self.inner.displacement) = (f64::INFINITY, f64::INFINITY);
    }

    fn step(&mut self) {
        self.observer = O::default();
        dispatch(Step(self));
    }

    fn read(&self, first: usize, out: &mut [Particle]) {
        self.bodies.read(first, out);
    }

    fn statistics(&self) -> Option<Statistics> {
        self.observer.statistics()
    }

    fn counters(&self) -> Vec<(&'static str, f64)> {
        let particle_steps = self.bodies.len() as f64 * self.steps as f64;
        vec![
            ("pair tests per particle and step", self.tests as f64 / particle_steps),
            ("particles touched per particle and step", 1.0),
            ("steps per rebuild", self.steps as f64 / self.rebuilds as f64),
        ]
    }
}
