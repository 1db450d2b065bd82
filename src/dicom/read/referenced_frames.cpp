#include "dicom/read/referenced_frames.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace macula::dicom {

namespace {

constexpr Tag kReferencedSopInstanceUid{0x0008, 0x1155};
constexpr Tag kReferencedFrameNumber{0x0008, 0x1160};
constexpr double kLargestFrame = 2147483647.0;  // the largest Integer String

void readNumbers(const Dataset& item, ReferencedFrames& image) {
    if (!item.has(kReferencedFrameNumber)) return;
    for (const double number : item.allNumbers(kReferencedFrameNumber)) {
        if (number != std::round(number) || number < 1.0 || number > kLargestFrame) {
            image.numbers.clear();
            break;
        }
        image.numbers.push_back(int(number));
    }
    image.isDamaged = image.numbers.empty();
}

void add(ReferencedFrames& to, const ReferencedFrames& other) {
    to.isDamaged = to.isDamaged || other.isDamaged;
    if (to.numbers.empty() || other.numbers.empty()) {
        to.numbers.clear();
    } else {
        to.numbers.insert(to.numbers.end(), other.numbers.begin(), other.numbers.end());
    }
}

}  // namespace

bool ReferencedFrames::holds(int frame) const {
    return numbers.empty() || std::ranges::find(numbers, frame + 1) != numbers.end();
}

std::vector<ReferencedFrames> referencedFrames(const std::vector<Dataset>& items) {
    std::vector<ReferencedFrames> images;
    for (const Dataset& item : items) {
        auto uid = item.text(kReferencedSopInstanceUid);
        if (!uid) continue;
        readNumbers(item, images.emplace_back(ReferencedFrames{.sopInstanceUid = *std::move(uid)}));
    }
    return images;
}

std::vector<ReferencedFrames> byImage(std::vector<ReferencedFrames> references) {
    std::ranges::stable_sort(references, {}, &ReferencedFrames::sopInstanceUid);
    std::vector<ReferencedFrames> images;
    for (ReferencedFrames& each : references) {
        if (images.empty() || images.back().sopInstanceUid != each.sopInstanceUid) {
            images.push_back(std::move(each));
        } else {
            add(images.back(), each);
        }
    }
    for (ReferencedFrames& image : images) {
        std::ranges::sort(image.numbers);
        image.numbers.erase(std::unique(image.numbers.begin(), image.numbers.end()), image.numbers.end());
    }
    return images;
}

}  // namespace macula::dicom
