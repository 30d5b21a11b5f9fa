// SPDX-License-Identifier: MIT
#pragma once

#include <deque>
#include <mutex>
#include <utility>
#include <vector>

#include "train/simulate/messenger.h"

namespace flinch::train {

/// Carries messages between threads that represent the processes of a run.
class LocalExchange {
 public:
  explicit LocalExchange(int size) : boxes_(static_cast<std::size_t>(size)) {}

  void put(int to, Message message) {
    const std::lock_guard lock(mutex_);
    boxes_[static_cast<std::size_t>(to)].push_back(std::move(message));
  }
  std::optional<Message> take(int rank) {
    const std::lock_guard lock(mutex_);
    std::deque<Message>& box = boxes_[static_cast<std::size_t>(rank)];
    if (box.empty()) return std::nullopt;
    Message message = std::move(box.front());
    box.pop_front();
    return message;
  }
  int size() const { return static_cast<int>(boxes_.size()); }

 private:
  std::mutex mutex_;
  std::vector<std::deque<Message>> boxes_;
};

class LocalMessenger : public Messenger {
 public:
  LocalMessenger(LocalExchange& exchange, int rank) : exchange_(exchange), rank_(rank) {}

  int rank() const override { return rank_; }
  int size() const override { return exchange_.size(); }
  int local_size() const override { return exchange_.size(); }
  void send(int to, std::vector<std::byte> bytes) override {
    exchange_.put(to, {rank_, std::move(bytes)});
  }
  std::optional<Message> receive() override { return exchange_.take(rank_); }

 private:
  LocalExchange& exchange_;
  int rank_;
};

}  // namespace flinch::train
