#include "live/model/scene_digests.h"

#include <fmt/format.h>

#include <span>
#include <type_traits>

#include "base/sha256.h"
#include "pipeline/volume/transfer_function_json.h"

namespace macula::live {

namespace {

template <class T>
std::string digestOfAll(std::span<const T> values) {
    static_assert(std::is_trivially_copyable_v<T> && sizeof(T) % alignof(float) == 0);
    return sha256Hex(std::as_bytes(values));
}

std::string words(const glm::dvec3& v) {
    return fmt::format("{:a} {:a} {:a}", v.x, v.y, v.z);
}

}  // namespace

std::string digestOf(TransferFunction function) {
    for (std::string* words : {&function.name, &function.title, &function.source, &function.document})
        words->clear();
    function.modalities.clear();
    function.number.reset();
    return sha256Hex(toJson(function));
}

std::string digestOf(const Clip& clip, const Volume& volume, PartDigests& parts) {
    std::string text = clip.removedCastsShadow ? "shadow\n" : "";
    forEachShape(clip, [&](const ClipShape auto& shape, Keep keep) {
        text += std::string(shape.kKey) + " ";
        if (shape.kHasKeep) text += fmt::format("{} ", keep == Keep::inside);
        text += fmt::format("{:a}\n", fmt::join(shape.numbers(), " "));
    });
    if (clip.mask) text += "mask " + parts.of(*clip.mask, volume) + "\n";
    if (clip.greyFaces)
        text += fmt::format("grey {:a} {:a} {} {}\n", clip.greyFaces->center, clip.greyFaces->width,
                            clip.greyFaces->function, clip.facesBelowWindowAreBlack ? "black" : "clear");
    return sha256Hex(text);
}

std::string digestOf(const Additions& additions, PartDigests& parts) {
    if (additions.isNothing()) return {};
    std::string text;
    if (additions.second) {
        const glm::dmat4& map = additions.second->secondFromVolumeMm;
        text += fmt::format("\nsecond {} {} {} {} {} {}\n", sha256Hex(parts.of(additions.second->volume)),
                            digestOf(*additions.second->function), words(glm::dvec3(map[0])),
                            words(glm::dvec3(map[1])), words(glm::dvec3(map[2])), words(glm::dvec3(map[3])));
    }
    if (additions.tints) {
        const TintBox& box = *additions.tints->box;
        text += fmt::format("\ntints {} {}", words(glm::dvec3(box.low)), words(glm::dvec3(box.size)));
        text += " " + parts.of(additions.tints->box) + "\n";
        for (const SegmentTints::Colour& colour : additions.tints->colours)
            text += fmt::format("tint {} {:a}\n", words(glm::dvec3(colour.rgb)), colour.opacity);
    }
    return sha256Hex(text);
}

std::string digestOf(const Clip& clip, const Additions& additions, const Volume& volume, PartDigests& parts) {
    std::string text = digestOf(clip, volume, parts);
    if (additions.isNothing()) return text;
    return sha256Hex(text + "\n" + digestOf(additions, parts));
}

std::string digestOf(const trace::Environment& lights) {
    return digestOfAll<trace::EnvironmentTexel>(lights.texels());
}

std::string digestOf(const trace::Settings& settings) {
    // Names every setting: adding one breaks the build here, so that nobody forgets to digest it.
    const auto& [bounces, seed, filter, exposure, denoising, look, lightRotationDeg, lightStrength, shading,
                 errorThreshold, indirect, window, toneMap] = settings;
    std::string text = fmt::format("bounces {}\nfilter {}\nlook {}\nlights {:a} {:a}\nshading {}\n", bounces,
                                   trace::nameOf(filter), trace::nameOf(look), lightRotationDeg,
                                   lightStrength, int(shading));
    text += fmt::format("seed {}\nexposure {:a}\ndenoising {}\nerror {:a}\n", seed, exposure,
                        trace::nameOf(denoising), errorThreshold);
    if (indirect != trace::Indirect::traced) text += fmt::format("indirect {}\n", trace::nameOf(indirect));
    if (toneMap != trace::ToneMap::neutral) text += fmt::format("tone map {}\n", trace::nameOf(toneMap));
    if (window) text += fmt::format("window {:a} {:a} {}\n", window->center, window->width, window->function);
    return sha256Hex(text);
}

}  // namespace macula::live
