// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/sample/gradient_rank.hpp"

#include "edgeproof/audit/sample/formal_values.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace edgeproof::audit {
namespace {

using formula::Expr;

constexpr std::size_t gradient_draws = 4;
constexpr long gradient_bits = 800;
constexpr std::size_t most_products = 200; ///< in a symbolic determinant

bool is_zero_expr(const Expr& e) { return e.rational() != nullptr && *e.rational() == 0; }

using Matrix = std::vector<std::vector<Expr>>;

bool contains(const std::vector<std::size_t>& list, std::size_t i) {
    return std::ranges::find(list, i) != list.end();
}

/// Expands the determinant of these columns of the last rows along its first row; returns nothing
/// if it has too many products.
std::optional<Expr> determinant(const Matrix& m, const std::vector<std::size_t>& columns,
                                std::size_t& products) {
    if (columns.empty()) {
        return Expr::number(1);
    }
    std::optional<Expr> sum;
    for (std::size_t j = 0; j < columns.size(); ++j) {
        const Expr& entry = m[m.size() - columns.size()][columns[j]];
        if (is_zero_expr(entry)) {
            continue;
        }
        if (++products > most_products) {
            return std::nullopt;
        }
        std::vector<std::size_t> rest = columns;
        rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(j));
        const auto minor = determinant(m, rest, products);
        if (!minor) {
            return std::nullopt;
        }
        if (is_zero_expr(*minor)) {
            continue;
        }
        const Expr term = entry * *minor;
        if (!sum) {
            sum = j % 2 == 0 ? term : -term;
        } else {
            sum = j % 2 == 0 ? *sum + term : *sum - term;
        }
    }
    return sum.value_or(Expr::number(0));
}

/// Returns the position of the entry with the greatest certain distance from zero.
std::optional<std::pair<std::size_t, std::size_t>>
pivot_of(const std::vector<std::vector<Ball>>& rows, const std::vector<std::size_t>& used) {
    std::optional<std::pair<std::size_t, std::size_t>> best;
    std::optional<Real> most;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (contains(used, i)) {
            continue;
        }
        for (std::size_t j = 0; j < rows[i].size(); ++j) {
            if (contains_zero(rows[i][j])) {
                continue;
            }
            const Real size = abs(rows[i][j]).lower();
            if (!most || size > *most) {
                most = size;
                best = {i, j};
            }
        }
    }
    return best;
}

void subtract(std::vector<Ball>& from, const std::vector<Ball>& pivots_row, std::size_t column) {
    const Ball factor = from[column] / pivots_row[column];
    for (std::size_t j = 0; j < from.size(); ++j) {
        from[j] = j == column ? Ball(0, from[j].bits()) : from[j] - factor * pivots_row[j];
    }
}

} // namespace

GradientRank::GradientRank(const Expr& of, const std::vector<Expr>& others,
                           const SymbolicCase& under)
    : under_(under) {
    std::set<std::string> names = free_symbols(of);
    for (const Expr& e : others) {
        names.merge(free_symbols(e));
    }
    names_.assign(names.begin(), names.end());
    columns_ = names_;
    try {
        of_ = gradient(of);
        for (const Expr& e : others) {
            others_.push_back(gradient(e));
        }
        drop_equal_columns();
        std::optional<Eliminated> best;
        for (std::size_t draw = 0; draw < gradient_draws; ++draw) {
            check_interruption();
            auto found = eliminate(draw);
            if (found && (!best || found->rows.size() > best->rows.size())) {
                best = std::move(found);
            }
        }
        if (best) {
            decide(*best);
        } else {
            problem_ = "the gradients have no enclosures at the points drawn";
        }
    } catch (const InputError&) {
        throw;
    } catch (const Error& error) {
        problem_ = error.what();
    }
}

GradientRank::Row GradientRank::gradient(const Expr& e) const {
    Row row;
    const std::set<std::string> held = free_symbols(e);
    for (const std::string& name : columns_) {
        row.push_back(held.contains(name) ? derivative(e, name) : Expr::number(0));
    }
    return row;
}

/// Formulas that depend only on a + b have equal derivatives with respect to a and b.
void GradientRank::drop_equal_columns() {
    for (std::size_t j = columns_.size(); j-- > 1;) {
        const auto equals = [&](std::size_t i) {
            return of_[i] == of_[j] && std::all_of(others_.begin(), others_.end(),
                                                   [&](const Row& r) { return r[i] == r[j]; });
        };
        std::size_t first = 0;
        while (first < j && !equals(first)) {
            ++first;
        }
        if (first == j) {
            continue;
        }
        const auto at = static_cast<std::ptrdiff_t>(j);
        columns_.erase(columns_.begin() + at);
        of_.erase(of_.begin() + at);
        for (Row& row : others_) {
            row.erase(row.begin() + at);
        }
    }
}

std::optional<GradientRank::Eliminated> GradientRank::eliminate(std::size_t draw) const {
    const FormalValues values({names_.begin(), names_.end()}, under_, draw);
    const auto enclose = [&](const Row& row) {
        std::vector<Ball> balls;
        for (const Expr& e : row) {
            balls.push_back(values.enclose(e, gradient_bits));
        }
        return balls;
    };
    Eliminated found;
    std::vector<std::vector<Ball>> rows;
    for (const Row& row : others_) {
        rows.push_back(enclose(row));
    }
    found.left = enclose(of_);
    const auto finite = [](const std::vector<Ball>& row) {
        return std::all_of(row.begin(), row.end(), [](const Ball& x) { return x.is_finite(); });
    };
    if (!finite(found.left) || !std::all_of(rows.begin(), rows.end(), finite)) {
        return std::nullopt;
    }
    while (const auto pivot = pivot_of(rows, found.rows)) {
        const auto [row, column] = *pivot;
        found.rows.push_back(row);
        found.columns.push_back(column);
        for (std::size_t i = 0; i < rows.size(); ++i) {
            if (!contains(found.rows, i)) {
                subtract(rows[i], rows[row], column);
            }
        }
        subtract(found.left, rows[row], column);
    }
    for (const std::string& name : names_) {
        const Real value = values.values().at(name);
        found.at += (found.at.empty() ? "" : ", ") + name + " = " + value.str(10);
    }
    return found;
}

bool GradientRank::adds_nothing(const Row& row, const Eliminated& pivots) const {
    Matrix rows{row};
    for (const std::size_t r : pivots.rows) {
        rows.push_back(others_[r]);
    }
    for (std::size_t j = 0; j < columns_.size(); ++j) {
        if (contains(pivots.columns, j)) {
            continue;
        }
        std::vector<std::size_t> bordered = pivots.columns;
        bordered.push_back(j);
        std::size_t products = 0;
        const auto d = determinant(rows, bordered, products);
        if (!d || !proved_equal(*d, Expr::number(0), under_)) {
            return false;
        }
    }
    return true;
}

bool GradientRank::others_add_nothing(const Eliminated& pivots) const {
    for (std::size_t i = 0; i < others_.size(); ++i) {
        if (!contains(pivots.rows, i) && !adds_nothing(others_[i], pivots)) {
            return false;
        }
    }
    return true;
}

/// True if the quantity certainly changes with a name that no other formula contains.
bool GradientRank::by_own_name(const Eliminated& pivots) {
    for (std::size_t j = 0; j < columns_.size(); ++j) {
        const bool own = std::all_of(others_.begin(), others_.end(),
                                     [&](const Row& row) { return is_zero_expr(row[j]); });
        if (own && !contains_zero(pivots.left[j])) {
            outside_ = abs(pivots.left[j]);
            return true;
        }
    }
    return false;
}

void GradientRank::decide(const Eliminated& pivots) {
    at_ = pivots.at;
    if (by_own_name(pivots)) {
        return;
    }
    const std::size_t rank = pivots.rows.size();
    // The others span all directions, so that any quantity is a function of them.
    if (rank == columns_.size()) {
        rank_ = rank;
        return;
    }
    if (rank < others_.size() && !others_add_nothing(pivots)) {
        problem_ = "the rank of the gradients of the others is not proved";
        return;
    }
    for (const Ball& left : pivots.left) {
        if (!contains_zero(left)) {
            outside_ = abs(left);
            return;
        }
    }
    if (adds_nothing(of_, pivots)) {
        rank_ = rank;
    } else {
        problem_ = "its gradient is a combination of the others at the points drawn, but this is "
                   "not proved by symbols";
    }
}

} // namespace edgeproof::audit
