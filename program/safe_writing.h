// SPDX-License-Identifier: MIT
#pragma once

namespace flinch::program {

/// Makes every write that cannot be done fail where it is made. Call first in main: a file that
/// reaches a size limit no longer ends the process by a signal, and if the program was started with
/// a closed standard stream, no file that it opens takes that stream's place and gets its text.
void make_writes_safe();

}  // namespace flinch::program
