// SPDX-License-Identifier: MIT
// Holds nothing of its own: the module that it makes is the whole run time, to be looked into.
