//! How the square is cut into cells, how much work that makes, and how its rows are shared out.

use std::ops::Range;

use common::hard::Disc;

use crate::{LANES, Square, Survey};

/// Columns and rows of cells that cover the places of the discs.
///
/// Places beyond the lattice count to its outermost cells, so that whatever overlaps in the plane
/// shares a row, and begins and ends in the right order of columns, on the lattice too.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lattice {
    left: f64,
    bottom: f64,
    per_width: f64,
    per_height: f64,
    columns: u32,
    rows: u32,
    /// The greatest velocity component of the scene.
    pub fastest: f64,
    /// Whether it pays to look at many pairs together: an entry has several partners, and few pairs
    /// must be asked when they touch.
    pub in_lanes: bool,
}

/// More columns or rows than this are not told apart.
const MOST: f64 = (1 << 30) as f64;

/// A row is so many times as high as a mean box. Lower rows mean more entries, higher ones more
/// pairs to look at.
const HEIGHT: f64 = 2.0;

/// A column is so many times as wide as a mean box.
const WIDTH: f64 = 0.5;

/// Mean width and height of a box, if the step is cut into `windows` windows.
fn mean_box(survey: &Survey, square: Square, windows: usize) -> (f64, f64) {
    let side = |speed: f64| speed / windows as f64 + 2.0 * square.radius;
    (side(survey.speed.0), side(survey.speed.1))
}

impl Lattice {
    /// The lattice for a step of `windows` windows.
    pub fn new(survey: &Survey, square: Square, windows: usize) -> Self {
        let (width, height) = mean_box(survey, square, windows);
        let work = expected_work(survey, square, windows);
        let count =
            |(low, high): (f64, f64), cell: f64| ((high - low) / cell).ceil().clamp(1.0, MOST);
        let columns = count(survey.x, WIDTH * width);
        let rows = count(survey.y, HEIGHT * height);
        let per = |(low, high): (f64, f64), cells: f64| {
            if high > low { cells / (high - low) } else { 0.0 }
        };
        Self {
            left: survey.x.0,
            bottom: survey.y.0,
            per_width: per(survey.x, columns),
            per_height: per(survey.y, rows),
            columns: columns as u32,
            rows: rows as u32,
            fastest: survey.fastest,
            in_lanes: work.pairs > work.entries && work.asked < 0.5 * work.pairs,
        }
    }

    /// The column of a place.
    #[inline]
    pub fn column(&self, x: f64) -> u32 {
        // The conversion takes what is negative to 0.
        (((x - self.left) * self.per_width) as u32).min(self.columns - 1)
    }

    /// The row of a place.
    #[inline]
    pub fn row(&self, y: f64) -> u32 {
        (((y - self.bottom) * self.per_height) as u32).min(self.rows - 1)
    }

    /// The number of a cell.
    #[inline]
    pub fn cell(&self, row: u32, column: u32) -> u64 {
        u64::from(row) * u64::from(self.columns) + u64::from(column)
    }

    /// Number of rows.
    pub fn rows(&self) -> u32 {
        self.rows
    }
}

/// Work that a step is expected to make, all its windows together.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Work {
    /// Entries.
    pub entries: f64,
    /// Pairs to look at.
    pub pairs: f64,
    /// Of these, pairs that are asked when they touch.
    pub asked: f64,
}

/// The work of a step that is cut into `windows` windows.
///
/// Boxes shrink with the number of windows: a mean one is `speed / windows + 2 r` wide. A disc
/// is in 1 + height / row height rows. Two entries of a row meet if their boxes overlap along x. Of such pairs
/// a share of about 4 r / width pass each other within 2 r, at any time, and then all are asked that were looked
/// at together with them. All that for each window, and only of discs that are free when it begins
/// ([`still_free`]).
pub fn expected_work(survey: &Survey, square: Square, windows: usize) -> Work {
    let (width, height) = mean_box(survey, square, windows);
    let extent = |(low, high): (f64, f64), least: f64| (high - low).max(least);
    let (wide, high) = (extent(survey.x, width), extent(survey.y, height));
    let (free, both_free) = still_free(survey.meetings, windows);

    let entries = survey.n as f64 * (1.0 + 1.0 / HEIGHT);
    let rows = (high / (HEIGHT * height)).max(1.0);
    let in_row = entries / rows;
    let pairs = rows * in_row * in_row * (width * (1.0 + WIDTH / 2.0) / wide).min(1.0);
    let asked = (LANES as f64 * 4.0 * square.radius / width).min(1.0);
    let pairs = both_free * pairs;
    Work { entries: free * entries, pairs, asked: asked * pairs }
}

/// Windows, counted by the share of discs that are free when they begin, and by the share of pairs.
///
/// A disc collides once in a step. If it would meet m discs, the share f of the free ones falls by
/// f' = −m f², so f(t) = 1 / (1 + m t). In the first window all are free; over the later ones f
/// and f² are integrated.
fn still_free(meetings: f64, windows: usize) -> (f64, f64) {
    let windows = windows as f64;
    let later = 1.0 - 1.0 / windows;
    let free = if meetings > 0.0 { (meetings * later).ln_1p() / meetings } else { later };
    (1.0 + windows * free, 1.0 + windows * later / (1.0 + meetings * later))
}

/// A strip has about so many discs, so that its entries stay in a core's nearest caches while they are
/// sorted and searched.
const DISCS: usize = 512;

/// A worker keeps a list for each strip open at the same time, and more of them would not fit into its caches.
const MOST_STRIPS: usize = 512;

/// Rows are told apart in slices of 2^k rows, in so many slices or fewer.
const MOST_SLICES: u32 = 4096;

/// So many discs tell well enough where the discs are.
const SAMPLE: usize = 1 << 14;

/// A lattice whose rows are cut into strips, with about as many discs in each.
///
/// How follows from the discs, and not from the number of workers: a worker takes strip after strip.
#[derive(Debug)]
pub struct Cut {
    /// The lattice.
    pub lattice: Lattice,
    shift: u32,
    /// The strip of each slice.
    strips: Vec<u32>,
    /// The rows of each strip.
    rows: Vec<Range<u32>>,
}

impl Cut {
    /// Cuts a lattice.
    pub fn new(lattice: Lattice, discs: &[Disc]) -> Self {
        let mut shift = 0;
        while lattice.rows() >> shift >= MOST_SLICES {
            shift += 1;
        }
        let slice = |row: u32| (row >> shift) as usize;
        // Without discs there are no rows.
        let mut sampled = vec![0_usize; slice(lattice.rows().saturating_sub(1)) + 1];
        for disc in discs.iter().step_by(discs.len().div_ceil(SAMPLE).max(1)) {
            sampled[slice(lattice.row(disc.y))] += 1;
        }

        let wanted = (discs.len() / DISCS).clamp(1, MOST_STRIPS);
        let all: usize = sampled.iter().sum();
        let (mut strips, mut rows) = (Vec::with_capacity(sampled.len()), Vec::new());
        let (mut below, mut start) = (0, 0);
        for (slice, discs) in sampled.into_iter().enumerate() {
            strips.push(rows.len() as u32);
            below += discs;
            let end = lattice.rows().min((slice as u32 + 1) << shift);
            if below * wanted >= (rows.len() + 1) * all || end == lattice.rows() {
                rows.push(start..end);
                start = end;
            }
        }
        Self { lattice, shift, strips, rows }
    }

    /// The strip that a row belongs to.
    #[inline]
    pub fn strip(&self, row: u32) -> usize {
        self.strips[(row >> self.shift) as usize] as usize
    }

    /// How many strips there are.
    pub fn strips(&self) -> usize {
        self.rows.len()
    }

    /// The numbers of the cells of a strip.
    pub fn cells(&self, strip: usize) -> Range<u64> {
        let Range { start, end } = self.rows[strip];
        self.lattice.cell(start, 0)..self.lattice.cell(end, 0)
    }
}
