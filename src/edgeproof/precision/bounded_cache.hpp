// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <map>
#include <memory>

namespace edgeproof {

/// Keeps values by their keys, and drops all of them when there are `capacity`. Values are shared
/// pointers and so remain valid for those who hold them. Not locked: an object belongs to one
/// thread, or its owner locks it.
template <class Key, class Value> class BoundedCache {
public:
    explicit BoundedCache(std::size_t capacity) : capacity_(capacity) {}

    /// Returns the value of a key. If there is none, make() -> std::shared_ptr<Value> creates it;
    /// make() may call this cache for other keys, and may throw, in which case nothing is stored.
    template <class Make> [[nodiscard]] std::shared_ptr<Value> get(const Key& key, Make make) {
        if (const auto known = values_.find(key); known != values_.end()) {
            return known->second;
        }
        std::shared_ptr<Value> value = make();
        if (values_.size() >= capacity_) {
            values_.clear();
        }
        return values_.emplace(key, std::move(value)).first->second;
    }

private:
    std::size_t capacity_;
    std::map<Key, std::shared_ptr<Value>> values_;
};

} // namespace edgeproof
