# Language level, warnings, optimisation and sanitizers, the same for every component.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release)
endif()

# No -ffast-math: results must not depend on how loops were reassociated, and NaN checks must work.
# -fno-math-errno and -fno-trapping-math let square roots vectorise and change no result.
add_compile_options(-Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -march=${RESTENOSIS_PROCESSOR} -fno-math-errno
                    -fno-trapping-math)
# Vectors wider than the processor's registers are passed between functions of one build only.
add_compile_options(-Wno-psabi)
if(RESTENOSIS_WARNINGS_AS_ERRORS)
  add_compile_options(-Werror)
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
  # GCC 12 takes the fill of a fmt 9 format, four bytes, for overrun once its parser is inlined; the sanitized build
  # checks the same at run time.
  add_compile_options(-Wno-stringop-overflow)
  if(RESTENOSIS_WARNINGS_AS_ERRORS)
    # GCC 12 takes the undefined operands of its own AVX-512 intrinsics, which Eigen uses, for uninitialised (GCC
    # bug 105593): of these it may warn.
    add_compile_options(-Wno-error=uninitialized -Wno-error=maybe-uninitialized)
    # It takes inlined concatenations of strings for accesses out of bounds, by the processor that it compiles for (GCC
    # bug 105651): of these too.
    add_compile_options(-Wno-error=array-bounds -Wno-error=restrict -Wno-error=stringop-overread)
  endif()
endif()
if(RESTENOSIS_SANITIZE)
  add_compile_options(-fsanitize=${RESTENOSIS_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  if(CMAKE_CXX_COMPILER_ID STREQUAL Clang)
    add_compile_options(-Wno-pass-failed)  # loops that are instrumented are not vectorised
  endif()
  if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
    # GCC's flow analysis does not see through the instrumentation: it takes the standard library's own members for
    # uninitialised. The same code is checked for them in the builds without sanitizers.
    add_compile_options(-Wno-maybe-uninitialized)
  endif()
  add_link_options(-fsanitize=${RESTENOSIS_SANITIZE})
endif()
if(RESTENOSIS_FUZZ)
  add_compile_options(-fsanitize=fuzzer-no-link)
endif()
set(CMAKE_CXX_FLAGS_RELEASE "-O3")
