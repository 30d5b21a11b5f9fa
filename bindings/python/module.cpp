// SPDX-License-Identifier: MIT
#include <pybind11/pybind11.h>

#include <exception>

#include "bindings/python/offline.h"
#include "bindings/python/runtime.h"

namespace py = pybind11;

namespace {

/// Raises flinch.Error with the text, and with the status of the run time where it was that.
void raise(const std::exception& error, const py::object& status) {
  const py::object type = py::module_::import("flinch._flinch").attr("Error");
  const py::object instance = type(error.what());
  instance.attr("status") = status;
  PyErr_SetObject(type.ptr(), instance.ptr());
}

void translate(std::exception_ptr thrown) {
  try {
    if (thrown) std::rethrow_exception(thrown);
  } catch (const flinch::python::StatusError& error) {
    raise(error, py::int_(error.status));
  } catch (const flinch::Error& error) {
    raise(error, py::none());
  }
}

}  // namespace

PYBIND11_MODULE(_flinch, module) {
  module.doc() = "Game characters that anticipate impacts.";
  module.attr("__version__") = FLINCH_VERSION;
  py::exception<flinch::Error> error(module, "Error");
  error.attr("status") = py::none();
  py::register_exception_translator(&translate);
  flinch::python::bind_values(module);
  flinch::python::bind_library(module);
  flinch::python::bind_perception(module);
  flinch::python::bind_character(module);
  flinch::python::bind_crowd(module);
  flinch::python::bind_clip_library(module);
  flinch::python::bind_simulation(module);
  flinch::python::bind_store(module);
  flinch::python::bind_training(module);
}
