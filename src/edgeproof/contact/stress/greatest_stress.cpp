// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/contact/stress/greatest_stress.hpp"

#include "edgeproof/contact/stress/isolated_pair.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <string>
#include <utility>

namespace edgeproof::contact {
namespace {

using Kind = GreatestPlace::Kind;

Ball zero_like(const Ball& x) { return {0, x.bits()}; }

/// The place near (x, z) at which the derivatives of F by the free coordinates are zero.
std::optional<BallPair> stationary(const StressMeasure& F, Kind kind, const Ball& x,
                                   const Ball& z) {
    const auto equations = [&](const BallPair& at) -> PairOfEquations {
        if (kind != Kind::surface && !certainly_positive(at[1])) {
            const Ball unknown = unknown_ball(at[1].bits());
            return {{unknown, unknown}, {{{unknown, unknown}, {unknown, unknown}}}};
        }
        const PlaneJet j = F.jet(Box(at[0], at[1]));
        const auto& [xx, xz, zz] = j.second;
        return {j.first, {{{xx, xz}, {xz, zz}}}};
    };
    return isolated_pair(equations, {x, z}, {kind != Kind::axis, kind != Kind::surface});
}

/// A rectangle in units of a power of two, with its middle and its half widths, which are powers of
/// two: it is represented exactly, and ends exactly at z = 0 where it meets the surface.
struct Cell {
    double x;
    double z;
    double half_x;
    double half_z;
    [[nodiscard]] bool on_surface() const { return z == half_z; }
    [[nodiscard]] std::array<Cell, 2> halves(bool across) const {
        Cell one = *this;
        double& half = across ? one.half_x : one.half_z;
        half /= 2;
        Cell other = one;
        (across ? one.x : one.z) -= half;
        (across ? other.x : other.z) += half;
        return {one, other};
    }
    /// True if its halves are exact, so that together they are the whole of it.
    [[nodiscard]] bool has_halves() const {
        constexpr double places = 0x1p52;
        return half_x >= least_half && std::abs(x) <= half_x * places && z <= half_z * places;
    }
    /// Below this part of the contact no boxes are divided.
    static constexpr double least_half = 0x1p-60;
};

/// Branch and bound over the half-plane: boxes in the order of their upper bounds of F.
class Search {
public:
    Search(const StressMeasure& F, std::size_t most_boxes)
        : F_(F), bits_(F.field().bits()), most_boxes_(most_boxes), surface_(F.on_surface_only()) {
        const Real size = max(F.field().contact().a(), F.field().contact().b()).upper();
        scale_ = mpfr_get_exp(raw(size));
    }

    GreatestStress run() {
        sample();
        find_edges();
        const double end = outer_end();
        const double depth = surface_ ? 0 : end / 2;
        for (const double x : {-end / 2, end / 2}) {
            add({x, depth, end / 2, depth});
        }
        while (!open_.empty() && open_.top().upper >= best_) {
            check_interruption();
            const Cell cell = open_.top().cell;
            const Real upper = open_.top().upper;
            open_.pop();
            if (is_decided(cell) || decide(cell)) {
                continue;
            }
            if (boxes_ >= most_boxes_ || !cell.has_halves()) {
                refuse(upper);
            }
            for (const Cell& half : cell.halves(cell.half_x >= cell.half_z)) {
                add(half);
            }
        }
        return result();
    }

private:
    static constexpr double farthest = 0x1p40;

    struct Open {
        Real upper;
        Cell cell;
        friend bool operator<(const Open& x, const Open& y) { return x.upper < y.upper; }
    };

    [[nodiscard]] Ball number(double middle, double half = 0) const {
        Ball x(0, bits_);
        arf_set_d(arb_midref(x.data()), middle);
        if (half != 0) {
            mag_set_ui_2exp_si(arb_radref(x.data()), 1, std::ilogb(half));
        }
        arb_mul_2exp_si(x.data(), x.data(), scale_);
        return x;
    }
    [[nodiscard]] Box box(const Cell& c) const {
        return {number(c.x, c.half_x), number(c.z, c.half_z)};
    }
    void raise(const Ball& F) {
        if (F.is_finite() && best_ < F.lower()) {
            best_ = F.lower();
        }
    }
    void sample() {
        constexpr int places = 24;
        constexpr int depths = 8;
        for (int i = -places; i <= places; ++i) {
            for (int j = surface_ ? depths : 0; j <= depths; ++j) {
                raise(F_.bound(
                    Box(number(1.5 * i / places), number(j == depths ? 0 : std::ldexp(2.0, -j)))));
            }
        }
    }
    /// The half width of a square outside of which F is less than in a place found.
    [[nodiscard]] double outer_end() const {
        for (double end = 4; end <= farthest; end *= 2) {
            if (F_.far(number(end - 1)).upper() < best_) {
                return end;
            }
        }
        refuse(F_.far(number(farthest - 1)).upper());
    }
    [[noreturn]] void refuse(const Real& upper) const {
        const auto text = [&](const Real& F) {
            return F_.stress(Ball(F, bits_)).midpoint().str(8);
        };
        throw BudgetError(std::to_string(boxes_) +
                          " boxes do not decide at which one place the stress is greatest: its "
                          "greatest value is between " +
                          text(best_) + " and " + text(upper));
    }

    /// Keeps the cell unless F is proved to be greater elsewhere than in any part of it that is
    /// not decided.
    void add(const Cell& cell) {
        if (F_.field().mirrored && cell.x + cell.half_x <= 0) {
            return;
        }
        ++boxes_;
        const Box zeta = box(cell);
        const Ball bound = F_.bound(zeta);
        std::optional<Real> upper;
        if (bound.is_finite()) {
            upper = bound.upper();
            if (*upper < best_) {
                return;
            }
        }
        const Box middle = zeta.middle();
        const PlaneJet over = F_.jet(zeta);
        if (over.value.is_finite() && (!upper || over.value.upper() < *upper)) {
            upper = over.value.upper();
            if (*upper < best_) {
                return;
            }
        }
        if (!over.is_finite()) {
            raise(F_.bound(middle));
        } else {
            // Both derivatives vanish at the place; on the surface F may increase towards it.
            const auto& [by_x, by_z] = over.first;
            if (!contains_zero(by_x) ||
                (!surface_ &&
                 (certainly_positive(by_z) || (!cell.on_surface() && certainly_negative(by_z))))) {
                return;
            }
            const PlaneJet at = F_.jet(middle);
            raise(at.value);
            const Ball x = number(0, cell.half_x);
            const Ball z = number(0, cell.half_z);
            const auto& [xx, xz, zz] = over.second;
            const Ball taylor = at.value + at.first[0] * x + at.first[1] * z +
                                (xx * x * x + zz * z * z) / 2 + xz * x * z;
            if (taylor.is_finite() && (!upper || taylor.upper() < *upper)) {
                upper = taylor.upper();
            }
        }
        if (!upper) {
            upper = std::numeric_limits<Real>::infinity();
        }
        if (*upper >= best_) {
            open_.push({*upper, cell});
        }
    }

    [[nodiscard]] bool is_decided(const Cell& cell) const {
        const Box zeta = box(cell);
        return std::ranges::any_of(places_, [&](const GreatestPlace& place) {
            if (place.kind == Kind::edge) { // a half disc, by its radius
                return certainly_less(abs(Box(zeta.real() - place.x, zeta.imaginary())),
                                      place.region.real());
            }
            return contains(place.region.real(), zeta.real()) &&
                   contains(place.region.imaginary(), zeta.imaginary());
        });
    }

    /// Adds the place of a region around the cell in which F is concave, or increases towards the
    /// surface and is concave along it: then it is the only one there.
    bool decide(const Cell& cell) {
        const PlaneJet own = F_.jet(box(cell));
        if (!own.is_finite() || !(own.concave() || is_greatest_on_surface(cell, own))) {
            return false;
        }
        for (const double factor : {8.0, 4.0, 2.0, 1.0}) {
            Cell region{cell.x, cell.z, cell.half_x * factor, cell.half_z * factor};
            if (cell.on_surface()) {
                region.z = region.half_z;
            } else if (region.z < region.half_z) {
                continue;
            }
            if (decide_in(region)) {
                return is_decided(cell);
            }
        }
        return false;
    }
    /// True if F is less inside, where that counts, and concave along the surface.
    [[nodiscard]] bool is_greatest_on_surface(const Cell& cell, const PlaneJet& over) const {
        return cell.on_surface() && certainly_negative(over.second[0]) &&
               (surface_ || certainly_negative(over.first[1]));
    }
    bool decide_in(const Cell& region) {
        const Box zeta = box(region);
        const PlaneJet over = F_.jet(zeta);
        if (!over.is_finite()) {
            return false;
        }
        const auto found = [&](Kind kind, double x, double z) {
            GreatestPlace place{.kind = kind, .region = zeta, .x = number(x), .z = number(z)};
            const auto at = refined(F_, place);
            if (at) {
                raise(at->F);
                places_.push_back(*at);
            }
            return at.has_value();
        };
        if (is_greatest_on_surface(region, over)) {
            return found(Kind::surface, region.x, 0);
        }
        if (surface_ || !over.concave()) {
            return false;
        }
        const bool axis = F_.field().mirrored && std::abs(region.x) < region.half_x;
        return (axis && found(Kind::axis, 0, region.z)) || found(Kind::inside, region.x, region.z);
    }

    /// Finds the edges at which F has a cusp, each with a half disc in which it is less elsewhere.
    void find_edges() {
        constexpr int largest = -2;
        constexpr int smallest = -24;
        const StressMeasure turned = F_.reflected();
        for (std::size_t part = 0; part < F_.field().parts.size(); ++part) {
            for (const Edge edge : {Edge::right, Edge::left}) {
                if (edge == Edge::left && F_.field().mirrored) {
                    continue;
                }
                const StressMeasure& F = edge == Edge::right ? F_ : turned;
                for (int i = largest; i >= smallest; --i) {
                    const Ball radius = number(std::ldexp(1.0, i));
                    if (F.greatest_at_right_edge(part, radius)) {
                        const auto place = refined(F_, {.kind = Kind::edge,
                                                        .part = part,
                                                        .edge = edge,
                                                        .region = Box(radius)});
                        if (place) {
                            raise(place->F);
                            places_.push_back(*place);
                        }
                        break;
                    }
                }
            }
        }
    }

    [[nodiscard]] GreatestStress result() {
        std::ranges::sort(places_, [](const GreatestPlace& x, const GreatestPlace& y) {
            return x.F.midpoint() > y.F.midpoint();
        });
        std::vector<GreatestPlace> first;
        for (const GreatestPlace& place : places_) {
            const bool known = std::ranges::any_of(first, [&](const GreatestPlace& other) {
                return other.kind != Kind::edge && contains(other.region.real(), place.x) &&
                       contains(other.region.imaginary(), place.z);
            });
            if (!known && !certainly_less(place.F, places_.front().F)) {
                first.push_back(place);
            }
        }
        if (first.empty() || first.size() > 2 || first.front().F.upper() < best_ ||
            (first.size() == 2 && !are_mirrored(first[0], first[1]))) {
            refuse(first.empty() ? best_ : first.front().F.upper());
        }
        if (first.size() == 2 && certainly_less(first[0].x, first[1].x)) {
            std::swap(first[0], first[1]);
        }
        return {first, boxes_};
    }
    [[nodiscard]] bool are_mirrored(const GreatestPlace& one, const GreatestPlace& other) const {
        return F_.field().surface_mirrored && one.kind == other.kind && one.part == other.part &&
               (one.kind == Kind::surface || one.kind == Kind::edge) && overlaps(one.x, -other.x) &&
               F_.mirrored_on_surface(one.x);
    }

    const StressMeasure& F_;
    long bits_;
    std::size_t most_boxes_;
    bool surface_;   ///< only places with z = 0 count
    long scale_ = 0; ///< of the unit of cells: both edges lie within one unit of the origin
    Real best_ = -std::numeric_limits<Real>::infinity(); ///< F is at least that at some place
    std::size_t boxes_ = 0;
    std::vector<GreatestPlace> places_;
    std::priority_queue<Open> open_;
};

} // namespace

std::optional<GreatestPlace> refined(const StressMeasure& F, GreatestPlace place) {
    if (place.kind == Kind::edge) {
        const PlaneContact& contact = *F.field().parts[place.part].contact;
        place.x = place.edge == Edge::right ? contact.a() : -contact.b();
        place.z = zero_like(place.x);
        place.F = F.at_edge(place.part, place.edge);
        return place.F.is_finite() ? std::optional(place) : std::nullopt;
    }
    const long bits = F.field().bits();
    const auto at = stationary(F, place.kind, place.x.with_bits(bits), place.z.with_bits(bits));
    if (!at || !contains(place.region.real(), (*at)[0]) ||
        !contains(place.region.imaginary(), (*at)[1])) {
        return {};
    }
    place.x = (*at)[0];
    place.z = (*at)[1];
    place.F = F.jet(Box(place.x, place.z)).value;
    return place;
}

GreatestStress greatest_stress(const StressMeasure& F, std::size_t most_boxes) {
    return Search(F, most_boxes).run();
}

} // namespace edgeproof::contact
