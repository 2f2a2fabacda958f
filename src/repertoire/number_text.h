#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace hexapod {

/// A number as text with a decimal point in every locale; reading it back gives the same number.
std::string toText(double number);

/// Numbers as toText() and std::to_string() write them; empty when the text is anything else or the
/// number does not fit.
std::optional<double> doubleFromText(const std::string& text);
std::optional<std::int64_t> integerFromText(const std::string& text);
std::optional<std::uint64_t> unsignedFromText(const std::string& text);

}  // namespace hexapod
