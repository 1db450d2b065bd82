#include "dicom/best_volume.h"

#include <algorithm>
#include <tuple>

namespace macula::dicom {

namespace {

bool isAxial(const Stack& stack) {
    return std::all_of(stack.frames.begin(), stack.frames.end(), [](const Frame& f) {
        return std::find(f.imageType.begin(), f.imageType.end(), "AXIAL") != f.imageType.end();
    });
}

auto rankOf(const Stack& stack) {
    constexpr std::size_t kFewSlices =
        20;  // an original of fewer is a scout or a sample rather than the study
    const bool original = isOriginalPrimary(stack) && stack.frames.size() >= kFewSlices;
    // CT images say AXIAL. Other modalities seldom do, so among themselves this changes nothing.
    return std::tuple(original, original && isAxial(stack), stack.isEven(),
                      std::size_t(stack.columns) * std::size_t(stack.rows) * stack.slices.size());
}

struct Candidates {
    ChosenStack best;
    std::size_t volumes = 0;
    std::size_t stacks = 0;
    const Stack* blocked = nullptr;  // the largest stack that is not a volume

    void add(const Series& series, std::span<const Stack* const> without = {}) {
        for (const Stack& stack : series.stacks) {
            if (std::ranges::find(without, &stack) != without.end()) continue;
            ++stacks;
            if (!stack.canBeVolume()) {
                if (blocked == nullptr || stack.frames.size() > blocked->frames.size()) blocked = &stack;
                continue;
            }
            ++volumes;
            if (!best || rankOf(stack) > rankOf(*best.stack)) {
                best.series = &series;
                best.stack = &stack;
            }
        }
    }

    // `place` ends the sentence on what there is: empty, or text that begins with a blank.
    ChosenStack choose(const Text& place) {
        if (best) {
            best.why = volumes == 1 ? Text("The only volume{}.", place) : whyBest(place);
            if (const std::size_t others = best.series->stacks.size() - 1; others > 0) {
                best.why =
                    Text::joined({std::move(best.why),
                                  others == 1 ? Text("Its series has {} other stack of images.", others)
                                              : Text("Its series has {} other stacks of images.", others)},
                                 " ");
            }
        } else if (blocked != nullptr) {
            const Message* reason = blocked->whyNoVolume();
            best.why = Text("Nothing{} can be shown in 3D. {}: {}", place,
                            stacks == 1 ? Text("The only stack of images")
                                        : Text("The largest of {} stacks of images", stacks),
                            reason != nullptr ? reason->sentence : Text("it is no volume."));
        } else {
            best.why = Text("There are no images{}.", place);
        }
        return std::move(best);
    }

    Text whyBest(const Text& place) const {
        const Stack& stack = *best.stack;
        const bool isOriginal = std::get<0>(rankOf(stack));
        const bool isAxialToo = std::get<1>(rankOf(stack));
        return Text("Of {} volumes{} the {}one {}with the most voxels ({} x {} x {}).", volumes, place,
                    isAxialToo   ? Text("original axial ")
                    : isOriginal ? Text("original ")
                                 : Text(),
                    stack.isEven() ? Text("without interpolated slices and ") : Text(), stack.columns,
                    stack.rows, stack.slices.size());
    }
};

}  // namespace

ChosenStack bestVolume(const Scan& scan, std::span<const Stack* const> without) {
    Candidates candidates;
    for (const Study& study : scan.studies) {
        for (const Series& series : study.series) candidates.add(series, without);
    }
    if (!candidates.best) {
        // Gives the question whether to join as the reason, not that each series has only one image.
        for (const Message& message : scan.messages) {
            if (message.key == key::kUidPerSlice)
                return {.series = nullptr,
                        .stack = nullptr,
                        .why = Text::joined({message.sentence, message.action}, " ")};
        }
    }
    return candidates.choose(scan.patients > 1 ? Text(" of {} in this folder", patientsText(scan)) : Text());
}

ChosenStack bestVolume(const Series& series) {
    Candidates candidates;
    candidates.add(series);
    return candidates.choose(Text(" in this series"));
}

}  // namespace macula::dicom
