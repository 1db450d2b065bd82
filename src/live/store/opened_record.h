// Records in a study store which volumes were opened.
#pragma once

#include <set>
#include <string>

#include "base/volume.h"
#include "live/store/keeper_messages.h"
#include "session/store.h"

namespace macula::live {

// The volume with that digest as the store knows it.
session::OpenedVolume openedVolume(const Volume& volume, std::string digest);

// Used by the keeper's thread alone.
class OpenedRecord {
  public:
    explicit OpenedRecord(KeeperMessages& messages) : messages_(messages) {}

    // Records each volume once. Waits for the disk.
    void record(session::Store& store, const session::OpenedVolume& volume);

  private:
    KeeperMessages& messages_;
    std::set<std::string> recorded_;  // digests of volumes
};

}  // namespace macula::live
