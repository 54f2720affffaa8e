use std::sync::mpsc;
use std::thread;
use std::time::Duration;

use common::Vec2;
use common::soft::{CUTOFF, Observer, Particle, Scene, NoStatistics};
use crossbeam_queue::SegQueue;
use lab4::{
    Meter, Regions, VARIANTS, add_across, pairs_across, pairs_within, post, put_all, rebuild, take,
    take_own,
};
use oracle::{Grader, Model, scenes};
use parking_lot::Mutex;
use solution1::Tally;
use solution2::{Grid, SortedBins, VecBins};

const THREADS: [usize; 5] = [1, 2, 3, 4, 8];

/// A dense box in which nearly everybody changes the bin in every step.
fn everybody_leaves() -> Scene {
    scenes::lattice_with_jitter(150, 10.3 * CUTOFF, 40.0, 5)
}

/// A variant that gives the bits of all pairs, on any number of threads. Two threads that wait for
/// each other are found out soon.
fn check_bits(task: &'static str, variant: &str) {
    for threads in THREADS {
        let grader = Grader::new(task, VARIANTS, variant).threads(threads).seconds(20);
        grader.resynchronised(&scenes::dense(), 20);
        grader.bits_of_all_pairs(&scenes::dense(), 20);
        grader.bits_of_all_pairs(&everybody_leaves(), 20);
        grader.resynchronised_on_each(scenes::edges(), 1);
        grader.resynchronised_on_each((1..=20).map(scenes::crowd).collect(), 2);
        grader.statistics_of_each_step(&scenes::dense(), 5);
        for scene in scenes::fast() {
            grader.resynchronised(&scene, 10);
        }
    }
    let grader = Grader::new(task, VARIANTS, variant).seconds(60);
    grader.same_bits_on_threads(&scenes::dense_with_seed(7), 50, &THREADS);
    grader.threads(3).keeps_everyone(&scenes::dense_with_seed(8), 1000);
}

#[test]
fn task_4_1_everybody_is_in_a_bin_again() {
    let scene = scenes::dense();
    let (inside, left) = scene.particles().split_at(100);
    let mut bins = VecBins::of_scene(&scene, 1.0);
    bins.refill(inside);
    let mut all = vec![scene.particles()[0]; 7];
    let (some, others) = left.split_at(20);
    rebuild(&mut bins, [some, others].into_iter(), &mut all);
    assert_eq!(bins.particles().count(), scene.len(), "particles in the bins");
    for (number, bin) in bins.bins().iter().enumerate() {
        for particle in bin {
            assert_eq!(number, bins.grid().bin(particle), "the bin of particle {}", particle.id);
        }
    }
}

#[test]
fn task_4_1_one_thread_rebuilds() {
    rebuild(&mut VecBins::of_scene(&scenes::dense(), 1.0), std::iter::empty(), &mut Vec::new());
    check_bits("4.1", "serial-rebuild");
}

#[test]
fn task_4_2_every_bin_lies_in_a_region() {
    for bins in [1, 2, 9, 100] {
        for count in [1, 2, 3, 7, 40, 100, 1000] {
            let mark = |bin: usize| vec![Particle { id: bin as u32, ..Particle::default() }];
            let mut lists: Vec<_> = (0..bins).map(mark).collect();
            let regions = Regions::new(&mut lists, count);
            assert!(regions.count() <= count, "{} regions, not {count}", regions.count());
            for bin in 0..bins {
                let (region, place) = regions.find(bin);
                let found = region.lock().get(place).map(|list| list[0].id as usize);
                assert_eq!(
                    found,
                    Some(bin),
                    "bin {bin} of {bins} in {} regions: found another",
                    regions.count()
                );
            }
        }
    }
}

#[test]
fn task_4_3_a_free_lock_costs_no_clock() {
    let mutex = Mutex::new(5);
    let mut meter = Meter::default();
    for _ in 0..3 {
        *meter.lock(&mutex) += 1;
    }
    assert_eq!(*mutex.lock(), 8, "the lock guards what it holds");
    assert_eq!((meter.locks, meter.contended), (3, 0), "locks taken, and waited for");
    assert_eq!(meter.waiting, Duration::ZERO, "nobody waited");
}

#[test]
fn task_4_3_the_wait_is_measured() {
    let (waited, meter) = oracle::within("4.3", 20, || {
        let mutex = Mutex::new(());
        let (held, go) = mpsc::channel();
        thread::scope(|scope| {
            scope.spawn(|| {
                let _guard = mutex.lock();
                held.send(()).unwrap();
                thread::sleep(Duration::from_millis(60));
            });
            go.recv().unwrap();
            let mut meter = Meter::default();
            let start = std::time::Instant::now();
            drop(meter.lock(&mutex));
            (start.elapsed(), meter)
        })
    });
    assert_eq!((meter.locks, meter.contended), (1, 1), "locks taken, and waited for");
    assert!(
        meter.waiting > Duration::ZERO && meter.waiting <= waited,
        "measured {:?} of a wait of {waited:?}",
        meter.waiting
    );
}

#[test]
fn task_4_4_leavers_go_into_their_bins() {
    let scene = scenes::dense();
    let grid = Grid::of_scene(&scene, 1.0);
    for count in [1, 7, 40] {
        let mut bins = VecBins::new(grid);
        let mut meter = Meter::default();
        oracle::within("4.4", 20, {
            let scene = scene.clone();
            move || {
                let regions = Regions::new(bins.bins_mut(), count);
                put_all(&grid, &regions, scene.particles(), &mut meter);
                assert_eq!(meter.locks as usize, scene.len(), "one lock for each particle");
                for (number, bin) in bins.bins().iter().enumerate() {
                    for particle in bin {
                        assert_eq!(
                            number,
                            grid.bin(particle),
                            "the bin of particle {}",
                            particle.id
                        );
                    }
                }
                assert_eq!(bins.particles().count(), scene.len(), "particles in the bins");
            }
        });
    }
}

/// On a starter this stops at task 4.4.
fn reach_4_4() {
    let mut bins = [Vec::new()];
    let regions = Regions::new(&mut bins, 1);
    put_all(&Grid::with_bins_along(1.0, 1), &regions, &[], &mut Meter::default());
}

#[test]
fn task_4_4_under_one_lock() {
    reach_4_4();
    check_bits("4.4", "global-lock");
}

#[test]
fn task_4_4_under_many_locks() {
    reach_4_4();
    check_bits("4.4", "region-locks");
}

#[test]
fn task_4_5_leavers_are_posted_to_their_owners() {
    let scene = scenes::dense();
    let grid = Grid::of_scene(&scene, 1.0);
    let owners: Vec<_> = (0..grid.rows()).map(|row| usize::from(row >= 4)).collect();
    let queues = [SegQueue::new(), SegQueue::new()];
    post(&grid, &owners, &queues, scene.particles());
    assert_eq!(queues[0].len() + queues[1].len(), scene.len(), "particles in the queues");
    for (owner, queue) in queues.iter().enumerate() {
        while let Some(particle) = queue.pop() {
            let expected = owners[grid.row(particle.y)];
            assert_eq!(owner, expected, "whose queue has particle {}", particle.id);
        }
    }
}

#[test]
fn task_4_5_an_owner_empties_its_queue() {
    let scene = scenes::dense();
    let grid = Grid::of_scene(&scene, 1.0);
    let first = 3 * grid.columns();
    let mine = |p: &&Particle| (3..6).contains(&grid.row(p.y));
    let queue = SegQueue::new();
    scene.particles().iter().filter(mine).for_each(|p| queue.push(*p));
    let (count, mut own) = (queue.len(), vec![Vec::new(); 3 * grid.columns()]);
    take(&grid, first, &mut own, &queue);
    assert!(queue.is_empty(), "the queue is empty afterwards");
    assert_eq!(own.iter().flatten().count(), count, "particles in the own bins");
    for (place, bin) in own.iter().enumerate() {
        for particle in bin {
            assert_eq!(first + place, grid.bin(particle), "the bin of particle {}", particle.id);
        }
    }
}

#[test]
fn task_4_5_queues() {
    post(&Grid::with_bins_along(1.0, 1), &[0], &[SegQueue::new()], &[]);
    check_bits("4.5", "queues");
}

#[test]
fn task_4_6_owners_take_everybody_once() {
    let scene = scenes::dense();
    let grid = Grid::of_scene(&scene, 1.0);
    let mut ids = Vec::new();
    for rows in [0..3, 3..4, 4..4, 4..grid.rows()] {
        let mut own = SortedBins::new(grid, rows.clone());
        take_own(&mut own, scene.particles().iter());
        for particle in own.particles() {
            let row = grid.row(particle.y);
            assert!(rows.contains(&row), "particle {} of row {row} in {rows:?}", particle.id);
            ids.push(particle.id);
        }
    }
    ids.sort_unstable();
    assert_eq!(ids, (0..150).collect::<Vec<_>>(), "all owners together have everybody once");
}

#[test]
fn task_4_6_owner_computes() {
    take_own(&mut SortedBins::new(Grid::with_bins_along(1.0, 1), 0..1), std::iter::empty());
    check_bits("4.6", "owner-computes");
}

/// The bins of some rows of a dense box, and the particles in them.
fn strip(rows: std::ops::Range<usize>) -> SortedBins {
    let scene = scenes::dense();
    let grid = Grid::of_scene(&scene, 1.0);
    let mut bins = SortedBins::new(grid, rows.clone());
    bins.refill(scene.particles().iter().filter(|p| rows.contains(&grid.row(p.y))).copied());
    bins
}

/// What the model says that these particles do to each other.
fn forces_among(particles: &[Particle]) -> (Vec<Vec2>, Vec<f64>) {
    let mut model = Model::from_state(10.3 * CUTOFF, particles.to_vec());
    model.step();
    (model.accelerations, model.magnitudes)
}

fn assert_near(task: &str, id: u32, found: Vec2, expected: Vec2, scale: f64) {
    let off = (found - expected).norm_squared().sqrt();
    assert!(
        off <= 1e-12 * scale,
        "task {task}: particle {id} is accelerated by ({:.6e}, {:.6e}), its neighbours make \
         ({:.6e}, {:.6e})",
        found.x,
        found.y,
        expected.x,
        expected.y
    );
}

#[test]
fn task_4_7_every_pair_of_a_strip() {
    for rows in [0..10, 2..5, 3..4] {
        let bins = strip(rows);
        let mut found = vec![Vec2::ZERO; bins.particles().len()];
        let mut tally = Tally::default();
        pairs_within(&bins, &mut found, &mut tally);
        let (expected, scale) = forces_among(bins.particles());
        for (i, particle) in bins.particles().iter().enumerate() {
            assert_near("4.7", particle.id, found[i], expected[i], scale[i]);
        }
        let near = |p: &Particle, q: &Particle| p.to(q).norm_squared() <= CUTOFF * CUTOFF;
        let pairs: usize = bins
            .particles()
            .iter()
            .map(|p| bins.particles().iter().filter(|q| q.id != p.id && near(p, q)).count())
            .sum();
        let seen = tally.statistics().expect("the tally counts");
        assert_eq!(seen.navg as usize, pairs, "ordered pairs within the cutoff");
    }
}

#[test]
fn task_4_7_each_is_looked_at_once() {
    let bins = strip(0..10);
    let mut tally = Tally::default();
    pairs_within(&bins, &mut vec![Vec2::ZERO; bins.particles().len()], &mut tally);
    let both_ways: usize = bins
        .particles()
        .iter()
        .map(|p| bins.around(p).iter().map(|slice| slice.len()).sum::<usize>() - 1)
        .sum();
    let looked = tally.statistics().expect("the tally counts").pair_tests;
    assert_eq!(2 * looked as usize, both_ways, "half of what looking from both sides takes");
}

#[test]
fn task_4_8_the_pair_across_a_cut_counts_once() {
    let (lower, upper) = (strip(2..4), strip(4..7));
    let first_row = upper.places(4..5).len();
    let mut below = vec![Vec2::ZERO; lower.particles().len()];
    let mut across = vec![Vec2::ZERO; first_row];
    pairs_across(&lower, &upper, &mut below, &mut across, &mut NoStatistics);
    // Forces among both strips, less those within each, are those across the cut.
    let both: Vec<_> = lower.particles().iter().chain(upper.particles()).copied().collect();
    let (all, scale) = forces_among(&both);
    let within = [forces_among(lower.particles()).0, forces_among(upper.particles()).0].concat();
    let mut above = vec![Vec2::ZERO; upper.particles().len()];
    add_across(&mut above, &across);
    for (i, particle) in both.iter().enumerate() {
        let found = [&below[..], &above[..]].concat()[i];
        assert_near("4.8", particle.id, found, all[i] - within[i], scale[i]);
    }
}

/// On a starter this stops at task 4.8.
fn reach_4_8() {
    let grid = Grid::with_bins_along(1.0, 2);
    let [lower, upper] = [0..1, 1..2].map(|rows| SortedBins::new(grid, rows));
    pairs_across(&lower, &upper, &mut [], &mut [], &mut NoStatistics);
}

#[test]
fn task_4_8_owners_with_two_way_forces() {
    reach_4_8();
    for threads in [1, 2, 3, 4, 8, 15] {
        let grader = Grader::new("4.8", VARIANTS, "owner-two-way").threads(threads).seconds(30);
        for bin_size in [1.0, 2.0, 3.0] {
            let grader = grader.clone().set("bin-size", bin_size);
            grader.resynchronised(&scenes::dense(), 20);
            grader.resynchronised_on_each(scenes::edges(), 1);
            grader.resynchronised_on_each((1..=20).map(scenes::crowd).collect(), 2);
        }
        grader.forces();
        grader.statistics_of_each_step(&scenes::dense(), 5);
        grader.same_bits_on_threads(&scenes::dense_with_seed(7), 20, &[threads]);
    }
    Grader::new("4.8", VARIANTS, "owner-two-way").threads(2).free_run();
}

#[test]
fn task_4_8_nobody_is_lost() {
    reach_4_8();
    let grader = Grader::new("4.8", VARIANTS, "owner-two-way").threads(3);
    grader.keeps_everyone(&scenes::dense_with_seed(8), 1000);
}
