// SPDX-License-Identifier: MIT
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>

#include "database/author/authored_library.h"
#include "database/author/character_toml.h"
#include "database/export/filmstrip.h"
#include "database/files/file_io.h"
#include "database/files/library_writer.h"
#include "motion/default_character.h"
#include "motion/error.h"
#include "program/command.h"
#include "program/printable.h"

namespace flinch::program {

namespace {

struct AuthorOptions {
  std::string library;
  std::optional<std::string> character;
  std::optional<std::string> gallery;
  bool startle = false;
  bool force = false;
  bool json = false;
};

motion::Physique character_of(const AuthorOptions& options) {
  if (!options.character) return motion::default_character();
  return database::find_character(*options.character);
}

/// The first words of a gallery's README.md.
constexpr std::string_view kGalleryTitle = "# The authored library";

/// Mirror images show nothing new.
bool is_drawn(const motion::Clip& clip) {
  return clip.mirrored_from.empty();
}

void draw_gallery(const database::ClipLibrary& library, const std::string& folder) {
  create_folder(folder);
  const motion::Figure figure = motion::make_figure(library.character);
  std::string index = std::string(kGalleryTitle) + "\n\nOne filmstrip per clip, of the " +
                      std::to_string(library.clips.size()) +
                      " that `flinch author` makes; mirror images are left out. Upper row from the"
                      " right, lower row from the front; the threat comes along the arrow, or out"
                      " of the page at the circle. Drawn by `scripts/gallery`.\n";
  for (const motion::Clip& clip : library.clips) {
    if (!is_drawn(clip)) continue;
    const std::string file = clip.name + ".svg";
    database::write_file_atomically((std::filesystem::path(folder) / file).string(),
                                    database::filmstrip_svg(figure, clip));
    index += "\n## " + clip.name + "\n\n![" + clip.name + "](" + file + ")\n";
  }
  database::write_file_atomically((std::filesystem::path(folder) / "README.md").string(), index);
}

/// Checks the outputs, of which the gallery's are known only once the library is.
void check_outputs(const AuthorOptions& options, const database::ClipLibrary* library) {
  using database::FileKind;
  const std::vector<std::string> inputs{options.character.value_or("")};
  const database::Overwrite overwrite = overwrite_of(options.force);
  database::check_outputs({{options.library, FileKind::library, ""}}, inputs, overwrite);
  if (!options.gallery) return;
  std::vector<database::Output> files{{"README.md", FileKind::text, kGalleryTitle}};
  if (library != nullptr) {
    for (const motion::Clip& clip : library->clips)
      if (is_drawn(clip))
        files.push_back({clip.name + ".svg", FileKind::text, database::kFilmstripMark});
  }
  database::check_output_folder(*options.gallery, files, inputs, overwrite);
}

void run_author(const AuthorOptions& options) {
  check_outputs(options, nullptr);
  database::ClipLibrary library =
      database::authored_library(character_of(options), options.startle);
  check_outputs(options, &library);
  library.provenance = database::authored_provenance(options.character, options.startle);
  library.hash = database::write_library(library, options.library);
  if (options.gallery) draw_gallery(library, *options.gallery);
  const std::string idle = library.idle_clip().name;
  if (options.json) {
    print({{"kind", "library"},
           {"file", options.library},
           {"name", library.name},
           {"hash", database::hash_text(library.hash)},
           {"clip_count", library.clips.size()},
           {"rate_hz", library.rate_hz},
           {"idle", idle}});
    return;
  }
  std::cout << printable(options.library) << ": library " << printable(library.name) << ", "
            << database::hash_text(library.hash) << ", " << library.clips.size() << " clips at "
            << library.rate_hz << " Hz, idle " << printable(idle) << '\n';
}

}  // namespace

Command author_command() {
  auto options = std::make_shared<AuthorOptions>();
  return {
      .name = "author",
      .summary = "Make the default library by rule, without motion capture",
      .required = {{"--out", "library file to write", &options->library}},
      .optional = {{"--character",
                    "TOML file with height_m, mass_kg, sex and [proportions], or a library "
                    "whose character to use (default: a man of 1.75 m and 75 kg); waist_up_man: "
                    "the proportions of Rose (2006), appendix A",
                    &options->character},
                   {"--startle", "start blocking clips with a flinch", &options->startle},
                   {"--gallery", "folder for filmstrips of all clips", &options->gallery},
                   force_option(options->force),
                   json_option(options->json)},
      .notes = "Example:\n  flinch author --out default.flinchlib",
      .run = [options] { run_author(*options); }};
}

}  // namespace flinch::program
