// SPDX-License-Identifier: MIT
#include "evolve/pain/pain.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "evolve/pain/pain_drawing.h"
#include "motion/default_character.h"
#include "motion/error.h"
#include "sim/ode/ode_simulator.h"
#include "sim/rehearsal/simulator.h"
#include "tests/scenes/error_of.h"
#include "tests/scenes/temporary_folder.h"
#include "tests/sim/random_hits.h"

namespace flinch::evolve {
namespace {

using motion::Body;

TEST(Pain, HasTheMultipliersOfFigure45) {
  const auto& multiplier = thesis_pain().multiplier;
  EXPECT_EQ(multiplier[PainRegion::palm], 1);
  EXPECT_EQ(multiplier[PainRegion::back_of_hand], 1);
  EXPECT_EQ(multiplier[PainRegion::chest], 2);
  EXPECT_EQ(multiplier[PainRegion::upper_arm], 2);
  EXPECT_EQ(multiplier[PainRegion::forearm_inside], 3);
  EXPECT_EQ(multiplier[PainRegion::forearm_outside], 3);
  EXPECT_EQ(multiplier[PainRegion::stomach], 4);
  EXPECT_EQ(multiplier[PainRegion::head], 5);
  EXPECT_EQ(multiplier[PainRegion::face], 10);
  EXPECT_EQ(multiplier[PainRegion::nose], 14);
  EXPECT_EQ(multiplier[PainRegion::eyes], 15);
}

TEST(Pain, IsTheSumOfImpulsesByTheirPlaces) {
  const motion::BodyModel bodies = make_body_model(motion::default_character());
  const std::vector<sim::PlacedImpulse> impulses{
      {Body::left_hand, true, 0.5, 3, {0, 0.1, -0.01}, {}},
      {Body::head,
       false,
       0.501,
       2,
       bodies[Body::head].shape.centre.cast<double>() + Eigen::Vector3d(-0.09, 0, 0),
       {}},
      {Body::abdomen, true, 0.502, 0.5, {0.1, 0, 0.05}, {}}};
  EXPECT_DOUBLE_EQ(pain_of(thesis_pain(), bodies, impulses), 1 * 3 + 5 * 2 + 4 * 0.5);
  EXPECT_EQ(pain_of(thesis_pain(), bodies, {}), 0);
}

// Force times step, not force: half the step gives the same pain, where equation 4.2 as printed
// would give about twice as much.
TEST(Pain, DoesNotDependOnTheContactStep) {
  const motion::Physique character = motion::default_character();
  const motion::BodyModel bodies = make_body_model(character);
  const auto motions = scenes::motions_by_rule(character.skeleton);
  const auto total = [&](double contact_step_s) {
    sim::SimulationOptions options;
    options.contact_step_s = contact_step_s;
    options.keeps_places = true;
    const sim::Simulator simulator(character, options);
    double sum = 0;
    for (const scenes::Hit& hit : scenes::random_hits(character, motions, 40, 9)) {
      const sim::Rehearsal rehearsal = simulator.rehearse(motions[hit.motion].motion, 0, 1);
      sum += pain_of(thesis_pain(), bodies, simulator.simulate(rehearsal, hit.ball).places);
    }
    return sum;
  };
  const double coarse = total(1.0 / 2000);
  EXPECT_NEAR(total(1.0 / 4000), coarse, 0.05 * coarse);
  EXPECT_GT(coarse, 0);
}

class PainFile : public testing::Test {
 protected:
  tests::TemporaryFolder folder_;
  std::string path_ = folder_ / "pain.toml";

  std::string write(const std::string& text) { return folder_.write("pain.toml", text); }
  std::string error(const std::string& text) {
    write(text);
    return tests::error_of([&] { read_pain(path_); });
  }
};

TEST_F(PainFile, ReplacesTheRegionsThatItNames) {
  const PainMap map = read_pain(write("[multipliers]\nback_of_hand = 4\neyes = 20.5\n"));
  EXPECT_EQ(map.multiplier[PainRegion::back_of_hand], 4);
  EXPECT_EQ(map.multiplier[PainRegion::eyes], 20.5);
  EXPECT_EQ(map.multiplier[PainRegion::palm], 1);
}

TEST_F(PainFile, OfTheDocumentationIsTheThesisTable) {
  std::ifstream page(FLINCH_SOURCE_DIR "/docs/evolving.md");
  const std::string text{std::istreambuf_iterator<char>(page), {}};
  const std::size_t begin = text.find("[multipliers]");
  ASSERT_NE(begin, std::string::npos);
  const PainMap map = read_pain(write(text.substr(begin, text.find("```", begin) - begin)));
  EXPECT_EQ(map.multiplier, thesis_pain().multiplier);
}

TEST_F(PainFile, IsRefusedWithItsLine) {
  EXPECT_THAT(error("[multipliers]\nhead = 5\near = 3\n"),
              testing::StartsWith(path_ + ":3: [multipliers] names a region 'ear' that does not "
                                          "exist; the regions are: eyes, nose, face, head, neck"));
  EXPECT_THAT(error("[multipliers]\nhead = -1\n"),
              testing::StrEq(path_ + ":2: [multipliers] needs a number from 0 to 1000 for head"));
  EXPECT_THAT(error("[multipliers]\nhead = 1e300\n"), testing::HasSubstr("from 0 to 1000"));
  EXPECT_THAT(error("[multipliers]\nhead = \"5\"\n"), testing::HasSubstr(":2: "));
  EXPECT_THAT(error("[multipliers]\nhead = inf\n"), testing::HasSubstr(":2: "));
  std::string nothing = "[multipliers]\n";
  for (const PainRegion region : kPainRegions) nothing += std::string(name_of(region)) + " = 0\n";
  EXPECT_THAT(error(nothing), testing::HasSubstr("only values of 0, so nothing would hurt"));
  EXPECT_THAT(error("head = 5\n"), testing::HasSubstr("unknown key \"head\""));
  EXPECT_THAT(error("multipliers = 3\n"), testing::HasSubstr("needs a table [multipliers]"));
}

TEST(PainDrawing, ShowsEveryRegionWithItsMultiplier) {
  const motion::Figure figure = motion::make_figure(motion::default_character());
  const std::string svg = pain_svg(figure, thesis_pain());
  EXPECT_TRUE(svg.starts_with(kPainDrawingMark));
  for (const char* text : {">eyes<", ">back of hand<", ">forearm inside<", ">15<", ">14<"})
    EXPECT_THAT(svg, testing::HasSubstr(text));
  // A map with another colour for the eyes draws other facets: they are on the figure.
  PainMap map = thesis_pain();
  map.multiplier[PainRegion::eyes] = 0;
  EXPECT_NE(pain_svg(figure, map), svg);
}

}  // namespace
}  // namespace flinch::evolve
