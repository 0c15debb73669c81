# SPDX-License-Identifier: GPL-3.0-or-later
# Every operation of MPFR's allocates its result, and an allocator that keeps small blocks at hand for
# each thread shows in the time of a verification. The program alone is linked with it; who links
# Edgeproof's libraries chooses for himself. The sanitizers bring an allocator of their own.
if(EDGEPROOF_JEMALLOC AND NOT EDGEPROOF_SANITIZE)
    find_library(JEMALLOC_LIBRARY jemalloc)
    mark_as_advanced(JEMALLOC_LIBRARY)
    if(JEMALLOC_LIBRARY)
        # No symbol of it is named in the program: it would be left out as unused.
        target_link_libraries(edgeproof PRIVATE
            -Wl,--push-state,--no-as-needed ${JEMALLOC_LIBRARY} -Wl,--pop-state)
    endif()
endif()
