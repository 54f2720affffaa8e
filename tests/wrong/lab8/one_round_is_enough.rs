// region: 8.13
// fails: task_8_13_the_bits_of_one_rank
// story: Take, tell, take again, and done. Most steps are right. In the tower of discs a decision has to travel through several strips.
self.docket.take_certain();
self.add_up(self.docket.front.len());
let news = partners.iter().map(|&partner| self.docket.news_for(partner)).collect();
self.docket.told = self.docket.taken.len();
let (arrived, ()) = self.exchange(partners, news, || ());
self.docket.hear(&arrived.concat());
self.docket.take_certain();
