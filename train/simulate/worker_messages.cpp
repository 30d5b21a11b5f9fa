// SPDX-License-Identifier: MIT
#include "train/simulate/worker_messages.h"

#include <cstring>
#include <type_traits>

#include "motion/error.h"

namespace flinch::train {

namespace {

class Writer {
 public:
  template <class T>
  requires std::is_trivially_copyable_v<T>
  void put(const T& value) { put(std::as_bytes(std::span(&value, 1))); }
  void put(std::span<const std::byte> block) {
    bytes_.insert(bytes_.end(), block.begin(), block.end());
  }
  void put_sized(std::span<const std::byte> block) {
    put(static_cast<std::uint32_t>(block.size()));
    put(block);
  }
  std::vector<std::byte> bytes() && { return std::move(bytes_); }

 private:
  std::vector<std::byte> bytes_;
};

class Reader {
 public:
  explicit Reader(std::span<const std::byte> bytes) : bytes_(bytes) {}

  template <class T>
  requires std::is_trivially_copyable_v<T> T take() {
    T value{};
    std::memcpy(&value, block(sizeof value).data(), sizeof value);
    return value;
  }
  std::span<const std::byte> take_sized() { return block(take<std::uint32_t>()); }
  void require_end() const {
    if (!bytes_.empty()) fail();
  }
  [[noreturn]] static void fail() {
    throw Error("",
                "the processes of this run use different message formats; run the same build of "
                "flinch everywhere");
  }

 private:
  std::span<const std::byte> block(std::size_t size) {
    if (size > bytes_.size()) fail();
    const auto front = bytes_.first(size);
    bytes_ = bytes_.subspan(size);
    return front;
  }

  std::span<const std::byte> bytes_;
};

void write(Writer& writer, const WorkRequest& ready) {
  writer.put(ready.run_hash);
  writer.put(ready.threads);
}
void write(Writer& writer, const RangeResult& done) {
  writer.put(done.range);
  writer.put(done.counts);
  writer.put(done.cpu);
  for (const auto& trials : done.trials) writer.put_sized(trials);
  for (const auto& places : done.places) writer.put_sized(places);
}
void write(Writer& writer, const WorkerFailure& failed) {
  writer.put_sized(std::as_bytes(std::span(failed.why)));
}
void write(Writer&, const WorkerStopped&) {}
void write(Writer& writer, const Assignment& assignment) {
  writer.put(assignment.range);
}

void read(Reader& reader, WorkRequest& ready) {
  ready.run_hash = reader.take<std::uint64_t>();
  ready.threads = reader.take<std::uint32_t>();
}
void read(Reader& reader, RangeResult& done) {
  done.range = reader.take<ScenarioRange>();
  done.counts = reader.take<SimulationCounts>();
  done.cpu = reader.take<PhaseTimes>();
  for (std::uint64_t i = 0; i < done.range.count; ++i) {
    const auto trials = reader.take_sized();
    done.trials.emplace_back(trials.begin(), trials.end());
  }
  for (std::uint64_t i = 0; i < done.range.count; ++i) {
    const auto places = reader.take_sized();
    done.places.emplace_back(places.begin(), places.end());
  }
}
void read(Reader& reader, WorkerFailure& failed) {
  const auto why = reader.take_sized();
  failed.why.assign(reinterpret_cast<const char*>(why.data()), why.size());
}
void read(Reader&, WorkerStopped&) {}
void read(Reader& reader, Assignment& assignment) {
  assignment.range = reader.take<ScenarioRange>();
}

template <std::size_t kind = 0>
WorkerMessage read_kind(std::size_t wanted, Reader& reader) {
  if constexpr (kind < std::variant_size_v<WorkerMessage>) {
    if (kind != wanted) return read_kind<kind + 1>(wanted, reader);
    std::variant_alternative_t<kind, WorkerMessage> message;
    read(reader, message);
    reader.require_end();
    return message;
  } else {
    Reader::fail();
  }
}

}  // namespace

std::vector<std::byte> encode(const WorkerMessage& message) {
  Writer writer;
  writer.put(static_cast<std::uint8_t>(message.index()));
  std::visit([&writer](const auto& content) { write(writer, content); }, message);
  return std::move(writer).bytes();
}

WorkerMessage decode(std::span<const std::byte> bytes) {
  Reader reader(bytes);
  return read_kind(reader.take<std::uint8_t>(), reader);
}

}  // namespace flinch::train
