// SPDX-License-Identifier: MIT
#include "database/import/role_overrides.h"

#include "motion/error.h"

namespace flinch::database {

RoleOverrides role_overrides(const TomlReader& roles) {
  RoleOverrides overrides;
  for (const auto& [key, value] : roles.table()) {
    const std::optional<motion::Role> role = motion::role_named(key.str());
    if (role) {
      overrides[*role] = roles.needed_text(key.str());
      continue;
    }
    std::string names;
    for (motion::Role known : motion::kRoles) {
      names += (names.empty() ? "" : ", ") + std::string(motion::name_of(known));
    }
    roles.fail(key.str(),
               "names an unknown role \"" + std::string(key.str()) + "\"; the roles are: " + names);
  }
  return overrides;
}

RoleOverrides read_role_overrides(const std::string& path) {
  const toml::table file = read_toml(path);
  const TomlReader reader(file, path, "the file of roles");
  reader.expect_keys({"roles"});
  const toml::table* roles = file["roles"].as_table();
  if (roles == nullptr) reader.fail("roles", "needs a table [roles] with lines: role = \"joint\"");
  return role_overrides(TomlReader(*roles, path, "[roles]"));
}

}  // namespace flinch::database
