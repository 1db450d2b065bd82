// A macula_progress, as a Progress.
#pragma once

#include <macula.h>

#include "base/progress.h"
#include "base/result.h"
#include "c/sized.h"

struct macula_cancel {
    macula::CancelToken token;
};

namespace macula::c {

// Runs body(progress), which returns a Result<void>. A callback that wants to stop cancels the handle.
template <class Body>
Result<void> withProgress(const macula_progress* given, const Body& body) {
    MACULA_TRY(const macula_progress to, taken(given));
    const CancelToken token = to.cancel != nullptr ? to.cancel->token : CancelToken();
    Progress progress(
        [&](const ProgressUpdate& update) {
            if (to.told != nullptr && to.told(to.user, update.stage.english().c_str(), update.fraction) != 0)
                token.cancel();
        },
        token);
    if (progress.cancelled()) return Error{ErrorCode::cancelled, Text("Stopped before it began."), {}, {}};
    return body(progress);
}

}  // namespace macula::c
