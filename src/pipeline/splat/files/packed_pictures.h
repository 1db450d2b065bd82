// Packed pictures of training views, kept for the next file: the pixels of a view never change, and packing
// them takes most of the time of writing a state.
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <span>
#include <vector>

#include "base/result.h"
#include "pipeline/splat/train/training_view.h"

namespace macula::splat {

// Holds the packed pixels, about a third of the plain size, but does not keep the views alive. Each view must
// have its own owner (make_shared). Used by one thread at a time.
class PackedPictures {
  public:
    // Packs the views that are not packed yet, on all cores, and forgets all others. On outOfMemory the
    // others are forgotten all the same, and some views may be packed. No view may be null.
    Result<void> pack(std::span<const std::shared_ptr<const TrainingView>> views);

    // The packed pixels of a view of the last pack(); valid until the next pack().
    std::span<const std::byte> of(const std::shared_ptr<const TrainingView>& view) const;

  private:
    std::map<std::weak_ptr<const TrainingView>, std::vector<std::byte>, std::owner_less<>> packed_;
};

}  // namespace macula::splat
