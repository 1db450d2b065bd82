// Where an archive is, as text to compare and to show.
#pragma once

#include <string>

#include "net/archive/source.h"

namespace macula::net {

// As in ARCHIVE@pacs.example.org:104 or https://pacs.example.org/dicom-web. Holds no secret.
std::string addressOf(const Source& source);

}  // namespace macula::net
