#include "viewer/segmentation/own_revisions.h"

#include <algorithm>
#include <set>
#include <utility>

namespace macula::viewer {

void OwnRevisions::clear() {
    revisions_.clear();
    current_.reset();
}

void OwnRevisions::add(Revision revision) {
    revisions_.push_back(std::move(revision));
    forgetOldest();
}

const study::LoadedSegmentation* OwnRevisions::find(std::string_view digest) const {
    const auto at = std::ranges::find_if(revisions_, [&](const Revision& r) { return r->digest == digest; });
    return at == revisions_.end() ? nullptr : at->get();
}

bool OwnRevisions::follow(std::span<const scene::SegmentationSettings> choices) {
    Revision next = revisions_.empty() ? nullptr : revisions_.back();
    for (const scene::SegmentationSettings& choice : choices) {
        const auto at =
            std::ranges::find_if(revisions_, [&](const Revision& r) { return r->digest == choice.digest; });
        if (at != revisions_.end()) next = *at;
    }
    if (next == current_) return false;
    current_ = std::move(next);
    return true;
}

// Revisions share the voxels of segments that did not change.
void OwnRevisions::forgetOldest() {
    while (revisions_.size() > 2) {
        std::size_t bytes = 0;
        std::set<const VoxelSet*> counted;
        for (const Revision& revision : revisions_)
            for (const study::LoadedSegment& each : revision->segments)
                if (counted.insert(each.voxels.get()).second) bytes += each.voxels->bytes();
        if (bytes <= kMostBytes) return;
        const auto oldest = revisions_.front() == current_ ? revisions_.begin() + 1 : revisions_.begin();
        revisions_.erase(oldest);
    }
}

}  // namespace macula::viewer
