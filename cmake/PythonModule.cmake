# SPDX-License-Identifier: BSD-3-Clause
# The Python package edgeproof, built if Python's headers and pybind11 are found: the module
# edgeproof._edgeproof of src/edgeproof/python, together with the sources of python/edgeproof. The
# build makes the whole package in <build>/python. This file is included before the modules are
# added, because it decides that their objects must fit into a shared library; afterwards,
# edgeproof_python_module() adds the module.
option(EDGEPROOF_PYTHON "Build the Python module (where Python's headers and pybind11 are)"
    ${PROJECT_IS_TOP_LEVEL})
option(EDGEPROOF_PYTHON_REQUIRED "Fail if the Python module cannot be built" OFF)
# The system's Python, which has the system's packages numpy and pytest, even if a version manager
# or a virtual environment has put another one before it.
if(EXISTS /usr/bin/python3)
    set(system_python /usr/bin/python3)
endif()
set(EDGEPROOF_PYTHON_EXECUTABLE "${system_python}" CACHE FILEPATH
    "The Python to build for and to test with (empty: the one that CMake finds)")
if(EDGEPROOF_PYTHON_EXECUTABLE)
    set(Python3_EXECUTABLE ${EDGEPROOF_PYTHON_EXECUTABLE})
endif()
set(Python3_FIND_VIRTUALENV STANDARD)

set(EDGEPROOF_PYTHON_BUILT FALSE)
# The sanitizers would need a Python that was built with them.
if(EDGEPROOF_PYTHON AND NOT EDGEPROOF_SANITIZE AND NOT EDGEPROOF_FUZZ)
    find_package(Python3 3.11 QUIET COMPONENTS Interpreter Development.Module)
    find_path(PYBIND11_INCLUDE_DIR pybind11/pybind11.h)
    mark_as_advanced(PYBIND11_INCLUDE_DIR)
    set(pybind11 0)
    if(PYBIND11_INCLUDE_DIR)
        file(STRINGS ${PYBIND11_INCLUDE_DIR}/pybind11/detail/common.h pybind11
            REGEX "define PYBIND11_VERSION_(MAJOR|MINOR) ")
        list(TRANSFORM pybind11 REPLACE ".* " "")
        list(JOIN pybind11 "." pybind11)
    endif()
    if(NOT Python3_Development.Module_FOUND OR NOT PYBIND11_INCLUDE_DIR)
        set(problem "no pybind11, or no headers of Python 3.11 or later (${Python3_EXECUTABLE})")
    elseif(Python3_VERSION VERSION_GREATER_EQUAL 3.12 AND pybind11 VERSION_LESS 2.11)
        set(problem "pybind11 ${pybind11} does not support Python ${Python3_VERSION}")
    else()
        set(EDGEPROOF_PYTHON_BUILT TRUE)
    endif()
    if(NOT EDGEPROOF_PYTHON_BUILT AND EDGEPROOF_PYTHON_REQUIRED)
        message(FATAL_ERROR "The Python module cannot be built: ${problem}. Install Debian's "
            "python3-dev and pybind11-dev and use /usr/bin/python3, or give another Python by "
            "-DEDGEPROOF_PYTHON_EXECUTABLE=...")
    elseif(NOT EDGEPROOF_PYTHON_BUILT)
        message(STATUS "No Python module: ${problem}")
    endif()
endif()
set(EDGEPROOF_PYTHON_FOLDER ${PROJECT_BINARY_DIR}/python)

function(edgeproof_python_module)
    file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/edgeproof/python/*.cpp)
    Python3_add_library(edgeproof_python MODULE WITH_SOABI ${sources})
    edgeproof_own_flags(edgeproof_python QUICK)
    if(EDGEPROOF_UNITY)
        # One unit: pybind11's headers take longer than the sources.
        set_target_properties(edgeproof_python PROPERTIES UNITY_BUILD_BATCH_SIZE 6)
    endif()
    set_target_properties(edgeproof_python PROPERTIES OUTPUT_NAME _edgeproof
        CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON DISABLE_PRECOMPILE_HEADERS ON
        LIBRARY_OUTPUT_DIRECTORY ${EDGEPROOF_PYTHON_FOLDER}/edgeproof)
    target_include_directories(edgeproof_python SYSTEM PRIVATE ${PYBIND11_INCLUDE_DIR})
    target_compile_definitions(edgeproof_python PRIVATE EDGEPROOF_VERSION="${PROJECT_VERSION}")
    target_link_libraries(edgeproof_python PRIVATE edgeproof::interface)
    # The libraries are static; their symbols stay inside this module.
    target_link_options(edgeproof_python PRIVATE -Wl,--exclude-libs,ALL)
    add_dependencies(edgeproof_python include_order)

    file(GLOB package CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/python/edgeproof/*.py
        ${PROJECT_SOURCE_DIR}/python/edgeproof/*.pyi ${PROJECT_SOURCE_DIR}/python/edgeproof/py.typed)
    set(copies)
    foreach(file IN LISTS package)
        cmake_path(GET file FILENAME name)
        set(copy ${EDGEPROOF_PYTHON_FOLDER}/edgeproof/${name})
        add_custom_command(OUTPUT ${copy}
            COMMAND ${CMAKE_COMMAND} -E copy ${file} ${copy} DEPENDS ${file} VERBATIM)
        list(APPEND copies ${copy})
    endforeach()
    # Install to a folder that Python searches by default: Debian's folder below /usr and
    # /usr/local, the user's own below ~/.local. Other folders must be named by PYTHONPATH or a .pth
    # file. The prefix is known only at installation.
    install(CODE "set(EDGEPROOF_PYTHON_EXECUTABLE ${Python3_EXECUTABLE})" COMPONENT python)
    install(CODE [[
        execute_process(COMMAND "${EDGEPROOF_PYTHON_EXECUTABLE}" -I -c "import site, sys
prefix = sys.argv[1].rstrip('/')
version = 'python%d.%d' % sys.version_info[:2]
print('lib/python3/dist-packages' if prefix == '/usr' else
      'lib/%s/dist-packages' % version if prefix == '/usr/local' else
      'lib/%s/site-packages' % version if prefix == site.getuserbase() else
      'lib/python3/dist-packages')" "${CMAKE_INSTALL_PREFIX}"
            OUTPUT_VARIABLE edgeproof_python_folder OUTPUT_STRIP_TRAILING_WHITESPACE
            COMMAND_ERROR_IS_FATAL ANY)]] COMPONENT python)
    install(TARGETS edgeproof_python LIBRARY
        DESTINATION "\${edgeproof_python_folder}/edgeproof" COMPONENT python)
    install(FILES ${package} DESTINATION "\${edgeproof_python_folder}/edgeproof" COMPONENT python)

    add_custom_target(edgeproof_python_package ALL DEPENDS ${copies} edgeproof_python)

    # The loop with which bench/python/run compares the module.
    add_executable(pressures_loop EXCLUDE_FROM_ALL ${PROJECT_SOURCE_DIR}/bench/python/pressures_loop.cpp)
    edgeproof_own_flags(pressures_loop)
    target_link_libraries(pressures_loop PRIVATE edgeproof::scene)
endfunction()
