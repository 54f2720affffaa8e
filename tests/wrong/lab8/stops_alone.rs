// region: 8.13
// fails: task_8_13_cuts_that_move
// story: A rank with nothing open and nothing to tell stops, and goes on to move its discs. The other ranks wait for its news.
loop {
    self.decisions.take_certain();
    let untold = self.decisions.taken.len() - self.decisions.told;
    if self.decisions.front.len() + untold == 0 {
        return;
    }
    let news = partners.iter().map(|&partner| self.decisions.news_for(partner)).collect();
    self.decisions.told = self.decisions.taken.len();
    let (arrived, ()) = self.exchange(partners, news, || ());
    self.decisions.hear(&arrived.concat());
}
