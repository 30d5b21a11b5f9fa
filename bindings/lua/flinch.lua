-- SPDX-License-Identifier: MIT
-- Flinch in LuaJIT: docs/lua.md. Its declarations are those of flinch.h, which it reads.
local ffi = require("ffi")

-- What LuaJIT's parser knows of a C header: no comments, no preprocessor, no macros.
local function declarations(header)
  header = header:gsub("/%*.-%*/", " "):gsub('\n#ifdef __cplusplus.-\n#endif', "")
  local constants = {}
  for name, value in header:gmatch("#define (FLINCH_[A-Z_]+) +(%d+)") do constants[name] = value end
  header = header:gsub("\n#[^\n]*", ""):gsub("^#[^\n]*", ""):gsub("FLINCH_API ", "")
  for name, value in pairs(constants) do header = header:gsub("%f[%w_]" .. name .. "%f[^%w_]", value) end
  return header, constants
end

local check_fields

-- Refuses an array of which not all elements are given; LuaJIT fills one with the only number that
-- it is given. `made` is a field of a struct, `value` what it is to hold.
local function check_value(where, made, value)
  local count = type(made) == "cdata" and tonumber(tostring(ffi.typeof(made)):match("%[(%d+)%]"))
  if count and type(value) == "table" then
    if #value ~= count then
      error(("%s has %d elements, and %d %s given: give all of them"):format(
        where, count, #value, #value == 1 and "was" or "were"), 0)
    end
    for i = 1, count do check_value(("%s[%d]"):format(where, i - 1), made[i - 1], value[i]) end
  elseif count and type(value) ~= "cdata" then
    error(("%s has %d elements, and a %s was given: give a table of all of them"):format(
      where, count, type(value)), 0)
  elseif type(value) == "table" then
    check_fields(where, made, value)
  end
end

-- Refuses fields that there are not, which LuaJIT leaves out.
function check_fields(where, made, fields)
  for key, value in pairs(fields) do
    local is_field, field = pcall(function() return made[key] end)
    if not is_field or type(key) ~= "string" then error(where .. " has no field " .. key, 0) end
    check_value(where .. "." .. key, field, value)
  end
end

local Flinch = {}
-- LuaJIT may close a library before it runs the finalizers that call it.
local loaded = {}

-- Loads the library at `library` ("libflinch.so") with the declarations of the header at `header`.
-- What it returns has every function of flinch.h without "flinch_"; one that fails raises an error
-- with the library's text. Constants are there without "FLINCH_".
function Flinch.load(library, header)
  local file = assert(io.open(header))
  local text, constants = declarations(file:read("*a"))
  file:close()
  ffi.cdef(text)
  local C = ffi.load(library)
  loaded[#loaded + 1] = C
  local flinch = { C = C }

  -- A struct of flinch.h, such as new("flinch_threat", {radius = 0.1}), with its size set.
  function flinch.new(name, fields)
    local is_sound, problem = pcall(check_fields, name, ffi.new(name), fields or {})
    if not is_sound then error(problem, 2) end
    local made = fields and ffi.new(name, fields) or ffi.new(name)
    made.size = ffi.sizeof(name)
    return made
  end

  -- Makes an object by a function whose last argument is the handle to be made, such as
  -- make("library", flinch.library_load, path); the garbage collector frees it.
  function flinch.make(kind, create, ...)
    local out = ffi.new("flinch_" .. kind .. "*[1]")
    local arguments = { ... }
    arguments[#arguments + 1] = out
    create(unpack(arguments))
    return ffi.gc(out[0], C["flinch_" .. kind .. "_free"])
  end

  local function checked(name)
    local call = C["flinch_" .. name]
    local returns_status = text:find("flinch_status flinch_" .. name .. "%(") ~= nil
    if not returns_status then
      return function(...)
        local result = call(...)
        if type(result) ~= "cdata" then return result end
        return result ~= nil and ffi.string(result) or nil
      end
    end
    return function(...)
      local status = call(...)
      if status < 0 then
        error("flinch_" .. name .. ": " .. ffi.string(C.flinch_status_message(status)), 2)
      end
      return status
    end
  end

  return setmetatable(flinch, {
    __index = function(self, name)
      local value
      if name:find("^%u") then
        value = tonumber(constants["FLINCH_" .. name]) or C["FLINCH_" .. name]
      else
        value = checked(name)
      end
      rawset(self, name, value)
      return value
    end,
  })
end

return Flinch
