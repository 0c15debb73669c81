// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/sample/audit_context.hpp"
#include "edgeproof/precision/ball/ball.hpp"

#include <map>
#include <memory>
#include <optional>
#include <string>

namespace edgeproof::audit {

/// A sample of a claim in ball arithmetic: the quantities of an EvaluatedScene with proved
/// enclosures (BallContact, enclosed_integral.hpp). Symbols and functions are those of
/// EvaluatedScene.
class EnclosedSample {
public:
    /// Throws BudgetError or DomainError if this number of bits does not enclose the contact.
    /// `integral_digits`: the accuracy that integrals aim at; the full accuracy of the bits would
    /// cost too much.
    EnclosedSample(const Sample& sample, long bits, unsigned integral_digits = 20);
    ~EnclosedSample();
    EnclosedSample(EnclosedSample&&) noexcept;

    /// The ball is not finite if a point at which the formula is undefined is not excluded. Throws
    /// Error for parts without an enclosure.
    [[nodiscard]] Ball evaluate(const Expr& e) const;
    /// Replaces the value of a name.
    void set(const std::string& name, const Ball& value);
    /// Moves the place to the distance u from an edge.
    void set_place(Edge edge, const Ball& u);
    /// Returns a + b.
    [[nodiscard]] Ball length() const;
    [[nodiscard]] long bits() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

/// The enclosure of a formula at a sample, right to `digits` digits if the bits are sufficient. If
/// `ball` is empty, `problem` gives the reason.
struct Enclosed {
    std::optional<Ball> ball;
    std::string problem;
};
[[nodiscard]] Enclosed enclosed(const Expr& e, const Sample& sample, unsigned digits);

/// Returns the value of a formula as an exact number, if it contains only parameters of the scene
/// and variables of the sample; nothing for others.
[[nodiscard]] std::optional<Exact> exact_value(Expr e, const Sample& sample);

/// Returns a text such as "0.123456 +- 1.2e-52".
[[nodiscard]] std::string ball_text(const Ball& ball, unsigned digits);

} // namespace edgeproof::audit
