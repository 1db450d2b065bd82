// Own segments as a document of the study store.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>

#include "base/result.h"
#include "base/volume.h"
#include "study/segmentation/loaded_segmentation.h"

namespace macula::scene {

// What a store keeps at most: see session/json_members.h.
inline constexpr std::size_t kMostOwnJsonBytes = 7'900'000;

// Voxels are kept as the lengths of runs, which takes some hundred kilobytes for an organ. Fails with usage
// where the text is longer than kMostOwnJsonBytes.
Result<std::string> toJson(const study::LoadedSegmentation& revision, const Volume& volume);

// Fails with inputNotUsable for a text that does not describe segments of this grid; trusts no number in it.
Result<std::shared_ptr<const study::LoadedSegmentation>> ownRevisionFromJson(std::string_view json,
                                                                             const Volume& volume);

}  // namespace macula::scene
