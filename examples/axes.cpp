// SPDX-License-Identifier: MIT
// Flinch's axes (right-handed, Z up, X forward, Y left, m) in those of engines, checked against
// what a change of axes is: a matrix M turns p into M p, and a rotation R into M R M^-1.
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cstdio>

namespace {

using Vector = std::array<float, 3>;
using Rotation = std::array<float, 4>;  // w, x, y, z

Vector unity_position(const Vector& p) {
  return {-p[1], p[2], p[0]};
}
Rotation unity_rotation(const Rotation& q) {
  return {q[0], q[2], -q[3], -q[1]};
}

Vector unreal_position(const Vector& p) {
  return {100 * p[0], -100 * p[1], 100 * p[2]};
}
Rotation unreal_rotation(const Rotation& q) {
  return {q[0], -q[1], q[2], -q[3]};
}

Vector godot_position(const Vector& p) {
  return {-p[1], p[2], -p[0]};
}
Rotation godot_rotation(const Rotation& q) {
  return {q[0], -q[2], q[3], -q[1]};
}

struct Engine {
  const char* name;
  Vector forward, left, up;  // where Flinch's axes point
  Vector (*position)(const Vector&);
  Rotation (*rotation)(const Rotation&);
};

constexpr std::array kEngines{
    Engine{"Unity", {0, 0, 1}, {-1, 0, 0}, {0, 1, 0}, unity_position, unity_rotation},
    Engine{"Unreal", {100, 0, 0}, {0, -100, 0}, {0, 0, 100}, unreal_position, unreal_rotation},
    Engine{"Godot", {0, 0, -1}, {-1, 0, 0}, {0, 1, 0}, godot_position, godot_rotation}};

Eigen::Vector3f eigen(const Vector& v) {
  return {v[0], v[1], v[2]};
}

Eigen::Matrix3f matrix_of(const Rotation& q) {
  return Eigen::Quaternionf(q[0], q[1], q[2], q[3]).toRotationMatrix();
}

float largest_error(const Engine& engine) {
  Eigen::Matrix3f change;
  change << eigen(engine.forward), eigen(engine.left), eigen(engine.up);
  float error = 0;
  for (int i = 0; i < 1000; ++i) {
    const Eigen::Vector3f p = Eigen::Vector3f::Random();
    const Eigen::Vector3f there = eigen(engine.position({p.x(), p.y(), p.z()}));
    const Eigen::Quaternionf q = Eigen::Quaternionf::UnitRandom();
    const Eigen::Matrix3f turned = matrix_of(engine.rotation({q.w(), q.x(), q.y(), q.z()}));
    const Eigen::Matrix3f wanted = change * q.toRotationMatrix() * change.inverse();
    error =
        std::max({error, (there - change * p).norm() / change.norm(), (turned - wanted).norm()});
  }
  return error;
}

}  // namespace

int main() {
  int wrong = 0;
  for (const Engine& engine : kEngines) {
    const float error = largest_error(engine);
    std::printf("%s: within %.1g\n", engine.name, double{error});
    wrong += error < 1e-5F ? 0 : 1;
  }
  return wrong;
}
