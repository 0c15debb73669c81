// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/counts/count.hpp"
#include "edgeproof/contact/law/shear.hpp"
#include "edgeproof/contact/witness/witness.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"
#include "edgeproof/scene/run_scene.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

namespace edgeproof::validation {

CountResult<CountFinding> count_values(const EnclosureCountOptions& options) {
    return count_contacts<CountFinding>(values_a_contact, options,
                                        [&options](std::size_t number, std::size_t values) {
                                            return count_contact(options, number, values);
                                        });
}

report::Table count_table(const EnclosureCountOptions& options,
                          const CountResult<CountFinding>& result) {
    report::Table t;
    t.title = std::to_string(result.total.values) + " values at " + std::to_string(options.digits) +
              " digits, seed " + std::to_string(options.seed);
    t.notes = {
        "excluded: the enclosure leaves out the value that the witness gives at twice the digits",
        "wrong: a printed digit is not that of a second enclosure at twice the digits, or of "
        "the witness",
        "wide: the enclosure is wider than 10 units of the last digit asked",
        "undecided: no enclosure, or no second value, within the budgets"};
    add_counts(t,
               {"profile",
                "regime",
                {sampled_profiles.begin(), sampled_profiles.end()},
                {sampled_regimes.begin(), sampled_regimes.end()}},
               {{"values", &CountCell::values},
                {"excluded", &CountCell::excluded},
                {"wrong", &CountCell::wrong},
                {"wide", &CountCell::wide},
                {"undecided", &CountCell::undecided}},
               result.cells, result.total);
    return t;
}

std::string text_of(const CountFinding& f) {
    return std::string(f.failed ? "FAILED" : "undecided") + ": " + f.asked + " (contact " +
           std::to_string(f.contact) + ", value " + std::to_string(f.value) + "): " + f.what +
           "\n  printed " + f.text + "\n  second  " + f.second + "\n" + f.scene;
}

namespace {

using scene::AskedValue;
using scene::Quantity;

constexpr std::size_t most_counted_terms = 4;
constexpr std::size_t mossakovskii_every = 64;
/// The allowed width of an enclosure, in units of the last printed digit.
constexpr long most_units = 10;

/// The enclosures of one contact at one number of digits, as in runs of scenes; points are separate
/// from coefficients, so that no approximations are computed at points.
class Enclosures {
public:
    Enclosures(const scene::Scene& scene, unsigned digits)
        : others_(scene,
                  {{.quantity = Quantity::p, .u = formula::Exact::of(Rational(1))},
                   {.quantity = Quantity::q, .u = formula::Exact::of(Rational(1))},
                   {Quantity::P}},
                  {digits, Rounding::nearest, false}),
          coefficients_(
              scene, {{Quantity::c, most_counted_terms - 1}, {Quantity::s, most_counted_terms - 1}},
              {digits, Rounding::nearest, false}) {}

    [[nodiscard]] scene::BoundedValue value(const AskedValue& asked) {
        return (row_of(asked.quantity).index == scene::QuantityRow::Index::order ? coefficients_
                                                                                 : others_)
            .value(asked);
    }

private:
    scene::SceneValues others_;
    scene::SceneValues coefficients_;
};

struct SecondValue {
    Real value;
    Real error;
};

/// The same values by the witness.
class SecondValues {
public:
    SecondValues(const scene::Scene& scene, unsigned digits)
        : digits_(digits), contact_(*scene.profile, scene.contact_modulus, scene.load, digits),
          shear_{scene.shear->Q, scene.shear->bulk_tension} {}

    [[nodiscard]] SecondValue value(const AskedValue& asked, std::size_t i) {
        const PrecisionScope scope(digits_ + 20);
        switch (asked.quantity) {
        case Quantity::p: {
            const bool mossakovskii =
                i % mossakovskii_every == mossakovskii_every / 2 && contact_.profile().symmetric();
            const Real p = contact_
                               .pressure(asked.edge, asked.u.value(),
                                         mossakovskii ? contact::Route::barber_mossakovskii
                                                      : contact::Route::singular_integral)
                               .value;
            return {p, Real(abs(p) * unit())};
        }
        case Quantity::q: {
            const contact::Extent<Real> extent{contact_.a(), contact_.b()};
            const auto at = point_at(extent, asked.edge, asked.u.value().to<Real>());
            return of_parts([&](const contact::ShearLoad<Real>& load) {
                return contact::full_stick_traction(at, load);
            });
        }
        case Quantity::s:
            return of_parts([&](const contact::ShearLoad<Real>& load) {
                return contact::full_stick_expansion(Real(contact_.a() + contact_.b()), load,
                                                     asked.edge, most_counted_terms)
                    .at(asked.k);
            });
        case Quantity::c: {
            auto& c = c_[asked.edge];
            if (c.empty()) {
                c = contact_.coefficients(asked.edge, most_counted_terms);
            }
            const Real natural =
                abs(c[0]) / pow(contact_.radius(asked.edge), static_cast<int>(asked.k));
            const Real size = std::max(Real(abs(c.at(asked.k))), natural);
            return {c.at(asked.k), Real(size * unit())};
        }
        default:
            break;
        }
        const Real x = asked.quantity == Quantity::P ? contact_.force() : contact_.b();
        return {x, Real(abs(x) * unit())};
    }

private:
    /// A value that is linear in the shear load. Q and the bulk tension may cancel.
    template <class Of> [[nodiscard]] SecondValue of_parts(const Of& of) const {
        const Real by_force = of({shear_.Q.to<Real>(), Real(0)});
        const Real by_tension = of({Real(0), shear_.bulk_tension.to<Real>()});
        return {Real(by_force + by_tension), Real((abs(by_force) + abs(by_tension)) * unit())};
    }
    [[nodiscard]] Real unit() const { return pow(Real(10), -static_cast<int>(digits_)); }

    unsigned digits_;
    contact::Witness contact_;
    contact::ShearSpec shear_;
    std::map<contact::Edge, std::vector<Real>> c_;
};

/// Returns the unit of the last of `digits` digits of x.
Real last_unit(const Real& x, unsigned digits) {
    const PrecisionScope scope(40);
    const Real size = abs(x);
    return pow(Real(10), Real(floor(log10(size)))) * pow(Real(10), 1 - static_cast<int>(digits));
}

} // namespace

std::string held_to(const scene::BoundedValue& first, const scene::BoundedValue& finer,
                    const Real& second, const Real& error, unsigned digits, CountCell& cell) {
    const scene::Digits asked{digits, Rounding::nearest, false};
    ++cell.values;
    if (!first.proved || !finer.proved) {
        ++cell.undecided;
        return "no enclosure: " + (first.proved ? finer : first).how();
    }
    std::string wrong;
    const long bits = std::max<long>(first.value.bits(),
                                     static_cast<long>(mpfr_get_prec(second.backend().data())));
    const Ball other = Ball::around(second, error, bits);
    if (!isfinite(second) || disjoint(first.value, other) || disjoint(first.value, finer.value)) {
        ++cell.excluded;
        wrong = "the enclosure excludes the second value";
    }
    const std::string text = printed(first, asked).text;
    if (text == "0") {
        // Zero cannot be excluded; then the finer enclosure must contain zero, too.
        if (!contains_zero(finer.value)) {
            ++cell.wrong;
            wrong +=
                (wrong.empty() ? "" : "; ") + std::string("0 is printed for a value that is not 0");
        }
        return wrong;
    }
    const Rounded again = round_ball(finer.value, digits);
    const Rounded by_other = round_ball(other, digits);
    if (text != again.text || (by_other.complete && text != by_other.text)) {
        ++cell.wrong;
        wrong += (wrong.empty() ? "" : "; ") + std::string("the digits printed are not those of ") +
                 (text != again.text ? "the finer enclosure, " + again.text : "the second value");
    }
    const PrecisionScope scope(40);
    if (2 * first.value.radius() > most_units * last_unit(first.value.midpoint(), digits)) {
        ++cell.wide;
        wrong += (wrong.empty() ? "" : "; ") + std::string("the enclosure is too wide");
    }
    return wrong;
}

CountedContact<CountFinding> count_contact(const EnclosureCountOptions& options, std::size_t number,
                                           std::size_t values) {
    CountedContact<CountFinding> found;
    const SampledContact contact = sampled_contact(options.seed, number, values);
    std::optional<Enclosures> coarse;
    std::optional<Enclosures> fine;
    std::optional<SecondValues> others;
    for (std::size_t i = 0; i < values; ++i) {
        check_interruption();
        const SampledValue& v = contact.values[i];
        CountCell& cell = found.cells[contact.profile * sampled_regimes.size() + v.regime];
        CountFinding finding{number, i, false, "", text_of(v.asked), "", "", contact.text};
        const std::size_t failures = cell.failures();
        const std::size_t counted = cell.values;
        try {
            if (!coarse) {
                coarse.emplace(contact.scene, options.digits);
                fine.emplace(contact.scene, 2 * options.digits);
                others.emplace(contact.scene, 2 * options.digits);
            }
            const scene::BoundedValue first = coarse->value(v.asked);
            SecondValue second = others->value(v.asked, i);
            if (options.second) {
                options.second(v, second.value);
            }
            finding.text = printed(first, {options.digits, Rounding::nearest, false}).text;
            finding.second = to_decimal(second.value, 2 * options.digits);
            finding.what = held_to(first, fine->value(v.asked), second.value, second.error,
                                   options.digits, cell);
        } catch (const Error& error) {
            cell.values = counted + 1;
            ++cell.undecided;
            finding.what = error.what();
        }
        finding.failed = cell.failures() > failures;
        if (!finding.what.empty()) {
            found.findings.push_back(std::move(finding));
        }
    }
    return found;
}

} // namespace edgeproof::validation
