#include "viewer/archive/archive_way.h"

#include <memory>
#include <utility>

#include "net/connect.h"

namespace macula::viewer {

namespace {

Result<std::shared_ptr<net::Archive>> archiveAt(const net::SourceList& sources, const QString& name) {
    MACULA_TRY(const ArchiveWay way, wayTo(sources, name));
    MACULA_TRY(std::unique_ptr<net::Archive> archive, way.archive());
    return std::shared_ptr<net::Archive>(std::move(archive));
}

}  // namespace

Result<std::unique_ptr<net::Archive>> ArchiveWay::archive() const {
    return net::archiveOf(list, source);
}

Result<ArchiveWay> wayTo(const net::SourceList& sources, const QString& name) {
    MACULA_TRY(net::Source source, sources.find(name.toStdString()));
    return ArchiveWay{std::move(source), sources};
}

study::NamedArchive namedArchive(const net::SourceList& sources, const QString& name) {
    return {name.toStdString(), archiveAt(sources, name)};
}

}  // namespace macula::viewer
