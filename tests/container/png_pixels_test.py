"""The PNG reader of the container test against pixels that this file filters and packs itself."""
import struct
import unittest
import zlib

import png_pixels


def chunk(kind, body):
    return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))


def png_of(width, height, filtered_rows, colour=2, depth=8):
    header = struct.pack(">IIBBBBB", width, height, depth, colour, 0, 0, 0)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(b"".join(filtered_rows)))
            + chunk(b"IEND", b""))


class PngPixelsTest(unittest.TestCase):
    def test_each_filter_gives_the_same_pixels(self):
        first = bytes([0, 10, 20, 30, 40, 60, 80])  # filter none: (10, 20, 30), (40, 60, 80)
        second = [(11, 22, 33), (50, 70, 90)]
        # Worked by hand from section 9.2 of the specification.
        encodings = {0: [11, 22, 33, 50, 70, 90], 1: [11, 22, 33, 39, 48, 57], 2: [1, 2, 3, 10, 10, 10],
                     3: [6, 12, 18, 25, 29, 34], 4: [1, 2, 3, 10, 10, 10]}
        for kind, encoded in encodings.items():
            with self.subTest(filter=kind):
                image = png_of(2, 2, [first, bytes([kind, *encoded])])
                self.assertEqual(png_pixels.read_png(image), (2, 2, [[(10, 20, 30), (40, 60, 80)], second]))

    def test_alpha_is_left_out(self):
        self.assertEqual(png_pixels.read_png(png_of(1, 1, [bytes([0, 1, 2, 3, 255])], colour=6)), (1, 1, [[(1, 2, 3)]]))

    def test_refuses_what_it_cannot_read(self):
        with self.assertRaisesRegex(ValueError, "not a PNG"):
            png_pixels.read_png(b"\xff\xd8\xff\xe0 and so on")
        with self.assertRaisesRegex(ValueError, "16 bits"):
            png_pixels.read_png(png_of(1, 1, [bytes(7)], depth=16))


if __name__ == "__main__":
    unittest.main()
