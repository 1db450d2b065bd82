#include "dicom/scan_failure.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <string_view>
#include <utility>
#include <vector>

namespace macula::dicom {

namespace fs = std::filesystem;

namespace {

using Phrase = std::pair<std::string_view, Text>;  // by the key of the message

// The end of a sentence about several files: what is wrong with them.
const std::vector<Phrase>& phrases() {
    static const std::vector<Phrase> all{
        {key::kUnreadableFile, Text("cannot be opened")},
        {key::kFileOffline, Text("with a content that is not on this machine")},
        {key::kUnreadableMedium, Text("on a medium that cannot be read there")},
        {key::kPathTooLong, Text("with a path that is too long to be opened")},
        {key::kDamagedFile, Text("damaged, or not written as they say")},
        {key::kTruncatedFile, Text("cut off before the end of their pixel data")},
        {key::kNoPixelData, Text("without pixel data")},
        {key::kInvalidFrameCount, Text("without a usable number of frames")},
    };
    return all;
}

struct Reasons {
    Text text;    // "4 without pixel data, 2 damaged, or not written as they say"
    Text action;  // for most of them
    std::size_t count = 0;
};

Reasons reasonsOf(const Scan& scan) {
    std::map<std::string_view, std::size_t> counts;
    for (const SkippedFile& skipped : scan.skipped) {
        if (!skipped.isFolder) ++counts[skipped.message.key];
    }
    std::vector<std::pair<std::size_t, const Phrase*>> byCount;
    Reasons reasons;
    for (const Phrase& phrase : phrases()) {
        const auto found = counts.find(phrase.first);
        if (found != counts.end()) byCount.emplace_back(found->second, &phrase);
    }
    std::ranges::stable_sort(byCount, std::ranges::greater{}, &std::pair<std::size_t, const Phrase*>::first);
    std::vector<Text> parts;
    for (const auto& [count, phrase] : byCount) {
        parts.push_back(Text("{} {}", count, phrase->second));
        reasons.count += count;
    }
    if (!byCount.empty()) reasons.action = message(byCount.front().second->first).action;
    reasons.text = Text::joined(std::move(parts), ", ");
    return reasons;
}

}  // namespace

Error nothingFound(const Scan& scan, const fs::path& path, const FolderListing& listing) {
    const auto fail = [&](Text sentence, Text action) {
        return Error{ErrorCode::inputNotUsable, std::move(sentence), path.string(), std::move(action)};
    };
    if (scan.skipped.size() == 1 && listing.files.size() == 1) {
        const Message& why = scan.skipped.front().message;
        return fail(why.sentence, why.action);
    }
    if (const Reasons reasons = reasonsOf(scan); reasons.count > 0) {
        return reasons.count == 1
                   ? fail(Text("The only DICOM file in this folder cannot be read: {}.", reasons.text),
                          reasons.action)
                   : fail(Text("None of the {} DICOM files in this folder can be read: {}.", reasons.count,
                               reasons.text),
                          reasons.action);
    }
    if (scan.listedFilesMissing > 0) {
        return fail(
            Text("There is the directory of a medium (DICOMDIR) here, and none of the {} files that it "
                 "lists.",
                 scan.listedFilesMissing),
            Text("Copy the whole medium, with all of its folders, and open the copy."));
    }
    if (const auto folder = std::ranges::find_if(scan.skipped, &SkippedFile::isFolder);
        folder != scan.skipped.end()) {
        const Message& why = folder->message;
        return fail(
            Text("There is no DICOM image in the folder, and some of its sub-folders cannot be read. {}",
                 why.sentence),
            why.action);
    }
    if (listing.linksOutside > 0) {
        return fail(
            Text("There is no DICOM image in the folder itself; links that lead out of it are not followed."),
            Text("Choose the folder that the links lead to."));
    }
    if (!scan.archiveKinds.empty()) {
        return fail(Text("There is no DICOM image here but perhaps in an archive ({}), which is not opened.",
                         fmt::format("{}", fmt::join(scan.archiveKinds, ", "))),
                    Text("Open the archive itself if it is a ZIP or tar file; otherwise unpack it, and open "
                         "the folder "
                         "with what was in it."));
    }
    std::error_code error;
    if (listing.files.empty())
        return fail(Text("There is no file in this folder."), Text("Choose a folder with DICOM images."));
    if (listing.files.size() == 1)
        return fail(fs::is_directory(path, error)
                        ? Text("There is no DICOM image in this folder: the only file in it is none.")
                        : Text("The file is not a DICOM image."),
                    Text("Choose a folder with DICOM images."));
    return fail(Text("There is no DICOM image among the {} files of this folder.", listing.files.size()),
                Text("Choose a folder with DICOM images."));
}

}  // namespace macula::dicom
