// What a call writes. One rule for every verb and option: never an input, never a file of a folder that is
// read, never another output of the same call, and a file that exists only where --overwrite was given.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "base/result.h"

namespace macula::app {

class OutputFiles {
  public:
    explicit OutputFiles(bool overwrite) : overwrite_(overwrite) {}

    // A file or folder that the call reads; of names that are no path ("phantom:", a built-in preset, none)
    // nothing is remembered. FILE#NAME is FILE.
    void read(const std::filesystem::path& path);

    // Fails now, not after minutes of work: with usage for another output of this call, with
    // outputNotWritable where nothing can be written, or by the rule. After all inputs are told. No path and
    // "-", which is standard output, are no files.
    Result<void> write(const std::filesystem::path& path);

    // The same for a training that goes on from that file: it may replace the file.
    Result<void> writeOn(const std::filesystem::path& path);

  private:
    Result<void> checkExisting(const std::filesystem::path& path) const;
    Result<void> take(const std::filesystem::path& path);

    bool overwrite_;
    std::vector<std::filesystem::path> files_, folders_;  // that are read, canonical
    std::set<std::filesystem::path> written_;             // canonical
    std::set<std::filesystem::path> tidied_;              // folders
};

// Makes it, and those above it, if it is not there. Error: outputNotWritable.
Result<void> makePictureFolder(const std::filesystem::path& folder);

// Where to put a result that was cut short: a finished one is never replaced by it, so beside that one if it
// is there ("model-unfinished.ply" beside "model.ply").
std::filesystem::path placeOfUnfinished(const std::filesystem::path& wanted);

// Whether both paths are the same file, also of files that are not there yet.
bool isSameFile(const std::filesystem::path& a, const std::filesystem::path& b);

}  // namespace macula::app
