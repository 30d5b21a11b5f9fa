// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace flinch::runtime {

/// The edges of a directed graph: for each node, the nodes that it leads to.
using Successors = std::vector<std::vector<std::uint32_t>>;

/// The number of each node's strongly connected component: two nodes have the same number if each
/// can be reached from the other. Components are numbered from 0 without gaps; an edge between two
/// leads from the higher number to the lower. In linear time (Tarjan 1972, "Depth-first search and
/// linear graph algorithms"), without recursion.
std::vector<std::uint32_t> strong_components(const Successors& successors);

/// The number of the component with the most nodes, of equal ones the lowest. There must be nodes.
std::uint32_t largest_component(std::span<const std::uint32_t> component_of);

}  // namespace flinch::runtime
