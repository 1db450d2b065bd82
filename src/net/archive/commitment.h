// Storage commitment (PS3.4 annex J): an archive confirms that it keeps what was stored.
#pragma once

#include <filesystem>

#include "base/result.h"

namespace macula::net {

struct Commitment {
    enum class State {
        committed,
        refused,
        unanswered,  // the archive may still do it: nothing came in time
    };
    std::filesystem::path file;
    State state = State::unanswered;
    Text why;  // it is not committed; empty if it is
    Text advice;
};

// Of archives that have no way of asking for it.
Error commitmentNotOffered();

}  // namespace macula::net
