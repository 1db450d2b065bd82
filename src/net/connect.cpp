#include "net/connect.h"

#include <variant>

#include "net/dimse/dimse_archive.h"

namespace macula::net {

Result<std::unique_ptr<Archive>> archiveOf(const Source& source, const Secrets& secrets) {
    if (const auto* peer = std::get_if<DimsePeer>(&source.peer)) {
        MACULA_TRY_VOID(checkDimsePeer(*peer));
        return makeDimseArchive(source, secrets);
    }
    return Error{ErrorCode::usage, Text("This build cannot speak with archives over DICOMweb."), {}, {}};
}

}  // namespace macula::net
