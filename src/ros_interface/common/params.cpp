#include "ros_interface/common/params.h"

#include <ros/param.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <stdexcept>

namespace hexapod {
namespace {

OptionValue valueOf(XmlRpc::XmlRpcValue& value) {
  switch (value.getType()) {
    case XmlRpc::XmlRpcValue::TypeBoolean:
      return static_cast<bool>(value);
    case XmlRpc::XmlRpcValue::TypeInt:
      return static_cast<std::int64_t>(static_cast<int>(value));
    case XmlRpc::XmlRpcValue::TypeDouble:
      return static_cast<double>(value);
    case XmlRpc::XmlRpcValue::TypeString:
      return static_cast<std::string>(value);
    default:
      throw std::invalid_argument("expected a single value, found a list, map or binary");
  }
}

}  // namespace

void loadParams(const ros::NodeHandle& private_node, const std::vector<Option>& options,
                const std::vector<std::string>& also_known) {
  const std::string& source = private_node.getNamespace();
  XmlRpc::XmlRpcValue params;
  if (!private_node.getParam("", params) || params.getType() != XmlRpc::XmlRpcValue::TypeStruct) {
    return;
  }
  std::map<std::string, OptionValue> values;
  std::string problems;
  for (auto& [name, value] : params) {
    if (std::find(also_known.begin(), also_known.end(), name) != also_known.end()) continue;
    try {
      values.emplace(name, valueOf(value));
    } catch (const std::invalid_argument& error) {
      problems += source + ": '" + name + "' is wrong: " + error.what() + ".\n";
    }
  }
  try {
    applyOptions(options, values, source);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(problems + error.what());
  }
  if (!problems.empty()) throw std::invalid_argument(problems);
}

std::string expandHome(const std::string& path) {
  const char* home = std::getenv("HOME");
  const bool relative_to_home = path == "~" || path.rfind("~/", 0) == 0;
  return relative_to_home && home ? home + path.substr(1) : path;
}

}  // namespace hexapod
