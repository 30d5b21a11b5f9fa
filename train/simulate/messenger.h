// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace flinch::train {

struct Message {
  int from = 0;
  std::vector<std::byte> bytes;
};

/// Carries messages between the processes of one run. Processes are numbered from 0. Process 0
/// writes the store. Messages from one process to another arrive in the order in which they were
/// sent.
class Messenger {
 public:
  virtual ~Messenger() = default;

  virtual int rank() const = 0;        ///< number of this process
  virtual int size() const = 0;        ///< number of processes
  virtual int local_size() const = 0;  ///< number of processes on this machine

  /// Returns at once; the message arrives when the receiver calls receive().
  virtual void send(int to, std::vector<std::byte> bytes) = 0;
  /// Returns the next message that has arrived, or nothing; returns at once.
  virtual std::optional<Message> receive() = 0;
};

/// A run of one process.
class SingleProcessMessenger : public Messenger {
 public:
  int rank() const override { return 0; }
  int size() const override { return 1; }
  int local_size() const override { return 1; }
  void send(int, std::vector<std::byte>) override {}
  std::optional<Message> receive() override { return std::nullopt; }
};

}  // namespace flinch::train
