// SPDX-License-Identifier: MIT
#include "train/fit/selector_reader.h"

#include <cmath>
#include <span>
#include <vector>

#include "database/files/file_io.h"
#include "database/files/file_kind.h"
#include "database/library/library_bounds.h"
#include "database/library/text_check.h"
#include "motion/error.h"
#include "selector_generated.h"
#include "train/fit/selector_record.h"

namespace flinch::train {

runtime::SelectorFile load_selector_file(const std::string& path) {
  const std::string bytes = database::read_file(path);
  runtime::SelectorFile file;
  const database::LoadStatus status =
      runtime::read_selector_file(std::as_bytes(std::span(bytes.data(), bytes.size())), file);
  if (status == database::LoadStatus::ok) return file;
  if (database::file_kind_of(bytes) != database::FileKind::selector)
    throw Error(path, "is " + std::string(database::name_of(database::file_kind_of(bytes))) +
                          ", not a selector; `flinch train` makes one");
  throw Error(path, "the selector " +
                        database::refusal_of(status, database::kSelectorFormat, bytes) +
                        "; run `flinch train` again");
}

std::optional<SelectorRecord> read_selector_record(std::span<const std::byte> file,
                                                   const std::string& path) {
  std::vector<std::byte> storage;
  const database::VerifiedFile verified =
      database::verify_file(database::kSelectorFormat, database::aligned(file, storage));
  flatbuffers::Verifier verifier(reinterpret_cast<const std::uint8_t*>(verified.content.data()),
                                 verified.content.size());
  const Error damaged(path, kDamagedRecord);
  if (verified.status != database::LoadStatus::ok ||
      !runtime::schema::VerifySelectorBuffer(verifier))
    throw Error(damaged);
  const runtime::schema::Selector& stored = *runtime::schema::GetSelector(verified.content.data());
  const runtime::schema::Training* training = stored.training();
  if (stored.provenance() == nullptr || training == nullptr) return std::nullopt;
  const auto text = [&damaged](const flatbuffers::String* stored_text) {
    if (stored_text->size() > database::kMaxProvenanceSize ||
        !database::is_printable(stored_text->string_view()))
      throw Error(damaged);
    return stored_text->str();
  };
  SelectorRecord record;
  record.provenance = text(stored.provenance());
  record.scenarios = training->scenarios();
  record.parameters = text(training->parameters());
  record.cross_validated_regret_ns = training->cross_validated_regret_ns();
  record.idle_regret_ns = training->idle_regret_ns();
  record.distribution = text(training->distribution());
  record.simulation = text(training->simulation());
  if (!std::isfinite(record.cross_validated_regret_ns) || !std::isfinite(record.idle_regret_ns))
    throw Error(damaged);
  return record;
}

runtime::Library load_runtime_library(const std::string& path) {
  runtime::Library library;
  const database::LoadStatus status = library.load(path);
  if (status == database::LoadStatus::ok) return library;
  load_selector_file(path);  // throws what the file is instead, or what is wrong with it
  throw Error(path, std::string("the selector ") + database::message_of(status) +
                        "; run `flinch train` again");
}

}  // namespace flinch::train
