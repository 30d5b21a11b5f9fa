-- SPDX-License-Identifier: MIT
-- whole.lua LIBRARY HEADER: the binding has each function, struct and constant of flinch.h.
local ffi = require("ffi")
local flinch = require("flinch").load(arg[1], arg[2])
local file = assert(io.open(arg[2]))
local header = file:read("*a"):gsub("/%*.-%*/", " ")
file:close()

local counts = {functions = 0, structs = 0, constants = 0}
for name in header:gmatch("FLINCH_API [%w_ *]-flinch_([%w_]+)%(") do
  assert(type(flinch[name]) == "function", name)
  counts.functions = counts.functions + 1
end
for name in header:gmatch("} (flinch_[%w_]+);") do
  assert(ffi.sizeof(name) > 0, name)
  counts.structs = counts.structs + 1
end
for name, value in header:gmatch("FLINCH_([%u_]+) = (%-?%d+)") do
  assert(flinch[name] == tonumber(value), name)
  counts.constants = counts.constants + 1
end
for name, value in header:gmatch("#define FLINCH_([%u_]+) +(%d+)") do
  assert(flinch[name] == tonumber(value), name)
  counts.constants = counts.constants + 1
end
-- A count of its own: each declaration has its FLINCH_API.
local _, declared = header:gsub("FLINCH_API %a", "")
assert(counts.functions == declared and declared > 60, counts.functions .. " of " .. declared)
assert(counts.structs > 15 and counts.constants > 60, counts.structs .. ", " .. counts.constants)
print(("%d functions, %d structs, %d constants"):format(counts.functions, counts.structs,
                                                         counts.constants))
