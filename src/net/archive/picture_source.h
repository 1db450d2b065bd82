// Small pictures of series, as an archive draws them, before anything is fetched.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "base/progress.h"
#include "base/result.h"
#include "net/archive/query.h"

namespace macula::net {

// As the archive sent it: nobody has looked into it, and whoever decodes it bounds its size.
struct EncodedPicture {
    enum class Kind { jpeg, png };
    Kind kind{};
    std::string bytes;
};

// Calls block, and may be made from any thread and by several at once.
class PictureSource {
  public:
    virtual ~PictureSource() = default;

    // Of an image in the middle of the series, with at most about `edgePixels` on either side. Nothing where
    // the archive has none of this series. Fails with archiveNotUsable where it does not answer, and with
    // cancelled.
    virtual Result<std::optional<EncodedPicture>> pictureOf(const std::string& studyInstanceUid,
                                                            const FoundSeries& series, int edgePixels,
                                                            Progress& progress) = 0;
    // False once the archive has said that it draws none: then it is not asked any more.
    virtual bool isOffered() const = 0;
};

}  // namespace macula::net
