#include "learning/distributed_evaluator.h"

#include <stdexcept>
#include <thread>

#include "learning/worker.h"
#include "learning_fixture.h"
#include "queue_channel.h"

namespace hexapod {
namespace {

/// Ends at (first gene, second gene); look n adds ten times n to what the one before it saw.
class Analytic : public Evaluator {
 public:
  std::vector<Outcome> evaluate(const std::vector<Genome>& genomes) override {
    genomes_ += static_cast<std::int64_t>(genomes.size());
    std::vector<Outcome> outcomes;
    for (const Genome& genome : genomes) {
      if (genome[0] == 4) throw std::runtime_error("Level 4 is too much.");
      outcomes.push_back({Verdict::kWalked, {1.0 * genome[0], 1.0 * genome[1], 0.5}, 0.25});
    }
    return outcomes;
  }
  int looks() const override { return 3; }
  std::vector<Outcome> lookAgain(int look, const std::vector<Genome>&,
                                 const std::vector<Outcome>& previous) override {
    std::vector<Outcome> outcomes = previous;
    for (Outcome& outcome : outcomes) outcome.end_pose.x_m += 10.0 * look;
    return outcomes;
  }
  std::int64_t genomes() const { return genomes_; }

 private:
  std::int64_t genomes_ = 0;
};

/// Workers in threads of their own.
class Crew {
 public:
  explicit Crew(const std::vector<std::int64_t>& threads, const std::string& run_id = "run") {
    evaluators_ = std::vector<Analytic>(threads.size());
    for (std::size_t w = 0; w < threads.size(); ++w) {
      auto [here, there] = QueueChannel::makePair();
      channels_.push_back(here);
      threads_.emplace_back([this, w, channel = there, own = Introduction{run_id, threads[w], ""}] {
        serve(*channel, own, evaluators_[w], [this, w] { return evaluators_[w].genomes(); });
      });
    }
  }
  ~Crew() { dismiss(); }

  void dismiss() {
    for (const auto& channel : channels_) channel->send("");
    for (std::thread& thread : threads_) thread.join();
    channels_.clear();
    threads_.clear();
  }

  DistributedEvaluator::Workers workers() const { return {channels_.begin(), channels_.end()}; }
  std::int64_t genomesOf(std::size_t worker) const { return evaluators_[worker].genomes(); }

 private:
  std::vector<Analytic> evaluators_;
  std::vector<std::shared_ptr<QueueChannel>> channels_;
  std::vector<std::thread> threads_;
};

const std::atomic<bool> kNotCancelled{false};
const std::atomic<bool> kCancelled{true};

std::vector<Genome> someGenomes(std::size_t count) {
  std::vector<Genome> genomes;
  for (std::size_t i = 0; i < count; ++i) {
    genomes.push_back({static_cast<std::uint8_t>(i % 4), static_cast<std::uint8_t>(i / 4)});
  }
  return genomes;
}

void expectSame(const std::vector<Outcome>& a, const std::vector<Outcome>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].verdict, b[i].verdict);
    EXPECT_EQ(a[i].end_pose.x_m, b[i].end_pose.x_m);
    EXPECT_EQ(a[i].end_pose.y_m, b[i].end_pose.y_m);
    EXPECT_EQ(a[i].end_pose.yaw_rad, b[i].end_pose.yaw_rad);
    EXPECT_EQ(a[i].cost, b[i].cost);
  }
}

TEST(DistributedEvaluator, SaysWhatTheLocalOneWouldHoweverManyShareTheWork) {
  for (const std::vector<std::int64_t>& threads :
       std::vector<std::vector<std::int64_t>>{{}, {1}, {2, 1, 5}}) {
    Crew crew(threads);
    Analytic local;
    Analytic alone;
    DistributedEvaluator shared(local, {"run", 2, ""}, crew.workers(), kNotCancelled);
    EXPECT_EQ(shared.looks(), 3);
    for (const std::size_t count : {0, 1, 2, 3, 16}) {
      const std::vector<Genome> genomes = someGenomes(count);
      const std::vector<Outcome> first = alone.evaluate(genomes);
      expectSame(shared.evaluate(genomes), first);
      for (const int look : {2, 3}) {
        expectSame(shared.lookAgain(look, genomes, first), alone.lookAgain(look, genomes, first));
      }
    }
    EXPECT_EQ(local.genomes() + shared.remoteSimulations(), 0 + 1 + 2 + 3 + 16);
  }
}

TEST(DistributedEvaluator, SharesByThreads) {
  Crew crew({2, 5});
  Analytic local;
  DistributedEvaluator shared(local, {"run", 1, ""}, crew.workers(), kNotCancelled);
  shared.evaluate(someGenomes(16));
  crew.dismiss();
  EXPECT_EQ(local.genomes(), 2);
  EXPECT_EQ(crew.genomesOf(0), 4);
  EXPECT_EQ(crew.genomesOf(1), 10);
}

TEST(DistributedEvaluator, RefusesAWorkerOfAnotherRun) {
  const Crew crew({1}, "another run");
  Analytic local;
  const std::string sentence = complaintOf([&] {
    DistributedEvaluator(local, {"run", 1, ""}, crew.workers(), kNotCancelled);
  });
  EXPECT_TRUE(mentions(sentence, "Process 1") && mentions(sentence, "another run")) << sentence;
}

TEST(DistributedEvaluator, TellsWhyAWorkerCannotWork) {
  auto [here, there] = QueueChannel::makePair();
  here->send("");  // lets the worker go at once
  declineWork(*there, "There is no robot.");
  Analytic local;
  const std::string sentence = complaintOf([&, channel = here] {
    DistributedEvaluator(local, {"run", 1, ""}, {channel}, kNotCancelled);
  });
  EXPECT_TRUE(mentions(sentence, "Process 1: There is no robot.")) << sentence;
}

TEST(DistributedEvaluator, NamesTheWorkerThatCouldNotDoItsPartAndCanGoOn) {
  const Crew crew({1, 1});
  Analytic local;
  DistributedEvaluator shared(local, {"run", 1, ""}, crew.workers(), kNotCancelled);
  const std::vector<Genome> genomes = {{1, 0}, {2, 0}, {4, 0}};
  const std::string sentence = complaintOf([&] { shared.evaluate(genomes); });
  EXPECT_TRUE(mentions(sentence, "Process 2: Level 4")) << sentence;
  EXPECT_EQ(shared.evaluate(someGenomes(3)).size(), 3U);
}

TEST(DistributedEvaluator, AFailureHereLeavesNoAnswerBehindThatCouldBeTakenForALaterOne) {
  const Crew crew({1});
  Analytic local;
  Analytic alone;
  DistributedEvaluator shared(local, {"run", 1, ""}, crew.workers(), kNotCancelled);
  EXPECT_THROW(shared.evaluate({{4, 0}, {1, 1}}), std::runtime_error);
  expectSame(shared.evaluate(someGenomes(6)), alone.evaluate(someGenomes(6)));
}

TEST(DistributedEvaluator, GivesUpABatchWhoseWorkerIsLost) {
  auto [here, there] = QueueChannel::makePair();
  there->send(toMessage(Introduction{"run", 1, ""}));
  there->send(QueueChannel::kSilence);
  Analytic local;
  DistributedEvaluator shared(local, {"run", 1, ""}, {here}, kCancelled);
  EXPECT_THROW(shared.evaluate(someGenomes(4)), EvaluationCancelled);
}

TEST(DistributedEvaluator, DoesThePartOfAWorkerThatAnswersNoMoreAndGoesOnWithoutIt) {
  const Crew crew({1, 1});
  auto [here, there] = QueueChannel::makePair();
  there->send(toMessage(Introduction{"run", 3, ""}));
  there->send(QueueChannel::kSilence);
  DistributedEvaluator::Workers workers = crew.workers();
  workers.insert(workers.begin() + 1, here);
  Analytic local;
  Analytic alone;
  DistributedEvaluator shared(local, {"run", 1, ""}, workers, kNotCancelled);
  for (const std::size_t count : {16, 5}) {
    expectSame(shared.evaluate(someGenomes(count)), alone.evaluate(someGenomes(count)));
  }
}

TEST(DistributedEvaluator, RefusesAWorkerThatDoesNotIntroduceItself) {
  auto [here, there] = QueueChannel::makePair();
  there->send(QueueChannel::kSilence);
  Analytic local;
  const std::string sentence = complaintOf([&, channel = here] {
    DistributedEvaluator(local, {"run", 1, ""}, {channel}, kNotCancelled, 60.0);
  });
  EXPECT_TRUE(mentions(sentence, "Process 1") && mentions(sentence, "60 s")) << sentence;
}

TEST(DistributedEvaluator, IsCancelledByAWorkerThatIsAskedToStop) {
  auto [here, there] = QueueChannel::makePair();
  there->send(toMessage(Introduction{"run", 1, ""}));
  Result stopped;
  stopped.cancelled = true;
  there->send(toMessage(stopped));
  Analytic local;
  DistributedEvaluator shared(local, {"run", 1, ""}, {here}, kNotCancelled);
  EXPECT_THROW(shared.evaluate(someGenomes(4)), EvaluationCancelled);
}

TEST(WorkMessage, ReadsBackWhatWasWritten) {
  const Questions task{3, {{0, 1, 2}, {}, {4, 10, 252, 255}}, Analytic().evaluate(someGenomes(3))};
  const Questions read = questionsFrom(toMessage(task));
  EXPECT_EQ(read.look, 3);
  EXPECT_EQ(read.genomes, task.genomes);
  expectSame(read.previous, task.previous);
  const Result result = resultFrom(toMessage(Result{task.previous, 17, "why", true}));
  expectSame(result.outcomes, task.previous);
  EXPECT_EQ(result.simulations, 17);
  EXPECT_EQ(result.problem, "why");
  EXPECT_TRUE(result.cancelled);
}

TEST(WorkMessage, RefusesAVerdictThatThereIsNot) {
  Outcome outcome;
  outcome.verdict = static_cast<Verdict>(17);
  EXPECT_THROW(resultFrom(toMessage(Result{{outcome}})), std::runtime_error);
}

TEST(WorkMessage, RefusesWhatIsCutShortOrTooLong) {
  const std::string message = toMessage(Questions{2, someGenomes(3), {Outcome(), Outcome()}});
  for (std::size_t size = 0; size < message.size(); ++size) {
    EXPECT_THROW(questionsFrom(message.substr(0, size)), std::runtime_error) << size;
  }
  EXPECT_THROW(questionsFrom(message + "x"), std::runtime_error);
  EXPECT_THROW(questionsFrom(std::string(message.size(), '\xff')), std::runtime_error);
}

class SharedSessionTest : public LearningFixture {};

TEST_F(SharedSessionTest, EndsWithTheEntriesOfASessionAlone) {
  LearnOptions options = smallRun("a.db");
  options.threads = 1;
  auto [here, there] = QueueChannel::makePair();
  std::thread worker([&, channel = there] { workFor(*channel, robot_, options, kNotCancelled); });
  {
    LearningSession session(robot_, options, [this] { return now(); }, {here});
    EXPECT_TRUE(session.run({}));
  }
  here->send("");
  worker.join();
  expectSameRun(loadRepertoire(options.repertoire_file), undisturbed(options));
}

}  // namespace
}  // namespace hexapod
