-- SPDX-License-Identifier: MIT
-- error.lua LIBRARY HEADER SELECTOR: ends by an error, with objects that are still to be freed.
local flinch = require("flinch").load(arg[1], arg[2])
local library = flinch.make("library", flinch.library_load, arg[3])
local character = flinch.make("character", flinch.character_create, library)
flinch.character_update(character, -1)
