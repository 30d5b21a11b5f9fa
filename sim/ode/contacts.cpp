// SPDX-License-Identifier: MIT
#include "sim/ode/contacts.h"

#include <cmath>

namespace flinch::sim {
namespace {

// The ball with each body, and each pair of bodies.
constexpr std::size_t kMaxMeasured =
    motion::kBodyCount + motion::kBodyCount * (motion::kBodyCount - 1) / 2;
dContact contact_of(const ContactConstraint& constraint) {
  dContact contact{};
  for (int i = 0; i < 3; ++i) {
    contact.geom.pos[i] = constraint.point[i];
    contact.geom.normal[i] = constraint.normal[i];
  }
  contact.geom.depth = constraint.depth_m;
  contact.surface.mode = dContactSoftERP | dContactSoftCFM | dContactApprox1;
  contact.surface.soft_erp = constraint.error_reduction;
  contact.surface.soft_cfm = constraint.softness;
  contact.surface.mu = constraint.friction;
  if (constraint.friction > 0) {
    contact.surface.mode |= dContactFDir1;
    for (int i = 0; i < 3; ++i) contact.fdir1[i] = constraint.tangent[i];
  }
  if (constraint.restitution > 0) {
    contact.surface.mode |= dContactBounce;
    contact.surface.bounce = constraint.restitution;
    contact.surface.bounce_vel = kMinBounceSpeed_mps;
  }
  if (constraint.free_closing_mps != 0) {
    contact.surface.mode |= dContactMotionN;
    contact.surface.motionN = -constraint.free_closing_mps;
  }
  return contact;
}

}  // namespace

Contacts::Contacts(dWorldID world) : world_(world), group_(dJointGroupCreate(0)) {
  measured_.reserve(kMaxMeasured);
  impulses_.reserve(kMaxMeasured);
}

Contacts::~Contacts() {
  dJointGroupDestroy(group_);
}

dJointID Contacts::attach(const ContactConstraint& constraint, dBodyID first, dBodyID second) {
  const dContact contact = contact_of(constraint);
  const dJointID joint = dJointCreateContact(world_, group_, &contact);
  dJointAttach(joint, first, second);
  return joint;
}

void Contacts::measure(dJointID joint, motion::Body first, std::optional<motion::Body> second) {
  measured_.push_back({{}, first, second});
  dJointSetFeedback(joint, &measured_.back().feedback);
}

void Contacts::add_hit(dBodyID ball, dBodyID part, motion::Body body, const motion::Clearance& at,
                       const features::Bounce& bounce) {
  const ContactConstraint impact =
      impact_constraint(at.point, at.normal, state_of(ball), state_of(part), bounce);
  measure(attach(impact, ball, part), body, std::nullopt);
}

void Contacts::add_bounce(dBodyID ball, const Eigen::Quaterniond& frame,
                          const features::Bounce& bounce) {
  attach(bounce_constraint(state_of(ball), frame, bounce), ball, nullptr);
}

void Contacts::add_body_contact(dBodyID first_part, motion::Body first, dBodyID second_part,
                                motion::Body second, const motion::Clearance& at,
                                double free_closing_mps, bool measured) {
  const dJointID joint =
      attach(body_contact_constraint(at, free_closing_mps), first_part, second_part);
  if (measured) measure(joint, first, second);
}

void Contacts::add_support(dBodyID part, const Eigen::Vector3d& point, double depth_m,
                           double mass_kg, double step_s) {
  attach(ground_constraint(point, depth_m, mass_kg, step_s), part, nullptr);
}

std::span<const ContactImpulse> Contacts::impulses(double step_s) {
  impulses_.clear();
  for (const Measured& contact : measured_) {
    const dReal* force = contact.feedback.f1;
    impulses_.push_back(
        {contact.first, contact.second, step_s * std::hypot(force[0], force[1], force[2])});
  }
  return impulses_;
}

void Contacts::clear() {
  dJointGroupEmpty(group_);
  measured_.clear();
}

}  // namespace flinch::sim
