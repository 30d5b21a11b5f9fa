// SPDX-License-Identifier: MIT
#include "train/simulate/crew.h"

#include <chrono>
#include <exception>
#include <thread>

#include "motion/error.h"

namespace flinch::train {

namespace {

constexpr int kWriter = 0;
/// How long one who has nothing to do sleeps between looks: nothing beside a range's second, and
/// it leaves the processor to who can use it.
constexpr std::chrono::milliseconds kPause(1);

ScenarioRange next_assignment(Messenger& messenger) {
  for (;;) {
    if (const auto message = messenger.receive())
      return std::get<Assignment>(decode(message->bytes)).range;
    std::this_thread::sleep_for(kPause);
  }
}

template <class... Cases>
struct Overloaded : Cases... {
  using Cases::operator()...;
};
template <class... Cases>
Overloaded(Cases...) -> Overloaded<Cases...>;

}  // namespace

Crew::Crew(Messenger& messenger, Work work, std::uint64_t run_hash)
    : messenger_(messenger),
      work_(std::move(work)),
      run_hash_(run_hash),
      helpers_(static_cast<std::size_t>(messenger.size())),
      at_work_(messenger.size() - 1) {}

void Crew::attend() {
  while (const auto message = messenger_.receive()) answer(message->from, decode(message->bytes));
}

void Crew::wait() const {
  std::this_thread::sleep_for(kPause);
}

void Crew::assign(int number) {
  Helper& helper = helpers_[static_cast<std::size_t>(number)];
  const auto range = work_.next(helper.threads);
  if (!range) --at_work_;
  helper.range = range.value_or(ScenarioRange{});
  messenger_.send(number, encode(Assignment{helper.range}));
}

void Crew::answer(int number, const CrewMessage& message) {
  Helper& helper = helpers_[static_cast<std::size_t>(number)];
  const std::string name = "process " + std::to_string(number);
  const auto ready = [&](const Ready& it) {
    if (it.run_hash != run_hash_)
      throw Error("", name +
                          " simulates another library or distribution; give all the same files and "
                          "the same build");
    helper.threads = static_cast<int>(it.threads);
    assign(number);
  };
  const auto done = [&](const Done& it) {
    work_.take(it);
    assign(number);
  };
  const auto failed = [&](const Failed& it) { throw Error("", name + ": " + it.why); };
  const auto stopped = [&](const Stopped&) {
    work_.take_back(helper.range);
    --at_work_;
  };
  const auto assigned = [&](const Assignment&) { throw Error("", name + " gives orders"); };
  std::visit(Overloaded{ready, done, failed, stopped, assigned}, message);
}

void help(Messenger& messenger, std::uint64_t run_hash, int threads,
          const std::function<std::optional<Done>(ScenarioRange)>& simulate) {
  messenger.send(kWriter, encode(Ready{run_hash, static_cast<std::uint32_t>(threads)}));
  for (ScenarioRange range = next_assignment(messenger); range.count > 0;
       range = next_assignment(messenger)) {
    std::optional<Done> done;
    try {
      done = simulate(range);
    } catch (const std::exception& error) {
      messenger.send(kWriter, encode(Failed{error.what()}));
      return;
    }
    if (!done) {
      messenger.send(kWriter, encode(Stopped{}));
      return;
    }
    messenger.send(kWriter, encode(*done));
  }
}

void tell_failure(Messenger& messenger, const std::string& why) {
  messenger.send(kWriter, encode(Failed{why}));
}

}  // namespace flinch::train
