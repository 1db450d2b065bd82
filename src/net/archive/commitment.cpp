#include "net/archive/commitment.h"

namespace macula::net {

Error commitmentNotOffered() {
    return {ErrorCode::archiveNotUsable,
            Text("By DICOMweb, an archive cannot be asked to confirm that it keeps what was stored."),
            {},
            Text("Set the archive up by DIMSE too, or search it for what was stored.")};
}

}  // namespace macula::net
