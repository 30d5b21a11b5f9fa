// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace flinch::python {

/// A numpy array in row-major order; what is not one is converted.
template <class Number>
using Array = pybind11::array_t<Number, pybind11::array::c_style | pybind11::array::forcecast>;

/// Makes an array that is not filled.
template <class Number>
Array<Number> make_array(const std::vector<std::size_t>& shape) {
  return Array<Number>(std::vector<pybind11::ssize_t>(shape.begin(), shape.end()));
}

/// "(2, 3)", as numpy writes it.
inline std::string shape_text(const std::vector<std::size_t>& shape) {
  std::string text;
  for (const std::size_t size : shape) text += (text.empty() ? "" : ", ") + std::to_string(size);
  return '(' + text + (shape.size() == 1 ? ",)" : ")");
}

/// Throws ValueError, naming the argument, unless the array has this shape.
template <class Number>
void require_shape(const Array<Number>& array, const std::vector<std::size_t>& shape,
                   const std::string& name) {
  std::vector<std::size_t> seen;
  for (pybind11::ssize_t i = 0; i < array.ndim(); ++i)
    seen.push_back(static_cast<std::size_t>(array.shape(i)));
  if (seen != shape)
    throw pybind11::value_error(name + " must have the shape " + shape_text(shape) + ", but has " +
                                shape_text(seen));
}

/// Returns whole numbers of any width. Throws ValueError, naming the argument, for others, which a
/// cast to an array of integers would round.
inline Array<std::int64_t> whole_numbers(const pybind11::object& numbers, const std::string& name) {
  const auto array = pybind11::array::ensure(numbers);
  if (!array || (array.dtype().kind() != 'i' && array.dtype().kind() != 'u'))
    throw pybind11::value_error(name + " must hold whole numbers");
  return Array<std::int64_t>::ensure(array);
}

/// Returns the array of these values.
template <class Number>
Array<Number> array_of(const Number* values, const std::vector<std::size_t>& shape) {
  Array<Number> array = make_array<Number>(shape);
  std::copy_n(values, array.size(), array.mutable_data());
  return array;
}

/// Copies an array of this shape into `values`.
inline void copy_into(const Array<float>& array, const std::vector<std::size_t>& shape,
                      const std::string& name, float* values) {
  require_shape(array, shape, name);
  std::copy_n(array.data(), array.size(), values);
}

}  // namespace flinch::python
