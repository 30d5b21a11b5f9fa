-- SPDX-License-Identifier: MIT
-- values.lua LIBRARY HEADER: a struct is made of what is given whole and by its name, or not at all.
local flinch = require("flinch").load(arg[1], arg[2])

local function refuses(name, fields, wanted)
  local made, text = pcall(function() local _ = flinch.new(name, fields) end)
  local line, told = tostring(text):match("^(.-values%.lua:%d+): (.*)$")
  assert(not made and line and told == wanted, ("%s instead of %s"):format(text, wanted))
end

local threat = flinch.new("flinch_threat", {velocity = {-20, 0, 1}, radius = 0.5})
assert(threat.velocity[0] == -20 and threat.velocity[1] == 0 and threat.velocity[2] == 1)
assert(threat.radius == 0.5 and threat.position[2] == 0 and threat.size > 0)
refuses("flinch_threat", {velocity = {-20}},
        "flinch_threat.velocity has 3 elements, and 1 was given: give all of them")
refuses("flinch_threat", {velocity = {-20, 0}},
        "flinch_threat.velocity has 3 elements, and 2 were given: give all of them")
refuses("flinch_threat", {velocity = {}},
        "flinch_threat.velocity has 3 elements, and 0 were given: give all of them")
refuses("flinch_threat", {velocity = {1, 2, 3, 4}},
        "flinch_threat.velocity has 3 elements, and 4 were given: give all of them")
refuses("flinch_threat", {velocity = -20},
        "flinch_threat.velocity has 3 elements, and a number was given: give a table of all of them")
refuses("flinch_threat", {radios = 0.1}, "flinch_threat has no field radios")
refuses("flinch_threat", {0.1}, "flinch_threat has no field 1")

local rotations = {}
for joint = 1, flinch.JOINT_COUNT do rotations[joint] = {1, 0, 0, 0} end
assert(flinch.new("flinch_pose", {rotation = rotations}).rotation[20][0] == 1)
rotations[3] = {1}
refuses("flinch_pose", {rotation = rotations},
        "flinch_pose.rotation[2] has 4 elements, and 1 was given: give all of them")

local noticed = flinch.new("flinch_perception", {threat = {velocity = {-20, 0, 1}}})
assert(noticed.threat.velocity[0] == -20)
refuses("flinch_perception", {threat = {velocity = {-20}}},
        "flinch_perception.threat.velocity has 3 elements, and 1 was given: give all of them")
