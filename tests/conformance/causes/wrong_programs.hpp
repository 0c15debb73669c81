// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/conformance/causes/convention.hpp"
#include "tests/support/injected_keys.hpp"

#include <functional>
#include <optional>
#include <string>
#include <vector>

/// Programs that answer with a mistake, made without the catalogue that is under test: the keys of
/// the contact are changed (tests/support/injected_keys.hpp), or places and values as a program
/// would change them. Mistakes without a name are right answers, and errors that no mistake of the
/// catalogue explains.
namespace edgeproof::conformance {

using test::SceneKeys;

/// The questions about a profile under two loads, and the right answers.
struct Asked {
    Questions questions;
    std::vector<Real> a; ///< by contact
    std::vector<Real> b;
    std::vector<Real> right;
};

/// The answers of a program; nothing if the program could not have computed any.
using Program = std::function<std::optional<std::vector<double>>(const Asked&)>;
struct WrongProgram {
    std::string name;
    Program program;
    std::function<double(double)> write = {}; ///< changes an answer after the noise
};

[[nodiscard]] Asked asked_about(const SceneKeys& keys, const ReferenceOptions& options);

/// The programs for a contact with these keys.
[[nodiscard]] std::vector<WrongProgram> wrong_programs(const SceneKeys& keys,
                                                       const ReferenceOptions& options);

} // namespace edgeproof::conformance
