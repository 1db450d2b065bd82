// The key images of a folder: those that selections of key objects (PS3.3 A.35.4) name.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "base/text.h"
#include "study/documents/image_places.h"
#include "study/open/found_volumes.h"

namespace macula::study {

inline constexpr std::size_t kMostKeyImages = 10'000;

struct KeyImage {
    ImagePlace place;
    Text why;                 // the title of the selection, "For Referring Provider"; from a file
    bool isRejected = false;  // the selection rejects it (CID 7011: for quality, safety and so on)
};

// In the order of the folder and of each selection; each image once, also where several name it. The
// FoundVolumes must outlive it.
class KeyImages {
  public:
    explicit KeyImages(std::vector<KeyImage> images = {}) : images_(std::move(images)) {}

    const std::vector<KeyImage>& images() const { return images_; }  // rejected ones too
    // Those that are not rejected, as places in images().
    std::vector<std::size_t> inOrder() const;
    // "2 key images: For Referring Provider", and those that are rejected; empty: none. Without the titles
    // for a list that hides what may name somebody.
    std::vector<Text> linesOf(const dicom::Series& series, bool withTitles) const;
    std::vector<Text> linesOf(const dicom::Stack& stack, bool withTitles) const;

  private:
    template <class IsMeant>
    std::vector<Text> lines(bool withTitles, const IsMeant& isMeant) const;

    std::vector<KeyImage> images_;
};

// Reads all selections of the folder; those that cannot be read name nothing, and manifests are none. At most
// kMostKeyImages. Fails with cancelled.
Result<KeyImages> findKeyImages(const FoundVolumes& found, Progress& progress);

}  // namespace macula::study
