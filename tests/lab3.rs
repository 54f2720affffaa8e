use common::soft::{CUTOFF, Particle, Scene, NoStatistics};
use lab3::{
    Barrier, Desk, Part, VARIANTS, one_step, own_rows, rebin_by_one, take_arrivals, take_posted,
};
use oracle::{Grader, scenes};
use parking_lot::Mutex;
use solution2::{Gather, Grid, SortedBins, VecBins};

const THREADS: [usize; 5] = [1, 2, 3, 4, 8];

/// A dense box in which nearly everybody changes the bin in every step: a particle goes two
/// cutoffs a step.
fn everybody_leaves() -> Scene {
    scenes::lattice_with_jitter(150, 10.3 * CUTOFF, 40.0, 5)
}

/// All checks of DESIGN for a variant that gives the bits of all pairs.
fn check(task: &'static str, variant: &str, threads: usize) {
    let grader = Grader::new(task, VARIANTS, variant).threads(threads);
    grader.resynchronised(&scenes::dense(), 20);
    grader.bits_of_all_pairs(&scenes::dense(), 20);
    grader.bits_of_all_pairs(&scenes::crowd(2), 4);
    grader.resynchronised_on_each(scenes::edges(), 1);
    grader.resynchronised_on_each((1..=20).map(scenes::crowd).collect(), 2);
    grader.resynchronised(&scenes::close_pairs(), 5);
    grader.bits_of_all_pairs(&everybody_leaves(), 20);
    for scene in scenes::fast() {
        grader.resynchronised(&scene, 10);
    }
    grader.statistics_of_each_step(&scenes::dense(), 5);
}

fn check_on_all_threads(task: &'static str, variant: &str) {
    for threads in THREADS {
        check(task, variant, threads);
    }
    let grader = Grader::new(task, VARIANTS, variant);
    grader.same_bits_on_threads(&scenes::dense_with_seed(7), 50, &THREADS);
    grader.clone().threads(3).keeps_everyone(&scenes::dense_with_seed(8), 1000);
}

/// Bins with `n` particles at rest on a jittered lattice, nine rows of bins.
fn bins() -> VecBins {
    let scene = scenes::lattice_with_jitter(150, 9.5 * CUTOFF, 0.0, 3);
    let mut bins = VecBins::of_scene(&scene, 1.0);
    bins.refill(scene.particles());
    bins
}

#[test]
fn task_3_1_all_pairs_on_several_threads() {
    for threads in [1, 2, 3, 8] {
        check("3.1", "vanilla", threads);
    }
    Grader::new("3.1", VARIANTS, "vanilla").same_bits_on_threads(
        &scenes::dense_with_seed(7),
        20,
        &THREADS,
    );
}

#[test]
fn task_3_1_the_official_bytes() {
    Grader::new("3.1", VARIANTS, "vanilla").threads(2).official_bytes();
}

#[test]
fn task_3_2_every_row_has_one_owner() {
    for rows in 1..=40 {
        for workers in 1..=20 {
            let mut next = 0;
            for worker in 0..workers {
                let own = own_rows(worker, workers, rows);
                assert_eq!(own.start, next, "worker {worker} of {workers}, {rows} rows: {own:?}");
                next = own.end;
            }
            assert_eq!(next, rows, "{workers} workers own {next} of {rows} rows");
        }
    }
}

#[test]
fn task_3_2_nobody_has_much_more_than_another() {
    for (rows, workers) in [(15, 8), (7, 3), (3, 8), (100, 16)] {
        let sizes: Vec<_> = (0..workers).map(|w| own_rows(w, workers, rows).len()).collect();
        let (least, most) = (sizes.iter().min(), sizes.iter().max());
        assert!(
            most.unwrap() - least.unwrap() <= 1,
            "{rows} rows among {workers} workers are cut into {sizes:?}"
        );
    }
}

#[test]
fn task_3_2_table_of_cuts() {
    let mut table = String::from("rows  workers  own rows\n");
    for (rows, workers) in [(10, 1), (10, 2), (10, 3), (15, 8), (3, 5)] {
        let cuts: Vec<_> =
            (0..workers).map(|w| format!("{:?}", own_rows(w, workers, rows))).collect();
        table += &format!("{rows:>4}  {workers:>7}  {}\n", cuts.join("  "));
    }
    insta::assert_snapshot!(table);
}

#[test]
fn task_3_3_the_forces_on_own_particles() {
    let bins = bins();
    let columns = bins.grid().columns();
    let mut desk = Desk::<NoStatistics>::new(2..5);
    // A second call must not add to what the first one left.
    desk.sum_forces(&bins);
    desk.sum_forces(&bins);
    let own: Vec<_> = bins.bins()[2 * columns..5 * columns].iter().flatten().collect();
    let mut gather = Gather::default();
    assert_eq!(desk.accelerations.len(), own.len(), "accelerations for rows 2, 3 and 4");
    for (p, found) in own.into_iter().zip(&desk.accelerations) {
        let expected = gather.acceleration(p, bins.around(p), &mut NoStatistics);
        assert_eq!(*found, expected, "the acceleration of particle {}, summed twice", p.id);
    }
    assert_eq!(desk.seen.len(), 3, "one observer for each of three rows");
}

#[test]
fn task_3_4_leavers_go_into_the_change_buffer() {
    let mut bins = bins();
    let grid = *bins.grid();
    let columns = grid.columns();
    let mut desk = Desk::<NoStatistics>::new(2..5);
    desk.changed.push(Particle { id: 7777, ..Particle::default() });
    let own = &mut bins.bins_mut()[2 * columns..5 * columns];
    // One step to the right takes the fast ones out of their bin.
    for (i, particle) in own.iter_mut().flatten().enumerate() {
        particle.vx = if i % 3 == 0 { 15.0 } else { 0.0 };
    }
    let before = own.iter().flatten().count();
    desk.accelerations = vec![common::Vec2::ZERO; before];
    desk.move_particles(&grid, own);
    assert!(
        desk.changed.iter().all(|p| p.id != 7777),
        "what was in the buffer from the step before is still there"
    );
    let stay = own.iter().flatten().count();
    assert_eq!(stay + desk.changed.len(), before, "particles in the bins and in the buffer");
    for (bin, inside) in own.iter().enumerate() {
        for particle in inside {
            let stays = 2 * columns + bin;
            assert_eq!(stays, grid.bin(particle), "the bin of particle {} afterwards", particle.id);
        }
    }
    assert!(!desk.changed.is_empty(), "the fast particles have left their bins");
    for particle in &desk.changed {
        assert!(particle.vx > 0.0, "particle {} is at rest and left no bin", particle.id);
    }
}

#[test]
fn task_3_5_the_buffers_are_emptied_into_the_bins() {
    let scene = scenes::dense();
    let grid = Grid::of_scene(&scene, 1.0);
    let mut bins = VecBins::new(grid);
    let (a, b) = scene.particles().split_at(60);
    rebin_by_one(&mut bins, [a, b].into_iter());
    for (number, bin) in bins.bins().iter().enumerate() {
        for particle in bin {
            assert_eq!(number, grid.bin(particle), "the bin of particle {}", particle.id);
        }
    }
    assert_eq!(bins.particles().count(), scene.len(), "particles in the bins");
}

#[test]
fn task_3_5_fork_and_join() {
    // Reaches task 3.5 before anything else of the step.
    rebin_by_one(&mut bins(), std::iter::empty());
    check_on_all_threads("3.5", "fork-join");
}

#[test]
fn task_3_6_everybody_takes_what_is_theirs() {
    let scene = scenes::dense();
    let grid = Grid::of_scene(&scene, 1.0);
    let columns = grid.columns();
    let (a, b) = scene.particles().split_at(60);
    let mut found = 0;
    for rows in [0..3, 3..4, 4..grid.rows()] {
        let mut own = vec![Vec::new(); rows.len() * columns];
        take_arrivals(&grid, rows.start * columns, &mut own, [a, b].into_iter());
        for (bin, inside) in own.iter().enumerate() {
            for particle in inside {
                let taken = rows.start * columns + bin;
                assert_eq!(taken, grid.bin(particle), "the bin of particle {}", particle.id);
            }
        }
        found += own.iter().flatten().count();
    }
    assert_eq!(found, scene.len(), "particles taken by three workers together");
}

#[test]
fn task_3_6_rebinning_by_all() {
    take_arrivals(bins().grid(), 0, &mut [], std::iter::empty());
    check_on_all_threads("3.6", "parallel-rebin");
}

#[test]
fn task_3_6_packed_desks_give_the_same() {
    take_arrivals(bins().grid(), 0, &mut [], std::iter::empty());
    let packed = Grader::new("3.6", VARIANTS, "parallel-rebin").set("padding", 0.0).threads(3);
    packed.bits_of_all_pairs(&scenes::dense(), 20);
}

#[test]
fn task_3_7_arrivals_of_a_crew_member() {
    let grid = Grid::with_bins_along(1.0, 4);
    let mut bins = SortedBins::new(grid, 1..2);
    let at = |id: u32, x: f64| Particle { id, x, y: 0.3, ..Particle::default() };
    bins.refill([at(0, 0.9), at(1, 0.1)]);
    let post = |letters: &[Particle]| Mutex::new(letters.to_vec());
    let mail = vec![
        vec![post(&[at(9, 0.5)]), post(&[at(2, 0.6), at(3, 0.2)])],
        vec![post(&[]), post(&[at(4, 0.7)])],
    ];
    take_posted(&mut bins, 1, &mail);
    let mut ids: Vec<_> = bins.particles().iter().map(|p| p.id).collect();
    ids.sort_unstable();
    assert_eq!(ids, [0, 1, 2, 3, 4], "the own particles and those posted to member 1");
    assert_eq!(bins.bin(1, 0).len(), 2, "the bins are sorted afterwards");
    assert!(mail[0][1].lock().is_empty() && mail[1][1].lock().is_empty(), "the mailbox is empty");
    assert_eq!(mail[0][0].lock().len(), 1, "the mail of others is none of its business");
}

#[test]
fn task_3_8_nobody_begins_a_part_too_early() {
    // Each member notes when it begins and when it ends a part, and dawdles in between, each in
    // its own way. No part may begin before everybody has ended the one before.
    let notes = oracle::within("3.8", 60, || {
        let (barrier, notes) = (Barrier::new(3), Mutex::new(Vec::new()));
        std::thread::scope(|scope| {
            for member in 0..3 {
                let (barrier, notes) = (&barrier, &notes);
                scope.spawn(move || {
                    let _membership = barrier.membership();
                    for step in 0..6 {
                        let part = |part: Part| {
                            let turn = 3 * step + part as usize;
                            notes.lock().push((turn, member, "begins"));
                            let pause = (member + turn) % 3;
                            std::thread::sleep(std::time::Duration::from_millis(4 * pause as u64));
                            notes.lock().push((turn, member, "ends"));
                        };
                        one_step(part, barrier);
                    }
                });
            }
        });
        notes.into_inner()
    });
    assert_eq!(notes.len(), 3 * 18 * 2, "three members, six steps of three parts each");
    let mut ended = [0; 18];
    for (turn, member, what) in notes {
        if what == "ends" {
            ended[turn] += 1;
        } else if turn > 0 {
            let parts = ["forces", "moves", "arrivals"];
            assert_eq!(
                ended[turn - 1],
                3,
                "task 3.8: member {member} begins with the {} of step {} when only {} of 3 have \
                 ended the part before",
                parts[turn % 3],
                turn / 3,
                ended[turn - 1]
            );
        }
    }
}

/// On a starter this stops at task 3.8, before the crew asks who owns what.
fn crew() -> Grader {
    one_step(|_| (), &Barrier::new(1));
    Grader::new("3.8", VARIANTS, "crew")
}

#[test]
fn task_3_8_the_crew() {
    crew();
    check_on_all_threads("3.8", "crew");
}

#[test]
fn task_3_8_a_late_member_changes_nothing() {
    for late in 1..=4 {
        let grader = crew().threads(4).set("late", f64::from(late));
        grader.bits_of_all_pairs(&everybody_leaves(), 12);
        grader.bits_after_a_run(&everybody_leaves(), 12);
    }
}

#[test]
fn task_3_8_the_official_bytes() {
    crew().threads(2).official_bytes();
}
