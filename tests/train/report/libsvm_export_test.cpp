// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

#include "tests/train/evaluate/comparison.h"
#include "train/fit/training.h"
#include "train/report/csv.h"
#include "train/report/export.h"

namespace flinch::train {
namespace {

bool succeeds(const std::string& command) {
  return std::system(command.c_str()) == 0;
}

std::string svm_train_options(const models::SvmModel& svm) {
  std::ostringstream options;
  options << " -q -t 1 -d " << svm.degree << " -g " << exact_text(svm.gamma) << " -r "
          << exact_text(svm.coef0) << " -c " << exact_text(svm.cost) << ' ';
  return options.str();
}

// Fitted to one store and tested on another, from the exported files alone.
TEST(LibsvmExport, LibsvmToolsChooseAsTheSelectorDoes) {
  if (!succeeds("command -v svm-train svm-predict > /dev/null")) {
    GTEST_SKIP() << "libsvm's programs are not installed (libsvm-tools)";
  }
  const TemporaryFolder folder;
  for (const features::FeatureSet& set : features::feature_sets()) {
    Store store = made_up_store(150);
    Store test = made_up_store(100, 6);
    derive_features(set.layout, store);
    derive_features(set.layout, test);
    const CostModel cost_model = default_cost(store.header);
    const Training training =
        train_selector(store.header, store.observations, cost_model, Method::svm, 1);
    const auto& svm = std::get<models::SvmModel>(training.selector.model);
    const features::Scaling scaling = scaling_of(store.header, store.observations);
    folder.write("train", libsvm_text(store, label(store.observations, cost_model), scaling));
    folder.write("test", libsvm_text(test, label(test.observations, cost_model), scaling));
    ASSERT_TRUE(succeeds("sort -s -n -k 1,1 " + (folder / "train") + " -o " + (folder / "sorted")));
    ASSERT_TRUE(succeeds("svm-train" + svm_train_options(svm) + (folder / "sorted") + ' ' +
                         (folder / "model")));
    ASSERT_TRUE(succeeds("svm-predict " + (folder / "test") + " " + (folder / "model") + " " +
                         (folder / "predicted") + " > /dev/null"));
    std::ifstream predicted(folder / "predicted");
    std::vector<double> scaled(static_cast<std::size_t>(set.layout.size()));
    std::size_t compared = 0;
    for (int clip = -1; predicted >> clip; ++compared) {
      training.selector.scaling.apply(test.observations[compared].features, scaled);
      const int chosen = svm.label[static_cast<std::size_t>(models::predict(svm, scaled))];
      EXPECT_EQ(chosen, clip) << set.name << ", scenario " << compared;
    }
    EXPECT_EQ(compared, 100U);
    EXPECT_GT(svm.class_count(), 3);
  }
}

}  // namespace
}  // namespace flinch::train
