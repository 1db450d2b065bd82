// Peripheral models of what was shown before, to go on with when it is shown again.
#pragma once

#include <cstdint>
#include <list>
#include <memory>
#include <string>

#include "pipeline/hybrid/model/peripheral_state.h"

namespace macula::hybrid {

// The size of its pictures and splats. What is small beside these is left out.
std::uint64_t bytesOf(const PeripheralState& state);

// Keeps models by key; the one that was put there or found last stays longest, so that what is looked for is
// not pushed off by what it takes the place of. Together they take at most so many bytes.
class ModelShelf {
  public:
    explicit ModelShelf(std::uint64_t mostBytes) : mostBytes_(mostBytes) {}

    // Replaces the model of the same key. One that is larger than all there is room for is not kept.
    void put(std::shared_ptr<const PeripheralState> state);
    // Null when there is none.
    std::shared_ptr<const PeripheralState> find(const std::string& key);
    std::size_t size() const { return states_.size(); }

  private:
    std::uint64_t mostBytes_;
    std::list<std::shared_ptr<const PeripheralState>> states_;  // the last one used first
};

}  // namespace macula::hybrid
