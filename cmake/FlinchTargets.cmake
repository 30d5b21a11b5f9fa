# SPDX-License-Identifier: MIT
# How every target of the project is made, so that flags stand in one place.
include(CheckCXXSourceCompiles)

# Flags that all of our code is compiled with. No fused multiply-add and no
# -ffast-math: results must be the same bits everywhere. Warnings are errors
# where CMAKE_COMPILE_WARNING_AS_ERROR is set, as by .ci/run: what another
# compiler warns of must not stop a user.
add_library(flinch_flags INTERFACE)
target_compile_features(flinch_flags INTERFACE cxx_std_20)
target_compile_options(flinch_flags INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -ffp-contract=off)
if(NOT FLINCH_WASM)  # which has no shared libraries
  # No one replaces a library's functions: they may be inlined.
  target_compile_options(flinch_flags INTERFACE -fno-semantic-interposition)
endif()
# Eigen fuses products and sums where it sees that the processor can, whatever the flags above say.
# With AVX-512 it insists, and results differ.
check_cxx_source_compiles("
  #if !defined(__FMA__) || defined(__AVX512F__)
  #error Eigen does not fuse, or insists
  #endif
  int main() {}" FLINCH_EIGEN_FUSES)
if(FLINCH_EIGEN_FUSES)
  target_compile_options(flinch_flags INTERFACE -U__FMA__)
endif()
if(FLINCH_SANITIZE)
  target_compile_options(flinch_flags INTERFACE
    -fsanitize=${FLINCH_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  if(FLINCH_SANITIZE MATCHES address)  # which finds these as well; they keep the compiler long
    target_compile_options(flinch_flags INTERFACE -fno-sanitize=null,object-size)
  endif()
  target_link_options(flinch_flags INTERFACE -fsanitize=${FLINCH_SANITIZE})
elseif(NOT FLINCH_WASM AND NOT WIN32)  # sanitizers find more than these, and the two do not mix; WebAssembly has its own, and for Windows they need a library beside the game
  target_compile_options(flinch_flags INTERFACE -fstack-protector-strong
    $<$<NOT:$<CONFIG:Debug>>:-U_FORTIFY_SOURCE;-D_FORTIFY_SOURCE=2>)  # needs an optimizing compiler
endif()

# What tests are compiled with beside: they wait for the compiler longer than they run.
add_library(flinch_test_flags INTERFACE)
target_compile_options(flinch_test_flags INTERFACE $<$<CONFIG:Release>:-O1>)
if(FLINCH_SANITIZE)
  target_compile_definitions(flinch_test_flags INTERFACE FLINCH_SANITIZED)
endif()

# flinch_precompile(TARGET KIND [dependency...])
# Precompiles for TARGET the headers that almost every file includes, which halves the compiler's
# time: once for all targets of a KIND (library, test, program), which are compiled alike, and once
# more for those of a kind that depend on OpenMP.
function(flinch_precompile target kind)
  set(precompiled flinch_precompiled_${kind})
  set(links Eigen3::Eigen flinch_flags)
  set(headers <Eigen/Geometry> <algorithm> <array> <cmath> <memory> <optional> <random> <span>
    <string> <vector>)
  if(kind STREQUAL test)
    list(APPEND links flinch_test_flags GTest::gmock)
    list(APPEND headers <gmock/gmock.h>)
  endif()
  if("OpenMP::OpenMP_CXX" IN_LIST ARGN)
    string(APPEND precompiled _openmp)
    list(APPEND links OpenMP::OpenMP_CXX)
  endif()
  if(NOT TARGET ${precompiled})
    file(GENERATE OUTPUT ${PROJECT_BINARY_DIR}/${precompiled}.cpp CONTENT "")
    add_library(${precompiled} STATIC EXCLUDE_FROM_ALL ${PROJECT_BINARY_DIR}/${precompiled}.cpp)
    target_link_libraries(${precompiled} PRIVATE ${links})
    target_precompile_headers(${precompiled} PRIVATE ${headers})
    get_target_property(independent ${target} POSITION_INDEPENDENT_CODE)
    if(independent)
      set_target_properties(${precompiled} PROPERTIES POSITION_INDEPENDENT_CODE ON)
    endif()
  endif()
  target_precompile_headers(${target} REUSE_FROM ${precompiled})
endfunction()

# flinch_unite(TARGET)
# Compiles up to eight source files of TARGET as one, in batches of equal size, so that the compiler
# reads what they include and instantiates what they share once. The preset `debug` does not: it
# finds includes that a file forgot.
function(flinch_unite target)
  get_target_property(sources ${target} SOURCES)
  list(FILTER sources INCLUDE REGEX "\\.cpp$")
  list(LENGTH sources count)
  math(EXPR batches "(${count} + 7) / 8")
  if(NOT FLINCH_UNITY_BUILD OR count LESS 2)
    return()
  endif()
  math(EXPR size "(${count} + ${batches} - 1) / ${batches}")
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${size})
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
  set_target_properties(${name} PROPERTIES EXPORT_NAME ${exported})
  if(NOT FLINCH_WASM)  # which has no shared libraries
    set_target_properties(${name} PROPERTIES POSITION_INDEPENDENT_CODE ON)
  endif()
  target_link_libraries(${name} PUBLIC ${arg_DEPENDS}
    PRIVATE ${arg_PRIVATE_DEPENDS} $<BUILD_INTERFACE:flinch_flags>)
  set_property(GLOBAL APPEND PROPERTY FLINCH_LIBRARIES ${name})
  flinch_precompile(${name} library ${arg_DEPENDS} ${arg_PRIVATE_DEPENDS})
  flinch_unite(${name})
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
  flinch_use_schema(${target} ${target})
endfunction()

# flinch_use_schema(TARGET OWNER)
# Lets TARGET's own sources include the header that flinch_schema generates for OWNER.
function(flinch_use_schema target owner)
  get_target_property(binary_directory ${owner} BINARY_DIR)
  # FlatBuffers' headers only: nothing of its library is linked.
  target_include_directories(${target} SYSTEM PRIVATE ${binary_directory}/schema
    $<TARGET_PROPERTY:flatbuffers::flatbuffers,INTERFACE_INCLUDE_DIRECTORIES>)
endfunction()

# flinch_embed(TARGET FOLDER VARIABLE file...)
# Generates the header `<FOLDER>_embedded.h` for TARGET's own sources: VARIABLE, an array of the texts
# of these files of FOLDER.
function(flinch_embed target folder variable)
  set(texts "")
  foreach(file IN LISTS ARGN)
    set(path ${CMAKE_CURRENT_SOURCE_DIR}/${folder}/${file})
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${path})
    file(READ ${path} text)
    string(APPEND texts "R\"file(${text})file\",\n")
  endforeach()
  set(directory ${CMAKE_CURRENT_BINARY_DIR}/embedded)
  file(GENERATE OUTPUT ${directory}/${folder}_embedded.h CONTENT
    "#pragma once\n#include <string_view>\ninline constexpr std::string_view ${variable}[]{\n${texts}};\n")
  target_include_directories(${target} PRIVATE ${directory})
endfunction()

# flinch_test(NAME SOURCES file... DEPENDS target... [LONG])
# A GoogleTest program; every test of it is a CTest test named NAME.Suite.Test. Under sanitizers the
# program is one test: what its tests share is then made once, which takes seconds there. LONG says
# that it is among the longest there and should start first.
function(flinch_test name)
  cmake_parse_arguments(arg "LONG" "" "SOURCES;DEPENDS" ${ARGN})
  add_executable(${name} ${arg_SOURCES})
  target_link_libraries(${name} PRIVATE ${arg_DEPENDS} flinch_flags flinch_test_flags GTest::gtest
    GTest::gmock GTest::gtest_main)
  target_compile_definitions(${name} PRIVATE
    FLINCH_SOURCE_DIR="${PROJECT_SOURCE_DIR}" FLINCH_MOCAP_DIR="${PROJECT_SOURCE_DIR}/../shared/mocap")
  flinch_precompile(${name} test ${arg_DEPENDS})
  flinch_unite(${name})
  if(FLINCH_SANITIZE)
    add_test(NAME ${name} COMMAND ${name} --gtest_brief=1)
    if(arg_LONG)
      set_tests_properties(${name} PROPERTIES COST 100)
    endif()
    return()
  endif()
  gtest_discover_tests(${name} TEST_PREFIX ${name}. DISCOVERY_TIMEOUT 60
    PROPERTIES TIMEOUT 600 SKIP_REGULAR_EXPRESSION "\\[  SKIPPED \\]")
endfunction()
