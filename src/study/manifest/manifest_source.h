// Which of the archives that are set up has what an imaging manifest names.
#pragma once

#include <string>

#include "base/result.h"
#include "dicom/manifest/imaging_manifest.h"
#include "net/sources/source_list.h"

namespace macula::study {

// Whether the address, which a manifest gives for something of the study, is below that of the service: same
// scheme, host and port, and behind the path of the service nothing but /studies/UID and so on of this study.
bool isOfService(const std::string& url, const net::WebPeer& service, const std::string& studyInstanceUid);

// The archive whose address or AE title the manifest gives for all series of the study. A manifest is
// somebody's claim: nobody connects to an address that only it names. Fails with usage where no archive that
// is set up has the address, which is then the `where` of the error.
Result<net::Source> sourceOf(const dicom::ManifestStudy& study, const net::SourceList& sources);

}  // namespace macula::study
