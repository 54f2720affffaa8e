//! Questions about changes of bins that are recorded or handed over: in buffers, queues and
//! channels.

use std::collections::HashMap;
use std::sync::Arc;

use common_threads::Watch;
use crossbeam::channel::unbounded;
use crossbeam::queue::SegQueue;
use lab4::{Bin, Change, Cut, Regions, apply_all, apply_own, post, receive, send, take};
use oracle::{Ask, Random, integers};

use super::bins::{places, regions_of};
use super::meters::Requests;

/// Particles with any ids in any bins, and changes of some of them, in several buffers.
struct Changes {
    bins: usize,
    cut: Cut,
    /// Bin and particle.
    residents: Vec<(usize, u32)>,
    changes: Vec<Change>,
    /// Ends of the buffers; some buffers are empty.
    ends: Vec<usize>,
}

/// A change that an owner receives: the owner, the particle, its old bin and its new bin.
type Letter = [usize; 4];

impl Changes {
    fn drawn(random: &mut Random, case: usize) -> Self {
        let bins = [2, 12, 300, 70_000][case % 4];
        let bins_each = [1, 1 + random.below(6), 1 + random.size(bins)][random.below(3)];
        let n = random.size(4097);
        let apart = [1, 1 << 16, 1_000_003][random.below(3)];
        let mut residents = Vec::new();
        let mut changes = Vec::new();
        for k in 0..n {
            let from = random.below(bins);
            let to = random.below(bins);
            let particle = (k * apart) as u32;
            residents.push((from, particle));
            if from != to {
                changes.push(Change { particle, from, to });
            }
        }
        random.shuffle(&mut changes);
        let all = changes.len();
        let mut ends: Vec<usize> = (0..random.size(33)).map(|_| random.below(all + 1)).collect();
        ends.extend([0, all, all]);
        ends.sort_unstable();
        Self { bins, cut: Cut { bins_each }, residents, changes, ends }
    }

    fn name(&self) -> String {
        format!(
            "{} particles in {} bins, up to {} bins in a region, {} changes in {} buffers, some of which are empty",
            self.residents.len(),
            self.bins,
            self.cut.bins_each,
            self.changes.len(),
            self.ends.len() - 1
        )
    }

    /// Returns the bins before the changes.
    fn regions(&self) -> Regions {
        let mut bins = vec![Bin::new(); self.bins];
        self.residents.iter().for_each(|(bin, particle)| bins[*bin].push(*particle));
        regions_of(self.cut.bins_each, &bins)
    }

    fn buffers(&self) -> impl Iterator<Item = &[Change]> {
        self.ends.windows(2).map(|ends| &self.changes[ends[0]..ends[1]])
    }

    /// Returns the regions that a change concerns, and a few others.
    fn owners(&self) -> Vec<usize> {
        let each = self.cut.bins_each;
        let concerned = self.changes.iter().flat_map(|c| [c.from / each, c.to / each]);
        let mut owners: Vec<usize> =
            (0..self.bins.div_ceil(each).min(3)).chain(concerned).collect();
        owners.sort_unstable();
        owners.dedup();
        owners
    }

    /// Asks for the bins of all particles.
    fn ask(&self, how: &str, regions: &mut Regions, ask: &mut impl Ask) {
        let name = self.name();
        let question =
            format!("{name}; changes {how}: id and bin of each particle that is in a bin");
        ask.judge(&question, || places(regions), |found| self.are_made(found));
    }

    /// Checks that each particle is in its bin and in no other bin after all changes.
    fn are_made(&self, found: &[f64]) -> Result<(), String> {
        let mut bins: HashMap<u32, Vec<usize>> = HashMap::new();
        for [particle, bin] in found.as_chunks::<2>().0 {
            bins.entry(*particle as u32).or_default().push(*bin as usize);
        }
        let to: HashMap<u32, usize> = self.changes.iter().map(|c| (c.particle, c.to)).collect();
        for (from, particle) in &self.residents {
            let bins = bins.remove(particle).unwrap_or_default();
            let right = to.get(particle).unwrap_or(from);
            if bins != [*right] {
                return Err(format!(
                    "the bins that contain particle {particle}, which was in bin {from}\n     found: {bins:?}\n  \
                     expected: [{right}]"
                ));
            }
        }
        match bins.keys().next() {
            None => Ok(()),
            Some(particle) => {
                Err(format!("a bin contains particle {particle}, which does not exist"))
            }
        }
    }

    /// Asks for the changes that each owner has received.
    fn ask_letters(&self, received: &[(usize, Change)], ask: &mut impl Ask) {
        let question = format!(
            "{}: for each change that an owner receives, in ascending order: the owner, the particle, the old bin and \
             the new bin",
            self.name()
        );
        let found = || in_order(received.iter().map(|(owner, c)| letter(*owner, c)).collect());
        ask.exact(&question, found, || in_order(self.letters()));
    }

    /// Returns the changes that the owners must receive.
    fn letters(&self) -> Vec<Letter> {
        let mut letters = Vec::new();
        for change in &self.changes {
            let mut owners = [change.from, change.to].map(|bin| bin / self.cut.bins_each).to_vec();
            owners.dedup();
            letters.extend(owners.into_iter().map(|owner| letter(owner, change)));
        }
        letters
    }
}

fn letter(owner: usize, c: &Change) -> Letter {
    [owner, c.particle as usize, c.from, c.to]
}

fn in_order(mut letters: Vec<Letter>) -> Vec<f64> {
    letters.sort_unstable();
    integers(letters.into_iter().flatten())
}

/// Asks one thread to make the changes of all buffers.
pub(crate) fn by_one(random: &mut Random, ask: &mut impl Ask) {
    for case in 0..40 {
        let all = Changes::drawn(random, case);
        let mut regions = all.regions();
        let requests = Arc::<Requests>::default();
        regions.watch(&(requests.clone() as Arc<dyn Watch>));
        apply_all(&mut regions, all.buffers());
        all.ask("made by one thread", &mut regions, ask);
        let question =
            format!("{}; one thread is alone: number of locks that it takes", all.name());
        ask.exact(&question, || integers([requests.count()]), || integers([0]));
    }
}

/// Asks the owners to make the changes of all buffers.
pub(crate) fn by_owners(random: &mut Random, ask: &mut impl Ask) {
    for case in 0..40 {
        let all = Changes::drawn(random, case);
        let mut regions = all.regions();
        for own in all.owners() {
            let bins = regions.locks[own].get_mut();
            apply_own(all.cut, own, bins, all.buffers().flatten().copied());
        }
        all.ask("made by the owners", &mut regions, ask);
    }
}

/// Asks about changes through queues: the receivers of the changes, and the bins afterwards.
pub(crate) fn queues(random: &mut Random, ask: &mut impl Ask) {
    for case in 0..40 {
        let all = Changes::drawn(random, case);
        let mut regions = all.regions();
        let queues: Vec<_> = regions.locks.iter().map(|_| SegQueue::new()).collect();
        all.changes.iter().for_each(|change| post(all.cut, &queues, *change));
        let mut received = Vec::new();
        for (owner, queue) in queues.iter().enumerate() {
            received.extend(std::iter::from_fn(|| queue.pop()).map(|change| (owner, change)));
        }
        all.ask_letters(&received, ask);
        // The posted changes go back into the queues.
        received.into_iter().for_each(|(owner, change)| queues[owner].push(change));
        for own in all.owners() {
            take(all.cut, own, regions.locks[own].get_mut(), &queues[own]);
        }
        let question = format!("{}: number of changes left in the queues", all.name());
        let left = || queues.iter().map(SegQueue::len).sum();
        ask.exact(&question, || integers([left()]), || integers([0]));
        all.ask("taken from queues", &mut regions, ask);
    }
}

/// Asks about changes through channels.
pub(crate) fn channels(random: &mut Random, ask: &mut impl Ask) {
    for case in 0..40 {
        let all = Changes::drawn(random, case);
        let mut regions = all.regions();
        let (senders, receivers): (Vec<_>, Vec<_>) =
            regions.locks.iter().map(|_| unbounded()).unzip();
        all.changes.iter().for_each(|change| send(all.cut, &senders, *change));
        let sent = receivers.iter().enumerate();
        let sent = sent.flat_map(|(owner, receiver)| receiver.try_iter().map(move |c| (owner, c)));
        let received: Vec<(usize, Change)> = sent.collect();
        all.ask_letters(&received, ask);
        // The received changes are sent again.
        for (owner, change) in received {
            senders[owner].send(change).expect("the channel has a receiver");
        }
        for own in all.owners() {
            receive(all.cut, own, regions.locks[own].get_mut(), &receivers[own]);
        }
        all.ask("received from channels", &mut regions, ask);
    }
}
