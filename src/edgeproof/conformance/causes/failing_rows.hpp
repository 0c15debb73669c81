// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/conformance/causes/convention.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace edgeproof::conformance {

/// Collects the rows that fail, at most the first `most`, from answers in blocks; conventions are
/// inferred from these rows.
class FailingRows {
public:
    static constexpr std::size_t most = 10'000;

    void add(const Answers& answers, const Agreements& agreements);
    /// True if there are more than are kept.
    [[nodiscard]] bool cut() const { return seen_ > answers_.given.size(); }
    [[nodiscard]] std::size_t seen() const { return seen_; }
    [[nodiscard]] std::size_t kept() const { return answers_.given.size(); }
    /// Calls infer_conventions() for the rows kept.
    [[nodiscard]] std::vector<Convention> conventions(const ReferenceOptions& options) const;
    /// Calls unexplained() for the rows kept.
    [[nodiscard]] std::vector<std::string>
    unexplained_by(const std::vector<Convention>& conventions) const;

private:
    Answers answers_;
    Agreements agreements_;
    std::size_t seen_ = 0;
};

} // namespace edgeproof::conformance
