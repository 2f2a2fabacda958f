#include "learning/distributed_evaluator.h"

#include <algorithm>
#include <exception>
#include <numeric>
#include <stdexcept>

#include "common/text.h"

namespace hexapod {
namespace {

std::string nameOf(std::size_t worker) { return "Process " + std::to_string(worker + 1); }

template <typename Value>
std::vector<Value> part(const std::vector<Value>& values, std::size_t begin, std::size_t end) {
  if (values.empty()) return {};
  return {values.begin() + static_cast<std::ptrdiff_t>(begin),
          values.begin() + static_cast<std::ptrdiff_t>(end)};
}

Questions partOf(const Questions& all, std::size_t begin, std::size_t end) {
  return {all.look, part(all.genomes, begin, end), part(all.previous, begin, end)};
}

}  // namespace

DistributedEvaluator::DistributedEvaluator(Evaluator& local, const Introduction& own,
                                           const Workers& workers,
                                           const std::atomic<bool>& cancelled, double patience_s)
    : local_(&local),
      workers_(workers),
      threads_{own.threads},
      cancelled_(&cancelled),
      patience_s_(patience_s) {
  for (std::size_t w = 0; w < workers_.size(); ++w) {
    const auto message = workers_[w]->receive(cancelled, patience_s);
    if (!message && cancelled) throw EvaluationCancelled();
    if (!message) {
      throw std::runtime_error(nameOf(w) + " has not answered for " + numberText(patience_s) +
                               " s: look at its machine, or set worker_patience_s higher.");
    }
    const Introduction introduction = introductionFrom(*message);
    if (!introduction.problem.empty()) {
      throw std::runtime_error(nameOf(w) + ": " + introduction.problem);
    }
    if (introduction.run_id != own.run_id) {
      throw std::runtime_error(nameOf(w) + " was started for the run " + introduction.run_id +
                               ", this one for " + own.run_id +
                               ": give all processes the same options and the same robot files.");
    }
    threads_.push_back(introduction.threads);
  }
}

std::vector<Outcome> DistributedEvaluator::evaluate(const std::vector<Genome>& genomes) {
  return spread({1, genomes, {}});
}

std::vector<Outcome> DistributedEvaluator::lookAgain(int look, const std::vector<Genome>& genomes,
                                                     const std::vector<Outcome>& previous) {
  return spread({look, genomes, previous});
}

std::size_t DistributedEvaluator::endOfPart(std::size_t p, std::size_t batch) const {
  // This process has a thread at least.
  const std::int64_t total =
      std::max<std::int64_t>(1, std::accumulate(threads_.begin(), threads_.end(), std::int64_t{0}));
  const auto until = std::accumulate(
      threads_.begin(), threads_.begin() + static_cast<std::ptrdiff_t>(p) + 1, std::int64_t{0});
  return batch * static_cast<std::size_t>(until) / static_cast<std::size_t>(total);
}

std::vector<Outcome> DistributedEvaluator::spread(const Questions& whole) {
  const std::size_t batch = whole.genomes.size();
  const Questions own = partOf(whole, 0, endOfPart(0, batch));
  std::vector<Questions> parts;
  for (std::size_t w = 0; w < workers_.size(); ++w) {
    parts.push_back(partOf(whole, endOfPart(w, batch), endOfPart(w + 1, batch)));
    if (workers_[w]) workers_[w]->send(toMessage(parts[w]));
  }
  std::vector<Outcome> outcomes;
  std::exception_ptr failure;
  try {
    outcomes = answersOf(*local_, own);
  } catch (...) {
    failure = std::current_exception();
  }
  // Whatever happened here, answers that are under way must not be taken for later ones.
  std::string problems;
  bool cancelled = false;
  for (std::size_t w = 0; w < workers_.size(); ++w) {
    if (!workers_[w]) continue;
    std::optional<Result> result = receiveFrom(w);
    if (!result) result = Result{failure ? std::vector<Outcome>() : answersOf(*local_, parts[w])};
    outcomes.insert(outcomes.end(), result->outcomes.begin(), result->outcomes.end());
    remote_simulations_ += result->simulations;
    cancelled |= result->cancelled;
    if (!result->problem.empty()) problems += nameOf(w) + ": " + result->problem + "\n";
  }
  if (failure) std::rethrow_exception(failure);
  if (cancelled) throw EvaluationCancelled();
  if (!problems.empty()) throw std::runtime_error(problems);
  return outcomes;
}

std::optional<Result> DistributedEvaluator::receiveFrom(std::size_t worker) {
  const auto message = workers_[worker]->receive(*cancelled_, patience_s_);
  if (message) return resultFrom(*message);
  if (*cancelled_) throw EvaluationCancelled();
  workers_[worker] = nullptr;
  threads_[worker + 1] = 0;
  return std::nullopt;
}

void serve(Channel& master, const Introduction& own, Evaluator& evaluator,
           const std::function<std::int64_t()>& simulations) {
  const std::atomic<bool> never{false};
  master.send(toMessage(own));
  while (true) {
    const auto message = master.receive(never, 0.0);
    if (!message || message->empty()) return;
    Result result;
    const std::int64_t before = simulations();
    try {
      result.outcomes = answersOf(evaluator, questionsFrom(*message));
    } catch (const EvaluationCancelled&) {
      result.cancelled = true;
    } catch (const std::exception& error) {
      result.problem = error.what();
    }
    result.simulations = simulations() - before;
    master.send(toMessage(result));
  }
}

}  // namespace hexapod
