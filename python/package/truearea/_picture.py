"""Fields as pictures: the colours that the core chose, within the frame that it drew."""

from __future__ import annotations

import base64
import struct
import zlib


def within_frame(svg: str, place: tuple[float, float, float, float], columns: int, colours: bytes) -> str:
    """An SVG document with points as an image in it: red, green and blue of each, row by row from the top."""
    left, top, width, height = place
    image = (
        f'<image x="{left}" y="{top}" width="{width}" height="{height}" preserveAspectRatio="none" '
        f'style="image-rendering:pixelated" href="data:image/png;base64,{base64.b64encode(_png(columns, colours)).decode()}"/>'
        "\n</svg>"
    )
    return svg.replace("</svg>", image)


def _png(columns: int, colours: bytes) -> bytes:
    row = 3 * columns
    # Each row begins with the filter that it is stored with: none.
    rows = b"".join(b"\0" + colours[at : at + row] for at in range(0, len(colours), row))
    header = struct.pack(">IIBBBBB", columns, len(colours) // row, 8, 2, 0, 0, 0)
    chunks = (_chunk(b"IHDR", header), _chunk(b"IDAT", zlib.compress(rows)), _chunk(b"IEND", b""))
    return b"\x89PNG\r\n\x1a\n" + b"".join(chunks)


def _chunk(kind: bytes, content: bytes) -> bytes:
    return struct.pack(">I", len(content)) + kind + content + struct.pack(">I", zlib.crc32(kind + content))
