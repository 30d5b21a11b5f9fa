// SPDX-License-Identifier: MIT
// Empty: the module built from this file contains the whole run time, for inspection.
