// SPDX-License-Identifier: GPL-3.0-or-later
// What nearly every source includes in the end and none of us edits: parsing it once halves the
// time of a clean build (option EDGEPROOF_PCH). No source may rely on it; presets without it tell.
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
