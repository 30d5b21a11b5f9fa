# SPDX-License-Identifier: MIT
# The headers that games may include: everything that is installed, at most 26. docs/embedding.md
# says what each is for; the test architecture.public_headers checks the list.
set(FLINCH_PUBLIC_HEADERS
  motion/enum_array.h
  motion/role.h
  motion/skeleton.h
  motion/clip.h
  motion/body.h
  motion/foot.h
  motion/interpolation.h
  motion/pose_distance.h
  features/threat.h
  features/ball.h
  features/scenario.h
  database/library/load_status.h
  database/library/library.h
  models/candidate.h
  runtime/library.h
  runtime/workspace.h
  runtime/perception.h
  runtime/response/inertialization.h
  runtime/response/response.h
  runtime/push/push_motion.h
  runtime/character.h
  runtime/c/flinch.h  # installed as flinch.h
  lookahead/look_ahead.h
  reaction/reaction.h
  reaction/reacting_character.h)
