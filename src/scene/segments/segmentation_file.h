// Segmentations of an open study as one DICOM object.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <vector>

#include "base/result.h"
#include "base/volume.h"
#include "study/open/found_volumes.h"
#include "study/segmentation/loaded_segmentation.h"

namespace macula::scene {

struct SegmentationRequest {
    struct Part {
        std::shared_ptr<const study::LoadedSegmentation> loaded;  // on the grid of the volume
        std::filesystem::path file;          // gives the codes of its segments; empty: none
        std::vector<std::uint16_t> numbers;  // of the segments that are shown
    };
    std::vector<Part> parts;
    std::shared_ptr<const Volume> volume;
    std::shared_ptr<const study::FoundVolumes> found;  // not null
    std::size_t volumeIndex = 0;                       // of the volume among them
    // Also leaves out what a person may have typed: a segment is then called by its code.
    bool isDeidentified = false;

    std::size_t segments() const;
};

// The segments of all parts, one after the other, on the voxels of the volume. Returns sentences on how they
// differ from what the parts were read from. Errors: those of dicom::readSegmentCodes and
// dicom::writeSegmentation; nothing is written then.
Result<std::vector<Text>> writeSegmentation(const std::filesystem::path& path,
                                            const SegmentationRequest& request);

}  // namespace macula::scene
