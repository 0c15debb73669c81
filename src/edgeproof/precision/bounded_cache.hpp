// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>

namespace edgeproof {

/// The last `capacity` values asked for, by key: where one more is made, the one that was not asked
/// for the longest goes. Values are shared, so that who holds one keeps it. Not locked: an object
/// belongs to one thread, or its owner locks it.
template <class Key, class Value> class BoundedCache {
public:
    explicit BoundedCache(std::size_t capacity) : capacity_(capacity) {}

    /// The value of a key; make() -> std::shared_ptr<Value> where there is none, which may itself
    /// ask this cache for others, and may throw: then nothing is kept.
    template <class Make> [[nodiscard]] std::shared_ptr<Value> get(const Key& key, Make make) {
        const auto known = entries_.find(key);
        if (known != entries_.end()) {
            known->second.last_use = ++uses_;
            return known->second.value;
        }
        std::shared_ptr<Value> value = make();
        while (!entries_.empty() && entries_.size() >= capacity_) {
            entries_.erase(std::min_element(entries_.begin(), entries_.end(),
                                            [](const auto& x, const auto& y) {
                                                return x.second.last_use < y.second.last_use;
                                            }));
        }
        entries_.insert_or_assign(key, Entry{value, ++uses_});
        return value;
    }

    [[nodiscard]] std::size_t size() const { return entries_.size(); }
    [[nodiscard]] std::size_t capacity() const { return capacity_; }

private:
    struct Entry {
        std::shared_ptr<Value> value;
        std::uint64_t last_use;
    };
    std::size_t capacity_;
    std::uint64_t uses_ = 0;
    std::map<Key, Entry> entries_;
};

} // namespace edgeproof
