#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "planning/planner_options.h"
#include "repertoire/repertoire.h"
#include "self_model/body_belief.h"
#include "self_model/imagination.h"

namespace hexapod {

/// What the entries of a repertoire cost as the first behaviour of a robot of which nothing was
/// measured yet, by index, in behaviours: the more, the more legs there are with which, limp, it
/// fails. So the careful one of chains of the same length is walked, and another behaviour is worth
/// it where all of those fail with two legs or more.
///
/// Every entry that is planned with is played in each of those bodies, from its stand: some seconds
/// on one core for a thousand. Null when `stop` was true meanwhile.
std::shared_ptr<const std::vector<double>> cautionOf(const Imagination& imagination,
                                                     const BodyBelief& belief,
                                                     const Repertoire& repertoire,
                                                     const PlannerOptions& planner,
                                                     const std::function<bool()>& stop);

}  // namespace hexapod
