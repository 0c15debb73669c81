# SPDX-License-Identifier: BSD-3-Clause
# cmake -D BUILD=<build> -D WORK=<scratch> -D PYTHON=<python3, or empty>
#       -P packages.cmake
# Makes the Debian packages of a build, checks them with lintian if it is installed, unpacks them
# together, and runs their programs.
function(run)
    execute_process(COMMAND ${ARGN} OUTPUT_VARIABLE output ERROR_VARIABLE output
        RESULT_VARIABLE status WORKING_DIRECTORY ${WORK})
    if(status)
        list(JOIN ARGN " " command)
        message(FATAL_ERROR "${command}: ${status}\n${output}")
    endif()
    set(output "${output}" PARENT_SCOPE)
endfunction()
function(expect text)
    string(FIND "${output}" "${text}" found)
    if(found EQUAL -1)
        message(FATAL_ERROR "no '${text}' in\n${output}")
    endif()
endfunction()

file(REMOVE_RECURSE ${WORK})
file(MAKE_DIRECTORY ${WORK}/root)
run(${CMAKE_CPACK_COMMAND} -G DEB --config ${BUILD}/CPackConfig.cmake -B ${WORK}/packages)
file(GLOB packages ${WORK}/packages/*.deb)
set(expected edgeproof_ libedgeproof-dev_ edgeproof-doc_)
if(PYTHON)
    list(APPEND expected python3-edgeproof_)
endif()
list(LENGTH packages count)
list(LENGTH expected wanted)
if(NOT count EQUAL wanted)
    message(FATAL_ERROR "${count} packages: ${packages}")
endif()
foreach(name IN LISTS expected)
    if(NOT "${packages}" MATCHES "/${name}[0-9.]+_(all|[a-z0-9]+)\\.deb")
        message(FATAL_ERROR "no package ${name}: ${packages}")
    endif()
endforeach()
foreach(package IN LISTS packages)
    run(dpkg-deb -x ${package} root)
endforeach()

# What each package contains and needs.
foreach(package IN LISTS packages)
    cmake_path(GET package FILENAME name)
    string(REGEX REPLACE "_.*" "" name ${name})
    run(dpkg-deb -c ${package})
    set(contents "${output}")
    run(dpkg-deb -f ${package} Depends)
    set(depends "${output}")
    run(dpkg-deb -I ${package})
    if(output MATCHES "postinst|postrm|triggers")
        message(FATAL_ERROR "${name} has a maintainer script or a trigger")
    endif()
    foreach(file "/usr/bin/edgeproof\n" "/man1/edgeproof-verify.1" "bash-completion" "vendor-completions"
            "vendor_completions.d")
        string(FIND "${contents}" "${file}" found)
        if((name STREQUAL "edgeproof") STREQUAL (found EQUAL -1))
            message(FATAL_ERROR "${name} and '${file}': all of the program belongs to edgeproof")
        endif()
    endforeach()
endforeach()

# Only their own folders are used, without environment variables.
set(ENV{PYTHONPATH} "")
run(root/usr/bin/edgeproof verify moore-hills --only "EQ18*" --digits 20)
expect("as recorded in moore-hills.expected.csv")
run(root/usr/bin/edgeproof table power-law --check --every 100)
foreach(file share/doc/edgeproof/README.md share/doc/edgeproof/docs/guide/python.md
        share/man/man1/edgeproof-verify.1.gz share/bash-completion/completions/edgeproof
        share/zsh/vendor-completions/_edgeproof share/fish/vendor_completions.d/edgeproof.fish
        share/edgeproof/examples/python.ipynb share/edgeproof/reference/power-law.csv
        share/edgeproof/schemas/scene.schema.json share/edgeproof/schemas/verdicts.schema.json
        include/edgeproof/scene/scene.hpp lib/cmake/edgeproof/edgeproofConfig.cmake
        share/doc/edgeproof/copyright share/doc/libedgeproof-dev/copyright)
    if(NOT EXISTS ${WORK}/root/usr/${file})
        message(FATAL_ERROR "no package has /usr/${file}")
    endif()
endforeach()
if(PYTHON)
    set(ENV{PYTHONPATH} ${WORK}/root/usr/lib/python3/dist-packages)
    run(${PYTHON} -c "import edgeproof
print(edgeproof.__file__)
print(edgeproof.verify('moore-hills', only='EQ18', digits=20).summary)")
    expect("${WORK}/root/usr/lib/python3/dist-packages/edgeproof/__init__.py")
    expect("1 refuted")
endif()
foreach(package IN LISTS packages)
    run(dpkg-deb -I ${package})
endforeach()

find_program(LINTIAN lintian)
if(LINTIAN)
    run(${LINTIAN} --fail-on error,warning --allow-root ${packages})
    message(STATUS "lintian:\n${output}")
else()
    message(STATUS "lintian is not installed: not asked")
endif()
