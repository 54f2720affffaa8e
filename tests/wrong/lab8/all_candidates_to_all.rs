// region: 8.13
// fails: task_8_13_ranks_talk_to_the_two_beside_them
// story: All ranks get all candidates, and each decides about all of them, as the master of lab 8 did.
use hard_disc_ranks::CandidateWire;
use mpi::datatype::PartitionMut;
use mpi::traits::{Communicator, CommunicatorCollectives};
use solution7::{Candidate, take_in_order};
let _ = (partners, take_certain as fn(&mut _), news_for as fn(&_, _) -> _, hear as fn(&mut _, &_));
let (known, world) = (&engine.decisions, &engine.world);
let here: Vec<Candidate> = known.queues.all().iter().map(|c| known.named(c)).collect();
let own: Vec<CandidateWire> = here.iter().map(CandidateWire::from).collect();
let mut counts = vec![0_i32; world.size() as usize];
world.all_gather_into(&(own.len() as i32), &mut counts[..]);
let mut all = vec![CandidateWire::default(); counts.iter().sum::<i32>() as usize];
let mut parts = PartitionMut::new(&mut all[..], &counts[..], common_mpi::displacements(&counts));
world.all_gather_varcount_into(&own[..], &mut parts);
let mut all: Vec<Candidate> = all.iter().map(Candidate::from).collect();
let discs = all.iter().flat_map(|c| [Some(c.hit.first()), c.hit.second()]).flatten();
let (mut free, mut taken) = (vec![true; discs.max().map_or(0, |most| most as usize + 1)], vec![]);
take_in_order(&mut all, &mut free, &mut taken);
for slot in taken.iter().flat_map(|candidate| known.slots(candidate)).collect::<Vec<_>>() {
    engine.decisions.free[slot] = false;
}
taken.retain(|candidate| here.contains(candidate));
engine.decisions.taken = taken;
