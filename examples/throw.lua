-- SPDX-License-Identifier: MIT
-- Throws one ball at a character: luajit throw.lua libflinch.so flinch.h SELECTOR
local flinch = require("flinch").load(arg[1], arg[2])
local library = flinch.make("library", flinch.library_load, arg[3])
local workspace = flinch.make("workspace", flinch.workspace_create, library)
local character = flinch.make("character", flinch.character_create, library)
local ball = flinch.new("flinch_threat", {position = {9, 1, 1.4}, velocity = {-20, -2.2, 2.8},
                                          radius = 0.105, mass_kg = 0.27})
local pose, frames = flinch.new("flinch_pose"), flinch.new("flinch_joint_frames")
print(flinch.status_message(flinch.character_perceive(character, ball, workspace)))
for frame = 1, 60 do
  flinch.character_update(character, 1 / 60)
  flinch.character_pose(character, pose)
  flinch.library_joint_frames(library, pose, frames)
  print(("head at %.2f m"):format(frames.position[4][2]))
end
