// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/algebra/form.hpp"

#include <optional>

namespace edgeproof::algebra {

/// True if e is proved to be zero by exact algebra (form.hpp), where its names may have either
/// sign. A constant must also be finite in ball arithmetic, so that there is no division by zero.
/// False means only that no proof was found.
[[nodiscard]] bool proved_zero(const Expr& e);

/// Returns the sign of a constant, by balls of up to `bits` bits, or 0 by proved_zero. Nothing if
/// neither decides, or if e has no real value.
[[nodiscard]] std::optional<int> decided_sign(const Expr& e, long bits = 2048);

/// The magnitude of a constant. Throws Error if its sign is not decided.
[[nodiscard]] Form abs(const Form& x);

} // namespace edgeproof::algebra
