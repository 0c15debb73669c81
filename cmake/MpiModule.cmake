# SPDX-License-Identifier: GPL-3.0-or-later
# edgeproof_mpi: the only part of Edgeproof that uses MPI (src/edgeproof/mpi), built if MPI is
# found. The program loads it from EDGEPROOF_MPI_MODULE, a path relative to the program's folder,
# which is the same in the build and after installation. The sanitizers report faults in MPI itself,
# so that their builds do not have it.
set(module_definition "")
if(EDGEPROOF_MPI AND NOT EDGEPROOF_SANITIZE)
    find_package(MPI QUIET COMPONENTS CXX)
endif()
if(MPI_CXX_FOUND AND EDGEPROOF_MPI AND NOT EDGEPROOF_SANITIZE)
    add_library(edgeproof_mpi MODULE src/edgeproof/mpi/mpi_processes.cpp)
    edgeproof_own_flags(edgeproof_mpi)
    set_target_properties(edgeproof_mpi PROPERTIES PREFIX "" DISABLE_PRECOMPILE_HEADERS ON)
    target_include_directories(edgeproof_mpi PRIVATE ${PROJECT_SOURCE_DIR}/src)
    target_link_libraries(edgeproof_mpi PRIVATE MPI::MPI_CXX)
    cmake_path(RELATIVE_PATH CMAKE_INSTALL_FULL_LIBDIR BASE_DIRECTORY ${CMAKE_INSTALL_FULL_BINDIR}
        OUTPUT_VARIABLE libraries)
    # Not directly below a folder of libraries: it is no library for others, and a package of it
    # needs no ldconfig.
    cmake_path(APPEND libraries edgeproof mpi)
    set(module_definition ${libraries}/edgeproof_mpi.so)
    if(CMAKE_RUNTIME_OUTPUT_DIRECTORY)
        set_target_properties(edgeproof_mpi PROPERTIES
            LIBRARY_OUTPUT_DIRECTORY ${CMAKE_RUNTIME_OUTPUT_DIRECTORY}/${libraries})
    endif()
    install(TARGETS edgeproof_mpi LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/edgeproof/mpi
        COMPONENT mpi)
else()
    message(STATUS "No MPI: edgeproof table runs on one machine")
endif()
set_property(SOURCE src/edgeproof/cli/installed.cpp APPEND PROPERTY
    COMPILE_DEFINITIONS "EDGEPROOF_MPI_MODULE=\"${module_definition}\"")
target_link_libraries(edgeproof_cli PRIVATE ${CMAKE_DL_LIBS})
