#pragma once

#include <memory>
#include <string>

#include "learning/distributed_evaluator.h"

namespace hexapod {

/// The processes that were started together to learn one repertoire. Process 0 learns, the others
/// work for it. Without MPI, or without mpirun, there is only process 0.
///
/// One per process, used by one thread. Gone in order it waits for the others; gone by an exception
/// as well.
class Ranks {
 public:
  virtual ~Ranks() = default;

  virtual int rank() const = 0;
  virtual int count() const = 0;

  /// Cores of this machine for each of the processes on it, 1 or more.
  virtual int coresPerProcess() const = 0;

  /// Process 0: the lines to the others. Elsewhere none.
  virtual DistributedEvaluator::Workers workers() const = 0;

  /// Elsewhere: the line to process 0.
  virtual std::shared_ptr<Channel> master() const = 0;

  /// A sentence about processes that did not answer any more, or empty.
  virtual std::string loss() const = 0;

  /// Ends all processes at once with this exit code.
  [[noreturn]] virtual void abort(int exit_code) = 0;
};

/// To be called at the start of main().
std::unique_ptr<Ranks> joinRanks(int& argc, char**& argv);

}  // namespace hexapod
