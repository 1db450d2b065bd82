#include "study/documents/image_places.h"

#include <algorithm>
#include <utility>

namespace macula::study {

ImagePlaces::ImagePlaces(const FoundVolumes& found, int patient) {
    std::unordered_map<const dicom::Stack*, std::size_t> volumes;
    for (std::size_t i = 0; i < found.volumes().size(); ++i) volumes.emplace(found.volumes()[i].stack, i);
    for (const dicom::Study& study : found.scan().studies) {
        if (study.patient != patient) continue;
        for (const dicom::Series& series : study.series) {
            for (const dicom::Stack& stack : series.stacks) {
                const auto volume = volumes.find(&stack);
                ImagePlace place{.series = &series, .stack = &stack};
                if (volume != volumes.end()) place.volume = volume->second;
                for (; place.frame < stack.frames.size(); ++place.frame) {
                    const auto& instance = stack.frames[place.frame].instance;
                    if (instance && !instance->sopInstanceUid.empty())
                        places_.emplace(instance->sopInstanceUid, place);
                }
            }
        }
    }
}

std::optional<ImagePlace> ImagePlaces::of(const dicom::DocumentReference& reference) const {
    const auto [begin, end] = places_.equal_range(reference.sopInstanceUid);
    std::optional<ImagePlace> first;
    const auto numberOf = [](const ImagePlace& place) { return place.stack->frames[place.frame].number; };
    for (auto at = begin; at != end; ++at) {
        const int number = numberOf(at->second);
        const bool isMeant = reference.frames.empty() ||
                             std::ranges::find(reference.frames, number + 1) != reference.frames.end();
        if (isMeant && (!first || number < numberOf(*first))) first = at->second;
    }
    return first;
}

Text nameOf(const ImagePlace& place) {
    const dicom::Frame& frame = place.stack->frames[place.frame];
    std::vector<Text> parts;
    if (place.series->number) parts.push_back(Text("Series {}", *place.series->number));
    if (frame.instance->instanceNumber)
        parts.push_back(Text("image {}", *frame.instance->instanceNumber));
    else
        parts.push_back(Text("an image without a number"));
    if (frame.instance->frames > 1) parts.push_back(Text("frame {}", frame.number + 1));
    return Text::joined(std::move(parts), ", ");
}

}  // namespace macula::study
