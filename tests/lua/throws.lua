-- SPDX-License-Identifier: MIT
-- throws.lua libflinch.so HEADER SELECTOR LIBRARY: does by LuaJIT what tests/throws/throws.c does, and prints the
-- same.
local ffi = require("ffi")
local flinch = require("flinch").load(arg[1], arg[2])
local THROWS, HITS, WALKS, FRAMES = 300, 20, 30, 20

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

local function print_numbers(numbers)
  local texts = {"pose"}
  for _, number in ipairs(numbers) do texts[#texts + 1] = ("%.9g"):format(number) end
  print(table.concat(texts, " "))
end

local function print_pose(of)
  local numbers = {}
  for i = 0, 2 do numbers[#numbers + 1] = of.root_position[i] end
  for joint = 0, flinch.JOINT_COUNT - 1 do
    for i = 0, 3 do numbers[#numbers + 1] = of.rotation[joint][i] end
  end
  print_numbers(numbers)
end

local function play_and_print()
  for _ = 1, FRAMES do flinch.character_update(character, 1 / 60) end
  flinch.character_pose(character, pose)
  print_pose(pose)
end

local function answer_by_steps(threat)
  local noticed = flinch.new("flinch_perception")
  noticed.threat.size = ffi.sizeof("flinch_threat")
  local hits = flinch.character_notice(character, threat, noticed)
  print("notices", hits, noticed.target)
  if hits ~= flinch.OK then return end
  local best, count = ffi.new("flinch_candidate[?]", flinch.MOST_CANDIDATES), ffi.new("int32_t[1]")
  flinch.character_rank(character, noticed, workspace, best, flinch.MOST_CANDIDATES, count)
  local plan = flinch.new("flinch_plan")
  flinch.character_plan(character, noticed, best[0].clip, plan)
  print_numbers({plan.first_motion_s, plan.begin_s, plan.peak_s, plan.end_s, plan.duration_s,
                 plan.playback_rate})
  flinch.character_planned_pose(character, noticed, best[0].clip, 0.3, pose)
  print_pose(pose)
  print_clip("answers",
             flinch.character_answer(character, noticed, best[0].clip, best, count[0]))
  play_and_print()
end

local function walk(path)
  local file = assert(io.open(path, "rb"))
  local bytes = file:read("*a")
  file:close()
  local clips = flinch.make("library", flinch.library_take, bytes, #bytes)
  local graph = flinch.make("motion_graph", flinch.motion_graph_create, clips)
  character = flinch.make("character", flinch.character_create, clips)
  flinch.character_walk(character, graph, 7, 0, 0, 3)
  for _ = 1, WALKS do
    local threat = ball()
    play_and_print()
    print_clip("braces", flinch.character_brace(character, threat, 0))
  end
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
  flinch.character_place(character, 0, 0, 0, 0.5)
  answer_by_steps(threat)
end
walk(arg[4])
local failed, text = pcall(flinch.character_update, character, -1)
assert(not failed and text:find("flinch_character_update: ") and text:find("time"), text)
