#include "python/keywords.h"

#include <cstdint>
#include <map>
#include <stdexcept>

namespace py = pybind11;

namespace hexapod {
namespace {

OptionValue valueOf(const std::string& name, const py::handle& value, const std::string& source) {
  if (py::isinstance<py::bool_>(value)) return value.cast<bool>();
  if (py::isinstance<py::str>(value)) return value.cast<std::string>();
  // NumPy's numbers as well.
  if (PyIndex_Check(value.ptr()) != 0)
    return py::int_(py::reinterpret_borrow<py::object>(value)).cast<std::int64_t>();
  if (py::hasattr(value, "__float__"))
    return py::float_(py::reinterpret_borrow<py::object>(value)).cast<double>();
  throw std::invalid_argument(source + ": '" + name +
                              "' is wrong: expected a number, a text, True or False, found " +
                              py::repr(value).cast<std::string>() + ".");
}

}  // namespace

void applyKeywords(const std::vector<Option>& options, const py::kwargs& keywords,
                   const std::string& source) {
  std::map<std::string, OptionValue> values;
  for (const auto& [key, value] : keywords) {
    const auto name = key.cast<std::string>();
    values[name] = valueOf(name, value, source);
  }
  applyOptions(options, values, source);
}

}  // namespace hexapod
