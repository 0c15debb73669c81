# SPDX-License-Identifier: BSD-3-Clause
# FLINT 2 and Arb: their sources, and what their configure scripts write.
set(flint ${LIBRARIES}/flint)
set(arb ${LIBRARIES}/flint-arb)

# The modules on which Arb depends, and mpoly, fmpz_mpoly, fmpz_mpoly_factor, ... on which these do.
set(flint_modules aprcl arith d_mat d_vec double_extras fft fmpq fmpq_mat fmpq_poly fmpq_vec fmpz
    fmpz_factor fmpz_lll fmpz_mat fmpz_mod fmpz_mod_mat fmpz_mod_poly fmpz_mod_poly_factor
    fmpz_mod_vec fmpz_poly fmpz_poly_factor fmpz_vec fq fq_mat fq_nmod fq_nmod_mat fq_nmod_poly
    fq_nmod_poly_factor fq_nmod_vec fq_poly fq_poly_factor fq_vec long_extras mpf_mat mpf_vec
    mpfr_mat mpfr_vec mpn_extras nmod nmod_mat nmod_poly nmod_poly_factor nmod_poly_mat nmod_vec
    perm qsieve thread_pool thread_support ulong_extras)
set(arb_modules acb acb_calc acb_dft acb_dirichlet acb_elliptic acb_hypgeom acb_mat acb_modular
    acb_poly arb arb_calc arb_fmpz_poly arb_hypgeom arb_mat arb_poly arf bernoulli bool_mat
    dirichlet dlog double_interval fmpr fmpz_extras fmpzi hypgeom mag partitions)

# What FLINT's configure script writes. The word of 64 bits is `long long`, as on Windows.
file(COPY_FILE ${flint}/fmpz/link/fmpz_single.c ${flint}/fmpz/fmpz.c ONLY_IF_DIFFERENT)
file(COPY_FILE ${flint}/fmpz-conversions-single.in ${flint}/fmpz-conversions.h ONLY_IF_DIFFERENT)
file(COPY_FILE ${flint}/fft_tuning64.in ${flint}/fft_tuning.h ONLY_IF_DIFFERENT)
file(CONFIGURE OUTPUT ${flint}/flint-config.h CONTENT "\
#define FLINT_USES_BLAS 0
#define FLINT_USES_TLS 0
#define FLINT_USES_FENV 0
#define FLINT_USES_PTHREAD 0
#define FLINT_BIG_ENDIAN 0
#define FLINT_USES_GC 0
#define FLINT_USES_CPUSET 0
#define FLINT_REENTRANT 0
#define FLINT_WANT_ASSERT 0
#define FLINT_DLL
")
foreach(file flint.h fmpz/fits_si.c fmpz/get_mpfr.c)
    replace_in(${flint}/${file} "defined(__mips64)" "defined(__mips64) || defined(__wasm__)")
endforeach()
# The number of leading and trailing zeros by instructions instead of a table.
replace_in(${flint}/longlong.h "defined (__arm64__))\n\n#ifdef _LONG_LONG_LIMB"
    "defined (__arm64__) || defined (__wasm__))\n\n#ifdef _LONG_LONG_LIMB")

file(GLOB sources ${flint}/*.c)
list(FILTER sources EXCLUDE REGEX "/(test_helpers|gettimeofday)\\.c$")
foreach(module IN LISTS flint_modules)
    file(GLOB more ${flint}/${module}/*.c)
    list(APPEND sources ${more})
endforeach()
foreach(module IN LISTS arb_modules)
    file(GLOB more ${arb}/${module}/*.c)
    list(APPEND sources ${more})
endforeach()

file(MAKE_DIRECTORY ${LIBRARIES}/include)
file(GLOB headers ${arb}/*.h)
foreach(header IN LISTS headers)
    cmake_path(GET header FILENAME name)
    file(CREATE_LINK ${header} ${LIBRARIES}/include/${name} SYMBOLIC)
endforeach()
set(folders ${flint} ${arb})
set(optimization -O2)
