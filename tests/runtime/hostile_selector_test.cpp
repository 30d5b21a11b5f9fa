// SPDX-License-Identifier: MIT
// Selector files as an attacker would make them: the schema's verification and the content hash
// pass.
#include <gtest/gtest.h>

#include "database/library/library_bounds.h"
#include "runtime/selector_file.h"
#include "selector_generated.h"
#include "tests/runtime/made_up_selector.h"
#include "tests/runtime/selector_samples.h"
#include "tests/scenes/file_damage.h"
#include "tests/scenes/guard.h"
#include "tests/scenes/read_cost.h"

namespace flinch::runtime {
namespace {

using database::LoadStatus;
using flatbuffers::FlatBufferBuilder;
using flatbuffers::Offset;

/// What a file's vectors have in common: each kind is stored once and referred to everywhere.
struct SharedParts {
  std::size_t clip_count = 1;
  std::size_t feature_count = 1;
  std::size_t name_size = 1;
  std::size_t number_count = 1;  ///< of each vector of the model
  std::size_t stance_count = 0;  ///< from which the file has the work of responses
  std::size_t work_count = 1;    ///< numbers in each of these
};

std::string with_shared_parts(const SharedParts& parts) {
  FlatBufferBuilder builder;
  const auto name = builder.CreateString(std::string(parts.name_size, 'a'));
  const auto clip = schema::CreateClip(builder, name);
  const auto clips =
      builder.CreateVector(std::vector<Offset<schema::Clip>>(parts.clip_count, clip));
  const auto features =
      builder.CreateVector(std::vector<Offset<flatbuffers::String>>(parts.feature_count, name));
  // Eight vectors of the model share these zeros.
  const Offset<void> zeros =
      builder.CreateVector(std::vector<double>(parts.number_count, 0.0)).Union();
  const auto as = [&zeros](auto number) {
    return Offset<flatbuffers::Vector<decltype(number)>>(zeros.o);
  };
  const auto centres = builder.CreateVector(std::vector<float>(12, 0.0F));
  const auto model = schema::CreateSvm(builder, 0, 3, 1, 0, 1, as(std::int32_t{}),
                                       as(std::int32_t{}), as(double{}), as(float{}), as(double{}),
                                       as(std::uint16_t{}), as(std::uint16_t{}), as(double{}));
  Offset<schema::ResponseCosts> costs;
  if (parts.stance_count > 0) {
    const auto work = builder.CreateVector(std::vector<float>(parts.work_count, 0.0F));
    const auto from = schema::CreateStanceWork(builder, 1, 1, work);
    const auto of_stance =
        builder.CreateVector(std::vector<Offset<schema::StanceWork>>(parts.stance_count, from));
    costs = schema::CreateResponseCosts(builder, as(double{}), 1, 1, as(float{}), 1, 1, 0, 1, 0, 0,
                                        0, of_stance);
  }
  schema::FinishSelectorBuffer(
      builder, schema::CreateSelector(builder, 1, clips, 0, features, as(double{}), as(double{}),
                                      0.1, centres, schema::Model::Svm, model.Union(), 0, costs));
  return tests::with_header(
      database::kSelectorFormat,
      std::string(reinterpret_cast<const char*>(builder.GetBufferPointer()), builder.GetSize()));
}

void expect_refused_cheaply(const std::string& file) {
  SelectorFile read;
  const tests::ReadCost cost;
  EXPECT_EQ(read_selector_file(database::bytes_of(file), read), LoadStatus::damaged);
  cost.expect_below(tests::ReadCost::allowance(file.size()));
}

TEST(HostileSelector, ThatUnfoldsToGigabytesIsRefusedBeforeItIsCopied) {
  expect_refused_cheaply(with_shared_parts({.clip_count = 9'000, .name_size = 760'000}));
  expect_refused_cheaply(with_shared_parts({.feature_count = 90'000, .name_size = 400'000}));
  expect_refused_cheaply(with_shared_parts({.clip_count = 190'000}));
  expect_refused_cheaply(with_shared_parts({.number_count = 8'000'000}));
  expect_refused_cheaply(
      with_shared_parts({.clip_count = 9'000, .stance_count = 9'000, .work_count = 1'000'000}));
  expect_refused_cheaply(with_shared_parts({.stance_count = 1'000'000}));
}

void expect_refused(const std::function<void(models::Selector&)>& break_it) {
  models::Selector selector = tests::knn_selector();
  ASSERT_TRUE(is_sound(selector));
  break_it(selector);
  EXPECT_FALSE(is_sound(selector));
}

TEST(SelectorBounds, HoldForNumbersAndTexts) {
  expect_refused([](models::Selector& s) { s.clips[1].name = "a\nb"; });
  expect_refused([](models::Selector& s) { s.clips[1].name = "\xFF"; });
  expect_refused([](models::Selector& s) { s.clips[1].name.clear(); });
  expect_refused([](models::Selector& s) { s.clips[1].name.assign(256, 'a'); });
  expect_refused([](models::Selector& s) { s.clips.resize(10'001, s.clips[0]); });
  expect_refused([](models::Selector& s) { s.clips[1].annotation->end_s = 1.1e6F; });
  expect_refused([](models::Selector& s) { s.clips[1].annotation->onset_s = -1; });
  expect_refused([](models::Selector& s) { s.clips[1].annotation->peak_s = 1.0F / 3; });
  expect_refused([](models::Selector& s) { s.clips[1].annotation->direction = 0.1F; });
  expect_refused([](models::Selector& s) { s.scaling.max[2] = 1e300; });
  expect_refused([](models::Selector& s) { s.scaling.min[2] = -1e300; });
  expect_refused([](models::Selector& s) { s.target_centres.values[2].y() = 1001; });
}

TEST(SelectorBounds, KeepOutWorkFromStancesThatTheLibraryDoesNotHave) {
  tests::MadeUpSelector made = with_response_costs(tests::made_up_selector(
      tests::with_guard(scenes::synthetic_library()), 30, tests::ModelKind::knn));
  made.selector.costs->of_stance.push_back({1, made.selector.costs->work_j, 1});
  EXPECT_NO_THROW(made.file());
  made.selector.costs->of_stance[0].stance = 2;
  EXPECT_ANY_THROW(made.file()) << "a file that cannot be read is not written";
}

TEST(SelectorBounds, KeepOneFarRootOutOfAnEmbeddedLibrary) {
  tests::MadeUpSelector made =
      tests::made_up_selector(scenes::synthetic_library(), 30, tests::ModelKind::knn);
  // The largest float for one coordinate of one pose: finite, and the blends of it are not.
  const float wanted = 0.4F;  // how far step_aside goes to the right
  std::string content = tests::content_of(made.library_file);
  const float far = std::numeric_limits<float>::max();
  const float from = -wanted;
  const std::string bytes(reinterpret_cast<const char*>(&from), sizeof from);
  const std::size_t place = content.find(bytes);
  ASSERT_NE(place, std::string::npos);
  content.replace(place, sizeof far, reinterpret_cast<const char*>(&far), sizeof far);
  made.library_file = tests::with_header(database::kLibraryFormat, content);
  made.selector.library_hash =
      database::verify_file(database::kLibraryFormat, made.library_bytes()).hash;
  EXPECT_ANY_THROW(made.file()) << "a file that cannot be read is not written";
}

}  // namespace
}  // namespace flinch::runtime
