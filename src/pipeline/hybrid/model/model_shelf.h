// Keeps peripheral models in memory, to continue with them when their scene is shown again.
#pragma once

#include <cstdint>
#include <list>
#include <memory>
#include <string>

#include "pipeline/hybrid/model/peripheral_state.h"

namespace macula::hybrid {

// The size of its pictures and splats; ignores everything smaller.
std::uint64_t bytesOf(const PeripheralState& state);

// Keeps models by key in at most `mostBytes`, and drops the least recently used ones first. So putting the
// present model away does not drop one that was just found.
class ModelShelf {
  public:
    explicit ModelShelf(std::uint64_t mostBytes) : mostBytes_(mostBytes) {}

    // Replaces the model of the same key. Does not keep a model that is larger than the whole shelf.
    void put(std::shared_ptr<const PeripheralState> state);
    // Null if there is none.
    std::shared_ptr<const PeripheralState> find(const std::string& key);
    std::size_t size() const { return states_.size(); }

  private:
    std::uint64_t mostBytes_;
    std::list<std::shared_ptr<const PeripheralState>> states_;  // most recently used first
};

}  // namespace macula::hybrid
