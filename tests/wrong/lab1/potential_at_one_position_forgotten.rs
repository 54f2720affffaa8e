// region: 1.5b
// fails: task_1_5_energies_of_any_number_of_particles
// story: Pairs at one position are taken for a particle with itself, though they hold the most energy.
let mut sum = 0.0;
for (i, particle) in particles.iter().enumerate() {
    for other in &particles[i + 1..] {
        let d = particle.to(other);
        if d.norm_squared() > 0.0 {
            sum += pair_potential(d);
        }
    }
}
sum
