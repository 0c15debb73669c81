// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/ledger/claim.hpp"
#include "edgeproof/audit/ledger/family.hpp"
#include "edgeproof/audit/ledger/judgement.hpp"
#include "edgeproof/audit/ledger/ledger.hpp"
#include "edgeproof/contact/profile/edge.hpp"

#include <atomic>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace edgeproof::audit {

/// One sample of a claim: a scene, a place in it, and values for the names of `vary`.
struct Sample {
    SceneSpec scene;
    std::optional<Exact> fraction; ///< u as a fraction of the contact's length
    Edge edge = Edge::right;
    std::map<std::string, Exact, std::less<>> variables;
    std::shared_ptr<const Sample> next = {}; ///< at the next value of a sweep, for next(f)
    [[nodiscard]] std::string text() const;
};

/// Quantities that need quadratures at every sample are checked to 100 digits at all samples; if
/// more digits are requested, they are checked to these digits at some evenly spread samples.
struct ManyDigits {
    static constexpr unsigned everywhere = 100;
    static constexpr std::size_t samples = 6;
};

/// Returns 0, 1, ..., n - 1 with `first` evenly spread indices, including both ends, before all
/// others (all of them if there are no more).
[[nodiscard]] std::vector<std::size_t> spread_first(std::size_t n, std::size_t first);

/// The data, in addition to the claim, that a check uses.
class AuditContext {
public:
    AuditContext(const Ledger& ledger, unsigned digits) : ledger_(ledger), digits_(digits) {}

    [[nodiscard]] const Ledger& ledger() const noexcept { return ledger_; }
    /// D: the requested digits.
    [[nodiscard]] unsigned digits() const noexcept { return digits_; }
    /// The digits of agreement required to confirm a claim: D - 5.
    [[nodiscard]] unsigned digits_needed() const noexcept { return digits_needed(digits_); }
    /// The same for another number of digits.
    [[nodiscard]] static unsigned digits_needed(unsigned of) noexcept { return of - 5; }
    /// Returns the scenes of the family in the claim's `over`.
    [[nodiscard]] std::vector<SceneSpec> scenes(const Claim& claim) const;
    /// Combines scenes, places (from the claim's `edge`; `points` in each scene) and values of
    /// `vary`.
    [[nodiscard]] std::vector<Sample> samples(const Claim& claim) const;

    /// Returns an object that is expensive to make and that only one thread may use at a time: a
    /// kept one, or a new one. The context keeps it when the last pointer to it is destroyed, and
    /// must outlive it.
    template <class T>
    [[nodiscard]] std::shared_ptr<T> borrow(const std::string& key,
                                            const std::function<std::unique_ptr<T>()>& make) const {
        std::shared_ptr<void> kept = take(key);
        if (!kept) {
            kept = std::shared_ptr<T>(make());
        }
        T* const object = static_cast<T*>(kept.get());
        return {object, [this, key, kept = std::move(kept)](T*) mutable {
                    give_back(key, std::move(kept));
                }};
    }

private:
    [[nodiscard]] std::shared_ptr<void> take(const std::string& key) const;
    void give_back(const std::string& key, std::shared_ptr<void> object) const;
    const Ledger& ledger_;
    unsigned digits_;
    mutable std::mutex lent_mutex_;
    mutable std::map<std::string, std::vector<std::shared_ptr<void>>, std::less<>> idle_;
};

} // namespace edgeproof::audit
