#pragma once

#include "simulation/reduced/system.h"

namespace hexapod::reduced {

/// Rows of motors and stops: which are at a bound, and what follows (8).
template <typename Real, int kSegments>
struct LegRows {
  Mask<Real> at_low[kSegments], at_high[kSegments];
  Real momentum[kSegments];   ///< r less what the wanted velocities take
  Real deviation[kSegments];  ///< y: joint velocity less the wanted one [rad/s]
  bool gives_way;             ///< some row is at a bound, in some lane
};

/// The velocity-level LCP that ODE's dWorldStep solves, in reduced coordinates (8).
///
/// First with motors and normals only; the normal impulses found bound the friction rows; then with
/// all rows. Each time an active set is guessed, the linear system it leaves is solved, rows that
/// break their bounds or pull the wrong way change sets, all at once or, after kBlockRounds rounds,
/// only the first one (which must end, the matrix being positive definite). The solution is unique
/// and computed from the last active set alone, so the way to it leaves no trace.
template <typename Real, int kSegments>
class Solver {
 public:
  static constexpr int kBlockRounds = 8;

  using Tree = TreeTerms<Real, kSegments>;
  using Contacts = FloorContacts<Real, kSegments>;
  using Contact = FloorContact<Real, kSegments>;

  /// Solves the step whose terms are in `tree`; `contacts` are its workspace and hold its sets.
  void solve(const ReducedModel& model, const Conditions<Real>& conditions, const Tree& tree,
             Contacts& contacts) {
    model_ = &model;
    conditions_ = &conditions;
    tree_ = &tree;
    contacts_ = &contacts;
    start();
    solveRows(false);
    boundFriction();
    solveRows(true);
  }

  /// Of the solution: velocity of the base, and of a joint less the one its row asks for [rad/s].
  const Spatial<Real>& baseMotion() const { return motion_; }
  const Real& deviation(int leg, int s) const { return rows_[leg].deviation[s]; }

  /// Robots for which no set was found that keeps all bounds: the solution is not one.
  const Mask<Real>& gaveUp() const { return gave_up_; }

 private:
  // All motors follow, all contacts bear.
  void start() {
    gave_up_ = noLanes<Real>();
    free_momentum_ = tree_->momentum;
    for (int i = 0; i < model_->legs; ++i) {
      const LegTerms<Real, kSegments>& leg = tree_->leg[i];
      LegRows<Real, kSegments>& rows = rows_[i];
      for (int s = 0; s < kSegments; ++s) {
        rows.at_low[s] = rows.at_high[s] = noLanes<Real>();
        rows.deviation[s] = Real();
        rows.momentum[s] = leg.momentum[s];
        for (int t = 0; t < kSegments; ++t) {
          const Real& inertia = s >= t ? leg.inertia[s][t] : leg.inertia[t][s];
          rows.momentum[s] = rows.momentum[s] - inertia * leg.velocity[t];
        }
        free_momentum_ = free_momentum_ - leg.velocity[s] * leg.coupling[s];
      }
      rows.gives_way = false;
    }
    for (int i = 0; i < contacts_->count; ++i) {
      Contact& contact = contacts_->contact[i];
      contact.free_z = contact.touching;
      contact.free_x = contact.free_y = noLanes<Real>();
    }
  }

  void solveRows(bool friction) {
    for (int round = 0; round < model_->most_solver_rounds; ++round) {
      solveSets(friction);
      changed_ = noLanes<Real>();
      one_by_one_ = round >= kBlockRounds;
      checkContacts(friction);
      for (int leg = 0; leg < model_->legs; ++leg) checkHinges(leg);
      if (!any<Real>(changed_)) return;
    }
    gave_up_ = gave_up_ | changed_;
  }

  // ODE bounds each tangent by mu times the normal force without friction.
  void boundFriction() {
    for (int i = 0; i < contacts_->count; ++i) {
      Contact& contact = contacts_->contact[i];
      const Real velocity = velocityAt(motion_, contact.arm).z + deviatingVelocity(contact).z;
      const Real normal = conditions_->normal_weight * (contact.wanted.z - velocity);
      contact.friction_bound = select<Real>(contact.free_z, conditions_->friction * normal, Real());
      contact.free_x = contact.free_y = contact.touching & (contact.friction_bound > 0.0);
    }
  }

  // Base motion and deviations that the present sets give.
  void solveSets(bool friction) {
    base_.reset(tree_->inertia, free_momentum_);
    resetLegs();
    for (int i = 0; i < contacts_->count; ++i) fillContact(contacts_->contact[i], friction);
    eliminateLegs();
    motion_ = base_.solution();
    for (int i = 0; i < model_->legs; ++i) {
      if (rows_[i].gives_way) legs_[i].deviations(motion_, rows_[i].deviation);
    }
  }

  void resetLegs() {
    for (int i = 0; i < model_->legs; ++i) {
      const LegRows<Real, kSegments>& rows = rows_[i];
      if (!rows.gives_way) continue;
      Mask<Real> gives_way[kSegments];
      for (int s = 0; s < kSegments; ++s) gives_way[s] = rows.at_low[s] | rows.at_high[s];
      legs_[i].reset(tree_->leg[i], rows.momentum, gives_way);
    }
  }

  void fillContact(const Contact& contact, bool friction) {
    const Real zero = Real();
    const auto weight = [&](const Mask<Real>& free, const Real& of_row) {
      return select<Real>(free, of_row, zero);
    };
    Vec3<Real> weights{zero, zero, weight(contact.free_z, conditions_->normal_weight)};
    Vec3<Real> impulse{zero, zero, weights.z * contact.wanted.z};
    if (friction) {
      weights.x = weight(contact.free_x, conditions_->friction_weight);
      weights.y = weight(contact.free_y, conditions_->friction_weight);
      impulse.x = weights.x * contact.wanted.x + contact.impulse.x;
      impulse.y = weights.y * contact.wanted.y + contact.impulse.y;
      base_.addPoint(weights, contact.arm, impulse);
    } else {
      base_.addNormal(weights.z, contact.arm, impulse.z);
    }
    if (contact.leg < 0 || !rows_[contact.leg].gives_way) return;
    legs_[contact.leg].addPoint(weights, contact.arm, contact.lever, impulse);
  }

  void eliminateLegs() {
    for (int i = 0; i < model_->legs; ++i) {
      const LegRows<Real, kSegments>& rows = rows_[i];
      const LegTerms<Real, kSegments>& leg = tree_->leg[i];
      if (!rows.gives_way) continue;
      Real impulse[kSegments];
      for (int s = 0; s < kSegments; ++s) {
        impulse[s] = select<Real>(rows.at_low[s], leg.low[s], leg.high[s]);
      }
      legs_[i].eliminate(impulse, base_);
    }
  }

  Vec3<Real> deviatingVelocity(const Contact& contact) const {
    Vec3<Real> velocity = zeroVec3<Real>();
    if (contact.leg < 0 || !rows_[contact.leg].gives_way) return velocity;
    for (int s = 0; s <= contact.segment; ++s) {
      velocity = velocity + rows_[contact.leg].deviation[s] * contact.lever[s];
    }
    return velocity;
  }

  // Lanes in which a row may change sets now.
  Mask<Real> admit(const Mask<Real>& change) {
    const Mask<Real> admitted = one_by_one_ ? Mask<Real>(change & notMask<Real>(changed_)) : change;
    changed_ = changed_ | change;
    return admitted;
  }

  void checkFriction(const Real& impulse, const Real& bound, Real& at_bound, Mask<Real>& free,
                     const Mask<Real>& touching) {
    const Mask<Real> slides = touching & (bound > 0.0);
    const Mask<Real> above = impulse > bound, below = impulse < -bound;
    const Mask<Real> leaves = free & (above | below);
    const Mask<Real> held = ((at_bound > 0.0) & notMask<Real>(impulse < bound)) |
                            ((at_bound < 0.0) & notMask<Real>(impulse > -bound));
    const Mask<Real> returns = slides & notMask<Real>(free) & notMask<Real>(held);
    const Mask<Real> change = admit(leaves | returns);
    const Real limit = select<Real>(free, select<Real>(above, bound, -bound), Real());
    free = free ^ change;
    at_bound = select<Real>(change, limit, at_bound);
  }

  // Also sums up what the contacts do to the hinges, with the sets the solution was made for.
  void checkContacts(bool friction) {
    for (auto& leg : load_) {
      for (Real& load : leg) load = Real();
    }
    for (int i = 0; i < contacts_->count; ++i) {
      Contact& contact = contacts_->contact[i];
      const Vec3<Real> lacking =
          contact.wanted - velocityAt(motion_, contact.arm) - deviatingVelocity(contact);
      const Vec3<Real> trial{conditions_->friction_weight * lacking.x,
                             conditions_->friction_weight * lacking.y,
                             conditions_->normal_weight * lacking.z};
      const Vec3<Real> impulse{select<Real>(contact.free_x, trial.x, contact.impulse.x),
                               select<Real>(contact.free_y, trial.y, contact.impulse.y),
                               select<Real>(contact.free_z, trial.z, Real())};
      for (int s = 0; s <= contact.segment && contact.leg >= 0; ++s) {
        load_[contact.leg][s] = load_[contact.leg][s] + dot(contact.lever[s], impulse);
      }
      const Mask<Real> bears = contact.touching & (trial.z > 0.0);
      contact.free_z = contact.free_z ^ admit(contact.free_z ^ bears);
      if (!friction) continue;
      checkFriction(trial.x, contact.friction_bound, contact.impulse.x, contact.free_x,
                    contact.touching);
      checkFriction(trial.y, contact.friction_bound, contact.impulse.y, contact.free_y,
                    contact.touching);
    }
  }

  void checkHinges(int index) {
    const LegTerms<Real, kSegments>& leg = tree_->leg[index];
    LegRows<Real, kSegments>& rows = rows_[index];
    Mask<Real> gives_way = noLanes<Real>();
    for (int s = 0; s < kSegments; ++s) {
      Real impulse = dot(leg.coupling[s], motion_) - rows.momentum[s] - load_[index][s];
      for (int t = 0; rows.gives_way && t < kSegments; ++t) {
        impulse = impulse + (s >= t ? leg.inertia[s][t] : leg.inertia[t][s]) * rows.deviation[t];
      }
      const Real& deviation = rows.deviation[s];
      const Mask<Real> follows = notMask<Real>(rows.at_low[s] | rows.at_high[s]);
      const Mask<Real> too_low = follows & (impulse < leg.low[s]);
      const Mask<Real> too_high = follows & (impulse > leg.high[s]);
      const Mask<Real> back =
          (rows.at_high[s] & (deviation > 0.0)) | (rows.at_low[s] & (deviation < 0.0));
      const Mask<Real> change = admit(too_low | too_high | back);
      rows.at_low[s] = (rows.at_low[s] | (change & too_low)) & notMask<Real>(change & back);
      rows.at_high[s] = (rows.at_high[s] | (change & too_high)) & notMask<Real>(change & back);
      gives_way = gives_way | rows.at_low[s] | rows.at_high[s];
    }
    const bool gave_way = rows.gives_way;
    rows.gives_way = any<Real>(gives_way);
    if (gave_way && !rows.gives_way) {
      for (Real& deviation : rows.deviation) deviation = Real();
    }
  }

  const ReducedModel* model_;
  const Conditions<Real>* conditions_;
  const Tree* tree_;
  Contacts* contacts_;
  LegRows<Real, kSegments> rows_[kMaxLegs];
  LegSystem<Real, kSegments> legs_[kMaxLegs];
  Real load_[kMaxLegs][kSegments];  // of contacts on hinges [N m s]
  BaseSystem<Real> base_;
  Spatial<Real> free_momentum_;  // of the base, less what the wanted velocities take
  Spatial<Real> motion_;
  bool one_by_one_;
  Mask<Real> changed_;
  Mask<Real> gave_up_;
};

}  // namespace hexapod::reduced
