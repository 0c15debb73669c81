# SPDX-License-Identifier: BSD-3-Clause
# Every operation of MPFR allocates its result, so that an allocator that keeps small blocks for
# each thread makes a verification faster. Only the programs are linked with it; users of Edgeproof's
# libraries choose their own. The sanitizers have an allocator of their own.
if(EDGEPROOF_JEMALLOC AND NOT EDGEPROOF_SANITIZE)
    find_library(JEMALLOC_LIBRARY jemalloc)
    mark_as_advanced(JEMALLOC_LIBRARY)
endif()
function(edgeproof_use_jemalloc program)
    if(JEMALLOC_LIBRARY)
        # The program uses none of its symbols by name, so that the linker would leave it out.
        target_link_libraries(${program} PRIVATE
            -Wl,--push-state,--no-as-needed ${JEMALLOC_LIBRARY} -Wl,--pop-state)
    endif()
endfunction()
