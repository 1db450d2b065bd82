#include "app/model/model_key.h"

#include <fmt/ranges.h>

#include <sstream>
#include <vector>

#include "app/model/scene_digests.h"
#include "base/fingerprint.h"
#include "base/sha256.h"

namespace macula::app {

namespace {

constexpr const char* kFirstLine = "macula training of";

std::vector<std::string> linesOf(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

}  // namespace

std::string trainingKey(const Volume& volume, const TransferFunction& function, const Clip& clip,
                        const trace::Environment& lights, const Additions& additions) {
    PartDigests parts;
    return fmt::format("{}\nstudy {}\npreset {}\nclip {}\nlights {}\n", kFirstLine,
                       sha256Hex(fingerprint(volume)), digestOf(function),
                       digestOf(clip, additions, volume, parts), digestOf(lights));
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
