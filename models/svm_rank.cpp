// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>

#include "models/svm.h"
#include "models/svm_kernel.h"

namespace flinch::models {
namespace {

/// The allowed classes play each other. Positions are those among the allowed ones, large classes
/// first: who is often right is found early, and then knocks out the others by games that it has to
/// play anyhow.
class Tournament {
 public:
  Tournament(const SvmModel& model, std::span<const double> scaled, std::span<const char> allowed,
             Memory memory)
      : model_(model),
        scaled_(scaled),
        kernel_(model, scaled, memory),
        classes_(memory),
        losses_(memory),
        played_(memory) {
    classes_.reserve(allowed.size());
    for (const std::size_t c : model.by_size) {
      if (allowed[c]) classes_.push_back(c);
    }
    losses_.resize(count());
    played_.resize(count() * count());
  }

  std::size_t count() const { return classes_.size(); }

  void play_all() {
    for (std::size_t a = 0; a < count(); ++a) play_rest_of(a, count());
  }

  /// Knocks out one after the other, so that all but one have lost before any is looked at twice.
  void play_knock_out() {
    std::size_t champion = 0;
    for (std::size_t next = 1; next < count(); ++next) {
      if (!play(champion, next)) champion = next;
    }
  }

  /// Plays until it knows who comes next after those that it gave before.
  RankedClass next() {
    for (;;) {
      const auto [best, runner_up] = leaders();
      if (play_rest_of(best, runner_up)) {
        const int votes = static_cast<int>(count()) - 1 - losses_[best];
        losses_[best] += kTaken;
        return {classes_[best], votes};
      }
    }
  }

 private:
  static constexpr int kTaken = 1 << 20;  // more than there can be losses

  /// Fewest losses so far, then the lower class. Losses only grow, so that nobody else gets before
  /// a class that has played all its games and is still the best.
  bool is_before(std::size_t a, std::size_t b) const {
    return b == count() || losses_[a] < losses_[b] ||
           (losses_[a] == losses_[b] && classes_[a] < classes_[b]);
  }

  /// The best two, count() where there is none.
  std::array<std::size_t, 2> leaders() const {
    std::size_t best = count();
    std::size_t second = count();
    for (std::size_t position = 0; position < count(); ++position) {
      if (is_before(position, best)) {
        second = best;
        best = position;
      } else if (is_before(position, second)) {
        second = position;
      }
    }
    return {best, second};
  }

  /// Plays what a class has not played yet, until it comes after where `rival` stands now (who may
  /// fall behind others meanwhile); whether it never does.
  bool play_rest_of(std::size_t one, std::size_t rival) {
    const bool yields = rival != count() && classes_[rival] < classes_[one];  // to an equal
    const int limit = rival == count() ? kTaken : losses_[rival];
    for (std::size_t other = 0; other < count(); ++other) {
      if (other == one || played_[one * count() + other]) continue;
      play(one, other);
      if (losses_[one] > limit || (losses_[one] == limit && yields)) return false;
    }
    return true;
  }

  /// Whether a wins against b.
  bool play(std::size_t a, std::size_t b) {
    const bool wins = classes_[a] < classes_[b] ? is_first_preferred(classes_[a], classes_[b])
                                                : !is_first_preferred(classes_[b], classes_[a]);
    ++losses_[wins ? b : a];
    played_[a * count() + b] = played_[b * count() + a] = 1;
    return wins;
  }

  /// sum of a K over one side's vectors, the free ones first; moves on to the other side's.
  double side(std::size_t one, std::uint16_t free_count, std::uint16_t bound_count,
              const std::uint16_t*& vector, const double*& coefficient) {
    const std::size_t vectors = std::size_t{free_count} + bound_count;
    const float* kernel = kernel_.values(one, {vector, vectors});
    std::array<double, 2> free{};
    std::array<double, 2> bound{};
    int k = 0;
    for (; k + 1 < free_count; k += 2) {
      free[0] += coefficient[k] * double{kernel[vector[k]]};
      free[1] += coefficient[k + 1] * double{kernel[vector[k + 1]]};
    }
    if (k < free_count) free[0] += coefficient[k] * double{kernel[vector[k]]};
    vector += free_count;
    coefficient += free_count;
    for (k = 0; k + 1 < bound_count; k += 2) {
      bound[0] += double{kernel[vector[k]]};
      bound[1] += double{kernel[vector[k + 1]]};
    }
    if (k < bound_count) bound[0] += double{kernel[vector[k]]};
    vector += bound_count;
    return free[0] + free[1] + model_.bound[one] * (bound[0] + bound[1]);
  }

  bool is_first_preferred(std::size_t i, std::size_t j) {
    const SvmMachine& machine = model_.machines[model_.machine_of(i, j)];
    const std::uint16_t* vector = model_.vectors.data() + machine.first_vector;
    const double* coefficient = model_.coefficients.data() + machine.first_coefficient;
    const double first = side(i, machine.count[0], machine.count[1], vector, coefficient);
    const double second = side(j, machine.count[2], machine.count[3], vector, coefficient);
    const double value = first - second - machine.rho;
    // Not a number is beyond no bound either.
    if (std::abs(value) > machine.weight * kernel_.error()) return value > 0;
    return decision(model_, scaled_, i, j) > 0;
  }

  const SvmModel& model_;
  std::span<const double> scaled_;
  LazyKernel kernel_;
  std::pmr::vector<std::size_t> classes_;  ///< by position
  std::pmr::vector<int> losses_;           ///< by position
  std::pmr::vector<char> played_;          ///< count() rows of one a position
};

}  // namespace

std::pmr::vector<RankedClass> rank(const SvmModel& model, std::span<const double> scaled,
                                   std::span<const char> allowed, std::size_t most, Memory memory) {
  Tournament tournament(model, scaled, allowed, memory);
  std::pmr::vector<RankedClass> ranked(memory);
  ranked.reserve(tournament.count());
  const std::size_t count = std::min(most, tournament.count());
  if (count == tournament.count()) {
    tournament.play_all();
  } else {
    tournament.play_knock_out();
  }
  while (ranked.size() < count) {
    ranked.push_back(tournament.next());
  }
  return ranked;
}

}  // namespace flinch::models
