#include "tools/own_processes.h"

#include <gtest/gtest.h>

#include <csignal>
#include <map>

namespace hexapod {
namespace {

std::map<std::size_t, ProcessEnd> endsOf(std::size_t count, std::size_t jobs,
                                         const std::function<int(std::size_t)>& work) {
  std::map<std::size_t, ProcessEnd> ends;
  forEachInOwnProcess(count, jobs, work, [&](std::size_t i, const ProcessEnd& end) {
    EXPECT_TRUE(ends.emplace(i, end).second) << i << " ended twice";
  });
  return ends;
}

TEST(OwnProcesses, TellTheirExitCodes) {
  for (const std::size_t jobs : {1, 3, 20}) {
    const auto ends = endsOf(7, jobs, [](std::size_t i) { return static_cast<int>(i); });
    ASSERT_EQ(ends.size(), 7u);
    for (const auto& [i, end] : ends) EXPECT_EQ(end.exit_code, static_cast<int>(i));
  }
}

TEST(OwnProcesses, AreNotStoppedByTheEndOfAnother) {
  const auto ends = endsOf(3, 1, [](std::size_t i) { return i == 1 ? std::raise(SIGKILL) : 0; });
  EXPECT_EQ(ends.at(0).signal, 0);
  EXPECT_EQ(ends.at(1).signal, SIGKILL);
  EXPECT_EQ(ends.at(2).signal, 0);
}

TEST(OwnProcesses, AreWaitedForWhereTheEndsOfChildrenAreIgnored) {
  std::signal(SIGCHLD, SIG_IGN);
  const auto ends = endsOf(3, 2, [](std::size_t i) { return static_cast<int>(i); });
  std::signal(SIGCHLD, SIG_DFL);
  ASSERT_EQ(ends.size(), 3u);
  EXPECT_EQ(ends.at(2).exit_code, 2);
}

TEST(OwnProcesses, KeepTheirMemoryToThemselves) {
  int value = 1;
  endsOf(2, 2, [&](std::size_t) { return value = 2; });
  EXPECT_EQ(value, 1);
}

TEST(OwnProcesses, NeedNotBeAny) {
  EXPECT_TRUE(endsOf(0, 2, [](std::size_t) { return 0; }).empty());
}

}  // namespace
}  // namespace hexapod
