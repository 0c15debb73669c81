// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The arithmetics that every numerical route is compiled for, once, in its own source file: who
/// includes the header does not compile the quadrature again.
#define EDGEPROOF_FOR_EACH_ARITHMETIC(M) M(double) M(long double) M(Float128) M(Real)
