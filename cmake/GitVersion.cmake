# Run at every build: cmake -DSOURCE=... -DFALLBACK=... -DOUTPUT=... -P GitVersion.cmake
# Writes the C++ source of restenosis::version(), touching it only when the version has changed.
set(version "")
find_program(GIT git)
if(GIT)
  execute_process(COMMAND ${GIT} -C ${SOURCE} describe --tags --always --dirty
                  OUTPUT_VARIABLE version OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
endif()
if(version STREQUAL "")
  set(version ${FALLBACK})
endif()
set(text "#include \"bridge/output/Version.h\"\n\nstd::string_view restenosis::version() { return \"${version}\"; }\n")
set(present "")
if(EXISTS ${OUTPUT})
  file(READ ${OUTPUT} present)
endif()
if(NOT present STREQUAL text)
  file(WRITE ${OUTPUT} "${text}")
endif()
