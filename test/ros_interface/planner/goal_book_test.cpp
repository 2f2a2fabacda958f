#include "ros_interface/planner/goal_book.h"

#include <gtest/gtest.h>

#include <map>

#include "common/random.h"
#include "ros_interface/planner/fakes.h"

namespace hexapod {
namespace {

class GoalBookTest : public testing::Test {
 protected:
  GoalBook::Goal enter(Client& client, const std::string& id = "", bool plan_only = false) {
    GoalRequest request = goalAt(1.0, 0.0, 0.0);
    request.plan_only = plan_only;
    return book_.enter(id, request, client.listener(), 0);
  }
  bool accept(const GoalBook::Goal& goal) { return book_.accept(goal, WalkReport(), WalkGoal()); }

  GoalBook book_;
};

TEST_F(GoalBookTest, GivesTheNewestOutForExamination) {
  Client a, b, c;
  enter(a, "a");
  enter(b, "b");
  EXPECT_EQ(book_.takeToExamine()->id, "b");
  enter(c, "c");
  EXPECT_EQ(book_.takeToExamine()->id, "c");
  EXPECT_EQ(book_.takeToExamine()->id, "a");
}

TEST_F(GoalBookTest, AnOlderGoalExaminedLaterIsTooLate) {
  Client older, newer;
  const auto first = enter(older);
  const auto second = enter(newer);
  EXPECT_TRUE(accept(second));
  EXPECT_EQ(older.waitForEnd().code, GoalCode::PREEMPTED);
  EXPECT_EQ(book_.takeToWalk(), second);
  second->end(GoalCode::SUCCEEDED, "");
  book_.strike(second);
  // Even when the newer one has been walked to already.
  EXPECT_FALSE(accept(first));
  EXPECT_EQ(older.ends(), 1u);
  EXPECT_FALSE(older.wasAccepted());
}

TEST_F(GoalBookTest, TheWalkedGoalEndsAtItsRestAndNotBefore) {
  Client walked, newer;
  const auto first = enter(walked);
  accept(first);
  EXPECT_EQ(book_.takeToWalk(), first);
  EXPECT_FALSE(book_.newerIsNext());
  const auto second = enter(newer);
  EXPECT_FALSE(book_.newerIsNext());
  accept(second);
  EXPECT_TRUE(book_.newerIsNext());
  EXPECT_FALSE(first->ended());
  // A newer one that is cancelled takes nothing over.
  book_.cancel(second->id);
  EXPECT_FALSE(book_.newerIsNext());
}

TEST_F(GoalBookTest, CancellingOneLeavesTheOthersAlone) {
  Client walked, examined, planned;
  const auto first = enter(walked, "walked");
  accept(first);
  book_.takeToWalk();
  enter(examined, "examined");
  enter(planned, "planned", true);
  EXPECT_EQ(book_.cancel("examined"), 1u);
  EXPECT_EQ(book_.cancel("examined"), 0u);
  EXPECT_EQ(book_.cancel("nobody"), 0u);
  EXPECT_EQ(book_.cancel(""), 0u);
  EXPECT_EQ(examined.waitForEnd().code, GoalCode::PREEMPTED);
  EXPECT_EQ(walked.ends() + planned.ends(), 0u);
  EXPECT_EQ(book_.cancelAll(), 2u);
  EXPECT_EQ(book_.cancelAll(), 0u);
}

TEST_F(GoalBookTest, ACancelTellsWhatTheWalkHadComeTo) {
  Client client;
  const auto goal = enter(client);
  accept(goal);
  WalkReport so_far;
  so_far.steps = 3;
  so_far.final_xy_error_m = 0.7;
  goal->note(so_far);
  book_.cancelAll();
  EXPECT_EQ(client.waitForEnd().code, GoalCode::PREEMPTED);
  EXPECT_EQ(client.waitForEnd().steps, 3u);
  EXPECT_EQ(client.waitForEnd().final_xy_error_m, 0.7);
}

TEST_F(GoalBookTest, OnceClosedEveryGoalIsAnsweredAndNobodyWaits) {
  Client open, accepted, late;
  enter(open);
  accept(enter(accepted));
  book_.close(GoalCode::SHUTDOWN, "leaving");
  enter(late);
  for (Client* client : {&open, &accepted, &late}) {
    EXPECT_NE(client->waitForEnd().code, GoalCode::SUCCEEDED);
    EXPECT_EQ(client->ends(), 1u);
  }
  EXPECT_EQ(late.waitForEnd().code, GoalCode::SHUTDOWN);
  EXPECT_EQ(book_.takeToExamine(), nullptr);
  EXPECT_EQ(book_.takeToWalk(), nullptr);
}

// Whatever happens in whatever order: one answer for each goal, and of two goals that were accepted
// the newer was accepted later.
TEST_F(GoalBookTest, AnswersEachGoalOnceInAnyOrderOfEvents) {
  Random random(1);
  for (int run = 0; run < 300; ++run) {
    GoalBook book;
    std::vector<std::unique_ptr<Client>> clients;
    std::vector<GoalBook::Goal> examined;
    GoalBook::Goal walked;
    std::size_t unexamined = 0;
    std::uint64_t newest = 0;
    bool next = false;
    for (int event = 0; event < 40; ++event) {
      switch (random.below(7)) {
        case 0:
        case 1:
          clients.push_back(std::make_unique<Client>());
          book.enter("", goalAt(0, 0, 0), clients.back()->listener(), 0);
          ++unexamined;
          break;
        case 2:
          if (unexamined > 0) examined.push_back(book.takeToExamine()), --unexamined;
          break;
        case 3: {
          if (examined.empty()) break;
          const auto goal = examined[random.below(examined.size())];
          examined.erase(std::find(examined.begin(), examined.end(), goal));
          if (!book.accept(goal, WalkReport(), WalkGoal())) break;
          EXPECT_GT(goal->number, newest);
          newest = goal->number;
          next = true;
          break;
        }
        case 4:
          if (!walked && next) walked = book.takeToWalk(), next = false;
          break;
        case 5:
          if (!walked) break;
          walked->end(GoalCode::SUCCEEDED, "");
          book.strike(walked);
          walked.reset();
          break;
        default:
          if (random.below(4) == 0)
            book.cancelAll();
          else if (!clients.empty()) {
            book.cancel("goal_" + std::to_string(1 + random.below(clients.size())));
          }
      }
      for (const auto& client : clients) ASSERT_LE(client->ends(), 1u);
    }
    book.close(GoalCode::SHUTDOWN, "");
    for (const auto& client : clients) ASSERT_EQ(client->ends(), 1u);
  }
}

}  // namespace
}  // namespace hexapod
