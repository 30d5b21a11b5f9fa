// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

#include "tests/train/made_up_store.h"
#include "train/export.h"
#include "train/training.h"

namespace flinch::train {
namespace {

bool succeeds(const std::string& command) {
  return std::system(command.c_str()) == 0;
}

TEST(LibsvmExport, SvmTrainAndSvmPredictAgreeWithTheSelectorsSvm) {
  if (!succeeds("command -v svm-train svm-predict > /dev/null")) {
    GTEST_SKIP() << "libsvm's programs are not installed (libsvm-tools)";
  }
  const TemporaryFolder folder;
  const StoreHeader header = made_up_header();
  const std::vector<Observation> observations = made_up_observations(header, 0, 150);
  const CostModel cost_model =
      make_cost_model(header, vulnerability_profiles()[0].vulnerability, 0.1);
  const Training training = train_selector(header, observations, cost_model, Method::svm, 1);
  const auto& svm = std::get<models::SvmModel>(training.selector.model);

  std::ofstream(folder / "data") << libsvm_text(observations, label(observations, cost_model));
  std::ostringstream train;
  train << "svm-train -q -t 1 -d " << svm.degree << " -g " << exact(svm.gamma) << " -r "
        << exact(svm.coef0) << " -c " << exact(svm.cost) << ' ' << (folder / "data") << ' '
        << (folder / "model");
  ASSERT_TRUE(succeeds(train.str()));
  ASSERT_TRUE(succeeds("svm-predict " + (folder / "data") + " " + (folder / "model") + " " +
                       (folder / "predicted") + " > /dev/null"));

  std::ifstream predicted(folder / "predicted");
  std::vector<double> scaled(features::kFeatureCount);
  int compared = 0;
  for (int clip = -1; predicted >> clip; ++compared) {
    training.selector.scaling.apply(observations[static_cast<std::size_t>(compared)].features,
                                    scaled);
    const int chosen = svm.label[static_cast<std::size_t>(models::predict(svm, scaled))];
    EXPECT_EQ(chosen, clip) << "scenario " << compared;
  }
  EXPECT_EQ(compared, 150);
  EXPECT_GT(svm.class_count(), 3);
}

}  // namespace
}  // namespace flinch::train
