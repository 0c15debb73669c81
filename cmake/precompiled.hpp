// SPDX-License-Identifier: GPL-3.0-or-later
// Library headers that nearly every source includes: parsing them once halves the time of a clean
// build (option EDGEPROOF_PCH). No source may rely on this header; presets without it check that.
#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/float128.hpp>
#include <boost/multiprecision/gmp.hpp>
#include <boost/multiprecision/mpfr.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>
