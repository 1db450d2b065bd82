#include "scene/segments/segmentation_choice.h"

#include <algorithm>
#include <utility>

namespace macula::app {

SegmentationChoice choiceOf(std::span<const SegmentationChoice> choices, std::string_view digest) {
    const auto found = std::ranges::find(choices, digest, &SegmentationChoice::digest);
    if (found != choices.end()) return *found;
    SegmentationChoice usual;
    usual.digest = digest;
    return usual;
}

SegmentChoice choiceOf(const SegmentationChoice& choice, std::uint16_t number) {
    const auto found = std::ranges::find(choice.segments, number, &SegmentChoice::number);
    if (found != choice.segments.end()) return *found;
    SegmentChoice usual;
    usual.number = number;
    return usual;
}

void choose(std::vector<SegmentationChoice>& choices, SegmentationChoice choice) {
    std::erase_if(choice.segments, [](const SegmentChoice& each) {
        SegmentChoice usual;
        usual.number = each.number;
        return each == usual;
    });
    std::ranges::sort(choice.segments, {}, &SegmentChoice::number);
    std::erase_if(choices, [&](const SegmentationChoice& each) { return each.digest == choice.digest; });
    if (!choice.isShown && choice.segments.empty()) return;
    choices.push_back(std::move(choice));
    std::ranges::sort(choices, {}, &SegmentationChoice::digest);
}

void choose(std::vector<SegmentationChoice>& choices, std::string_view digest, const SegmentChoice& segment) {
    SegmentationChoice choice = choiceOf(choices, digest);
    std::erase_if(choice.segments, [&](const SegmentChoice& each) { return each.number == segment.number; });
    choice.segments.push_back(segment);
    choose(choices, std::move(choice));
}

std::vector<SegmentationChoice> onSlicesAlone(std::span<const SegmentationChoice> choices) {
    std::vector<SegmentationChoice> all;
    for (SegmentationChoice choice : choices) {
        for (SegmentChoice& segment : choice.segments) {
            segment.in3d = In3d::asIs;
            segment.isColouredIn3d = false;
            segment.opacityIn3d = SegmentChoice{}.opacityIn3d;
        }
        choose(all, std::move(choice));
    }
    return all;
}

std::vector<ColouredIn3d> colouredIn3dOf(std::span<const SegmentationChoice> choices) {
    std::vector<ColouredIn3d> all;
    for (const SegmentationChoice& choice : choices) {
        if (!choice.isShown) continue;
        for (const SegmentChoice& segment : choice.segments) {
            if (segment.isColouredIn3d)
                all.emplace_back(choice.digest, segment.number, segment.rgb, segment.opacityIn3d);
        }
    }
    return all;
}

std::vector<SegmentationChoice> withColoursIn3d(std::span<const SegmentationChoice> choices,
                                                std::span<const ColouredIn3d> coloured) {
    std::vector<SegmentationChoice> all;
    for (SegmentationChoice choice : choices) {
        const bool isAsked = std::ranges::any_of(
            coloured, [&](const ColouredIn3d& each) { return std::get<std::string>(each) == choice.digest; });
        if (choice.isShown || isAsked) {
            for (SegmentChoice& segment : choice.segments) segment.isColouredIn3d = false;
        }
        choose(all, std::move(choice));
    }
    for (const auto& [digest, number, rgb, opacity] : coloured) {
        SegmentationChoice choice = choiceOf(all, digest);
        choice.isShown = true;
        SegmentChoice segment = choiceOf(choice, number);
        segment.isColouredIn3d = true;
        segment.rgb = rgb;
        segment.opacityIn3d = opacity;
        choose(all, std::move(choice));
        choose(all, digest, segment);
    }
    return all;
}

std::vector<In3dOf> in3dOf(std::span<const SegmentationChoice> choices) {
    std::vector<In3dOf> all;
    for (const SegmentationChoice& choice : choices) {
        if (!choice.isShown) continue;
        for (const SegmentChoice& segment : choice.segments) {
            if (segment.in3d != In3d::asIs) all.emplace_back(choice.digest, segment.number, segment.in3d);
        }
    }
    return all;
}

std::vector<SegmentationChoice> withIn3d(std::span<const SegmentationChoice> choices,
                                         std::span<const In3dOf> in3d) {
    std::vector<SegmentationChoice> all;
    for (SegmentationChoice choice : choices) {
        const bool isAsked = std::ranges::any_of(
            in3d, [&](const In3dOf& each) { return std::get<std::string>(each) == choice.digest; });
        if (choice.isShown || isAsked) {
            for (SegmentChoice& segment : choice.segments) segment.in3d = In3d::asIs;
        }
        choose(all, std::move(choice));
    }
    for (const auto& [digest, number, what] : in3d) {
        SegmentationChoice choice = choiceOf(all, digest);
        choice.isShown = true;
        SegmentChoice segment = choiceOf(choice, number);
        segment.in3d = what;
        choose(all, std::move(choice));
        choose(all, digest, segment);
    }
    return all;
}

}  // namespace macula::app
