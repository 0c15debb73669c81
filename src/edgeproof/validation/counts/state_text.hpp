// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace edgeproof::validation {

/// Reads the state of a count: the line `head`, then one line per contact, then "end". `read` is
/// called with each line and returns true if it is well formed; otherwise throws InputError with
/// the line.
void read_state_text(std::string_view text, const std::string& file, const std::string& head,
                     const std::function<bool(const std::string&)>& read);

/// Returns those of the contacts 0 ... n - 1 that are missing in a state.
template <class Found>
[[nodiscard]] std::vector<std::size_t> contacts_left(std::size_t n,
                                                     const std::map<std::size_t, Found>& contacts) {
    std::vector<std::size_t> left;
    for (std::size_t i = 0; i < n; ++i) {
        if (!contacts.contains(i)) {
            left.push_back(i);
        }
    }
    return left;
}

/// `values` divided into contacts of `each` values; the last one may have fewer.
struct ContactSizes {
    std::size_t values;
    std::size_t each;
    [[nodiscard]] std::size_t contacts() const { return (values + each - 1) / each; }
    [[nodiscard]] std::size_t of(std::size_t number) const {
        return number + 1 < contacts() ? each : values - number * each;
    }
    /// The number of values without those contacts.
    [[nodiscard]] std::size_t but(const std::vector<std::size_t>& left) const {
        std::size_t sum = values;
        for (const std::size_t number : left) {
            sum -= of(number);
        }
        return sum;
    }
};

} // namespace edgeproof::validation
