// Where the images that documents refer to lie among those of a folder.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <unordered_map>

#include "base/text.h"
#include "dicom/documents/document.h"
#include "study/open/found_volumes.h"

namespace macula::study {

struct ImagePlace {
    const dicom::Series* series = nullptr;
    const dicom::Stack* stack = nullptr;
    std::size_t frame = 0;                   // in Stack::frames
    std::optional<std::size_t> volume = {};  // in FoundVolumes::volumes(), if the stack is one
};

// Of one patient: another patient's image is never found, whatever its UID. The FoundVolumes must outlive it.
class ImagePlaces {
  public:
    // `patient` is Study::patient.
    ImagePlaces(const FoundVolumes& found, int patient);

    // The first of its frames that the folder has; nothing for what is no image there.
    std::optional<ImagePlace> of(const dicom::DocumentReference& reference) const;

  private:
    std::unordered_multimap<std::string, ImagePlace> places_;  // by SOP Instance UID
};

// "Series 3, image 12", with the frame where the file has several.
Text nameOf(const ImagePlace& place);

}  // namespace macula::study
