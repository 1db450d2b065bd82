// Checks the output files of a command. One rule for every command and option: never replace an input, a file
// in an input folder, or another output of the same call; replace any other file only with --overwrite.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "base/result.h"

namespace macula::pictures {

class OutputFiles {
  public:
    explicit OutputFiles(bool overwrite) : overwrite_(overwrite) {}

    // Registers a file or folder that the call reads. Ignores names that are not paths ("phantom:", a
    // built-in preset, empty). For FILE#NAME it registers FILE.
    void read(const std::filesystem::path& path);

    // Checks an output before work begins; call it after every read(). usage if another output of this call
    // has that path; outputNotWritable if nothing can be written there, or the rule forbids it. Accepts an
    // empty path and "-", standard output, without a check.
    Result<void> write(const std::filesystem::path& path);

    // The same for a training that resumes from that file: it may replace the file.
    Result<void> writeOn(const std::filesystem::path& path);

  private:
    Result<void> checkExisting(const std::filesystem::path& path) const;
    Result<void> take(const std::filesystem::path& path);

    bool overwrite_;
    std::vector<std::filesystem::path> files_, folders_;  // inputs, canonical
    std::set<std::filesystem::path> written_;             // canonical
    std::set<std::filesystem::path> tidied_;              // folders cleared of abandoned drafts
};

// Makes the folder and its parents if they are missing. Error: outputNotWritable.
Result<void> makePictureFolder(const std::filesystem::path& folder);

// The path for an unfinished result: `wanted`, or if that file exists a name next to it, so that a finished
// result is never replaced ("model-unfinished.ply" next to "model.ply").
std::filesystem::path placeOfUnfinished(const std::filesystem::path& wanted);

// Whether both paths are the same file, even if it does not exist yet; false for an empty path.
bool isSameFile(const std::filesystem::path& a, const std::filesystem::path& b);

}  // namespace macula::pictures
