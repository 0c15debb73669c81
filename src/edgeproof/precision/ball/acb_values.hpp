// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/ball/acb_include.hpp"
#include "edgeproof/precision/ball/arb_values.hpp"

namespace edgeproof {

template <> struct FlintType<acb_struct> {
    static void init(acb_ptr x) { acb_init(x); }
    static void clear(acb_ptr x) { acb_clear(x); }
    static void set(acb_ptr x, acb_srcptr y) { acb_set(x, y); }
    static void swap(acb_ptr x, acb_ptr y) { acb_swap(x, y); }
};
template <> struct FlintType<acb_poly_struct> {
    static void init(acb_poly_struct* x) { acb_poly_init(x); }
    static void clear(acb_poly_struct* x) { acb_poly_clear(x); }
    static void set(acb_poly_struct* x, const acb_poly_struct* y) { acb_poly_set(x, y); }
    static void swap(acb_poly_struct* x, acb_poly_struct* y) { acb_poly_swap(x, y); }
};
template <> struct FlintType<arb_poly_struct> {
    static void init(arb_poly_struct* x) { arb_poly_init(x); }
    static void clear(arb_poly_struct* x) { arb_poly_clear(x); }
    static void set(arb_poly_struct* x, const arb_poly_struct* y) { arb_poly_set(x, y); }
    static void swap(arb_poly_struct* x, arb_poly_struct* y) { arb_poly_swap(x, y); }
};

using AcbValue = FlintValue<acb_struct>;
using AcbPolyValue = FlintValue<acb_poly_struct>;
using ArbPolyValue = FlintValue<arb_poly_struct>;

} // namespace edgeproof
