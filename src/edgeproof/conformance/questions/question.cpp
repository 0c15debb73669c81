// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/conformance/questions/question.hpp"

#include "edgeproof/precision/error.hpp"

#include <algorithm>
#include <charconv>
#include <set>

namespace edgeproof::conformance {
namespace {

constexpr std::size_t most_k = 399;

struct Name {
    Wanted::Kind kind;
    std::string_view text;
};
constexpr Name names[] = {
    {Wanted::Kind::p, "p"},         {Wanted::Kind::q, "q"}, {Wanted::Kind::a, "a"},
    {Wanted::Kind::b, "b"},         {Wanted::Kind::P, "P"}, {Wanted::Kind::M, "M"},
    {Wanted::Kind::alpha, "alpha"},
};
constexpr Name numbered[] = {
    {Wanted::Kind::c, "c_"},
    {Wanted::Kind::s, "s_"},
    {Wanted::Kind::extent, "extent_"},
    {Wanted::Kind::measure, "measure_"},
};

} // namespace

std::optional<Wanted> wanted_named(std::string_view name) {
    for (const Name& known : names) {
        if (known.text == name) {
            return Wanted{known.kind};
        }
    }
    for (const Name& known : numbered) {
        if (!name.starts_with(known.text)) {
            continue;
        }
        Wanted wanted{known.kind};
        const char* const end = name.data() + name.size();
        const auto [stop, error] = std::from_chars(name.data() + known.text.size(), end, wanted.k);
        const bool read = error == std::errc{} && stop == end && wanted.k <= most_k;
        return read && (wanted.k > 0 || !wanted.of_terms()) ? std::optional(wanted) : std::nullopt;
    }
    return {};
}

std::string wanted_name(const Wanted& wanted) {
    for (const Name& known : names) {
        if (known.kind == wanted.kind) {
            return std::string(known.text);
        }
    }
    for (const Name& known : numbered) {
        if (known.kind == wanted.kind) {
            return std::string(known.text) + std::to_string(wanted.k);
        }
    }
    return {};
}

std::string parameter_text(const AskedContact& contact, std::string_view key) {
    for (const Parameter& p : contact.parameters) {
        if (p.key == key) {
            return p.text;
        }
    }
    return {};
}

std::vector<std::string> Questions::columns() const {
    std::set<std::string, std::less<>> used;
    for (const AskedContact& contact : contacts) {
        for (const Parameter& p : contact.parameters) {
            used.insert(p.key);
        }
    }
    std::vector<std::string> keys;
    for (const std::string_view key : parameter_keys()) {
        if (used.contains(key)) {
            keys.emplace_back(key);
        }
    }
    return keys;
}

bool Questions::has_tolerances() const {
    return std::any_of(list.begin(), list.end(), [](const Question& q) { return q.tolerance; });
}

Questions rounded_to_binary64(const Questions& questions) {
    Questions rounded;
    rounded.file = questions.file;
    for (const AskedContact& contact : questions.contacts) {
        rounded.contacts.push_back(make_asked_contact(rounded_to_binary64(contact.parameters),
                                                      questions.file, contact.scene.ask_line));
    }
    rounded.list = questions.list;
    for (Question& q : rounded.list) {
        if (q.u) {
            q.u = rounded_to_binary64(*q.u);
        }
        if (q.tolerance) {
            q.tolerance = rounded_to_binary64(*q.tolerance);
        }
    }
    return rounded;
}

void check_askable(const AskedContact& contact, const Wanted& wanted, const std::string& file,
                   std::size_t line) {
    const bool shear = wanted.kind == Wanted::Kind::q || wanted.kind == Wanted::Kind::s;
    if (shear && !contact.scene.shear) {
        throw InputError(wanted_name(wanted) + " is asked for and there is no shear",
                         "add Q or bulk_tension, or leave " + wanted_name(wanted) + " out")
            .at(file, line);
    }
    if (wanted.kind == Wanted::Kind::alpha && !contact.scene.punch) {
        throw InputError("alpha is asked for and is not unknown",
                         "give P and M and no alpha, or leave alpha out of the quantities")
            .at(file, line);
    }
}

} // namespace edgeproof::conformance
