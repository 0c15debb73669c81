/* SPDX-License-Identifier: BSD-3-Clause */
/* FLINT 3's real and complex numbers convert from algebraic numbers and symbolic expressions. The
 * page has none of these: their modules are not compiled, and the conversions end the program. */
#include <stdlib.h>

#include "fexpr.h"
#include "gr_generic.h"
#include "qqbar.h"

void fexpr_set_fmpz(fexpr_t res, const fmpz_t c) { abort(); }
void fexpr_set_fmpq(fexpr_t res, const fmpq_t x) { abort(); }
int gr_generic_set_fexpr(gr_ptr res, fexpr_vec_t inputs, gr_vec_t outputs, const fexpr_t expr,
                         gr_ctx_t ctx) {
    abort();
}
void qqbar_get_arb(arb_t res, const qqbar_t x, slong prec) { abort(); }
void qqbar_get_acb(acb_t res, const qqbar_t x, slong prec) { abort(); }
void qqbar_get_fmpq(fmpq_t res, const qqbar_t x) { abort(); }
void qqbar_get_fmpz(fmpz_t res, const qqbar_t x) { abort(); }
int qqbar_sgn_im(const qqbar_t x) { abort(); }
int _gr_ca_get_arb_with_prec(arb_t res, gr_srcptr x, gr_ctx_t x_ctx, slong prec) { abort(); }
int _gr_ca_get_acb_with_prec(acb_t res, gr_srcptr x, gr_ctx_t x_ctx, slong prec) { abort(); }
