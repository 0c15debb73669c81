// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstddef>
#include <string>
#include <string_view>

namespace edgeproof::io {

/// Only in a catch block. An error of ours that names no file becomes an InputError at FILE:LINE,
/// with `instead` (or what suits its kind) as advice where it has none; any other exception, among
/// them an interruption, goes on as it is.
[[noreturn]] void rethrow_at(const std::string& file, std::size_t line,
                             std::string_view instead = {});

/// What f gives; whatever it refuses is told with the file and the line.
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
