// In place of what needs ITK, which Debian's clang cannot compile: NRRD and MetaImage files are not written
// here.
#include "formats/itk_image_file.h"

namespace macula::formats {

namespace {

Error notHere() {
    return {ErrorCode::outputNotWritable, Text("The fuzz targets write no files."), {}, {}};
}

}  // namespace

Result<void> writeNrrd(const std::filesystem::path&, const RawImage&) {
    return notHere();
}

Result<void> writeMetaImage(const std::filesystem::path&, const RawImage&) {
    return notHere();
}

}  // namespace macula::formats
