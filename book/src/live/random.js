// The kit's random numbers: MT19937, and what the C++ library makes of its words.
"use strict";
(() => {
  // MT19937.
  class Twister {
    constructor(seed) {
      this.state = new Uint32Array(624);
      this.state[0] = seed;
      for (let i = 1; i < 624; i++) {
        const before = this.state[i - 1] ^ (this.state[i - 1] >>> 30);
        this.state[i] = Math.imul(1812433253, before) + i;
      }
      this.next = 624;
    }

    word() {
      const s = this.state;
      if (this.next === 624) {
        for (let i = 0; i < 624; i++) {
          const y = (s[i] & 0x80000000) | (s[(i + 1) % 624] & 0x7fffffff);
          s[i] = s[(i + 397) % 624] ^ (y >>> 1) ^ (y & 1 ? 0x9908b0df : 0);
        }
        this.next = 0;
      }
      let y = s[this.next++];
      y ^= y >>> 11;
      y ^= (y << 7) & 0x9d2c5680;
      y ^= (y << 15) & 0xefc60000;
      return (y ^ (y >>> 18)) >>> 0;
    }

    // An integer below `range`, by Lemire's method.
    below(range) {
      const product = () => BigInt(this.word()) * BigInt(range);
      let p = product();
      if (BigInt.asUintN(32, p) < range) {
        const threshold = BigInt((2 ** 32 - range) % range);
        while (BigInt.asUintN(32, p) < threshold) p = product();
      }
      return Number(p >> 32n);
    }

    // A number in -1 .. 1, in single precision.
    speed() {
      const unit = Math.min(Math.fround(this.word()) / 2 ** 32, 1 - 2 ** -24);
      return Math.fround(unit * 2 - 1);
    }
  }

  globalThis.Twister = Twister;
})();
