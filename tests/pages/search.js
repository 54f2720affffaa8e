// Asks the search of the built book for terms of the field: the first hit must be the section that teaches the term.
//
//   node tests/pages/search.js    after `cargo lab book`
"use strict";
const fs = require("fs");
const path = require("path");
const vm = require("vm");

const BOOK = path.join(__dirname, "../../book/build");
// A term, and the beginning of the address that the first hit must have.
const TERMS = {
  "alltoallv": "lab6.html#alltoallv",
  "amdahl": "lab3.html#rebinning-by-one",
  "allreduce": "lab13.html#when-all-must-agree",
  "barrier": "lab3.html#barriers",
  "branch misprediction": "lab10.html#the-neighbours-of-a-particle",
  "cell list": "lab2.html#the-bins",
  "coalescing": "lab9.html#in-step",
  "compare-and-swap": "lab3.html#a-reduction-three-ways",
  "critical section": "lab7.html#one-list-for-all",
  "data race": "races.html#in-c",
  "deadlock": "lab4.html#two-locks",
  "domain decomposition": "lab5.html#blocks-of-rows",
  "dynamic schedule": "lab7.html#the-queue",
  "false sharing": "lab3.html#false-sharing",
  "gatherv": "lab5.html#gather",
  "ghost cells": "lab5.html#ghosts",
  "halo exchange": "lab6.html#both-ways-at-once",
  "leapfrog": "lab12.html#three-compositions",
  "linked list": "lab2.html#linked-lists",
  "load imbalance": "lab6.html#balance",
  "lock-free": "lab4.html#queues",
  "memory ordering": "lab3.html#a-reduction-three-ways",
  "neighbour list": "lab10.html#a-list-and-its-skin",
  "non-blocking": "lab6.html#both-ways-at-once",
  "occupancy": "lab9.html#in-step",
  "predication": "lab10.html#the-neighbours-of-a-particle",
  "prefix sum": "lab9.html#a-prefix-sum",
  "race condition": "lab3.html#a-reduction-three-ways",
  "roofline": "lab10-more.html#what-limits-it",
  "runge-kutta": "lab12.html#runge-kutta",
  "sendrecv": "lab6.html#both-ways-at-once",
  "simd": "lab10.html#eight-at-a-time",
  "speed-up": "lab3.html#strong-and-weak-scaling",
  "speedup": "lab3.html#strong-and-weak-scaling",
  "stream compaction": "lab10.html#a-list-within-the-list",
  "strong scaling": "lab3.html#strong-and-weak-scaling",
  "structure of arrays": "lab2.html#sorted",
  "symplectic": "lab12.html#the-energy-of-a-composition",
  "velocity verlet": "lab12.html#three-compositions",
  "work stealing": "lab3.html#the-quick-win",
};

// Runs a script of the book whose name begins so, as a browser does.
function run(name, context) {
  const file = fs.readdirSync(BOOK).find(file => file.startsWith(name) && file.endsWith(".js"));
  if (!file) throw new Error(`no ${name}*.js in ${BOOK}: build the book first`);
  vm.runInContext(fs.readFileSync(path.join(BOOK, file), "utf8"), context);
}

const context = vm.createContext({ window: { search: {} } });
run("elasticlunr", context);
run("searchindex", context);
const { search } = context.window;
const index = context.elasticlunr.Index.load(search.index);
let faults = 0;
for (const [term, expected] of Object.entries(TERMS)) {
  const [first] = index.search(term, search.search_options);
  const found = first ? search.doc_urls[first.ref] : "nothing";
  if (found.startsWith(expected)) continue;
  console.log(`the search for '${term}' leads to ${found}, not to ${expected}`);
  faults += 1;
}
console.log(`${Object.keys(TERMS).length} terms, ${faults} faults`);
process.exit(faults > 0 ? 1 : 0);
