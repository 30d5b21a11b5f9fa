// SPDX-License-Identifier: MIT
// Walking by a motion graph, in C.
#include <utility>

#include "runtime/c/c_check.h"
#include "runtime/c/c_objects.h"
#include "runtime/c/c_values.h"
#include "runtime/graph/motion_graph.h"

namespace runtime = flinch::runtime;
using runtime::check;

flinch_status flinch_motion_graph_create(const flinch_library* library, flinch_motion_graph** out) {
  if (out == nullptr) return FLINCH_NULL_POINTER;
  *out = nullptr;
  if (const flinch_status status = check(library)) return status;
  auto graph = runtime::make_motion_graph(*library->content);
  if (!graph) return FLINCH_OUT_OF_MEMORY;
  if (graph->nodes.empty()) return FLINCH_BAD_CLIP;
  return runtime::make_handle(out, [&] {
    return flinch_motion_graph::Content{library->content, std::move(graph)};
  });
}

flinch_status flinch_motion_graph_free(flinch_motion_graph* graph) {
  return runtime::free_handle(graph);
}

flinch_status flinch_character_walk(flinch_character* character, const flinch_motion_graph* graph,
                                    uint64_t seed, float x, float y, float radius) {
  if (const flinch_status status = check(character, graph)) return status;
  flinch_character::Content& content = *character->content;
  if (content.library != graph->content->library) return FLINCH_OTHER_LIBRARY;
  const runtime::Status status = content.moved([&](runtime::Character& body) {
    return body.walk(*graph->content->graph, seed, {{x, y}, radius});
  });
  if (status == runtime::Status::ok) content.graph = graph->content->graph;
  return runtime::status_of(status);
}
