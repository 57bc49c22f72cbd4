"""A self-signed certificate for a class, which encrypts its traffic."""

import datetime
import ipaddress
import socket
from dataclasses import dataclass
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING

from learnblock.errors import LearnBlockError
from learnblock.installation import add_on
from learnblock.server.http.address import own_address
from learnblock.storage.files import save

if TYPE_CHECKING:
    from cryptography import x509

_DAYS = 365


@dataclass(frozen=True, slots=True)
class CertificateFiles:
    """The files of a certificate.

    Args:
        file: the certificate, in PEM.
        key: its private key, in PEM.
    """

    file: Path
    key: Path


# Why: docs/decisions.md, "HTTPS is a choice"
def own_certificate(folder: Path) -> CertificateFiles:
    """The class's own certificate, which is made for a year if there is none.

    Browsers warn of it once on each device, since no authority has signed it.

    Args:
        folder: of the class.

    Raises:
        LearnBlockError: the library that makes it is not installed.
        OSError: it can't be saved.
    """
    certificate = CertificateFiles(folder / "certificate.pem", folder / "certificate-key.pem")
    if not (certificate.file.is_file() and certificate.key.is_file()):
        if find_spec("cryptography") is None:
            raise LearnBlockError("class-no-cryptography", command=add_on("tls"))
        _make(certificate)
    return certificate


def _make(certificate: CertificateFiles) -> None:
    from cryptography import x509  # noqa: PLC0415 - an optional part of the install
    from cryptography.hazmat.primitives import hashes, serialization  # noqa: PLC0415
    from cryptography.hazmat.primitives.asymmetric import ec  # noqa: PLC0415

    key = ec.generate_private_key(ec.SECP256R1())
    name = x509.Name([x509.NameAttribute(x509.NameOID.COMMON_NAME, socket.gethostname())])
    now = datetime.datetime.now(datetime.UTC)
    signed = (
        x509.CertificateBuilder()
        .subject_name(name)
        .issuer_name(name)
        .public_key(key.public_key())
        .serial_number(x509.random_serial_number())
        .not_valid_before(now - datetime.timedelta(days=1))
        .not_valid_after(now + datetime.timedelta(days=_DAYS))
        .add_extension(x509.SubjectAlternativeName(_names()), critical=False)
        .sign(key, hashes.SHA256())
    )
    pem = serialization.Encoding.PEM
    private = key.private_bytes(
        pem, serialization.PrivateFormat.PKCS8, serialization.NoEncryption()
    )
    save(certificate.key, private, private=True)
    save(certificate.file, signed.public_bytes(pem))


def _names() -> "list[x509.GeneralName]":
    from cryptography import x509  # noqa: PLC0415 - as above

    addresses = dict.fromkeys(filter(None, ("127.0.0.1", own_address())))
    return [
        x509.DNSName(socket.gethostname()),
        x509.DNSName("localhost"),
        *(x509.IPAddress(ipaddress.ip_address(address)) for address in addresses),
    ]
