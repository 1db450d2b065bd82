// The own segments of the open study, as they are and as they were: what an undo needs.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "scene/segments/segmentation_settings.h"
#include "study/segmentation/loaded_segmentation.h"

namespace macula::viewer {

// Keeps all revisions of a study, up to kMostBytes of voxels: the oldest are forgotten first, and an undo to
// one of these shows the newest. The state of the study names the one that counts.
class OwnRevisions {
  public:
    using Revision = std::shared_ptr<const study::LoadedSegmentation>;
    static constexpr std::size_t kMostBytes = std::size_t(1) << 30;

    void clear();
    void add(Revision revision);                                           // it is the newest
    const study::LoadedSegmentation* find(std::string_view digest) const;  // null: not among them
    const Revision& newest() const { return revisions_.back(); }           // there must be one
    // The one that `choices` name, else the newest; null without any.
    const Revision& current() const { return current_; }
    // Returns whether another one is current now.
    bool follow(std::span<const scene::SegmentationSettings> choices);

  private:
    void forgetOldest();

    std::vector<Revision> revisions_;  // the newest last
    Revision current_;
};

}  // namespace macula::viewer
