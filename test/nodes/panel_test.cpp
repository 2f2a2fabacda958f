// The panel for rviz without a display and without rviz: a hand that clicks, and nodes that only
// note what they are asked.
#include "ros_interface/panel/panel.h"

#include <gtest/gtest.h>
#include <ros/ros.h>
#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>

#include <QApplication>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTabWidget>
#include <QTableView>
#include <QTableWidget>
#include <QtTest>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "hexapod_repertoire/ChooseEntry.h"
#include "hexapod_repertoire/ExecutorState.h"
#include "hexapod_repertoire/GoTo.h"
#include "hexapod_repertoire/LearningProgress.h"
#include "hexapod_repertoire/LoadRepertoire.h"
#include "hexapod_repertoire/RepertoireFilter.h"
#include "hexapod_repertoire/StepReport.h"
#include "hexapod_repertoire/WalkSummary.h"
#include "repertoire/fixtures.h"
#include "ros_interface/common/conversions.h"

namespace hexapod {
namespace {

using hexapod_repertoire::ExecutorState;
using hexapod_repertoire::LearningProgress;

constexpr int kPatience_ms = 20000;

// The nodes of a session, which do nothing but answer "Heard <what>." and keep it.
class FakeNodes {
 public:
  FakeNodes() {
    for (const char* name : {"learner/save", "executor/arm", "executor/stop", "executor/stand",
                             "executor/sit", "planner/cancel"}) {
      serve<std_srvs::Trigger>(name, [name](const auto&) { return std::string(name); });
    }
    serve<std_srvs::SetBool>("learner/pause", [](const std_srvs::SetBool::Request& request) {
      return std::string(request.data ? "pause" : "start");
    });
    serve<hexapod_repertoire::GoTo>("go_to", [](const hexapod_repertoire::GoTo::Request& request) {
      const auto& goal = request.target_pose;
      return "go to " + std::to_string(goal.pose.position.x) + " in " + goal.header.frame_id;
    });
    serve<hexapod_repertoire::LoadRepertoire>(
        "repertoire_server/load", [](const auto& request) { return "load " + request.file; });
    serve<hexapod_repertoire::ChooseEntry>("browser/choose", [](const auto& request) {
      return (request.play ? "play " : "look at ") + std::to_string(request.entry_id);
    });
    filter_ = node_.subscribe<hexapod_repertoire::RepertoireFilter>(
        "repertoire_filter", 10, [this](const hexapod_repertoire::RepertoireFilter::ConstPtr& m) {
          note("filter " + std::to_string(m->max_spread_m));
        });
    spinner_.start();
  }
  ~FakeNodes() { spinner_.stop(); }

  bool wasAsked(const std::string& what) {
    const std::lock_guard<std::mutex> lock(mutex_);
    return std::count(asked_.begin(), asked_.end(), what) > 0;
  }

  ros::NodeHandle node_;
  ros::Publisher progress_ = node_.advertise<LearningProgress>("learner/progress", 1, true);
  ros::Publisher state_ = node_.advertise<ExecutorState>("executor/state", 1, true);
  ros::Publisher walk_ =
      node_.advertise<hexapod_repertoire::WalkSummary>("planner/walk_summary", 1, true);
  ros::Publisher steps_ =
      node_.advertise<hexapod_repertoire::StepReport>("browser/step_report", 1, true);
  ros::Publisher repertoire_ =
      node_.advertise<hexapod_repertoire::Repertoire>("repertoire", 1, true);

 private:
  void note(const std::string& what) {
    const std::lock_guard<std::mutex> lock(mutex_);
    asked_.push_back(what);
  }

  template <class Service, class Describe>
  void serve(const std::string& name, Describe describe) {
    const boost::function<bool(typename Service::Request&, typename Service::Response&)> answer =
        [this, describe](typename Service::Request& request, typename Service::Response& response) {
          const std::string what = describe(request);
          note(what);
          response.message = "Heard " + what + ".";
          return true;
        };
    services_.push_back(node_.advertiseService(name, answer));
  }

  std::mutex mutex_;
  std::vector<std::string> asked_;
  std::vector<ros::ServiceServer> services_;
  ros::Subscriber filter_;
  ros::AsyncSpinner spinner_{2};
};

class PanelTest : public ::testing::Test {
 protected:
  PanelTest() {
    LearningProgress progress;
    progress.run_id = "run";
    progress.phase = "paused";
    nodes_.progress_.publish(progress);
    executor(ExecutorState::DISARMED);
    nodes_.repertoire_.publish(toMsg(sampleRepertoire(20), ros::Time::now()));
    panel_.resize(320, 700);
    panel_.show();
  }

  void executor(std::uint8_t state) {
    ExecutorState message;
    message.state = state;
    message.reason = "Because.";
    nodes_.state_.publish(message);
  }

  template <class Widget>
  Widget* find(const char* name) {
    auto* widget = panel_.findChild<Widget*>(name);
    if (widget == nullptr) throw std::runtime_error(std::string("no widget ") + name);
    return widget;
  }

  void click(const char* name) {
    auto* button = find<QPushButton>(name);
    ASSERT_TRUE(QTest::qWaitFor([&] { return button->isEnabled(); }, kPatience_ms)) << name;
    QTest::mouseClick(button, Qt::LeftButton);
  }

  void expectAsked(const std::string& what) {
    EXPECT_TRUE(QTest::qWaitFor([&] { return nodes_.wasAsked(what); }, kPatience_ms)) << what;
    const QString answer = QString::fromStdString("Heard " + what + ".");
    EXPECT_TRUE(
        QTest::qWaitFor([&] { return find<QLabel>("answer")->text() == answer; }, kPatience_ms))
        << find<QLabel>("answer")->text().toStdString();
  }

  FakeNodes nodes_;
  Panel panel_;
};

TEST_F(PanelTest, ItsButtonsAskTheNodesAndItsFootTellsTheAnswers) {
  click("start");
  expectAsked("start");
  LearningProgress progress;
  progress.run_id = "run";
  progress.phase = "evolving";
  nodes_.progress_.publish(progress);
  click("pause");
  expectAsked("pause");
  click("save");
  expectAsked("learner/save");
  find<QTabWidget>("tabs")->setCurrentIndex(1);
  click("arm");
  expectAsked("executor/arm");
  executor(ExecutorState::READY);
  for (const char* name : {"stand", "sit", "stop"}) {
    click(name);
    expectAsked(std::string("executor/") + name);
  }
  click("cancel");
  expectAsked("planner/cancel");
}

TEST_F(PanelTest, GoSendsTheGoalThatItsBoxesHold) {
  executor(ExecutorState::READY);
  find<QTabWidget>("tabs")->setCurrentIndex(1);
  find<QDoubleSpinBox>("x_m")->setValue(0.5);
  auto* frame = find<QLineEdit>("frame");
  frame->clear();
  QTest::keyClicks(frame, "base_footprint");
  click("go");
  expectAsked("go to 0.500000 in base_footprint");
}

TEST_F(PanelTest, TheListShrinksWithTheFilterAndARowIsLookedAtAndPlayed) {
  find<QTabWidget>("tabs")->setCurrentIndex(2);
  auto* table = find<QTableView>("entries");
  ASSERT_TRUE(QTest::qWaitFor([&] { return table->model()->rowCount() == 20; }, kPatience_ms));
  find<QDoubleSpinBox>("max_error_deg")->setValue(0.0);
  EXPECT_TRUE(QTest::qWaitFor([&] { return table->model()->rowCount() == 0; }, kPatience_ms));
  find<QDoubleSpinBox>("max_error_deg")->setValue(180.0);
  find<QDoubleSpinBox>("max_spread_cm")->setValue(999.0);
  EXPECT_TRUE(QTest::qWaitFor([&] { return nodes_.wasAsked("filter 9.990000"); }, kPatience_ms));
  ASSERT_TRUE(QTest::qWaitFor([&] { return table->model()->rowCount() == 20; }, kPatience_ms));
  const QPoint place = table->visualRect(table->model()->index(2, 0)).center();
  QTest::mouseClick(table->viewport(), Qt::LeftButton, {}, place);
  expectAsked("look at 3");
  QTest::mouseDClick(table->viewport(), Qt::LeftButton, {}, place);
  expectAsked("play 3");
}

TEST_F(PanelTest, LoadIsRefusedWhileSomebodyLearnsAndThenSendsTheFile) {
  find<QTabWidget>("tabs")->setCurrentIndex(2);
  auto* load = find<QPushButton>("load");
  ASSERT_TRUE(QTest::qWaitFor([&] { return !load->isEnabled(); }, kPatience_ms));
  nodes_.progress_.shutdown();
  QTest::keyClicks(find<QLineEdit>("file"), "a.db");
  click("load");
  expectAsked("load a.db");
}

TEST_F(PanelTest, TheTableOfNodesTellsStateAndReason) {
  find<QTabWidget>("tabs")->setCurrentIndex(3);
  auto* nodes = find<QTableWidget>("nodes");
  executor(ExecutorState::FAULT);
  ASSERT_TRUE(QTest::qWaitFor([&] { return nodes->item(1, 1)->text() == "fault"; }, kPatience_ms));
  EXPECT_EQ(nodes->item(1, 0)->text(), "executor");
  EXPECT_EQ(nodes->item(1, 2)->text(), "Because.");
  EXPECT_TRUE(nodes->item(1, 1)->font().bold());
}

TEST_F(PanelTest, WhatWasConfiguredIsSavedAndLoaded) {
  find<QTabWidget>("tabs")->setCurrentIndex(2);
  find<QDoubleSpinBox>("y_m")->setValue(-0.7);
  find<QDoubleSpinBox>("max_spread_cm")->setValue(1.5);
  find<QLineEdit>("file")->setText("/some/where.db");
  const rviz::Config config;
  panel_.save(config);
  Panel other;
  other.load(config);
  EXPECT_EQ(other.findChild<QTabWidget*>("tabs")->currentIndex(), 2);
  EXPECT_EQ(other.findChild<QDoubleSpinBox*>("y_m")->value(), -0.7);
  EXPECT_EQ(other.findChild<QDoubleSpinBox*>("max_spread_cm")->value(), 1.5);
  EXPECT_EQ(other.findChild<QLineEdit*>("file")->text(), "/some/where.db");
}

TEST_F(PanelTest, FitsBesideThePictureOnASmallScreen) {
  EXPECT_LE(panel_.minimumSizeHint().width(), 320);
  EXPECT_LE(panel_.minimumSizeHint().height(), 700);
}

}  // namespace
}  // namespace hexapod

int main(int argc, char** argv) {
  ::testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "panel_test");
  const QApplication application(argc, argv);
  const ros::NodeHandle keeps_ros_up;
  return RUN_ALL_TESTS();
}
