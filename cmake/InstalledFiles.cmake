# SPDX-License-Identifier: BSD-3-Clause
# Installs the files other than programs and libraries: ledgers, recipes, tables and scenes, which
# the program finds by their names (src/edgeproof/cli/installed.cpp); the documents; the manual
# pages that the program itself writes; completions.
set(data_folder ${CMAKE_INSTALL_DATADIR}/edgeproof)
cmake_path(RELATIVE_PATH CMAKE_INSTALL_FULL_DATADIR BASE_DIRECTORY ${CMAKE_INSTALL_FULL_BINDIR}
    OUTPUT_VARIABLE data_from_program)
set_property(SOURCE src/edgeproof/cli/installed.cpp APPEND PROPERTY
    COMPILE_DEFINITIONS "EDGEPROOF_DATA_FOLDER=\"${data_from_program}/edgeproof\"")

foreach(folder verify reference examples)
    install(DIRECTORY ${folder} DESTINATION ${data_folder} COMPONENT program
        USE_SOURCE_PERMISSIONS
        PATTERN "__pycache__" EXCLUDE PATTERN "third-party/solvers" EXCLUDE)
endforeach()
install(DIRECTORY share/edgeproof/schemas DESTINATION ${data_folder} COMPONENT program)
foreach(file README.md CHANGELOG.md CONTRIBUTING.md LICENSE CITATION.cff)
    install(FILES ${file} DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT documentation)
endforeach()
install(DIRECTORY docs DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT documentation
    PATTERN Doxyfile EXCLUDE PATTERN pages.css EXCLUDE)
# A script in Python with the page that describes it: the program's package does not need Python.
install(DIRECTORY examples/third-party/solvers
    DESTINATION ${CMAKE_INSTALL_DOCDIR}/examples/third-party COMPONENT documentation
    USE_SOURCE_PERMISSIONS PATTERN "__pycache__" EXCLUDE)
# The pages to which the documents link.
foreach(page examples/README.md examples/third-party/README.md verify/README.md reference/README.md
        bench/README.md)
    cmake_path(GET page PARENT_PATH folder)
    install(FILES ${page} DESTINATION ${CMAKE_INSTALL_DOCDIR}/${folder} COMPONENT documentation)
endforeach()

if(PROJECT_IS_TOP_LEVEL AND TARGET edgeproof)
    # The program in the build folder finds these files in the source folder.
    cmake_path(APPEND CMAKE_RUNTIME_OUTPUT_DIRECTORY ${data_from_program} edgeproof
        OUTPUT_VARIABLE data_in_build)
    cmake_path(NORMAL_PATH data_in_build)
    file(MAKE_DIRECTORY ${data_in_build})
    foreach(folder verify reference examples)
        file(CREATE_LINK ${PROJECT_SOURCE_DIR}/${folder} ${data_in_build}/${folder} SYMBOLIC)
    endforeach()
    file(CREATE_LINK ${PROJECT_SOURCE_DIR}/share/edgeproof/schemas ${data_in_build}/schemas SYMBOLIC)

    set(manual ${PROJECT_BINARY_DIR}/manual)
    find_program(GZIP_PROGRAM gzip)
    mark_as_advanced(GZIP_PROGRAM)
    set(compress)
    if(GZIP_PROGRAM)
        set(compress COMMAND sh -c "gzip -9nf ${manual}/man1/*.1")
    endif()
    add_custom_command(OUTPUT ${manual}/made
        COMMAND ${CMAKE_COMMAND} -E rm -rf ${manual}
        # FLINT keeps memory until the end (tests/lsan.supp, which is not set in a build).
        COMMAND ${CMAKE_COMMAND} -E env ASAN_OPTIONS=detect_leaks=0
                $<TARGET_FILE:edgeproof> --write-manual ${manual}
        ${compress}
        COMMAND ${CMAKE_COMMAND} -E touch ${manual}/made
        DEPENDS edgeproof VERBATIM COMMENT "Manual pages")
    add_custom_target(edgeproof_manual ALL DEPENDS ${manual}/made)
    install(DIRECTORY ${manual}/man1 DESTINATION ${CMAKE_INSTALL_MANDIR} COMPONENT program
        OPTIONAL)
    install(FILES share/edgeproof/completions/edgeproof.bash
        DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME edgeproof
        COMPONENT program OPTIONAL)
    install(FILES share/edgeproof/completions/_edgeproof
        DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions
        COMPONENT program OPTIONAL)
    install(FILES share/edgeproof/completions/edgeproof.fish
        DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d COMPONENT program
        OPTIONAL)
endif()
