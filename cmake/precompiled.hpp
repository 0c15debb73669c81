// SPDX-License-Identifier: BSD-3-Clause
// Headers that nearly every source includes: parsing them once halves the time of a clean build
// (option EDGEPROOF_PCH). No source may rely on this header; presets without it check that.
#include "edgeproof/formula/expr.hpp"
#include "edgeproof/precision/ball/arb_values.hpp"
#include "edgeproof/precision/ball/ball.hpp"

#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/gmp.hpp>
#include <boost/multiprecision/mpfr.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <variant>
#include <vector>
