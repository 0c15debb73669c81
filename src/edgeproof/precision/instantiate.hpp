// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The number types for which every numerical route is compiled, once, in its own source file. A
/// file that includes the header does not compile the quadrature again.
#define EDGEPROOF_FOR_EACH_ARITHMETIC(M) M(double) M(long double) M(Float128) M(Real)
