#include "learning/work_message.h"

#include <cstring>
#include <stdexcept>
#include <type_traits>

namespace hexapod {
namespace {

class Writer {
 public:
  template <typename Number>
  void number(Number value) {
    static_assert(std::is_arithmetic_v<Number>, "only numbers have bytes that mean something");
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof(value));
  }
  void count(std::size_t value) { number(static_cast<std::uint64_t>(value)); }
  void text(const std::string& value) {
    count(value.size());
    bytes_ += value;
  }
  void outcomes(const std::vector<Outcome>& values) {
    count(values.size());
    for (const Outcome& outcome : values) {
      number(static_cast<std::int32_t>(outcome.verdict));
      for (const double value :
           {outcome.end_pose.x_m, outcome.end_pose.y_m, outcome.end_pose.yaw_rad, outcome.cost}) {
        number(value);
      }
    }
  }
  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

class Reader {
 public:
  explicit Reader(const std::string& bytes) : bytes_(bytes) {}

  template <typename Number>
  Number number() {
    Number value{};
    require(sizeof(value));
    std::memcpy(&value, bytes_.data() + position_, sizeof(value));
    position_ += sizeof(value);
    return value;
  }
  /// Of things that take a byte each at least.
  std::size_t count() {
    const auto value = number<std::uint64_t>();
    require(value);
    return static_cast<std::size_t>(value);
  }
  std::string text() {
    const std::size_t size = count();
    position_ += size;
    return bytes_.substr(position_ - size, size);
  }
  std::vector<Outcome> outcomes() {
    std::vector<Outcome> values(count());
    for (Outcome& outcome : values) {
      outcome.verdict = verdict();
      outcome.end_pose.x_m = number<double>();
      outcome.end_pose.y_m = number<double>();
      outcome.end_pose.yaw_rad = number<double>();
      outcome.cost = number<double>();
    }
    return values;
  }
  Verdict verdict() {
    const auto found = static_cast<Verdict>(number<std::int32_t>());
    for (const Verdict known :
         {Verdict::kWalked, Verdict::kFell, Verdict::kSelfCollided, Verdict::kDiverged}) {
      if (found == known) return found;
    }
    fail();
  }
  void requireEnd() const {
    if (position_ != bytes_.size()) fail();
  }

 private:
  [[noreturn]] static void fail() {
    throw std::runtime_error(
        "A message between the processes of a run cannot be understood: do they all run the same "
        "program, on processors of the same kind?");
  }
  void require(std::uint64_t size) const {
    if (size > bytes_.size() - position_) fail();
  }

  const std::string& bytes_;
  std::size_t position_ = 0;
};

}  // namespace

std::string toMessage(const Introduction& introduction) {
  Writer writer;
  writer.text(introduction.run_id);
  writer.number(introduction.threads);
  writer.text(introduction.problem);
  return writer.bytes();
}

std::string toMessage(const Questions& questions) {
  Writer writer;
  writer.number(static_cast<std::int32_t>(questions.look));
  writer.count(questions.genomes.size());
  for (const Genome& genome : questions.genomes) writer.text({genome.begin(), genome.end()});
  writer.outcomes(questions.previous);
  return writer.bytes();
}

std::string toMessage(const Result& result) {
  Writer writer;
  writer.outcomes(result.outcomes);
  writer.number(result.simulations);
  writer.text(result.problem);
  writer.number(static_cast<std::int32_t>(result.cancelled));
  return writer.bytes();
}

Introduction introductionFrom(const std::string& message) {
  Reader reader(message);
  Introduction introduction;
  introduction.run_id = reader.text();
  introduction.threads = reader.number<std::int64_t>();
  introduction.problem = reader.text();
  reader.requireEnd();
  return introduction;
}

Questions questionsFrom(const std::string& message) {
  Reader reader(message);
  Questions questions;
  questions.look = reader.number<std::int32_t>();
  questions.genomes.resize(reader.count());
  for (Genome& genome : questions.genomes) {
    const std::string levels = reader.text();
    genome.assign(levels.begin(), levels.end());
  }
  questions.previous = reader.outcomes();
  reader.requireEnd();
  return questions;
}

Result resultFrom(const std::string& message) {
  Reader reader(message);
  Result result;
  result.outcomes = reader.outcomes();
  result.simulations = reader.number<std::int64_t>();
  result.problem = reader.text();
  result.cancelled = reader.number<std::int32_t>() != 0;
  reader.requireEnd();
  return result;
}

}  // namespace hexapod
