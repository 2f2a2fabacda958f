#pragma once

#include <locale>
#include <string>

namespace hexapod {

/// Makes the decimal point a comma and groups thousands, as many countries do, for its lifetime.
class CommaLocale {
 public:
  CommaLocale() : previous_(std::locale::global({std::locale::classic(), new Comma})) {}
  ~CommaLocale() { std::locale::global(previous_); }
  CommaLocale(const CommaLocale&) = delete;
  CommaLocale& operator=(const CommaLocale&) = delete;

 private:
  struct Comma : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
  };
  std::locale previous_;
};

}  // namespace hexapod
