#include "robot_import/tell_legs.h"

#include <urdf_model/joint.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>

#include "robot_import/name_words.h"

namespace hexapod {
namespace {

const std::vector<std::string> kLegWords = {"leg",   "coxa", "femur", "tibia", "hip",  "thigh",
                                            "calf",  "shin", "shank", "knee",  "foot", "toe",
                                            "ankle", "haa",  "hfe",   "kfe"};
const std::vector<std::string> kOtherWords = {
    "arm",    "manipulator", "gripper", "hand", "finger",   "wrist", "head",   "neck", "tail",
    "camera", "cam",         "lidar",   "mast", "antennae", "laser", "turret", "ptu",  "antenna"};

// From hinge to hinge, as far as the joints' own origins tell.
double lengthOf(const JointChain& chain) {
  double length_m = 0.0;
  for (std::size_t j = 1; j < chain.size(); ++j) {
    const urdf::Vector3& at = chain[j]->parent_to_joint_origin_transform.position;
    length_m += std::sqrt(at.x * at.x + at.y * at.y + at.z * at.z);
  }
  return length_m;
}

std::set<std::string> wordsOfChain(const JointChain& chain) {
  std::set<std::string> words;
  for (const urdf::JointSharedPtr& joint : chain) {
    for (const std::string& name : {joint->name, joint->child_link_name}) {
      const std::set<std::string> more = wordsOf(name);
      words.insert(more.begin(), more.end());
    }
  }
  return words;
}

class LegTeller {
 public:
  explicit LegTeller(const std::vector<Chain>& chains) : chains_(chains) {
    for (const Chain& chain : chains) {
      ++of_hinges_[chain.hinges];
      const std::set<std::string> words = wordsOfChain(chain.joints);
      is_named_leg_.push_back(hasAny(words, kLegWords));
      is_named_other_.push_back(!is_named_leg_.back() && hasAny(words, kOtherWords));
    }
    // The number that most have; single hinges only count where there is nothing longer.
    for (const auto& [hinges, count] : of_hinges_) {
      if (hinges > 1 && (usual_ == 1 || count >= of_hinges_[usual_])) usual_ = hinges;
    }
  }

  bool isLeg(std::size_t i) const {
    const std::size_t hinges = chains_[i].hinges;
    if (hinges == 1 && usual_ > 1) return false;
    const auto others = std::count(is_named_other_.begin(), is_named_other_.end(), true);
    if (is_named_other_[i] && 2 * others < static_cast<std::ptrdiff_t>(chains_.size())) {
      return false;
    }
    const int alike = of_hinges_.at(hinges), usual = of_hinges_.at(usual_);
    if (hinges != usual_ && alike == 1 && usual >= 3) return false;
    if (is_named_leg_[i]) return true;
    if (hinges != usual_ && alike == 2 && usual >= 4) return false;
    return hasTwin(i) || chainsWithTwins() < 3;
  }

 private:
  bool hasTwin(std::size_t i) const {
    const double length_m = lengthOf(chains_[i].joints);
    for (std::size_t j = 0; j < chains_.size(); ++j) {
      if (j == i || chains_[j].hinges != chains_[i].hinges) continue;
      if (std::abs(lengthOf(chains_[j].joints) - length_m) <= 0.1 * length_m) return true;
    }
    return false;
  }

  int chainsWithTwins() const {
    int count = 0;
    for (std::size_t i = 0; i < chains_.size(); ++i) count += hasTwin(i) ? 1 : 0;
    return count;
  }

  const std::vector<Chain>& chains_;
  std::map<std::size_t, int> of_hinges_;
  std::size_t usual_ = 1;
  std::vector<bool> is_named_leg_, is_named_other_;
};

}  // namespace

std::vector<bool> tellLegs(const std::vector<Chain>& chains) {
  const LegTeller teller(chains);
  std::vector<bool> are_legs;
  for (std::size_t i = 0; i < chains.size(); ++i) are_legs.push_back(teller.isLeg(i));
  return are_legs;
}

}  // namespace hexapod
