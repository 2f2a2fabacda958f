#include "evaluation/cached_evaluator.h"

#include <stdexcept>
#include <string>
#include <utility>

namespace hexapod {

CachedEvaluator::CachedEvaluator(Evaluator& evaluator, std::size_t capacity, GenomeSpace space,
                                 std::vector<Symmetry> symmetries)
    : evaluator_(&evaluator),
      space_(std::move(space)),
      symmetries_(std::move(symmetries)),
      memories_(static_cast<std::size_t>(evaluator.looks()), Memory(capacity)) {}

std::vector<Outcome> CachedEvaluator::evaluate(const std::vector<Genome>& genomes) {
  std::vector<Representative> questions;
  for (const Genome& genome : genomes) questions.push_back(representative(genome));
  std::int64_t passed_on = 0;
  auto outcomes = answer(questions, memories_[0], [&](const std::vector<std::size_t>& open) {
    std::vector<Genome> asked;
    for (const std::size_t i : open) asked.push_back(questions[i].genome);
    passed_on = static_cast<std::int64_t>(asked.size());
    return evaluator_->evaluate(asked);
  });
  counts_.asked += static_cast<std::int64_t>(genomes.size());
  counts_.passed_on += passed_on;
  return outcomes;
}

std::vector<Outcome> CachedEvaluator::lookAgain(int look, const std::vector<Genome>& genomes,
                                                const std::vector<Outcome>& previous) {
  std::vector<Representative> questions;
  for (const Genome& genome : genomes) questions.push_back(representative(genome));
  Memory& memory = memories_.at(static_cast<std::size_t>(look) - 1);
  return answer(questions, memory, [&](const std::vector<std::size_t>& open) {
    std::vector<Genome> asked;
    std::vector<Outcome> known;
    for (const std::size_t i : open) {
      asked.push_back(questions[i].genome);
      known.push_back(questions[i].mapped(previous[i]));
    }
    return evaluator_->lookAgain(look, asked, known);
  });
}

CachedEvaluator::Representative CachedEvaluator::representative(const Genome& genome) const {
  Representative first{space_.canonical(genome), nullptr};
  for (const Symmetry& symmetry : symmetries_) {
    Genome image = symmetry.image(genome);
    if (image < first.genome) first = {std::move(image), &symmetry};
  }
  return first;
}

template <typename Ask>
std::vector<Outcome> CachedEvaluator::answer(const std::vector<Representative>& questions,
                                             Memory& memory, const Ask& ask) {
  std::unordered_map<Genome, Outcome, GenomeHash> answers;
  std::vector<std::size_t> open;
  for (std::size_t i = 0; i < questions.size(); ++i) {
    const auto [answer, is_new] = answers.try_emplace(questions[i].genome);
    if (!is_new) continue;
    if (const Outcome* known = memory.find(questions[i].genome)) {
      answer->second = *known;
    } else {
      open.push_back(i);
    }
  }
  if (!open.empty()) {
    const std::vector<Outcome> outcomes = ask(open);
    if (outcomes.size() != open.size()) {
      throw std::logic_error("The evaluator gave " + std::to_string(outcomes.size()) +
                             " outcomes for " + std::to_string(open.size()) + " genomes.");
    }
    for (std::size_t k = 0; k < open.size(); ++k) {
      answers[questions[open[k]].genome] = outcomes[k];
      memory.add(questions[open[k]].genome, outcomes[k]);
    }
  }
  std::vector<Outcome> result;
  result.reserve(questions.size());
  for (const Representative& question : questions) {
    result.push_back(question.mapped(answers.at(question.genome)));
  }
  return result;
}

const Outcome* CachedEvaluator::Memory::find(const Genome& genome) const {
  const auto found = outcomes_.find(genome);
  return found == outcomes_.end() ? nullptr : &found->second;
}

void CachedEvaluator::Memory::add(const Genome& genome, const Outcome& outcome) {
  if (capacity_ == 0) return;
  if (outcomes_.size() >= capacity_) {
    outcomes_.erase(by_age_.front());
    by_age_.pop_front();
  }
  outcomes_.emplace(genome, outcome);
  by_age_.push_back(genome);
}

}  // namespace hexapod
