#include "ros_interface/learner/learner_core.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <vector>

#include "learning/learning_fixture.h"
#include "ros_interface/fake_clock.h"

namespace hexapod {
namespace {

namespace fs = std::filesystem;

using Progress = hexapod_repertoire::LearningProgress;

// Time passes while it is looked at, so that learning takes some.
class PassingClock : public FakeClock {
 public:
  std::int64_t steadyNow_ns() const override {
    pass(kSecond_ns / 4);
    return FakeClock::steadyNow_ns();
  }
};

// A learner of five generations and a half, and what it tells. What a test does, it does in
// `on_tell`, where the other threads of a node would.
class LearnerCoreTest : public LearningFixture, public LearnerAudience {
 protected:
  LearnerCoreTest() { options_.exit_when_done = true; }

  void show(const Repertoire& repertoire) override { shown_.push_back(repertoire.entries.size()); }
  void tell(const Progress& progress) override {
    told_.push_back(progress);
    if (on_tell) on_tell(progress);
  }

  void tell(const hexapod_repertoire::LearningHistory& history) override {
    histories_.push_back(history);
  }

  LearnerCore& core() {
    options_.learn = smallRun("gaits.db");
    core_ =
        std::make_unique<LearnerCore>(robot_, options_, clock_, *this, [this] { return leaves_; });
    return *core_;
  }

  // The folder is elsewhere for a while.
  void makeUnwritable() {
    fs::rename(folder_, folder_.string() + ".away");
    fs::create_directory_symlink("/nowhere", folder_);
  }
  void makeWritable() {
    fs::remove(folder_);
    fs::rename(folder_.string() + ".away", folder_);
  }

  PassingClock clock_;
  LearnerOptions options_;
  std::unique_ptr<LearnerCore> core_;
  bool leaves_ = false;
  std::function<void(const Progress&)> on_tell;
  std::vector<Progress> told_;
  std::vector<hexapod_repertoire::LearningHistory> histories_;
  std::vector<std::size_t> shown_;
};

TEST_F(LearnerCoreTest, TellsHowFarItIsAndShowsTheRepertoireAtTheEnd) {
  EXPECT_EQ(core().run(), 0);
  ASSERT_GT(told_.size(), 3u);
  EXPECT_EQ(told_.front().phase, "evolving");
  EXPECT_EQ(told_.back().phase, "done");
  EXPECT_EQ(told_.back().evaluations, 55);
  EXPECT_EQ(told_.back().evaluations_budget, 55);
  EXPECT_EQ(told_.back().run_id, loadRepertoire(options_.learn.repertoire_file).run_id);
  const std::size_t entries = loadRepertoire(options_.learn.repertoire_file).entries.size();
  EXPECT_EQ(shown_.back(), entries);
  const std::string words = core_->lastWords();
  EXPECT_NE(words.find(std::to_string(entries) + " entries in " + options_.learn.repertoire_file),
            std::string::npos);
  EXPECT_NE(words.find("./run walk repertoire_file:="), std::string::npos);
}

TEST_F(LearnerCoreTest, TellsTheHistoryThatIsInTheFileAndThatOfARunThatGoesOnAtOnce) {
  EXPECT_EQ(core().run(), 0);
  const Repertoire repertoire = loadRepertoire(options_.learn.repertoire_file);
  ASSERT_FALSE(histories_.empty());
  const auto told = histories_.back();
  EXPECT_EQ(told.run_id, repertoire.run_id);
  ASSERT_EQ(told.evaluations.size(), repertoire.history.size());
  for (std::size_t i = 0; i < repertoire.history.size(); ++i) {
    EXPECT_EQ(told.evaluations[i], repertoire.history[i].evaluations);
    EXPECT_EQ(told.sparseness_m[i], repertoire.history[i].sparseness_m);
    EXPECT_EQ(told.median_orientation_error_rad[i],
              repertoire.history[i].median_orientation_error_rad);
  }
  histories_.clear();
  options_.learn = smallRun("gaits.db");
  options_.learn.resume = true;
  core_.reset();
  LearnerCore again(robot_, options_, clock_, *this, [] { return false; });
  EXPECT_EQ(again.run(), 0);
  EXPECT_EQ(histories_.at(0).evaluations, told.evaluations);
}

TEST_F(LearnerCoreTest, ShowsAGrowingRepertoireNoMoreOftenThanAsked) {
  options_.publish_period_s = 86400.0;
  EXPECT_EQ(core().run(), 0);
  EXPECT_EQ(shown_.size(), 2u) << "at first and at the end";
}

TEST_F(LearnerCoreTest, PausedItStandsStillTellsOnSavesAndGoesOn) {
  int paused = 0;
  std::int64_t evaluations = 0;
  on_tell = [&](const Progress& progress) {
    if (progress.phase != "paused") {
      if (paused == 0 && progress.generation >= 2) core_->pause(true);
      evaluations = progress.evaluations;
      return;
    }
    if (++paused < 5) return;
    const LearnerCore::Answer saved = core_->save();
    EXPECT_TRUE(saved.success) << saved.message;
    EXPECT_EQ(loadRepertoire(options_.learn.repertoire_file).evaluations, progress.evaluations);
    EXPECT_TRUE(core_->pause(false).success);
  };
  EXPECT_EQ(core().run(), 0);
  EXPECT_EQ(paused, 5);
  std::vector<std::int64_t> while_paused;
  for (const Progress& progress : told_) {
    if (progress.phase == "paused") while_paused.push_back(progress.evaluations);
  }
  EXPECT_EQ(while_paused, std::vector<std::int64_t>(5, while_paused.at(0)));
  EXPECT_EQ(evaluations, 55);
}

TEST_F(LearnerCoreTest, ASaveThatFailsIsToldAndOneThatSucceedsIsInTheFile) {
  bool tried = false;
  on_tell = [&](const Progress& progress) {
    if (tried || progress.generation < 2) return;
    tried = true;
    makeUnwritable();
    const LearnerCore::Answer failed = core_->save();
    EXPECT_FALSE(failed.success);
    EXPECT_NE(failed.message.find(folder_.string()), std::string::npos) << failed.message;
    EXPECT_NE(core_->lastWords().find("is lost"), std::string::npos);
    makeWritable();
    const LearnerCore::Answer saved = core_->save();
    EXPECT_TRUE(saved.success) << saved.message;
    EXPECT_NE(saved.message.find(options_.learn.repertoire_file), std::string::npos);
  };
  EXPECT_EQ(core().run(), 0);
  EXPECT_TRUE(tried);
}

TEST_F(LearnerCoreTest, WhatIsNotInTheFileInTheEndIsAnError) {
  on_tell = [&](const Progress& progress) {
    if (progress.generation == 3 && !fs::is_symlink(folder_)) makeUnwritable();
  };
  EXPECT_EQ(core().run(), 1);
  EXPECT_NE(core_->lastWords().find("What was learned since is lost."), std::string::npos);
  makeWritable();
}

TEST_F(LearnerCoreTest, AFileThatCanBeWrittenAgainIsWrittenBeforeItEnds) {
  on_tell = [&](const Progress& progress) {
    if (progress.generation == 3 && !fs::is_symlink(folder_)) makeUnwritable();
    if (progress.phase != "done") return;
    clock_.on_step = [this, done_ns = clock_.FakeClock::steadyNow_ns()] {
      const bool later = clock_.FakeClock::steadyNow_ns() - done_ns > kSecond_ns;
      if (later && fs::is_symlink(folder_)) makeWritable();
    };
  };
  EXPECT_EQ(core().run(), 0);
  clock_.on_step = nullptr;
  EXPECT_EQ(loadRepertoire(options_.learn.repertoire_file).evaluations, 55);
}

TEST_F(LearnerCoreTest, DoneItServesUntilItIsToLeaveAndHasNothingToPause) {
  options_.exit_when_done = false;
  int looked = 0;
  on_tell = [&](const Progress& progress) {
    if (progress.phase != "done") return;
    clock_.on_step = [&] { leaves_ = ++looked > 100; };
    const LearnerCore::Answer paused = core_->pause(true);
    EXPECT_FALSE(paused.success);
    EXPECT_NE(paused.message.find("nothing to pause"), std::string::npos);
  };
  EXPECT_EQ(core().run(), 0);
  EXPECT_GT(looked, 100);
  fs::remove(options_.learn.repertoire_file);
  EXPECT_TRUE(core_->save().success);
  EXPECT_TRUE(fs::exists(options_.learn.repertoire_file));
}

TEST_F(LearnerCoreTest, StartedPausedItLearnsNothingBeforeItIsToGoOn) {
  options_.start_paused = true;
  int paused = 0;
  on_tell = [&](const Progress& progress) {
    if (progress.phase != "paused") return;
    EXPECT_EQ(progress.evaluations, 0);
    if (++paused == 3) core_->pause(false);
  };
  EXPECT_EQ(core().run(), 0);
  EXPECT_EQ(paused, 3);
  EXPECT_EQ(told_.back().phase, "done");
}

TEST_F(LearnerCoreTest, AskedToLeaveWhilePausedItKeepsWhatItHas) {
  on_tell = [&](const Progress& progress) {
    if (progress.phase == "paused") {
      leaves_ = true;
      core_->requestStop();
    } else if (progress.generation == 2) {
      core_->pause(true);
    }
  };
  EXPECT_EQ(core().run(), 0);
  EXPECT_EQ(loadRepertoire(options_.learn.repertoire_file).generation, 2);
  EXPECT_EQ(told_.back().phase, "paused");
}

}  // namespace
}  // namespace hexapod
