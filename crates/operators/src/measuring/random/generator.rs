//! Random numbers that are the same everywhere.

use std::f64::consts::PI;

/// The generator xoshiro256++ of D. Blackman and S. Vigna, *Scrambled linear pseudorandom number
/// generators*, 2018, seeded by their splitmix64.
pub(super) struct Generator([u64; 4]);

impl Generator {
    pub(super) fn new(seed: u64) -> Self {
        let mut state = seed;
        Self([(); 4].map(|()| {
            state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
            let mixed = (state ^ (state >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
            let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
            mixed ^ (mixed >> 31)
        }))
    }

    fn next(&mut self) -> u64 {
        let s = &mut self.0;
        let number = s[0].wrapping_add(s[3]).rotate_left(23).wrapping_add(s[0]);
        let shifted = s[1] << 17;
        s[2] ^= s[0];
        s[3] ^= s[1];
        s[1] ^= s[2];
        s[0] ^= s[3];
        s[2] ^= shifted;
        s[3] = s[3].rotate_left(45);
        number
    }

    /// From 0 to 1, without 1: a multiple of 2⁻⁵³.
    pub(super) fn unit(&mut self) -> f64 {
        (self.next() >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// Normal about 1/2 with standard deviation 1/6, between 0 and 1.
    pub(super) fn middling(&mut self) -> f64 {
        loop {
            let radius = (-2.0 * libm::log(1.0 - self.unit())).sqrt();
            let number = 0.5 + radius * libm::cos(2.0 * PI * self.unit()) / 6.0;
            if (0.0..=1.0).contains(&number) {
                return number;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_numbers_are_those_of_the_authors() {
        // splitmix64 from 0, then xoshiro256++ on the state 1, 2, 3, 4.
        assert_eq!(Generator::new(0).0[0], 0xe220_a839_7b1d_cdaf);
        let mut random = Generator([1, 2, 3, 4]);
        assert_eq!([random.next(), random.next()], [41_943_041, 58_720_359]);
    }
}
