# Compiles once the headers of the libraries that nearly every source reads, and eight sources of a component at a
# time: reading headers and making the templates they share takes longer than compiling most sources. What sources of
# one component name for themselves must therefore differ. The preset `dev` compiles each by itself and without, which
# shows includes that are missing.
option(RESTENOSIS_PRECOMPILED_HEADERS "Compile the headers of the libraries once, and several sources at a time" ON)
if(NOT DEFINED CMAKE_UNITY_BUILD)
  set(CMAKE_UNITY_BUILD ${RESTENOSIS_PRECOMPILED_HEADERS})
  set(CMAKE_UNITY_BUILD_BATCH_SIZE 8)
endif()

# precompiled_headers(NAME HEADERS... LIBRARIES...): a library whose sources' common headers others reuse.
function(precompiled_headers NAME)
  cmake_parse_arguments(ARG "" "" "HEADERS;LIBRARIES" ${ARGN})
  add_library(${NAME} STATIC ${CMAKE_BINARY_DIR}/precompiled.cpp)
  target_link_libraries(${NAME} PRIVATE Eigen3::Eigen fmt::fmt OpenMP::OpenMP_CXX ${ARG_LIBRARIES})
  target_precompile_headers(${NAME} PRIVATE ${ARG_HEADERS} <Eigen/Dense> <fmt/format.h> <algorithm> <array> <cmath>
    <filesystem> <fstream> <functional> <map> <memory> <optional> <regex> <span> <stdexcept> <string> <vector>)
endfunction()

# Tests are half of what is compiled, and what takes their time is compiled elsewhere: they are optimised less, which is
# faster in sum.
set(RESTENOSIS_TEST_OPTIONS $<$<CONFIG:Release>:-O1>)

if(RESTENOSIS_PRECOMPILED_HEADERS)
  file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/precompiled.cpp CONTENT "")
  precompiled_headers(rfPrecompiled)
  if(RESTENOSIS_TESTS)
    precompiled_headers(rfPrecompiledTests HEADERS <gtest/gtest.h> LIBRARIES GTest::gtest)
    target_compile_options(rfPrecompiledTests PRIVATE ${RESTENOSIS_TEST_OPTIONS})
  endif()
endif()

# restenosis_precompiled(TARGET FROM): TARGET reads the headers compiled for FROM, a library of precompiled_headers.
function(restenosis_precompiled TARGET FROM)
  if(RESTENOSIS_PRECOMPILED_HEADERS)
    # The flags must be those that the headers were compiled with, and clang looks the headers up again.
    target_link_libraries(${TARGET} PRIVATE Eigen3::Eigen fmt::fmt OpenMP::OpenMP_CXX)
    target_precompile_headers(${TARGET} REUSE_FROM ${FROM})
  endif()
endfunction()
