// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/precision/arithmetic.hpp"

#include <iostream>

int main() {
    const edgeproof::PrecisionScope scope(50);
    const auto third = edgeproof::from_rational<edgeproof::Real>(edgeproof::Rational(1, 3));
    std::cout << third.str(50, std::ios_base::fmtflags{}) << '\n';
}
