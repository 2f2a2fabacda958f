#include "calibration/choose_behaviors.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>

#include "calibration/trial_chain.h"
#include "self_model/evidence.h"

namespace hexapod {
namespace {

/// An entry that walks in all bodies.
struct Candidate {
  std::size_t entry = 0;
  Pose2 end;               // in the nominal body
  BodyMatrix information;  // about the parameters, in units of what is possible
};

std::vector<Outcome> outcomesIn(const Imagination& imagination, const std::vector<Genome>& genomes,
                                const Physics& body) {
  const std::optional<WorldState> stand = imagination.stands({body}).front();
  if (!stand) return std::vector<Outcome>(genomes.size());
  return imagination.playAll(genomes, {body, &*stand});
}

std::vector<Candidate> candidatesOf(const Imagination& imagination, const Physics& nominal,
                                    const std::vector<Entry>& entries,
                                    const Eigen::Vector3d& noise) {
  std::vector<Genome> genomes;
  for (const Entry& entry : entries) genomes.push_back(entry.genome);
  const std::vector<Outcome> middle = outcomesIn(imagination, genomes, nominal);
  std::vector<std::vector<Outcome>> sides;
  for (int j = 0; j < kBodyParameters; ++j) {
    for (const double side : {1.0, -1.0}) {
      BodyVector body = BodyVector::Zero();
      body[j] = side * possibleDeviations()[j];
      sides.push_back(outcomesIn(imagination, genomes, physicsOf(nominal, nominal.legs, body)));
    }
  }
  std::vector<Candidate> candidates;
  for (std::size_t i = 0; i < genomes.size(); ++i) {
    const auto walks = [&](const std::vector<Outcome>& outcomes) { return outcomes[i].walked(); };
    if (!walks(middle) || !std::all_of(sides.begin(), sides.end(), walks)) continue;
    Eigen::Matrix<double, 3, kBodyParameters> change;
    for (int j = 0; j < kBodyParameters; ++j) {
      const std::size_t side = 2 * static_cast<std::size_t>(j);
      change.col(j) =
          0.5 *
          difference(sides[side][i].end_pose, sides[side + 1][i].end_pose).cwiseQuotient(noise);
    }
    candidates.push_back({i, middle[i].end_pose, change.transpose() * change});
  }
  return candidates;
}

std::vector<Candidate> mostTelling(std::vector<Candidate> candidates, std::size_t count) {
  BodyMatrix known = BodyMatrix::Identity();
  std::vector<Candidate> chosen;
  while (chosen.size() < count) {
    const auto tells_less = [&](const Candidate& a, const Candidate& b) {
      return (known + a.information).determinant() < (known + b.information).determinant();
    };
    const auto best = std::max_element(candidates.begin(), candidates.end(), tells_less);
    known += best->information;
    chosen.push_back(*best);
    candidates.erase(best);
  }
  return chosen;
}

}  // namespace

std::vector<std::size_t> chooseBehaviors(const Imagination& imagination, const Physics& nominal,
                                         const std::vector<Entry>& entries, std::size_t count,
                                         double noise_m, double noise_rad) {
  std::vector<Candidate> candidates =
      candidatesOf(imagination, nominal, entries, Eigen::Vector3d(noise_m, noise_m, noise_rad));
  if (candidates.size() < count) {
    throw std::invalid_argument(
        "Only " + std::to_string(candidates.size()) + " of " + std::to_string(entries.size()) +
        " entries walk in all bodies thought of, and " + std::to_string(count) +
        " behaviours are to be played; learn a larger repertoire, or play fewer.");
  }
  std::vector<Candidate> left = mostTelling(std::move(candidates), count);
  std::vector<std::size_t> order;
  Pose2 pose;
  while (!left.empty()) {
    const auto next =
        std::min_element(left.begin(), left.end(), [&](const Candidate& a, const Candidate& b) {
          return distance(pose * a.end, Pose2()) < distance(pose * b.end, Pose2());
        });
    pose = pose * next->end;
    order.push_back(next->entry);
    left.erase(next);
  }
  return order;
}

}  // namespace hexapod
