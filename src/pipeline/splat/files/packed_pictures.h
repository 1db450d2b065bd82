// Pictures of views as a file has them, kept for the next file: the pixels of a view never change, and to
// pack them takes most of the time in which a state is written.
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <span>
#include <vector>

#include "base/result.h"
#include "pipeline/splat/train/training_view.h"

namespace macula::splat {

// Holds the packed pixels, about a third of them as they are, but no view. Each view has an owner of its own
// (make_shared). Used by one thread at a time.
class PackedPictures {
  public:
    // Packs those that it lacks, on all cores, and forgets all others. outOfMemory: the others are forgotten,
    // and some may be packed. No view is null.
    Result<void> pack(std::span<const std::shared_ptr<const TrainingView>> views);

    // Of a view of the last pack(), until the next.
    std::span<const std::byte> of(const std::shared_ptr<const TrainingView>& view) const;

  private:
    std::map<std::weak_ptr<const TrainingView>, std::vector<std::byte>, std::owner_less<>> packed_;
};

}  // namespace macula::splat
