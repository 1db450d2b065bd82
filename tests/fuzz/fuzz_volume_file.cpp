// Any bytes as a NIfTI, NRRD or MetaImage file, whichever they look like.
#include <string_view>

#include "formats/volume_file.h"
#include "fuzz/file_of_bytes.h"

namespace {

void read(const std::uint8_t* data, std::size_t size, const std::string& name) {
    const std::filesystem::path file = macula::fuzz::fileOf(data, size, name);
    (void)macula::formats::readVolumeFileInfo(file);
    macula::Progress progress;
    const auto volume = macula::formats::readVolumeFile(file, progress);
    if (volume) MACULA_CHECK(macula::isInvertibleAffine((*volume)->worldFromVoxel()));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    if (text.starts_with("NRRD")) {
        read(data, size, "volume.nrrd");
        if (text.find("file:") != text.npos) read(data, size, "volume.nhdr");
    } else if (text.starts_with("\x1F\x8B")) {
        read(data, size, "volume.nii.gz");
    } else if (text.find("ElementDataFile") != text.npos) {
        read(data, size, "volume.mha");
        read(data, size, "volume.mhd");
    } else {
        read(data, size, "volume.nii");
    }
    return 0;
}
