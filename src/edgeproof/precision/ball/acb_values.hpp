// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/precision/ball/arb_values.hpp"

#ifdef EDGEPROOF_ARB_IN_FLINT
#include <flint/acb.h>
#include <flint/acb_calc.h>
#include <flint/acb_hypgeom.h>
#include <flint/acb_poly.h>
#else
#include <acb.h>
#include <acb_calc.h>
#include <acb_hypgeom.h>
#include <acb_poly.h>
#endif

namespace edgeproof {

EDGEPROOF_FLINT_TYPE(acb_struct, acb)
EDGEPROOF_FLINT_TYPE(acb_poly_struct, acb_poly)
EDGEPROOF_FLINT_TYPE(arb_poly_struct, arb_poly)

using AcbValue = FlintValue<acb_struct>;
using AcbPolyValue = FlintValue<acb_poly_struct>;
using ArbPolyValue = FlintValue<arb_poly_struct>;

} // namespace edgeproof
