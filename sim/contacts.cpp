// SPDX-License-Identifier: MIT
#include "sim/contacts.h"

#include <cmath>
#include <numbers>

namespace flinch::sim {
namespace {

// The ball with every body, and every pair of bodies.
constexpr std::size_t kMostMeasured =
    motion::kBodyCount + motion::kBodyCount * (motion::kBodyCount - 1) / 2;
constexpr double kFriction = 0.5;           // of ball and body or ground
constexpr double kGroundFrequency_hz = 20;  // of the figure on its feet

dContact contact_at(const Eigen::Vector3d& point, const Eigen::Vector3d& normal) {
  dContact contact{};
  for (int i = 0; i < 3; ++i) {
    contact.geom.pos[i] = point[i];
    contact.geom.normal[i] = normal[i];
  }
  contact.surface.mode = dContactSoftERP | dContactApprox1;
  return contact;
}

dContact bounce_at(const Eigen::Vector3d& point, const Eigen::Vector3d& normal,
                   double restitution) {
  dContact contact = contact_at(point, normal);
  contact.surface.mode |= dContactBounce;
  contact.surface.bounce = restitution;
  contact.surface.bounce_vel = kRestSpeed_mps;
  contact.surface.mu = kFriction;
  return contact;
}

}  // namespace

Contacts::Contacts(dWorldID world) : world_(world), group_(dJointGroupCreate(0)) {
  measured_.reserve(kMostMeasured);
  impulses_.reserve(kMostMeasured);
}

Contacts::~Contacts() {
  dJointGroupDestroy(group_);
}

dJointID Contacts::attach(const dContact& contact, dBodyID first, dBodyID second) {
  const dJointID joint = dJointCreateContact(world_, group_, &contact);
  dJointAttach(joint, first, second);
  return joint;
}

void Contacts::measure(dJointID joint, motion::Body first, std::optional<motion::Body> second) {
  measured_.push_back({{}, first, second});
  dJointSetFeedback(joint, &measured_.back().feedback);
}

void Contacts::add_hit(dBodyID ball, dBodyID part, motion::Body body, const features::Clearance& at,
                       double restitution) {
  measure(attach(bounce_at(at.point, at.normal, restitution), ball, part), body, std::nullopt);
}

void Contacts::add_bounce(dBodyID ball, const Eigen::Vector3d& point, double restitution) {
  attach(bounce_at(point, Eigen::Vector3d::UnitZ(), restitution), ball, nullptr);
}

void Contacts::add_push(dBodyID first_part, motion::Body first, dBodyID second_part,
                        motion::Body second, const features::Clearance& at, double free_closing_mps,
                        bool measured) {
  dContact contact = contact_at(at.point, at.normal);
  contact.surface.mode |= dContactMotionN;
  contact.surface.motionN = -free_closing_mps;
  const dJointID joint = attach(contact, first_part, second_part);
  if (measured) measure(joint, first, second);
}

// A spring k and damper c taken implicitly over a step h (ODE manual, 3.8.2):
//   erp = h k / (h k + c),  cfm = 1 / (h k + c),  with k = m w^2 and c = 2 m w.
void Contacts::add_support(dBodyID part, const Eigen::Vector3d& point, double depth_m,
                           double mass_kg, double step_s) {
  const double frequency = 2 * std::numbers::pi * kGroundFrequency_hz;
  const double spring = step_s * mass_kg * frequency * frequency;
  const double damper = 2 * mass_kg * frequency;
  dContact contact = contact_at(point, Eigen::Vector3d::UnitZ());
  contact.geom.depth = depth_m;
  contact.surface.mode |= dContactSoftCFM;
  contact.surface.soft_erp = spring / (spring + damper);
  contact.surface.soft_cfm = 1 / (spring + damper);
  attach(contact, part, nullptr);
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
