#pragma once

#include <gtest/gtest.h>

#include "bridge/system/ExternalProgram.h"

/// Skips the test where OpenFOAM is not installed.
#define RESTENOSIS_NEEDS_OPENFOAM()                                        \
  try {                                                                    \
    ::restenosis::ExternalProgram("simpleFoam");                           \
  } catch (const ::restenosis::ProgramMissing&) {                          \
    GTEST_SKIP() << "OpenFOAM is not installed (Debian package openfoam)"; \
  }                                                                        \
  static_assert(true)
