// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/formula/expr.hpp"

#include "edgeproof/formula/builtin.hpp"
#include "edgeproof/formula/fold.hpp"
#include "edgeproof/precision/error.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <optional>
#include <utility>

namespace edgeproof::formula {

namespace {

/// In the order of the enumeration, from sqrt on.
constexpr std::array<std::string_view, 23> builtin_names{
    "sqrt", "exp",   "log",  "sin",   "cos",  "tan",   "asin",  "acos",
    "atan", "atan2", "sinh", "cosh",  "tanh", "asinh", "acosh", "atanh",
    "abs",  "sgn",   "step", "gamma", "max",  "min",   "hypot"};

constexpr std::array table = [] {
    std::array<BuiltinInfo, builtin_names.size()> all{};
    for (std::size_t i = 0; i < all.size(); ++i) {
        constexpr unsigned any_number = 64;
        const auto f = static_cast<Builtin>(i + 1);
        const bool list = f == Builtin::max || f == Builtin::min;
        const unsigned least = list || f == Builtin::atan2 || f == Builtin::hypot ? 2 : 1;
        all[i] = {f, builtin_names[i], least, list ? any_number : least};
    }
    return all;
}();
static_assert(table.back().id == Builtin::hypot);

} // namespace

std::span<const BuiltinInfo> builtins() { return table; }

std::optional<BuiltinInfo> find_builtin(std::string_view name) {
    const auto it = std::ranges::find(table, name, &BuiltinInfo::name);
    return it == table.end() ? std::nullopt : std::optional(*it);
}

std::string_view name_of(Builtin f) {
    return f == Builtin::none ? std::string_view{} : table[static_cast<std::size_t>(f) - 1].name;
}

struct Expr::Node {
    Kind kind = Kind::number;
    Builtin builtin = Builtin::none;
    std::string name;
    std::vector<Expr> args;
    /// The exact value, if there is one.
    std::optional<Rational> value;
    std::size_t hash = 0;
    std::size_t height = 1;
    std::size_t size = 1;
    std::size_t offset = 0;
    std::size_t length = 0;
};

namespace {

/// The greatest number of nodes of a tree, with shared nodes counted repeatedly: definitions that
/// are substituted into each other may double it at each step.
constexpr std::size_t max_size = 1'000'000;

std::size_t mix(std::size_t seed, std::size_t x) {
    return seed ^ (x + 0x9e3779b97f4a7c15ULL + (seed << 6U) + (seed >> 2U));
}

std::size_t hash_of(const Rational& q) {
    const auto* raw = q.backend().data();
    std::size_t h = 0;
    for (const mpz_srcptr z : {mpq_numref(raw), mpq_denref(raw)}) {
        h = mix(h, mpz_size(z));
        for (std::size_t i = 0; i < mpz_size(z); ++i) {
            h = mix(h, mpz_getlimbn(z, static_cast<mp_size_t>(i)));
        }
    }
    return h;
}

/// True if the decimal expansion of q terminates.
bool terminates(const Rational& q) {
    const auto* const denominator = mpq_denref(q.backend().data());
    if (mpz_fits_ulong_p(denominator) != 0) {
        unsigned long d = mpz_get_ui(denominator);
        d >>= static_cast<unsigned>(std::countr_zero(d));
        while (d % 5 == 0) {
            d /= 5;
        }
        return d == 1;
    }
    Integer odd;
    mpz_tdiv_q_2exp(odd.backend().data(), denominator, mpz_scan1(denominator, 0));
    const Integer five(5);
    mpz_remove(odd.backend().data(), odd.backend().data(), five.backend().data());
    return odd == 1;
}

void check_call(std::string_view name, std::size_t given, std::size_t least, std::size_t most) {
    if (given < least || given > most) {
        std::string wanted = std::to_string(least);
        if (most > least) {
            wanted += " or more";
        }
        throw InputError("'" + std::string(name) + "' is given " + std::to_string(given) +
                             (given == 1 ? " argument" : " arguments"),
                         "give it " + wanted);
    }
}

} // namespace

Expr Expr::make(Kind kind, std::string name, std::vector<Expr> args, const Rational* value) {
    auto node = std::make_shared<Node>();
    node->kind = kind;
    node->name = std::move(name);
    node->args = std::move(args);
    if (kind == Kind::call) {
        if (const auto f = find_builtin(node->name)) {
            node->builtin = f->id;
        }
    }
    node->hash = mix(static_cast<std::size_t>(kind), std::hash<std::string>{}(node->name));
    for (const Expr& x : node->args) {
        node->hash = mix(node->hash, x.hash());
        node->height = std::max(node->height, x.height() + 1);
        node->size += x.node_->size;
    }
    if (node->size > max_size) {
        throw Error("an expression has more than " + std::to_string(max_size) + " parts");
    }
    if (node->height > max_height) {
        throw Error("an expression is more than " + std::to_string(max_height) + " levels high");
    }
    node->value = value != nullptr ? *value : fold(kind, node->builtin, node->args);
    return Expr(std::move(node));
}

Expr::Expr() {
    static const Expr zero = number(Rational(0));
    node_ = zero.node_;
}

Expr Expr::number(const Rational& q) {
    if (q.sign() < 0) {
        return -number(-q);
    }
    if (!terminates(q)) {
        return make(Kind::div, {},
                    {number(Rational(numerator(q))), number(Rational(denominator(q)))}, &q);
    }
    auto node = std::make_shared<Node>();
    node->value = q;
    node->hash = hash_of(q);
    return Expr(std::move(node));
}

Expr Expr::pi() {
    static const Expr constant = make(Kind::pi, {}, {});
    return constant;
}

Expr Expr::symbol(std::string_view name) { return make(Kind::symbol, std::string(name), {}); }

Expr Expr::call(std::string_view name, std::vector<Expr> args) {
    if (const unsigned arity = binder_arity(name); arity != 0) {
        check_call(name, args.size(), arity, arity);
        if (args[1].kind() != Kind::symbol) {
            throw InputError("the second argument of '" + std::string(name) + "' is not a variable",
                             "write " + std::string(name) + "(f, s, lower, upper" +
                                 (arity == 5 ? ", x)" : ")"));
        }
        const Kind kind = name == "pv" ? Kind::pv : name == "sum" ? Kind::sum : Kind::integral;
        return make(kind, std::string(name), std::move(args));
    }
    if (const auto f = find_builtin(name)) {
        check_call(name, args.size(), f->min_arity, f->max_arity);
    }
    return make(Kind::call, std::string(name), std::move(args));
}

Expr Expr::with_args(const Expr& like, std::vector<Expr> args) {
    if (args.size() != like.args().size()) {
        throw Error("an expression is rebuilt with another number of arguments");
    }
    if (args.empty()) {
        return like;
    }
    const bool named = like.kind() == Kind::call || like.is_binder();
    const Expr made =
        named ? call(like.name(), std::move(args)) : make(like.kind(), {}, std::move(args));
    return made.located(like.offset(), like.length());
}

Expr Expr::located(std::size_t offset, std::size_t length) const {
    auto node = std::make_shared<Node>(*node_);
    node->offset = offset;
    node->length = length;
    return Expr(std::move(node));
}

Expr::Kind Expr::kind() const noexcept { return node_->kind; }

const Rational& Expr::number() const {
    if (node_->kind != Kind::number) {
        throw Error("an expression that is not a number has no value");
    }
    return *node_->value;
}

const std::string& Expr::name() const noexcept { return node_->name; }
Builtin Expr::builtin() const noexcept { return node_->builtin; }
std::span<const Expr> Expr::args() const noexcept { return node_->args; }

const Expr& Expr::arg(std::size_t i) const {
    if (i >= node_->args.size()) {
        throw Error("an expression does not have the requested argument");
    }
    return node_->args[i];
}

bool Expr::is_binder() const noexcept {
    return kind() == Kind::integral || kind() == Kind::pv || kind() == Kind::sum;
}

const Rational* Expr::rational() const noexcept { return node_->value ? &*node_->value : nullptr; }

std::size_t Expr::offset() const noexcept { return node_->offset; }
std::size_t Expr::length() const noexcept { return node_->length; }
std::size_t Expr::hash() const noexcept { return node_->hash; }
std::size_t Expr::height() const noexcept { return node_->height; }

bool operator==(const Expr& x, const Expr& y) {
    if (x.node_ == y.node_) {
        return true;
    }
    if (x.hash() != y.hash() || x.kind() != y.kind() || x.name() != y.name()) {
        return false;
    }
    if (x.kind() == Expr::Kind::number) {
        return x.number() == y.number();
    }
    return std::ranges::equal(x.args(), y.args());
}

Expr operator-(const Expr& x) { return Expr::make(Expr::Kind::neg, {}, {x}); }
Expr operator+(const Expr& x, const Expr& y) { return Expr::make(Expr::Kind::add, {}, {x, y}); }
Expr operator-(const Expr& x, const Expr& y) { return Expr::make(Expr::Kind::sub, {}, {x, y}); }
Expr operator*(const Expr& x, const Expr& y) { return Expr::make(Expr::Kind::mul, {}, {x, y}); }
Expr operator/(const Expr& x, const Expr& y) { return Expr::make(Expr::Kind::div, {}, {x, y}); }
Expr pow(const Expr& x, const Expr& y) { return Expr::make(Expr::Kind::pow, {}, {x, y}); }

Replacing::Replacing(std::vector<std::string>& names, const std::string& name) : names_(names) {
    const auto first = std::find(names.begin(), names.end(), name);
    if (first != names.end()) {
        std::string circle;
        for (auto it = first; it != names.end(); ++it) {
            circle += *it + " -> ";
        }
        throw InputError("the definitions are circular: " + circle + name,
                         "define each name by names that do not depend on it");
    }
    names_.push_back(name);
}

Definitions put_into_each_other(const Definitions& definitions) {
    Definitions done;
    std::vector<std::string> names;
    const std::function<const Expr&(const std::string&, const Expr&)> resolved =
        [&](const std::string& name, const Expr& formula) -> const Expr& {
        if (const auto it = done.find(name); it != done.end()) {
            return it->second;
        }
        const Replacing now(names, name);
        Expr e = formula;
        for (const std::string& part : free_symbols(formula)) {
            if (const auto it = definitions.find(part); it != definitions.end()) {
                e = substitute(e, part, resolved(part, it->second));
            }
        }
        return done.emplace(name, std::move(e)).first->second;
    };
    for (const auto& [name, formula] : definitions) {
        static_cast<void>(resolved(name, formula));
    }
    return done;
}

Expr put_in(const Definitions& resolved, Expr e) {
    for (const std::string& name : free_symbols(e)) {
        if (const auto it = resolved.find(name); it != resolved.end()) {
            e = substitute(e, name, it->second);
        }
    }
    return e;
}

} // namespace edgeproof::formula
