#include "ros_interface/common/master_watch.h"

#include <ros/master.h>
#include <ros/this_node.h>
#include <xmlrpcpp/XmlRpcException.h>

#include <algorithm>
#include <chrono>

namespace hexapod {
namespace {

constexpr std::chrono::milliseconds kLookPeriod{100};
constexpr int kLooksPerQuestion = 5;
constexpr int kSilentQuestions = 3;

bool ask(const std::string& method, XmlRpc::XmlRpcValue& answer) {
  XmlRpc::XmlRpcValue request;
  XmlRpc::XmlRpcValue response;
  request[0] = ros::this_node::getName();
  return ros::master::execute(method, request, response, answer, false);
}

// getSystemState: [publishers, subscribers, services], each a list of [topic, [nodes]].
std::map<std::string, std::vector<std::string>> publishersIn(
    XmlRpc::XmlRpcValue& state, const std::vector<std::string>& topics) {
  std::map<std::string, std::vector<std::string>> others;
  XmlRpc::XmlRpcValue& publishers = state[0];
  for (int i = 0; i < publishers.size(); ++i) {
    const std::string topic = publishers[i][0];
    if (std::find(topics.begin(), topics.end(), topic) == topics.end()) continue;
    for (int n = 0; n < publishers[i][1].size(); ++n) {
      const std::string node = publishers[i][1][n];
      if (node != ros::this_node::getName()) others[topic].push_back(node);
    }
  }
  return others;
}

}  // namespace

MasterWatch::MasterWatch(std::vector<std::string> topics)
    : topics_(std::move(topics)), thread_([this] { run(); }) {}

MasterWatch::~MasterWatch() {
  running_ = false;
  thread_.join();
}

std::vector<std::string> MasterWatch::otherPublishers(const std::string& topic) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto found = publishers_.find(topic);
  return found == publishers_.end() ? std::vector<std::string>() : found->second;
}

void MasterWatch::run() {
  for (int poll = 0; running_; ++poll) {
    if (poll % kLooksPerQuestion == 0) askOnce();
    std::this_thread::sleep_for(kLookPeriod);
  }
}

void MasterWatch::askOnce() {
  XmlRpc::XmlRpcValue pid;
  XmlRpc::XmlRpcValue state;
  try {
    if (!ask("getPid", pid) || !ask("getSystemState", state)) {
      lost_ = lost_ || ++silent_ >= kSilentQuestions;
      return;
    }
    silent_ = 0;
    const int now = pid;
    if (master_pid_ == 0) master_pid_ = now;
    lost_ = lost_ || now != master_pid_;
    auto publishers = publishersIn(state, topics_);
    const std::lock_guard<std::mutex> lock(mutex_);
    publishers_ = std::move(publishers);
  } catch (const XmlRpc::XmlRpcException&) {
    lost_ = lost_ || ++silent_ >= kSilentQuestions;
  }
}

}  // namespace hexapod
