// SPDX-License-Identifier: MIT
#include "database/author/authored_library.h"
#include "database/files/library_writer.h"
#include "motion/default_character.h"
#include "tests/bench/study.h"
#include "tests/runtime/push/push_scene.h"
#include "tests/scenes/synthetic_library.h"
#include "tests/scenes/walk.h"

namespace {

flinch::database::ClipLibrary library_named(const std::string& name) {
  using namespace flinch;
  if (name == "walks") return tests::library_with_walks();
  if (name == "pushes") return tests::library_with_pushes();
  if (name == "walker")
    return tests::with_walk(database::authored_library(motion::default_character()));
  return scenes::synthetic_library();
}

}  // namespace

/// Writes the synthetic library; under the name "pushes" with recoveries from pushes, under the
/// name "walks" with everyday motion, too. Under the name "walker", the authored one with a walk.
int main(int count, char** arguments) {
  return flinch::bench::study_main(count, arguments, {"make_synthetic_library FILE [NAME]", 1, 2},
                                   [](const flinch::bench::StudyArguments& given) {
                                     const std::string name = given.has(1) ? given.text(1) : "";
                                     flinch::database::ClipLibrary library = library_named(name);
                                     if (!name.empty()) library.name = name;
                                     flinch::database::write_library(library, given.text(0));
                                   });
}
