#include "app/model/model_key.h"

#include <fmt/ranges.h>

#include <span>
#include <sstream>
#include <type_traits>
#include <vector>

#include "base/fingerprint.h"
#include "base/sha256.h"
#include "pipeline/volume/mask_bits.h"
#include "pipeline/volume/transfer_function_json.h"

namespace macula::app {

namespace {

constexpr const char* kFirstLine = "macula training of";

template <class T>
std::string digestOf(std::span<const T> values) {
    static_assert(std::is_trivially_copyable_v<T> && sizeof(T) % alignof(float) == 0);
    return sha256Hex(std::as_bytes(values));
}

// A digest of the preset's numbers: the same curves under another name are the same preset.
std::string digestOf(TransferFunction function) {
    for (std::string* words : {&function.name, &function.title, &function.source, &function.document})
        words->clear();
    function.modalities.clear();
    function.number.reset();
    return sha256Hex(toJson(function));
}

std::string words(const glm::dvec3& v) {
    return fmt::format("{:a} {:a} {:a}", v.x, v.y, v.z);
}

std::string digestOf(const Clip& clip, const Volume& volume) {
    std::string text = clip.removedCastsShadow ? "shadow\n" : "";
    if (clip.box)
        text += fmt::format("box {} {} {} {} {} {}\n", clip.ofBox == Keep::inside, words(clip.box->centreMm),
                            words(clip.box->axes[0]), words(clip.box->axes[1]), words(clip.box->axes[2]),
                            words(clip.box->halfSizeMm));
    for (const HalfSpace& plane : clip.planes)
        text += fmt::format("plane {} {:a}\n", words(plane.normal), plane.offsetMm);
    if (clip.cut) text += fmt::format("cut {} {}\n", words(clip.cut->pointMm), words(clip.cut->towards));
    if (clip.ball)
        text += fmt::format("ball {} {} {:a}\n", clip.ofBall == Keep::inside, words(clip.ball->centreMm),
                            clip.ball->radiusMm);
    if (clip.mask) text += "mask " + digestOf<std::uint32_t>(maskBits(*clip.mask, volume).words) + "\n";
    if (clip.greyFaces)
        text += fmt::format("grey {:a} {:a} {} {}\n", clip.greyFaces->center, clip.greyFaces->width,
                            clip.greyFaces->function, clip.facesBelowWindowAreBlack ? "black" : "clear");
    return sha256Hex(text);
}

std::vector<std::string> linesOf(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

}  // namespace

std::string trainingKey(const Volume& volume, const TransferFunction& function, const Clip& clip,
                        const trace::Environment& lights) {
    return fmt::format("{}\nstudy {}\npreset {}\nclip {}\nlights {}\n", kFirstLine,
                       sha256Hex(fingerprint(volume)), digestOf(function), digestOf(clip, volume),
                       digestOf<trace::EnvironmentTexel>(lights.texels()));
}

Result<void> checkTrainingKey(const std::string& saved, const std::string& now,
                              const std::filesystem::path& file) {
    if (saved == now) return {};
    const std::vector<std::string> before = linesOf(saved);
    const std::vector<std::string> after = linesOf(now);
    if (before.size() != after.size() || before.front() != after.front())
        return Error{ErrorCode::inputNotUsable, "The saved training does not say what its pictures show.",
                     file.string(), "It is of another program, or of an older one: train anew."};
    std::vector<std::string> other;
    for (std::size_t i = 1; i < after.size(); ++i) {
        if (before[i] == after[i]) continue;
        const std::string word = after[i].substr(0, after[i].find(' '));
        other.push_back((word == "lights" ? "other " : "another ") + word);
    }
    return Error{
        ErrorCode::inputNotUsable, fmt::format("The saved training is of {}.", fmt::join(other, " and ")),
        file.string(),
        "Give the PATH, --series, --preset, --clip, --remove-table and --lights that it was made with, "
        "or train anew."};
}

}  // namespace macula::app
