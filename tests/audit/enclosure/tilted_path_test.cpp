// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/audit/enclosure/tilted_path.hpp"
#include "edgeproof/contact/enclosure/ball_contact.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <string>

namespace {

constexpr long path_bits = 260;

struct PathCase {
    const char* alpha;
    const char* t;
    const char* R;
    const char* a;
    TiltedPath::LeftEdge left;
};

constexpr PathCase path_cases[] = {{"1/10", "1", "2", "3/10", TiltedPath::LeftEdge::on_flat},
                                   {"1/10", "1", "2", "1/4", TiltedPath::LeftEdge::on_flat},
                                   {"1/10", "1", "2", "4", TiltedPath::LeftEdge::on_left_arc},
                                   {"1/1000", "1/50", "7", "3", TiltedPath::LeftEdge::on_left_arc},
                                   {"3/2", "1/50", "7", "25", TiltedPath::LeftEdge::on_left_arc}};

Ball path_number(const char* text) { return enclosed_constant(Exact::parse(text), path_bits); }

/// True if only the last digits are uncertain.
bool narrow(const Box& x) {
    return x.is_finite() && x.real().relative_accuracy_bits() > path_bits - 60;
}

} // namespace

TEST_CASE("the path of angles holds the contacts that the left edge's equation gives") {
    for (const PathCase& c : path_cases) {
        const std::string which = std::string(c.a) + " " + c.R;
        CAPTURE(which);
        const Exact modulus = Exact::parse("7/3");
        const BallContact contact(Profile::tilted_flat_and_rounded(
                                      Exact::parse(c.alpha), Exact::parse(c.t), Exact::parse(c.R)),
                                  modulus, Load::right_edge(Exact::parse(c.a)), path_bits);
        const TiltedPath path(c.left, path_number(c.alpha) * path_number(c.R), path_number(c.t),
                              path_number(c.R), path_number("7/3"));
        const Ball angle = path.angle_of(contact.a(), contact.b());
        const TiltedPath::Point at = path.at(Box(angle));
        CHECK(narrow(at.s));
        CHECK(overlaps(at.s.real(), contact.a()));
        CHECK(narrow(at.b));
        CHECK(overlaps(at.b.real(), contact.b()));
        CHECK(narrow(at.rate));
        CHECK(overlaps(at.rate.real(), contact.force_rate()));
        CHECK(narrow(at.ds));
        CHECK(certainly_positive(at.ds.real()));
        CHECK(overlaps((at.db / at.ds).real(), contact.left_edge_derivatives(2)[1]));
        // Check ds by the mean slope over a short step, which must lie in the derivative's box over
        // the step.
        const Ball step(Rational(1, 1000000), path_bits);
        const TiltedPath::Point next = path.at(Box(angle + step));
        const TiltedPath::Point over = path.at(Box(Ball::hull(angle, angle + step)));
        CHECK(overlaps((next.s - at.s).real() / step, over.ds.real()));
        CHECK(over.ds.real().relative_accuracy_bits() > 8);
    }
}

TEST_CASE("boxes of the path hold its points, and boxes off the real axis are not taken") {
    const Ball r = path_number("1/5");
    const TiltedPath path(TiltedPath::LeftEdge::on_left_arc, r, path_number("1"), path_number("2"),
                          path_number("7/3"));
    const Ball wide = Ball::from_interval(Real(19) / 64, Real(21) / 64, path_bits);
    const TiltedPath::Point over =
        path.at(Box(wide, (wide - Ball(Rational(5, 16), path_bits)) / 4));
    CHECK(over.s.is_finite());
    for (const Rational& q : {Rational(19, 64), Rational(5, 16), Rational(21, 64)}) {
        const TiltedPath::Point at = path.at(Box(Ball(q, path_bits)));
        CHECK(overlaps(at.s.real(), over.s.real()));
        CHECK(overlaps(at.rate.real(), over.rate.real()));
        CHECK(contains(over.b.real(), at.b.real()));
    }
    const Ball above = Ball(Rational(1, 8), path_bits);
    CHECK_FALSE(path.at(Box(wide, above)).s.is_finite());
    CHECK_FALSE(path.at(Box(Ball::from_interval(Real(0), Real(3), path_bits))).s.is_finite());
}

TEST_CASE("the flat's end: the angle at which the path goes over to the left arc") {
    const Ball r = path_number("1/5");
    const Ball t = path_number("1");
    const TiltedPath flat(TiltedPath::LeftEdge::on_flat, r, t, path_number("2"), path_number("1"));
    const TiltedPath arc(TiltedPath::LeftEdge::on_left_arc, r, t, path_number("2"),
                         path_number("1"));
    const TiltedPath::Point last = flat.at(Box(flat.end_of_flat()));
    const TiltedPath::Point first = arc.at(Box(Ball(0, path_bits)));
    CHECK(overlaps(last.b.real(), r + t * 2));
    CHECK(narrow(last.b));
    CHECK(overlaps(first.b.real(), r + t * 2));
    CHECK(overlaps(last.s.real(), first.s.real()));
    CHECK(overlaps(last.rate.real(), first.rate.real()));
}
