// SPDX-License-Identifier: MIT
#include "database/files/library_writer.h"
#include "tests/bench/study.h"
#include "tests/runtime/push/push_scene.h"
#include "tests/scenes/synthetic_library.h"

/// Writes the synthetic library; under the name "pushes" with recoveries from pushes, under the
/// name "walks" with everyday motion, too.
int main(int count, char** arguments) {
  return flinch::bench::study_main(count, arguments, {"make_synthetic_library FILE [NAME]", 1, 2},
                                   [](const flinch::bench::StudyArguments& given) {
                                     const std::string name = given.has(1) ? given.text(1) : "";
                                     flinch::database::ClipLibrary library =
                                         name == "walks"    ? flinch::tests::library_with_walks()
                                         : name == "pushes" ? flinch::tests::library_with_pushes()
                                                            : flinch::scenes::synthetic_library();
                                     if (!name.empty()) library.name = name;
                                     flinch::database::write_library(library, given.text(0));
                                   });
}
