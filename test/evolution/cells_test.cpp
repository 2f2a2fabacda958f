#include "evolution/cells.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>
#include <stdexcept>

namespace hexapod {
namespace {

TEST(GridCells, AreSquaresAroundTheOrigin) {
  const Cells cells = gridCells(0.1);
  EXPECT_EQ(cells({0.049, -0.049, 1.0}), (Cell{0, 0}));
  EXPECT_EQ(cells({0.051, -0.151, 0.0}), (Cell{1, -2}));
}

TEST(GridCells, CutATurnIntoEqualPartsWhereHeadingsCount) {
  const Cells cells = gridCells(0.1, {0.2});  // 2 pi 0.2 m / 0.1 m: 13 parts of 27.7 degrees
  EXPECT_EQ(cells({0.051, 0.0, 0.2}), (Cell{1, 0, 0}));
  EXPECT_EQ(cells({0.0, 0.0, 0.3}), (Cell{0, 0, 1}));
  EXPECT_EQ(cells({0.0, 0.0, -0.3}), (Cell{0, 0, 12}));
  std::set<Cell> all;
  for (double yaw_rad = -3.14; yaw_rad < 3.14; yaw_rad += 0.01)
    all.insert(cells({0.0, 0.0, yaw_rad}));
  EXPECT_EQ(all.size(), 13u);
  EXPECT_EQ(gridCells(10.0, {0.2})({0.0, 0.0, -3.0}), (Cell{0, 0, 0}));
}

/// How many points of a fine grid in the disk of radius_m belong to each cell.
std::map<Cell, int> sharesOf(const Cells& cells, double radius_m) {
  std::map<Cell, int> shares;
  for (double x = -1.0; x <= 1.0; x += 0.01) {
    for (double y = -1.0; y <= 1.0; y += 0.01) {
      if (std::hypot(x, y) <= 1.0) ++shares[cells({radius_m * x, radius_m * y, 0.0})];
    }
  }
  return shares;
}

// 31,400 points in 100 cells.
TEST(VoronoiCells, AllHaveTheirShareOfTheDisk) {
  const std::map<Cell, int> shares = sharesOf(voronoiCells(100, 0.5), 0.5);
  EXPECT_EQ(shares.size(), 100u);
  for (const auto& [cell, points] : shares) {
    EXPECT_GT(points, 314 / 3) << cell[0];
    EXPECT_LT(points, 314 * 3) << cell[0];
  }
}

TEST(VoronoiCells, AreTheSameForAllSizesOfRobots) {
  const Cells once = voronoiCells(20, 0.5), larger = voronoiCells(20, 2.0);
  EXPECT_EQ(once({0.1, 0.2, 0.0}), larger({0.4, 0.8, 0.0}));
  EXPECT_EQ(once({50.0, 0.0, 0.0}), once({0.5, 0.0, 0.0}));  // beyond the disk: the rim's
  EXPECT_EQ(sharesOf(voronoiCells(1, 0.5), 0.5).size(), 1u);
}

TEST(AllCells, NeedASize) {
  EXPECT_THROW(gridCells(0.0), std::invalid_argument);
  EXPECT_THROW(voronoiCells(0, 0.5), std::invalid_argument);
  EXPECT_THROW(voronoiCells(10, std::nan("")), std::invalid_argument);
}

}  // namespace
}  // namespace hexapod
