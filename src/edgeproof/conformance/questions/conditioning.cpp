// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/conformance/questions/reference.hpp"

#include "edgeproof/precision/rational.hpp"
#include "edgeproof/precision/rounding/text.hpp"

#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace edgeproof::conformance {
namespace {

constexpr unsigned neighbour_digits = 34;

/// Returns x plus or minus half a unit in the last place of its binary64; nothing for zero.
std::optional<formula::Exact> neighbour(const formula::Exact& x, int side) {
    const double near = std::abs(x.to<Real>().convert_to<double>());
    if (near == 0 || !std::isfinite(near)) {
        return {};
    }
    const double ulp = std::nextafter(near, std::numeric_limits<double>::infinity()) - near;
    if (!std::isfinite(ulp)) {
        return {};
    }
    const Rational half = exact_rational(ulp) * side / 2;
    if (x.is_rational()) {
        return formula::Exact::of(Rational(x.rational() + half));
    }
    return formula::Exact(x.expr() + formula::Expr::number(half));
}

/// One number of a contact.
struct Number {
    std::size_t parameter; ///< index
    std::size_t item;      ///< index into the items of the parameter
    formula::Exact value;
};

std::vector<Number> numbers_of(const AskedContact& contact) {
    std::vector<Number> numbers;
    for (std::size_t i = 0; i < contact.parameters.size(); ++i) {
        const Parameter& p = contact.parameters[i];
        if (!p.is_word()) {
            for (std::size_t k = 0; const std::string& item : p.items()) {
                numbers.push_back({i, k++, formula::Exact::parse(item)});
            }
        }
    }
    return numbers;
}

/// Returns the contact with one of its numbers changed, or nothing if there is no such contact.
std::optional<AskedContact> moved_contact(const AskedContact& contact, const Number& number,
                                          int side, const std::string& file, std::size_t line) {
    const auto value = neighbour(number.value, side);
    if (!value) {
        return {};
    }
    std::vector<Parameter> parameters = contact.parameters;
    std::vector<std::string> items = parameters[number.parameter].items();
    items[number.item] = value->text();
    parameters[number.parameter].set_items(items);
    try {
        return make_asked_contact(std::move(parameters), file, line);
    } catch (const Error&) { // no contact on this side
        return {};
    }
}

/// A question, and the index of a number: those of the contact, then u or the tolerance.
using Change = std::pair<std::size_t, std::size_t>;

class Neighbours {
public:
    Neighbours(const Questions& questions, const std::vector<std::size_t>& which)
        : questions_(questions), which_(which) {
        for (const std::size_t i : which) {
            const std::size_t contact = questions.list[i].contact;
            if (!numbers_.contains(contact)) {
                numbers_.emplace(contact, numbers_of(questions.contacts[contact]));
            }
        }
    }

    /// Computes the values of the questions with one number changed, if they are not known yet.
    void find(int side, const ReferenceOptions& options) {
        Questions asked{questions_.file, {}, {}};
        std::vector<Change> changes;
        std::map<std::pair<std::size_t, std::size_t>, std::optional<std::size_t>> contacts;
        for (const std::size_t i : which_) {
            const Question& q = questions_.list[i];
            const std::vector<Number>& numbers = numbers_.at(q.contact);
            for (std::size_t n = 0; n < numbers.size() + (q.u || q.tolerance ? 1 : 0); ++n) {
                const bool of_contact = n < numbers.size();
                if (values_.contains({i, n})) {
                    continue;
                }
                const auto [found, is_new] = contacts.try_emplace({q.contact, n});
                if (is_new) {
                    const AskedContact& same = questions_.contacts[q.contact];
                    auto contact =
                        of_contact ? moved_contact(same, numbers[n], side, questions_.file, q.line)
                                   : same;
                    if (contact) {
                        found->second = asked.contacts.size();
                        asked.contacts.push_back(std::move(*contact));
                    }
                }
                Question changed = q;
                std::optional<formula::Exact>& place = q.u ? changed.u : changed.tolerance;
                if (!of_contact) {
                    place = neighbour(*place, side);
                }
                if (found->second && (of_contact || place)) { // else it is beyond a double's range
                    changed.contact = *found->second;
                    asked.list.push_back(std::move(changed));
                    changes.emplace_back(i, n);
                }
            }
        }
        const auto found = references_where_any(asked, options);
        for (std::size_t k = 0; k < found.size(); ++k) {
            if (found[k]) {
                values_.emplace(changes[k], found[k]->value.value.midpoint());
            }
        }
    }

    /// Returns nothing if a number other than 0 has no neighbour with a value.
    [[nodiscard]] std::optional<Conditioning> of(std::size_t i, const Real& exact) const {
        const Question& q = questions_.list[i];
        const std::vector<Number>& numbers = numbers_.at(q.contact);
        Real sum = 0;
        for (std::size_t n = 0; n < numbers.size() + (q.u || q.tolerance ? 1 : 0); ++n) {
            const auto found = values_.find({i, n});
            if (found != values_.end()) {
                sum += abs(Real(found->second / exact - 1));
            } else if (n >= numbers.size() || numbers[n].value.sign() != 0) {
                return {};
            }
        }
        return Conditioning{sum.convert_to<double>()};
    }

private:
    const Questions& questions_;
    const std::vector<std::size_t>& which_;
    std::map<std::size_t, std::vector<Number>> numbers_; ///< by contact
    std::map<Change, Real> values_;
};

} // namespace

std::vector<std::optional<Conditioning>> conditioning(const Questions& questions,
                                                      const std::vector<Reference>& references,
                                                      const std::vector<std::size_t>& which,
                                                      ReferenceOptions options) {
    options.digits = {neighbour_digits, Rounding::nearest, false};
    const PrecisionScope scope(neighbour_digits + 10);
    Neighbours neighbours(questions, which);
    neighbours.find(1, options);
    neighbours.find(-1, options);
    std::vector<std::optional<Conditioning>> result(questions.list.size());
    for (const std::size_t i : which) {
        const Ball& value = references[i].value.value;
        if (!contains_zero(value)) {
            result[i] = neighbours.of(i, value.midpoint());
        }
    }
    return result;
}

} // namespace edgeproof::conformance
