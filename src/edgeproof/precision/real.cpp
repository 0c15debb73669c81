// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/precision/real.hpp"

#include "edgeproof/precision/error.hpp"

#include <string>

namespace edgeproof {
namespace {
constexpr unsigned max_digits = 100'000'000;
}

PrecisionScope::PrecisionScope(unsigned digits) : saved_digits_(Real::thread_default_precision()) {
    if (digits < 2 || digits > max_digits) {
        throw DomainError("a working precision of " + std::to_string(digits) +
                          " digits is outside 2 ... 100000000");
    }
    Real::thread_default_precision(digits);
}

PrecisionScope::~PrecisionScope() { Real::thread_default_precision(saved_digits_); }

unsigned working_digits() { return Real::thread_default_precision(); }

Real at_working_precision(const Real& x) { return Real(x, Real::thread_default_precision()); }

} // namespace edgeproof
