#include "dicom/scan_failure.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace macula::dicom {

namespace fs = std::filesystem;

namespace {

// What is wrong with several files, as the end of a sentence about them.
constexpr std::array kReasons = std::to_array<std::pair<std::string_view, std::string_view>>({
    {key::kUnreadableFile, "cannot be opened"},
    {key::kFileOffline, "with a content that is not on this machine"},
    {key::kUnreadableMedium, "on a medium that cannot be read there"},
    {key::kPathTooLong, "with a path that is too long to be opened"},
    {key::kDamagedFile, "damaged, or not written as they say"},
    {key::kTruncatedFile, "cut off before the end of their pixel data"},
    {key::kNoPixelData, "without pixel data"},
    {key::kInvalidFrameCount, "without a usable number of frames"},
});

struct Reasons {
    std::string text;    // "4 without pixel data, 2 damaged, or not written as they say"
    std::string action;  // for most of them
    std::size_t count = 0;
};

Reasons reasonsOf(const Scan& scan) {
    std::map<std::string_view, std::size_t> counts;
    for (const SkippedFile& skipped : scan.skipped) {
        if (!skipped.isFolder) ++counts[skipped.message.key];
    }
    std::vector<std::pair<std::size_t, std::string_view>> byCount;
    Reasons reasons;
    for (const auto& [key, phrase] : kReasons) {
        const auto found = counts.find(key);
        if (found != counts.end()) byCount.emplace_back(found->second, key);
    }
    std::ranges::stable_sort(byCount, std::ranges::greater{},
                             &std::pair<std::size_t, std::string_view>::first);
    std::vector<std::string> parts;
    for (const auto& [count, key] : byCount) {
        const auto phrase =
            std::ranges::find(kReasons, key, &std::pair<std::string_view, std::string_view>::first);
        parts.push_back(fmt::format("{} {}", count, phrase->second));
        reasons.count += count;
    }
    if (!byCount.empty()) reasons.action = message(byCount.front().second).action;
    reasons.text = fmt::format("{}", fmt::join(parts, ", "));
    return reasons;
}

}  // namespace

Error nothingFound(const Scan& scan, const fs::path& path, const FolderListing& listing) {
    const auto fail = [&](std::string sentence, std::string action) {
        return Error{ErrorCode::inputNotUsable, std::move(sentence), path.string(), std::move(action)};
    };
    if (scan.skipped.size() == 1 && listing.files.size() == 1) {
        const Message& why = scan.skipped.front().message;
        return fail(why.sentence, why.action);
    }
    if (const Reasons reasons = reasonsOf(scan); reasons.count > 0) {
        return reasons.count == 1
                   ? fail(fmt::format("The only DICOM file in this folder cannot be read: {}.", reasons.text),
                          reasons.action)
                   : fail(fmt::format("None of the {} DICOM files in this folder can be read: {}.",
                                      reasons.count, reasons.text),
                          reasons.action);
    }
    if (scan.listedFilesMissing > 0) {
        return fail(
            fmt::format(
                "There is the directory of a medium (DICOMDIR) here, and none of the {} files that it "
                "lists.",
                scan.listedFilesMissing),
            "Copy the whole medium, with all of its folders, and open the copy.");
    }
    if (const auto folder = std::ranges::find_if(scan.skipped, &SkippedFile::isFolder);
        folder != scan.skipped.end()) {
        const Message& why = folder->message;
        return fail("There is no DICOM image in the folder, and some of its sub-folders cannot be read. " +
                        why.sentence,
                    why.action);
    }
    if (listing.linksOutside > 0) {
        return fail(
            "There is no DICOM image in the folder itself; links that lead out of it are not followed.",
            "Choose the folder that the links lead to.");
    }
    if (!scan.archiveKinds.empty()) {
        return fail(
            fmt::format("There is no DICOM image here but perhaps in an archive ({}), which is not opened.",
                        fmt::join(scan.archiveKinds, ", ")),
            "Unpack it, and open the folder with what was in it.");
    }
    std::error_code error;
    if (listing.files.empty())
        return fail("There is no file in this folder.", "Choose a folder with DICOM images.");
    if (listing.files.size() == 1)
        return fail(fs::is_directory(path, error)
                        ? "There is no DICOM image in this folder: the only file in it is none."
                        : "The file is not a DICOM image.",
                    "Choose a folder with DICOM images.");
    return fail(
        fmt::format("There is no DICOM image among the {} files of this folder.", listing.files.size()),
        "Choose a folder with DICOM images.");
}

}  // namespace macula::dicom
