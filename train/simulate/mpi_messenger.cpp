// SPDX-License-Identifier: MIT
#include "train/simulate/mpi_messenger.h"

#include <cstdlib>
#include <string>

#include "motion/error.h"

#ifdef FLINCH_MPI
#include <mpi.h>

#include <deque>
#include <exception>
#endif

namespace flinch::train {

namespace {

/// Returns the number of processes that the launcher says it started, from the environment
/// variables of Open MPI, or of Slurm and MPICH through PMI; 1 without a launcher.
int launched_count() {
  for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"}) {
    if (const char* size = std::getenv(name)) return std::atoi(size);
  }
  // PMIx sets only the rank; Slurm sets the number of tasks of the step.
  const char* tasks = std::getenv("SLURM_STEP_NUM_TASKS");
  return std::getenv("PMIX_RANK") != nullptr && tasks != nullptr ? std::atoi(tasks) : 1;
}

}  // namespace

#ifdef FLINCH_MPI

namespace {

class MpiMessenger : public Messenger {
 public:
  MpiMessenger() {
    // Only the main thread sends and receives.
    int provided = 0;
    MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
    MPI_Comm_size(MPI_COMM_WORLD, &size_);
    MPI_Comm local = MPI_COMM_NULL;
    MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, rank_, MPI_INFO_NULL, &local);
    MPI_Comm_size(local, &local_size_);
    MPI_Comm_free(&local);
  }
  ~MpiMessenger() override {
    if (std::uncaught_exceptions() > exceptions_) return;
    for (Outgoing& message : outgoing_) MPI_Wait(&message.request, MPI_STATUS_IGNORE);
    MPI_Finalize();
  }
  MpiMessenger(const MpiMessenger&) = delete;
  MpiMessenger& operator=(const MpiMessenger&) = delete;

  int rank() const override { return rank_; }
  int size() const override { return size_; }
  int local_size() const override { return local_size_; }

  void send(int to, std::vector<std::byte> bytes) override {
    drop_delivered();
    Outgoing& message = outgoing_.emplace_back();
    message.bytes = std::move(bytes);
    MPI_Isend(message.bytes.data(), static_cast<int>(message.bytes.size()), MPI_BYTE, to, 0,
              MPI_COMM_WORLD, &message.request);
  }

  std::optional<Message> receive() override {
    drop_delivered();
    int arrived = 0;
    MPI_Status status;
    MPI_Iprobe(MPI_ANY_SOURCE, 0, MPI_COMM_WORLD, &arrived, &status);
    if (!arrived) return std::nullopt;
    int size = 0;
    MPI_Get_count(&status, MPI_BYTE, &size);
    Message message{status.MPI_SOURCE, std::vector<std::byte>(static_cast<std::size_t>(size))};
    MPI_Recv(message.bytes.data(), size, MPI_BYTE, status.MPI_SOURCE, 0, MPI_COMM_WORLD,
             MPI_STATUS_IGNORE);
    return message;
  }

 private:
  /// A message being sent; its bytes must stay in place until it has left.
  struct Outgoing {
    std::vector<std::byte> bytes;
    MPI_Request request = MPI_REQUEST_NULL;
  };

  void drop_delivered() {
    while (!outgoing_.empty()) {
      int left = 0;
      MPI_Test(&outgoing_.front().request, &left, MPI_STATUS_IGNORE);
      if (!left) return;
      outgoing_.pop_front();
    }
  }

  int rank_ = 0;
  int size_ = 1;
  int local_size_ = 1;
  int exceptions_ = std::uncaught_exceptions();
  std::deque<Outgoing> outgoing_;
};

}  // namespace

std::unique_ptr<Messenger> make_messenger() {
  if (launched_count() > 1) return std::make_unique<MpiMessenger>();
  return std::make_unique<SingleProcessMessenger>();
}

#else

std::unique_ptr<Messenger> make_messenger() {
  if (launched_count() > 1)
    throw Error(
        "",
        "this flinch was built without MPI; install libopenmpi-dev and build flinch again, or "
        "simulate ranges (--first) and merge them");
  return std::make_unique<SingleProcessMessenger>();
}

#endif

}  // namespace flinch::train
