// The way to an archive that is set up: where it is, and what it asks for.
#pragma once

#include <QString>
#include <memory>

#include "base/result.h"
#include "net/archive/archive.h"
#include "net/sources/source_list.h"
#include "study/archive/study_search.h"

namespace macula::viewer {

struct ArchiveWay {
    net::Source source;
    net::SourceList list;  // with its secrets

    Result<std::unique_ptr<net::Archive>> archive() const;  // opens no connection
};

Result<ArchiveWay> wayTo(const net::SourceList& sources, const QString& name);

// To be asked. Opens no connection.
study::NamedArchive namedArchive(const net::SourceList& sources, const QString& name);

}  // namespace macula::viewer
