// region: 8.10
// fails: task_8_10_nothing_is_taken_that_others_could_prevent, task_8_11_ranks_together_take_what_one_would
// story: A candidate at the same time as its rival goes first at home, whatever the numbers say: at a tie both ranks take theirs.
loop {
    let mut open = std::mem::take(&mut self.open);
    open.retain(|candidate| self.places(candidate).all(|place| self.free[place]));
    for candidate in &open {
        for place in self.places(candidate) {
            let note = &mut self.notes[place];
            if note.is_none_or(|note| order(candidate, &note).is_lt()) {
                *note = Some(*candidate);
            }
        }
    }
    let before = self.taken.len();
    for candidate in &open {
        let first = |place: usize| {
            self.notes[place] == Some(*candidate)
                && self.rivals[place].is_none_or(|rival| candidate.time <= rival.time)
        };
        if self.places(candidate).all(first) {
            self.places(candidate).for_each(|place| self.free[place] = false);
            self.taken.push(*candidate);
        }
    }
    for candidate in &open {
        self.places(candidate).for_each(|place| self.notes[place] = None);
    }
    self.open = open;
    if self.taken.len() == before {
        return;
    }
}
