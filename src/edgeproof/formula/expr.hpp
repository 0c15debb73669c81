// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/formula/builtin.hpp"
#include "edgeproof/precision/real.hpp"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace edgeproof::formula {

/// An exact expression: an immutable tree, cheap to copy and safe to share between threads. Nothing
/// is simplified: the tree is exactly the written text, so that a misprint remains visible.
///
/// Number nodes are exact non-negative terminating decimals. `Expr::number` writes any other
/// rational as a quotient, or with a minus sign, as in the text of a formula.
class Expr {
public:
    enum class Kind {
        number,   ///< an exact rational
        pi,       ///< the constant, printed `Pi`
        symbol,   ///< a free or bound variable
        neg,      ///< -args[0]
        add,      ///< args[0] + args[1]; the operators below likewise
        sub,      //
        mul,      //
        div,      //
        pow,      //
        call,     ///< name(args...)
        integral, ///< integral(f, s, lo, hi): of f ds from lo to hi
        pv,       ///< pv(f, s, lo, hi, x): the same, a Cauchy principal value at s = x
        sum,      ///< sum(f, k, lo, hi): of f over the integers k = lo ... hi
    };

    /// The number 0.
    Expr();

    [[nodiscard]] static Expr number(const Rational& q);
    [[nodiscard]] static Expr pi();
    [[nodiscard]] static Expr symbol(std::string_view name);
    /// A call, or a binder if `name` is integral, pv or sum. Throws InputError for a wrong number
    /// of arguments of a built-in function, or a bound variable that is not a symbol.
    [[nodiscard]] static Expr call(std::string_view name, std::vector<Expr> args);
    /// A node of any kind with one to five children that otherwise copies `like` (name and place in
    /// the source).
    [[nodiscard]] static Expr with_args(const Expr& like, std::vector<Expr> args);
    /// The same expression with its place in the source text.
    [[nodiscard]] Expr located(std::size_t offset, std::size_t length) const;

    [[nodiscard]] Kind kind() const noexcept;
    /// The value of a number node (throws Error for other kinds; see rational()).
    [[nodiscard]] const Rational& number() const;
    /// The name of a symbol, a called function, or a binder; empty for other kinds.
    [[nodiscard]] const std::string& name() const noexcept;
    /// The called function; `Builtin::none` if it is not built in.
    [[nodiscard]] Builtin builtin() const noexcept;
    /// The children in the order of the text; the second child of a binder is its bound variable.
    [[nodiscard]] std::span<const Expr> args() const noexcept;
    [[nodiscard]] const Expr& arg(std::size_t i) const;
    [[nodiscard]] bool is_binder() const noexcept;
    /// The exact value if all leaves are rational numbers and the value is a rational of moderate
    /// size (exact roots are included: sqrt(4)), else nullptr.
    [[nodiscard]] const Rational* rational() const noexcept;

    /// The place in the parsed text (bytes from 0; length 0: not parsed).
    [[nodiscard]] std::size_t offset() const noexcept;
    [[nodiscard]] std::size_t length() const noexcept;

    /// Structural equality: places in the source are ignored, names of bound variables are
    /// compared.
    friend bool operator==(const Expr& x, const Expr& y);
    [[nodiscard]] std::size_t hash() const noexcept;
    /// 1 for a leaf.
    [[nodiscard]] std::size_t height() const noexcept;

    friend Expr operator-(const Expr& x);
    friend Expr operator+(const Expr& x, const Expr& y);
    friend Expr operator-(const Expr& x, const Expr& y);
    friend Expr operator*(const Expr& x, const Expr& y);
    friend Expr operator/(const Expr& x, const Expr& y);
    friend Expr pow(const Expr& x, const Expr& y);

    /// The greatest height of a tree, because functions on it are recursive. Builders throw Error.
    static constexpr std::size_t max_height = 2000;

private:
    struct Node;
    explicit Expr(std::shared_ptr<const Node> node) : node_(std::move(node)) {}
    /// `value`: the exact value, if known.
    static Expr make(Kind kind, std::string name, std::vector<Expr> args,
                     const Rational* value = nullptr);
    std::shared_ptr<const Node> node_;
};

/// The text of an expression, with only those parentheses that the tree requires, and parentheses
/// around a sign after an operator for readability. It parses to the same tree.
[[nodiscard]] std::string to_text(const Expr& e);

/// The LaTeX of an expression. `symbol` returns the LaTeX of a name, or an empty string for the
/// default: Greek names become Greek letters, trailing digits and the part after an underscore
/// become subscripts, and P1 and b2 become derivatives.
[[nodiscard]] std::string to_tex(const Expr& e,
                                 const std::function<std::string(std::string_view)>& symbol = {});

/// The names that are not bound by an enclosing integral, pv or sum.
[[nodiscard]] std::set<std::string> free_symbols(const Expr& e);
/// True if `name` is one of them.
[[nodiscard]] bool holds_symbol(const Expr& e, std::string_view name);
/// True if holds(part) is true for e or one of its parts.
template <class Predicate> [[nodiscard]] bool any_part(const Expr& e, const Predicate& holds) {
    return std::invoke(holds, e) ||
           std::ranges::any_of(e.args(), [&](const Expr& part) { return any_part(part, holds); });
}
/// True if the function `name` is called.
[[nodiscard]] bool holds_call(const Expr& e, std::string_view name);
/// True if an integral, pv or sum occurs.
[[nodiscard]] bool has_binder(const Expr& e);

/// Replaces every free `name` by `value`. Bound variables that would capture a name of `value` are
/// renamed.
[[nodiscard]] Expr substitute(const Expr& e, std::string_view name, const Expr& value);

/// Returns k of a name such as P2 or right_c1: one digit after the stem.
[[nodiscard]] std::optional<std::size_t> order_behind(std::string_view name, std::string_view stem);

/// The path from the root of a tree to a node: the index of the child at each step.
using Path = std::vector<std::size_t>;

/// All nodes except bound variables, each parent before its children, in the order of the text.
[[nodiscard]] std::vector<Path> paths(const Expr& e);
/// The node at a path. Throws Error if there is none.
[[nodiscard]] Expr at(const Expr& e, std::span<const std::size_t> path);
/// The tree with the node at `path` replaced. Throws Error if there is none.
[[nodiscard]] Expr replace(const Expr& e, std::span<const std::size_t> path, const Expr& value);

/// For unordered containers.
struct ExprHash {
    [[nodiscard]] std::size_t operator()(const Expr& e) const noexcept { return e.hash(); }
};

/// Names with their formulas, which may contain other names of the map.
using Definitions = std::map<std::string, Expr, std::less<>>;

/// Substitutes the definitions into each other, so that no result contains a defined name. Throws
/// InputError if a name depends on itself, with the cycle: "P2 -> P3 -> P2".
[[nodiscard]] Definitions put_into_each_other(const Definitions& definitions);

/// Returns e with the names replaced by the results of put_into_each_other.
[[nodiscard]] Expr put_in(const Definitions& resolved, Expr e);

/// Adds a name to those that are being replaced, and removes it in the destructor. Throws
/// InputError if the name is already among them.
class Replacing {
public:
    Replacing(std::vector<std::string>& names, const std::string& name);
    ~Replacing() { names_.pop_back(); }
    Replacing(const Replacing&) = delete;
    Replacing& operator=(const Replacing&) = delete;

private:
    std::vector<std::string>& names_;
};

/// Returns q as a quotient, 3/2 rather than 1.5.
[[nodiscard]] inline Expr quotient_of(const Rational& q) {
    const Expr top = Expr::number(Rational(numerator(q)));
    return denominator(q) == 1 ? top : top / Expr::number(Rational(denominator(q)));
}

} // namespace edgeproof::formula
