// SPDX-License-Identifier: MIT
#pragma once

#include "sim/rehearsal/simulator.h"

namespace flinch::evolve {

/// The joints of the upper body, whose torques follow from the motion alone: nothing else pushes
/// the bodies beyond them. Those of the legs would need the ground's force.
inline constexpr std::array kEffortJoints{
    motion::Body::abdomen,   motion::Body::chest,           motion::Body::neck,
    motion::Body::head,      motion::Body::left_upper_arm,  motion::Body::left_forearm,
    motion::Body::left_hand, motion::Body::right_upper_arm, motion::Body::right_forearm,
    motion::Body::right_hand};

/// The energy metric (Rose 2006, equation 4.3, without its factor) over the part of a rehearsal
/// that it keeps: the sum over joints and steps of |tau| h, N·m·s, by inverse dynamics. Torque that
/// pulls the back of a hand, by weaker muscles, counts `extension_weight` times more (section
/// 6.2.1).
double joint_effort(const sim::FigureModel& figure_model, const sim::Rehearsal& rehearsal,
                    double gravity_mps2, double extension_weight = 0);

}  // namespace flinch::evolve
