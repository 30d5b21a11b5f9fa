// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <sstream>
#include <string>

#include "models/fit/svm_fit.h"
#include "tests/models/training_sets.h"

namespace flinch::models {
namespace {

namespace fs = std::filesystem;

void write_libsvm_text(const TrainingSet& set, const fs::path& path) {
  std::ofstream file(path);
  file << std::setprecision(17);
  for (int i = 0; i < set.size(); ++i) {
    file << set.label[static_cast<std::size_t>(i)];
    int index = 0;
    for (const double value : set.point(i)) {
      ++index;
      if (value != 0) {
        file << ' ' << index << ':' << value;
      }
    }
    file << '\n';
  }
}

bool run(const std::string& command) {
  return std::system((command + " >/dev/null 2>&1").c_str()) == 0;
}

/// Rounds to multiples of 1/64: svm-train writes support vectors with eight significant digits, and
/// numbers with more would not survive its model file.
TrainingSet of_64ths(TrainingSet set) {
  for (double& value : set.points) {
    value = std::round(value * 64) / 64;
  }
  return set;
}

TEST(LibsvmTools, AgreeWithTheModel) {
  if (!run("command -v svm-train") || !run("command -v svm-predict")) {
    GTEST_SKIP() << "svm-train and svm-predict are not installed (Debian: libsvm-tools)";
  }
  const TrainingSet set = of_64ths(random_clouds(21, 600, 12, 16));
  const TrainingSet asked = of_64ths(random_clouds(22, 2000, 12, 16));
  const fs::path folder = fs::path(testing::TempDir()) / "flinch_libsvm_tools_test";
  fs::create_directories(folder);
  const std::string train = folder / "train";
  const std::string asked_for = folder / "asked";
  const std::string model_file = folder / "model";
  const std::string predicted = folder / "predicted";
  write_libsvm_text(sorted_by_label(set), train);
  write_libsvm_text(asked, asked_for);
  for (const SvmParameters& parameters :
       {default_svm_parameters(16), SvmParameters{2, 0.25, 1, 10},
        SvmParameters{.gamma = 0.5, .cost = 10, .kernel = SvmKernel::rbf}}) {
    std::ostringstream arguments;
    arguments << std::setprecision(17) << " -q -s 0 -t "
              << (parameters.kernel == SvmKernel::polynomial ? 1 : 2) << " -d " << parameters.degree
              << " -g " << parameters.gamma << " -r " << parameters.coef0 << " -c "
              << parameters.cost << ' ';
    ASSERT_TRUE(run("svm-train" + arguments.str() + train + ' ' + model_file));
    ASSERT_TRUE(run("svm-predict " + asked_for + ' ' + model_file + ' ' + predicted));
    const SvmModel model = fit_svm(set, parameters);
    std::ifstream out(predicted);
    for (int i = 0; i < asked.size(); ++i) {
      int label = -1;
      ASSERT_TRUE(out >> label) << "line " << i + 1;
      ASSERT_EQ(label, model.label[static_cast<std::size_t>(predict(model, asked.point(i)))])
          << "line " << i + 1;
    }
  }
  fs::remove_all(folder);
}

}  // namespace
}  // namespace flinch::models
