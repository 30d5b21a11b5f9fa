// SPDX-License-Identifier: MIT
#include "train/realism/label_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "database/files/file_io.h"
#include "motion/error.h"

namespace flinch::train {
namespace {

using Json = nlohmann::ordered_json;

/// A kind of file, by its first line.
struct Format {
  const char* name;
  const char* kind;
  const char* maker;
};
constexpr Format kLabels{"flinch labels 1", "a label file", "`flinch label` makes one"};
constexpr Format kStudy{"flinch study 1", "a file of the test",
                        "the page of `flinch view` saves one"};

Json header_of(const database::ClipLibrary& library, const Format& format = kLabels) {
  return {{"format", format.name}, {"library", database::hash_text(library.hash)}};
}

Json components(const Eigen::Vector3f& v) {
  return {v.x(), v.y(), v.z()};
}

Json document_of(const Label& label, const database::ClipLibrary& library) {
  const PushExample& example = label.example;
  const auto name = [&](int clip) { return library.clip(clip).name; };
  return {{"judge", label.judge},
          {"sitting", label.sitting},
          {"realism", label.quality},
          {"state", name(example.state_clip)},
          {"state_s", example.state_s},
          {"place", motion::push_place_name(example.place)},
          {"asked_mps", components(example.asked)},
          {"response", name(example.answer.clip)},
          {"turn", example.answer.turn},
          {"taper", example.answer.taper},
          {"deformation_mps", components(example.answer.deformation)}};
}

std::string at_line(const std::string& path, std::size_t line) {
  return path + ":" + std::to_string(line);
}

/// What a line says. Throws nlohmann's exceptions where something is missing or of another type,
/// and std::out_of_range where a name is unknown.
class LabelReader {
 public:
  LabelReader(const database::ClipLibrary& library, const runtime::PushResponses& responses)
      : library_(library), responses_(responses) {}

  Label label(const Json& document) const {
    Label label;
    label.judge = document.at("judge").get<std::string>();
    label.sitting = document.at("sitting").get<std::string>();
    label.quality = number(document.at("realism"));
    if (!(label.quality >= 0 && label.quality <= 1)) throw std::out_of_range("realism");
    PushExample& example = label.example;
    example.state_clip = clip(document.at("state").get<std::string>());
    example.state_s = number(document.at("state_s"));
    const auto place = motion::push_place_named(document.at("place").get<std::string>());
    if (!place) throw std::out_of_range("place");
    example.place = *place;
    example.asked = vector(document.at("asked_mps"));
    example.answer.clip = clip(document.at("response").get<std::string>());
    example.answer.response = response(example.answer.clip);
    example.answer.turn = number(document.at("turn"));
    example.answer.taper = number(document.at("taper"));
    if (!(example.answer.taper > 0)) throw std::out_of_range("taper");
    example.answer.deformation = vector(document.at("deformation_mps"));
    return label;
  }

 private:
  static float number(const Json& value) {
    const auto number = value.get<float>();
    if (!std::isfinite(number)) throw std::out_of_range("number");
    return number;
  }
  static Eigen::Vector3f vector(const Json& value) {
    return {number(value.at(0)), number(value.at(1)), number(value.at(2))};
  }
  int clip(const std::string& name) const {
    const auto found = std::ranges::find(library_.clips, name, &motion::Clip::name);
    if (found == library_.clips.end()) throw std::out_of_range(name);
    return static_cast<int>(found - library_.clips.begin());
  }
  int response(int clip) const {
    const auto found = std::ranges::find(responses_.responses, clip, &runtime::PushResponse::clip);
    if (found == responses_.responses.end()) throw std::out_of_range("response");
    return static_cast<int>(found - responses_.responses.begin());
  }

  const database::ClipLibrary& library_;
  const runtime::PushResponses& responses_;
};

/// Checks the first line and that the last one is complete.
void check_text(const std::string& path, const std::string& text,
                const database::ClipLibrary& library, const Format& format = kLabels) {
  const std::string header = header_of(library, format).dump() + "\n";
  const std::size_t named = header.find(',');
  if (text.compare(0, named, header, 0, named) != 0)
    throw Error(path, std::string("is not ") + format.kind + "; " + format.maker);
  if (text.compare(0, header.size(), header) != 0) {
    throw Error(at_line(path, 1), "holds labels of another library than the one with the hash " +
                                      database::hash_text(library.hash) +
                                      "; judge that library's motions in a file of their own");
  }
  if (text.back() != '\n') {
    const auto line = static_cast<std::size_t>(std::ranges::count(text, '\n')) + 1;
    throw Error(at_line(path, line),
                "is cut short; delete this line, the labels before it are whole");
  }
}

/// A file that is open for appending and locked against other writers, until it is destroyed.
class LockedFile {
 public:
  explicit LockedFile(const std::string& path)
      : path_(path), file_(::open(path.c_str(), O_CREAT | O_APPEND | O_WRONLY | O_CLOEXEC, 0666)) {
    if (file_ < 0) fail();
    if (::flock(file_, LOCK_EX) != 0) fail();
  }
  ~LockedFile() { ::close(file_); }
  LockedFile(const LockedFile&) = delete;
  LockedFile& operator=(const LockedFile&) = delete;

  void append(const std::string& text) {
    for (std::size_t written = 0; written < text.size();) {
      const ::ssize_t count = ::write(file_, text.data() + written, text.size() - written);
      if (count < 0 && errno != EINTR) fail();
      if (count > 0) written += static_cast<std::size_t>(count);
    }
    if (::fsync(file_) != 0) fail();
  }

 private:
  [[noreturn]] void fail() const {
    const int code = errno;
    throw Error(path_, std::string("labels cannot be written: ") + std::strerror(code));
  }

  std::string path_;
  int file_;
};

}  // namespace

void append_labels(const std::string& path, const database::ClipLibrary& library,
                   const std::vector<Label>& labels) {
  LockedFile file(path);
  const std::string present = database::read_file(path);
  std::string text;
  if (present.empty()) {
    text = header_of(library).dump() + "\n";
  } else {
    check_text(path, present, library);
  }
  for (const Label& label : labels) text += document_of(label, library).dump() + "\n";
  file.append(text);
}

namespace {

/// The labels of a file. With `unanswered` counts lines without an answer, which else are refused.
LabelSet read_lines(const std::string& path, const database::ClipLibrary& library,
                    const runtime::PushResponses& responses, std::size_t* unanswered) {
  const std::string text = database::read_file(path);
  check_text(path, text, library);
  const LabelReader reader(library, responses);
  LabelSet set{library.hash, {}};
  std::istringstream lines(text);
  std::string line;
  std::getline(lines, line);
  const std::string header = line;
  for (std::size_t number = 2; std::getline(lines, line); ++number) {
    if (line == header) continue;  // files that were joined
    try {
      const Json document = Json::parse(line);
      if (unanswered != nullptr && document.at("realism").is_null()) {
        ++*unanswered;
      } else {
        set.labels.push_back(reader.label(document));
      }
    } catch (const std::exception& error) {
      throw Error(at_line(path, number),
                  std::string("is no label of this library: ") + error.what());
    }
  }
  return set;
}

}  // namespace

LabelSet read_labels(const std::string& path, const database::ClipLibrary& library,
                     const runtime::PushResponses& responses) {
  return read_lines(path, library, responses, nullptr);
}

MergedLabels merge_labels(const std::string& path, const database::ClipLibrary& library,
                          const runtime::PushResponses& responses,
                          const std::vector<std::string>& files) {
  std::set<std::string> known;
  const auto line_of = [&](const Label& label) { return document_of(label, library).dump(); };
  append_labels(path, library, {});
  for (const Label& label : read_labels(path, library, responses).labels)
    known.insert(line_of(label));
  MergedLabels merged;
  std::vector<Label> fresh;
  for (const std::string& file : files) {
    for (const Label& label : read_lines(file, library, responses, &merged.unanswered).labels) {
      if (known.insert(line_of(label)).second) {
        fresh.push_back(label);
      } else {
        ++merged.known;
      }
    }
  }
  append_labels(path, library, fresh);
  merged.added = fresh.size();
  return merged;
}

void write_questions(const std::string& path, const database::ClipLibrary& library,
                     const std::vector<Question>& questions) {
  std::string text = header_of(library).dump() + "\n";
  for (const Question& question : questions) {
    Json document = document_of({question.example, 0, "", ""}, library);
    document["realism"] = nullptr;
    document["estimate"] = question.estimate ? Json(*question.estimate) : Json();
    document["motion"] = question.motion;
    text += document.dump() + "\n";
  }
  database::write_file_atomically(path, text);
}

StudyFile read_study(const std::string& path, const database::ClipLibrary& library) {
  const std::string text = database::read_file(path);
  check_text(path, text, library, kStudy);
  StudyFile study;
  std::set<std::string> judges;
  std::istringstream lines(text);
  std::string line;
  std::getline(lines, line);
  const std::string header = line;
  for (std::size_t number = 2; std::getline(lines, line); ++number) {
    if (line == header) continue;
    try {
      const Json document = Json::parse(line);
      const auto shown =
          std::ranges::find(kShown, document.at("shown").get<std::string>(), name_of);
      if (shown == kShown.end()) throw std::out_of_range("shown");
      Verdicts& verdicts = study.table[static_cast<std::size_t>(*shown)];
      const auto answer = document.at("answer").get<std::string>();
      if (answer != "yes" && answer != "unsure" && answer != "no")
        throw std::out_of_range("answer");
      ++(answer == "yes" ? verdicts.yes : answer == "no" ? verdicts.no : verdicts.unsure);
      judges.insert(document.at("judge").get<std::string>());
    } catch (const std::exception& error) {
      throw Error(at_line(path, number), std::string("is no answer: ") + error.what());
    }
  }
  study.judges = judges.size();
  return study;
}

}  // namespace flinch::train
