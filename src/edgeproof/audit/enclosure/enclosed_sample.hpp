// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/sample/audit_context.hpp"
#include "edgeproof/precision/ball/ball.hpp"

#include <map>
#include <memory>
#include <optional>
#include <string>

namespace edgeproof::audit {

/// A sample of a claim in ball arithmetic: what a EvaluatedScene gives in Real, here proved
/// (BallContact, enclosed_integral.hpp). Symbols and functions are those of EvaluatedScene.
class EnclosedSample {
public:
    /// Throws BudgetError or DomainError where so many bits do not enclose the contact.
    /// `integral_digits`: what integrals aim at; all that the bits can hold would cost more
    /// than it is worth.
    EnclosedSample(const Sample& sample, long bits, unsigned integral_digits = 20);
    ~EnclosedSample();
    EnclosedSample(EnclosedSample&&) noexcept;

    /// Not finite where the balls do not exclude a point at which the formula is undefined. Throws
    /// Error for what has no enclosure.
    [[nodiscard]] Ball evaluate(const formula::Expr& e) const;
    /// Another value for a name, in place of its own.
    void set(const std::string& name, const Ball& value);
    /// Another place: at the distance u from an edge.
    void set_place(contact::Edge edge, const Ball& u);
    /// a + b.
    [[nodiscard]] Ball length() const;
    [[nodiscard]] long bits() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

/// A formula's enclosure at a sample, good for `digits` digits if the bits suffice; nothing if
/// there is none, and `problem` says why.
struct Enclosed {
    std::optional<Ball> ball;
    std::string problem;
};
[[nodiscard]] Enclosed enclosed(const formula::Expr& e, const Sample& sample, unsigned digits);

/// The value of a formula that names parameters of the scene and variables of the sample only, as
/// an exact number; nothing for others.
[[nodiscard]] std::optional<formula::Exact> exact_value(formula::Expr e, const Sample& sample);

/// "0.123456 +- 1.2e-52".
[[nodiscard]] std::string ball_text(const Ball& ball, unsigned digits);

} // namespace edgeproof::audit
