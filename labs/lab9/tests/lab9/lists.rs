//! Questions about lists of candidates: the candidates that the host confirms, and lists that grow.

use std::collections::BTreeSet;
use std::ops::Range;

use common::hard::Disc;
use device::GpuError;
use device_discs::hard::{Deal, Finder, HardKernels, Search, WALL};
use lab9::Lab9;
use oracle::{Ask, Random, integers};
use solution7::{Candidate, Hit, Square, pair_hit, wall_hit};

use super::adapter::adapter;
use super::launched::{SMALL, everything_found, line};

/// Returns kind (0 to 3 for a corner, an x wall, a y wall, a pair), discs and time of each
/// candidate.
pub(super) fn values(candidates: &[Candidate]) -> Vec<[f64; 4]> {
    let value = |c: &Candidate| {
        let [kind, a, b] = match c.hit {
            Hit::Corner(a) => [0, a, WALL],
            Hit::WallX(a) => [1, a, WALL],
            Hit::WallY(a) => [2, a, WALL],
            Hit::Pair(a, b) => [3, a, b],
        };
        [f64::from(kind), f64::from(a), f64::from(b), c.time]
    };
    candidates.iter().map(value).collect()
}

/// Returns the numbers of candidates in sorted order, because a device produces no fixed order.
pub(super) fn sorted(candidates: &[Candidate]) -> Vec<f64> {
    let mut values = values(candidates);
    values.sort_by(|a, b| a.partial_cmp(b).expect("the values are numbers"));
    values.concat()
}

/// Discs, and the candidates that a device passed on.
struct PassedOn {
    square: Square,
    discs: Vec<Disc>,
    found: Vec<[u32; 2]>,
}

impl PassedOn {
    /// Draws pairs and walls that collide or do not collide.
    fn drawn(random: &mut Random, n: usize) -> Self {
        let square = Square { side: 3.0 * (n as f64 + 4.0).sqrt(), radius: 1.0 };
        let disc = |_| {
            let [x, y] = [0; 2].map(|_| random.between(1.0, square.side - 1.0));
            Disc::new(x, y, random.signed(1e-3, 8.0), random.signed(1e-3, 8.0))
        };
        let discs = (0..n + 2).map(disc).collect();
        let mut found = Vec::with_capacity(n);
        for _ in 0..n {
            let [a, b] = [0; 2].map(|_| random.below(n + 2) as u32);
            let is_wall = a == b || random.below(3) == 0;
            found.push(if is_wall { [a, WALL] } else { [a.min(b), a.max(b)] });
        }
        Self { square, discs, found }
    }

    fn confirmed(&self) -> Vec<Candidate> {
        let confirm = |&[a, b]: &[u32; 2]| match b {
            WALL => wall_hit(a, &self.discs[a as usize], self.square),
            b => pair_hit(&self.discs, a, b, self.square.radius),
        };
        self.found.iter().filter_map(confirm).collect()
    }
}

/// Asks for the confirmed candidates of several lists in one vector: longer, shorter, and empty
/// lists.
pub(crate) fn confirmed(random: &mut Random, ask: &mut impl Ask) {
    let mut candidates = Vec::new();
    for n in random.sizes(4097).into_iter().chain([257, 1, 0]) {
        let passed_on = PassedOn::drawn(random, n);
        let question = format!(
            "{n} candidates that a device passed on, after another list: kind (0 corner, 1 and 2 walls, 3 pair), \
             discs and time of each candidate that is confirmed"
        );
        let found = || {
            let PassedOn { square, discs, found } = &passed_on;
            Lab9::confirm(discs, *square, found, &mut candidates);
            values(&candidates).concat()
        };
        ask.exact(&question, found, || values(&passed_on.confirmed()).concat());
    }
}

/// A search that finds one candidate in each row, and counts what is asked of it.
struct Counted {
    room: u64,
    runs: usize,
    grown: usize,
}

impl Search for Counted {
    fn run(&mut self, rows: Range<u32>) -> u64 {
        self.runs += 1;
        u64::from(rows.end - rows.start)
    }

    fn capacity(&self) -> u64 {
        self.room
    }

    fn grow(&mut self, count: u64) -> Result<(), GpuError> {
        self.grown += 1;
        self.room = count;
        Ok(())
    }

    fn fetch(&mut self, count: u64, found: &mut Vec<[u32; 2]>) {
        found.extend((0..count as u32).map(|disc| [disc, WALL]));
    }
}

/// Asks how often kernels run if a list has room, and if it has none.
pub(crate) fn kernel_runs(_: &mut Random, ask: &mut impl Ask) {
    for (room, rows) in [(8, 5), (8, 8), (8, 9), (1, 100)] {
        let mut search = Counted { room, runs: 0, grown: 0 };
        let mut all = Vec::new();
        let question = format!(
            "a list with room for {room} candidates, and {rows} candidates: (1) number of runs of the kernels, (2) \
             number of times that the list grows, (3) number of candidates collected, (4) number of candidates for \
             which the list has room afterwards"
        );
        let found = || match Lab9::collect(&mut search, 0..rows, &mut all) {
            Ok(()) => integers([search.runs, search.grown, all.len(), search.room as usize]),
            Err(error) => panic!("{error}"),
        };
        let fits = u64::from(rows) <= room;
        let right = || {
            let runs = if fits { 1 } else { 2 };
            let most = room.max(rows.into()) as usize;
            integers([runs, usize::from(!fits), rows as usize, most])
        };
        ask.exact(&question, found, right);
    }
}

/// A list for all pairs and all walls of some discs.
struct Grown {
    discs: usize,
    /// Number of candidates for which a new device has memory. `None` for the device of the
    /// previous question.
    room: Option<u64>,
}

impl Grown {
    /// Returns lists that grow, that were longer before, and that exceed the device's memory. In
    /// the last case the memory suffices for parts of the rows, or not even for one row.
    fn all(random: &mut Random) -> Vec<Self> {
        let [few, some, more] = [30, 700, 1100].map(|least| least + random.below(100));
        let room = 1024 + random.below(60) as u64;
        let on_one_device = [few + 10, some + 200, few, more, 1].map(|discs| (discs, None));
        let with_little = [(some + 200, Some(room)), (some, Some(2 * room)), (more, Some(room))];
        let all = on_one_device.into_iter().chain(with_little);
        all.map(|(discs, room)| Self { discs, room }).collect()
    }

    fn question(&self) -> String {
        let room =
            self.room.map_or_else(String::new, |room| format!(", memory for {room} candidates"));
        format!(
            "{} discs{room}, all pairs and all walls: (1) number of candidates found, (2) number of different \
             candidates. No numbers if the memory is too small for one row",
            self.discs
        )
    }

    fn search(&self, finder: &mut Finder<Lab9, f32>) -> Vec<f64> {
        match everything_found(finder, &line(self.discs)) {
            Err(GpuError::Memory { .. }) => Vec::new(),
            Err(error) => panic!("{error}"),
            Ok(found) => {
                let different: BTreeSet<_> = found.iter().filter(|[a, b]| a < b).collect();
                vec![found.len() as f64, different.len() as f64]
            }
        }
    }

    /// Returns the number of candidates, twice: found, and different. Empty if the device has no
    /// room for one row.
    fn right(&self) -> Vec<f64> {
        let all = self.discs * (self.discs + 1) / 2;
        let has_room = self.room.is_none_or(|room| room >= self.discs as u64);
        if has_room { vec![all as f64; 2] } else { Vec::new() }
    }
}

pub(crate) fn grown(random: &mut Random, ask: &mut impl Ask) {
    let Some(gpu) = adapter("9.3") else { return };
    let new =
        || Finder::new(gpu, Deal::Discs, SMALL, None).unwrap_or_else(|error| panic!("{error}"));
    let mut finder = new();
    for grown in Grown::all(random) {
        if let Some(room) = grown.room {
            finder = new().with_room_for(room);
        }
        ask.exact(&grown.question(), || grown.search(&mut finder), || grown.right());
    }
}
