# SPDX-License-Identifier: BSD-3-Clause
# FLINT 3, which contains Arb: its sources, and what its configure script writes.
set(flint ${LIBRARIES}/flint/src)

# The modules of Arb, and those on which they depend.
set(modules acb acb_calc acb_dft acb_dirichlet acb_elliptic acb_hypgeom acb_mat acb_modular acb_poly
    acf aprcl arb arb_calc arb_fmpz_poly arb_hypgeom arb_mat arb_poly arf arith bernoulli bool_mat
    d_mat d_vec dirichlet dlog double_extras double_interval fft fmpq fmpq_mat fmpq_poly fmpq_vec
    fmpz fmpz_extras fmpz_factor fmpz_lll fmpz_mat fmpz_mod fmpz_mod_mat fmpz_mod_poly
    fmpz_mod_poly_factor fmpz_mod_vec fmpz_poly fmpz_poly_factor fmpz_vec fmpzi fq fq_mat fq_nmod
    fq_nmod_mat fq_nmod_poly fq_nmod_poly_factor fq_nmod_vec fq_poly fq_poly_factor fq_vec
    generic_files gr gr_generic gr_mat gr_poly gr_special gr_vec hypgeom long_extras mag mpfr_mat
    mpfr_vec mpn_extras n_poly nmod nmod_mat nmod_poly nmod_poly_factor nmod_poly_mat nmod_vec
    partitions perm qsieve thread_pool thread_support ulong_extras)
# The word of 64 bits is `long long`, as on Windows.
file(COPY_FILE ${flint}/fmpz/link/fmpz_single.c ${flint}/fmpz/fmpz.c ONLY_IF_DIFFERENT)
file(COPY_FILE ${flint}/gmpcompat-longlong.h.in ${flint}/gmpcompat.h ONLY_IF_DIFFERENT)
file(COPY_FILE ${flint}/fft_tuning64.in ${flint}/fft_tuning.h ONLY_IF_DIFFERENT)
file(STRINGS ${LIBRARIES}/flint/VERSION FLINT_VERSION_FULL LIMIT_COUNT 1)
string(REGEX MATCH "^([0-9]+)\\.([0-9]+)\\.([0-9]+)" numbers ${FLINT_VERSION_FULL})
set(FLINT_MAJOR ${CMAKE_MATCH_1})
set(FLINT_MINOR ${CMAKE_MATCH_2})
set(FLINT_PATCH ${CMAKE_MATCH_3})
configure_file(${flint}/flint.h.in ${flint}/flint.h @ONLY)
foreach(header config.h flint-config.h)
    file(CONFIGURE OUTPUT ${flint}/${header} CONTENT "/* One thread, nothing that needs a processor. */\n")
endforeach()
foreach(file fmpz/fits_si.c fmpz/get.c)
    replace_in(${flint}/${file} "defined(__mips64)" "defined(__mips64) || defined(__wasm__)")
endforeach()

foreach(module IN LISTS modules)
    file(GLOB more ${flint}/${module}/*.c)
    list(APPEND sources ${more})
endforeach()
list(FILTER sources EXCLUDE REGEX
    "/(test_helpers|gettimeofday|gr/ca|gr/qqbar|gr_generic/set_fexpr)\\.c$")
list(APPEND sources ${CMAKE_CURRENT_SOURCE_DIR}/without_calcium.c)
add_compile_definitions(BUILDING_FLINT)
set(folders ${flint})
set(optimization -Os) # its rings of every kind make the page larger
