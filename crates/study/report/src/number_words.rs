//! Small numbers as they are written out.

/// `three` of 3; numbers of 13 and more, 0 and 1 in digits.
pub(crate) fn number_word(number: usize) -> String {
    const WORDS: [&str; 11] =
        ["two", "three", "four", "five", "six", "seven", "eight", "nine", "ten", "eleven", "twelve"];
    let word = number.checked_sub(2).and_then(|at| WORDS.get(at));
    word.map_or_else(|| number.to_string(), |word| (*word).to_owned())
}
