// SPDX-License-Identifier: MIT
#include "train/program/info_bvh.h"

#include <iostream>

#include "train/program/table.h"

namespace flinch::train::program {

MappedBvh read_mapped_bvh(const std::string& path, const std::string& overrides) {
  MappedBvh mapped;
  mapped.bvh = database::read_bvh(path);
  mapped.roles =
      database::map_roles(mapped.bvh, overrides.empty() ? database::RoleOverrides{}
                                                        : database::read_role_overrides(overrides));
  return mapped;
}

namespace {

std::string joint_name(const MappedBvh& mapped, motion::Role role) {
  const int joint = mapped.roles.joint[role];
  return joint < 0 ? "" : mapped.bvh.joints[static_cast<std::size_t>(joint)].name;
}

}  // namespace

Json bvh_document(const MappedBvh& mapped) {
  Json roles;
  for (const motion::Role role : motion::kRoles) {
    const std::string joint = joint_name(mapped, role);
    roles[std::string(motion::name_of(role))] = {
        {"joint", joint.empty() ? Json() : Json(joint)},
        {"source", database::name_of(mapped.roles.source[role])}};
  }
  return {{"kind", "bvh"},
          {"file", mapped.bvh.path},
          {"joints", mapped.bvh.joints.size()},
          {"frames", mapped.bvh.frame_count},
          {"frame_time_s", mapped.bvh.frame_time_s},
          {"duration_s", mapped.bvh.duration_s()},
          {"roles", roles},
          {"warnings", mapped.bvh.warnings}};
}

void print_bvh(const MappedBvh& mapped) {
  Table table({{"role"}, {"joint"}, {"found by"}});
  for (const motion::Role role : motion::kRoles) {
    const std::string joint = joint_name(mapped, role);
    table.add({std::string(motion::name_of(role)), joint.empty() ? "-" : joint,
               std::string(database::name_of(mapped.roles.source[role]))});
  }
  std::cout << "BVH motion of " << mapped.bvh.joints.size() << " joints, " << mapped.bvh.frame_count
            << " frames of " << mapped.bvh.frame_time_s << " s, "
            << fixed(mapped.bvh.duration_s(), 2) << " s\n\n"
            << table.text();
  for (const std::string& warning : mapped.bvh.warnings) std::cout << "note: " << warning << '\n';
}

}  // namespace flinch::train::program
