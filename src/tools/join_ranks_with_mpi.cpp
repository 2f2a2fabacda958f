#include <mpi.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <limits>
#include <stdexcept>
#include <thread>

#include "tools/ranks_alone.h"

namespace hexapod {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kTag = 1;
// Waiting must not take a core from those that simulate; a batch takes milliseconds.
constexpr std::chrono::microseconds kPoll{100};
// mpirun kills one second after it asked to end; before that the run must be saved.
constexpr std::chrono::milliseconds kPatience{300};

class MpiChannel : public Channel {
 public:
  explicit MpiChannel(int other) : other_(other) {}

  void send(const std::string& message) override {
    if (message.size() > static_cast<std::size_t>(std::numeric_limits<int>::max())) {
      throw std::runtime_error("A batch is too large for one message; use a smaller population.");
    }
    if (request_ != MPI_REQUEST_NULL) MPI_Wait(&request_, MPI_STATUS_IGNORE);
    sent_ =
        message;  // kept until the other side has it: a process that hangs must not stop this one
    MPI_Isend(sent_.data(), static_cast<int>(sent_.size()), MPI_BYTE, other_, kTag, MPI_COMM_WORLD,
              &request_);
  }

  /// Waits until the other side has all that was sent.
  void finish() {
    if (request_ != MPI_REQUEST_NULL) MPI_Wait(&request_, MPI_STATUS_IGNORE);
  }

  std::optional<std::string> receive(const std::atomic<bool>& cancelled,
                                     double patience_s) override {
    MPI_Status status;
    int is_there = 0;
    const Clock::time_point begin = Clock::now();
    std::optional<Clock::time_point> deadline;
    if (patience_s > 0.0) {
      deadline = begin + std::chrono::duration_cast<Clock::duration>(
                             std::chrono::duration<double>(patience_s));
    }
    bool was_cancelled = false;
    while (true) {
      MPI_Iprobe(other_, kTag, MPI_COMM_WORLD, &is_there, &status);
      if (is_there != 0) break;
      if (cancelled && !was_cancelled) deadline = Clock::now() + kPatience;
      was_cancelled = cancelled;
      if (deadline && Clock::now() > *deadline) {
        is_lost_ = true;
        return std::nullopt;
      }
      std::this_thread::sleep_for(kPoll);
    }
    int size = 0;
    MPI_Get_count(&status, MPI_BYTE, &size);
    std::string message(static_cast<std::size_t>(size), '\0');
    MPI_Recv(message.data(), size, MPI_BYTE, other_, kTag, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    return message;
  }

  int other() const { return other_; }
  bool isLost() const { return is_lost_; }

 private:
  int other_;
  bool is_lost_ = false;
  std::string sent_;
  MPI_Request request_ = MPI_REQUEST_NULL;
};

/// One of the processes that mpirun started.
class MpiRanks : public Ranks {
 public:
  MpiRanks(int& argc, char**& argv) {
    int provided = 0;
    MPI_Init_thread(&argc, &argv, MPI_THREAD_FUNNELED, &provided);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
    MPI_Comm_size(MPI_COMM_WORLD, &count_);
    MPI_Comm on_this_machine = MPI_COMM_NULL;
    MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &on_this_machine);
    MPI_Comm_size(on_this_machine, &neighbours_);
    MPI_Comm_free(&on_this_machine);
    for (int other = rank_ == 0 ? 1 : 0; other < (rank_ == 0 ? count_ : 1); ++other) {
      channels_.push_back(std::make_shared<MpiChannel>(other));
    }
  }

  ~MpiRanks() override {
    if (rank_ == 0) {
      for (const auto& channel : channels_) channel->send("");
    }
    for (const auto& channel : channels_) channel->finish();
    MPI_Finalize();
  }

  int rank() const override { return rank_; }
  int count() const override { return count_; }
  int coresPerProcess() const override {
    return std::max(1, RankAlone().coresPerProcess() / neighbours_);
  }
  DistributedEvaluator::Workers workers() const override {
    if (rank_ != 0) return {};
    return {channels_.begin(), channels_.end()};
  }
  std::shared_ptr<Channel> master() const override {
    return rank_ == 0 ? nullptr : channels_.front();
  }
  std::string loss() const override {
    std::string lost;
    for (const auto& channel : channels_) {
      if (channel->isLost()) {
        lost += (lost.empty() ? "" : ", ") + std::to_string(channel->other());
      }
    }
    return lost.empty() ? "" : "No answer any more from process " + lost + ".";
  }
  [[noreturn]] void abort(int exit_code) override {
    MPI_Abort(MPI_COMM_WORLD, exit_code);
    std::_Exit(exit_code);
  }

 private:
  int rank_ = 0;
  int count_ = 1;
  int neighbours_ = 1;
  std::vector<std::shared_ptr<MpiChannel>> channels_;
};

/// True in what an mpirun, mpiexec or srun started. Alone, MPI is not even initialised.
bool isStartedTogether() {
  for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMIX_RANK", "PMI_RANK"}) {
    if (std::getenv(name) != nullptr) return true;
  }
  return false;
}

}  // namespace

std::unique_ptr<Ranks> joinRanks(int& argc, char**& argv) {
  if (!isStartedTogether()) return std::make_unique<RankAlone>();
  return std::make_unique<MpiRanks>(argc, argv);
}

}  // namespace hexapod
