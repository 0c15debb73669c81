// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstddef>
#include <string>
#include <string_view>

namespace edgeproof::io {

/// Only for a catch block. An error of this program that names no file becomes an InputError at
/// FILE:LINE; if it has no advice, `instead` is added (or advice that suits its kind). Any other
/// exception, including an interruption, is rethrown unchanged.
[[noreturn]] void rethrow_at(const std::string& file, std::size_t line,
                             std::string_view instead = {});

/// Returns f(); its errors get the file and the line.
template <class F>
decltype(auto) at_place(const std::string& file, std::size_t line, const F& f,
                        std::string_view instead = {}) {
    try {
        return f();
    } catch (...) {
        rethrow_at(file, line, instead);
    }
}

} // namespace edgeproof::io
