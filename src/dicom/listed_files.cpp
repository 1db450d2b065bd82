#include "dicom/listed_files.h"

#include <set>
#include <string_view>

#include "dicom/read/media_directory.h"

namespace macula::dicom {

ListedFiles compareWithDirectories(std::span<const std::filesystem::path> directories,
                                   std::span<const Examination> found) {
    ListedFiles result;
    if (directories.empty()) return result;
    std::set<std::string_view> uids;
    for (const Examination& file : found) uids.insert(file.sopInstanceUid);
    for (const std::filesystem::path& path : directories) {
        const auto directory = readMediaDirectory(path);
        if (!directory) {
            ++result.unreadable;
            continue;
        }
        result.outside += directory->outside;
        for (const ListedFile& listed : directory->missing) {
            if (!listed.sopInstanceUid.empty() && uids.contains(listed.sopInstanceUid)) continue;
            ++result.missing;
            if (!listed.seriesInstanceUid.empty())
                result.absent[listed.seriesInstanceUid].push_back(listed.instanceNumber);
        }
    }
    return result;
}

}  // namespace macula::dicom
