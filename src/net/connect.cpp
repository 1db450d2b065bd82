#include "net/connect.h"

namespace macula::net {

Result<std::unique_ptr<Archive>> archiveOf(const Source& /*source*/, const Secrets& /*secrets*/) {
    return Error{ErrorCode::usage, Text("This build cannot speak with archives."), {}, {}};
}

}  // namespace macula::net
