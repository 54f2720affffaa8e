// region: 8.13
// fails: task_8_13_cuts_that_move
// story: A rank with nothing open and nothing to tell stops, and goes on to move its discs. The others wait for its news.
loop {
    self.docket.take_certain();
    let untold = self.docket.taken.len() - self.docket.told;
    if self.docket.front.len() + untold == 0 {
        return;
    }
    let news = partners.iter().map(|&partner| self.docket.news_for(partner)).collect();
    self.docket.told = self.docket.taken.len();
    let (arrived, ()) = self.exchange(partners, news, || ());
    self.docket.hear(&arrived.concat());
}
