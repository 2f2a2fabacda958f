#pragma once

#include <pybind11/pybind11.h>

namespace hexapod {

/// Each adds its names, with their docstrings, to the Python module.
void bindRobot(pybind11::module& module);
void bindRepertoire(pybind11::module& module);
void bindSimulation(pybind11::module& module);
void bindAlgorithm(pybind11::module& module);

}  // namespace hexapod
