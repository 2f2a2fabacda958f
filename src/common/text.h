#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace hexapod {

/// Numbers as text, with a decimal point in every locale, and back: nowhere else is this done.

/// For a sentence: so many significant digits, "0.785".
std::string numberText(double number, int digits = 6);

/// For a sentence or a table: so many decimals, "0.50".
std::string fixedText(double number, int decimals);

/// For a file: the shortest text that reads back as the same number.
std::string exactText(double number);

/// Numbers as the functions above and std::to_string() write them; empty when the text is anything
/// else or the number does not fit.
std::optional<double> doubleFromText(const std::string& text);
std::optional<std::int64_t> integerFromText(const std::string& text);
std::optional<std::uint64_t> unsignedFromText(const std::string& text);

/// A row of a Markdown table: "| a | b |" and the end of the line.
std::string tableRow(const std::vector<std::string>& cells);

/// "a, b, c".
std::string listed(const std::vector<std::string>& words);

/// Without the white space around it.
std::string trimmed(const std::string& text);

/// The words of "a, b, c", trimmed; none are empty.
std::vector<std::string> separated(const std::string& text);

/// The words of a text in lines of at most so many characters, but for longer words; one line at
/// least.
std::vector<std::string> inLines(const std::string& text, std::size_t columns);

}  // namespace hexapod
