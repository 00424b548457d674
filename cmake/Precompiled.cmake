# Compiles once the headers of the libraries that nearly every source reads: reading them takes longer than compiling
# most sources. The preset `dev` compiles without, which shows includes that are missing.
option(RESTENOSIS_PRECOMPILED_HEADERS "Compile the headers of the libraries once" ON)

if(RESTENOSIS_PRECOMPILED_HEADERS)
  file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/precompiled.cpp CONTENT "")
  add_library(rfPrecompiled STATIC ${CMAKE_BINARY_DIR}/precompiled.cpp)
  target_link_libraries(rfPrecompiled PRIVATE Eigen3::Eigen fmt::fmt OpenMP::OpenMP_CXX)
  target_precompile_headers(rfPrecompiled PRIVATE <Eigen/Dense> <fmt/format.h> <algorithm> <array> <cmath> <filesystem>
    <fstream> <functional> <map> <memory> <optional> <regex> <span> <stdexcept> <string> <vector>)
endif()
if(RESTENOSIS_PRECOMPILED_HEADERS AND RESTENOSIS_TESTS)
  add_library(rfPrecompiledTests STATIC ${CMAKE_BINARY_DIR}/precompiled.cpp)
  target_link_libraries(rfPrecompiledTests PRIVATE Eigen3::Eigen fmt::fmt OpenMP::OpenMP_CXX GTest::gtest)
  target_precompile_headers(rfPrecompiledTests PRIVATE <gtest/gtest.h> <Eigen/Dense> <fmt/format.h> <algorithm> <array>
    <cmath> <filesystem> <fstream> <functional> <map> <memory> <optional> <regex> <span> <stdexcept> <string> <vector>)
endif()

# restenosis_precompiled(TARGET FROM): TARGET reads the headers compiled for FROM (rfPrecompiled or rfPrecompiledTests).
function(restenosis_precompiled TARGET FROM)
  if(RESTENOSIS_PRECOMPILED_HEADERS)
    target_link_libraries(${TARGET} PRIVATE OpenMP::OpenMP_CXX)  # the flags must be those the headers were compiled with
    target_precompile_headers(${TARGET} REUSE_FROM ${FROM})
  endif()
endfunction()
