#pragma once

#include "simulation/reduced/contacts.h"

namespace hexapod::reduced {

/// Symmetric positive definite system of n equations, lower triangle, factored L D L^T in place.
template <typename Real, int n>
struct SymmetricSystem {
  Real a[n][n];        ///< after factor(): L below the diagonal
  Real reciprocal[n];  ///< after factor(): 1 / D

  void factor() {
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < i; ++j) {
        for (int k = 0; k < j; ++k) a[i][j] = a[i][j] - a[i][k] * a[j][k];
      }
      Real pivot = a[i][i];
      for (int j = 0; j < i; ++j) {
        const Real scaled = a[i][j] * reciprocal[j];
        pivot = pivot - a[i][j] * scaled;
        a[i][j] = scaled;
      }
      reciprocal[i] = 1.0 / pivot;
    }
  }

  /// x becomes the solution.
  void solve(Real (&x)[n]) const {
    for (int i = 1; i < n; ++i) {
      for (int j = 0; j < i; ++j) x[i] = x[i] - a[i][j] * x[j];
    }
    for (int i = n - 1; i >= 0; --i) {
      x[i] = x[i] * reciprocal[i];
      for (int j = i + 1; j < n; ++j) x[i] = x[i] - a[j][i] * x[j];
    }
  }
};

/// The six equations of the base (8): angular, then linear.
template <typename Real>
struct BaseSystem : SymmetricSystem<Real, 6> {
  Spatial<Real> right;

  /// Starts with the inertia of the robot and its momentum.
  void reset(const Inertia<Real>& inertia, const Spatial<Real>& momentum) {
    const Sym3<Real>& i = inertia.angular;
    const Real& mass = inertia.mass;
    setAngular({i.xx, i.yy, i.zz, i.xy, i.xz, i.yz});
    auto& a = this->a;
    const Vec3<Real>& h = inertia.moment;
    a[3][0] = Real(), a[3][1] = h.z, a[3][2] = -h.y;
    a[4][0] = -h.z, a[4][1] = Real(), a[4][2] = h.x;
    a[5][0] = h.y, a[5][1] = -h.x, a[5][2] = Real();
    a[3][3] = a[4][4] = a[5][5] = mass;
    a[4][3] = a[5][3] = a[5][4] = Real();
    right = momentum;
  }

  /// Adds springs of the given weights along x, y, z at `arm`, J^T W J, and an impulse there.
  void addPoint(const Vec3<Real>& weight, const Vec3<Real>& arm, const Vec3<Real>& impulse) {
    right = right + Spatial<Real>{cross(arm, impulse), impulse};
    auto& a = this->a;
    const Vec3<Real>&w = weight, &c = arm;
    const Real xz = w.x * c.z, xy = w.x * c.y, yz = w.y * c.z, yx = w.y * c.x;
    const Real zx = w.z * c.x, zy = w.z * c.y;
    a[0][0] = a[0][0] + (yz * c.z + zy * c.y);
    a[1][1] = a[1][1] + (xz * c.z + zx * c.x);
    a[2][2] = a[2][2] + (xy * c.y + yx * c.x);
    a[1][0] = a[1][0] - zx * c.y;
    a[2][0] = a[2][0] - yx * c.z;
    a[2][1] = a[2][1] - xy * c.z;
    a[3][1] = a[3][1] + xz, a[3][2] = a[3][2] - xy;
    a[4][0] = a[4][0] - yz, a[4][2] = a[4][2] + yx;
    a[5][0] = a[5][0] + zy, a[5][1] = a[5][1] - zx;
    a[3][3] = a[3][3] + w.x, a[4][4] = a[4][4] + w.y, a[5][5] = a[5][5] + w.z;
  }

  /// The same along z alone, with the impulse along z.
  void addNormal(const Real& weight, const Vec3<Real>& arm, const Real& impulse) {
    auto& a = this->a;
    const Real zx = weight * arm.x, zy = weight * arm.y;
    a[0][0] = a[0][0] + zy * arm.y;
    a[1][1] = a[1][1] + zx * arm.x;
    a[1][0] = a[1][0] - zx * arm.y;
    a[5][0] = a[5][0] + zy, a[5][1] = a[5][1] - zx;
    a[5][5] = a[5][5] + weight;
    right.angular.x = right.angular.x + arm.y * impulse;
    right.angular.y = right.angular.y - arm.x * impulse;
    right.linear.z = right.linear.z + impulse;
  }

  /// Subtracts factor * column column^T.
  void subtractSquare(const Real& factor, const Spatial<Real>& column) {
    const Real c[6] = {column.angular.x, column.angular.y, column.angular.z,
                       column.linear.x,  column.linear.y,  column.linear.z};
    for (int i = 0; i < 6; ++i) {
      const Real scaled = factor * c[i];
      for (int j = 0; j <= i; ++j) this->a[i][j] = this->a[i][j] - scaled * c[j];
    }
  }

  Spatial<Real> solution() {
    Real x[6] = {right.angular.x, right.angular.y, right.angular.z,
                 right.linear.x,  right.linear.y,  right.linear.z};
    this->factor();
    this->solve(x);
    return {{x[0], x[1], x[2]}, {x[3], x[4], x[5]}};
  }

 private:
  void setAngular(const Sym3<Real>& i) {
    auto& a = this->a;
    a[0][0] = i.xx, a[1][1] = i.yy, a[2][2] = i.zz;
    a[1][0] = i.xy, a[2][0] = i.xz, a[2][1] = i.yz;
  }
};

/// The equations of one leg's hinges that give way, to be eliminated from the base's (8). A hinge
/// that follows its motor has no row; in a lane where only others' hinge s gives way, the row says
/// that its deviation is zero.
template <typename Real, int kSegments>
class LegSystem {
 public:
  /// `gives_way` for each hinge: in which lanes.
  void reset(const LegTerms<Real, kSegments>& leg, const Real (&momentum)[kSegments],
             const Mask<Real> (&gives_way)[kSegments]) {
    for (int s = 0; s < kSegments; ++s) {
      gives_way_[s] = gives_way[s];
      used_[s] = any<Real>(gives_way[s]);
      for (int t = 0; t <= s; ++t) a_[s][t] = leg.inertia[s][t];
      coupling_[s] = leg.coupling[s];
      right_[s] = momentum[s];
    }
  }

  /// Springs at a contact point, and the impulse they bring on the right-hand side.
  void addPoint(const Vec3<Real>& weight, const Vec3<Real>& arm,
                const Vec3<Real> (&lever)[kSegments], const Vec3<Real>& impulse) {
    for (int s = 0; s < kSegments; ++s) {
      if (!used_[s]) continue;
      const Vec3<Real> pull{weight.x * lever[s].x, weight.y * lever[s].y, weight.z * lever[s].z};
      for (int t = 0; t <= s; ++t) a_[s][t] = a_[s][t] + dot(pull, lever[t]);
      coupling_[s] = coupling_[s] + Spatial<Real>{cross(arm, pull), pull};
      right_[s] = right_[s] + dot(lever[s], impulse);
    }
  }

  /// Drives each hinge with its motor's bound and takes the leg out of the base's equations.
  void eliminate(const Real (&impulse)[kSegments], BaseSystem<Real>& base) {
    for (int s = 0; s < kSegments; ++s) {
      if (!used_[s]) continue;
      maskRow(s, impulse[s]);
      Real pivot = a_[s][s];
      for (int t = 0; t < s; ++t) {
        if (!used_[t]) continue;
        for (int k = 0; k < t; ++k) {
          if (used_[k]) a_[s][t] = a_[s][t] - a_[s][k] * a_[t][k];
        }
      }
      for (int t = 0; t < s; ++t) {
        if (!used_[t]) continue;
        const Real scaled = a_[s][t] * reciprocal_[t];
        pivot = pivot - a_[s][t] * scaled;
        a_[s][t] = scaled;
        coupling_[s] = coupling_[s] - scaled * coupling_[t];
        right_[s] = right_[s] - scaled * right_[t];
      }
      reciprocal_[s] = 1.0 / pivot;
      base.subtractSquare(reciprocal_[s], coupling_[s]);
      base.right = base.right - Real(reciprocal_[s] * right_[s]) * coupling_[s];
    }
  }

  /// Deviations of the joint velocities from the motors' for a known motion of the base.
  void deviations(const Spatial<Real>& motion, Real (&deviation)[kSegments]) const {
    for (int s = kSegments - 1; s >= 0; --s) {
      deviation[s] = Real();
      if (!used_[s]) continue;
      deviation[s] = (right_[s] - dot(coupling_[s], motion)) * reciprocal_[s];
      for (int t = s + 1; t < kSegments; ++t) {
        if (used_[t]) deviation[s] = deviation[s] - a_[t][s] * deviation[t];
      }
    }
  }

 private:
  void maskRow(int s, const Real& impulse) {
    const Mask<Real>& mask = gives_way_[s];
    for (int t = 0; t < s; ++t) {
      a_[s][t] = select<Real>(mask & gives_way_[t], a_[s][t], Real());
    }
    a_[s][s] = select<Real>(mask, a_[s][s], splat<Real>(1.0));
    for (Vec3<Real>* part : {&coupling_[s].angular, &coupling_[s].linear}) {
      *part = {select<Real>(mask, part->x, Real()), select<Real>(mask, part->y, Real()),
               select<Real>(mask, part->z, Real())};
    }
    right_[s] = select<Real>(mask, right_[s] + impulse, Real());
  }

  Mask<Real> gives_way_[kSegments];
  bool used_[kSegments];          // in any lane
  Real a_[kSegments][kSegments];  // lower triangle, L D L^T in place
  Real reciprocal_[kSegments];    // 1 / D
  Spatial<Real> coupling_[kSegments];
  Real right_[kSegments];
};

}  // namespace hexapod::reduced
