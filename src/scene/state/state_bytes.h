// The memory of several states that share their large parts.
#pragma once

#include <cstddef>
#include <unordered_map>

#include "scene/state/study_state.h"

namespace macula::scene {

class StateBytes {
  public:
    void add(const StudyState& state);
    void remove(const StudyState& state);  // must have been added
    // The bytes of all added states together; a part that several of them share counts once.
    std::size_t total() const { return own_ + shared_; }

  private:
    struct Shared {
        std::size_t bytes = 0;
        std::size_t users = 0;
    };
    void use(const void* what, std::size_t bytes);
    void leave(const void* what);

    std::unordered_map<const void*, Shared> known_;
    std::size_t own_ = 0;
    std::size_t shared_ = 0;
};

}  // namespace macula::scene
