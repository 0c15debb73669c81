// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/conformance/questions/asked_contact.hpp"
#include "edgeproof/scene/input/quantity.hpp"

#include <cstddef>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace edgeproof::conformance {

/// A value requested for a contact (scene/input/quantity.hpp).
struct Question : scene::AskedValue {
    std::string id;
    std::size_t contact = 0; ///< index into Questions::contacts
    std::size_t line = 0;    ///< in the file of the question

    [[nodiscard]] bool at_point() const { return row_of(quantity).at_point(); }
    [[nodiscard]] bool at_edge() const { return row_of(quantity).at_edge(); }
    [[nodiscard]] bool to_a_tolerance() const { return row_of(quantity).tolerance; }
};

struct Questions {
    std::string file;
    std::vector<AskedContact> contacts;
    std::vector<Question> list;

    /// The keys of parameters that occur in any contact.
    [[nodiscard]] std::vector<std::string> columns() const;
    [[nodiscard]] bool has_tolerances() const;
    [[nodiscard]] std::set<scene::Quantity> quantities() const;
};

/// The text of a parameter; empty if the contact does not have it.
[[nodiscard]] std::string parameter_text(const AskedContact& contact, std::string_view key);

/// Returns the same questions with every number rounded to binary64, so that a program in binary64
/// can read them exactly.
[[nodiscard]] Questions rounded_to_binary64(const Questions& questions);

/// Throws InputError if the contact does not have the quantity: q or s without shear, alpha if the
/// tilt is given.
void check_askable(const AskedContact& contact, const scene::AskedValue& asked,
                   const std::string& file, std::size_t line);

} // namespace edgeproof::conformance
