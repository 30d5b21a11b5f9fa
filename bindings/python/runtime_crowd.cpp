// SPDX-License-Identifier: MIT
#include <memory>
#include <vector>

#include "bindings/python/runtime.h"

namespace flinch::python {

namespace py = pybind11;

namespace {

/// Many characters of one library, whose numbers are rows of arrays.
class Crowd {
 public:
  Crowd(const std::shared_ptr<Library>& library, std::size_t count, bool reacting) {
    members_.reserve(count);
    for (std::size_t i = 0; i < count; ++i)
      members_.push_back(std::make_shared<Character>(library, reacting));
  }

  std::size_t size() const { return members_.size(); }
  std::shared_ptr<Character> member(py::ssize_t index) const {
    const auto count = static_cast<py::ssize_t>(size());
    const py::ssize_t place = index < 0 ? index + count : index;
    if (place < 0 || place >= count) throw py::index_error("there is no such character");
    return members_[static_cast<std::size_t>(place)];
  }

  void place(const Array<float>& position, const Array<float>& facing,
             const Array<float>& stance_time_s) const {
    require_shape(position, {size(), 2}, "position");
    require_shape(facing, {size()}, "facing");
    require_shape(stance_time_s, {size()}, "stance_time_s");
    for (std::size_t i = 0; i < size(); ++i)
      checked(flinch_character_place(members_[i]->get(), position.data()[2 * i],
                                     position.data()[2 * i + 1], facing.data()[i],
                                     stance_time_s.data()[i]));
  }

  /// Throws one threat at each character; returns their statuses.
  Array<std::int32_t> perceive(const Array<float>& position, const Array<float>& velocity,
                               float radius, float mass_kg, std::int32_t kind) const {
    require_shape(position, {size(), 3}, "position");
    require_shape(velocity, {size(), 3}, "velocity");
    Array<std::int32_t> answers = make_array<std::int32_t>({size()});
    auto threat = sized<flinch_threat>();
    threat.radius = radius;
    threat.mass_kg = mass_kg;
    threat.kind = kind;
    for (std::size_t i = 0; i < size(); ++i) {
      std::copy_n(position.data() + 3 * i, 3, threat.position);
      std::copy_n(velocity.data() + 3 * i, 3, threat.velocity);
      answers.mutable_data()[i] = checked(flinch_character_perceive(
          members_[i]->get(), &threat, members_[i]->library->workspace()));
    }
    return answers;
  }

  void update(float dt_s) const {
    for (const auto& one : members_) checked(flinch_character_update(one->get(), dt_s));
  }

  py::tuple poses() const {
    Array<float> root = make_array<float>({size(), 3});
    Array<float> rotation = make_array<float>({size(), FLINCH_JOINT_COUNT, 4});
    auto pose = sized<flinch_pose>();
    for (std::size_t i = 0; i < size(); ++i) {
      checked(flinch_character_pose(members_[i]->get(), &pose));
      std::copy_n(pose.root_position, 3, root.mutable_data() + 3 * i);
      std::copy_n(&pose.rotation[0][0], kRotations, rotation.mutable_data() + kRotations * i);
    }
    return py::make_tuple(root, rotation);
  }

  Array<float> joint_positions() const {
    Array<float> positions = make_array<float>({size(), FLINCH_JOINT_COUNT, 3});
    constexpr std::size_t kPositions = std::size_t{FLINCH_JOINT_COUNT} * 3;
    auto pose = sized<flinch_pose>();
    auto frames = sized<flinch_joint_frames>();
    for (std::size_t i = 0; i < size(); ++i) {
      checked(flinch_character_pose(members_[i]->get(), &pose));
      checked(flinch_library_joint_frames(members_[i]->library->get(), &pose, &frames));
      std::copy_n(&frames.position[0][0], kPositions, positions.mutable_data() + kPositions * i);
    }
    return positions;
  }

  Array<std::int32_t> clips() const {
    Array<std::int32_t> clips = make_array<std::int32_t>({size()});
    auto state = sized<flinch_character_state>();
    for (std::size_t i = 0; i < size(); ++i) {
      checked(flinch_character_describe(members_[i]->get(), &state));
      clips.mutable_data()[i] = state.clip;
    }
    return clips;
  }

 private:
  static constexpr std::size_t kRotations = std::size_t{FLINCH_JOINT_COUNT} * 4;

  std::vector<std::shared_ptr<Character>> members_;
};

}  // namespace

void bind_crowd(py::module_& module) {
  py::class_<Crowd>(module, "Crowd", "Many characters of one library, as rows of arrays.")
      .def(py::init<const std::shared_ptr<Library>&, std::size_t, bool>(), py::arg("library"),
           py::arg("count"), py::kw_only(), py::arg("reacting") = false)
      .def("__len__", &Crowd::size)
      .def("__getitem__", &Crowd::member, py::arg("index"))
      .def("place", &Crowd::place, py::arg("position"), py::arg("facing"), py::arg("stance_time_s"),
           "Positions (n, 2), m; facings and times (n,).")
      .def("perceive", &Crowd::perceive, py::arg("position"), py::arg("velocity"),
           py::arg("radius") = 0.105F, py::arg("mass_kg") = 0.27F, py::arg("kind") = 0,
           "Throws one threat at each: positions and velocities (n, 3), world. Returns 0 for each "
           "that answers, 1 for a miss, 2 for one that goes unnoticed, 3 for one outside of "
           "training.")
      .def("update", &Crowd::update, py::arg("dt_s"))
      .def("poses", &Crowd::poses, "Root positions (n, 3) and local rotations (n, 21, 4).")
      .def("joint_positions", &Crowd::joint_positions, "World, m: (n, 21, 3).")
      .def("clips", &Crowd::clips, "Indices of the clips that play: (n,).");
}

}  // namespace flinch::python
