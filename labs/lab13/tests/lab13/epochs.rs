#[test]
fn task_13_7_what_is_wrong_comes_nearer() {
    for steps in 1..30 {
        for fastest in [0.0, 0.05 * CUTOFF, 0.7 * CUTOFF, 40.0 * CUTOFF] {
            let width = deep_width(fastest, steps);
            // The nearest particle that the rank does not know, and its own that comes to meet it.
            let (mut wrong, mut own) = (width * (1.0 + 1e-9), 0.0);
            for step in 1..=steps {
                // Whatever is within a cutoff of a wrong particle is pushed wrongly.
                wrong -= CUTOFF;
                assert!(
                    wrong > own,
                    "ghosts {} cutoffs deep for {steps} steps of {} cutoffs: in step {step} an own \
                     particle is pushed by one that has gone wrong",
                    width / CUTOFF,
                    fastest / CUTOFF
                );
                (wrong, own) = (wrong - fastest, own + fastest);
            }
            let spare = width - f64::from(steps) * CUTOFF - 2.0 * f64::from(steps - 1) * fastest;
            assert!(
                spare <= 1e-9 * width,
                "ghosts {} cutoffs deep for {steps} steps of {} cutoffs are deeper than they need be",
                width / CUTOFF,
                fastest / CUTOFF
            );
        }
    }
}

#[test]
fn task_13_7_no_other_epoch_is_cheaper() {
    let mut random = Random::new(137);
    for _ in 0..200 {
        let fastest = CUTOFF * 10_f64.powf(random.between(-3.0, 1.5));
        let height = CUTOFF * 10_f64.powf(random.between(0.3, 3.5));
        let particles = 10_f64.powf(random.between(0.0, 6.0));
        let most = 1 + random.between(0.0, 40.0) as u32;
        let found = best_depth(Outlook { fastest, height, particles, most });
        assert!((1..=most).contains(&found), "an epoch of {found} steps, where lists last {most}");
        let cost = |steps: u32| {
            let m = f64::from(steps);
            let depth = m * CUTOFF + 2.0 * (m - 1.0) * fastest;
            let particle = STEP + RENEWAL / m;
            particle + 2.0 * depth / height * particle + WAIT / (particles * m)
        };
        for steps in 1..=most {
            assert!(
                cost(found) <= cost(steps) * (1.0 + 1e-12),
                "an epoch of {steps} steps is cheaper than one of {found}: the fastest goes {} cutoffs in \
                 a step, {particles:.0} particles in strips {} cutoffs high",
                fastest / CUTOFF,
                height / CUTOFF
            );
        }
    }
    let outlook = Outlook { fastest: 0.0, height: 1.0, particles: 1.0, most: 1 };
    assert_eq!(best_depth(outlook), 1, "where lists last one step");
}

#[test]
fn task_13_8_steps_are_right_until_the_ghosts_are_used_up() {
    for (moves, width, right, words) in [
        (vec![0.0; 4], 4.0, 4, "no particle moves, and ghosts are 4 cutoffs deep"),
        (vec![0.0; 4], 3.5, 3, "no particle moves, and ghosts are 3.5 cutoffs deep"),
        (vec![9.0], 1.0, 1, "in the first step forces are right, however far particles then go"),
        (vec![9.0, 9.0, 9.0], 1.0, 1, "ghosts for one step, and three were taken"),
        (vec![0.5, 0.5, 0.5], 5.0, 3, "particles go half a cutoff, as was foreseen"),
        (vec![0.5, 0.5, 9.0], 5.0, 3, "only the last move went further than was foreseen"),
        (vec![0.5, 9.0, 0.5], 5.0, 2, "the second move went further than was foreseen"),
        (vec![9.0, 0.0, 0.0], 5.0, 1, "the first move went further than was foreseen"),
        (vec![0.75, 0.125, 0.5], 5.0, 3, "what the second move spared made up for the first"),
        (vec![0.75, 0.375, 0.5], 5.0, 2, "the second move spared less than the first went too far"),
    ] {
        let moves: Vec<f64> = moves.into_iter().map(|far| far * CUTOFF).collect();
        // Not to the last bit: the sum may be taken in another order.
        let found = right_steps(&moves, width * CUTOFF * (1.0 + 1e-9));
        assert_eq!(found, right, "how many of {} steps are right: {words}", moves.len());
    }
}

#[test]
fn task_13_8_all_ranks_go_back_or_none() {
    on_each("13.8", &[1, 2, 3, 5], |world| {
        let (rank, ranks) = (world.rank(), world.size());
        let width = 4.001 * CUTOFF;
        for fast in 0..ranks {
            for step in 0..4 {
                // One particle of one rank goes too far in one step.
                let mut said = vec![0.0; 6];
                if rank == fast {
                    said[step] = 2.0 * CUTOFF;
                }
                said[4 + rank as usize % 2] = f64::from(10 + rank);
                let right = confirm(world, &mut said, 4, width);
                assert_eq!(
                    right,
                    (step + 1).min(4),
                    "right steps of 4 by what rank {rank} finds, when a particle of rank {fast} goes too far \
                     in step {}",
                    step + 1
                );
                assert_eq!(said[step], 2.0 * CUTOFF, "the greatest move of step {}", step + 1);
                let greatest = |odd: i32| {
                    let ranks = (0..ranks).filter(|rank| rank % 2 == odd);
                    ranks.map(|rank| f64::from(10 + rank)).fold(0.0, f64::max)
                };
                assert_eq!(
                    said[4..],
                    [greatest(0), greatest(1)],
                    "the other numbers that were said"
                );
            }
        }
        // Each rank alone has kept to what was foreseen; no one particle need have gone so far.
        if ranks > 1 {
            let mut said = vec![0.0; 3];
            said[rank as usize % 2] = 0.3 * CUTOFF;
            let right = confirm(world, &mut said, 3, 4.0 * CUTOFF);
            assert_eq!(right, 2, "some ranks have a fast particle in step 1, some in step 2");
        }
    });
}
