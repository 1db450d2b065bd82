// The second volume's optics and the coloured segments (additions.h), as tables on the device.
#pragma once

#include <memory>
#include <optional>

#include "base/result.h"
#include "pipeline/gpu/resources.h"
#include "pipeline/volume/additions.h"

namespace macula::trace {

class AdditionTables {
  public:
    // Makes the tables that are missing. One with nothing to hold gets a single 0: a binding cannot be empty.
    Result<void> make(const std::shared_ptr<gpu::Device>& device, const Additions& additions);
    bool areMade(const Additions& additions) const {
        return table_ && noBlocks_ && (tints_ || !additions.tints);
    }

    void forget();
    // Forgets all but what `next` has too: the segments of each voxel, if both have the same box of them.
    void forgetFor(const Additions& next, const Additions& before);

    // Once they are made. Optics of the second volume, and colours of segments (additionTable).
    const gpu::TexelBuffer& optics() const { return *table_; }
    const gpu::TexelBuffer& segments() const { return tints_ ? *tints_ : *noWords_; }
    // To be bound where there is no second volume.
    const gpu::TexelBuffer& noEntries() const { return *noEntries_; }
    const gpu::TexelBuffer& noBlocks() const { return *noBlocks_; }

  private:
    Result<void> makeNothings(const std::shared_ptr<gpu::Device>& device);

    std::optional<gpu::TexelBuffer> noWords_;
    std::optional<gpu::TexelBuffer> noEntries_;
    std::optional<gpu::TexelBuffer> noBlocks_;  // made last of these three
    std::optional<gpu::TexelBuffer> table_, tints_;
};

}  // namespace macula::trace
