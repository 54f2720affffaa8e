//! The engine on one thread: a neighbour list, an inner list, forces and the move.

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

/// Pairs of particles, with the skin and the displacement that limit how long they are valid.
#[derive(Default)]
pub struct List {
    /// Pairs [i, j], i < j, of indices in the sorted order.
    pub pairs: Vec<Pair>,
    /// The skin, a length: the list contains every pair that was within cutoff + skin when it was built.
    pub skin: f64,
    /// The greatest distance that a particle may have moved since the list was built; infinite before
    /// the first list.
    pub displacement: f64,
}

/// The engine of the variant `serial-list`.
#[derive(Default)]
pub struct Engine<O> {
    /// The skin that the user chose, a length, or 0 for the cheapest skin.
    fixed_skin: f64,
    /// Whether the engine uses an inner list.
    has_inner: bool,
    size: f64,
    /// The particles, sorted by cell when the outer list was built.
    pub bodies: Bodies,
    sorter: Sorter,
    /// The list of all pairs that may touch until the next rebuild.
    pub outer: List,
    /// The list of the pairs of `outer` that may touch within the next few steps.
    pub inner: List,
    contacts: Contacts<Tasks>,
    /// The accelerations of a step along x.
    pub ax: Vec<f64>,
    /// The accelerations of a step along y.
    pub ay: Vec<f64>,
    observer: O,
    steps: u64,
    rebuilds: u64,
    /// The number of pair tests in both lists, except the tests of `collect` when it builds a list.
    tests: u64,
}

impl<O: Observer> Engine<O> {
    /// Builds a new outer list, and makes the inner list invalid.
    ///
    /// 1. [`skin`](Self::skin) returns the skin. Its argument is the distance that the fastest particle moves in
    ///    a step: its speed, [`Bodies::fastest`], times [`DT`].
    /// 2. Sort the particles into cells of side [`reach`](Self::reach). Use [`Extent::of`], [`Grid::new`], and
    ///    [`Sorter::sort`] with [`Workers::default`], which is one thread.
    /// 3. Go through the particles i in sorted order. [`Cells::ahead`](neighbour_list_core::Cells::ahead)
    ///    returns the two ranges of particles that may be near particle i. Before each call of
    ///    [`collect`], let [`make_room`] lengthen the list. `collect` then writes the pairs of i after
    ///    the pairs found before.
    /// 4. Truncate the list. At this point it is too long, and may contain old pairs after the new ones.
    /// 5. Set the skin of the list, and set its displacement to 0. Set the displacement of the inner list
    ///    to infinity.
    ///
    /// Book: chapter 10, *The engine*.
    #[inline(always)]
    pub fn rebuild(&mut self, signs: impl Signs) {
        todo!("task 10.5: a new list");
        self.rebuilds += 1;
    }

    /// Builds a new inner list from the pairs of the outer list.
    ///
    /// The inner list contains the pairs within the [`reach`](Self::reach) of the inner skin, in the same
    /// order. [`filter`] finds these pairs. It takes at most [`ROOM`] pairs at a time, and the square of this
    /// reach.
    ///
    /// [`inner_skin`](Self::inner_skin) returns the inner skin. Its argument is the distance that the fastest
    /// particle moves in a step. At the end, set the skin of the inner list, and set its displacement to 0.
    ///
    /// Book: chapter 10, *A list within the list*.
    #[inline(always)]
    pub fn rebuild_inner(&mut self) {
        todo!("task 10.5b: a new inner list");
        self.count(self.outer.pairs.len());
    }

    /// Writes the accelerations of all particles into `ax` and `ay`.
    ///
    /// At first `ax` and `ay` may contain the accelerations of an earlier step, and of fewer particles.
    ///
    /// [`Contacts::for_each`] calls a closure for each pair of the inner list within the cutoff. The closure
    /// receives the pair [i, j], the acceleration of i, and the squared distance. The acceleration of
    /// j is the opposite.
    ///
    /// Call the observer's [`seen`](Observer::seen) twice with the squared distance, once for each particle.
    /// Do not call [`tested`](Observer::tested), because the given line below counts the tests.
    ///
    /// Book: chapter 10, *The engine*.
    #[inline(always)]
    pub fn accelerate(&mut self) {
        todo!("task 10.6: forces");
        self.count(self.inner.pairs.len());
    }

    /// Takes one step of all particles.
    ///
    /// 1. Rebuild each list that has [`expired`], the outer list first.
    /// 2. [`accelerate`](Self::accelerate) computes the forces.
    /// 3. [`Moving::advance`](neighbour_list_core::Moving::advance) of [`Bodies::moving`] moves all particles by
    ///    [`DT`] in the box of side `size`. Call it as `advance::<Tasks>(…)`, so that it calls your `drift`.
    /// 4. Increase the displacement of both lists by the distance that the fastest particle moved in this
    ///    step, plus [`rounding`](Self::rounding).
    ///
    /// Book: chapter 10, *The engine*.
    #[inline(always)]
    pub fn advance(&mut self, signs: impl Signs) {
        todo!("task 10.6b: a step");
        self.steps += 1;
    }
}

/// The given functions that the loop calls.
impl<O: Observer> Engine<O> {
    /// Makes an engine with a skin of `skin` cutoffs (0: the cheapest skin), with or without an inner list.
    pub fn new(skin: f64, has_inner: bool) -> Self {
        Self { fixed_skin: skin * CUTOFF, has_inner, ..Self::default() }
    }

    /// Counts pair tests in a list, and reports them to the observer.
    fn count(&mut self, pairs: usize) {
        self.tests += pairs as u64;
        self.observer.tested(pairs as u64);
    }

    /// Returns the skin of a list for particles that move at most by `displacement` in a step.
    fn skin(&self, displacement: f64) -> f64 {
        if self.fixed_skin > 0.0 {
            return self.fixed_skin;
        }
        let extent = Extent::of(&self.bodies);
        let area = (extent.width + CUTOFF) * (extent.height + CUTOFF);
        best_skin(self.bodies.len() as f64 / area, displacement)
    }

    /// Returns the skin of an inner list that lasts for the cheapest number of steps.
    ///
    /// The inner list lasts at most as long as the outer list. If an inner list does not pay, the result is
    /// the rest of the outer skin.
    fn inner_skin(&self, displacement: f64) -> f64 {
        let left = self.outer.skin - 2.0 * self.outer.displacement;
        let steps = lasting(self.outer.skin, displacement).filter(|_| self.has_inner);
        steps.map_or(left, |steps| left.min(2.0 * (steps - 1.0) * displacement))
    }

    /// Returns the distance within which a list with this skin contains all pairs.
    ///
    /// The distance is a little greater than cutoff + `skin`, so that rounding cannot hide a pair.
    fn reach(&self, skin: f64) -> f64 {
        (CUTOFF + skin) * (1.0 + 1e-9) + 1e-15 * self.size
    }

    /// The length that rounding may add to a displacement in a step.
    fn rounding(&self) -> f64 {
        f64::EPSILON * self.size
    }
}

/// A step as a vector kernel: [`dispatch`] runs the version that was compiled for this processor.
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
