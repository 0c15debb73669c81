// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// Parts of C++20 that the program uses, for the C++ library of Emscripten 3.1.6 (libc++ 13 has no
/// algorithms for ranges, for example) and 3.1.69 (libc++ 19 reads no double). Included before
/// every source. FLINT 2 makes `ulong` a macro: <sys/types.h>, which declares this type, comes
/// first.
#include <sys/types.h>
#include <version>
#if defined(_LIBCPP_VERSION) && _LIBCPP_VERSION < 200000
#include <cerrno>
#include <charconv>
#include <cstdlib>
#include <string>

namespace std {
/// As in <charconv> of newer versions.
inline from_chars_result from_chars(const char* first, const char* last, double& x) {
    const string text(first, last);
    char* end = nullptr;
    errno = 0;
    const double read = strtod(text.c_str(), &end);
    if (end == text.c_str()) {
        return {first, errc::invalid_argument};
    }
    if (errno == ERANGE) {
        return {first + (end - text.c_str()), errc::result_out_of_range};
    }
    x = read;
    return {first + (end - text.c_str()), errc{}};
}
} // namespace std
#endif
#if defined(_LIBCPP_VERSION) && _LIBCPP_VERSION < 15000
#include <algorithm>
#include <array>
#include <compare>
#include <cstdio>
#include <functional>
#include <iterator>
#include <ranges>
#include <utility>

namespace std {
/// The same, for the one format that is used.
inline to_chars_result to_chars(char* first, char* last, double x, chars_format, int precision) {
    const int n = std::snprintf(first, static_cast<size_t>(last - first), "%.*e", precision, x);
    return {first + n, errc{}};
}
template <class T, size_t N>
constexpr auto operator<=>(const array<T, N>& x, const array<T, N>& y) {
    auto order = x[0] <=> y[0];
    for (size_t i = 1; i < N && order == 0; ++i) {
        order = x[i] <=> y[i];
    }
    return order;
}
template <class To, class From> constexpr To bit_cast(const From& from) {
    return __builtin_bit_cast(To, from);
}
} // namespace std

namespace std::ranges {

template <class R, class T, class P = identity>
constexpr auto find(R&& r, const T& value, P p = {}) {
    return std::find_if(ranges::begin(r), ranges::end(r),
                        [&](auto&& x) { return std::invoke(p, x) == value; });
}
template <class R, class F, class P = identity> constexpr auto find_if(R&& r, F f, P p = {}) {
    return std::find_if(ranges::begin(r), ranges::end(r),
                        [&](auto&& x) { return std::invoke(f, std::invoke(p, x)); });
}
template <class R, class F, class P = identity> constexpr bool any_of(R&& r, F f, P p = {}) {
    return ranges::find_if(r, std::move(f), std::move(p)) != ranges::end(r);
}
template <class R, class F, class P = identity> constexpr bool none_of(R&& r, F f, P p = {}) {
    return !ranges::any_of(r, std::move(f), std::move(p));
}
template <class R, class F, class P = identity> constexpr bool all_of(R&& r, F f, P p = {}) {
    return !ranges::any_of(r, [&](auto&& x) { return !std::invoke(f, std::invoke(p, x)); });
}
template <class R, class F, class P = identity> constexpr auto count_if(R&& r, F f, P p = {}) {
    return std::count_if(ranges::begin(r), ranges::end(r),
                         [&](auto&& x) { return std::invoke(f, std::invoke(p, x)); });
}
template <class R, class F, class P = identity> constexpr void for_each(R&& r, F f, P p = {}) {
    for (auto&& x : r) {
        std::invoke(f, std::invoke(p, x));
    }
}
template <class R, class S> constexpr bool equal(R&& r, S&& s) {
    return std::equal(ranges::begin(r), ranges::end(r), ranges::begin(s), ranges::end(s));
}
template <class R, class S, class F> constexpr bool equal(R&& r, S&& s, F f) {
    return std::equal(ranges::begin(r), ranges::end(r), ranges::begin(s), ranges::end(s), f);
}
template <class R, class C = less, class P = identity>
constexpr void sort(R&& r, C c = {}, P p = {}) {
    std::sort(ranges::begin(r), ranges::end(r), [&](auto&& x, auto&& y) {
        return std::invoke(c, std::invoke(p, x), std::invoke(p, y));
    });
}
template <class R, class C = less, class P = identity>
constexpr void stable_sort(R&& r, C c = {}, P p = {}) {
    std::stable_sort(ranges::begin(r), ranges::end(r), [&](auto&& x, auto&& y) {
        return std::invoke(c, std::invoke(p, x), std::invoke(p, y));
    });
}
template <class R, class C = less, class P = identity>
constexpr auto min_element(R&& r, C c = {}, P p = {}) {
    return std::min_element(ranges::begin(r), ranges::end(r), [&](auto&& x, auto&& y) {
        return std::invoke(c, std::invoke(p, x), std::invoke(p, y));
    });
}
template <class R, class C = less, class P = identity>
constexpr auto max_element(R&& r, C c = {}, P p = {}) {
    return std::max_element(ranges::begin(r), ranges::end(r), [&](auto&& x, auto&& y) {
        return std::invoke(c, std::invoke(p, x), std::invoke(p, y));
    });
}
template <class R> constexpr void reverse(R&& r) { std::reverse(ranges::begin(r), ranges::end(r)); }
template <class R, class T> constexpr void fill(R&& r, const T& value) {
    std::fill(ranges::begin(r), ranges::end(r), value);
}
template <class R, class T, class U> constexpr void replace(R&& r, const T& from, const U& to) {
    std::replace(ranges::begin(r), ranges::end(r), from, to);
}
template <class R, class F, class T> constexpr void replace_if(R&& r, F f, const T& to) {
    std::replace_if(ranges::begin(r), ranges::end(r), f, to);
}
template <class R, class O> constexpr void copy(R&& r, O out) {
    std::copy(ranges::begin(r), ranges::end(r), out);
}
template <class R, class O, class F> constexpr void copy_if(R&& r, O out, F f) {
    std::copy_if(ranges::begin(r), ranges::end(r), out, f);
}
template <class R, class O> constexpr void move(R&& r, O out) {
    std::move(ranges::begin(r), ranges::end(r), out);
}
template <class R, class O, class F> constexpr void transform(R&& r, O out, F f) {
    for (auto&& x : r) {
        *out++ = std::invoke(f, x);
    }
}
template <class R, class S, class O, class F> constexpr void transform(R&& r, S&& s, O out, F f) {
    std::transform(ranges::begin(r), ranges::end(r), ranges::begin(s), out, f);
}

} // namespace std::ranges
#endif
