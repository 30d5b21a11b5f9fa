-- SPDX-License-Identifier: MIT
-- throws.lua LIBRARY HEADER SELECTOR: does by LuaJIT what tests/throws/throws.c does, and prints the
-- same.
local ffi = require("ffi")
local flinch = require("flinch").load(arg[1], arg[2])
local THROWS, HITS, FRAMES = 300, 20, 20

local single = ffi.new("float[1]")
local function float(number)  -- rounds to single precision, as C does at each step
  single[0] = number
  return single[0]
end

local state = 1ULL
local function uniform(low, high)
  state = state * 6364136223846793005ULL + 1442695040888963407ULL
  local share = float(float(tonumber(state / 2ULL ^ 40)) / 16777216)
  return float(float(low) + float(float(float(high) - float(low)) * share))
end

local function ball()
  local x, y, square
  repeat
    x = uniform(-9, 9)
    y = uniform(-9, 9)
    square = float(float(x * x) + float(y * y))
  until square >= 9 and square <= 81
  local from = {x, y, uniform(0.5, 2)}
  local to = {uniform(-0.3, 0.3)}
  to[2] = uniform(-0.3, 0.3)
  to[3] = uniform(0.3, 1.8)
  local flight_s = uniform(0.3, 1.1)
  local threat = flinch.new("flinch_threat")
  for i = 1, 3 do
    threat.position[i - 1] = from[i]
    threat.velocity[i - 1] = float(float(to[i] - from[i]) / flight_s)
  end
  threat.velocity[2] = threat.velocity[2] + float(float(float(9.81) * flight_s) / 2)
  threat.radius = uniform(0.03, 0.2)
  threat.mass_kg = uniform(0.1, 1)
  return threat
end

local library = flinch.make("library", flinch.library_load, arg[3])
local workspace = flinch.make("workspace", flinch.workspace_create, library)
local look_ahead = flinch.make("look_ahead", flinch.look_ahead_create, library)
local character = flinch.make("character", flinch.character_create_reacting, library)
local now, pose = flinch.new("flinch_character_state"), flinch.new("flinch_pose")

local function print_clip(how, answer)
  flinch.character_describe(character, now)
  print(how, answer, now.clip)
end

local function play_and_print()
  for _ = 1, FRAMES do flinch.character_update(character, 1 / 60) end
  flinch.character_pose(character, pose)
  local numbers = {"pose"}
  for i = 0, 2 do numbers[#numbers + 1] = ("%.9g"):format(pose.root_position[i]) end
  for joint = 0, flinch.JOINT_COUNT - 1 do
    for i = 0, 3 do numbers[#numbers + 1] = ("%.9g"):format(pose.rotation[joint][i]) end
  end
  print(table.concat(numbers, " "))
end

local write = print
function print(...) write(table.concat({...}, " ")) end
for _ = 1, THROWS do
  local threat = ball()
  flinch.character_place(character, 0, 0, 0, 0.5)
  print_clip("perceives", flinch.character_perceive(character, threat, workspace))
  play_and_print()
  play_and_print()
end
for _ = 1, HITS do
  local threat = ball()
  local options = flinch.new("flinch_look_ahead_options", {candidates = 4})
  flinch.character_place(character, 0, 0, 0, 0.5)
  print_clip("looks ahead",
             flinch.character_look_ahead(character, threat, 1, options, look_ahead, nil))
  flinch.character_place(character, 0, 0, 0, 0.5)
  flinch.character_react_to(character, threat)
  play_and_print()
  play_and_print()
end
local failed, text = pcall(flinch.character_update, character, -1)
assert(not failed and text:find("flinch_character_update: ") and text:find("time"), text)
