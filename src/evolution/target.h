#pragma once

namespace hexapod {

/// A position of the plane that a controller is wanted for, or that stands for those around it [m].
struct Target {
  double x_m = 0.0;
  double y_m = 0.0;
};

}  // namespace hexapod
