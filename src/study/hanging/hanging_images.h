// What hangs in a study and its priors: each series of slices, and each image or loop that is no volume.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "study/open/found_volumes.h"
#include "study/planar/planar_images.h"

namespace macula::study {

struct HangingImage {
    PlanarSeries of;        // a volume or not
    std::size_t place = 0;  // in Stack::frames, of its first frame; of a volume 0
    int prior = 0;          // 0: the study that is read; 1: the newest one before it, and so on
    bool isVolume = false;
    bool isLocalizer = false;
    std::string modality;
    std::string bodyPart;    // as in the file
    std::string laterality;  // R, L, B or U
    std::string view;        // "CC"
};

// In the order of the studies, their series and stacks. Refers to the FoundVolumes, which must outlive it.
struct HangingImages {
    std::vector<const dicom::Study*> studies;  // the one that is read, then its priors, newest first
    std::vector<HangingImage> images;
};

// Older studies of the same patient with images of a modality that `study` has, newest first; CR, DX and RG
// count as one modality. None without a date.
inline constexpr std::size_t kMostPriors = 8;
std::vector<const dicom::Study*> priorsOf(const dicom::Study& study, const FoundVolumes& found);

// The newest study of the same patient with such images, which is the one that is read: `study` itself where
// none is newer.
const dicom::Study& studyToRead(const dicom::Study& study, const FoundVolumes& found);

// Whether the two count as one modality: those of X-rays do.
bool areAlike(const std::string& modality, const std::string& other);

// Reads a header of each image that is no volume, and of each volume's first one. Of what cannot be read
// nothing is known; it hangs nevertheless. Fails with cancelled.
Result<HangingImages> hangingImages(const dicom::Study& study, const FoundVolumes& found, Progress& progress);

}  // namespace macula::study
