// SPDX-License-Identifier: MIT
// The layout of the structs in JSON.
#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>
#include <vector>

#include "bindings/js/exports.h"

namespace {

struct Field {
  std::string name;
  std::size_t offset;
  std::string type;
  std::size_t count;
};

template <class T>
std::string type_name() {
  if constexpr (std::is_pointer_v<T>) {
    return "pointer";
  } else if constexpr (std::is_same_v<T, float>) {
    return "f32";
  } else if constexpr (std::is_same_v<T, std::uint32_t>) {
    return "u32";
  } else if constexpr (std::is_same_v<T, std::int32_t>) {
    return "i32";
  } else {
    static_assert(std::is_same_v<T, flinch_foreseen>, "a struct within a struct: name it here");
    return "flinch_foreseen";
  }
}

template <class Member>
Field field(const char* name, std::size_t offset) {
  using Element = std::remove_all_extents_t<Member>;
  return {name, offset, type_name<Element>(), sizeof(Member) / sizeof(Element)};
}

std::string quoted(const std::string& text) {
  return '"' + text + '"';
}

std::string struct_text(const char* name, std::size_t size, const std::vector<Field>& fields) {
  std::string text = quoted(name) + ": {\"size\": " + std::to_string(size) + ", \"fields\": {";
  const char* separator = "";
  for (const Field& one : fields) {
    text += separator + quoted(one.name) + ": {\"offset\": " + std::to_string(one.offset) +
            ", \"type\": " + quoted(one.type) + ", \"count\": " + std::to_string(one.count) + "}";
    separator = ", ";
  }
  return text + "}}";
}

// A member of S, its name spelt once.
#define F(member) field<decltype(S::member)>(#member, offsetof(S, member))

std::string layout() {
  std::vector<std::string> structs;
  {
    using S = flinch_library_info;
    structs.push_back(
        struct_text("flinch_library_info", sizeof(S),
                    {F(size), F(clip_count), F(idle_clip), F(rate_hz), F(mass_kg), F(kind_count)}));
  }
  {
    using S = flinch_push_example;
    structs.push_back(struct_text("flinch_push_example", sizeof(S),
                                  {F(state_clip), F(state_s), F(place), F(asked), F(response_clip),
                                   F(turn), F(taper), F(deformation)}));
  }
  {
    using S = flinch_question;
    structs.push_back(struct_text("flinch_question", sizeof(S),
                                  {F(estimate), F(push_s), F(frame_count), F(label_count),
                                   F(compared), F(same_side), F(mean_error), F(is_agreement)}));
  }
  {
    using S = flinch_crowd_state;
    structs.push_back(struct_text("flinch_crowd_state", sizeof(S),
                                  {F(characters), F(half_side_m), F(bumps), F(walls), F(answered),
                                   F(physical), F(knocked_over), F(push_count)}));
  }
  {
    using S = flinch_crowd_push;
    structs.push_back(struct_text("flinch_crowd_push", sizeof(S),
                                  {F(character), F(is_physical), F(at), F(velocity)}));
  }
  {
    using S = flinch_skeleton;
    structs.push_back(struct_text("flinch_skeleton", sizeof(S), {F(size), F(offset), F(tip)}));
  }
  {
    using S = flinch_outline;
    structs.push_back(
        struct_text("flinch_outline", sizeof(S),
                    {F(size), F(joint), F(is_box), F(centre), F(orientation), F(radius),
                     F(half_length), F(half_extents), F(mass_kg), F(centre_of_mass)}));
  }
  {
    using S = flinch_clip;
    structs.push_back(
        struct_text("flinch_clip", sizeof(S),
                    {F(size), F(is_annotated), F(name), F(kind), F(duration_s), F(target),
                     F(direction), F(degree), F(onset_s), F(peak_s), F(end_s), F(reserved)}));
  }
  {
    using S = flinch_pose;
    structs.push_back(
        struct_text("flinch_pose", sizeof(S), {F(size), F(root_position), F(rotation)}));
  }
  {
    using S = flinch_joint_frames;
    structs.push_back(
        struct_text("flinch_joint_frames", sizeof(S), {F(size), F(position), F(orientation)}));
  }
  {
    using S = flinch_perception_limits;
    structs.push_back(
        struct_text("flinch_perception_limits", sizeof(S),
                    {F(size), F(reaction_delay_s), F(bearing_noise), F(distance_noise),
                     F(heading_noise), F(speed_noise), F(chance_to_fail)}));
  }
  {
    using S = flinch_threat;
    structs.push_back(struct_text(
        "flinch_threat", sizeof(S),
        {F(size), F(position), F(velocity), F(radius), F(mass_kg), F(kind), F(starts_in_s),
         F(lasts_s), F(axis), F(angular_velocity), F(to_butt_m), F(to_tip_m)}));
  }
  {
    using S = flinch_kind;
    structs.push_back(struct_text("flinch_kind", sizeof(S),
                                  {F(size), F(shape), F(name), F(radius), F(mass_kg), F(speed_mps),
                                   F(elevation), F(time_to_impact_s), F(reach_m), F(restitution),
                                   F(friction), F(is_straight), F(reserved), F(length_m)}));
  }
  {
    using S = flinch_outside;
    structs.push_back(
        struct_text("flinch_outside", sizeof(S), {F(name), F(value), F(trained), F(reserved)}));
  }
  {
    using S = flinch_mask;
    structs.push_back(struct_text("flinch_mask", sizeof(S), {F(size), F(weight), F(joint)}));
  }
  {
    using S = flinch_character_state;
    structs.push_back(struct_text(
        "flinch_character_state", sizeof(S),
        {F(size), F(phase), F(clip), F(target), F(time_to_impact_s), F(position), F(facing)}));
  }
  {
    using S = flinch_candidate;
    structs.push_back(
        struct_text("flinch_candidate", sizeof(S), {F(clip), F(vote), F(expected_cost_ns)}));
  }
  {
    using S = flinch_look_ahead_options;
    structs.push_back(
        struct_text("flinch_look_ahead_options", sizeof(S),
                    {F(size), F(candidates), F(budget_us), F(reserved), F(now_us), F(clock)}));
  }
  {
    using S = flinch_reaction_options;
    structs.push_back(struct_text("flinch_reaction_options", sizeof(S),
                                  {F(size), F(simulation_only_s), F(stiffness)}));
  }
  {
    using S = flinch_foreseen;
    structs.push_back(
        struct_text("flinch_foreseen", sizeof(S),
                    {F(clip), F(foreseen), F(work_j), F(damage_ns), F(cost_ns), F(contact_s)}));
  }
  {
    using S = flinch_look_ahead_status;
    structs.push_back(struct_text("flinch_look_ahead_status", sizeof(S),
                                  {F(size), F(candidate_count), F(tried), F(encounters), F(chosen),
                                   F(threats), F(ignored), F(is_complete), F(candidate)}));
  }
  {
    using S = flinch_reaction;
    structs.push_back(
        struct_text("flinch_reaction", sizeof(S),
                    {F(size), F(phase), F(moved_by), F(clip), F(contact_s), F(ball_position),
                     F(ball_velocity), F(impulse_ns), F(ball_axis), F(ball_momentum)}));
  }
  {
    using S = flinch_skin_mesh;
    structs.push_back(struct_text("flinch_skin_mesh", sizeof(S),
                                  {F(size), F(vertex_count), F(position), F(normal), F(joint),
                                   F(weight), F(triangle), F(triangle_count)}));
  }
  {
    using S = flinch_costs;
    structs.push_back(struct_text("flinch_costs", sizeof(S), {F(brawn), F(work_weight_ns_per_j)}));
  }
  {
    using S = flinch_trial;
    structs.push_back(
        struct_text("flinch_trial", sizeof(S),
                    {F(clip), F(work_j), F(damage_ns), F(cost_ns), F(contact_s), F(impulse_ns)}));
  }
  {
    using S = flinch_scenario;
    structs.push_back(struct_text("flinch_scenario", sizeof(S),
                                  {F(target), F(time_to_impact_s), F(idle_time_s), F(position),
                                   F(velocity), F(radius), F(mass_kg)}));
  }
  std::string text = "{";
  const char* separator = "";
  for (const std::string& one : structs) {
    text += separator + one;
    separator = ",\n";
  }
  return text + "}\n";
}

#undef F

}  // namespace

const char* flinch_layout(void) {
  static const std::string kLayout = layout();
  return kLayout.c_str();
}
