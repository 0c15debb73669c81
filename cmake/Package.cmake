# SPDX-License-Identifier: BSD-3-Clause
# `cpack -G DEB` in the build folder makes edgeproof (the program, its manual pages and the files that
# it finds by name),
# libedgeproof-dev, python3-edgeproof (if it was built) and edgeproof-doc. The dependencies are those
# of the Debian on which it runs.
set(EDGEPROOF_MAINTAINER "" CACHE STRING
    "Name <address> in the Debian packages (empty: DEBFULLNAME and DEBEMAIL of the environment)")
set(maintainer "${EDGEPROOF_MAINTAINER}")
if(NOT maintainer AND DEFINED ENV{DEBFULLNAME} AND DEFINED ENV{DEBEMAIL})
    set(maintainer "$ENV{DEBFULLNAME} <$ENV{DEBEMAIL}>")
endif()
if(NOT maintainer) # packages for local use
    set(maintainer "built locally <nobody@edgeproof.invalid>")
elseif(NOT maintainer MATCHES "^[^<>]+ <[^<> ]+@[^<> ]+>$")
    message(FATAL_ERROR "the maintainer of the Debian packages is '${maintainer}'; write "
        "-DEDGEPROOF_MAINTAINER=\"Name <address>\", or set DEBFULLNAME and DEBEMAIL")
endif()
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME edgeproof)
set(CPACK_PACKAGE_VENDOR "The Edgeproof contributors")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "contact pressures near an edge, to any number of digits, with bounds")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL program development documentation)
if(EDGEPROOF_PYTHON_BUILT)
    list(APPEND CPACK_COMPONENTS_ALL python)
endif()
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION math)
set(CPACK_DEBIAN_PACKAGE_MAINTAINER "${maintainer}")
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION TRUE)

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME edgeproof)
set(CPACK_DEBIAN_PROGRAM_DESCRIPTION "The program. It computes the pressure and the edge expansions of an incomplete
contact to any number of digits, each value with an error bound, and holds
printed formulas, tables and other programs against them.")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS "librsvg2-bin, edgeproof-doc")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS "python3-edgeproof")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libedgeproof-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION "Headers, static libraries and the CMake package: contacts, scenes, audits of
printed formulas and checks of other programs, for C++.")
set(needed "libboost1.81-dev | libboost-dev (>= 1.81)" libgmp-dev libmpfr-dev libflint-dev
    libtomlplusplus-dev nlohmann-json3-dev libfmt-dev libtbb-dev libcli11-dev)
if(FLINT_ARB_LIBRARY)
    list(APPEND needed libflint-arb-dev)
endif()
list(JOIN needed ", " CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS)

set(CPACK_DEBIAN_DOCUMENTATION_PACKAGE_NAME edgeproof-doc)
set(CPACK_DEBIAN_DOCUMENTATION_PACKAGE_SECTION doc)
set(CPACK_DEBIAN_DOCUMENTATION_PACKAGE_ARCHITECTURE all)
set(CPACK_DEBIAN_DOCUMENTATION_DESCRIPTION "The documents: how to use the program and the Python module, the mechanics,
the formats of files and the API for C++.")

set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-edgeproof)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_DESCRIPTION "The Python module: scenes, values with bounds, audits of printed formulas and
checks of other programs as Python objects.")
set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS ON)
math(EXPR after "${Python3_VERSION_MINOR} + 1")
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
    "python3 (>= 3.${Python3_VERSION_MINOR}~), python3 (<< 3.${after}), python3-numpy")
set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS "edgeproof")
set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "python3-matplotlib, python3-mpmath")

# Files that Debian requires in every package; `cmake --install` does not install them.
set(debian ${PROJECT_BINARY_DIR}/debian)
file(WRITE ${debian}/changelog "edgeproof (${PROJECT_VERSION}) unstable; urgency=medium

  * Version ${PROJECT_VERSION}: CHANGELOG.md says what is new.

 -- ${CPACK_DEBIAN_PACKAGE_MAINTAINER}  Thu, 01 Oct 2026 12:00:00 +0000
")
find_program(GZIP_PROGRAM gzip)
if(GZIP_PROGRAM)
    execute_process(COMMAND ${GZIP_PROGRAM} -9nf ${debian}/changelog)
endif()
foreach(component IN LISTS CPACK_COMPONENTS_ALL)
    string(TOUPPER ${component} key)
    set(folder ${CMAKE_INSTALL_DATADIR}/doc/${CPACK_DEBIAN_${key}_PACKAGE_NAME})
    install(FILES ${PROJECT_SOURCE_DIR}/cmake/debian-copyright DESTINATION ${folder}
        RENAME copyright COMPONENT ${component} EXCLUDE_FROM_ALL)
    install(FILES ${debian}/changelog.gz DESTINATION ${folder} COMPONENT ${component}
        EXCLUDE_FROM_ALL OPTIONAL)
endforeach()

include(CPack)
