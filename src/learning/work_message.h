#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "evolution/evaluator.h"
#include "gait/outcome.h"

namespace hexapod {

/// What processes that learn together tell each other, and how it is put into bytes. Exact; all
/// processes must run on processors with the same byte order.

/// The first message of a worker.
struct Introduction {
  std::string run_id;  ///< of the run it has been started for
  std::int64_t threads = 1;
  std::string problem;  ///< a sentence when it cannot work, else empty
};

/// The answers to a part of the questions.
struct Result {
  std::vector<Outcome> outcomes = {};  ///< per genome asked about
  std::int64_t simulations = 0;        ///< behaviours simulated for it
  std::string problem = {};            ///< a sentence when it could not be done, else empty
  bool cancelled = false;              ///< the worker was asked to stop: so is the run
};

/// Neither is ever empty, so an empty message can mean the end.
std::string toMessage(const Introduction& introduction);
std::string toMessage(const Questions& questions);
std::string toMessage(const Result& result);

/// The ways back. Throw std::runtime_error when the message is cut short, too long or garbled.
Introduction introductionFrom(const std::string& message);
Questions questionsFrom(const std::string& message);
Result resultFrom(const std::string& message);

}  // namespace hexapod
