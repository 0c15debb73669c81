// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/ball/arb_include.hpp"
#include "edgeproof/precision/rational.hpp"

#include <flint/fmpq.h>
#include <flint/fmpz.h>

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

template <> struct FlintType<arb_struct> {
    static void init(arb_ptr x) { arb_init(x); }
    static void clear(arb_ptr x) { arb_clear(x); }
    static void set(arb_ptr x, arb_srcptr y) { arb_set(x, y); }
    static void swap(arb_ptr x, arb_ptr y) { arb_swap(x, y); }
};
template <> struct FlintType<arf_struct> {
    static void init(arf_ptr x) { arf_init(x); }
    static void clear(arf_ptr x) { arf_clear(x); }
    static void set(arf_ptr x, arf_srcptr y) { arf_set(x, y); }
    static void swap(arf_ptr x, arf_ptr y) { arf_swap(x, y); }
};
template <> struct FlintType<mag_struct> {
    static void init(mag_ptr x) { mag_init(x); }
    static void clear(mag_ptr x) { mag_clear(x); }
    static void set(mag_ptr x, mag_srcptr y) { mag_set(x, y); }
    static void swap(mag_ptr x, mag_ptr y) { mag_swap(x, y); }
};
template <> struct FlintType<fmpz> {
    static void init(fmpz* x) { fmpz_init(x); }
    static void clear(fmpz* x) { fmpz_clear(x); }
    static void set(fmpz* x, const fmpz* y) { fmpz_set(x, y); }
    static void swap(fmpz* x, fmpz* y) { fmpz_swap(x, y); }
};
template <> struct FlintType<fmpq> {
    static void init(fmpq* x) { fmpq_init(x); }
    static void clear(fmpq* x) { fmpq_clear(x); }
    static void set(fmpq* x, const fmpq* y) { fmpq_set(x, y); }
    static void swap(fmpq* x, fmpq* y) { fmpq_swap(x, y); }
};

using ArbValue = FlintValue<arb_struct>;
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
