//! Numbers as colours: differences with a sign, and powers.

use crate::stats::portable;

/// The colour of a difference: white for 0, blue down to -1, vermilion up to 1; white where there is none.
pub fn signed(share: f64) -> [u8; 3] {
    let end = if share < 0.0 { [0.0, 104.0, 173.0] } else { [201.0, 72.0, 10.0] };
    let share = if share.is_nan() { 0.0 } else { share.abs().min(1.0) };
    end.map(|end| (255.0 + (end - 255.0) * share + 0.5) as u8)
}

/// The powers in grey, frequency 0 in the middle: black for 1/10 and less, white for 1000 and more, on a logarithmic scale.
pub fn spectrum(powers: &[f64], [width, height]: [usize; 2]) -> Vec<u8> {
    let shade = |power: f64| (255.0 * (portable::log10(power.max(0.1)) + 1.0) / 4.0).clamp(0.0, 255.0) as u8;
    let place =
        |row: usize, column: usize| (row + height.div_ceil(2)) % height * width + (column + width.div_ceil(2)) % width;
    let places = (0..height).flat_map(|row| (0..width).map(move |column| place(row, column)));
    places.flat_map(|at| [shade(powers.get(at).copied().unwrap_or(0.0)); 3]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_colours_of_differences() {
        assert_eq!(signed(0.0), [255; 3]);
        assert_eq!((signed(-1.0), signed(5.0)), ([0, 104, 173], [201, 72, 10]));
        assert_eq!(signed(f64::NAN), [255; 3]);
    }

    #[test]
    fn the_frequency_zero_is_in_the_middle() {
        for (width, height) in [(4, 6), (5, 3)] {
            let mut powers = vec![0.0; width * height];
            powers[0] = 1e9;
            let bytes = spectrum(&powers, [width, height]);
            let white = bytes.iter().step_by(3).position(|&shade| shade == 255);
            assert_eq!(white, Some(height / 2 * width + width / 2));
        }
    }
}
