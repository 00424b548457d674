# What `cmake --install` puts where, and the same places in the build tree, as links into the sources: the program finds
# its data from its own place (bridge/system/DataFolder.h).
set(dataFolder ${CMAKE_INSTALL_DATADIR}/restenosisFoam)
install(TARGETS restenosisFoam RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(FILES ${PROJECT_SOURCE_DIR}/docs/restenosisFoam.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(FILES ${PROJECT_SOURCE_DIR}/cmake/bashCompletion RENAME restenosisFoam
        DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
install(FILES README.md CHANGELOG.md CITATION.cff DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(FILES LICENSE RENAME copyright DESTINATION ${CMAKE_INSTALL_DOCDIR})

# restenosis_data(FOLDER [PATTERN ... EXCLUDE]...): a folder of the sources, with all that is in it but the patterns.
function(restenosis_data FOLDER)
  cmake_path(GET FOLDER FILENAME name)
  file(MAKE_DIRECTORY ${CMAKE_BINARY_DIR}/share/restenosisFoam)
  file(CREATE_LINK ${PROJECT_SOURCE_DIR}/${FOLDER} ${CMAKE_BINARY_DIR}/share/restenosisFoam/${name} SYMBOLIC)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/${FOLDER} DESTINATION ${dataFolder} USE_SOURCE_PERMISSIONS
          PATTERN __pycache__ EXCLUDE PATTERN .gitignore EXCLUDE ${ARGN})
endfunction()

# What a run by hand leaves in the template is none of it (foamCase/.gitignore).
restenosis_data(foamCase REGEX "/foamCase/(0|[1-9][0-9.]*|postProcessing|log\\..*|case\\.foam)$" EXCLUDE
                REGEX "/constant/(triSurface|polyMesh)$" EXCLUDE)
restenosis_data(bridge/output/figures)
restenosis_data(scenes)
restenosis_data(studies PATTERN seeds.sbatch EXCLUDE)
