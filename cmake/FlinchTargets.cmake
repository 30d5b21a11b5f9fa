# SPDX-License-Identifier: MIT
# How every target of the project is made, so that flags stand in one place.

# Flags that all of our code is compiled with. Warnings are errors. No fused
# multiply-add and no -ffast-math: results must be the same bits everywhere.
add_library(flinch_flags INTERFACE)
target_compile_features(flinch_flags INTERFACE cxx_std_20)
target_compile_options(flinch_flags INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror -ffp-contract=off)
if(FLINCH_SANITIZE)
  target_compile_options(flinch_flags INTERFACE
    -fsanitize=${FLINCH_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  target_link_options(flinch_flags INTERFACE -fsanitize=${FLINCH_SANITIZE})
endif()

# What tests are compiled with beside: they wait for the compiler longer than they run.
add_library(flinch_test_flags INTERFACE)
target_compile_options(flinch_test_flags INTERFACE $<$<CONFIG:Release>:-O1>)

# Tests and sanitizer builds precompile the headers that almost every file includes, which saves a
# third of their time; what users build does without, so that a file which forgets an include does
# not compile.
function(flinch_precompiled name)
  file(GENERATE OUTPUT ${PROJECT_BINARY_DIR}/${name}.cpp CONTENT "")
  add_library(${name} STATIC EXCLUDE_FROM_ALL ${PROJECT_BINARY_DIR}/${name}.cpp)
  target_link_libraries(${name} PRIVATE Eigen3::Eigen flinch_flags ${ARGN})
  target_precompile_headers(${name} PRIVATE
    <Eigen/Geometry> <algorithm> <array> <cmath> <memory> <optional> <random> <span> <string> <vector>)
  if(ARGN)
    target_precompile_headers(${name} PRIVATE <gmock/gmock.h>)
  endif()
endfunction()

# flinch_library(NAME SOURCES file... [DEPENDS target...] [PRIVATE_DEPENDS target...])
# A static library, flinch::NAME without its `flinch_`: DEPENDS are what its headers
# need too, PRIVATE_DEPENDS only its sources.
function(flinch_library name)
  cmake_parse_arguments(arg "" "" "SOURCES;DEPENDS;PRIVATE_DEPENDS" ${ARGN})
  add_library(${name} STATIC ${arg_SOURCES})
  string(REGEX REPLACE "^flinch_" "" exported ${name})
  add_library(flinch::${exported} ALIAS ${name})
  target_include_directories(${name} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}> $<INSTALL_INTERFACE:include/flinch>)
  target_compile_features(${name} PUBLIC cxx_std_20)
  set_target_properties(${name} PROPERTIES POSITION_INDEPENDENT_CODE ON EXPORT_NAME ${exported})
  target_link_libraries(${name} PUBLIC ${arg_DEPENDS}
    PRIVATE ${arg_PRIVATE_DEPENDS} $<BUILD_INTERFACE:flinch_flags>)
  set_property(GLOBAL APPEND PROPERTY FLINCH_LIBRARIES ${name})
  # What is compiled for OpenMP cannot use what is not.
  if(FLINCH_SANITIZE AND NOT "OpenMP::OpenMP_CXX" IN_LIST arg_PRIVATE_DEPENDS)
    if(NOT TARGET flinch_precompiled_library)
      flinch_precompiled(flinch_precompiled_library)
      set_target_properties(flinch_precompiled_library PROPERTIES POSITION_INDEPENDENT_CODE ON)
    endif()
    target_precompile_headers(${name} REUSE_FROM flinch_precompiled_library)
  endif()
endfunction()

# flinch_link_closure(VARIABLE TARGET)
# TARGET and all that it links, directly or not, private or public; each once.
function(flinch_link_closure variable target)
  set(closure "")
  set(waiting ${target})
  while(waiting)
    list(POP_FRONT waiting item)
    string(REGEX REPLACE "^\\$<(BUILD_INTERFACE|LINK_ONLY):(.*)>$" "\\2" item "${item}")
    if(item STREQUAL "" OR item IN_LIST closure)
      continue()
    endif()
    list(APPEND closure ${item})
    if(TARGET ${item})
      foreach(property LINK_LIBRARIES INTERFACE_LINK_LIBRARIES)
        get_target_property(links ${item} ${property})
        if(links)
          list(APPEND waiting ${links})
        endif()
      endforeach()
    endif()
  endwhile()
  set(${variable} ${closure} PARENT_SCOPE)
endfunction()

# flinch_schema(TARGET file.fbs)
# Generates the FlatBuffers header `<file>_generated.h` for TARGET's own sources.
function(flinch_schema target schema)
  get_filename_component(stem ${schema} NAME_WE)
  set(directory ${CMAKE_CURRENT_BINARY_DIR}/schema)
  set(header ${directory}/${stem}_generated.h)
  add_custom_command(OUTPUT ${header}
    COMMAND flatbuffers::flatc --cpp --scoped-enums -o ${directory}
            ${CMAKE_CURRENT_SOURCE_DIR}/${schema}
    DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${schema} COMMENT "flatc ${schema}")
  target_sources(${target} PRIVATE ${header})
  # FlatBuffers' headers only: nothing of its library is linked.
  target_include_directories(${target} SYSTEM PRIVATE ${directory}
    $<TARGET_PROPERTY:flatbuffers::flatbuffers,INTERFACE_INCLUDE_DIRECTORIES>)
endfunction()

# flinch_test(NAME SOURCES file... DEPENDS target...)
# A GoogleTest program; every test of it is a CTest test named NAME.Suite.Test. Under sanitizers the
# program is one test: what its tests share is then made once, which takes seconds there.
function(flinch_test name)
  cmake_parse_arguments(arg "" "" "SOURCES;DEPENDS" ${ARGN})
  add_executable(${name} ${arg_SOURCES})
  target_link_libraries(${name} PRIVATE ${arg_DEPENDS} flinch_flags flinch_test_flags GTest::gtest
    GTest::gmock GTest::gtest_main)
  target_compile_definitions(${name} PRIVATE
    FLINCH_SOURCE_DIR="${PROJECT_SOURCE_DIR}" FLINCH_MOCAP_DIR="${PROJECT_SOURCE_DIR}/../shared/mocap")
  if(NOT "OpenMP::OpenMP_CXX" IN_LIST arg_DEPENDS)
    if(NOT TARGET flinch_precompiled_test)
      flinch_precompiled(flinch_precompiled_test flinch_test_flags GTest::gmock)
    endif()
    target_precompile_headers(${name} REUSE_FROM flinch_precompiled_test)
  endif()
  if(FLINCH_SANITIZE)
    add_test(NAME ${name} COMMAND ${name} --gtest_brief=1)
    set_tests_properties(${name} PROPERTIES TIMEOUT 600)
    return()
  endif()
  gtest_discover_tests(${name} TEST_PREFIX ${name}. DISCOVERY_TIMEOUT 60
    PROPERTIES TIMEOUT 600 SKIP_REGULAR_EXPRESSION "\\[  SKIPPED \\]")
endfunction()
