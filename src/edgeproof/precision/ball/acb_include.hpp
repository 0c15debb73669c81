// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
/// Arb's complex headers; see arb_include.hpp.
#include "edgeproof/precision/ball/arb_include.hpp"
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
