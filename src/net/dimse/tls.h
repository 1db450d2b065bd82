// What a protected connection is made with.
#pragma once

#include <memory>
#include <string>

#include "base/result.h"
#include "net/archive/source.h"

struct ssl_ctx_st;

namespace macula::net {

// The profile BCP 195 without downgrading (PS3.15 B.10): TLS 1.2 or later. The peer must show a certificate
// that an authority has signed which is trusted, except where nobody asks for it.
class TlsSettings {
  public:
    // acceptsAnyone: the peer is not asked for a certificate.
    enum class Role { connects, accepts, acceptsAnyone };
    static Result<std::shared_ptr<const TlsSettings>> of(const Tls& tls, const std::string& keyPassphrase,
                                                         Role role);
    ~TlsSettings();

    ssl_ctx_st* native() const;
    Role role() const { return role_; }

  private:
    struct Layer;
    TlsSettings(std::unique_ptr<Layer> layer, Role role);

    std::unique_ptr<Layer> layer_;
    Role role_;
};

// Why a certificate of a peer is refused: `problem` is one of X509_V_ERR_.
Error errorOfCertificate(long problem);

}  // namespace macula::net
