// The Python module hexapod_repertoire._core; src/hexapod_repertoire/__init__.py shows its names.
#include <stdexcept>
#include <utility>

#include "python/arrays.h"
#include "python/bindings.h"

namespace py = pybind11;

namespace hexapod {
namespace {

/// What C++ throws has the sentence for the user: one Python exception for all of it.
void translate(std::exception_ptr thrown) {
  try {
    if (thrown) std::rethrow_exception(std::move(thrown));
  } catch (const py::builtin_exception&) {
    throw;  // pybind11's own
  } catch (const std::runtime_error& error) {
    PyErr_SetString(PyExc_ValueError, error.what());
  }
}

}  // namespace
}  // namespace hexapod

PYBIND11_MODULE(_core, module) {
  module.doc() = "The C++ part of hexapod_repertoire.";
  py::register_exception_translator(hexapod::translate);
  hexapod::registerArrays(module);
  hexapod::bindRobot(module);
  hexapod::bindRepertoire(module);
  hexapod::bindSimulation(module);
  hexapod::bindAlgorithm(module);
}
