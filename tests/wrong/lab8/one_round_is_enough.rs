// region: 8.13
// fails: task_8_13_the_bits_of_one_rank
// story: Take, tell, take again, and done. Most steps are right. In the tower of discs a decision has to travel through several strips.
self.decisions.take_certain();
self.add_up(self.decisions.front.len());
let news = partners.iter().map(|&partner| self.decisions.news_for(partner)).collect();
self.decisions.told = self.decisions.taken.len();
let (arrived, ()) = self.exchange(partners, news, || ());
self.decisions.hear(&arrived.concat());
self.decisions.take_certain();
