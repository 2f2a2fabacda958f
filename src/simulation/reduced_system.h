#pragma once

#include "simulation/reduced_contacts.h"

namespace hexapod_repertoire::reduced {

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
    const Real mass = splat<Real>(inertia.mass);
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

  /// Adds springs of the given weights along x, y, z at `arm`: J^T W J.
  void addPoint(const Vec3<Real>& weight, const Vec3<Real>& arm) {
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

/// The equations of one leg's hinges whose motors give way, to be eliminated from the base's (8).
/// A hinge that follows its motor has the row "deviation = 0" instead.
template <typename Real, int kSegments>
struct LegSystem : SymmetricSystem<Real, kSegments> {
  Spatial<Real> coupling[kSegments];
  Real right[kSegments];

  void reset(const LegTerms<Real, kSegments>& leg, const Real (&momentum)[kSegments]) {
    for (int s = 0; s < kSegments; ++s) {
      for (int t = 0; t <= s; ++t) this->a[s][t] = leg.inertia[s][t];
      coupling[s] = leg.coupling[s];
      right[s] = momentum[s];
    }
  }

  /// Springs at a contact point, and the impulse they bring on the right-hand side.
  void addPoint(const Vec3<Real>& weight, const Vec3<Real>& arm,
                const Vec3<Real> (&lever)[kSegments], const Vec3<Real>& impulse) {
    for (int s = 0; s < kSegments; ++s) {
      const Vec3<Real> pull{weight.x * lever[s].x, weight.y * lever[s].y, weight.z * lever[s].z};
      for (int t = 0; t <= s; ++t) this->a[s][t] = this->a[s][t] + dot(pull, lever[t]);
      coupling[s] = coupling[s] + Spatial<Real>{cross(arm, pull), pull};
      right[s] = right[s] + dot(lever[s], impulse);
    }
  }

  /// Keeps only the hinges that give way, each driven by its motor's bound.
  void keep(const Mask<Real> (&gives_way)[kSegments], const Real (&impulse)[kSegments]) {
    const Real zero = Real(), one = splat<Real>(1.0);
    for (int s = 0; s < kSegments; ++s) {
      for (int t = 0; t < s; ++t) {
        this->a[s][t] = select<Real>(gives_way[s] & gives_way[t], this->a[s][t], zero);
      }
      this->a[s][s] = select<Real>(gives_way[s], this->a[s][s], one);
      keepOnly(gives_way[s], coupling[s].angular);
      keepOnly(gives_way[s], coupling[s].linear);
      right[s] = select<Real>(gives_way[s], right[s] + impulse[s], zero);
    }
  }

  /// Factors, and takes the leg out of the base's equations.
  void eliminate(BaseSystem<Real>& base) {
    this->factor();
    for (int s = 0; s < kSegments; ++s) {
      for (int t = 0; t < s; ++t) {
        coupling[s] = coupling[s] - this->a[s][t] * coupling[t];
        right[s] = right[s] - this->a[s][t] * right[t];
      }
      base.subtractSquare(this->reciprocal[s], coupling[s]);
      base.right = base.right - Real(this->reciprocal[s] * right[s]) * coupling[s];
    }
  }

  /// Deviations of the joint velocities from the motors' for a known motion of the base.
  void deviations(const Spatial<Real>& motion, Real (&deviation)[kSegments]) const {
    for (int s = kSegments - 1; s >= 0; --s) {
      deviation[s] = (right[s] - dot(coupling[s], motion)) * this->reciprocal[s];
      for (int t = s + 1; t < kSegments; ++t) {
        deviation[s] = deviation[s] - this->a[t][s] * deviation[t];
      }
    }
  }

 private:
  static void keepOnly(const Mask<Real>& mask, Vec3<Real>& v) {
    v = {select<Real>(mask, v.x, Real()), select<Real>(mask, v.y, Real()),
         select<Real>(mask, v.z, Real())};
  }
};

}  // namespace hexapod_repertoire::reduced
