// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "bindings/python/arrays.h"
#include "motion/error.h"
#include "runtime/c/flinch.h"

// The run time in Python, over the C interface. Every call holds Python's lock, so the characters
// of a library can share its workspace.

namespace flinch::python {

/// An error of the run time: its text is that of the status.
class StatusError : public Error {
 public:
  explicit StatusError(flinch_status failed, const std::string& where = "")
      : Error(where, flinch_status_message(failed)), status(failed) {}
  flinch_status status;
};

/// Returns the status unless it is an error; that is thrown.
inline flinch_status checked(flinch_status status) {
  if (status < 0) throw StatusError(status);
  return status;
}

/// Returns a struct of the C interface that has its size and is otherwise 0.
template <class Struct>
Struct sized() {
  Struct made{};
  made.size = sizeof made;
  return made;
}

/// A loaded library and the memory that its characters take turns with.
class Library {
 public:
  /// Throws Error with the program's own text for a file that cannot be used.
  static std::shared_ptr<Library> load(const std::filesystem::path& path);
  static std::shared_ptr<Library> from_bytes(const pybind11::bytes& bytes);
  /// Of the bytes of a library's file, which has clips and no selector.
  static std::shared_ptr<Library> take(const pybind11::bytes& bytes);
  static std::shared_ptr<Library> load_beside(const pybind11::bytes& bytes, const Library& owner);

  flinch_library* get() const { return handle_.get(); }
  flinch_workspace* workspace() const { return workspace_.get(); }
  /// Makes it at the first call.
  flinch_look_ahead* look_ahead();
  flinch_library_info info() const;

 private:
  explicit Library(flinch_library* loaded);

  std::shared_ptr<flinch_library> handle_;
  std::shared_ptr<flinch_workspace> workspace_;
  std::shared_ptr<flinch_look_ahead> look_ahead_;
};

/// What a library's everyday clips can follow each other by.
struct MotionGraph {
  explicit MotionGraph(const Library& library);

  std::shared_ptr<flinch_motion_graph> handle;
};

/// How a character takes a hit; what is not given is as usual.
struct HitOptions {
  std::optional<float> simulation_only_s;
  std::optional<float> stiffness;
};

/// A character of a library, which it keeps alive.
struct Character {
  /// Throws ValueError for options of hits that it does not take.
  Character(std::shared_ptr<Library> of, bool reacting, const HitOptions& hits = {});
  flinch_character* get() const { return handle.get(); }

  std::shared_ptr<Library> library;
  std::shared_ptr<flinch_character> handle;
};

/// A pose, as Python sees it.
struct Pose {
  flinch_pose value = sized<flinch_pose>();
};

/// Something that approaches, as Python sees it.
struct Threat {
  flinch_threat value = sized<flinch_threat>();
};

/// A threat that a character has noticed, as Python sees it.
struct Perception {
  Perception() { value.threat.size = sizeof value.threat; }
  flinch_perception value = sized<flinch_perception>();
};

/// "ok", "misses", "unnoticed", "outside_training" or "no_good_answer". Throws for an error.
std::string answer_of(flinch_status status);

/// The target's number. Throws ValueError for another name.
std::int32_t target_numbered(const std::string& name);
/// The joint's number. Throws ValueError for another name.
std::int32_t joint_numbered(const std::string& name);

void bind_library(pybind11::module_& module);
void bind_values(pybind11::module_& module);
/// The candidates as a list of dictionaries.
pybind11::list candidate_list(const flinch_candidate* candidates, std::int32_t count);

using CharacterClass = pybind11::class_<Character, std::shared_ptr<Character>>;
void bind_character(pybind11::module_& module);
/// The steps of perceiving.
void bind_perception(pybind11::module_& module);
void bind_steps(CharacterClass& character);
void bind_crowd(pybind11::module_& module);

}  // namespace flinch::python
