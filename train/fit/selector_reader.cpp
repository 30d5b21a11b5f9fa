// SPDX-License-Identifier: MIT
#include "train/fit/selector_reader.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "database/files/file_io.h"
#include "database/files/file_kind.h"
#include "database/library/library_bounds.h"
#include "database/library/library_file.h"
#include "database/library/text_check.h"
#include "motion/error.h"
#include "selector_generated.h"
#include "train/fit/selector_record.h"

namespace flinch::train {

namespace fs = std::filesystem;

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

namespace {

/// The library of that hash in a folder, if one of its .flinchlib files is it.
std::optional<database::ClipLibrary> library_in(const fs::path& folder, std::uint64_t hash) {
  std::vector<std::string> files;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error))
    if (entry.path().extension() == ".flinchlib") files.push_back(entry.path().string());
  std::ranges::sort(files);
  for (const std::string& file : files) {
    database::ClipLibrary library;
    if (database::read_library(file, library) == database::LoadStatus::ok && library.hash == hash)
      return library;
  }
  return std::nullopt;
}

runtime::Library library_of_bare_selector(const std::string& path) {
  const std::uint64_t hash = load_selector_file(path).selector.library_hash;
  std::optional<database::ClipLibrary> clips = library_in(fs::absolute(path).parent_path(), hash);
  if (!clips)
    throw Error(path,
                "the selector has no clips, and no .flinchlib file beside it is its library " +
                    database::hash_text(hash) + "; put that library into the same folder");
  runtime::Library owner;
  runtime::Library library;
  database::LoadStatus status = owner.take(std::move(*clips));
  if (status == database::LoadStatus::ok) status = library.load(path, owner);
  if (status != database::LoadStatus::ok)
    throw Error(path, std::string("the selector ") + database::message_of(status));
  return library;
}

}  // namespace

runtime::Library load_runtime_library(const std::string& path) {
  runtime::Library library;
  const database::LoadStatus status = library.load(path);
  if (status == database::LoadStatus::ok) return library;
  if (status == database::LoadStatus::without_clips) return library_of_bare_selector(path);
  load_selector_file(path);  // throws what the file is instead, or what is wrong with it
  throw Error(path, std::string("the selector ") + database::message_of(status) +
                        "; run `flinch train` again");
}

}  // namespace flinch::train
