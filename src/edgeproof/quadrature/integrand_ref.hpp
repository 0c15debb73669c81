// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <memory>
#include <type_traits>

namespace edgeproof::quadrature {

/// A reference to an integrand f(lo, hi), from two T to R. Rules that take it are compiled once for
/// each T and R, not once for every integrand. The integrand must outlive it.
template <class T, class R> class IntegrandRef {
public:
    template <class F>
    requires(!std::is_same_v<std::remove_cvref_t<F>, IntegrandRef>)
        IntegrandRef(const F& f) // NOLINT(google-explicit-constructor): converts any integrand
        : object_(std::addressof(f)), call_([](const void* object, const T& lo, const T& hi) {
              return R((*static_cast<const F*>(object))(lo, hi));
          }) {}

    R operator()(const T& lo, const T& hi) const { return call_(object_, lo, hi); }

private:
    const void* object_;
    R (*call_)(const void*, const T&, const T&);
};

/// The type of the values of an integrand over T.
template <class T, class F>
using IntegrandResult = std::remove_cvref_t<std::invoke_result_t<const F&, const T&, const T&>>;

} // namespace edgeproof::quadrature
