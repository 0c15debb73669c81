// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/precision/real.hpp"

#include <flint/fmpq.h>
#include <flint/fmpz.h>

/// Arb's headers: separate with FLINT 2.9, part of FLINT from version 3 on.
#ifdef EDGEPROOF_ARB_IN_FLINT
#include <mpfr.h> // first: with it, <flint/arf.h> declares conversions to and from mpfr_t

#include <flint/acb.h>
#include <flint/acb_calc.h>
#include <flint/acb_hypgeom.h>
#include <flint/acb_poly.h>
#include <flint/arb.h>
#include <flint/arb_hypgeom.h>
#include <flint/arb_poly.h>
#include <flint/arf.h>
#include <flint/mag.h>
#else
#include <acb.h>
#include <acb_calc.h>
#include <acb_hypgeom.h>
#include <acb_poly.h>
#include <arb.h>
#include <arb_hypgeom.h>
#include <arb_poly.h>
#include <arf.h>
#include <mag.h>
#endif

namespace edgeproof {

/// The functions that initialise, clear and copy a type of Arb or FLINT, for `FlintValue`.
template <class Struct> struct FlintType;

/// A value of such a type that clears itself, initially 0. It converts to the pointer that the
/// functions of the libraries take. A copy is deep; a moved-from value is valid but unspecified.
template <class Struct> class FlintValue {
public:
    FlintValue() { FlintType<Struct>::init(&x_); }
    FlintValue(const FlintValue& o) : FlintValue() { FlintType<Struct>::set(&x_, &o.x_); }
    FlintValue(FlintValue&& o) noexcept : FlintValue() { FlintType<Struct>::swap(&x_, &o.x_); }
    FlintValue& operator=(const FlintValue& o) {
        FlintType<Struct>::set(&x_, &o.x_);
        return *this;
    }
    FlintValue& operator=(FlintValue&& o) noexcept {
        FlintType<Struct>::swap(&x_, &o.x_);
        return *this;
    }
    ~FlintValue() { FlintType<Struct>::clear(&x_); }

    operator Struct*() noexcept { return &x_; }             // NOLINT(*-explicit-*)
    operator const Struct*() const noexcept { return &x_; } // NOLINT(*-explicit-*)
    /// For macros such as arb_midref(x).
    Struct* operator->() noexcept { return &x_; }
    const Struct* operator->() const noexcept { return &x_; }

private:
    Struct x_;
};

#define EDGEPROOF_FLINT_TYPE(Struct, name)                                                         \
    template <> struct FlintType<Struct> {                                                         \
        static void init(Struct* x) { name##_init(x); }                                            \
        static void clear(Struct* x) { name##_clear(x); }                                          \
        static void set(Struct* x, const Struct* y) { name##_set(x, y); }                          \
        static void swap(Struct* x, Struct* y) { name##_swap(x, y); }                              \
    };
EDGEPROOF_FLINT_TYPE(arb_struct, arb)
EDGEPROOF_FLINT_TYPE(arb_poly_struct, arb_poly)
EDGEPROOF_FLINT_TYPE(acb_struct, acb)
EDGEPROOF_FLINT_TYPE(acb_poly_struct, acb_poly)
EDGEPROOF_FLINT_TYPE(arf_struct, arf)
EDGEPROOF_FLINT_TYPE(mag_struct, mag)
EDGEPROOF_FLINT_TYPE(fmpz, fmpz)
EDGEPROOF_FLINT_TYPE(fmpq, fmpq)

using ArbValue = FlintValue<arb_struct>;
using ArbPolyValue = FlintValue<arb_poly_struct>;
using AcbValue = FlintValue<acb_struct>;
using AcbPolyValue = FlintValue<acb_poly_struct>;
using ArfValue = FlintValue<arf_struct>;
using MagValue = FlintValue<mag_struct>;
using FmpzValue = FlintValue<fmpz>;
using FmpqValue = FlintValue<fmpq>;

[[nodiscard]] inline FmpqValue to_fmpq(const Rational& q) {
    FmpqValue f;
    fmpq_set_mpq(f, q.backend().data());
    return f;
}
[[nodiscard]] inline Rational from_fmpq(const FmpqValue& f) {
    Rational q;
    fmpq_get_mpq(q.backend().data(), f);
    return q;
}

} // namespace edgeproof
