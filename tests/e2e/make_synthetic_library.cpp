// SPDX-License-Identifier: MIT
#include <exception>
#include <iostream>

#include "database/import/library_writer.h"
#include "tests/scenes/synthetic_library.h"

/// Writes the synthetic library: `make_synthetic_library FILE [NAME]`.
int main(int argument_count, char** arguments) {
  if (argument_count < 2) return 2;
  try {
    flinch::database::ClipLibrary library = flinch::scenes::synthetic_library();
    if (argument_count > 2) library.name = arguments[2];
    flinch::database::write_library(library, arguments[1]);
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
  return 0;
}
