// Whether two files that name the same instance hold the same object.
#pragma once

#include <filesystem>

namespace macula::study {

// By the encoded pixels, since archives write headers anew and correct them; of objects without pixels by the
// bytes of the dataset. Files that cannot be read are not the same. An archive may also have encoded the
// pixels anew, which is not looked into.
bool isSameObject(const std::filesystem::path& a, const std::filesystem::path& b);

}  // namespace macula::study
