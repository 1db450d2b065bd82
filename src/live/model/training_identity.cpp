#include "live/model/training_identity.h"

#include <fmt/format.h>

#include <utility>
#include <vector>

#include "base/fingerprint.h"
#include "base/sha256.h"
#include "live/model/scene_digests.h"
#include "pipeline/splat/files/text_lines.h"

namespace macula::live {

namespace {

constexpr const char* kFirstLine = "macula training of";
constexpr const char* kAdditions = "additions";  // the last line, if there are any

// Removes the line of additions and returns it; empty if there is none.
std::string takeAdditions(std::vector<std::string>& lines) {
    if (lines.empty() || !lines.back().starts_with(kAdditions)) return {};
    std::string taken = std::move(lines.back());
    lines.pop_back();
    return taken;
}

// The difference, in words; `word` is the first of the line that differs.
Text otherThan(const std::string& word) {
    if (word == "study") return Text("another study");
    if (word == "preset") return Text("another preset");
    if (word == "clip") return Text("another clip");
    if (word == "lights") return Text("other lights");
    return Text("another {}", word);
}

}  // namespace

std::string trainingIdentity(const Volume& volume, const TransferFunction& function, const Clip& clip,
                             const trace::Environment& lights, const Additions& additions) {
    PartDigests parts;
    std::string key = fmt::format("{}\nstudy {}\npreset {}\nclip {}\nlights {}\n", kFirstLine,
                                  sha256Hex(fingerprint(volume)), digestOf(function),
                                  digestOf(clip, volume, parts), digestOf(lights));
    if (!additions.isNothing()) key += fmt::format("{} {}\n", kAdditions, digestOf(additions, parts));
    return key;
}

Result<void> checkTrainingIdentity(const std::string& saved, const std::string& now,
                                   const std::filesystem::path& file) {
    if (saved == now) return {};
    std::vector<std::string> before = splat::splitLines(saved);
    std::vector<std::string> after = splat::splitLines(now);
    const bool hasOtherAdditions = takeAdditions(before) != takeAdditions(after);
    if (before.size() != after.size() || before.front() != after.front())
        return Error{ErrorCode::inputNotUsable,
                     Text("The saved training does not say what its pictures show."), file.string(),
                     Text("It is of another program, or of an older one: train anew.")};
    std::vector<Text> other;
    for (std::size_t i = 1; i < after.size(); ++i) {
        if (before[i] == after[i]) continue;
        other.push_back(otherThan(after[i].substr(0, after[i].find(' '))));
    }
    if (hasOtherAdditions) other.push_back(Text("another second volume or other colours of segments"));
    // No option of `macula train` adds them.
    Text hint =
        hasOtherAdditions
            ? Text("macula train draws no second volume and no colours of segments: train anew without them.")
            : Text(
                  "Give the PATH, --series, --preset, --clip, --remove-table and --lights that it was made "
                  "with, or train anew.");
    return Error{ErrorCode::inputNotUsable,
                 Text("The saved training is of {}.", Text::joined(std::move(other), " and ")), file.string(),
                 std::move(hint)};
}

}  // namespace macula::live
