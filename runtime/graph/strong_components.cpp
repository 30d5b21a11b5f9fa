// SPDX-License-Identifier: MIT
#include "runtime/graph/strong_components.h"

#include <algorithm>
#include <limits>

namespace flinch::runtime {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

/// The state of Tarjan's search.
class Search {
 public:
  explicit Search(const Successors& successors)
      : successors_(successors),
        order_(successors.size(), kNone),
        lowest_(successors.size(), 0),
        component_(successors.size(), kNone) {}

  std::vector<std::uint32_t> components() {
    for (std::uint32_t root = 0; root < successors_.size(); ++root) {
      if (order_[root] == kNone) search_from(root);
    }
    return std::move(component_);
  }

 private:
  /// A node whose successors are being visited, and how many of them have been.
  struct Visit {
    std::uint32_t node;
    std::size_t next = 0;
  };

  void open(std::uint32_t node) {
    order_[node] = lowest_[node] = opened_++;
    open_.push_back(node);
    path_.push_back({node});
  }

  void search_from(std::uint32_t root) {
    open(root);
    while (!path_.empty()) {
      Visit& visit = path_.back();
      const std::uint32_t node = visit.node;
      if (visit.next < successors_[node].size()) {
        const std::uint32_t to = successors_[node][visit.next++];
        if (order_[to] == kNone) {
          open(to);
        } else if (component_[to] == kNone) {
          lowest_[node] = std::min(lowest_[node], order_[to]);
        }
        continue;
      }
      path_.pop_back();
      if (!path_.empty()) {
        std::uint32_t& above = lowest_[path_.back().node];
        above = std::min(above, lowest_[node]);
      }
      if (lowest_[node] == order_[node]) close(node);
    }
  }

  /// `first` is the first node of a component that was opened; those opened after it complete it.
  void close(std::uint32_t first) {
    std::uint32_t node = kNone;
    do {
      node = open_.back();
      open_.pop_back();
      component_[node] = closed_;
    } while (node != first);
    ++closed_;
  }

  const Successors& successors_;
  std::vector<std::uint32_t> order_;      // in which nodes are opened
  std::vector<std::uint32_t> lowest_;     // order of an open node that is reached from each
  std::vector<std::uint32_t> component_;  // none for a node that is open
  std::vector<std::uint32_t> open_;
  std::vector<Visit> path_;
  std::uint32_t opened_ = 0;
  std::uint32_t closed_ = 0;
};

}  // namespace

std::vector<std::uint32_t> strong_components(const Successors& successors) {
  return Search(successors).components();
}

std::uint32_t largest_component(std::span<const std::uint32_t> component_of) {
  std::vector<std::size_t> sizes(std::ranges::max(component_of) + std::size_t{1});
  for (const std::uint32_t component : component_of) ++sizes[component];
  return static_cast<std::uint32_t>(std::ranges::max_element(sizes) - sizes.begin());
}

}  // namespace flinch::runtime
