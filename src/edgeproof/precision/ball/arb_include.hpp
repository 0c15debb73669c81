// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
/// Arb's headers: separate with FLINT 2.9, part of FLINT from version 3 on.
#ifdef EDGEPROOF_ARB_IN_FLINT
#include <mpfr.h> // first: with it, <flint/arf.h> declares conversions to and from mpfr_t

#include <flint/arb.h>
#include <flint/arb_hypgeom.h>
#include <flint/arb_poly.h>
#include <flint/arf.h>
#include <flint/mag.h>
#else
#include <arb.h>
#include <arb_hypgeom.h>
#include <arb_poly.h>
#include <arf.h>
#include <mag.h>
#endif
