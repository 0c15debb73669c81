// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/conformance/questions/conditioning.hpp"

#include "edgeproof/precision/exact_rational.hpp"
#include "edgeproof/precision/rounding/text.hpp"

#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <utility>

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

/// Returns the text of a parameter with its nth number changed; nothing if that is zero.
std::optional<std::string> moved_text(const Parameter& p, std::size_t n, int side) {
    std::vector<std::string> items =
        is_list_key(p.key) ? list_items(p.text) : std::vector<std::string>{p.text};
    const auto moved = neighbour(formula::Exact::parse(items[n]), side);
    if (!moved) {
        return {};
    }
    items[n] = moved->text();
    std::string text;
    for (const std::string& item : items) {
        text += (text.empty() ? "" : "; ") + item;
    }
    return text;
}

/// One number of a contact: the index of the parameter, and of the item in it.
struct Number {
    std::size_t parameter;
    std::size_t item;
};

std::vector<Number> numbers_of(const AskedContact& contact) {
    std::vector<Number> numbers;
    for (std::size_t i = 0; i < contact.parameters.size(); ++i) {
        const Parameter& p = contact.parameters[i];
        if (is_word_key(p.key)) {
            continue;
        }
        const std::size_t items = is_list_key(p.key) ? list_items(p.text).size() : 1;
        for (std::size_t k = 0; k < items; ++k) {
            numbers.push_back({i, k});
        }
    }
    return numbers;
}

/// True if the modulus is only a scale factor: a is given and there is no shear.
bool scales(const AskedContact& contact, const Parameter& p) {
    return p.key == "contact_modulus" &&
           contact.scene.load.kind == contact::Load::Kind::right_edge && !contact.scene.shear &&
           !contact.scene.punch;
}

/// Questions with changed numbers, and the origin of each.
class Neighbours {
public:
    Neighbours(const Questions& questions, int side) : questions_(questions), side_(side) {
        asked_.file = questions.file;
    }
    /// Adds the question with the nth of its numbers changed; the order is the numbers of the
    /// contact, u, the tolerance.
    void add(std::size_t question, std::size_t n) {
        Question q = questions_.list[question];
        const AskedContact& contact = questions_.contacts[q.contact];
        const std::vector<Number> numbers = numbers_of(contact);
        if (n < numbers.size()) {
            const auto [found, is_new] = contacts_.emplace(std::pair{q.contact, n}, none);
            if (is_new) {
                found->second = moved_contact(contact, numbers[n], q.line);
            }
            if (found->second == none) {
                return;
            }
            q.contact = found->second;
        } else {
            q.contact = unmoved(q.contact);
            std::optional<formula::Exact>& place = q.u ? q.u : q.tolerance;
            place = neighbour(*place, side_);
            if (!place) { // beyond the range of a double
                return;
            }
        }
        asked_.list.push_back(std::move(q));
        of_.emplace_back(question, n);
    }
    /// The references, by question and number.
    [[nodiscard]] std::map<std::pair<std::size_t, std::size_t>, Real>
    values(const ReferenceOptions& options) const {
        std::map<std::pair<std::size_t, std::size_t>, Real> values;
        const auto found = references_where_any(asked_, options);
        for (std::size_t i = 0; i < found.size(); ++i) {
            if (found[i]) {
                values.emplace(of_[i], found[i]->value.value.midpoint());
            }
        }
        return values;
    }

private:
    static constexpr std::size_t none = static_cast<std::size_t>(-1);

    std::size_t moved_contact(const AskedContact& contact, const Number& n, std::size_t line) {
        std::vector<Parameter> parameters = contact.parameters;
        Parameter& p = parameters[n.parameter];
        const auto text = moved_text(p, n.item, side_);
        if (!text) {
            return none;
        }
        p.text = *text;
        try {
            asked_.contacts.push_back(
                make_asked_contact(std::move(parameters), questions_.file, line));
        } catch (const Error&) { // no contact on this side
            return none;
        }
        return asked_.contacts.size() - 1;
    }
    std::size_t unmoved(std::size_t contact) {
        const auto [found, is_new] = unmoved_.emplace(contact, asked_.contacts.size());
        if (is_new) {
            asked_.contacts.push_back(questions_.contacts[contact]);
        }
        return found->second;
    }

    const Questions& questions_;
    int side_;
    Questions asked_;
    std::vector<std::pair<std::size_t, std::size_t>> of_;
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> contacts_;
    std::map<std::size_t, std::size_t> unmoved_;
};

std::size_t count_of_numbers(const Questions& questions, const Question& q) {
    return numbers_of(questions.contacts[q.contact]).size() + (q.u || q.tolerance ? 1 : 0);
}

bool is_zero(const Questions& questions, const Question& q, std::size_t n) {
    const AskedContact& contact = questions.contacts[q.contact];
    const auto numbers = numbers_of(contact);
    if (n >= numbers.size()) {
        return false;
    }
    const Parameter& p = contact.parameters[numbers[n].parameter];
    const std::string text = is_list_key(p.key) ? list_items(p.text)[numbers[n].item] : p.text;
    return formula::Exact::parse(text).sign() == 0;
}

} // namespace

std::vector<std::optional<Conditioning>> conditioning(const Questions& questions,
                                                      const std::vector<Reference>& references,
                                                      const std::vector<std::size_t>& which,
                                                      ReferenceOptions options) {
    options.digits = {neighbour_digits, Rounding::nearest, false};
    const PrecisionScope scope(neighbour_digits + 10);
    std::vector<std::optional<Conditioning>> result(questions.list.size());
    std::map<std::pair<std::size_t, std::size_t>, Real> moved;
    const auto scaled = [&](const Question& q, std::size_t n) {
        const AskedContact& contact = questions.contacts[q.contact];
        const auto numbers = numbers_of(contact);
        return n < numbers.size() && scales(contact, contact.parameters[numbers[n].parameter]);
    };
    for (const int side : {1, -1}) {
        Neighbours neighbours(questions, side);
        for (const std::size_t i : which) {
            const Question& q = questions.list[i];
            for (std::size_t n = 0; n < count_of_numbers(questions, q); ++n) {
                if (!moved.contains({i, n}) && !scaled(q, n)) {
                    neighbours.add(i, n);
                }
            }
        }
        moved.merge(neighbours.values(options));
    }
    for (const std::size_t i : which) {
        const Question& q = questions.list[i];
        const Ball& value = references[i].value.value;
        if (contains_zero(value)) {
            continue;
        }
        const Real exact = value.midpoint();
        Real sum = 0;
        bool complete = true;
        for (std::size_t n = 0; n < count_of_numbers(questions, q); ++n) {
            if (scaled(q, n)) {
                const formula::Exact modulus = formula::Exact::parse(
                    parameter_text(questions.contacts[q.contact], "contact_modulus"));
                const bool moves = row_of(q.quantity).force_power != 0;
                const auto above = neighbour(modulus, 1);
                if (moves && above) {
                    sum += abs(Real(above->to<Real>() / modulus.to<Real>() - 1));
                }
                continue;
            }
            const auto found = moved.find({i, n});
            if (found != moved.end()) {
                sum += abs(Real(found->second / exact - 1));
            } else {
                complete = complete && is_zero(questions, q, n);
            }
        }
        if (complete) {
            result[i] = Conditioning{sum.convert_to<double>()};
        }
    }
    return result;
}

} // namespace edgeproof::conformance
