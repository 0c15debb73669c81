// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <memory>
#include <type_traits>

namespace edgeproof::quadrature {

/// An integrand f(lo, hi), T and T to R, by reference: rules that take it are compiled once for a
/// T and an R, not once for every integrand. What it refers to has to outlive it.
template <class T, class R> class IntegrandRef {
public:
    template <class F>
    requires(!std::is_same_v<std::remove_cvref_t<F>, IntegrandRef>)
        IntegrandRef(const F& f) // NOLINT(google-explicit-constructor): stands for any integrand
        : object_(std::addressof(f)), call_([](const void* object, const T& lo, const T& hi) {
              return R((*static_cast<const F*>(object))(lo, hi));
          }) {}

    R operator()(const T& lo, const T& hi) const { return call_(object_, lo, hi); }

private:
    const void* object_;
    R (*call_)(const void*, const T&, const T&);
};

/// What an integrand over T gives.
template <class T, class F>
using IntegrandResult = std::remove_cvref_t<std::invoke_result_t<const F&, const T&, const T&>>;

} // namespace edgeproof::quadrature
