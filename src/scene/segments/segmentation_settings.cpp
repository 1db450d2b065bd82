#include "scene/segments/segmentation_settings.h"

#include <algorithm>
#include <utility>

namespace macula::scene {

SegmentationSettings choiceOf(std::span<const SegmentationSettings> choices, std::string_view digest) {
    const auto found = std::ranges::find(choices, digest, &SegmentationSettings::digest);
    if (found != choices.end()) return *found;
    SegmentationSettings usual;
    usual.digest = digest;
    return usual;
}

SegmentSettings choiceOf(const SegmentationSettings& choice, std::uint16_t number) {
    const auto found = std::ranges::find(choice.segments, number, &SegmentSettings::number);
    if (found != choice.segments.end()) return *found;
    SegmentSettings usual;
    usual.number = number;
    return usual;
}

void choose(std::vector<SegmentationSettings>& choices, SegmentationSettings choice) {
    std::erase_if(choice.segments, [](const SegmentSettings& each) {
        SegmentSettings usual;
        usual.number = each.number;
        return each == usual;
    });
    std::ranges::sort(choice.segments, {}, &SegmentSettings::number);
    std::erase_if(choices, [&](const SegmentationSettings& each) { return each.digest == choice.digest; });
    if (!choice.isShown && choice.segments.empty()) return;
    choices.push_back(std::move(choice));
    std::ranges::sort(choices, {}, &SegmentationSettings::digest);
}

void choose(std::vector<SegmentationSettings>& choices, std::string_view digest,
            const SegmentSettings& segment) {
    SegmentationSettings choice = choiceOf(choices, digest);
    std::erase_if(choice.segments,
                  [&](const SegmentSettings& each) { return each.number == segment.number; });
    choice.segments.push_back(segment);
    choose(choices, std::move(choice));
}

std::vector<SegmentationSettings> onSlicesAlone(std::span<const SegmentationSettings> choices) {
    std::vector<SegmentationSettings> all;
    for (SegmentationSettings choice : choices) {
        for (SegmentSettings& segment : choice.segments) {
            segment.in3d = In3d::asIs;
            segment.isColouredIn3d = false;
            segment.opacityIn3d = SegmentSettings{}.opacityIn3d;
        }
        choose(all, std::move(choice));
    }
    return all;
}

std::vector<ColouredIn3d> colouredIn3dOf(std::span<const SegmentationSettings> choices) {
    std::vector<ColouredIn3d> all;
    for (const SegmentationSettings& choice : choices) {
        if (!choice.isShown) continue;
        for (const SegmentSettings& segment : choice.segments) {
            if (segment.isColouredIn3d)
                all.emplace_back(choice.digest, segment.number, segment.rgb, segment.opacityIn3d);
        }
    }
    return all;
}

std::vector<SegmentationSettings> withColoursIn3d(std::span<const SegmentationSettings> choices,
                                                  std::span<const ColouredIn3d> coloured) {
    std::vector<SegmentationSettings> all;
    for (SegmentationSettings choice : choices) {
        const bool isAsked = std::ranges::any_of(
            coloured, [&](const ColouredIn3d& each) { return std::get<std::string>(each) == choice.digest; });
        if (choice.isShown || isAsked) {
            for (SegmentSettings& segment : choice.segments) segment.isColouredIn3d = false;
        }
        choose(all, std::move(choice));
    }
    for (const auto& [digest, number, rgb, opacity] : coloured) {
        SegmentationSettings choice = choiceOf(all, digest);
        choice.isShown = true;
        SegmentSettings segment = choiceOf(choice, number);
        segment.isColouredIn3d = true;
        segment.rgb = rgb;
        segment.opacityIn3d = opacity;
        choose(all, std::move(choice));
        choose(all, digest, segment);
    }
    return all;
}

std::vector<In3dOf> in3dOf(std::span<const SegmentationSettings> choices) {
    std::vector<In3dOf> all;
    for (const SegmentationSettings& choice : choices) {
        if (!choice.isShown) continue;
        for (const SegmentSettings& segment : choice.segments) {
            if (segment.in3d != In3d::asIs) all.emplace_back(choice.digest, segment.number, segment.in3d);
        }
    }
    return all;
}

std::vector<SegmentationSettings> withIn3d(std::span<const SegmentationSettings> choices,
                                           std::span<const In3dOf> in3d) {
    std::vector<SegmentationSettings> all;
    for (SegmentationSettings choice : choices) {
        const bool isAsked = std::ranges::any_of(
            in3d, [&](const In3dOf& each) { return std::get<std::string>(each) == choice.digest; });
        if (choice.isShown || isAsked) {
            for (SegmentSettings& segment : choice.segments) segment.in3d = In3d::asIs;
        }
        choose(all, std::move(choice));
    }
    for (const auto& [digest, number, what] : in3d) {
        SegmentationSettings choice = choiceOf(all, digest);
        choice.isShown = true;
        SegmentSettings segment = choiceOf(choice, number);
        segment.in3d = what;
        choose(all, std::move(choice));
        choose(all, digest, segment);
    }
    return all;
}

}  // namespace macula::scene
