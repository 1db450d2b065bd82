// Makes the archive of a source.
#pragma once

#include <memory>

#include "net/archive/archive.h"
#include "net/archive/picture_source.h"
#include "net/sources/source_list.h"

namespace macula::net {

// Checks the settings and opens no connection. Fails with usage where they cannot work: no host, an AE title
// longer than 16 characters, an address that is not http or https, a password over http to another machine.
Result<std::unique_ptr<Archive>> archiveOf(const Source& source, const Secrets& secrets);

// With the secrets that the list keeps. A token that takes the place of another is kept there too.
Result<std::unique_ptr<Archive>> archiveOf(const SourceList& list, const Source& source);

// What draws small pictures of the series of an archive; null where its protocol has none (DIMSE). Fails as
// archiveOf. To be kept: it remembers what the archive does not offer.
Result<std::unique_ptr<PictureSource>> picturesOf(const Source& source, const Secrets& secrets);
Result<std::unique_ptr<PictureSource>> picturesOf(const SourceList& list, const Source& source);

}  // namespace macula::net
