#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "gait/genome.h"
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

/// A part of a batch.
struct Task {
  int look = 1;
  std::vector<Genome> genomes;
  std::vector<Outcome> previous;  ///< per genome; none for the first look
};

/// The answer to a task.
struct Result {
  std::vector<Outcome> outcomes = {};  ///< per genome of the task
  std::int64_t simulations = 0;        ///< behaviours simulated for it
  std::string problem = {};            ///< a sentence when it could not be done, else empty
  bool cancelled = false;              ///< the worker was asked to stop: so is the run
};

/// Neither is ever empty, so an empty message can mean the end.
std::string toMessage(const Introduction& introduction);
std::string toMessage(const Task& task);
std::string toMessage(const Result& result);

/// The ways back. Throw std::runtime_error when the message is cut short, too long or garbled.
Introduction introductionFrom(const std::string& message);
Task taskFrom(const std::string& message);
Result resultFrom(const std::string& message);

}  // namespace hexapod
