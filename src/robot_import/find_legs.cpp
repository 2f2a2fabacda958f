#include "robot_import/find_legs.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "robot/urdf_bodies.h"

namespace hexapod {
namespace {

// What the fast engine simulates, and more than a leg needs for a gait of two signals.
constexpr std::size_t kMostJoints = 4;
// Parts of a body that hang on the base by a hinge, before and behind it.
constexpr std::ptrdiff_t kMostSpines = 2;
constexpr int kMostSpineJoints = 2;  // of one of them; an arm has more before it branches

bool isHinge(const urdf::Joint& joint) {
  return joint.type == urdf::Joint::REVOLUTE || joint.type == urdf::Joint::CONTINUOUS;
}

bool isFree(const urdf::Joint& joint) {
  return joint.type == urdf::Joint::FIXED || joint.type == urdf::Joint::FLOATING ||
         joint.type == urdf::Joint::PLANAR;
}

bool hasBody(const urdf::Link& link) {
  return (link.inertial && link.inertial->mass > 0.0) || !link.collision_array.empty() ||
         !link.visual_array.empty();
}

// A link with two joints above it is where a linkage closes; the parser lets that pass.
void refuseLoops(const urdf::ModelInterface& model, ImportReport& report) {
  std::map<std::string, std::string> joint_above;
  for (const auto& [name, joint] : model.joints_) {
    const auto [above, is_first] = joint_above.emplace(joint->child_link_name, name);
    if (is_first) continue;
    report.problems.add(report.source, {"link", joint->child_link_name},
                        "is below two joints, " + above->second + " and " + name +
                            ": a closed loop, which a tree of links cannot have. Leave out one of "
                            "them; the leg is then simulated without that linkage.");
  }
}

class LegFinder {
 public:
  LegFinder(urdf::ModelInterface& model, ImportReport& report) : model_(model), report_(report) {}

  std::vector<JointChain> find(const urdf::LinkSharedPtr& base) {
    std::vector<Chain> chains;
    addChainsFrom(base, chains);
    std::vector<JointChain> legs = legsAmong(chains);
    complainOfWheels(legs);
    return legs;
  }

 private:
  // A body in parts is taken as one: legs are on all of them.
  void addChainsFrom(const urdf::LinkSharedPtr& body, std::vector<Chain>& chains) {
    const std::vector<urdf::JointSharedPtr> joints = movingBelow(body);
    const auto carrying =
        std::count_if(joints.begin(), joints.end(), [&](const auto& j) { return carriesLegs(j); });
    for (const urdf::JointSharedPtr& first : joints) {
      if (carriesLegs(first) && carrying <= kMostSpines) {
        fix(first, "joins parts of the body");
        addChainsFrom(childOf(first), chains);
        continue;
      }
      const std::size_t hinges = depth(first);
      const JointChain chain = chainFrom(first);
      if (!chain.empty()) chains.push_back({chain, hinges});
    }
  }

  // Whether two chains or more, of two hinges at least, hang on what a joint moves, or on what the
  // next one does.
  bool carriesLegs(const urdf::JointSharedPtr& joint, int joints = kMostSpineJoints) const {
    std::vector<urdf::JointSharedPtr> deep;
    for (const urdf::JointSharedPtr& next : movingBelow(childOf(joint))) {
      if (depth(next) >= 2) deep.push_back(next);
    }
    if (deep.size() >= 2) return true;
    return deep.size() == 1 && joints > 1 && carriesLegs(deep.front(), joints - 1);
  }

  urdf::LinkSharedPtr childOf(const urdf::JointSharedPtr& joint) const {
    urdf::LinkSharedPtr link;
    model_.getLink(joint->child_link_name, link);
    return link;
  }

  // The joints that move something relative to a link or to what is fixed to it.
  std::vector<urdf::JointSharedPtr> movingBelow(const urdf::LinkSharedPtr& link) const {
    std::vector<urdf::JointSharedPtr> joints;
    for (const urdf::JointSharedPtr& joint : link->child_joints) {
      if (joint->type == urdf::Joint::FIXED) {
        for (const auto& below : movingBelow(childOf(joint))) joints.push_back(below);
      } else {
        joints.push_back(joint);
      }
    }
    return joints;
  }

  // Follows the longest way outwards, making fixed what is no hinge and what branches off.
  JointChain chainFrom(const urdf::JointSharedPtr& first) {
    JointChain chain;
    urdf::JointSharedPtr joint = first;
    while (joint) {
      const std::vector<urdf::JointSharedPtr> below = movingBelow(childOf(joint));
      if (isHinge(*joint) && !isWheel(*joint, below, chain) && !joint->mimic &&
          chain.size() < kMostJoints) {
        chain.push_back(joint);
      } else {
        fix(joint, reasonFor(*joint, chain));
      }
      joint = nullptr;
      for (const urdf::JointSharedPtr& candidate : below) {
        if (!joint || depth(candidate) > depth(joint)) joint = candidate;
      }
      for (const urdf::JointSharedPtr& other : below) {
        if (other != joint) fixAllFrom(other, "branches off a leg");
      }
    }
    return chain;
  }

  // The last hinge of a leg that turns without end while those before it have limits.
  static bool isWheel(const urdf::Joint& joint, const std::vector<urdf::JointSharedPtr>& below,
                      const JointChain& chain) {
    return joint.type == urdf::Joint::CONTINUOUS && below.empty() && !chain.empty() &&
           chain.back()->type != urdf::Joint::CONTINUOUS;
  }

  static std::string reasonFor(const urdf::Joint& joint, const JointChain& chain) {
    if (joint.mimic) return "mimics another joint";
    if (!isHinge(joint)) return "is no hinge";
    if (chain.size() >= kMostJoints) return "is beyond the fourth hinge of its leg";
    return "turns without end, like a wheel";
  }

  std::size_t depth(const urdf::JointSharedPtr& joint) const {
    std::size_t deepest = 0;
    for (const auto& below : movingBelow(childOf(joint))) deepest = std::max(deepest, depth(below));
    return deepest + (isHinge(*joint) ? 1 : 0);
  }

  // Makes fixed what is no leg.
  std::vector<JointChain> legsAmong(const std::vector<Chain>& chains) {
    const std::vector<bool> are_legs = tellLegs(chains);
    std::vector<JointChain> legs;
    for (std::size_t i = 0; i < chains.size(); ++i) {
      if (are_legs[i]) {
        legs.push_back(chains[i].joints);
      } else {
        fixAllFrom(chains[i].joints.front(), "is not part of a leg");
      }
    }
    return legs;
  }

  void complainOfWheels(const std::vector<JointChain>& legs) {
    const bool are_wheels =
        !legs.empty() && std::all_of(legs.begin(), legs.end(), [](const JointChain& leg) {
          return leg.size() == 1 && leg.front()->type == urdf::Joint::CONTINUOUS;
        });
    if (!are_wheels) return;
    report_.problems.add(report_.source,
                         "moves on " + std::to_string(legs.size()) +
                             " wheels (joints that turn without end, one after the base each); "
                             "expected legs of hinges with limits.");
  }

  void fixAllFrom(const urdf::JointSharedPtr& joint, const std::string& reason) {
    for (const auto& below : movingBelow(childOf(joint))) fixAllFrom(below, reason);
    fix(joint, reason);
  }

  // Where it is at 0, or at the limit nearest to that.
  void fix(const urdf::JointSharedPtr& joint, const std::string& reason) {
    double at = 0.0;
    if (joint->limits && joint->limits->lower < joint->limits->upper) {
      at = std::clamp(0.0, joint->limits->lower, joint->limits->upper);
    }
    urdf::Pose& pose = joint->parent_to_joint_origin_transform;
    Eigen::Isometry3d parent_from_child = toIsometry(pose);
    const Eigen::Vector3d axis(joint->axis.x, joint->axis.y, joint->axis.z);
    if (at != 0.0 && axis.norm() > 1e-9) {
      if (isHinge(*joint)) parent_from_child.rotate(Eigen::AngleAxisd(at, axis.normalized()));
      if (joint->type == urdf::Joint::PRISMATIC)
        parent_from_child.translate(at * axis.normalized());
      const Eigen::Quaterniond q(parent_from_child.linear());
      const Eigen::Vector3d p = parent_from_child.translation();
      pose.rotation = urdf::Rotation(q.x(), q.y(), q.z(), q.w());
      pose.position = urdf::Vector3(p.x(), p.y(), p.z());
    }
    joint->type = urdf::Joint::FIXED;
    report_.remarks.add("legs", {"joint", joint->name}, reason + ": made fixed.");
  }

  urdf::ModelInterface& model_;
  ImportReport& report_;
};

}  // namespace

urdf::LinkSharedPtr findBaseLink(urdf::ModelInterface& model, ImportReport& report) {
  const std::set<std::string> frames = {"world", "map", "odom", "base_footprint", "footprint"};
  urdf::LinkSharedPtr base;
  model.getLink(model.getRoot()->name, base);
  while (base->child_joints.size() == 1 && !hasBody(*base) && isFree(*base->child_joints[0]) &&
         (base->child_joints[0]->type != urdf::Joint::FIXED || frames.count(base->name) > 0)) {
    report.remarks.add("base", {"link", base->name},
                       "is a frame above the robot (joint " + base->child_joints[0]->name +
                           "): the robot starts below it.");
    base = base->child_links[0];
  }
  return base;
}

std::vector<JointChain> findLegs(urdf::ModelInterface& model, const urdf::LinkSharedPtr& base,
                                 ImportReport& report) {
  refuseLoops(model, report);
  report.problems.throwIfAny();
  std::vector<JointChain> legs = LegFinder(model, report).find(base);
  if (legs.size() == 1 || legs.size() == 2) {
    report.problems.add(report.source, "has " + std::to_string(legs.size()) +
                                           " of the chains of hinges that are legs; expected three "
                                           "or more: gaits without balance need them.");
  }
  if (legs.empty()) {
    report.problems.add(report.source, "has no legs: no chain of hinges starts at its base link " +
                                           base->name +
                                           " (revolute or continuous joints); it has " +
                                           std::to_string(model.joints_.size()) + " joints.");
  }
  return legs;
}

}  // namespace hexapod
